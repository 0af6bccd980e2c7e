# closest-hit.gp - one ray asks one sphere after the other, and keeps the smallest t > 0 (slide 'Ray casting process').
#
# As in the figure nearest-hit, each sphere is turned around the ray into the paper.
steps = |$moments| - 1
rate = 12
title = own("The closest hit, sphere by sphere")
description = sprintf(own("One ray asks %d spheres, one after the other, and keeps the smallest t > 0. %s"), all_balls, all_hits == 0 ? \
    own("It hits none.") : sprintf(own("At the end that is %s, on sphere %s."), nearest_text, nearest_name))
# A lecturer stops at each answer, and at the end.
stops = ""
do for [k=2:steps] { if (word($moments[k + 1], 5) eq "1" && word($moments[k], 5) eq "0") { stops = stops." ".k } }
now = int(most(1, least(step, steps)))
at = $moments[now + 1]
asked = whole(at, 1)
tip = cell(at, 2)
best = word(at, 3) eq "NaN" ? 0 : cell(at, 3)
best_ball = whole(at, 4)
answered = whole(at, 5)
room = "0.05 0.95 0.28 0.96"
@flat
x(t) = U(1, t)
on_ray = V(1, 0)
is_asked(number) = int(number) == asked
is_best(number) = best_ball >= 0 && int(number) == best_ball
place_y(side, r) = V(1, side) - (abs(V(1, side) - on_ray) < 24 ? size[1] * r * 0.5 : 0)
# What the sphere that is asked says: 0 missed, 1 behind, 2 or 3 hit.
fate = asked < 0 ? -1 : 0
hit_t = 0
stats $circles index 0 using (is_asked($1) && $4 < 1e8 ? (fate = int($6), hit_t = $9, 1) : 0) nooutput
mathless(s) = math("t")." = ".shown(s)
first_line = asked < 0 ? (answered && best_ball >= 0 ? own("the closest hit colors the pixel") : own("of all answers the smallest")." ".math("t")." > 0") : \
    own("sphere")." ".ball_name(asked).": ".(!answered ? own("where does the ray meet it?") : fate == 0 ? own("the ray misses it") : \
    fate == 1 ? math("t")." < 0, ".own("it is behind the eye") : own("hit at")." ".mathless(hit_t))
second_line = (asked < 0 && answered ? own("closest hit:") : own("closest so far:"))." ".(best_ball < 0 ? own("none") : \
    mathless(best).", ".own("sphere")." ".ball_name(best_ball))
diameter = "(2*size[1]*$4):(2*size[1]*$4)"

plot $circles index 0 using ($11 == 0 ? x($2) : NaN):(V(1,$3)):(size[1]*$4):(pale($5)) with circles \
        fc rgb variable fs solid noborder title "circles", \
    $circles index 0 using (is_best($1) ? x($2) : NaN):(V(1,$3)):(size[1]*$4):(int($5)) with circles \
        fc rgb variable fs solid noborder title "closest so far", \
    $circles index 0 using ($11 == 0 ? x($2) : NaN):(V(1,$3)):@diameter with ellipses units xx lc rgb grey lw 1 fs empty \
        border lc rgb grey title "outlines", \
    $circles index 0 using (is_asked($1) ? x($2) : NaN):(V(1,$3)):@diameter with ellipses units xx lc rgb ink lw 3 fs empty \
        border lc rgb ink title "outline of the one that is asked", \
    $along using (x(low_x)):(on_ray):(x(high_x) - x(low_x)):(0) with vectors nohead lw 2 dt 3 lc rgb blue \
        title "line of the ray", \
    $along using (x(0)):(on_ray):(x(tip) - x(0)):(0) with vectors nohead lw 3 lc rgb blue title "ray so far", \
    $along using (x(0)):(on_ray):(x(1) - x(0)):(0) with @arrow lc rgb blue title "v", \
    $along using (x(0)):(on_ray) with @dot lc rgb blue title "eye", \
    $along using (x(0)):(on_ray - 26):(own("eye")) with labels tc rgb blue title "eye, label", \
    $along using (x(0.5)):(on_ray + 22):(math("v")) with labels tc rgb blue title "v, label", \
    $circles index 0 using (x($2)):(place_y($3,$4)):(ball_name($1)) with labels tc rgb ink title "names", \
    for [_=1:asked>=0&&answered&&fate>1] $along using (x(hit_t)):(on_ray) with points pt 6 ps 0.8 lw 2 lc rgb ink title "hit", \
    for [_=0:best_ball] $along using (x(best)):(on_ray) with points pt 7 ps 0.8 lc rgb blue title "closest so far, hit", \
    $once using (width / 2):(100):(first_line) with labels tc rgb ink title "words", \
    $once using (width / 2):(52):(second_line) with labels tc rgb (best_ball < 0 ? grey : blue) title "closest"
