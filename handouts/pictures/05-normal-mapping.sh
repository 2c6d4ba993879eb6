size=448x168
draw 05-inscription $step --scene inscription --eye 0,0,3.1 && single 05-inscription
size=448x252
draw 05-degenerate $step --scene degenerate --eye 0,-0.1,4.6 && single 05-degenerate
size=300x240
from=(--eye 2.6,1.6,1.9)
draw world $step --scene ball "${from[@]}" --output normal && draw recorded $step --scene ball "${from[@]}" --output recorded_normal && pair 05-frames world recorded
coarse=(--eye 0.9,1.7,1.5 --set ball.segments=8 --output normal)
draw vertex $step --scene ball "${coarse[@]}" && draw derivative $step --scene ball "${coarse[@]}" --set normal.tangents=derivative && pair 05-tangents vertex derivative
mistakes $step 05-mistakes wall--{bitangent-reversed,not-decoded,frame-transposed} wall-heights--{heights-inverted,rows-down}
