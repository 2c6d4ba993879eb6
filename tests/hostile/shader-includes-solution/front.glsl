#include "solutions/01-transforms/transforms.glsl"
#include "02-blinn-phong/blinn_phong.glsl"
