# world-object.gp - the same ray and sphere in world and in object coordinates: points move by −c, the
# roots stay (slide 'Ray and sphere in world coordinates').
coefficients(at) = math("a").sprintf(" = %s,  ", value(at."_a_text")).math("b").sprintf(" = %s,  ", value(at."_b_text")). \
    math("c").sprintf(" = %s", value(at."_c_text"))
your_coefficients(at) = (differs(at."_a") ? "a".yours(at."_a")." " : "").(differs(at."_b") ? "b".yours(at."_b")." " : ""). \
    (differs(at."_c") ? "c".yours(at."_c") : "")
count(at) = value(at."_roots")
root(at, i) = value(sprintf("%s_t%d_text", at, i))
found(at, t) = count(at) == 0 ? "no root" : root(at, 0) eq root(at, 1) ? t."_0 = ".t."_1 = ".root(at, 0) : \
    t."_0 = ".root(at, 0).",  ".t."_1 = ".root(at, 1)
plain(at) = count(at) == 0 ? "no root" : root(at, 0)." and ".root(at, 1)
title = "World and object coordinates"
description = sprintf("Left, in the world: a ray from %s along %s, and a sphere of radius %s around c = %s. Its equation \
|(p + t v) − c|² = r² has a = %s, b = %s, c = %s, and roots: %s. Right, moved by −c: the ray starts at %s, and the sphere is \
around the origin. The equation |p + t v|² = r² has a = %s, b = %s, c = %s, and roots: %s.", origin_text, velocity_text, r_text, center_text, \
    world_a_text, world_b_text, world_c_text, plain("world"), object_p_text, object_a_text, object_b_text, object_c_text, \
    plain("object"))
steps = 4
if (wrong) { set label 99 "solid: right\ndashed, squares: yours" }
lift = wrong ? 20 : 0

# The world is in the left half; the other half is the same, moved.
azimuth = 90
elevation = 0
room = "0.045 0.445 0.32 0.88"
@see
@beside_line
side = 0.51 * width
object_x(x, y, z) = X(x, y, z) + scale * seen_x(ball_x, ball_y, ball_z) + side
object_y(x, y, z) = Y(x, y, z) + scale * seen_y(ball_x, ball_y, ball_z)
object_point = "(object_x($1,$2,$3)):(object_y($1,$2,$3))"
object_vector = object_point.":(scale*seen_x($4,$5,$6)):(scale*seen_y($4,$5,$6))"
n0 = 4
n1 = 4
@beside_roots
touches = t0 == t1
color(t) = abs(t - hit) <= 1e-6 * abs(hit) ? orange : t > 0 ? pink : grey
look0 = color(t0) eq orange ? dot : ring
look1 = touches || color(t1) eq orange ? dot : ring
left_text = 0.245 * width
right_text = 0.755 * width
taken(u, v) = object_roots > 0 && (overlap(u, v, 1, hit0_u, hit0_v, 2) || overlap(u, v, 1, hit1_u, hit1_v, 2))
axis_name(i) = word("x y z", int(i))
# The name of an axis is beside its tip, or above it if the ray would cross it; t_1 is beside an axis.
from_ray(u, v) = abs((u - t_u(0)) * (t_v(1) - t_v(0)) - (v - t_v(0)) * (t_u(1) - t_u(0))) / \
    sqrt((t_u(1) - t_u(0))**2 + (t_v(1) - t_v(0))**2)
crossed(u, v) = from_ray(u + 10, v - 6) < 10
axis_u = X(ball_x, ball_y, ball_z)
off_axis(u) = abs(u - axis_u) < 20 ? axis_u + (u < axis_u ? -20 : 20) : u
v_label = stride == 1 ? "v" : stride_text." v"
v_u = t_u(v_first + stride / 2.0)
v_v = t_v(v_first + stride / 2.0)
v_side = (taken(beside_u(v_u, 1), beside_v(v_v, 1)) ? -1 : 1) * strlen(v_label)
p_side = taken(beside_u(t_u(0), -1), beside_v(t_v(0), -1)) ? 1 : -1
split = 7.9 * (12 + strlen(origin_text.center_text)) > 0.47 * width ? 22 : 0

