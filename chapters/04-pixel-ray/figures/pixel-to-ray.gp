# pixel-to-ray.gp - the chain from a pixel to its ray (slide 'Mapping from Pixel to Camera Ray').
title = "From a pixel to its ray"
description = sprintf("The pixel in column %s, row %s of a screen of %s by %s pixels is a square. Its centre is the \
point %s on the screen. In the unit square, with s = x/W and t = 1 − y/H, the centre is at (s, t) = %s. The vector from \
the eye to that place on the image plane is v = d f + (s − ½) w r + (t − ½) h u = %s. The ray starts at the eye, p = %s, \
and its points are p + t v.", \
    pixel_column_text, pixel_row_text, screen_W_text, screen_H_text, center_text, place_text, v_text, origin_text)
steps = 5

# In the upper half, panel 1 is the pixel under a lens, 2 is the screen, with y down, and 3 is the
# unit square. In the lower half is the world.
low_x = pixel_column; high_x = pixel_column + 1; low_y = -pixel_row - 1; high_y = -pixel_row
panel = 1; room = "0.05 0.21 0.70 0.91"
@flat
low_x = 0; high_x = screen_W; low_y = -screen_H; high_y = 0
panel = 2; room = "0.28 0.51 0.70 0.91"
@flat
low_x = 0; high_x = 1; low_y = 0; high_y = 1
panel = 3; room = "0.72 0.90 0.70 0.91"
@flat
room = "0.08 0.71 0.19 0.64"
@see
XS(panel, s) = U(panel, pixel_column + s)
YT(panel, t) = V(panel, t - pixel_row - 1)
middle_1 = U(1, pixel_column + 0.5)
between = (U(2, screen_W) + U(3, 0)) / 2
level = V(3, 0.5)
captions = 516
caption_3 = shape eq "4:3" ? "width-10,captions right" : "U(3,0.5),captions center"
ray_end = "(X($1+$4,$2+$5,$3+$6)+8):(Y($1+$4,$2+$5,$3+$6))"

set label 1 "pixel ".pixel_text at middle_1,captions center tc rgb ink
if (step >= 2) { set label 2 "centre ".center_text at U(2,screen_W/2),captions center tc rgb ink }
if (step >= 3) { set label 3 math("(s, t)")." = ".place_text at @caption_3 tc rgb ink }
if (step >= 4) { set label 4 math("v = d f + (s − ½) w r + (t − ½) h u").sprintf(" = %s", v_text) at 0.05*width,72 tc rgb pink }
if (step >= 5) { set label 5 sprintf("ray: %s from %s = %s", math("p + t v"), math("p"), origin_text) at 0.05*width,46 tc rgb blue }
# Of the user's answer: the first link that is wrong.
link = exists("your_center_text") ? "centre ".your("center_text") : exists("your_place_text") ? "(s, t) = ".your("place_text") : \
    exists("your_v_text") ? "v = ".your("v_text") : exists("your_origin_text") ? "p = ".your("origin_text") : "the ray"
if (wrong) { set label 6 "yours: ".link at 0.05*width,18 tc rgb orange }

