atelier_step(10-artstyles
  TITLE "Art styles"
  FILES artstyles.cpp artstyles.glsl choices.txt
  USES 01-transforms 02-blinn-phong 03-shadow-mapping 08-post-processing)
