# beam-and-lobe.gp - why diffuse light has a cosine: a slanted beam is wider on the surface than across; and what the exponent
# of a highlight does.
title = own("Diffuse light, and highlights")
description = (arrives ? sprintf(own("Left: a beam of light is %s wide across. It meets the surface at the angle θ to the normal n, and there it is \
%s wide, so each piece of the surface gets %s of the light: the cosine of θ.")." ", beam_text, spread_text, cosine_text) : \
    own("Left: the light is below the horizon, or so low that hardly any of it arrives.")." ").\
    own("Right: how bright the highlight is for an eye in each direction, drawn as the distance from the point. It is brightest in the mirrored \
direction. With shine 80 the lobe is much narrower than with shine 8.")
steps = 3


plot $ground using @along1 with @stroke lc rgb ink title "surface", \
    $normal using @along1 with @green_arrow title "normal", \
    for [_=1:arrives] $middle using @along1 with @orange_segment dt 3 title "l", \
    for [_=1:arrives] $theta using @flat1 with @lines lc rgb orange title "theta", \
    for [_=1:arrives] @who $beam_edges index who using @along1 with @orange_arrow dt dash(who) title "beam", \
    for [_=1:arrives] $across using @along1 with @dimension lc rgb ink title "across", \
    for [_=1:step >= 2 && arrives] @who $on_surface index who using @along1 with vectors nohead lw 6 lc rgb orange dt dash(who) title "on the surface", \
    @step3 $ground2 using @along2 with @stroke lc rgb ink title "surface, right", \
    @step3 @who $wide_lobe index who using @flat2 with @thick lc rgb blue dt dash(who) title "wide lobe", \
    @step3 @who $narrow_lobe index who using @flat2 with @pink_thick dt dash(who) title "narrow lobe", \
    @step3 $n2 using @along2 with @green_arrow title "n, right", \
    @step3 $l2 using @along2 with @orange_arrow title "l, right", \
    @labels
