# discriminant.gp - the sign of b² − 4ac and the signs of the roots, for five rays and one sphere.
array names[5] = ["miss", "tangent", "two hits", "inside", "behind"]
of(i, what) = value(sprintf("panel%d_%s", i, what))
roots(i) = of(i, "roots") == 0 ? "no root" : of(i, "t0") == of(i, "t1") ? sprintf("double root %s", of(i, "t0_text")) : \
    sprintf("%s, %s", of(i, "t0_text"), of(i, "t1_text"))
yours_of(i, what) = differs(sprintf("panel%d_%s", i, what)) ? value(sprintf("your_panel%d_%s", i, what)) : of(i, what)
your_roots(i) = !(differs(sprintf("panel%d_t0", i)) || differs(sprintf("panel%d_t1", i))) ? "" : \
    yours_of(i, "roots") == 0 ? "yours: none" : "yours ".yours_of(i, "t0_text").", ".yours_of(i, "t1_text")
used(i, t) = of(i, "hit") > 0 ? "use ".t." = ".of(i, "hit_text") : "no hit"
in_words(i) = sprintf("%s: b² − 4ac = %s, roots: %s; %s. ", names[i], of(i, "D_text"), roots(i), \
    used(i, "t"))
title = "The discriminant, and the signs of the roots"
description = "Five rays against one sphere, each below its parabola f(t). ".in_words(1).in_words(2).in_words(3). \
    in_words(4).in_words(5)."The hit is the smallest root greater than 0."
steps = 5
if (wrong) { set label 99 "solid: right\ndashed, squares: yours" }

# Each panel: the section, and above it f over the same places.
low_y = -1.1 * r
high_y = 1.6 * r
do for [i=1:5] {
    panel = i
    room = sprintf("%g %g 0.17 0.44", (i - 1) / 5.0 + 0.01, i / 5.0 - 0.01)
    low_x = of(i, "middle") - 1.75 * r
    high_x = of(i, "middle") + 1.75 * r
    @flat
}
axis = height * 0.58
F(f) = axis + 0.11 * height * f / r**2
middle(i) = width * (i - 0.5) / 5
left_of(i) = width * (i - 1) / 5.0
foot = wrong ? 58 : 34
last = least(5, step)
only(i, panel, x) = panel == i ? x : NaN
one = "$circle every ::0::0"

plot for [i=1:4] @one using (left_of(i + 1)):(24):(0):(height - 48) with vectors nohead lw 0.8 lc rgb faint title "between", \
    for [i=1:last] $circle using (U(i,$1)):(V(i,$2)) with filledcurves closed fc rgb surface fs solid noborder title "disc", \
    for [i=1:last] $circle using (U(i,$1)):(V(i,$2)) with @lines lc rgb ink title "circle", \
    for [i=1:last] @one using (middle(i)):(height - 26):(names[i]) with labels tc rgb ink title "name", \
    for [i=1:last] @one using (middle(i)):(height - 54):(small(math("b^2−4 a c = ").of(i, "D_text"))) with labels tc rgb ink title "discriminant", \
    for [i=1:last] @one using (left_of(i) + 8):(axis):(width / 5.0 - 16):(0) with @thin_arrow lc rgb grey title "axis", \
    for [i=1:last] @one using (U(i, of(i, "x"))):(axis - 5):(0):(10) with vectors nohead lw 2 lc rgb blue title "t = 0", \
    for [i=1:last] @one using (U(i, of(i, "x"))):(axis - 16):(small("0")) with labels tc rgb blue title "t = 0, label", \
    for [i=1:last] $rays using (only(i,$1,U($1,$2))):(V($1,$3)):(size[1]*(of($1,"middle")+1.75*r-$2)):(0) with vectors nohead lw 1.2 lc rgb blue title "ray", \
    for [i=1:last] $rays using (only(i,$1,U($1,$6-1.75*r))):(V($1,$3)):(size[1]*($2-$6+1.75*r)):(0) with vectors nohead lw 1.2 dt 3 lc rgb grey title "behind p", \
    @who for [i=1:last] $behind index who using (only(i,$1,U($1,$2))):(F($3)) with @lines lc rgb grey dt dash(who) title "f, t < 0", \
    @who for [i=1:last] $ahead index who using (only(i,$1,U($1,$2))):(F($3)) with @thick lc rgb green dt dash(who) title "f", \
    for [i=1:last] $back index 0 using (only(i,$1,U($1,$2))):(axis):(0):(V($1,$3)-axis) with vectors nohead lw 0.8 dt 2 lc rgb grey title "behind, vertical", \
    for [i=1:last] $later index 0 using (only(i,$1,U($1,$2))):(axis):(0):(V($1,$3)-axis) with vectors nohead lw 0.8 dt 2 lc rgb pink title "later, vertical", \
    for [i=1:last] $used index 0 using (only(i,$1,U($1,$2))):(axis):(0):(V($1,$3)-axis) with vectors nohead lw 0.8 dt 2 lc rgb orange title "used, vertical", \
    for [i=1:last] $rays using (only(i,$1,U($1,$2))):(V($1,$3)):(size[1]*$4):(size[1]*$5) with @arrow lc rgb blue title "v", \
    for [i=1:last] $rays using (only(i,$1,U($1,$2))):(V($1,$3)) with @dot lc rgb blue title "p", \
    for [i=1:last] @one using (U(i, of(i, "x"))):(V(i, of(i, "y")) - 15):(small(math("p"))) with labels tc rgb blue title "p, label", \
    for [i=1:last] @one using (U(i, of(i, "x") + 0.5 * v)):(V(i, of(i, "y")) + 15):(small(math("v"))) with labels tc rgb blue title "v, label", \
    for [i=1:last] $back index 0 using (only(i,$1,U($1,$2))):(axis) with @cross lc rgb grey title "root behind", \
    for [i=1:last] $back index 0 using (only(i,$1,U($1,$2))):(V($1,$3)) with @cross lc rgb grey title "place behind", \
    for [i=1:last] $later index 0 using (only(i,$1,U($1,$2))):(axis) with @ring lc rgb pink title "later root", \
    for [i=1:last] $later index 0 using (only(i,$1,U($1,$2))):(V($1,$3)) with @ring lc rgb pink title "later place", \
    for [i=1:last] $used index 0 using (only(i,$1,U($1,$2))):(axis) with @dot lc rgb orange title "root used", \
    for [i=1:last] $used index 0 using (only(i,$1,U($1,$2))):(V($1,$3)) with @dot lc rgb orange title "hit", \
    for [_=1:wrong] for [i=1:last] $used index wrong using (only(i,$1,U($1,$2))):(axis) with @square lc rgb ink title "your root used", \
    for [_=1:wrong] for [i=1:last] $later index wrong using (only(i,$1,U($1,$2))):(axis) with @square lc rgb ink title "your later root", \
    for [_=1:wrong] for [i=1:last] $back index wrong using (only(i,$1,U($1,$2))):(axis) with @square lc rgb ink title "your root behind", \
    for [i=1:last] @one using (middle(i)):(foot + 26):(used(i, math("t"))) with labels tc rgb (of(i, "hit") > 0 ? orange : grey) title "used", \
    for [i=1:last] @one using (middle(i)):(foot):(small(roots(i))) with labels tc rgb grey title "roots", \
    for [i=1:last] @one using (middle(i)):(foot - 21):(small(your_roots(i))) with labels tc rgb ink title "your roots"
