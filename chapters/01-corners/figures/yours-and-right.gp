# yours-and-right.gp - a vector that ends where it should, and one that does not, dashed beside it.
#
# The judge also uses this layout to draw wrong answers of chapters 01 and 04.
title = asked.own(": yours beside the right one")
description = sprintf(own("The image plane, and two vectors to it from %s.")." ", eye_text).beside_words(0)
steps = 3
# A wrong answer of the user takes the place of the example.
example = "for [_=wrong:0]"

plot $plane using @point with filledcurves closed fc rgb surface fs solid noborder title "surface", \
    $grid using @point with @hair lc rgb grey title "grid", \
    $plane using @point with @lines lc rgb ink title "plane", \
    @step3 @example $off using @vector with @thin_arrow lc rgb grey title "off by", \
    @who $answer index who using @vector with @arrow lc rgb (who == 0 ? blue : ink) dt dash(who) title "right", \
    @step2 @example $yours using @vector with @arrow lc rgb ink dt 2 title "yours", \
    $eye using @point with @dot lc rgb blue title "eye", \
    @labels
