# yours-and-right.gp - a vector that ends where it should, and one that does not, dashed beside it.
#
# The judge also uses this layout to draw wrong answers of chapters 01 and 04.
title = asked.": yours beside the right one"
description = sprintf("The image plane, and two vectors to it from %s. ", eye_text).beside_words(0)
steps = 3
room = "0.10 0.95 0.05 0.90"
@see
@beside
# A wrong answer of the user takes the place of the example.
example = "for [_=wrong:0]"
if (exists("your_answer_text")) { set label 93 your_answer_text; set label 94 ""; set label 95 "" }

plot $plane using @point with filledcurves closed fc rgb surface fs solid noborder title "surface", \
    $grid using @point with @hair lc rgb faint title "grid", \
    $plane using @point with @lines lc rgb ink title "plane", \
    @step3 @example $off using @vector with vectors head filled size 9,18,90 lw 1.2 lc rgb ink title "off by", \
    @who $answer index who using @vector with @arrow lc rgb (who == 0 ? blue : orange) dt dash(who) title "right", \
    @step2 @example $yours using @vector with @arrow lc rgb orange dt 2 title "yours", \
    $eye using @point with @dot lc rgb ink title "eye", \
    $eye using @point:(math("p")) with labels offset -1.5,-0.7 tc rgb ink title "p"
