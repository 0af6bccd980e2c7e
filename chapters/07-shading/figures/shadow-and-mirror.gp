# shadow-and-mirror.gp - the two rays that leave a point: to the light, and the mirrored one.
title = own("Two rays from one point")
description = own("Three spheres, an eye and a light. The eye's ray meets a sphere at a point with the normal n.")." ".(visibility > 0 ? \
    own("The shadow ray from there reaches the light: visibility 1.")." " : own("The shadow ray from there meets another sphere before the light: no light arrives, visibility 0.")." ").\
    (mirrored_t < 1e300 ? own("The mirrored ray leaves on the other side of n and meets another sphere, whose color the mirror shows.") : \
    own("The mirrored ray leaves on the other side of n and meets no sphere: the mirror shows the background."))
steps = 3

spot = "points pt 3 ps 0.7 lw 2"

plot for [i=0:2] "$ball".i using @flat1 with filledcurves closed fc rgb surface fs solid noborder title "sphere", \
    for [i=0:2] "$ball".i using @flat1 with @lines lc rgb ink title "outline", \
    @who $seen index who using @along1 with @thin_arrow lc rgb grey dt dash(who) title "seen", \
    @who $n index who using @along1 with @green_arrow dt dash(who) title "n", \
    @step2 $to_light index wrong using @along1 with @segment dt 3 lc rgb grey title "to the light", \
    @step2 @who $lit index who using @along1 with @orange_arrow dt dash(who) title "shadow ray", \
    @step3 @who $mirrored index who using @along1 with @arrow lc rgb blue dt dash(who) title "mirrored ray", \
    $point index 0 using @flat1 with @dot lc rgb ink title "point", \
    $eye using @flat1 with @dot lc rgb blue title "eye", \
    $lamp using @flat1 with @spot lc rgb orange title "light", \
    @labels
