# place.gp - a place of the screen or the unit square: what went in, what is right, and yours.
#
# The screen is drawn as it is: y counts down.
title = asked.": yours beside the right one"
description = (has_given ? sprintf("On the left the place %s that went in; on the right ", given_text) : "In a pixel, ").\
    "what came out. ".beside_words(0)
steps = 2
beside_room = width / 8
@beside
panel = 1; room = "0.08 0.42 0.12 0.66"
low_x = from_low_x; high_x = from_high_x; low_y = from_low_y; high_y = from_high_y
@flat
panel = 2; room = has_given ? "0.58 0.92 0.12 0.66" : "0.25 0.75 0.12 0.66"
low_x = into_low_x; high_x = into_high_x; low_y = into_low_y; high_y = into_high_y
@flat
down(y, is_down) = is_down ? -y : y
from = "(U(1,$1)):(V(1,down($2,from_down)))"
into = "(U(2,$1)):(V(2,down($2,into_down)))"
given = has_given ? "for [_=0:0]" : "for [_=1:0]"
$here << EOD
0
EOD

plot @given $from_frame using @from with filledcurves closed fc rgb surface fs solid border lc rgb ink lw 1.2 title "from", \
    $into_frame using @into with filledcurves closed fc rgb surface fs solid border lc rgb ink lw 1.2 title "into", \
    @given $from_frame every ::0::0 using @from:(from_origin_text) with labels left offset 0,(from_down ? 0.8 : -0.8) tc rgb grey title "from, origin", \
    @given $from_frame every ::2::2 using @from:(from_corner_text) with labels right offset 0,(from_down ? -0.8 : 0.8) tc rgb grey title "from, corner", \
    $into_frame every ::0::0 using @into:(into_origin_text) with labels left offset 0,(into_down ? 0.8 : -0.8) tc rgb grey title "into, origin", \
    $into_frame every ::2::2 using @into:(into_corner_text) with labels right offset 0,(into_down ? -0.8 : 0.8) tc rgb grey title "into, corner", \
    @given $here using (width * 0.47):(height * 0.4):(width * 0.06):(0) with @arrow lc rgb ink title "becomes", \
    @given $given using @from with @dot lc rgb ink title "given", \
    @given $given using @from:(given_text) with labels offset 0,0.9 tc rgb ink title "given, label", \
    $answer using @into with @dot lc rgb blue title "right", \
    $answer using @into:("right") with labels left offset 0.8,0 tc rgb blue title "right, label", \
    @step2 $yours using @into with @ring lc rgb orange title "yours", \
    @step2 $yours using @into:("yours") with labels right offset -0.8,0 tc rgb orange title "yours, label"
