# ray-sphere.gp - where the line p + t v meets the circle (slide 'Intersecting a ray and a sphere').
touches = roots == 2 && t0 == t1
title = "A ray and a sphere"
description = sprintf("The section through the ray and the centre of the sphere. p is %s, v is %s, the centre c is %s, \
r is %s%s. |p + t v|² = r² in object coordinates has a = %s, b = %s, c = %s, and b² − 4ac is %s: ", \
    origin_text, velocity_text, center_text, r_text, moved ? "; p − c is ".object_p_text : "", a_text, b_text, c_text, D_text).( \
    roots == 0 ? sprintf("no hit. The line is closest to c at t = %s, at a distance of %s.", t_nearest_text, away_text) : \
    touches ? sprintf("the line touches the circle at t = %s.", t0_text) : \
    sprintf("the line meets the circle at t0 = %s and t1 = %s.", t0_text, t1_text)).( \
    hit > 0 ? sprintf(" The hit is at t = %s.", hit_text) : roots > 0 ? " No hit is in front of p." : "")
verdict = hit > 0 ? math("t").sprintf(" = %s is the hit", hit_text) : roots > 0 ? "no root > 0: no hit" : \
    "no root: ".math("c").sprintf(" is %s away", away_text)
your_hit_words = differs("hit") ? (your_hit > 0 ? yours("hit") : ", yours: none") : ""
steps = 5
if (wrong) { set label 99 "solid: right\ndashed, squares: yours" }

# Room for the labels of the roots. The numbers are in a corner that the line and the circle leave free,
# or beside both.
azimuth = 90
elevation = 0
n0 = strlen(t0_text) + (touches ? 10 : 5)
n1 = touches ? 0 : strlen(t1_text) + 5
steep = abs(seen_x(off_x, off_y, off_z)) > 0.5
x_low = steep ? 0.13 : 0.05
x_high = 1 - x_low
fill(low) = sprintf("%g %g 0.09 0.91", low, x_high)
room = fill(x_low)
@see
@beside_line
@beside_roots
over_left(u, n) = roots == 2 ? most(0, 8.0 - u + half(n)) / width : 0
over_right(u, n) = roots == 2 ? most(0, u + half(n) + 8.0 - width) / width : 0
x_low = x_low + most(over_left(hit0_u, n0), over_left(hit1_u, n1))
x_high = x_high - most(over_right(hit0_u, n0), over_right(hit1_u, n1))
room = fill(x_low)
@see
@beside_line
row = 27
box_w = most(250, moved ? 7.9 * (2 + strlen(object_p_text)) : 0) + (wrong ? 110 : 0)
box_h = row * (moved ? 8 : 6)
x_left = 26
x_right = width - 20 - box_w
y_top = height - 36
y_bottom = 6 + box_h
off_line(u, v) = abs((u - ball_u) * off_u + (v - ball_v) * off_v - scale * away) \
    - box_w / 2 * abs(off_u) - box_h / 2 * abs(off_v)
free(x, y) = off_line(x + box_w / 2, y + row / 2 - box_h / 2) > 45 && \
    from_circle(x + box_w / 2, y + row / 2 - box_h / 2, box_w / 2, box_h / 2) > 12
text_x = free(x_left, y_top) || free(x_left, y_bottom) || !(free(x_right, y_top) || free(x_right, y_bottom)) ? x_left : x_right
text_y = free(text_x, y_top) || !free(text_x, y_bottom) ? y_top : y_bottom
if (!free(text_x, text_y)) {
    room = fill((x_left + box_w + 10.0) / width + (steep ? 0.1 : 0))
    @see
    @beside_line
    @beside_roots
    x_high = x_high - most(over_right(hit0_u, n0), over_right(hit1_u, n1))
    room = fill((x_left + box_w + 10.0) / width + (steep ? 0.1 : 0))
    @see
    @beside_line
}
say(k) = text_y - k * row
@beside_roots

# Other labels beside the line, if there is room for them.
v_label = stride == 1 ? "v" : stride_text." v"
p_label = near_p ? "p" : "to p"
n_p = strlen(p_label)
taken(u, v, n) = roots == 2 && (overlap(u, v, n, hit0_u, hit0_v, n0) || overlap(u, v, n, hit1_u, hit1_v, n1))
p_side = taken(beside_u(t_u(0), 1) - 6 * line_u, beside_v(t_v(0), 1) - 6 * line_v, 1) ? -n_p : n_p
v_u = t_u(v_first + stride / 2.0)
v_v = t_v(v_first + stride / 2.0)
v_side = (taken(beside_u(v_u, 1), beside_v(v_v, 1), strlen(v_label)) ? -1 : 1) * strlen(v_label)
mark(t) = t == 0 ? (p_side < 0 ? "" : "t = 0") : roots == 0 && abs(t - t_nearest) * speed * scale < 12 ? "" : number(t)
end_label = !near_p && t_nearest < 0 ? "" : "p + t v"
small_ball = scale * r < 45
c_label = small_ball ? math("c").", ".math("r")." = ".r_text : math("c")
c_off = small_ball ? scale * r + 16 : 14
c_back = small_ball ? 0 : 8
color(t) = t == hit ? orange : t > 0 ? pink : grey
beside_center(x, y) = !small_ball && sqrt((x - ball_u + c_off * off_u + c_back * line_u)**2 + (y - ball_v + c_off * off_v + c_back * line_v)**2) < 22

