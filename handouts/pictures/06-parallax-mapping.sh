size=300x225
view=(--eye 0.3,1,1.5)
draw 06-flat $step --scene bricks "${view[@]}" --set parallax.method=none
draw 06-offset $step --scene bricks "${view[@]}" --set parallax.method=offset
draw 06-steep $step --scene bricks "${view[@]}" --set parallax.method=steep --set parallax.layers=8
draw 06-occlusion $step --scene bricks "${view[@]}" --set parallax.layers=8
sheet 06-methods 2 06-flat="normal map" 06-offset=offset 06-steep="steep, 8 layers" 06-occlusion="occlusion, 8 layers"
draw found $step --scene pillars --set parallax.layers=256 && draw missed $step --scene pillars --set parallax.layers=8 && pair 06-pillars found missed
draw without $step --scene bricks --set parallax.layers=128 && draw with $step --scene bricks --set parallax.layers=128 --set parallax.shadow_samples=128 && pair 06-shadows without with
draw level $step --scene crossing --set parallax.layers=128 && draw crossing $step --scene crossing --set parallax.layers=128 --set parallax.write_depth=true && pair 06-crossing level crossing
round=(--scene column --set parallax.depth=0.1 --set parallax.layers=128)
draw 06-flat $step "${round[@]}" && draw 06-carved $step "${round[@]}" --set parallax.silhouette=on && truth 06-truth $step "${round[@]}"
sheet 06-column 3 06-flat="off" 06-carved="parallax.silhouette=on" 06-truth=truth
mistakes $step 06-mistakes bricks--{span-towards-eye,height-for-depth,span-not-divided} bricks-shadowed--{shadow-from-surface,shadow-away-from-light} crossing--position-towards-eye
