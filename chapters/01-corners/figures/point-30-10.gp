# point-30-10.gp - a point on the image plane, named by two fractions (slide 'Finding vectors').
title = sprintf("%s %% across the image plane and %s %% up", percent_across_text, percent_up_text)
formula = "d f + (s − ½) w r + (t − ½) h u"
description = sprintf("The image plane has lines at every tenth of its width and height. A point is %s %% of the \
way across from the left edge, s = %s, and %s %% of the way up from the bottom edge, t = %s. Three arrows lead to it \
from the eye p: d f forward to the middle, (s − ½) w r sideways, (t − ½) h u up or down. Their sum \
%s = %s is the vector from the eye to the point. Here d is %s, w is %s, h is %s.", \
    percent_across_text, s_text, percent_up_text, t_text, formula, vector_text, d_text, w_text, h_text)
steps = 3
room = sprintf("0.08 %g 0.12 0.80", 1 - 100.0 / width)
if (!turned) azimuth = 42
@see

# The labels of the legs are on the side where there is room.
gap = 14
aside_is = "(s − ½) w r"
up_is = "(t − ½) h u"
long_leg = long(up_is, text_size)
aside_of(x) = middle_at(x + (s > 0.5 ? -long_leg : long_leg) / 2, long_leg)
below = t < 0.5 ? 1 : -1
across_is = percent_across_text." %"
upward_is = percent_up_text." %"
if (step >= 3) set label 1 math(formula)."  = ".vector_text at 24, height - 60 left tc rgb blue
set label 2 sprintf("%s = %s,   %s = %s", math("s"), s_text, math("t"), t_text) at 24, height - 34 left tc rgb ink
if (step >= 3 && exists("your_vector_text")) set label 3 "yours: ".your_vector_text at 24, height - 86 left tc rgb blue
plot $plane index 0 using @point with filledcurves closed fc rgb surface fs solid noborder title "surface", \
    $grid index 0 using @point with lines lw 0.4 lc rgb grey title "grid", \
    @who $plane index who using @point with @lines lc rgb ink dt dash(who) title "plane", \
    $column index 0 using @vector with @leg lc rgb green title "column", \
    $row index 0 using @vector with @leg lc rgb orange title "row", \
    $column index 0 using @tip with @dot lc rgb ink title "place", \
    $across index 0 using (@point_x):(@point_y - gap):@moved with @dimension lc rgb orange title "across", \
    $across index 0 using (middle_at(@half_x, long(across_is, text_size))):(@half_y - gap - 14):(percent_across_text." ".percent) \
        with labels tc rgb orange title "across, label", \
    $upward index 0 using (@point_x + gap):(@point_y):@moved with @dimension lc rgb green title "up", \
    $upward index 0 using (left_at(@half_x + gap + 8, long(upward_is, text_size))):(@half_y):(percent_up_text." ".percent) \
        with labels left tc rgb green title "up, label", \
    @step2 @who $ahead index who using @vector with @arrow lc rgb pink dt dash(who) title "ahead", \
    @step2 $ahead index 0 using (@half_x):(@half_y + 18 * below):(math("d f")) with labels tc rgb pink title "d f", \
    @step2 @who $aside index who using @vector with @arrow lc rgb orange dt dash(who) title "aside", \
    @step2 @who $up_or_down index who using @vector with @arrow lc rgb green dt dash(who) title "up or down", \
    @step2 $aside index 0 using (middle_at(@half_x, long_leg)):(@half_y + 22 * below):(math(aside_is)) \
        with labels tc rgb orange title "aside, label", \
    @step2 $up_or_down index 0 using (aside_of(@point_x)):(@point_y + 0.4 * scale * seen_y($4,$5,$6)):(math(up_is)) \
        with labels tc rgb green title "up or down, label", \
    @step3 @who $vector index who using @vector with @arrow lc rgb blue dt dash(who) title "vector", \
    @step3 $vector index 0 using @tip with @dot lc rgb blue title "point", \
    $eye using @point with @dot lc rgb blue title "eye", \
    $eye using (@point_x - 14):(@point_y - 10):(math("p")) with labels tc rgb blue title "p"
