# parabola.gp - f(t) = |p + t v|² − r² above the ray and the sphere, with one axis for t (slide 'Solving
# quadratic'): where f is 0, the line meets the circle.
touches = roots == 2 && t0 == t1
title = own("The quadratic as a parabola")
description = sprintf(own("Above, f(t) = |p + t v|² − r² = %s above an axis for t; f(0) is %s. Below, on the same \
axis, the ray and the circle.")." ", polynomial_text, c_text).( \
    roots == 0 ? sprintf(own("The parabola stays above the axis, and the line misses the circle. At the lowest point, t = %s, f is %s."), \
        t_nearest_text, f_nearest_text) : \
    touches ? sprintf(own("The parabola touches the axis, and the line touches the circle, at t = %s."), t0_text) : \
    sprintf(own("The parabola crosses the axis, and the line crosses the circle, at t0 = %s and t1 = %s."), t0_text, t1_text)).arrow_words(stride)
steps = 4
if (wrong) { set label 99 squares_are_yours }

# Places of t, along the line, and of f.
t_u(t) = zero_x[1] + size[1] * (t_zero + speed * t)
f_v(f) = zero_y[1] + size[1] * (f_axis + f_scale * f)
axis = f_v(0)
look0 = color(t0) eq blue ? dot : ring
look1 = touches || color(t1) eq blue ? dot : ring

plot $circle using @point with filledcurves closed fc rgb surface fs solid noborder title "disc", \
    $circle using @point with @lines lc rgb ink title "circle", \
    $behind index wrong using @point with @lines lc rgb grey dt 3 title "behind p", \
    $ahead index wrong using @point with lines lw 1.6 lc rgb blue title "p + t v", \
    $v index wrong using @vector with @arrow lc rgb blue title "v", \
    for [_=1:near_p] $p index wrong using @point with @dot lc rgb blue title "p", \
    $center using @point with @dot lc rgb ink title "c", \
    for [_=1:!small_ball] $radius using @vector with @thin_arrow lc rgb ink title "r", \
    @step2 $axis index wrong using @vector with @thin_arrow lc rgb grey title "axis", \
    @step2 $ticks index wrong using (X($1,$2,$3)):(axis-5):(0):(10) with vectors nohead lw 1 lc rgb grey title "marks of t", \
    @step2 @who $parabola index who using (t_u($1)):(f_v($2)) with @thick lc rgb ink dt dash(who) title "f", \
    for [_=1:step >= 2 && above] $once using (t_u(0)):(f_v(c)) with @ring lc rgb grey title "f(0)", \
    @step3 $hit0 index 0 using (X($1,$2,$3)):(Y($1,$2,$3)):(0):(axis-Y($1,$2,$3)) with vectors nohead lw 1.2 dt 2 lc rgb color(t0) title "t0, vertical", \
    @step3 $hit1 index 0 using (X($1,$2,$3)):(Y($1,$2,$3)):(0):(axis-Y($1,$2,$3)) with vectors nohead lw 1.2 dt 2 lc rgb color(t1) title "t1, vertical", \
    for [_=1:step >= 3 && roots == 0] $nearest using @point:(0):(f_v(f_nearest)-Y($1,$2,$3)) with vectors nohead lw 1.2 dt 2 lc rgb grey \
        title "nearest", \
    @step3 $hit1 index 0 using (X($1,$2,$3)):(axis) with @look1 lc rgb color(t1) title "t1", \
    @step3 $hit0 index 0 using (X($1,$2,$3)):(axis) with @look0 lc rgb color(t0) title "t0", \
    for [_=1:step >= 3 && differs("t0")] $hit0 index differs("t0") using (X($1,$2,$3)):(axis) with @square lc rgb ink title "your t0", \
    for [_=1:step >= 3 && differs("t1")] $hit1 index differs("t1") using (X($1,$2,$3)):(axis) with @square lc rgb ink title "your t1", \
    @step4 $hit1 index 0 using @point with @look1 lc rgb color(t1) title "second hit", \
    @step4 $hit0 index 0 using @point with @look0 lc rgb color(t0) title "first hit", \
    for [_=1:step >= 4 && roots == 0] $nearest using @point with @square lc rgb grey title "nearest point", \
    @labels
