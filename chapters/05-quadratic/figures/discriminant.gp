# discriminant.gp - the sign of b² − 4ac and the signs of the roots, for five rays and one sphere.
array names[5] = [own("miss"), own("tangent"), own("two hits"), own("inside"), own("behind")]
of(i, what) = value(sprintf("panel%d_%s", i, what))
roots(i) = of(i, "roots") == 0 ? own("no root") : of(i, "t0") == of(i, "t1") ? sprintf(own("double root %s"), of(i, "t0_text")) : \
    sprintf("%s, %s", of(i, "t0_text"), of(i, "t1_text"))
used(i) = of(i, "hit") > 0 ? own("use t =")." ".of(i, "hit_text") : own("no hit")
in_words(i) = sprintf(own("%s: b² − 4ac = %s, roots: %s; %s.")." ", names[i], of(i, "D_text"), roots(i), used(i))
title = own("The discriminant, and the signs of the roots")
description = own("Five rays against one sphere, each below its parabola f(t).")." ".in_words(1).in_words(2).in_words(3). \
    in_words(4).in_words(5).own("The hit is the smallest root greater than 0.")
steps = 5
if (wrong) { set label 99 squares_are_yours }

# A table: a column for each ray, with its section, and above it f over the same places. Its words begin where a
# slide's do.
margin = 36
narrow = shape eq "4:3"
column = (narrow ? 0.165 : 0.17) * width
left_of(i) = (narrow ? 0.17 : 0.14) * width + column * (i - 1)
middle(i) = left_of(i) + column / 2
axis = 290
f_unit = 45
F(f) = axis + f_unit * f / r**2
last = least(5, step)
only(i, panel, x) = panel == i ? x : NaN
one = "$circle every ::0::0"
# If there is no room for the number, its sign, which decides.
sign_of(D) = D < 0 ? "< 0" : D > 0 ? "> 0" : "0"
D_shown(i) = strlen(of(i, "D_text")) > (narrow ? 6 : 9) ? sign_of(of(i, "D")) : of(i, "D_text")
root(i, k) = of(i, "roots") == 0 ? (k == 0 ? own("no root") : "") : of(i, sprintf("t%d_text", k))
root_color(i, k) = of(i, "roots") == 0 ? grey : of(i, sprintf("t%d", k)) == of(i, "hit") ? blue : of(i, sprintf("t%d", k)) > 0 ? ink : grey
hit_shown(i) = of(i, "hit") > 0 ? of(i, "hit_text") : own("none")

