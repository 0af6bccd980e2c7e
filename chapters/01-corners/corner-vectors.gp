# corner-vectors.gp - the two upper corners, each a sum of three legs (slide 'Finding vectors').
title = "From the eye to the upper corners"
description = sprintf("From the eye, the upper left corner of the image plane is at %s, the upper right \
one at %s. Here d is %s, w %s, h %s.", \
    upper_left_text, upper_right_text, d_text, w_text, h_text)
steps = 5
room = "0.08 0.70 0.08 0.84"
@see

plot $plane using @point with filledcurves closed fc rgb surface fs solid noborder title "surface", \
    $grid using @point with @hair lc rgb faint title "grid", \
    $plane using @point with @lines lc rgb ink title "plane", \
    $ahead using @vector with @arrow lc rgb pink title "ahead", \
    $ahead using @half_way:(answer("d f")) with labels tc rgb pink offset 2,-1 title "d f", \
    @step2 $aside_left using @vector with @arrow lc rgb orange title "aside left", \
    @step2 $aside_left using @half_way:(answer("−(w/2) r")) with labels tc rgb orange offset 1,1 title "w/2", \
    @step2 $up_left using @vector with @arrow lc rgb green title "up left", \
    @step2 $up_left using @half_way:(answer("+(h/2) u")) with labels right tc rgb green offset -1,0 title "h/2", \
    @step3 @who $upper_left index who using @vector with @arrow lc rgb blue dt dash(who) title "upper left", \
    @step3 $upper_left index 0 using @tip:(equals(answer("d f − (w/2) r + (h/2) u"), upper_left_text)) \
        with labels right tc rgb blue offset 0,1 title "upper left, label", \
    @step4 $aside_right using @vector with @arrow lc rgb orange title "aside right", \
    @step4 $aside_right using @half_way:(answer("+(w/2) r")) with labels tc rgb orange offset 2,1 title "w/2", \
    @step4 $up_right using @vector with @arrow lc rgb green title "up right", \
    @step4 $up_right using @half_way:(answer("+(h/2) u")) with labels left tc rgb green offset 1,0 title "h/2", \
    @step5 @who $upper_right index who using @vector with @arrow lc rgb blue dt dash(who) title "upper right", \
    @step5 $upper_right index 0 using @tip:(equals(answer("d f + (w/2) r + (h/2) u"), upper_right_text)) \
        with labels left tc rgb blue offset 1,1 title "upper right, label", \
    $eye using @point with @dot lc rgb blue title "eye", \
    $eye using @point:(math("p")) with labels tc rgb blue offset -1.5,-0.7 title "p"
