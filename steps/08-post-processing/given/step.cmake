atelier_step(08-post-processing
  TITLE "Post-processing"
  FILES post_processing.cpp post_processing.glsl choices.txt
  USES 01-transforms 02-blinn-phong)
