# rectangle.gp - the rectangle of a sphere on the screen, and another one dashed beside it.
#
# The screen is drawn as it is: y counts down.
title = asked.": yours beside the right one"
description = "The screen with the outline of the sphere. ".beside_words(0)
steps = 2

plot $frame using @flat1 with filledcurves closed fc rgb surface fs solid border lc rgb ink lw 1.2 title "screen", \
    $outline using @flat1 with lines lc rgb grey lw 1.6 title "outline", \
    $answer using @flat1 with @thick lc rgb blue title "right", \
    @step2 $yours using @flat1 with @thick lc rgb ink dt 2 title "yours", \
    @step2 $yours every ::::0 using (is_tiny ? U(1,$1) : NaN):(V(1,$2)) with points pt 1 ps 0.7 lc rgb ink title "yours, tiny", \
    @labels
