atelier_step(03-shadow-mapping
  TITLE "Shadow mapping"
  FILES shadow_mapping.cpp shadow_mapping.glsl depth_pass.glsl choices.txt
  USES 01-transforms 02-blinn-phong)
