# place.gp - a place of the screen or the unit square: the argument on the left, the result and yours on the right.
#
# The screen is drawn as it is: y counts down.
title = asked.": yours beside the right one"
description = (has_given ? sprintf("On the left is the place %s, the argument; on the right is the result. ", given_text) : \
    "In a pixel: ").beside_words(0)
steps = 2
frame = "filledcurves closed fc rgb surface fs solid border lc rgb ink lw 1.2"

plot $into using @flat1 with @frame title "into", \
    $from using @flat2 with @frame title "from", \
    $once using (width * 0.47):(has_given ? height * 0.45 : 1e9):(width * 0.06):(0) with @arrow lc rgb ink title "becomes", \
    $given using @flat2 with @dot lc rgb ink title "given", \
    $right using @flat1 with @dot lc rgb blue title "right", \
    @step2 $yours using @flat1 with @ring lc rgb ink title "yours", \
    @labels
