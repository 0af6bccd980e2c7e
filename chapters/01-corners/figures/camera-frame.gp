# camera-frame.gp - the camera <p, r, u, f, d, w, h> (slide 'Camera').
title = "A camera: a frame, a distance, a width, a height"
description = sprintf("The eye p is at %s. Three arrows at right angles start there: right r is %s, up u is %s, \
forward f is %s. The image plane is straight ahead, at the distance d = %s. It is a grid of 8 by 8 pixels, w = %s \
wide and h = %s high. Lines go from the eye to its corners. The arrows x, y, z show the world's axes%s.", \
    eye_text, right_text, up_text, forward_text, d_text, w_text, h_text, \
    origin_is_far ? ", here below the camera, because their origin is too far away" : "")
steps = 4
room = "0.06 0.86 0.09 0.94"
if (!turned) azimuth = 32
@see

# How far dimensions are from the edges.
gap = 14
plot $x_axis using @vector with @axis lc rgb grey title "x axis", \
    $y_axis using @vector with @axis lc rgb grey title "y axis", \
    $z_axis using @vector with @axis lc rgb grey title "z axis", \
    $x_axis using (@tip_x + 10):(@tip_y - 8):(math("x")) with labels tc rgb grey title "x", \
    $y_axis using (@tip_x - 12):(@tip_y - 2):(math("y")) with labels tc rgb grey title "y", \
    $z_axis using (@tip_x + 12):(@tip_y):(math("z")) with labels tc rgb grey title "z", \
    @step2 $plane index 0 using @point with filledcurves closed fc rgb surface fs @glass noborder title "surface", \
    @step3 $grid index 0 using @point with @hair lc rgb grey title "grid", \
    @step2 @who $plane index who using @point with @thick lc rgb ink dt dash(who) title "plane", \
    @step2 @who $ahead index who using @vector with @leg lc rgb ink dt dash(who) title "ahead", \
    @step2 $ahead index 0 using @tip with @dot lc rgb ink title "middle", \
    @step2 $ahead index 0 using (@half_x):(@half_y - 14):(math("d")." = ".d_text) with labels tc rgb ink title "d", \
    @step2 $upper_edge index 0 using (@point_x):(@point_y + gap):@moved with @dimension lc rgb ink title "w", \
    @step2 $upper_edge index 0 using (@half_x + 8):(@half_y + gap + 14):(math("w")." = ".w_text) \
        with labels left tc rgb ink title "w, label", \
    @step2 $right_edge index 0 using (@point_x + gap):(@point_y):@moved with @dimension lc rgb ink title "h", \
    @step2 $right_edge index 0 using (left_at(@half_x + gap + 10, long("h = ".h_text, text_size))):(@half_y):(math("h")." = ".h_text) \
        with labels left tc rgb ink title "h, label", \
    @step4 @who $to_corners index who using @vector with @leg lc rgb blue dt dash(who) title "to the corners", \
    $right_arrow using @vector with @arrow lc rgb orange title "r", \
    $up_arrow using @vector with @arrow lc rgb green title "u", \
    $forward_arrow using @vector with @arrow lc rgb pink title "f", \
    $right_arrow using @beyond:(math("r")) with labels tc rgb orange title "r, label", \
    $up_arrow using @beyond:(math("u")) with labels tc rgb green title "u, label", \
    $forward_arrow using (@tip_x + 3):(@tip_y + 30):(math("f")) with labels tc rgb pink title "f, label", \
    $eye using @point with @dot lc rgb blue title "eye", \
    $eye using (@point_x - 14):(@point_y - 10):(math("p")) with labels tc rgb blue title "p"
