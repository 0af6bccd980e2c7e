# section.gp - where a ray meets spheres, in the plane through the ray, and the t axis below.
#
# Each sphere is turned around the ray into the paper: how far it is along the ray and from it stays.
title = asked.": yours beside the right one"
description = "A ray from left to right, the spheres near it, and its t axis. ".beside_words(0)
steps = 2
on_the_ray = "(U(1,$1)):(V(1,0))"
up_to_it = flat1.":(0):(V(1,0)-V(1,$2))"

plot $spheres using @flat1:(size[1]*$3) with circles fc rgb surface fs solid border lc rgb ink lw 1.2 title "spheres", \
    $ray using @along1 with vectors nohead lw 2 lc rgb blue title "ray", \
    $v using @along1 with @arrow lc rgb blue title "v", \
    $p using @flat1 with @dot lc rgb blue title "p", \
    $axis using @along1 with @axis lc rgb grey title "axis", \
    $ticks using (U(1,$1)):(V(1,$2)-4):(0):(8) with vectors nohead lw 0.8 lc rgb grey title "ticks", \
    $answer using @up_to_it with @segment lc rgb blue title "right, line", \
    $answer using @on_the_ray with @dot lc rgb blue title "right", \
    $answer using @flat1 with @dot lc rgb blue title "right, on the axis", \
    @step2 $yours using @up_to_it with @segment dt 2 lc rgb ink title "yours, line", \
    @step2 $yours using @on_the_ray with @ring lc rgb ink title "yours", \
    @step2 $yours using @flat1 with @ring lc rgb ink title "yours, on the axis", \
    @labels
