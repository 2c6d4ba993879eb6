atelier_step(05-normal-mapping
  TITLE "Normal mapping"
  FILES normal_mapping.cpp normal_mapping.glsl
  USES 01-transforms 02-blinn-phong)
