# image-order.gp - the picture, pixel by pixel, beside the ray of each pixel (slide 'Image order').
steps = sets
rate = 8
stops = ""
do for [k=1:sets] { if (k % columns == 0) { stops = stops." ".k } }
title = own("Image order, pixel by pixel")
description = sprintf(own("For each of %s pixels a ray goes from the eye through its center, up to the closest hit, and the pixel \
gets the color of that sphere, or of the background."), grid_text)
now = int(most(1, least(step, steps)))
at = $pixel_sets[now + 1]
column = whole(at, 1)
row = whole(at, 2)
ball_hit = whole(at, 3)
room = scene_room
@see
@spheres

# The picture: its pixels as squares.
side = picture_size / most(columns, rows)
left = picture_x - side * columns / 2
upper = picture_y + side * rows / 2
in_picture = "(left+side*($5+0.5)):(upper-side*($6+0.5)):(left+side*$5):(left+side*($5+1)):(upper-side*($6+1)):(upper-side*$6)"
so_far = "every 1:1:0:0:0:(now-1)"
this_ray = "every :::(now-1)::(now-1)"

plot @behind \
    $plane using @point with filledcurves closed fc rgb surface fs solid noborder title "surface", \
    for [k=0:now-1] $sets every :::k::k using @point:4 with filledcurves closed fc rgb variable fs solid noborder \
        title "pixels", \
    $grid using @point with @hair lc rgb grey title "grid", \
    $plane using @point with @lines lc rgb ink title "plane", \
    @before \
    $sets @this_ray using @point with @halo title "outline of the pixel, halo", \
    $sets @this_ray using @point with @thick lc rgb ink title "outline of the pixel", \
    $rays @this_ray using @point with @hidden lc rgb blue title "ray, all of it", \
    $rays @this_ray using @bold with @ray lc rgb blue title "ray", \
    @names \
    $eye using @point with @dot lc rgb blue title "eye", \
    $eye using @point:(own("eye")) with labels left tc rgb blue offset -1,-1 title "eye, label", \
    $square using (left+side*columns*$1):(upper-side*rows*$2) with filledcurves closed fc rgb surface fs solid noborder \
        title "picture", \
    $sets @so_far using @in_picture:4 with boxxyerror fc rgb variable fs solid noborder title "picture, pixels", \
    $square using (left+side*columns*$1):(upper-side*rows*$2) with @lines lc rgb ink title "picture, outline", \
    $square using (left+side*(column+$1)):(upper-side*(row+$2)) with @halo title "picture, this pixel, halo", \
    $square using (left+side*(column+$1)):(upper-side*(row+$2)) with @thick lc rgb ink title "picture, this pixel", \
    $once using (picture_x):(upper + 26):(own("the picture")) with labels tc rgb ink title "picture, name", \
    $once using (width / 2):(44):(sprintf(own("pixel (%d, %d): %s"), column, row, ball_hit < 0 ? own("the ray hits nothing") : \
        own("the ray hits sphere")." ".ball_name(ball_hit))) with labels tc rgb ink title "words"
