# explain.gp - the whole story of one pixel, in steps (slide 'Ray casting process').
# In words, also the quadratic of each sphere k of those that are explained.
of(what, k) = value(sprintf("%s_%d_text", what, k))
plain(k) = sprintf(own("Sphere %s: a = %s, b = %s, c = %s, discriminant %s, %s.")." ", value(sprintf("name_%d", k)), of("a", k), \
    of("b", k), of("c", k), of("discriminant", k), value(sprintf("roots_%d", k)) < 1 ? own("no root: missed") : \
    own("roots")." ".of("root_0", k)." ".own("and")." ".of("root_1", k).(value(sprintf("root_1_%d", k)) > 0 ? "" : ": ".own("behind the eye")))
all_plain(k) = k > told ? "" : plain(k).all_plain(k + 1)
title = own("One pixel, explained")
description = sprintf(own("Pixel %s of %s has its center at (%s, %s); s is %s, t is %s; the vector from the eye, %s, is v = %s.")." ", \
    pixel_text, size_text, screen_x_text, screen_y_text, s_text, t_text, p_text, vector_v_text).all_plain(1). \
    (all_hits == 0 ? own("The ray hits nothing, so the pixel shows the background.")." " : \
    sprintf(own("The smallest t > 0 is %s, on sphere %s.")." ", nearest_text, nearest_name)). \
    sprintf(own("The color is %s.")." ", bytes_text).in_part(0).drawn_text
steps = 6
@spheres
# Visible on every sphere: in a white ring with a black rim.
rim = "points pt 7 ps 1.1 lc rgb 'black'"
white = "points pt 7 ps 0.9 lc rgb 'white'"

plot @patches @behind \
    $plane index 0 using @point with filledcurves closed fc rgb surface fs solid noborder title "surface", \
    @step6 $pixel index 0 using @point with filledcurves closed fc rgb int(pixel_rgb) fs solid noborder title "pixel", \
    $grid index 0 using @point with @hair lc rgb grey title "grid", \
    @who $plane index who using @point with @lines lc rgb ink dt dash(who) title "plane", \
    @before \
    @who $pixel index who using @point with @thick lc rgb ink dt dash(who) title "outline of the pixel", \
    $crossing using @point with points pt 7 ps 0.3 lc rgb ink title "center", \
    @step3 $ray index 0 using @point with @hidden lc rgb blue title "ray, all of it", \
    @step5 @who $ray index who using @bold with @ray dt dash(who) lc rgb blue title "ray", \
    @step2 @who $arrow index who using @vector with @arrow lc rgb blue dt dash(who) title "vector from the eye", \
    @step4 $hits index 0 using @point with @rim title "hits, rim", \
    @step4 $hits index 0 using @point with @white title "hits", \
    @step5 @who $hits index who every ::0::0 using @point with points pt (who ? 8 : 7) ps 0.7 lc rgb blue title "closest hit", \
    $eye using @point with @dot lc rgb blue title "eye", \
    @labels
