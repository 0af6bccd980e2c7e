# ray.gp - a ray as the center of a sphere sees it, and another one dashed beside it.
title = asked.": yours beside the right one"
description = sprintf("A sphere of radius %s around the origin, and two rays. ", radius_text).beside_words(0)
steps = 2

plot $center using @point:(size[1]*radius) with circles fc rgb surface fs solid border lc rgb ink lw 1.2 title "sphere", \
    $center using @point with @dot lc rgb ink title "center", \
    @step2 $off using @vector with @thin_arrow lc rgb grey title "off by", \
    $answer using @vector with @arrow lc rgb blue title "right", \
    $answer using @point with @dot lc rgb blue title "right, start", \
    @step2 $yours using @vector with @arrow lc rgb ink dt 2 title "yours", \
    @step2 $yours using @point with @ring lc rgb ink title "yours, start", \
    @labels
