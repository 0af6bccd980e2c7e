# object-order.gp - the picture, sphere by sphere: its lines to the eye, its outline, its pixels (slide 'Object order').
steps = |$moments| - 1
rate = 8
title = own("Object order, sphere by sphere")
description = sprintf(own("For each of %d spheres, lines go from its outline to the eye. The places where they cross the image plane \
are its outline in the picture. Of the pixels inside, it colors those that show no nearer sphere."), all_balls)
# A lecturer stops where a sphere has its outline, and where it has its pixels.
stops = ""
do for [k=2:steps] {
    a = $moments[k]
    b = $moments[k + 1]
    if (word(a, 1) ne word(b, 1) || (word(a, 3) eq "0" && word(b, 3) eq "1")) { stops = stops." ".(k - 1) }
}
stops = stops." ".steps
now = int(most(1, least(step, steps)))
at = $moments[now + 1]
ball_now = whole(at, 1)
part = cell(at, 2)
outlined = whole(at, 3)
done = whole(at, 4)
share = ball_now < 0 ? "" : $shares[ball_now + 2]
set_by = done == 0 || ball_now < 0 ? 0 : (sum [k=1:done] (word($pixel_sets[k + 1], 3) eq sprintf("%d", ball_now)))
said = ball_now < 0 ? (done ? own("all pixels get the color of the background") : own("for each sphere: which pixels does it color?")) : \
    !outlined ? sprintf(own("sphere %s: lines to the eye"), ball_name(ball_now)) : \
    set_by == 0 && whole(share, 2) > 0 ? sprintf(own("sphere %s: its outline on the image plane"), ball_name(ball_now)) : \
    set_by < whole(share, 2) ? sprintf(set_by == 1 ? own("sphere %s: %d pixel") : own("sphere %s: %d pixels"), ball_name(ball_now), set_by) : \
    whole(share, 3) > set_by ? sprintf(own("sphere %s: %d of %d pixels; the others show a nearer sphere"), ball_name(ball_now), set_by, whole(share, 3)) : \
    sprintf(set_by == 1 ? own("sphere %s: %d pixel") : own("sphere %s: %d pixels"), ball_name(ball_now), set_by)
room = scene_room
@see
@spheres

@place_picture
lines_now = sprintf("$lines%d", most(0, ball_now))
outline_now = sprintf("$outline%d", most(0, ball_now))
longest = 160 # places of a line, from the eye to the sphere
shown = "every ::(int(longest*(1-part)))"

plot @behind \
    @plane_and_pixels \
    @before \
    for [_=0:ball_now] @lines_now @shown using @point with @hidden lc rgb blue title "lines to the eye, all of them", \
    for [_=0:ball_now] @lines_now @shown using @bold with @ray lc rgb blue title "lines to the eye", \
    for [_=1:ball_now>=0&&outlined] @outline_now using @point with @halo title "outline, halo", \
    for [_=1:ball_now>=0&&outlined] @outline_now using @point with @thick lc rgb ink title "outline on the plane", \
    @names \
    @eye_and_picture \
    $once using (width / 2):(44):(said) with labels tc rgb ink title "words"
