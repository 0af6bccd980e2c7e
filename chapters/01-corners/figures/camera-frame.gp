# camera-frame.gp - the camera <p, r, u, f, d, w, h> (slide 'Camera').
title = own("A camera: a frame, a distance, a width, a height")
description = sprintf(own("The eye p is at %s. Three arrows at right angles start there: right r is %s, up u is %s, \
forward f is %s. The image plane is straight ahead, at the distance d = %s. It is a grid of 8 by 8 pixels, w = %s \
wide and h = %s high. Lines go from the eye to its corners. The arrows x, y, z show the world's axes%s."), \
    eye_text, right_text, up_text, forward_text, d_text, w_text, h_text, \
    origin_is_far ? own(", here below the camera, because their origin is too far away") : "")
steps = 4

# How far dimensions are from the edges.
gap = 14
plot $x_axis using @vector with @axis lc rgb grey title "x axis", \
    $y_axis using @vector with @axis lc rgb grey title "y axis", \
    $z_axis using @vector with @axis lc rgb grey title "z axis", \
    @step2 $plane index 0 using @point with filledcurves closed fc rgb surface fs @glass noborder title "surface", \
    @step3 $grid index 0 using @point with @hair lc rgb grey title "grid", \
    @step2 @who $plane index who using @point with @thick lc rgb ink dt dash(who) title "plane", \
    @step2 @who $ahead index who using @vector with @pink_segment dt dash(who) title "ahead", \
    @step2 $ahead index 0 using @tip with @dot lc rgb pink title "middle", \
    @step2 $upper_edge index 0 using (@point_x):(@point_y + gap):@moved with @orange_dimension title "upper edge", \
    @step2 $right_edge index 0 using (@point_x + gap):(@point_y):@moved with @green_dimension title "right edge", \
    @step4 @who $to_corners index who using @vector with @segment lc rgb blue dt dash(who) title "to the corners", \
    $right_arrow using @vector with @orange_arrow title "right arrow", \
    $up_arrow using @vector with @green_arrow title "up arrow", \
    $forward_arrow using @vector with @pink_arrow title "forward arrow", \
    $eye using @point with @dot lc rgb blue title "eye", \
    @labels
