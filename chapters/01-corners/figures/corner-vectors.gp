# corner-vectors.gp - the two upper corners, each a sum of three legs (slide 'Finding vectors').
title = "From the eye to the upper corners"
description = sprintf("The vector from the eye p to the upper left corner of the image plane is \
d f − (w/2) r + (h/2) u = %s. The vector to the upper right corner is d f + (w/2) r + (h/2) u = %s. Each is the sum \
of three arrows: d f forward to the middle, half the width sideways to an edge, half the height up. \
Here d is %s, w is %s, h is %s.", \
    upper_left_text, upper_right_text, d_text, w_text, h_text)
steps = 5
left = "d f − (w/2) r + (h/2) u"
right = "d f + (w/2) r + (h/2) u"
left_is = "= ".upper_left_text
right_is = "= ".upper_right_text
# Room for the text beside the plane.
room = sprintf("0.08 %g 0.06 0.86", 1 - (long(right, text_size) + 20) / width)
if (!turned) azimuth = 34
@see

plot $plane index 0 using @point with filledcurves closed fc rgb surface fs solid noborder title "surface", \
    $grid index 0 using @point with @hair lc rgb faint title "grid", \
    @who $plane index who using @point with @lines lc rgb ink dt dash(who) title "plane", \
    @who $ahead index who using @vector with @arrow lc rgb pink dt dash(who) title "ahead", \
    $ahead index 0 using (@half_x):(@half_y - 18):(math("d f")) with labels tc rgb pink title "d f", \
    @step2 @who $aside_left index who using @vector with @arrow lc rgb orange dt dash(who) title "aside left", \
    @step2 $ahead index 0 using (@tip_x - 10):(@tip_y + 27):(math("−(w/2) r")) \
        with labels tc rgb orange title "aside left, label", \
    @step2 @who $up_left index who using @vector with @arrow lc rgb green dt dash(who) title "up left", \
    @step2 $up_left index 0 using (right_at(@half_x - 8, long("+(h/2) u", text_size))):(@half_y - 12):(math("+(h/2) u")) with labels right tc rgb green title "up left, label", \
    @step3 @who $upper_left index who using @vector with @arrow lc rgb blue dt dash(who) title "upper left", \
    @step3 $upper_left index 0 using (right_at(@tip_x, long(left, text_size))):(@tip_y + 40):(math(left)) \
        with labels right tc rgb blue title "upper left, label", \
    @step3 $upper_left index 0 using (right_at(@tip_x, long(left_is, text_size))):(@tip_y + 18):(left_is) \
        with labels right tc rgb blue title "upper left, numbers", \
    @step4 @who $aside_right index who using @vector with @arrow lc rgb orange dt dash(who) title "aside right", \
    @step4 $aside_right index 0 using (@tip_x + 10):(@tip_y - 8):(math("+(w/2) r")) \
        with labels left tc rgb orange title "aside right, label", \
    @step4 @who $up_right index who using @vector with @arrow lc rgb green dt dash(who) title "up right", \
    @step4 $up_right index 0 using (@half_x + 10):(@half_y):(math("+(h/2) u")) with labels left tc rgb green title "up right, label", \
    @step5 @who $upper_right index who using @vector with @arrow lc rgb blue dt dash(who) title "upper right", \
    @step5 $upper_right index 0 using (@tip_x + 10):(@tip_y + 24):(math(right)) \
        with labels left tc rgb blue title "upper right, label", \
    @step5 $upper_right index 0 using (left_at(@tip_x + 10, long(right_is, text_size))):(@tip_y + 2):(right_is) \
        with labels left tc rgb blue title "upper right, numbers", \
    $eye using @point with @dot lc rgb blue title "eye", \
    $eye using (@point_x - 14):(@point_y - 10):(math("p")) with labels tc rgb blue title "p"
