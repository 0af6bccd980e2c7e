# discriminant.gp - one ray moves across the sphere: the five cases of b² − 4ac and of the roots' signs.
#
# As in the figure discriminant, also in its colors: below the section, above it f over the same places.
steps = moments
rate = 16
array names[5] = [own("miss"), own("tangent"), own("two hits"), own("inside"), own("behind")]
stops = ""
do for [k=1:5] { stops = stops." ".word($stays[k + 1], 1) }
title = own("The discriminant, as one ray moves")
description = own("One ray moves across a sphere, below its parabola f(t): it misses, it touches, it has two hits, it starts inside, \
and the sphere is behind it. The sign of b² − 4ac says how many roots there are, and their signs say which of them is the hit.")
now = int(most(1, least(step, steps)))
of(what) = value(sprintf("panel%d_%s", now, what))
D = of("D")
roots = of("roots")
case = roots == 0 ? 1 : of("t0") == of("t1") ? 2 : of("t0") > 0 ? 3 : of("t1") > 0 ? 4 : 5
sign = D < 0 ? " < 0" : D == 0 ? " = 0" : " > 0"
low_x = -2.4 * r
high_x = 2.4 * r
low_y = -1.15 * r
high_y = 1.7 * r
room = "0.02 0.62 0.04 0.60"
@flat
axis_y = height * 0.76
F(f) = axis_y + 0.10 * height * f / r**2
moment = "every :::(now-1)::(now-1)"
is_now(panel, x) = panel == now ? x : NaN
left = U(1, low_x)
right = U(1, high_x)
p_x = U(1, of("x"))
p_y = V(1, of("y"))
words_x = width * 0.66
# Large, so that its small digits are as large as other words.
t_words(name, t) = large(math(name)." = ".shown(t))

plot $circle using (U(1,$1)):(V(1,$2)) with filledcurves closed fc rgb surface fs solid noborder title "disc", \
    $circle using (U(1,$1)):(V(1,$2)) with @lines lc rgb ink title "circle", \
    $once using (left):(axis_y):(right - left):(0) with @thin_arrow lc rgb grey title "axis", \
    $once using (p_x):(axis_y - 6):(0):(12) with vectors nohead lw 2 lc rgb blue title "t = 0", \
    $once using (p_x):(p_y):(right - p_x):(0) with vectors nohead lw 2 lc rgb blue title "ray", \
    $once using (left):(p_y):(p_x - left):(0) with vectors nohead lw 1.2 dt 3 lc rgb grey title "behind p", \
    $behind @moment using (U(1,$2)):(F($3)) with @lines lc rgb grey title "f, t < 0", \
    $ahead @moment using (U(1,$2)):(F($3)) with @thick lc rgb ink title "f", \
    $back using (is_now($1,U(1,$2))):(axis_y):(0):(V(1,$3)-axis_y) with vectors nohead lw 0.8 dt 3 lc rgb grey title "behind, vertical", \
    $later using (is_now($1,U(1,$2))):(axis_y):(0):(V(1,$3)-axis_y) with vectors nohead lw 0.8 dt 2 lc rgb ink title "later, vertical", \
    $used using (is_now($1,U(1,$2))):(axis_y):(0):(V(1,$3)-axis_y) with vectors nohead lw 0.8 dt 2 lc rgb blue title "used, vertical", \
    $once using (p_x):(p_y):(size[1]*v):(0) with @arrow lc rgb blue title "v", \
    $once using (p_x):(p_y) with @dot lc rgb blue title "p", \
    $once using (p_x):(p_y - 24):(math("p")) with labels tc rgb blue title "p, label", \
    $once using (p_x + size[1] * v / 2):(p_y + 22):(math("v")) with labels tc rgb blue title "v, label", \
    $back using (is_now($1,U(1,$2))):(axis_y) with @cross lc rgb grey title "root behind", \
    $back using (is_now($1,U(1,$2))):(V(1,$3)) with @cross lc rgb grey title "place behind", \
    $later using (is_now($1,U(1,$2))):(axis_y) with @ring lc rgb ink title "later root", \
    $later using (is_now($1,U(1,$2))):(V(1,$3)) with @ring lc rgb ink title "later place", \
    $used using (is_now($1,U(1,$2))):(axis_y) with @dot lc rgb blue title "root used", \
    $used using (is_now($1,U(1,$2))):(V(1,$3)) with @dot lc rgb blue title "hit", \
    $once using (right + 22):(axis_y):(math("t")) with labels tc rgb grey title "axis, label", \
    $once using (words_x):(height * 0.86):(large(names[case])) with labels left tc rgb ink title "case", \
    $once using (words_x):(height * 0.74):(large(math("b^2 − 4 a c").sign)) with labels left tc rgb ink title "sign", \
    $once using (words_x):(height * 0.64):(large("= ".shown(D))) with labels left tc rgb ink title "discriminant", \
    $once using (words_x):(height * 0.50):(roots == 0 ? own("no root") : case == 2 ? own("one root") : own("two roots")) \
        with labels left tc rgb ink title "number of roots", \
    $once using (words_x):(height * 0.40):(roots == 0 ? "" : t_words(case == 2 ? "t_0 = t_1" : "t_0", of("t0"))) \
        with labels left tc rgb (case > 3 ? grey : blue) title "first root", \
    $once using (words_x):(height * 0.30):(roots == 0 || case == 2 ? "" : t_words("t_1", of("t1"))) \
        with labels left tc rgb (case == 3 ? ink : case == 4 ? blue : grey) title "second root", \
    $once using (words_x):(height * 0.16):(case == 1 || case == 5 ? own("no hit") : own("hit").": ".math("t")." = ".shown(of("hit"))) \
        with labels left tc rgb (case == 1 || case == 5 ? grey : blue) title "verdict"
