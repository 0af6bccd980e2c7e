# ray-casting.gp - one ray, all its hits, and the color of the closest one (slide 'Ray casting').
title = own("Ray casting: the closest hit colors the pixel")
description = sprintf(own("The ray of pixel %s of %s goes from the eye through the image plane.")." ", pixel_text, size_text). \
    (all_hits == 0 ? own("It meets no sphere, so the pixel has the color of the background.")." " : \
    sprintf(own("It meets %d of %d spheres; the closest hit is on sphere %s at t = %s, so the pixel has its color.")." ", \
        all_hits, all_balls, nearest_name, nearest_text).farther_hits). \
    sprintf(own("%d of the %s pixels that are drawn show a sphere. %s"), cells, grid_text, in_part(0).drawn_text)
steps = 5
@spheres
@seen_front

plot @patches @behind \
    $plane index 0 using @point with filledcurves closed fc rgb surface fs solid noborder title "surface", \
    @step5 $pixels index 0 using @point:4 with filledcurves closed fc rgb variable fs solid noborder title "pixels", \
    for [_=5:wrong * step:1000] $pixels index wrong using @point:4 with lines lw 2.2 dt 2 lc rgb variable title "your pixels", \
    @step4 $pixel index 0 using @point with filledcurves closed fc rgb int(pixel_rgb) fs solid noborder title "pixel", \
    $grid index 0 using @point with @hair lc rgb grey title "grid", \
    @who $plane index who using @point with @lines lc rgb ink dt dash(who) title "plane", \
    @before \
    @step2 @who $pixel index who using @point with @thick lc rgb ink dt dash(who) title "outline of the pixel", \
    @step2 $ray index 0 using @point with @hidden lc rgb blue title "ray, all of it", \
    @step2 @who $ray index who using @bold with @ray dt dash(who) lc rgb blue title "ray", \
    @step3 @who $hits index who every ::1 using @point with @ring lc rgb ink title "farther hits", \
    @step3 @who $hits index who every ::0::0 using @point with points pt (who ? 8 : 7) ps 0.6 lc rgb ink title "closest hit", \
    @front_plane \
    @step5 @front_pixels \
    @step4 @front_pixel \
    @front_lines, \
    @step2 $pixel index 0 using @front with @thick lc rgb ink title "picture, outline of the pixel", \
    $eye using @point with @dot lc rgb blue title "eye", \
    @labels
