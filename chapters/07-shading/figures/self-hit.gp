# self-hit.gp - why a ray must not start on the surface that it leaves, and the remedy.
title = "A surface that hits itself"
description = sprintf("A ray hits a sphere. Because of rounding, the point is %s inside. A ray from there to the light \
immediately meets the sphere, at t = %s: the surface casts a shadow on itself. A ray that starts %s outside, along the \
normal, meets nothing before the light.", inside_by_text, self_t_text, offset_size_text)
steps = 4
low_x = -3.4; high_x = 1.1; low_y = -1.1; high_y = 4.2
panel = 1; room = "0.03 0.50 0.10 0.92"
@flat
# The magnifying glass: the surface is a line, the normal is up, and distances are not to scale.
low_x = -3; high_x = 3; low_y = -3; high_y = 3
panel = 2; room = "0.52 0.97 0.08 0.92"
@flat

place = "(U(1,$1)):(V(1,$2))"
way = "(U(1,$1)):(V(1,$2)):(size[1]*$4):(size[1]*$5)"
tip = "(U(1,$1+$4)):(V(1,$2+$5))"
in_loupe(x, y) = sprintf("(U(2,%g)):(V(2,%g))", x, y)
middle = in_loupe(0, 0)
inside = in_loupe(0, -1.2)
outside = in_loupe(0, 1)
inside_label = in_loupe(0.2, -1.6)
outside_label = in_loupe(0.2, 0.65)
meets = in_loupe(1.2 * tan(light_angle), 0)
meets_label = in_loupe(1.2 * tan(light_angle) + 0.25, -0.35)
surface_label = in_loupe(-2.7, 0.25)
note_label = in_loupe(0, -2.55)
light_way(y, length) = in_loupe(0, y).sprintf(":(size[2]*%g):(size[2]*%g)", length * sin(light_angle), length * cos(light_angle))
from_inside = light_way(-1.2, 1.2 / cos(light_angle))
from_outside = light_way(1, 1.9)

plot $center using (U(1,$1)):(V(1,$2)):(size[1]*radius) with circles fc rgb surface fs solid border lc rgb ink lw 1.4 title "sphere", \
    $center using @place with @dot lc rgb ink title "centre", \
    $center using @place:(math("c")) with labels offset 1.2,-0.4 tc rgb ink title "c", \
    $seen using @way with @arrow lc rgb grey title "seen", \
    $light using @place with points pt 3 ps 1.1 lw 2 lc rgb orange title "light", \
    $light using @place:("light") with labels left offset 1.2,0 tc rgb orange title "light, label", \
    $to_light using @way with vectors nohead lw 1.4 dt 3 lc rgb blue title "to the light", \
    $normal using @way with @arrow lc rgb green title "normal", \
    $normal using @tip:(math("n")) with labels right offset -0.8,0.5 tc rgb green title "n", \
    $seen using @tip with @ring lc rgb ink title "point", \
    @step2 $center using @middle:(size[2]*6):(size[2]*6) with ellipses units xx fs empty border lc rgb grey lw 1 title "loupe", \
    @step2 $center using (U(2,-3)):(V(2,0)):(size[2]*6):(0) with vectors nohead lw 1.8 lc rgb ink title "surface", \
    @step2 $center using @surface_label:("surface") with labels left tc rgb ink title "surface, label", \
    @step2 $center using @note_label:("not to scale") with labels tc rgb grey title "note", \
    @step3 $center using @from_inside with vectors nohead lw 1.6 dt 2 lc rgb pink title "from the point", \
    @step3 $center using @meets with points pt 2 ps 1 lw 2.4 lc rgb pink title "self hit", \
    @step3 $center using @meets_label:(small(math("t = ").self_t_text)) with labels left tc rgb pink title "self hit, label", \
    @step3 $center using @inside with @ring lc rgb ink title "rounded", \
    @step3 $center using @inside_label:(small(inside_by_text." inside")) with labels left tc rgb pink title "rounded, label", \
    @step4 $center using @from_outside with @arrow lc rgb blue title "from the start", \
    @step4 $center using @outside with @dot lc rgb blue title "start", \
    @step4 $center using @outside_label:(small(offset_size_text." outside")) with labels left tc rgb blue title "start, label"
