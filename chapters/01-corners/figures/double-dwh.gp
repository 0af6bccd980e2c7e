# double-dwh.gp - 'Would it matter if d, w, h were all doubled?' (slide 'Camera'): no, the same rays.
title = "d, w and h all doubled: the same rays"
description = sprintf("Four rays go from the eye p through the corners of the image plane with d = %s, w = %s, h = %s. \
If all three are doubled, 2 d = %s, 2 w = %s, 2 h = %s, the corners of the plane are on the same rays. If all three are \
divided by d, so that d/d = %s, w/d = %s, h/d = %s, they are also on the same rays. A fifth ray goes through the same \
place on all three planes: s = %s of the way across, t = %s of the way up.", d_text, w_text, h_text, twice_d_text, twice_w_text, twice_h_text, \
    unit_d_text, unit_w_text, unit_h_text, s_text, t_text)
steps = 4
room = "0.06 0.92 0.08 0.94"
if (!turned) azimuth = 32
@see

row(d, d_is, w, w_is, h, h_is) = math(d)." = ".d_is.",   ".math(w)." = ".w_is.",   ".math(h)." = ".h_is
plot @step2 $twice_plane index 0 using @point with filledcurves closed fc rgb surface fs @glass noborder title "surface of twice", \
    @step2 @who $twice_plane index who using @point with @thick lc rgb orange dt dash(who) title "twice", \
    $plane index 0 using @point with filledcurves closed fc rgb surface fs @glass noborder title "surface", \
    @who $plane index who using @point with @thick lc rgb ink dt dash(who) title "plane", \
    @step3 $unit_plane index 0 using @point with filledcurves closed fc rgb surface fs @glass noborder title "surface of unit", \
    @step3 @who $unit_plane index who using @point with @thick lc rgb green dt dash(who) title "unit", \
    @who $rays index who every ::0::3 using @vector with @leg lc rgb blue dt dash(who) title "rays", \
    @step4 @who $rays index who every ::4::4 using @vector with @arrow lc rgb blue dt dash(who) title "one ray", \
    @step4 $same_place index 0 using @point with @dot lc rgb blue title "same place", \
    $plane index 0 every ::0::0 using (@point_x - 4):(@point_y + 12):(math("d")) with labels right tc rgb ink title "d", \
    @step2 $twice_plane index 0 every ::0::0 using (@point_x - 4):(@point_y + 12):(math("2 d")) with labels right tc rgb orange title "2 d", \
    @step3 $unit_plane index 0 every ::0::0 using (@point_x - 4):(@point_y + 12):(math("d/d")) with labels right tc rgb green title "d/d", \
    $eye using (24):(72):(row("d", d_text, "w", w_text, "h", h_text)) with labels left tc rgb ink title "d w h", \
    @step2 $eye using (24):(48):(row("2 d", twice_d_text, "2 w", twice_w_text, "2 h", twice_h_text)) \
        with labels left tc rgb orange title "2 d 2 w 2 h", \
    @step3 $eye using (24):(24):(row("d/d", unit_d_text, "w/d", unit_w_text, "h/d", unit_h_text)) \
        with labels left tc rgb green title "d/d w/d h/d", \
    $eye using @point with @dot lc rgb blue title "eye", \
    $eye using (@point_x - 14):(@point_y - 10):(math("p")) with labels tc rgb blue title "p"
