# look-at.gp - how a look-at becomes a frame: f, the up that was given, r at right angles to both, and u, which leans back;
# and the right triangle of half the angle.
title = own("From a look-at to a frame")
description = sprintf(own("f goes from the eye %s to the look-at point. The up that is given, %s, need not be at right angles to it. r = %s is \
at right angles to both, and u = %s is at right angles to r and f, in the plane of f and up. Beside it, from above: the eye and the image \
plane at the distance %s. Half the width, %s, is opposite to half the angle, %s degrees."), \
    eye_text, lean_text, r_text, u_text, distance_text, half_text, half_degrees_text)
steps = 5


plot @step2 $sheet using @point with filledcurves closed fc rgb surface fs solid noborder title "plane of f and up", \
    $view using @vector with @segment dt 2 lc rgb grey title "view", \
    @step2 $given_up using @vector with @arrow lc rgb ink title "up", \
    @who $f index who using @vector with @pink_arrow dt dash(who) title "f", \
    @step3 @who $r index who using @vector with @orange_arrow dt dash(who) title "r", \
    @step4 @who $u index who using @vector with @green_arrow dt dash(who) title "u", \
    $eye using @point with @dot lc rgb blue title "eye", \
    @step5 $other_slope using @along2 with @segment lc rgb grey title "other edge", \
    @step5 $other_half using @along2 with @segment lc rgb grey title "other half", \
    @step5 @who $slope index who using @along2 with @stroke lc rgb ink dt dash(who) title "edge", \
    @step5 $ahead using @along2 with @pink_stroke title "d", \
    @step5 @who $half_width index who using @along2 with @orange_stroke dt dash(who) title "half the width", \
    @step5 $corner using @flat2 with @dot lc rgb blue title "eye from above", \
    @labels
