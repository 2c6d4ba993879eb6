atelier_step(07-stencil-portals
  TITLE "Stencil portals"
  FILES stencil_portals.cpp stencil_portals.glsl choices.txt
  USES 01-transforms 02-blinn-phong 03-shadow-mapping 04-point-shadows 05-normal-mapping)
