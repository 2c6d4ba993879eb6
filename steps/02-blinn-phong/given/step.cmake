atelier_step(02-blinn-phong
  TITLE "Light and materials after Blinn and Phong"
  FILES blinn_phong.cpp blinn_phong.glsl choices.txt
  USES 01-transforms)
