# surface-vectors.gp - the vectors at a point of a sphere, and the angles of the three terms.
title = own("The vectors at a point")
description = sprintf(own("A point of a sphere with five vectors, each 1 long: the normal n; l to the light; m, the mirrored direction, on the other \
side of n; e to the eye; and h, halfway between l and e. Three angles: θ between n and l, with the cosine %s, for diffuse light; α between m \
and e, with the cosine %s, for Phong's highlight; β between n and h, with the cosine %s, for the halfway variant."), \
    diffuse_text, phong_text, halfway_text)
steps = 4


plot $surface using @flat1 with filledcurves closed fc rgb surface fs solid noborder title "sphere", \
    $surface using @flat1 with @thick lc rgb ink title "surface", \
    @who $n index who using @along1 with @green_arrow dt dash(who) title "n", \
    @step2 @who $theta index who using @flat1 with @orange_lines dt dash(who) title "theta", \
    @step2 @who $l index who using @along1 with @orange_arrow dt dash(who) title "l", \
    @step3 @who $alpha index who using @flat1 with @lines lc rgb blue dt dash(who) title "alpha", \
    @step3 @who $m index who using @along1 with @orange_arrow dt dash(who) title "m", \
    @step3 @who $e index who using @along1 with @arrow lc rgb blue dt dash(who) title "e", \
    @step4 @who $beta index who using @flat1 with @pink_lines dt dash(who) title "beta", \
    @step4 @who $h index who using @along1 with @pink_arrow dt dash(who) title "h", \
    $point using @flat1 with @dot lc rgb ink title "point", \
    @labels
