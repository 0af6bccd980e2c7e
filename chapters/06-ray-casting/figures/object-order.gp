# object-order.gp - for one object, the pixels that it colors (slide 'Object order').
title = own("Object order: for each object, find the pixels that it colors")
description = (!eye_inside ? sprintf(own("Lines go from the outline of sphere %s to the eye. The places where they cross the image plane \
are its outline in the picture. Of the pixels that are drawn, the sphere colors those with centers inside: %d of %s.")." ", \
    object_name, cells, grid_text) : sprintf(own("Sphere %s has no outline here, because the eye is in it. It colors %d of the \
%s pixels that are drawn.")." ", object_name, cells, grid_text)).drawn_text
steps = 4
@spheres
@seen_front

plot @behind \
    $plane index 0 using @point with filledcurves closed fc rgb surface fs solid noborder title "surface", \
    @step4 $pixels index 0 using @point:4 with filledcurves closed fc rgb variable fs solid noborder title "pixels", \
    for [_=4:wrong * step:1000] $pixels index wrong using @point:4 with lines lw 2.2 dt 2 lc rgb variable \
        title "your pixels", \
    $grid index 0 using @point with @hair lc rgb grey title "grid", \
    @who $plane index who using @point with @lines lc rgb ink dt dash(who) title "plane", \
    @step4 $centers using @point with points pt 7 ps (coarse ? 0.07 : 0.12) lc rgb ink title "centers", \
    @before \
    @step2 $lines using @point with @hidden lc rgb blue title "lines to the eye, all of them", \
    @step2 $lines using @bold with @ray lc rgb blue title "lines to the eye", \
    @step2 $heads using @vector with vectors head filled size 16,18,90 lw 1.6 lc rgb blue title "towards the eye", \
    @step3 $outline using @point with @thick lc rgb ink title "outline on the plane", \
    @front_plane \
    @step4 @front_pixels \
    @front_lines, \
    $eye using @point with @dot lc rgb blue title "eye", \
    @labels
