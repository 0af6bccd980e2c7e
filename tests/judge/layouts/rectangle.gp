# rectangle.gp - the rectangle of a sphere on the screen, and another one dashed beside it.
#
# The screen is drawn as it is: y counts down.
title = asked.": yours beside the right one"
description = "The screen with the outline of the sphere. ".beside_words(0)
steps = 2
beside_room = width / 8
@beside
panel = 1; room = "0.2 0.8 0.1 0.68"
@flat
on = "(U(1,$1)):(V(1,$2))"

plot $frame using @on with filledcurves closed fc rgb surface fs solid border lc rgb ink lw 1.2 title "screen", \
    $frame every ::0::0 using @on:(origin_text) with labels left offset 0,0.8 tc rgb grey title "origin", \
    $frame every ::2::2 using @on:(corner_text) with labels right offset 0,-0.8 tc rgb grey title "corner", \
    $outline using @on with lines lc rgb grey lw 1.6 title "outline", \
    $answer using @on with lines lc rgb blue lw 2.2 title "right", \
    @step2 $yours using @on with lines lc rgb orange lw 2.2 dt 2 title "yours"
