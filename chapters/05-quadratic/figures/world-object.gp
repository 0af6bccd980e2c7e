# world-object.gp - the same ray and sphere in world and in object coordinates: points move by −C, the
# roots stay (slide 'Ray and sphere in world coordinates').
count(at) = value(at."_roots")
root(at, i) = value(sprintf("%s_t%d_text", at, i))
plain(at) = count(at) == 0 ? own("no root") : root(at, 0)." ".own("and")." ".root(at, 1)
title = own("World and object coordinates")
description = sprintf(own("Left, in the world: a ray from %s along %s, and a sphere of radius %s around C = %s%s. Its equation \
|(p + t v) − C|² = r² has a = %s, b = %s, c = %s, and roots: %s. Right, moved by −C: the ray starts at %s, and the sphere is \
around the origin. The equation |p + t v|² = r² has a = %s, b = %s, c = %s, and roots: %s."), origin_text, velocity_text, r_text, center_text, near_origin ? "" : ", ".own("from (0, 0, 0)"), \
    world_a_text, world_b_text, world_c_text, plain("world"), object_p_text, object_a_text, object_b_text, object_c_text, \
    plain("object")).arrow_words(stride)
steps = 4
if (wrong) { set label 99 squares_are_yours }

# In the right panel: what is in object coordinates, and what the world's data are there.
object_point = "(X($1-moved_x,$2-moved_y,$3-moved_z)):(Y($1-moved_x,$2-moved_y,$3-moved_z))"
look0 = color(t0) eq blue ? dot : ring
look1 = t0 == t1 || color(t1) eq blue ? dot : ring

plot $circle using @point with filledcurves closed fc rgb surface fs solid noborder title "disc", \
    for [_=1:near_origin] $world_axes using @vector with @thin_arrow lc rgb grey title "axes", \
    $circle using @point with @lines lc rgb ink title "circle", \
    $behind index wrong using @point with @lines lc rgb grey dt 3 title "behind p", \
    $ahead index wrong using @point with lines lw 1.6 lc rgb blue title "p + t v", \
    $c using @vector with @arrow lc rgb ink title "c", \
    @step2 $minus_c using @vector with @arrow lc rgb blue title "moved", \
    $v index wrong using @vector with @arrow lc rgb blue title "v", \
    for [_=1:near_p] $p index wrong using @point with @dot lc rgb blue title "p", \
    $center using @point with @dot lc rgb ink title "center", \
    @step4 $world_hit1 index 0 using @point with @look1 lc rgb color(t1) title "t1", \
    @step4 $world_hit0 index 0 using @point with @look0 lc rgb color(t0) title "t0", \
    for [_=1:step >= 4 && differs("world_t0")] $world_hit0 index differs("world_t0") using @point with @square lc rgb ink title "your t0", \
    for [_=1:step >= 4 && differs("world_t1")] $world_hit1 index differs("world_t1") using @point with @square lc rgb ink title "your t1", \
    @step2 @panel2 $circle using @object_point with filledcurves closed fc rgb surface fs solid noborder title "object disc", \
    @step2 @panel2 $object_axes using @vector with @thin_arrow lc rgb grey title "object axes", \
    @step2 @panel2 $circle using @object_point with @lines lc rgb ink title "object circle", \
    @step2 @panel2 $behind index wrong using @object_point with @lines lc rgb grey dt 3 title "behind p − c", \
    @step2 @panel2 $ahead index wrong using @object_point with lines lw 1.6 lc rgb blue title "p − c + t v", \
    @step2 @panel2 @who $object_v index who using @vector with @arrow lc rgb blue dt dash(who) title "object v", \
    for [_=1:step >= 2 && near_p] @panel2 $object_p index 0 using @point with @dot lc rgb blue title "p − c", \
    for [_=1:step >= 2 && differs("object_p_text")] @panel2 $object_p index differs("object_p_text") using @point \
        with @square lc rgb ink title "your p − c", \
    @step4 @panel2 $object_hit1 index 0 using @point with @look1 lc rgb color(t1) title "object t1", \
    @step4 @panel2 $object_hit0 index 0 using @point with @look0 lc rgb color(t0) title "object t0", \
    for [_=1:step >= 4 && differs("object_t0")] @panel2 $object_hit0 index differs("object_t0") using @point with @square lc rgb ink title "your object t0", \
    for [_=1:step >= 4 && differs("object_t1")] @panel2 $object_hit1 index differs("object_t1") using @point with @square lc rgb ink title "your object t1", \
    @labels
