atelier_step(01-transforms
  TITLE "Transforms and vertex buffers"
  FILES transforms.cpp transforms.glsl choices.txt)
