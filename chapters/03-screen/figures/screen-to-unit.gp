# screen-to-unit.gp - a point on the screen, and the same point in the unit square (slide
# 'Normalized screen coordinates').
title = "A point on the screen, normalized"
s_is = sprintf("%s/%s", point_x_text, screen_W_text)
from_top = sprintf(point_y < 0 ? "(%s)/%s" : "%s/%s", point_y_text, screen_H_text)
t_is = "1 − ".from_top
description = sprintf("On the left is a screen of %s by %s pixels. Its origin is at the upper left; x counts to the \
right, y counts down. It shows the point %s. On the right is the unit square. Its origin is at the lower left; \
s counts to the right, t counts up. There, the same point is at s = %s, t = %s: %s.", \
    screen_W_text, screen_H_text, point_text, s_is, t_is, place_text)
steps = 5

# Panel 1 is the screen, with y down; panel 2 is the unit square. A point outside one is outside both.
panel = 1; room = "0.115 0.47 0.27 0.84"
low_x = least(0, point_x); high_x = most(screen_W, point_x)
low_y = -most(screen_H, point_y); high_y = -least(0, point_y)
@flat
panel = 2; room = "0.70 0.97 0.27 0.84"
low_x = least(0, place_s); high_x = most(1, place_s)
low_y = least(0, place_t); high_y = most(1, place_t)
@flat
top = V(1, -least(0, point_y))
left = U(1, least(0, point_x))
bottom = V(2, least(0, place_t))
square_left = U(2, least(0, place_s))
between = V(1, -screen_H / 2)

# Labels are beside their lines, away from the edges. A line that is too short has no label.
side = point_x > 0.6 * screen_W ? -1 : 1
beside = side > 0 ? "labels left" : "labels right"
over = point_y > 0.75 * screen_H ? 1 : -1
crowded = point_y < 0.15 * screen_H || point_y > 0.88 * screen_H
under = crowded ? over : -over
part = crowded && side < 0 ? 1 / 3.0 : 1 / 2.0
fits(length, text) = abs(length) < 12 * strlen(text) ? "" : text

if (step >= 5) {
    set label 1 large(sprintf("( %s ,  %s ) = %s", s_is, t_is, place_text)) at width/2,84 center tc rgb ink
    set label 2 wrong ? "yours: ".your("place_text") : "" at width/2,48 center tc rgb orange
}
plot $square using (U(1,$1*screen_W)):(V(1,-$2*screen_H)) with filledcurves closed fc rgb surface fs solid noborder title "screen, surface", \
    $square using (U(1,$1*screen_W)):(V(1,-$2*screen_H)) with @lines lc rgb ink title "screen", \
    $once using (U(1,0)):(top+14):(size[1]*screen_W):(0) with @axis lc rgb grey title "x axis", \
    $once using (U(1,screen_W/2)):(top+30):(math("x")) with labels tc rgb ink title "x", \
    $once using (U(1,screen_W)):(top+30):(screen_W_text) with labels tc rgb ink title "W", \
    $once using (left-14):(V(1,0)):(0):(-size[1]*screen_H) with @axis lc rgb grey title "y axis", \
    $once using (left-26):(V(1,-screen_H/2)):(math("y")) with labels right tc rgb ink title "y", \
    $once using (left-26):(V(1,-screen_H)):(screen_H_text) with labels right tc rgb ink title "H", \
    $once using (U(1,0)):(V(1,0)) with points pt 5 ps 0.5 lc rgb pink title "origin of the screen", \
    $once using (left-10):(top+30):("origin") with labels tc rgb pink title "origin", \
    $once using (U(1,0)):(V(1,-point_y)):(size[1]*point_x):(0) with @stroke lc rgb blue title "x of the point", \
    $once using (U(1,point_x*part)):(V(1,-point_y)+13*under):(fits(size[1]*point_x,point_x_text)) with labels tc rgb blue title "x, label", \
    $once using (U(1,point_x)):(V(1,0)):(0):(-size[1]*point_y) with @stroke lc rgb green title "y of the point", \
    $once using (U(1,point_x)+8*side):(V(1,-point_y/2)):(fits(size[1]*point_y,point_y_text)) with @beside tc rgb green title "y, label", \
    $point using (U(1,$1)):(V(1,-$2)) with @dot lc rgb orange title "point", \
    $point using (U(1,$1)+10*side):(V(1,-$2)+14*over):(point_text) with @beside tc rgb orange title "point, label", \
    @step2 $square using (U(2,$1)):(V(2,$2)) with filledcurves closed fc rgb surface fs solid noborder title "square, surface", \
    @step2 $square using (U(2,$1)):(V(2,$2)) with @lines lc rgb ink title "square", \
    @step2 $once using (U(2,0)):(bottom-14):(size[2]):(0) with @axis lc rgb grey title "s axis", \
    @step2 $once using (U(2,0.5)):(bottom-30):(math("s")) with labels tc rgb ink title "s", \
    @step2 $once using (U(2,1)):(bottom-30):("1") with labels tc rgb ink title "1", \
    @step2 $once using (square_left-14):(V(2,0)):(0):(size[2]) with @axis lc rgb grey title "t axis", \
    @step2 $once using (square_left-26):(V(2,0.5)):(math("t")) with labels right tc rgb ink title "t", \
    @step2 $once using (square_left-26):(V(2,1)):("1") with labels right tc rgb ink title "1", \
    @step2 $once using (U(2,0)):(V(2,0)) with points pt 5 ps 0.5 lc rgb pink title "origin of the square", \
    @step2 $once using (square_left-10):(bottom-30):("origin") with labels tc rgb pink title "origin", \
    @step3 $once using (0.49*width):(between):(0.14*width):(0) with @arrow lc rgb ink title "mapping", \
    @step3 $once using (0.56*width):(between+18):(math("s = x/").screen_W_text) with labels tc rgb blue title "s = x/W", \
    @step4 @who $place index who using (U(2,0)):(V(2,$2)):(size[2]*$1):(0) with @stroke lc rgb blue dt dash(who) title "s of the point", \
    @step4 $place index 0 using (U(2,$1*part)):(V(2,$2)+13*under):(fits(size[2]*$1,s_is)) with labels tc rgb blue title "s, label", \
    @step3 $once using (0.56*width):(between-20):(math("t = 1 − y/").screen_H_text) with labels tc rgb green title "t = 1 - y/H", \
    @step4 $place index 0 using (U(2,$1)):(V(2,1)):(0):(size[2]*($2-1)) with vectors nohead lw 0.8 lc rgb green title "from the top", \
    @step4 $place index 0 using (U(2,$1)+8*side):(V(2,($2+1)/2)):(fits(size[2]*(1-$2),from_top)) with @beside tc rgb green title "from the top, label", \
    @step4 @who $place index who using (U(2,$1)):(V(2,0)):(0):(size[2]*$2) with @stroke lc rgb green dt dash(who) title "t of the point", \
    @step4 @who $place index who using (U(2,$1)):(V(2,$2)) with points pt mark(who) ps 0.55 lw 1+who lc rgb orange title "place", \
    @step4 $place index 0 using (U(2,$1)+10*side):(V(2,$2)+14*over):(math("(s, t)")) with @beside tc rgb orange title "place, label"
