# double-dwh.gp - 'Would it matter if d, w, h were all doubled?' (slide 'Camera'): no, the same rays.
title = own("d, w and h all doubled: the same rays")
description = sprintf(own("Four rays go from the eye p through the corners of the image plane with d = %s, w = %s, h = %s. \
If all three are doubled, 2 d = %s, 2 w = %s, 2 h = %s, the corners of the plane are on the same rays. If all three are \
divided by d, so that d/d = %s, w/d = %s, h/d = %s, they are also on the same rays. A fifth ray goes through the same \
place on all three planes: s = %s of the way across, t = %s of the way up.").(to_scale ? "" : " ".own("The plane at d/d is not drawn to scale.")), d_text, w_text, h_text, twice_d_text, twice_w_text, twice_h_text, \
    unit_d_text, unit_w_text, unit_h_text, s_text, t_text)
steps = 4

# The dimensions of a plane: how far they are from its edges, and the thin lines to the one below.
gap = 14
plot @step2 $twice_plane index 0 using @point with filledcurves closed fc rgb surface fs @glass noborder title "surface of twice", \
    @step2 @who $twice_plane index who using @point with @lines lc rgb ink dt dash(who) title "twice", \
    $plane index 0 using @point with filledcurves closed fc rgb surface fs @glass noborder title "surface", \
    @who $plane index who using @point with @thick lc rgb ink dt dash(who) title "plane", \
    @step3 $unit_plane index 0 using @point with filledcurves closed fc rgb surface fs @glass noborder title "surface of unit", \
    @step3 @who $unit_plane index who using @point with @lines lc rgb ink dt dash(who) title "unit", \
    $plane_down index 0 using @vector with vectors nohead lw 0.8 lc rgb grey title "down from the plane", \
    @step2 $twice_plane_down index 0 using @vector with vectors nohead lw 0.8 lc rgb grey title "down from twice", \
    @step3 $unit_plane_down index 0 using @vector with vectors nohead lw 0.8 lc rgb grey title "down from unit", \
    $plane_d index 0 using @vector with @pink_dimension title "plane d", \
    $plane_w index 0 using (@point_x):(@point_y + gap):@moved with @orange_dimension title "plane w", \
    $plane_h index 0 using (@point_x + gap):(@point_y):@moved with @green_dimension title "plane h", \
    @step2 $twice_plane_d index 0 using @vector with @pink_dimension title "twice plane d", \
    @step2 $twice_plane_w index 0 using (@point_x):(@point_y + gap):@moved with @orange_dimension title "twice plane w", \
    @step2 $twice_plane_h index 0 using (@point_x + gap):(@point_y):@moved with @green_dimension title "twice plane h", \
    @step3 $unit_plane_d index 0 using @vector with @pink_dimension title "unit plane d", \
    @step3 $unit_plane_w index 0 using (@point_x):(@point_y + gap):@moved with @orange_dimension title "unit plane w", \
    @step3 $unit_plane_h index 0 using (@point_x + gap):(@point_y):@moved with @green_dimension title "unit plane h", \
    @who $rays index who every ::0::3 using @vector with @segment lc rgb blue dt dash(who) title "rays", \
    @step4 @who $rays index who every ::4::4 using @vector with @arrow lc rgb blue dt dash(who) title "one ray", \
    @step4 $same_place index 0 using @point with @dot lc rgb blue title "same place", \
    $eye using @point with @dot lc rgb blue title "eye", \
    @labels
