# parabola.gp - f(t) = |p + t v|² − r² above the ray and the sphere, with one axis for t (slide 'Solving
# quadratic'): where f is 0, the line meets the circle.
touches = roots == 2 && t0 == t1
term(text, x) = (text[1:1] eq "−" ? " − ".text[2:*] : " + ".text).x
polynomial(square) = (a == 1 ? "" : a_text." ").square.(b == 0 ? "" : term(b_text, " t")).(c == 0 ? "" : term(c_text, ""))
your_coefficients = (differs("a") ? "a".yours("a")."  " : "").(differs("b") ? "b".yours("b")."  " : "").(differs("c") ? "c".yours("c") : "")
title = "The quadratic as a parabola"
description = sprintf("Above, f(t) = |p + t v|² − r² = %s above an axis for t; f(0) is %s. Below, on the same axis, \
the ray and the circle. ", polynomial("t²"), c_text).( \
    roots == 0 ? sprintf("The parabola stays above the axis, and the line misses the circle. At the lowest point, t = %s, f is %s.", \
        t_nearest_text, f_nearest_text) : \
    touches ? sprintf("The parabola touches the axis, and the line touches the circle, at t = %s.", t0_text) : \
    sprintf("The parabola crosses the axis, and the line crosses the circle, at t0 = %s and t1 = %s.", t0_text, t1_text))
text_w = most(330, 60 + 9.4 * strlen(polynomial("t²")))
steps = 4
if (wrong) { set label 99 "solid: right\ndashed, squares: yours" }

# The section below; f in what is left above it, as high as the words leave free.
azimuth = 90
elevation = 0
room = "0.10 0.92 0.05 0.44"
@see
@beside_line
half_f = scale * speed * sqrt((f_high - f_nearest) / a)
at_left = !wrong && t_u(t_nearest) - half_f > text_w + 40
at_right = !wrong && !at_left && t_u(t_nearest) + half_f < width - text_w - 40
text_x = at_right ? width - text_w - 10 : 24
f_bottom = height * 0.60
f_top = height * (at_left || at_right ? 0.96 : wrong ? 0.75 : 0.80)
f_scale = (f_top - f_bottom) / (f_high - f_low)
if (f_bottom - f_low * f_scale > height * 0.75 && f_low < 0) { f_scale = (height * 0.75 - f_bottom) / -f_low }
axis = f_bottom - f_low * f_scale
f_v(f) = axis + f_scale * f
above = near_p && c <= f_high
says_c = above ? "" : near_p ? " is off the top" : ", t = 0 is far away"
color(t) = abs(t - hit) <= 1e-6 * abs(hit) ? orange : t > 0 ? pink : grey
look0 = color(t0) eq orange ? dot : ring
look1 = touches || color(t1) eq orange ? dot : ring
at_root(t) = roots == 2 && (abs(t - t0) < 14 / scale / speed || abs(t - t1) < 14 / scale / speed)
mark(t) = at_root(t) || (roots == 0 && abs(t - t_nearest) < 14 / scale / speed) ? "" : number(t)
mark_v(t) = axis + (roots == 2 && t > t0 && t < t1 ? 15 : -15)
aside = t_u(t_nearest) > width / 2 ? "right" : "left"
small_ball = scale * r < 45

