# screen-to-unit.gp - a point on the screen, and the same point in the unit square (slide
# 'Normalized screen coordinates').
title = own("A point on the screen, normalized")
s_is = sprintf("%s/%s", point_x_text, screen_W_text)
t_is = "1 − ".sprintf(point_y < 0 ? "(%s)/%s" : "%s/%s", point_y_text, screen_H_text)
description = sprintf(own("On the left is a screen of %s by %s pixels. Its origin is at the upper left; x counts to the \
right, y counts down. It shows the point %s. On the right is the unit square. Its origin is at the lower left; \
s counts to the right, t counts up. There, the same point is at s = %s, t = %s: %s."), \
    screen_W_text, screen_H_text, point_text, s_is, t_is, place_text)
steps = 5

# Panel 1 is the screen, with y down; panel 2 is the unit square.

plot $screen_outline using @flat1 with filledcurves closed fc rgb surface fs solid noborder title "screen, surface", \
    $screen_outline using @flat1 with @lines lc rgb ink title "screen", \
    $x_axis using @along1 with @orange_thin_arrow title "x axis", \
    $y_axis using @along1 with @green_thin_arrow title "y axis", \
    $screen_origin using @flat1 with points pt 5 ps 0.5 lc rgb ink title "origin of the screen", \
    $x using @along1 with @orange_stroke title "x of the point", \
    $y using @along1 with @stroke lc rgb green title "y of the point", \
    $point using (U(1,$1)):(V(1,-$2)) with @dot lc rgb blue title "point", \
    @step2 $square using @flat2 with filledcurves closed fc rgb surface fs solid noborder title "square, surface", \
    @step2 $square using @flat2 with @lines lc rgb ink title "square", \
    @step2 $s_axis using @along2 with @orange_thin_arrow title "s axis", \
    @step2 $t_axis using @along2 with @green_thin_arrow title "t axis", \
    @step2 $square_origin using @flat2 with points pt 5 ps 0.5 lc rgb ink title "origin of the square", \
    @step3 $once using (0.535*width-70):(0.43*height):(140):(0) with @arrow lc rgb ink title "mapping", \
    @step4 @who $place index who using (U(2,0)):(V(2,$2)):(size[2]*$1):(0) with @orange_stroke dt dash(who) title "s of the point", \
    @step4 $place index 0 using (U(2,$1)):(V(2,1)):(0):(size[2]*($2-1)) with vectors nohead lw 0.8 lc rgb green title "from the top", \
    @step4 @who $place index who using (U(2,$1)):(V(2,0)):(0):(size[2]*$2) with @stroke lc rgb green dt dash(who) title "t of the point", \
    @step4 @who $place index who using (U(2,$1)):(V(2,$2)) with points pt mark(who) ps 0.55 lw 1+who lc rgb blue title "place", \
    @labels
