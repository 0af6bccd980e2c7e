# ray.gp - a ray as the centre of a sphere sees it, and another one dashed beside it.
title = asked.": yours beside the right one"
description = sprintf("A sphere of radius %s round the origin, and two rays. ", radius_text).beside_words(0)
steps = 2
room = "0.08 0.92 0.08 0.70"
azimuth = 16
elevation = 12
beside_room = width / 8
@see
@beside

plot $center using @point:(scale * radius) with circles fc rgb surface fs solid border lc rgb ink lw 1.2 title "sphere", \
    $center using @point with @dot lc rgb ink title "center", \
    $center using @point:(math("c = (0, 0, 0)")) with labels offset 0,-1 tc rgb ink title "c", \
    @step2 $off using @vector with vectors head filled size 9,18,90 lw 1.2 lc rgb ink title "off by", \
    $answer using @vector with @arrow lc rgb blue title "right", \
    $answer using @point with @dot lc rgb blue title "right, start", \
    @step2 $yours using @vector with @arrow lc rgb orange dt 2 title "yours", \
    @step2 $yours using @point with @ring lc rgb orange title "yours, start"
