# self-hit.gp - why a ray must not start on the surface that it leaves, and the remedy.
title = "A surface that hits itself"
description = "A ray from the eye hits a sphere. Left: because of rounding, the computed point is a little inside the \
sphere; here that is drawn far too large. From there, the ray to the light hits the sphere itself from inside, so the point \
is in its own shadow. A picture made so has dark specks. Right: the ray starts a little outside, along the normal n, and \
reaches the light. The same picture has no specks.".(exists("$your_smooth") ? " Yours is shown in its place." : "")
steps = 4
panel = 1
# The pictures are below the drawings, at the edges of the canvas, with words beside them.
cast = 1
picture = "$specks"
@decode
cast = 2
picture = exists("$your_smooth") ? "$your_smooth" : "$smooth"
@decode
wide = shape eq "4:3" ? 132 : 150
pixel = 1.0 * wide / side
left(number) = number == 1 ? 14 : width - 14 - wide
at_the_edge = 'cast_file(number) binary filetype=png origin=(left(number)+pixel/2,14+pixel/2) dx=pixel dy=pixel with rgbimage'
if (framed) at_the_edge = '$square using (left(number)+wide*$1):(14+wide*$2) with lines lc rgb ink'
line_left(k) = sprintf("(%g):(%g)", 14 + wide + 16, 14 + wide / 2.0 + 32 * k)
line_right(k) = sprintf("(%g):(%g)", width - 14 - wide - 16, 14 + wide / 2.0 + 32 * k)
upper_left = line_left(1)
middle_left = line_left(0)
lower_left = line_left(-1)
upper_right = line_right(1)
middle_right = line_right(0)
lower_right = line_right(-1)
place = "(U(panel,$1)):(V(panel,$2))"
way = "(U(panel,$1)):(V(panel,$2)):(size[panel]*$4):(size[panel]*$5)"
right = "for [_=4:step:1000] for [panel=2:2]"
spot = "points pt 3 ps 1.2 lw 2.4"
missed = "points pt 2 ps 1.1 lw 3.4"

plot $cap_1 using @place with filledcurves closed fc rgb surface fs solid noborder title "sphere", \
    $cap_1 using @place with @thick lc rgb ink title "surface", \
    $seen_1 using @way with @arrow lc rgb grey title "seen", \
    $wanted using @way with vectors nohead lw 1.6 dt 3 lc rgb grey title "to the light, wanted", \
    $light_1 using @place with @spot lc rgb ink title "light", \
    $point using @place with @dot lc rgb grey title "point", \
    @step3 $to_itself using @way with vectors nohead lw 3 lc rgb blue title "from the point", \
    @step2 $inside using @place with points pt 7 ps 0.7 lc rgb ink title "rounded", \
    @step3 $own_hit using @place with @missed lc rgb ink title "self hit", \
    for [_=3:step:1000] for [number=1:1] @at_the_edge title cast_title(1, "specks"), \
    @step3 $once using @upper_left:("starts inside,") with labels left tc rgb ink title "words 1", \
    @step3 $once using @middle_left:("hits itself:") with labels left tc rgb ink title "words 2", \
    @step3 $once using @lower_left:("dark specks") with labels left tc rgb ink title "words 3", \
    @right $cap_2 using @place with filledcurves closed fc rgb surface fs solid noborder \
        title "sphere, right", \
    @right $cap_2 using @place with @thick lc rgb ink title "surface, right", \
    @right $seen_2 using @way with @arrow lc rgb grey title "seen, right", \
    @right $light_2 using @place with @spot lc rgb ink title "light, right", \
    @right $normal using @way with @arrow lc rgb green title "normal", \
    @right $to_light using @way with @arrow lc rgb blue title "from the start", \
    @right $outside using @place with points pt 7 ps 0.7 lc rgb blue title "start", \
    for [_=4:step:1000] for [number=2:2] @at_the_edge title cast_title(2, "smooth"), \
    @step4 $once using @upper_right:("starts outside,") with labels right tc rgb ink title "words 4", \
    @step4 $once using @middle_right:("reaches the light:") with labels right tc rgb ink title "words 5", \
    @step4 $once using @lower_right:(exists("$your_smooth") ? "yours" : "no specks") with labels right tc rgb ink title "words 6", \
    @labels
@forget
