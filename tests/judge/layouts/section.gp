# section.gp - where a ray meets spheres, in the plane through the ray, and the t axis below.
#
# Each sphere is turned round the ray into the paper: how far it is along the ray and from it stays.
title = asked.": yours beside the right one"
description = "A ray from left to right, the spheres near it, and its t axis. ".beside_words(0)
steps = 2
beside_room = width / 8
@beside
room = "0.06 0.94 0.30 0.70"
low_x = low; high_x = high; low_y = bottom; high_y = top
@flat
axis = 96
minus(x) = x < 0 ? sprintf("−%g", -x) : sprintf("%g", x)
$here << EOD
0
EOD
eye = has_eye ? "for [_=0:0]" : "for [_=1:0]"
arrow_of_v = has_arrow ? "for [_=0:0]" : "for [_=1:0]"
long_arrow = has_arrow && size[1] * unit > 80 ? "for [_=0:0]" : "for [_=1:0]"

plot $spheres using (U(1,$1)):(V(1,$2)):(size[1]*$3) with circles fc rgb surface fs solid border lc rgb ink lw 1.2 title "spheres", \
    $spheres using (U(1,$1)):(V(1,$2)):(sprintf("%d", $4)) with labels tc rgb grey title "sphere, number", \
    $here using (U(1,low)):(V(1,0)):(size[1]*(high-low)):(0) with vectors nohead lc rgb blue lw 1.2 title "ray", \
    @arrow_of_v $here using (U(1,0)):(V(1,0)):(size[1]*unit):(0) with @arrow lc rgb blue title "v", \
    @long_arrow $here using (U(1,unit/2)):(V(1,0)):(math("v")) with labels offset 0,1 tc rgb blue title "v, label", \
    @eye $here using (U(1,0)):(V(1,0)) with @dot lc rgb blue title "p", \
    @eye $here using (U(1,0)):(V(1,0)):(math("p")) with labels offset 0,-0.9 tc rgb blue title "p, label", \
    $here using (U(1,low)):(axis):(size[1]*(high-low)):(0) with vectors head filled size 9,18,90 lw 1 lc rgb grey title "axis", \
    $here using (U(1,high)):(axis):(math("t")) with labels left offset 0.8,0 tc rgb grey title "t", \
    $ticks using (U(1,$2)):(axis-4):(0):(8) with vectors nohead lw 1 lc rgb grey title "ticks", \
    $ticks using (U(1,$2)):(axis):(minus($1)) with labels font small_font offset 0,-0.9 tc rgb grey title "tick, label", \
    $answer using (U(1,$2)):(axis):(0):(V(1,0)-axis) with vectors nohead lw 1.2 lc rgb blue title "right, line", \
    $answer using (U(1,$2)):(V(1,0)) with @dot lc rgb blue title "right", \
    $answer using (U(1,$2)):(axis) with @dot lc rgb blue title "right, on the axis", \
    $answer using (U(1,$2)):(axis):("right") with labels font small_font offset 0,-2.1 tc rgb blue title "right, label", \
    @step2 $yours using (U(1,$2)):(axis):(0):(V(1,0)-axis) with vectors nohead lw 1.2 dt 2 lc rgb orange title "yours, line", \
    @step2 $yours using (U(1,$2)):(V(1,0)) with @ring lc rgb orange title "yours", \
    @step2 $yours using (U(1,$2)):(axis) with @ring lc rgb orange title "yours, on the axis", \
    @step2 $yours using (U(1,$2)):(axis):("yours") with labels font small_font offset 0,-3.2 tc rgb orange title "yours, label"
