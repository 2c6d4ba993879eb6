atelier_step(12-gallery
  TITLE "Gallery"
  FILES gallery.cpp choices.txt
  USES 01-transforms 02-blinn-phong 03-shadow-mapping 04-point-shadows 05-normal-mapping 06-parallax-mapping
       07-stencil-portals 08-post-processing 09-dithering 10-artstyles)