plot for [i=1:4] @one using (left_of(i + 1)):(104):(0):(356) with vectors nohead lw 0.8 lc rgb faint title "between", \
    @one using (margin):(418):(math("b²−4ac")) with labels left tc rgb ink title "row of the discriminant", \
    @one using (margin):(axis + 50):(math("f (t)")) with labels left tc rgb ink title "row of f", \
    @one using (margin):(84):(math("t_0")) with labels left tc rgb ink title "row of t0", \
    @one using (margin):(54):(math("t_1")) with labels left tc rgb ink title "row of t1", \
    @one using (margin):(20):(own("hit")) with labels left tc rgb blue title "row of the hit", \
    for [i=1:last] $circle using (U(i,$1)):(V(i,$2)) with filledcurves closed fc rgb surface fs solid noborder title "disc", \
    for [i=1:last] $circle using (U(i,$1)):(V(i,$2)) with @lines lc rgb ink title "circle", \
    for [i=1:last] @one using (middle(i)):(448):(names[i]) with labels tc rgb ink title "name", \
    for [i=1:last] @one using (middle(i)):(418):(D_shown(i)) with labels tc rgb ink title "discriminant", \
    for [i=1:last] @one using (left_of(i) + 8):(axis):(column - 16):(0) with @thin_arrow lc rgb grey title "axis", \
    for [i=1:last] @one using (U(i, of(i, "x"))):(axis - 5):(0):(10) with vectors nohead lw 2 lc rgb blue title "t = 0", \
    for [i=1:last] @one using (U(i, of(i, "x"))):(axis + (i == 4 ? 20 : -20)):("0") with labels tc rgb blue title "t = 0, label", \
    for [i=1:last] $rays using (only(i,$1,U(i,$2))):(V(i,$3)):(size[1]*(of($1,"middle")+1.75*r-$2)):(0) with vectors nohead lw 2 lc rgb blue title "ray", \
    for [i=1:last] $rays using (only(i,$1,U(i,$6-1.75*r))):(V(i,$3)):(size[1]*($2-$6+1.75*r)):(0) with vectors nohead lw 1.2 dt 3 lc rgb grey title "behind p", \
    @who for [i=1:last] $behind index who using (only(i,$1,U(i,$2))):(F($3)) with @lines lc rgb grey dt dash(who) title "f, t < 0", \
    @who for [i=1:last] $ahead index who using (only(i,$1,U(i,$2))):(F($3)) with @thick lc rgb ink dt dash(who) title "f", \
    for [i=1:last] $back index 0 using (only(i,$1,U(i,$2))):(axis):(0):(V(i,$3)-axis) with vectors nohead lw 0.8 dt 3 lc rgb grey title "behind, vertical", \
    for [i=1:last] $later index 0 using (only(i,$1,U(i,$2))):(axis):(0):(V(i,$3)-axis) with vectors nohead lw 0.8 dt 2 lc rgb ink title "later, vertical", \
    for [i=1:last] $used index 0 using (only(i,$1,U(i,$2))):(axis):(0):(V(i,$3)-axis) with vectors nohead lw 0.8 dt 2 lc rgb blue title "used, vertical", \
    for [i=1:last] $rays using (only(i,$1,U(i,$2))):(V(i,$3)):(size[1]*$4):(size[1]*$5) with @arrow lc rgb blue title "v", \
    for [i=1:last] $rays using (only(i,$1,U(i,$2))):(V(i,$3)) with @dot lc rgb blue title "p", \
    @one using (U(1, of(1, "x")) - 8):(V(1, of(1, "y")) - 20):(math("p")) with labels tc rgb blue title "p, label", \
    @one using (U(1, of(1, "x") + 0.5 * v) + 4):(V(1, of(1, "y")) - 20):(math("v")) with labels tc rgb blue title "v, label", \
    for [i=1:last] $back index 0 using (only(i,$1,U(i,$2))):(axis) with @cross lc rgb grey title "root behind", \
    for [i=1:last] $back index 0 using (only(i,$1,U(i,$2))):(V(i,$3)) with @cross lc rgb grey title "place behind", \
    for [i=1:last] $later index 0 using (only(i,$1,U(i,$2))):(axis) with @ring lc rgb ink title "later root", \
    for [i=1:last] $later index 0 using (only(i,$1,U(i,$2))):(V(i,$3)) with @ring lc rgb ink title "later place", \
    for [i=1:last] $used index 0 using (only(i,$1,U(i,$2))):(axis) with @dot lc rgb blue title "root used", \
    for [i=1:last] $used index 0 using (only(i,$1,U(i,$2))):(V(i,$3)) with @dot lc rgb blue title "hit", \
    for [_=1:wrong] for [i=1:last] $used index wrong using (only(i,$1,U(i,$2))):(axis) with @square lc rgb blue title "your root used", \
    for [_=1:wrong] for [i=1:last] $later index wrong using (only(i,$1,U(i,$2))):(axis) with @square lc rgb ink title "your later root", \
    for [_=1:wrong] for [i=1:last] $back index wrong using (only(i,$1,U(i,$2))):(axis) with @square lc rgb grey title "your root behind", \
    for [k=0:1] for [i=1:last] @one using (middle(i)):(80 - 30 * k):(root(i, k)) with labels tc rgb root_color(i, k) title "root", \
    for [i=1:last] @one using (middle(i)):(20):(hit_shown(i)) with labels tc rgb (of(i, "hit") > 0 ? blue : grey) title "used"
