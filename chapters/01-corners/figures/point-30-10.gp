# point-30-10.gp - a point on the image plane, named by two fractions (slide 'Finding vectors').
title = sprintf(own("%s %% across, %s %% up"), percent_across_text, percent_up_text)
description = sprintf(own("The image plane has lines at every tenth of its width and height. A point is %s %% of the \
way across from the left edge, s = %s, and %s %% of the way up from the bottom edge, t = %s. Three arrows lead to it \
from the eye p: d f forward to the middle, (s − ½) w r sideways, (t − ½) h u up or down. Their sum \
%s = %s is the vector from the eye to the point. Here d is %s, w is %s, h is %s."), \
    percent_across_text, s_text, percent_up_text, t_text, "d f + (s − ½) w r + (t − ½) h u", vector_text, d_text, w_text, h_text)
steps = 3

# How far dimensions are from the edges.
gap = 14
plot $plane index 0 using @point with filledcurves closed fc rgb surface fs solid noborder title "surface", \
    $grid index 0 using @point with lines lw 0.4 lc rgb grey title "grid", \
    @who $plane index who using @point with @lines lc rgb ink dt dash(who) title "plane", \
    $column index 0 using @vector with @segment lc rgb green title "column", \
    $row index 0 using @vector with @orange_segment title "row", \
    $column index 0 using @tip with @dot lc rgb ink title "place", \
    $across index 0 using (@point_x):(@point_y - gap):@moved with @orange_dimension title "across", \
    $upward index 0 using (@point_x + gap):(@point_y):@moved with @green_dimension title "upward", \
    @step2 @who $ahead index who using @vector with @pink_arrow dt dash(who) title "ahead", \
    @step2 @who $aside index who using @vector with @orange_arrow dt dash(who) title "aside", \
    @step2 @who $up_or_down index who using @vector with @green_arrow dt dash(who) title "up or down", \
    @step3 @who $vector index who using @vector with @arrow lc rgb blue dt dash(who) title "vector", \
    @step3 $vector index 0 using @tip with @dot lc rgb blue title "point", \
    $eye using @point with @dot lc rgb blue title "eye", \
    @labels
