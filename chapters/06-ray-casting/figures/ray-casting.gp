# ray-casting.gp - one ray, all its hits, and the colour of the closest one (slide 'Ray casting').
note = drawn(0)
# In words: the rows of $hits after the comment and the first row, which is the closest.
hits_from(i) = i > |$hits| || i > 9 ? "" : (i < 3 || words($hits[i]) < 5 || word($hits[i], 5) eq "-1" ? "" : \
    sprintf("It meets sphere %s at t = %.4g. ", ball_name(int(word($hits[i], 5) + 0)), word($hits[i], 4) + 0)).hits_from(i + 1)
title = "Ray casting: the closest hit colours the pixel"
description = sprintf("The ray of pixel %s of %s goes from the eye through the image plane. ", pixel_text, size_text). \
    (all_hits == 0 ? "It meets no sphere, so the pixel has the colour of the background. " : \
    sprintf("It meets %d of %d spheres; the closest hit is on sphere %s at t = %s, so the pixel has its colour. ", \
        all_hits, all_balls, nearest_name, nearest_text).hits_from(1)). \
    sprintf("%d of the %s pixels that are drawn show a sphere. %s", cells, grid_text, in_part(0).note)
hit_words(i, t, ball) = math("t").sprintf(" = %.4g, sphere %s%s", t, ball_name(ball), i == 0 ? ": closest" : "")
# The words of a hit are at the left of the line to it, or at the right if the edge is too near.
at_left(i, ball, x) = ball >= 0 && x > (i == 0 ? 330 : 240)
nothing(i) = all_hits == 0 && i == 0 ? "the ray meets nothing" : ""
under(k) = 96 - 24 * k
steps = 5
room = "0.04 0.96 0.24 0.93"
@see
@spheres

plot @patches @behind \
    $plane using @point with filledcurves closed fc rgb surface fs solid noborder title "surface", \
    @step5 $pixels index 0 using @point:4 with filledcurves closed fc rgb variable fs solid noborder title "pixels", \
    for [_=5:wrong * step:1000] $pixels index wrong using @point:4 with lines lw 2.2 dt 2 lc rgb variable title "your pixels", \
    @step4 $pixel using @point with filledcurves closed fc rgb int(pixel_rgb) fs solid noborder title "pixel", \
    $grid using @point with @hair lc rgb faint title "grid", \
    $plane using @point with @lines lc rgb ink title "plane", \
    @before \
    @step2 $pixel using @point with @thick lc rgb ink title "outline of the pixel", \
    @step2 $ray index 0 using @point with lines lw 1.2 dt 3 lc rgb blue title "ray, all of it", \
    @step2 @who $ray index who using @bold with lines lw 2.2 dt dash(who) lc rgb blue title "ray", \
    @names \
    @step3 $hits index 0 using @point:(0):(under($0) + 10 - Y($1,$2,$3)) with vectors nohead lw 0.8 lc rgb grey \
        title "leader", \
    @step3 $hits index 0 using ($5 < 0 ? width / 2 : X($1,$2,$3) - 6):(under($0)):(at_left($0, $5, $5 < 0 ? 0 : X($1,$2,$3)) ? \
        hit_words($0, $4, $5) : "") with labels right tc rgb ink title "t of the hits", \
    @step3 $hits index 0 using ($5 < 0 ? width * 0.4 : X($1,$2,$3) + 6):(under($0)):($5 < 0 || \
        at_left($0, $5, $5 < 0 ? 0 : X($1,$2,$3)) ? nothing($0) : hit_words($0, $4, $5)) \
        with labels left tc rgb ink title "t, other side", \
    @step3 @who $hits index who every ::1 using @point with @ring lc rgb ink title "farther hits", \
    @step3 @who $hits index who every ::0::0 using @point with points pt (who ? 8 : 7) ps 0.6 lc rgb ink title "closest hit", \
    $eye using @point with @dot lc rgb blue title "eye", \
    $eye using @point:("eye") with labels tc rgb blue offset 0,-1 title "eye, label", \
    $eye using (16):(height - 20):(small(note)) with labels left tc rgb grey title "note"
