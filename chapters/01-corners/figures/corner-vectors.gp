# corner-vectors.gp - the two upper corners, each a sum of three steps (slide 'Finding vectors').
title = own("From the eye to the upper corners")
description = sprintf(own("The vector from the eye p to the upper left corner of the image plane is \
d f − (w/2) r + (h/2) u = %s. The vector to the upper right corner is d f + (w/2) r + (h/2) u = %s. Each is the sum \
of three arrows: d f forward to the middle, half the width sideways to an edge, half the height up. \
Here d is %s, w is %s, h is %s."), \
    upper_left_text, upper_right_text, d_text, w_text, h_text)
steps = 5

plot $plane index 0 using @point with filledcurves closed fc rgb surface fs solid noborder title "surface", \
    $grid index 0 using @point with @hair lc rgb grey title "grid", \
    @who $plane index who using @point with @lines lc rgb ink dt dash(who) title "plane", \
    @who $ahead index who using @vector with @pink_arrow dt dash(who) title "ahead", \
    @step2 @who $aside_left index who using @vector with @orange_arrow dt dash(who) title "aside left", \
    @step2 @who $up_left index who using @vector with @green_arrow dt dash(who) title "up left", \
    @step3 @who $upper_left index who using @vector with @arrow lc rgb blue dt dash(who) title "upper left", \
    @step4 @who $aside_right index who using @vector with @orange_arrow dt dash(who) title "aside right", \
    @step4 @who $up_right index who using @vector with @green_arrow dt dash(who) title "up right", \
    @step5 @who $upper_right index who using @vector with @arrow lc rgb blue dt dash(who) title "upper right", \
    $eye using @point with @dot lc rgb blue title "eye", \
    @labels
