# self-hit.gp - why a ray must not start on the surface that it leaves, and the remedy.
title = own("A surface that hits itself")
description = own("A ray from the eye hits a sphere. Left: because of rounding, the computed point is a little inside the \
sphere; here that is drawn far too large. From there, the ray to the light hits the sphere itself from inside, so the point \
is in its own shadow. A picture made so has dark specks. Right: the ray starts a little outside, along the normal n, and \
reaches the light. The same picture has no specks.").(exists("$your_smooth") ? " ".own("Yours is shown in its place.") : "")
steps = 4
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
array said[6] = [own("starts inside,"), own("hits itself:"), own("dark specks"), own("starts outside,"), own("reaches the light:"), \
    exists("$your_smooth") ? own("yours") : own("no specks")]
line(k) = 14 + wide / 2.0 + 32 * (1 - (k - 1) % 3)
spot = "points pt 3 ps 1.2 lw 2.4"
missed = "points pt 2 ps 1.1 lw 3.4"

plot $cap_1 using @flat1 with filledcurves closed fc rgb surface fs solid noborder title "sphere", \
    $cap_1 using @flat1 with @thick lc rgb ink title "surface", \
    $seen_1 using @along1 with @thin_arrow lc rgb grey title "seen", \
    $wanted using @along1 with vectors nohead lw 1.6 dt 3 lc rgb grey title "to the light, wanted", \
    $light_1 using @flat1 with @spot lc rgb ink title "light", \
    $point using @flat1 with @dot lc rgb grey title "point", \
    @step3 $to_itself using @along1 with vectors nohead lw 3 lc rgb blue title "from the point", \
    @step2 $inside using @flat1 with points pt 7 ps 0.7 lc rgb ink title "rounded", \
    @step3 $own_hit using @flat1 with @missed lc rgb ink title "self hit", \
    @step3 for [number=1:1] @at_the_edge title cast_title(1, "specks"), \
    @step3 for [k=1:3] $once using (30+wide):(line(k)):(said[k]) with labels left tc rgb ink title sprintf("words %d", k), \
    @step4 $cap_2 using @flat2 with filledcurves closed fc rgb surface fs solid noborder title "sphere, right", \
    @step4 $cap_2 using @flat2 with @thick lc rgb ink title "surface, right", \
    @step4 $seen_2 using @along2 with @thin_arrow lc rgb grey title "seen, right", \
    @step4 $light_2 using @flat2 with @spot lc rgb ink title "light, right", \
    @step4 $normal using @along2 with @green_arrow title "normal", \
    @step4 $to_light using @along2 with @arrow lc rgb blue title "from the start", \
    @step4 $outside using @flat2 with points pt 7 ps 0.7 lc rgb blue title "start", \
    @step4 for [number=2:2] @at_the_edge title cast_title(2, "smooth"), \
    @step4 for [k=4:6] $once using (width-30-wide):(line(k)):(said[k]) with labels right tc rgb ink title sprintf("words %d", k), \
    @labels
@forget
