# image-order.gp - the picture, pixel by pixel, beside the ray of each pixel (slide 'Image order').
steps = sets
rate = 8
stops = ""
do for [k=1:sets] { if (k % columns == 0) { stops = stops." ".k } }
title = own("Image order, pixel by pixel")
description = sprintf(own("For each of %s pixels a ray goes from the eye through its center, up to the closest hit, and the pixel \
gets the color of that sphere, or of the background."), grid_text)
now = int(most(1, least(step, steps)))
done = now
at = $pixel_sets[now + 1]
column = whole(at, 1)
row = whole(at, 2)
ball_hit = whole(at, 3)
room = scene_room
@see
@spheres

@place_picture
this_ray = "every :::(now-1)::(now-1)"

plot @behind \
    @plane_and_pixels \
    @before \
    $sets @this_ray using @point with @halo title "outline of the pixel, halo", \
    $sets @this_ray using @point with @thick lc rgb ink title "outline of the pixel", \
    $rays @this_ray using @point with @hidden lc rgb blue title "ray, all of it", \
    $rays @this_ray using @bold with @ray lc rgb blue title "ray", \
    @names \
    @eye_and_picture \
    $square using (left+side*(column+$1)):(upper-side*(row+$2)) with @halo title "picture, this pixel, halo", \
    $square using (left+side*(column+$1)):(upper-side*(row+$2)) with @thick lc rgb ink title "picture, this pixel", \
    $once using (width / 2):(44):(sprintf(own("pixel (%d, %d): %s"), column, row, ball_hit < 0 ? own("the ray hits nothing") : \
        own("the ray hits sphere")." ".ball_name(ball_hit))) with labels tc rgb ink title "words"