plot $square using (XS(1,$1)):(YT(1,$2)) with filledcurves closed fc rgb orange fs transparent solid 0.35 noborder title "pixel", \
    $square using (XS(1,$1)):(YT(1,$2)) with @thick lc rgb orange title "pixel, outline", \
    $square using (U(2,$1*screen_W)):(V(2,-$2*screen_H)) with filledcurves closed fc rgb surface fs solid noborder title "screen, surface", \
    $square using (U(2,$1*screen_W)):(V(2,-$2*screen_H)) with @lines lc rgb ink title "screen", \
    $square using (XS(2,$1)):(YT(2,$2)) with filledcurves closed fc rgb orange fs transparent solid 0.35 border lc rgb orange title "pixel on the screen", \
    $once using (XS(1,1)):(YT(1,1)):(XS(2,0)-XS(1,1)):(YT(2,1)-YT(1,1)) with vectors nohead lw 0.8 lc rgb grey title "lens", \
    $once using (XS(1,1)):(YT(1,0)):(XS(2,0)-XS(1,1)):(YT(2,0)-YT(1,0)) with vectors nohead lw 0.8 lc rgb grey title "lens", \
    $once using (U(2,0)):(V(2,0)) with points pt 5 ps 0.5 lc rgb pink title "origin of the screen", \
    @step2 @who $center index who using (XS(1,0)):(V(1,-$2)):(U(1,$1)-XS(1,0)):(0) with @stroke lc rgb blue dt dash(who) title "half across", \
    @step2 @who $center index who using (U(1,$1)):(YT(1,1)):(0):(V(1,-$2)-YT(1,1)) with @stroke lc rgb green dt dash(who) title "half down", \
    @step2 @who $center index who using (U(1,$1)):(V(1,-$2)) with points pt mark(who) ps 0.55 lw 1+who lc rgb ink title "center under the lens", \
    @step2 $once using (XS(1,0.25)):(YT(1,0.5)-13):("½") with labels tc rgb ink title "half", \
    @step2 $once using (XS(1,0.5)+9):(YT(1,0.75)):("½") with labels left tc rgb ink title "half", \
    @step2 @who $center index who using (U(2,0)):(V(2,-$2)):(size[2]*$1):(0) with @stroke lc rgb blue dt dash(who) title "x of the center", \
    @step2 @who $center index who using (U(2,$1)):(V(2,0)):(0):(-size[2]*$2) with @stroke lc rgb green dt dash(who) title "y of the center", \
    @step2 @who $center index who using (U(2,$1)):(V(2,-$2)) with points pt mark(who) ps 0.55 lw 1+who lc rgb ink title "center", \
    @step3 $square using (U(3,$1)):(V(3,$2)) with filledcurves closed fc rgb surface fs solid noborder title "square, surface", \
    @step3 $square using (U(3,$1)):(V(3,$2)) with @lines lc rgb ink title "square", \
    @step3 $once using (U(3,0)):(V(3,0)) with points pt 5 ps 0.5 lc rgb pink title "origin of the square", \
    @step3 $once using (between-58):(level):(116):(0) with @arrow lc rgb ink title "mapping", \
    @step3 $once using (between):(level+18):(math("s = x/").screen_W_text) with labels tc rgb blue title "s = x/W", \
    @step3 $once using (between):(level-20):(math("t = 1 − y/").screen_H_text) with labels tc rgb green title "t = 1 - y/H", \
    @step3 @who $place index who using (U(3,0)):(V(3,$2)):(size[3]*$1):(0) with @stroke lc rgb blue dt dash(who) title "s", \
    @step3 @who $place index who using (U(3,$1)):(V(3,0)):(0):(size[3]*$2) with @stroke lc rgb green dt dash(who) title "t", \
    @step3 @who $place index who using (U(3,$1)):(V(3,$2)) with points pt mark(who) ps 0.55 lw 1+who lc rgb ink title "place", \
    @step4 $once using (U(3,0.5)):(V(3,0)-10):(0):(-46) with @arrow lc rgb ink title "mapping to the world", \
    @step4 $once using (U(3,0.5)+14):(V(3,0)-32):(math("v(s, t)")) with labels left tc rgb pink title "v(s, t)", \
    @step4 $plane using @point with filledcurves closed fc rgb surface fs solid noborder title "plane, surface", \
    @step4 $plane using @point with @lines lc rgb ink title "plane", \
    @step4 $plane every ::3::3 using @point with points pt 5 ps 0.5 lc rgb pink title "origin of the plane", \
    @step4 @who $along_s index who using @vector with @stroke lc rgb blue dt dash(who) title "s on the plane", \
    @step4 @who $along_t index who using @vector with @stroke lc rgb green dt dash(who) title "t on the plane", \
    @step5 @who $ray index who using @vector with @axis lc rgb blue dt dash(who) title "ray", \
    @step5 $ray index 0 using @ray_end:(math("p + t v")) with labels left tc rgb blue title "ray, label", \
    @step4 @who $vector index who using @vector with @arrow lc rgb pink dt dash(who) title "vector", \
    @step4 $vector index 0 using @half_way:(math("v")) with labels tc rgb pink offset 0,-0.8 title "v", \
    @step4 $eye using @point with @dot lc rgb blue title "eye", \
    @step4 $eye using @point:(math("p")) with labels tc rgb blue offset -1.5,-0.5 title "p", \
    @step4 @who $vector index who using @tip with points pt mark(who) ps 0.55 lw 1+who lc rgb ink title "pixel on the plane"
