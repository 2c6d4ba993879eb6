atelier_step(06-parallax-mapping
  TITLE "Parallax mapping"
  FILES parallax_mapping.glsl choices.txt
  USES 01-transforms 02-blinn-phong 05-normal-mapping)
