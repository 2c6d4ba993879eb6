atelier_step(04-point-shadows
  TITLE "Point light shadows"
  FILES point_shadows.cpp point_shadows.glsl cube_pass.glsl
  USES 01-transforms 02-blinn-phong 03-shadow-mapping)
