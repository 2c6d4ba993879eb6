draw 02-sphere $step --scene sphere && single 02-sphere
draw 02-teapot $step --scene teapot && single 02-teapot
draw 02-edges $step --scene edges && single 02-edges
draw diffuse $step --scene sphere --output diffuse && draw specular $step --scene sphere --output specular
pair 02-parts diffuse specular
draw spots $step --scene spots && draw lights $step --scene lights && pair 02-lights spots lights
size=256x192 # fine detail all over: larger ones would weigh over 100 kB
plain linear $step --scene tiles --set texture.filter=linear && plain mipmap $step --scene tiles
pair 02-tiles linear mipmap
size=320x240
draw plain $step --scene materials && draw normalised $step --scene materials --set specular.normalisation=n+8
pair 02-materials plain normalised
draw pixel $step --scene facets && draw vertex $step --scene facets --set shading=vertex && pair 02-facets pixel vertex
draw blind-lamp $step --scene blinds --set light.blind=on light.count=1
draw blinds $step --scene blinds --set light.blind=on && pair 02-blinds blind-lamp blinds
mistakes $step 02-mistakes sphere--{eye-at-origin,missing-n-dot-l,no-attenuation,rv-for-nh} \
  facets--normal-not-normalised backlight--specular-from-behind spots--{cone-inverted,cone-axis-sign,cone-hard} \
  lights--lights-overwrite tiles--{no-mipmaps,texture-upside-down} encoded--{gamma-missing,gamma-twice} \
  copper--specular-grey sphere--to-light-reversed \
  blinds--{visibility-ignored,ambient-shadowed,first-lights-shadow,shadows-multiplied}