plot $circle using @point with filledcurves closed fc rgb surface fs solid noborder title "disc", \
    $circle using @point with @lines lc rgb ink title "circle", \
    $behind index wrong using @point with @lines lc rgb grey dt 3 title "behind p", \
    $ahead index wrong using @point with @lines lc rgb blue title "p + t v", \
    $v index wrong using @vector with @arrow lc rgb blue title "v", \
    $v index wrong using (X($1+$4/2,$2+$5/2,$3+$6/2)):(Y($1,$2,$3)+15):(math(stride == 1 ? "v" : stride_text." v")) \
        with labels tc rgb blue title "v, label", \
    for [_=1:near_p] $p index wrong using @point with @dot lc rgb blue title "p", \
    $p index wrong using (X($1,$2,$3)):(Y($1,$2,$3)-17):(math(near_p ? "p" : "to p")) with labels tc rgb blue title "p, label", \
    $center using @point with @dot lc rgb ink title "c", \
    $center using (X($1,$2,$3)-(small_ball?scale*r:0)-14):(Y($1,$2,$3)):(math("c")) with labels tc rgb ink title "c, label", \
    for [_=1:!small_ball] $radius using @vector with @thin_arrow lc rgb ink title "r", \
    $radius using (X($1+$4/2,$2+$5/2,$3+$6/2)+12):(Y($1+$4/2,$2+$5/2,$3+$6/2)+8):(small_ball ? "" : math("r")) \
        with labels tc rgb ink title "r, label", \
    @step2 $center using (0.03*width):(axis):(0.94*width):(0) with @thin_arrow lc rgb grey title "axis", \
    @step2 $center using (0.97*width):(axis+15):(math("t")) with labels tc rgb grey title "axis, label", \
    @step2 $ticks index wrong using (X($1,$2,$3)):(axis-4):(0):(8) with vectors nohead lw 1 lc rgb grey title "marks of t", \
    @step2 $ticks index wrong using (X($1,$2,$3)):(mark_v($4)):(small(mark($4))) with labels tc rgb grey title "t", \
    @step2 @who $parabola index who using (t_u($1)):(f_v($2)) with @thick lc rgb green dt dash(who) title "f", \
    @step2 $center using (text_x):(height-36):(math("f (t) = |p + t v|^2 − r^2")) with labels left tc rgb green title "f, label", \
    @step2 $center using (text_x + (tex ? 0 : 28)):(height-64):(math(" = ".polynomial("t^2"))) with labels left tc rgb green title "polynomial", \
    @step2 $center using (text_x):(height-118):(small(your_coefficients)) with labels left tc rgb ink title "your a, b, c", \
    for [_=1:step >= 2 && above] $center using (t_u(0)):(f_v(c)) with @ring lc rgb grey title "f(0)", \
    @step2 $center using (text_x):(height-92):(small(math("f (0) = c = ").c_text.says_c)) with labels left tc rgb grey title "f(0), label", \
    @step3 $hit0 index 0 using (X($1,$2,$3)):(Y($1,$2,$3)):(0):(axis-Y($1,$2,$3)) with vectors nohead lw 1.2 dt 2 lc rgb color(t0) title "t0, vertical", \
    @step3 $hit1 index 0 using (X($1,$2,$3)):(Y($1,$2,$3)):(0):(axis-Y($1,$2,$3)) with vectors nohead lw 1.2 dt 2 lc rgb color(t1) title "t1, vertical", \
    for [_=1:step >= 3 && roots == 0] $nearest using @point:(0):(f_v(f_nearest)-Y($1,$2,$3)) with vectors nohead lw 1.2 dt 2 lc rgb grey \
        title "nearest", \
    @step3 $hit1 index 0 using (X($1,$2,$3)):(axis) with @look1 lc rgb color(t1) title "t1", \
    @step3 $hit0 index 0 using (X($1,$2,$3)):(axis) with @look0 lc rgb color(t0) title "t0", \
    @step3 $center using (right_at(here(t_u(t0)) - 10, long("t0 = ".t0_text, text_size))):(axis - 40):(roots < 1 ? "" : math(touches ? "t_0 = t_1 = " : "t_0 = ").t0_text) \
        with labels right tc rgb color(t0) title "t0, label", \
    @step3 $center using (left_at(here(t_u(t1)) + 10, long("t1 = ".t1_text, text_size))):(axis - 40):(roots < 2 || touches ? "" : math("t_1 = ").t1_text) \
        with labels left tc rgb color(t1) title "t1, label", \
    @step3 $nearest using (X($1,$2,$3) + (aside eq "right" ? -10 : 10)):(axis - 40):(roots == 0 ? "no root: ".math("f")." is never below ".f_nearest_text : "") \
        with labels @aside tc rgb grey title "no root", \
    for [_=1:step >= 3 && differs("t0")] $hit0 index differs("t0") using (X($1,$2,$3)):(axis) with @square lc rgb ink title "your t0", \
    for [_=1:step >= 3 && differs("t1")] $hit1 index differs("t1") using (X($1,$2,$3)):(axis) with @square lc rgb ink title "your t1", \
    @step4 $hit1 index 0 using @point with @look1 lc rgb color(t1) title "second hit", \
    @step4 $hit0 index 0 using @point with @look0 lc rgb color(t0) title "first hit", \
    for [_=1:step >= 4 && roots == 0] $nearest using @point with @square lc rgb grey title "nearest point"