plot @step2 $circle using @point with filledcurves closed fc rgb surface fs solid noborder title "disc", \
    @step2 $circle using @point with @lines lc rgb ink title "circle", \
    $behind index wrong using @point with @lines lc rgb grey dt 3 title "behind p", \
    $ahead index wrong using @point with @lines lc rgb blue title "p + t v", \
    $end index wrong using (beside_u(X($1,$2,$3), 7) - 34 * line_u):(beside_v(Y($1,$2,$3), 7) - 34 * line_v): \
        (taken(beside_u(X($1,$2,$3), 7) - 34 * line_u, beside_v(Y($1,$2,$3), 7) - 34 * line_v, 7) ? "" : math(end_label)) \
        with labels tc rgb blue title "line, label", \
    $ticks index wrong using (X($1,$2,$3)-4*off_u):(Y($1,$2,$3)-4*off_v):(8*off_u):(8*off_v) \
        with vectors nohead lw 1 lc rgb grey title "marks of t", \
    $ticks index wrong using (beside_u(X($1,$2,$3), -strlen(mark($4)))):(beside_v(Y($1,$2,$3), -strlen(mark($4)))): \
        (beside_center(beside_u(X($1,$2,$3), -2), beside_v(Y($1,$2,$3), -2)) ? "" : small(mark($4))) \
        with labels tc rgb grey title "t", \
    $v index wrong using @vector with @arrow lc rgb blue title "v", \
    $v index wrong using (beside_u(v_u, v_side)):(beside_v(v_v, v_side)): \
        (math(v_label)) with labels tc rgb blue title "v, label", \
    for [_=1:near_p] $p index wrong using @point with @dot lc rgb blue title "p", \
    $p index wrong using (beside_u(X($1,$2,$3), p_side) - 6 * line_u):(beside_v(Y($1,$2,$3), p_side) - 6 * line_v): \
        (math(p_label)) with labels tc rgb blue title "p, label", \
    for [_=1:step >= 2 && !small_ball] $radius using @vector with @thin_arrow lc rgb ink title "r", \
    @step2 $radius using (X($1+$4/2,$2+$5/2,$3+$6/2)+9*(line_u+off_u)):(Y($1+$4/2,$2+$5/2,$3+$6/2)+9*(line_v+off_v)): \
        (small_ball ? "" : math("r")) with labels tc rgb ink title "r, label", \
    @step2 $center using @point with @dot lc rgb ink title "c", \
    @step2 $center using (ball_u-c_off*off_u-c_back*line_u):(ball_v-c_off*off_v-c_back*line_v):(c_label) with labels tc rgb ink title "c, label", \
    @step3 $center using (text_x):(say(0)):(math("|p + t v|^2 = r^2")) with labels left tc rgb ink title "equation", \
    @step3 $center using (text_x):(say(1)):(math("a = v·v = ").a_text.yours("a")) with labels left tc rgb grey title "a", \
    @step3 $center using (text_x):(say(2)):(math("b = 2 p·v = ").b_text.yours("b")) with labels left tc rgb grey title "b", \
    @step3 $center using (text_x):(say(3)):(math("c = p·p − r^2 = ").c_text.yours("c")) with labels left tc rgb grey title "c = p·p − r²", \
    @step3 $center using (text_x):(say(4)):(math("b^2 − 4 a c = ").D_text.yours("D")) with labels left tc rgb ink title "discriminant", \
    for [_=1:step >= 4 && roots == 0] $apart using @vector with vectors nohead lw 1.2 dt 2 lc rgb grey title "nearest", \
    for [_=1:step >= 4 && roots == 0] $nearest using @point with @square lc rgb grey title "nearest point", \
    @step4 $nearest using (beside_u(X($1,$2,$3), 9)):(beside_v(Y($1,$2,$3), 9)):(roots == 0 ? math("t")." = ".t_nearest_text : "") \
        with labels tc rgb grey title "nearest, label", \
    @step4 $hit0 index 0 using @point with @ring lc rgb color(t0) title "t0", \
    @step4 $hit1 index 0 using @point with @ring lc rgb color(t1) title "t1", \
    for [_=1:step >= 4 && differs("t0")] $hit0 index differs("t0") using @point with @square lc rgb ink title "your t0", \
    for [_=1:step >= 4 && differs("t1")] $hit1 index differs("t1") using @point with @square lc rgb ink title "your t1", \
    @step4 $center using (hit0_u):(hit0_v):(roots == 2 ? math(touches ? "t_0 = t_1 = " : "t_0 = ").t0_text : "") \
        with labels tc rgb color(t0) title "t0, label", \
    @step4 $center using (hit1_u):(hit1_v):(roots == 2 && !touches ? math("t_1 = ").t1_text : "") \
        with labels tc rgb color(t1) title "t1, label", \
    @step5 $used index 0 using @point with @dot lc rgb orange title "the hit", \
    for [_=1:step >= 5 && differs("hit")] $used index differs("hit") using @point with @square lc rgb orange title "your hit", \
    @step5 $center using (text_x):(say(5)):(verdict.your_hit_words) with labels left tc rgb orange title "verdict", \
    @step3 $center using (text_x):(say(6)):(moved ? small(math("p")." stands for ".math("p − c")." =") : "") \
        with labels left tc rgb grey title "p − c", \
    @step3 $center using (text_x):(say(7)):(moved ? small(object_p_text) : "") with labels left tc rgb grey title "p − c, numbers"
