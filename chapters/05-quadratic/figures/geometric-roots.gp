# geometric-roots.gp - the same roots by geometry: closest approach, distance from the center, half chord.
touches = roots == 2 && t0 == t1
title = own("The same roots by geometry")
description = sprintf(own("The section through the ray and the center C of the sphere, turned so that the ray goes to the right. L is the vector \
from p to C: %s. Its part along v has the length s = %s and ends at M, the point of the line that is nearest to C. m = %s is the distance \
from C to M, and r is %s"), l_text, s_text, m_text, r_text).( \
    roots == 0 ? own(": m is larger than r, so the line misses the sphere.") : touches ? own(": m = r, so the line touches the sphere.") : \
    sprintf(own(". Half the chord is k = √(r² − m²) = %s, and the roots are (s − k)/|v| = %s and (s + k)/|v| = %s."), k_text, t0_text, t1_text))
steps = 5
if (wrong) { set label 99 squares_are_yours }

plot $circle using @point with filledcurves closed fc rgb surface fs solid noborder title "disc", \
    $circle using @point with @lines lc rgb ink title "circle", \
    $behind index wrong using @point with @lines lc rgb grey dt 3 title "behind p", \
    $ahead index wrong using @point with lines lw 1.6 lc rgb blue title "p + t v", \
    for [_=1:step >= 2 && near_p] $l index wrong using @vector with @arrow lc rgb ink title "L", \
    for [_=1:step >= 3 && near_p] $closest index wrong using @vector with @green_arrow title "s", \
    @step4 $height index 0 using @vector with @stroke lc rgb pink title "m", \
    @step4 $corner using @point with @hair lc rgb grey title "right angle", \
    @step5 $half_chord index 0 using @vector with vectors nohead lw 3 lc rgb orange title "k", \
    @step5 $spoke using @vector with @thin_arrow lc rgb ink title "r", \
    $center using @point with @dot lc rgb ink title "C", \
    for [_=1:near_p] $p index wrong using @point with @dot lc rgb blue title "p", \
    @step3 $nearest index 0 using @point with @dot lc rgb green title "M", \
    @step5 $hit0 index 0 using @point with @ring lc rgb color(t0) title "t0", \
    @step5 $hit1 index 0 using @point with @ring lc rgb color(t1) title "t1", \
    for [_=1:step >= 5 && differs("t0")] $hit0 index differs("t0") using @point with @square lc rgb ink title "your t0", \
    for [_=1:step >= 5 && differs("t1")] $hit1 index differs("t1") using @point with @square lc rgb ink title "your t1", \
    @labels
