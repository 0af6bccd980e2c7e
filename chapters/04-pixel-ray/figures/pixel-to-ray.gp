# pixel-to-ray.gp - the chain from a pixel to its ray (slide 'Mapping from Pixel to Camera Ray').
title = own("From a pixel to its ray")
description = sprintf(own("The pixel in column %s, row %s of a screen of %s by %s pixels is a square. Its center is the \
point %s on the screen. In the unit square, with s = x/W and t = 1 − y/H, the center is at (s, t) = %s. The vector from \
the eye to that place on the image plane is v = d f + (s − ½) w r + (t − ½) h u = %s. The ray starts at the eye, p = %s, \
and its points are p + t v."), \
    pixel_column_text, pixel_row_text, screen_W_text, screen_H_text, center_text, place_text, vector_text, origin_text)
steps = 5

# Panel 1 is the world; 2 is the pixel under a lens, 3 is the screen, with y down, and 4 is the unit square.
corner = "points pt 5 ps 0.5"
area = "filledcurves closed fc rgb surface fs solid noborder"
here = "filledcurves closed fc rgb blue fs transparent solid 0.35"
to_screen = "vectors nohead lw 0.8 lc rgb grey"
mark_at = "points ps 0.55"
from_lens(up) = sprintf("(U(2,pixel_column+1)):(V(2,%d-pixel_row)):(U(3,pixel_column)-U(2,pixel_column+1)):(V(3,%d-pixel_row)-V(2,%d-pixel_row))", up, up, up)
upper = from_lens(0)
lower = from_lens(-1)

plot $lens using @flat2 with @here noborder title "pixel", \
    $lens using @flat2 with @lines lc rgb blue title "pixel, outline", \
    $display using @flat3 with @area title "screen, surface", \
    $display using @flat3 with @lines lc rgb ink title "screen", \
    $lens using @flat3 with @here border lc rgb blue title "pixel on the screen", \
    $once using @upper with @to_screen title "lens", \
    $once using @lower with @to_screen title "lens", \
    $once using (U(3,0)):(V(3,0)) with @corner lc rgb ink title "origin of the screen", \
    @step2 @who $lens_across index who using @along2 with @orange_stroke dt dash(who) title "half across", \
    @step2 @who $lens_up index who using @along2 with @stroke lc rgb green dt dash(who) title "half down", \
    @step2 @who $lens_point index who using @flat2 with @mark_at pt mark(who) lw 1+who lc rgb blue title "center under the lens", \
    @step2 @who $display_across index who using @along3 with @orange_stroke dt dash(who) title "x of the center", \
    @step2 @who $display_up index who using @along3 with @stroke lc rgb green dt dash(who) title "y of the center", \
    @step2 @who $display_point index who using @flat3 with @mark_at pt mark(who) lw 1+who lc rgb blue title "center", \
    @step3 $unit using @flat4 with @area title "square, surface", \
    @step3 $unit using @flat4 with @lines lc rgb ink title "square", \
    @step3 $once using (U(4,0)):(V(4,0)) with @corner lc rgb ink title "origin of the square", \
    @step3 $once using (U(3,screen_W)+12):(0.7*height):(U(4,0)-U(3,screen_W)-30):(0) with @arrow lc rgb ink title "mapping", \
    @step3 @who $unit_across index who using @along4 with @orange_stroke dt dash(who) title "s", \
    @step3 @who $unit_up index who using @along4 with @stroke lc rgb green dt dash(who) title "t", \
    @step3 @who $unit_point index who using @flat4 with @mark_at pt mark(who) lw 1+who lc rgb blue title "place", \
    @step4 $plane index 0 using @point with @area title "plane, surface", \
    @step4 $plane index 0 using @point with @lines lc rgb ink title "plane", \
    @step4 $plane every ::3::3 using @point with @corner lc rgb ink title "origin of the plane", \
    @step4 @who $along_s index who using @vector with @orange_stroke dt dash(who) title "s on the plane", \
    @step4 @who $along_t index who using @vector with @stroke lc rgb green dt dash(who) title "t on the plane", \
    @step5 @who $ray index who using @vector with @axis lc rgb blue dt dash(who) title "ray", \
    @step4 @who $vector index who using @vector with @arrow lc rgb blue dt dash(who) title "vector", \
    @step4 $eye using @point with @dot lc rgb blue title "eye", \
    @step4 @who $vector index who using @tip with @mark_at pt mark(who) lw 1+who lc rgb blue title "pixel on the plane", \
    @labels
