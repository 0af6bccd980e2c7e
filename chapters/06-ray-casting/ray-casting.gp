# ray-casting.gp - one ray, all it meets, and the colour of what is closest (slide 'Ray casting').
title = "Ray casting: the closest hit colours the pixel"
hit_words(i, t, ball) = sprintf("%s = %.4g, sphere %s", "t", t, ball_name(ball)).(i == 0 ? ": closest" : "")
description = sprintf("The ray of pixel %s of %s goes from the eye through the image plane. ", pixel_text, size_text). \
    (all_hits == 0 ? "It meets no sphere, so the pixel keeps the background. " : \
    sprintf("It meets %d of the %d spheres; the closest hit is on sphere %s at t = %s, so the pixel has its colour. ", \
        all_hits, all_balls, nearest_name, nearest_text)). \
    sprintf("%d of the %s pixels that are drawn show a sphere. Drawn are %d of %d spheres.", \
        cells, grid_text, balls, all_balls)
note = (coarse ? sprintf("drawn with %s of %s pixels", grid_text, size_text) : ""). \
    (balls < all_balls ? sprintf("%s%d of %d spheres are drawn", coarse ? "; " : "", balls, all_balls) : "")
steps = 5
room = "0.04 0.96 0.26 0.94"
@see
@spheres
row(k) = 100 - 26 * k

plot @behind \
    $plane using @point with filledcurves closed fc rgb surface fs solid noborder title "surface", \
    @step5 $pixels index 0 using @point:4 with filledcurves closed fc rgb variable fs solid noborder title "pixels", \
    @step5 for [_=1:wrong] $pixels index 1 using @point:4 with lines lw 2.2 dt 2 lc rgb variable title "your pixels", \
    @step4 $pixel using @point with filledcurves closed fc rgb int(pixel_rgb) fs solid noborder title "pixel", \
    $grid using @point with @hair lc rgb faint title "grid", \
    $plane using @point with @lines lc rgb ink title "plane", \
    @before \
    $pixel using @point with @thick lc rgb ink title "outline of the pixel", \
    @step2 $ray index 0 using @point with lines lw 1.2 dt 3 lc rgb ink title "ray, hidden too", \
    @step2 @who $ray index who using (X($1,$2,$3)):($5 == 1 && seen($1,$2,$3) ? Y($1,$2,$3) : NaN) \
        with lines lw 2.2 dt dash(who) lc rgb ink title "ray", \
    @names \
    @step3 $hits index 0 using @point:(0):(row($0) + 10 - Y($1,$2,$3)) with vectors nohead lw 0.8 lc rgb grey title "leader", \
    @step3 $hits index 0 using (all_hits ? X($1,$2,$3) - 6 : width / 2):(row($0)):(all_hits ? hit_words($0, $4, $5) : "the ray meets nothing") \
        with labels right tc rgb ink title "t of the hits", \
    @step3 @who $hits index who every ::1 using @point with @ring lc rgb ink title "farther hits", \
    @step3 @who $hits index who every ::0::0 using @point with @dot lc rgb ink title "closest hit", \
    $eye using @point with @dot lc rgb ink title "eye", \
    $eye using @point:("eye") with labels tc rgb ink offset 0,-1 title "eye, label", \
    $eye using (16):(20):(note) with labels left tc rgb grey font ",13" title "note"
