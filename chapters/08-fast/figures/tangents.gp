# tangents.gp - the sphere from above: two lines through the eye touch its circle, and meet the image plane at the left
# and the right edge of its rectangle.
title = own("Which part of the screen?")
description = sprintf(own("From above: the eye at the left, the image plane in front of it, and the circle of a sphere of radius %s, whose center C \
is z = %s ahead of the eye and x = %s to the right.")." ", r_text, z_text, x_text).(nothing ? own("It is behind the eye or beside the screen.") : \
    sprintf(own("Two lines through the eye touch the circle. On a screen of %s columns they meet the image plane at %s and %s: the \
left and the right edge of the sphere's rectangle."), columns_text, left_text, right_text))
steps = 4


plot $circle using @flat1 with filledcurves closed fc rgb surface fs solid noborder title "disc", \
    $circle using @flat1 with @lines lc rgb ink title "circle", \
    $plane using @along1 with @stroke lc rgb ink title "image plane", \
    @step2 $ahead using @along1 with @dimension lc rgb grey title "z", \
    @step2 $aside using @along1 with @dimension lc rgb grey title "x", \
    @step2 $radius using @along1 with @thin_arrow lc rgb ink title "r", \
    for [_=1:step >= 3 && !nothing] @who $left_line index who using @along1 with @orange_stroke dt dash(who) title "left line", \
    for [_=1:step >= 3 && !nothing] @who $right_line index who using @along1 with @stroke lc rgb green dt dash(who) title "right line", \
    for [_=1:step >= 3 && !nothing] $left_radius index 0 using @along1 with @segment dt 2 lc rgb grey title "to the left line", \
    for [_=1:step >= 3 && !nothing] $right_radius index 0 using @along1 with @segment dt 2 lc rgb grey title "to the right line", \
    for [_=1:step >= 4 && !nothing] @who $left_mark index who using @flat1 with points pt mark(who) ps 0.55 lc rgb orange title "left", \
    for [_=1:step >= 4 && !nothing] @who $right_mark index who using @flat1 with points pt mark(who) ps 0.55 lc rgb green title "right", \
    $eye using @flat1 with @dot lc rgb blue title "eye", \
    $center using @flat1 with @dot lc rgb ink title "C", \
    @labels
