# nearest-hit.gp - along one ray: the smallest t > 0 (slide 'Ray casting process').
#
# Each sphere is turned around the ray into the paper, so circles and hits have their true distances.
# Lengths are measured in the ray's t. If a sphere is too large for the paper (part is 1: a ground), only
# its part in the window from low_x to high_x and low_y to high_y is drawn. At first all spheres look alike: step 2
# says which of them the line misses, step 3 which are behind the eye.
left_out = (balls < all_balls ? sprintf(own("Drawn are %d of %d spheres.")." ", balls, all_balls) : "").(part_names eq "" ? "" : \
    sprintf(own("Of %s only a part is drawn."), part_names))
title = own("The nearest hit: the smallest t > 0")
description = sprintf(own("One ray and %d spheres.")." ", balls).(behind_names eq "" ? "" : \
    sprintf(own("Behind the eye, t < 0, so they are not hits: %s.")." ", behind_names)).(missed_names eq "" ? "" : \
    sprintf(own("Missed: %s.")." ", missed_names)).(all_hits == 0 ? own("No t is greater than 0, so nothing is hit.")." " : \
    sprintf(own("Hit: %s. The smallest t > 0 is %s, on sphere %s.")." ", hit_names, nearest_text, nearest_name)). \
    left_out
steps = 4
axis = 96
above_axis(lane) = axis + 19 + 24 * lane
x(t) = U(1, t)
on_ray = V(1, 0)
# Numbers on the axis: 1, 2 or 5 times a power of ten, and room for each.
rough = most((high_x - low_x) / 7, 62 / size[1])
power = 10 ** floor(log10(rough))
tick = rough > 5 * power ? 10 * power : rough > 2 * power ? 5 * power : rough > power ? 2 * power : power
first = tick * ceil(low_x / tick)
ticks = floor((high_x - first) / tick)
tick_at(k) = first + tick * k
grouped(digits) = strlen(digits) < 4 ? digits : grouped(digits[1:strlen(digits) - 3]).",".digits[strlen(digits) - 2:*]
tick_text(t) = (t < 0 ? "−" : "").(abs(t) < 9999.5 ? sprintf("%g", abs(t)) : grouped(sprintf("%.0f", abs(t))))
# Within the window.
shown_t(t) = most(low_x, least(high_x, t))
# Outlines are ellipses: gnuplot 5.4 draws an empty circle's outline twice, which closes the gaps of a dashed one.
diameter = "(2*size[1]*$4):(2*size[1]*$4)"
outline_hit = "lc rgb ink lw 1.4 fs empty border lc rgb ink"
outline_other = "lc rgb grey lw 1 dt 2 fs empty border lc rgb grey"
outline_missed = step < 2 ? outline_hit : outline_other
outline_behind = step < 3 ? outline_hit : outline_other
words_x = all_hits ? most(width * 0.32, least(width * 0.68, x(nearest))) : width / 2

plot $parts index 0 using (x($1)):(V(1,$2)):(pale($3)) with filledcurves closed \
        fc rgb variable fs solid noborder title "parts", \
    $parts index 0 using (x($1)):($4 == 1 ? V(1,$2) : NaN) with lines lw 1.4 lc rgb ink \
        title "parts, outline", \
    $circles index 0 using ($11 == 0 ? x($2) : NaN):(V(1,$3)):(size[1]*$4):($6 > 0 || step < 2 ? pale($5) : rgb_of(surface)) with circles \
        fc rgb variable fs solid noborder title "circles", \
    $circles index 0 using ($6 > 1 && $11 == 0 ? x($2) : NaN):(V(1,$3)):@diameter with ellipses units xx @outline_hit title "hit circles", \
    $circles index 0 using ($6 == 1 ? x($2) : NaN):(V(1,$3)):@diameter with ellipses units xx @outline_behind title "circles behind", \
    $circles index 0 using ($6 == 0 ? x($2) : NaN):(V(1,$3)):@diameter with ellipses units xx @outline_missed title "missed circles", \
    $along using (x(low_x)):(on_ray):(x(high_x) - x(low_x)):(0) with vectors nohead lw 2 dt 3 lc rgb blue \
        title "line of the ray", \
    $along using (x(0)):(on_ray):(x(high_x) - x(0)):(0) with vectors nohead lw 1.6 lc rgb blue title "ray", \
    $along using (x(0)):(on_ray):(x(1) - x(0)):(0) with @arrow lc rgb blue title "v", \
    $along using (x(0)):(on_ray) with @dot lc rgb blue title "eye", \
    @step2 $along using (x(low_x)):(axis):(x(high_x) - x(low_x) + 14):(0) \
        with vectors head filled size 10,16,90 lw 1 lc rgb grey title "axis", \
    @step2 $along using (x(high_x) + 20):(axis - 22):(math("t")) with labels tc rgb grey title "t", \
    @step2 for [k=0:ticks] $along using (x(tick_at(k))):(axis - 3):(0):(6) with vectors nohead lw 1 lc rgb grey \
        title "ticks", \
    @step2 for [k=0:ticks] $along using (x(tick_at(k))):(axis - 22):(x(tick_at(k)) > x(high_x) - 16 ? "" : tick_text(tick_at(k))) \
        with labels tc rgb grey title "numbers", \
    @step2 $circles index 0 using (x(shown_t($7)) - 1):(above_axis($10)):(x(shown_t($8)) - x(shown_t($7)) + 2):(0) with vectors nohead lw 9 \
        lc rgb grey title "intervals, outline", \
    @step2 $circles index 0 using (x(shown_t($7))):(above_axis($10)):(x(shown_t($8)) - x(shown_t($7))):(0):5 with vectors nohead lw 7 \
        lc rgb variable title "intervals", \
    @step2 $circles index 0 using ($6 > 0 ? x(shown_t($8)) + 9 : width / 2):(above_axis($10)):($6 > 0 ? ball_name($1) : "") \
        with labels left tc rgb ink title "intervals, names", \
    @step2 @who $roots index who using ($1 == shown_t($1) ? x($1) : NaN):(on_ray) with @ring lc rgb ink title "roots", \
    @step3 $circles index 0 using ($6 == 1 ? x($7) - 5 : NaN):(above_axis($10)):($6 == 1 ? x($8) - x($7) + 10 : NaN):(0) \
        with vectors nohead lw 1.4 lc rgb ink title "crossed out", \
    @step3 $along using (x(0)):(axis - 3):(0):(on_ray - axis + 3) with vectors nohead lw 1 dt 2 lc rgb blue title "t = 0", \
    @step4 @who $closest index who using (x($1)):(on_ray):(0):(axis - on_ray) with vectors nohead lw 1.4 dt dash(who) \
        lc rgb blue title "closest, down", \
    @step4 @who $closest index who using (x($1)):(on_ray) with points pt (who ? 8 : 7) ps 0.6 lc rgb blue title "closest", \
    @step4 $closest index 0 using (x($1)):(axis) with @dot lc rgb blue title "closest on the axis", \
    @step4 $along using (words_x):(30):(all_hits ? own("smallest")." ".math("t")." > 0:  ".math("t")." = ".nearest_text. \
        ", ".own("sphere")." ".nearest_name : own("no")." ".math("t")." > 0: ".own("nothing is hit")) with labels tc rgb blue title "words", \
    @labels
