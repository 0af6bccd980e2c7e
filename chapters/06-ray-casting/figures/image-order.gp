# image-order.gp - for each pixel its ray, and the sphere that it hits (slide 'Image order').
title = own("Image order: for each pixel, find the object that colors it")
description = sprintf(own("A ray goes from the eye through the center of pixel %s of %s and %s.")." ", pixel_text, size_text, \
    all_hits == 0 ? own("meets no sphere") : sprintf(own("meets sphere %s at t = %s"), nearest_name, nearest_text)). \
    (misses ? own("The ray of another pixel meets nothing.")." " : "").sprintf(own("The rays through the centers of %d of the \
%s pixels that are drawn hit a sphere. %s"), cells, grid_text, in_part(0).drawn_text)
steps = 5
@spheres
@seen_front

plot @patches @behind \
    $plane index 0 using @point with filledcurves closed fc rgb surface fs solid noborder title "surface", \
    @step5 $pixels index 0 using @point:4 with filledcurves closed fc rgb variable fs solid noborder title "pixels", \
    for [_=5:wrong * step:1000] $pixels index wrong using @point:4 with lines lw 2.2 dt 2 lc rgb variable \
        title "your pixels", \
    @step3 $pixel index 0 using @point with filledcurves closed fc rgb int(pixel_rgb) fs solid noborder title "pixel", \
    $grid index 0 using @point with @hair lc rgb grey title "grid", \
    @who $plane index who using @point with @lines lc rgb ink dt dash(who) title "plane", \
    $centers using @point with points pt 7 ps (coarse ? 0.07 : 0.12) lc rgb ink title "centers", \
    @before \
    @step2 @who $pixel index who using @point with @thick lc rgb ink dt dash(who) title "outline of the pixel", \
    @step2 $ray index 0 using @point with @hidden lc rgb blue title "ray, all of it", \
    @step2 @who $ray index who using @bold with @ray dt dash(who) lc rgb blue title "ray", \
    @step3 @who $hits index who every ::0::0 using @point with points pt (who ? 8 : 7) ps 0.6 lc rgb ink title "closest hit", \
    @step4 for [who=0:wrong] $miss index who using @bold with lines lw 1.2 dt dash(who) lc rgb grey title "ray that misses", \
    @front_plane \
    @step5 @front_pixels \
    @step3 @front_pixel \
    @front_lines, \
    @step2 $pixel index 0 using @front with @thick lc rgb ink title "picture, outline of the pixel", \
    $eye using @point with @dot lc rgb blue title "eye", \
    @labels
