atelier_step(09-dithering
  TITLE "Dithering"
  FILES dithering.cpp dithering.glsl choices.txt
  USES 01-transforms 02-blinn-phong 03-shadow-mapping 08-post-processing)