plot $circle using @point with filledcurves closed fc rgb surface fs solid noborder title "disc", \
    for [_=1:near_origin] $world_axes using @vector with @thin_arrow lc rgb grey title "axes", \
    $world_axes using (@tip_x + (crossed(@tip_x, @tip_y) ? 0 : 10)):(@tip_y + (crossed(@tip_x, @tip_y) ? 14 : -6)): \
        (near_origin ? small(math(axis_name($7))) : "") with labels tc rgb grey title "axes, labels", \
    $circle using @point with @lines lc rgb ink title "circle", \
    $behind index wrong using @point with @lines lc rgb grey dt 3 title "behind p", \
    $ahead index wrong using @point with @lines lc rgb blue title "p + t v", \
    $c using @vector with @arrow lc rgb green title "c", \
    $c using (X($1+0.5*$4,$2+0.5*$5,$3+0.5*$6)-13*off_u):(Y($1+0.5*$4,$2+0.5*$5,$3+0.5*$6)-13*off_v):(math("c")) \
        with labels tc rgb green title "c, label", \
    $c using (X($1,$2,$3)):(Y($1,$2,$3) - 14):(near_origin ? "" : small("from (0, 0, 0)")) with labels tc rgb green title "c, start", \
    $v index wrong using @vector with @arrow lc rgb blue title "v", \
    $v index wrong using (beside_u(v_u, v_side)):(beside_v(v_v, v_side)): \
        (math(v_label)) with labels tc rgb blue title "v, label", \
    for [_=1:near_p] $p index wrong using @point with @dot lc rgb blue title "p", \
    $p index wrong using (beside_u(X($1,$2,$3), 2 * p_side)):(beside_v(Y($1,$2,$3), 2 * p_side)):(math(near_p ? "p" : "to p")) with labels tc rgb blue title "p, label", \
    $center using @point with @dot lc rgb ink title "centre", \
    $center using (left_text):(height - 28):("world") with labels tc rgb ink title "world", \
    @step2 $center using (left_text + 0.205 * width):(0.84 * height):(0.10 * width):(0) with @arrow lc rgb green title "moved", \
    @step2 $center using (0.5 * width):(0.84 * height + 18):(math("− c")) with labels tc rgb green title "moved, label", \
    @step2 $circle using (X($1,$2,$3) + side):(Y($1,$2,$3)) with filledcurves closed fc rgb surface fs solid noborder title "object disc", \
    @step2 $object_axes using @object_vector with @thin_arrow lc rgb grey title "object axes", \
    @step2 $object_axes using (object_x($1+$4,$2+$5,$3+$6) + 10):(object_y($1+$4,$2+$5,$3+$6) - 6): \
        (taken(object_x($1+$4,$2+$5,$3+$6) + 10 - side, object_y($1+$4,$2+$5,$3+$6) - 6) ? "" : small(math(axis_name($7)))) \
        with labels tc rgb grey title "object axes, labels", \
    @step2 $circle using (X($1,$2,$3) + side):(Y($1,$2,$3)) with @lines lc rgb ink title "object circle", \
    @step2 $behind index wrong using (X($1,$2,$3) + side):(Y($1,$2,$3)) with @lines lc rgb grey dt 3 title "behind p − c", \
    @step2 $ahead index wrong using (X($1,$2,$3) + side):(Y($1,$2,$3)) with @lines lc rgb blue title "p − c + t v", \
    @step2 @who $object_v index who using @object_vector with @arrow lc rgb blue dt dash(who) title "object v", \
    for [_=1:step >= 2 && near_p] $object_p index 0 using @object_point with @dot lc rgb blue title "p − c", \
    @step2 $v index wrong using (beside_u(v_u, v_side) + side):(beside_v(v_v, v_side)): \
        (math(v_label)) with labels tc rgb blue title "object v, label", \
    for [_=1:step >= 2 && differs("object_p_text")] $object_p index differs("object_p_text") using @object_point \
        with @square lc rgb ink title "your p − c", \
    @step2 $p index wrong using (middle_at(beside_u(X($1,$2,$3), 5 * p_side) + side, long("to p − c", text_size))):(beside_v(Y($1,$2,$3), 5 * p_side)):(math(near_p ? "p − c" : "to p − c")) \
        with labels tc rgb blue title "p − c, label", \
    @step2 $center using (right_text):(height - 28):("object") with labels tc rgb ink title "object", \
    @step3 $center using (left_text):(lift + split + 126):(math("|(p + t v) − c|^2 = r^2")) with labels tc rgb ink title "world equation", \
    @step3 $center using (right_text):(lift + split + 126):(math("|p + t v|^2 = r^2")) with labels tc rgb ink title "object equation", \
    @step3 $center using (left_text):(lift + split + 98):(small(math("p")." = ".origin_text.(split ? "" : ",  ".math("c")." = ".center_text))) with labels tc rgb grey title "p and c", \
    @step3 $center using (left_text):(lift + 98):(split ? small(math("c")." = ".center_text) : "") with labels tc rgb grey title "c, on its own", \
    @step3 $center using (right_text):(lift + 98):(small(math("p")." stands for ".math("p − c")." = ".object_p_text)) with labels tc rgb grey title "p for p − c", \
    @step3 $center using (left_text):(lift + 72):(small(coefficients("world"))) with labels tc rgb grey title "world a, b, c", \
    @step3 $center using (right_text):(lift + 72):(small(coefficients("object"))) with labels tc rgb grey title "object a, b, c", \
    @step4 $world_hit1 index 0 using @point with @look1 lc rgb color(t1) title "t1", \
    @step4 $world_hit0 index 0 using @point with @look0 lc rgb color(t0) title "t0", \
    @step4 $object_hit1 index 0 using @object_point with @look1 lc rgb color(t1) title "object t1", \
    @step4 $object_hit0 index 0 using @object_point with @look0 lc rgb color(t0) title "object t0", \
    for [_=1:step >= 4 && differs("world_t0")] $world_hit0 index differs("world_t0") using @point with @square lc rgb ink title "your t0", \
    for [_=1:step >= 4 && differs("world_t1")] $world_hit1 index differs("world_t1") using @point with @square lc rgb ink title "your t1", \
    for [_=1:step >= 4 && differs("object_t0")] $object_hit0 index differs("object_t0") using @object_point with @square lc rgb ink title "your object t0", \
    for [_=1:step >= 4 && differs("object_t1")] $object_hit1 index differs("object_t1") using @object_point with @square lc rgb ink title "your object t1", \
    @step4 for [i=0:1] $center using (hit0_u + i * side):(hit0_v):(object_roots > 0 ? math("t_0") : "") with labels tc rgb color(t0) title "t0, label", \
    @step4 for [i=0:1] $center using (i ? off_axis(hit1_u) + side : hit1_u):(hit1_v):(object_roots > 1 && !touches ? math("t_1") : "") with labels tc rgb color(t1) title "t1, label", \
    @step4 $center using (left_text):(lift + 42):(found("world", math("t"))) with labels tc rgb orange title "world roots", \
    @step4 $center using (right_text):(lift + 42):(found("object", math("t"))) with labels tc rgb orange title "object roots", \
    @step4 $center using (left_text):(lift + 18):(small(your_coefficients("world"))) with labels tc rgb ink title "your world a, b, c", \
    @step4 $center using (right_text):(lift + 18):(small(your_coefficients("object"))) with labels tc rgb ink title "your object a, b, c"
