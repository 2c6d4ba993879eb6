atelier_step(@STEP@
  TITLE "@TITLE@"
  FILES @NAME@.cpp @NAME@.glsl
  USES 01-transforms 02-blinn-phong)
