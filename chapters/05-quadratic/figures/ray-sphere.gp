# ray-sphere.gp - where the line p + t v meets the circle (slide 'Intersecting a ray and a sphere').
touches = roots == 2 && t0 == t1
title = own("A ray and a sphere")
description = sprintf(own("The section through the ray and the center of the sphere. p is %s, v is %s, the center C is %s, \
r is %s%s. |p + t v|² = r² in object coordinates has a = %s, b = %s, c = %s, and b² − 4ac is %s:")." ", \
    origin_text, velocity_text, center_text, r_text, moved ? own("; p − C is")." ".object_p_text : "", a_text, b_text, c_text, D_text).( \
    roots == 0 ? sprintf(own("no hit. The line is closest to C at t = %s, at a distance of %s."), t_nearest_text, away_text) : \
    touches ? sprintf(own("the line touches the circle at t = %s."), t0_text) : \
    sprintf(own("the line meets the circle at t0 = %s and t1 = %s."), t0_text, t1_text)).( \
    hit > 0 ? sprintf(" ".own("The hit is at t = %s."), hit_text) : roots > 0 ? " ".own("No hit is in front of p.") : "").arrow_words(stride)
steps = 5
if (wrong) { set label 99 squares_are_yours }

# Across the line, for the marks of t.
off_u = seen_x(off_x, off_y, off_z)
off_v = seen_y(off_x, off_y, off_z)

plot @step2 $circle using @point with filledcurves closed fc rgb surface fs solid noborder title "disc", \
    @step2 $circle using @point with @lines lc rgb ink title "circle", \
    $behind index wrong using @point with @lines lc rgb grey dt 3 title "behind p", \
    $ahead index wrong using @point with lines lw 1.6 lc rgb blue title "p + t v", \
    $ticks index wrong using (X($1,$2,$3)-5*off_u):(Y($1,$2,$3)-5*off_v):(10*off_u):(10*off_v) \
        with vectors nohead lw 1 lc rgb grey title "marks of t", \
    $v index wrong using @vector with @arrow lc rgb blue title "v", \
    for [_=1:near_p] $p index wrong using @point with @dot lc rgb blue title "p", \
    for [_=1:step >= 2 && !small_ball] $radius using @vector with @thin_arrow lc rgb ink title "r", \
    @step2 $center using @point with @dot lc rgb ink title "c", \
    for [_=1:step >= 4 && roots == 0] $apart using @vector with vectors nohead lw 1.2 dt 2 lc rgb grey title "nearest", \
    for [_=1:step >= 4 && roots == 0] $nearest using @point with @square lc rgb grey title "nearest point", \
    @step4 $hit0 index 0 using @point with @ring lc rgb color(t0) title "t0", \
    @step4 $hit1 index 0 using @point with @ring lc rgb color(t1) title "t1", \
    for [_=1:step >= 4 && differs("t0")] $hit0 index differs("t0") using @point with @square lc rgb ink title "your t0", \
    for [_=1:step >= 4 && differs("t1")] $hit1 index differs("t1") using @point with @square lc rgb ink title "your t1", \
    @step5 $used index 0 using @point with @dot lc rgb blue title "the hit", \
    for [_=1:step >= 5 && differs("hit")] $used index differs("hit") using @point with @square lc rgb blue title "your hit", \
    @labels
