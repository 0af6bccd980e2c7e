# explain.gp - the whole story of one pixel, in steps (slide 'Ray casting process').
note = drawn(0)
# The numbers of sphere k of those that are explained, and their meaning.
of(what, k) = k > told ? "" : value(sprintf("%s_%d_text", what, k))
number(what, k) = k > told ? 0 : value(sprintf("%s_%d", what, k))
called(k) = k > told ? "" : value(sprintf("name_%d", k))
coefficients(k) = called(k).":  ".math("a")." = ".of("a", k).",  ".math("b")." = ".of("b", k).",  ".math("c")." = ".of("c", k)
ends(k) = number("roots", k) < 1 ? "no root: missed" : math("t")." = ".of("root_0", k)." and ".of("root_1", k). \
    (number("root_1", k) > 0 ? "" : ": behind")
solved(k) = math("b")."² − 4".math("ac")." = ".of("discriminant", k).",  ".ends(k)
plain(k) = sprintf("Sphere %s: a = %s, b = %s, c = %s, discriminant %s, %s. ", called(k), of("a", k), of("b", k), \
    of("c", k), of("discriminant", k), number("roots", k) < 1 ? "no root" : "roots ".of("root_0", k)." and ".of("root_1", k))
all_plain(k) = k > told ? "" : plain(k).all_plain(k + 1)
verdict = all_hits == 0 ? "no hit: background" : "smallest ".math("t")." > 0:  ".nearest_text.", sphere ".nearest_name
title = "One pixel, explained"
description = sprintf("Pixel %s of %s has its centre at (%s, %s); s is %s, t is %s; the vector from the eye, %s, is %s. ", \
    pixel_text, size_text, screen_x_text, screen_y_text, s_text, t_text, p_text, vector_v_text).all_plain(1). \
    (all_hits == 0 ? "The ray hits nothing, so the pixel shows the background. " : \
    sprintf("The smallest t > 0 is %s, on sphere %s. ", nearest_text, nearest_name)). \
    sprintf("The colour is %s. ", bytes_text).in_part(0).note
steps = 6
room = shape eq "4:3" ? "0.03 0.43 0.14 0.90" : "0.04 0.56 0.14 0.90"
@see
@spheres
left = width * (shape eq "4:3" ? 0.45 : 0.595)
line(k) = height - 48 - 27 * k

plot @patches @behind \
    $plane using @point with filledcurves closed fc rgb surface fs solid noborder title "surface", \
    @step6 $pixel using @point with filledcurves closed fc rgb int(pixel_rgb) fs solid noborder title "pixel", \
    $grid using @point with @hair lc rgb faint title "grid", \
    $plane using @point with @lines lc rgb ink title "plane", \
    @before \
    $pixel using @point with @thick lc rgb ink title "outline of the pixel", \
    $crossing using @point with points pt 7 ps 0.3 lc rgb ink title "centre", \
    @step3 $ray index 0 using @point with lines lw 1.2 dt 3 lc rgb blue title "ray, all of it", \
    @step5 @who $ray index who using @bold with lines lw 1.4 dt dash(who) lc rgb blue title "ray", \
    @step2 @who $arrow index who using @vector with @arrow lc rgb blue dt dash(who) title "vector from the eye", \
    @names \
    @step4 $hits index 0 using @point with @ring lc rgb ink title "hits", \
    @step5 @who $hits index who every ::0::0 using @point with points pt (who ? 8 : 7) ps 0.6 lc rgb orange title "closest hit", \
    $eye using (left):(line(0)):("pixel ".pixel_text." of ".size_text) with labels left tc rgb ink title "words 1", \
    $eye using (left):(line(1)):(sprintf("centre (%s, %s)", screen_x_text, screen_y_text)) with labels @little left \
        tc rgb ink title "words 2", \
    $eye using (left):(line(2)):(math("s")." = ".s_text.",  ".math("t")." = ".t_text) with labels @little left \
        tc rgb ink title "words 3", \
    @step2 $eye using (left):(line(3.2)):(math("v")." = ".vector_v_text) with labels @little left tc rgb blue title "words 4", \
    @step3 $eye using (left):(line(4.2)):("ray  ".math("p + t v").",  ".math("p")." = ".p_text) with labels @little left \
        tc rgb blue title "words 5", \
    @step4 for [k=1:told] $eye using (left):(line(3.9 + 1.9 * k)):(coefficients(k)) with labels @little left \
        tc rgb ink title "words 6", \
    @step4 for [k=1:told] $eye using (left + 18):(line(4.7 + 1.9 * k)):(solved(k)) with labels @little left \
        tc rgb grey title "words 7", \
    @step5 $eye using (left):(line(6.2 + 1.9 * told)):(verdict) with labels left tc rgb orange title "words 8", \
    @step6 $eye using (left + 12):(line(7.4 + 1.9 * told)) with points pt 5 ps 1.6 lc rgb int(pixel_rgb) title "swatch", \
    @step6 $eye using (left + 12):(line(7.4 + 1.9 * told)) with points pt 4 ps 1.6 lw 1 lc rgb ink title "swatch, outline", \
    @step6 $eye using (left + 34):(line(7.4 + 1.9 * told)):("colour ".bytes_text) with labels left tc rgb ink title "words 9", \
    $eye using @point with @dot lc rgb blue title "eye", \
    $eye using @point:("eye") with labels tc rgb blue offset 0,-1 title "eye, label", \
    $eye using (16):(20):(small(note)) with labels left tc rgb grey title "note"
