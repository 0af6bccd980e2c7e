# spheres.gp - spheres in front of and behind the image plane, as shaded discs with great circles.
#
# $spheres has a row for each of 'balls' spheres: number x y z radius rgb (65536 r + 256 g + b).
# '@spheres', after @see, makes three lists for the plot command: @behind is drawn
# before the image plane, @before after it, @names are the letters. seen(x, y, z) is 1 if neither a
# sphere nor the image plane hides that place of the world.
#
# Far spheres are drawn first. Where two meet, a plane through their common circle divides them, and
# of the nearer one just what is beyond it is drawn: so neither hides too much. The image plane
# divides a sphere that sticks out of it in the same way; it is number 0 among what divides.
array ball_number[100]
array ball_x[100] # on the canvas, and how near; in the canvas' units
array ball_y[100]
array ball_n[100]
array ball_r[100]
array ball_rgb[100]
array ball_h[100] # from its middle to the image plane, towards whoever looks
array divided[100] # by which: "2 5"
array order[100]

# Sphere 0 is A, as in the lesson; after Z comes AA.
letter(i) = "ABCDEFGHIJKLMNOPQRSTUVWXYZ"[i % 26 + 1:i % 26 + 1]
ball_name(i) = i < 26 ? letter(int(i)) : ball_name(int(i) / 26 - 1).letter(int(i))

# Colors: how bright; and with some of black (k < 0) or white mixed in.
linear(byte) = (byte / 255.0) ** 2.2
bright(rgb) = 0.2126 * linear(rgb / 65536) + 0.7152 * linear(rgb / 256 % 256) + 0.0722 * linear(rgb % 256)
mixed(byte, k) = int(byte + abs(k) * ((k < 0 ? 0 : 255) - byte) + 0.5)
shade(rgb, k) = sprintf("#%02x%02x%02x", mixed(rgb / 65536, k), mixed(rgb / 256 % 256, k), mixed(rgb % 256, k))
pale(rgb) = rgb_of(shade(int(rgb), dark ? -0.6 : 0.6))
rgb_of(text) = int("0x".text[2:*])
outline(rgb) = shade(rgb, dark ? 0.5 : -0.5)
on_ball(rgb) = bright(rgb) > 0.18 ? "#000000" : "#ffffff"

# Of sphere i what lies beyond divider j is seen: the places from its middle with n.place >= h.
apart(i, j) = sqrt((ball_x[i] - ball_x[j])**2 + (ball_y[i] - ball_y[j])**2 + (ball_n[i] - ball_n[j])**2)
n_x(i, j) = j == 0 ? plane_x : (ball_x[i] - ball_x[j]) / apart(i, j)
n_y(i, j) = j == 0 ? plane_y : (ball_y[i] - ball_y[j]) / apart(i, j)
n_n(i, j) = j == 0 ? plane_n : (ball_n[i] - ball_n[j]) / apart(i, j)
h_of(i, j) = j == 0 ? ball_h[i] : (ball_r[j]**2 - ball_r[i]**2 - apart(i, j)**2) / (2 * apart(i, j))

# In direction phi from its middle it is seen from 'from' to 'upto'; there n has the part a, and b
# towards whoever looks.
upto1(r, a, b, h) = a * r >= h ? r : r * r * (a * a + b * b) < h * h ? 0 : \
    (h * a + b * sqrt(r * r * (a * a + b * b) - h * h)) / (a * a + b * b)
from1(r, a, b, h) = -a * r >= h ? 0 : r * r * (a * a + b * b) < h * h ? 0 : \
    (h * a - b * sqrt(r * r * (a * a + b * b) - h * h)) / (a * a + b * b)
n_along(i, j, phi) = n_x(i, j) * cos(phi) + n_y(i, j) * sin(phi)
upto(i, list, m, phi) = m == 0 ? ball_r[i] : least(upto(i, list, m - 1, phi), \
    upto1(ball_r[i], n_along(i, int(word(list, m)), phi), n_n(i, int(word(list, m))), h_of(i, int(word(list, m)))))
from(i, list, m, phi) = m == 0 ? 0 : most(from(i, list, m - 1, phi), \
    from1(ball_r[i], n_along(i, int(word(list, m)), phi), n_n(i, int(word(list, m))), h_of(i, int(word(list, m)))))
beyond(i, list, m, x, y, n) = m == 0 ? 1 : n_x(i, int(word(list, m))) * x + n_y(i, int(word(list, m))) * y + \
    n_n(i, int(word(list, m))) * n < h_of(i, int(word(list, m))) ? 0 : beyond(i, list, m - 1, x, y, n)

# Shade k, from 0 (the whole disc) to 1, is a smaller disc, nearer to a light at the upper left.
lit(r, k, phi) = 0.32 * k * r * cos(phi - 125) + sqrt((r * (1 - 0.66 * k))**2 - (0.32 * k * r * sin(phi - 125))**2)
rim(i, list, k, phi) = list eq "" ? lit(ball_r[i], k, phi) : \
    most(0, least(lit(ball_r[i], k, phi), upto(i, list, words(list), phi)))
inner(i, list, phi) = list eq "" ? 0 : from(i, list, words(list), phi)
# Once round the rim in so many places; where something divides it, also back along its inner rim.
places = dragged ? 37 : 145
once_round(at) = 360.0 / (places - 1) * at
turn(list, at) = list eq "" ? once_round(at) : at <= places / 2 ? 2 * once_round(at) : 720 - 2 * once_round(at)
way(i, list, k, at) = list eq "" || at <= places / 2 ? rim(i, list, k, turn(list, at)) : \
    least(inner(i, list, turn(list, at)), rim(i, list, k, turn(list, at)))
disc_x(i, list, k, at) = ball_x[i] + way(i, list, k, at) * cos(turn(list, at))
disc_y(i, list, k, at) = ball_y[i] + way(i, list, k, at) * sin(turn(list, at))
edge_x(i, list, phi) = ball_x[i] + rim(i, list, 0, phi) * cos(phi)
edge_y(i, list, phi) = inner(i, list, phi) < rim(i, list, 0, phi) ? ball_y[i] + rim(i, list, 0, phi) * sin(phi) : NaN

# Great circles, one level, one facing the eye: only what is towards whoever looks.
arc_x(which, phi) = which == 0 ? across(cos(phi), sin(phi)) : across(cos(phi), 0)
arc_y(which, phi) = which == 0 ? above(cos(phi), 0, sin(phi)) : above(cos(phi), sin(phi), 0)
arc_n(which, phi) = which == 0 ? near(cos(phi), 0, sin(phi)) : near(cos(phi), sin(phi), 0)
on_arc(i, list, which, phi) = arc_n(which, phi) > 0 && beyond(i, list, words(list), ball_r[i] * arc_x(which, phi), \
    ball_r[i] * arc_y(which, phi), ball_r[i] * arc_n(which, phi)) ? ball_y[i] + ball_r[i] * arc_y(which, phi) : NaN

# The commands that draw sphere i: its shades, its outline, its great circles.
layers = 10 # fewer of many spheres, and while something is dragged
disc(i, list, k) = sprintf("'+' using (disc_x(%d,'%s',%g,$0)):(disc_y(%d,'%s',%g,$0)) with filledcurves closed \
fc rgb '%s' fs solid noborder title '%s %s', ", i, list, k, i, list, k, shade(ball_rgb[i], 0.55 * k - 0.3), \
    k > 0 ? "shade of" : words(list) > 0 && word(list, 1) eq "0" ? "before the plane, sphere" : "sphere", \
    ball_name(ball_number[i]))
discs(i, list, m) = m < 0 ? "" : discs(i, list, m - 1).disc(i, list, m / (layers + 0.0))
rims(i, list) = sprintf("'+' using (edge_x(%d,'%s',once_round($0))):(edge_y(%d,'%s',once_round($0))) with lines lw 1 \
lc rgb '%s' title 'outline of %s', ", i, list, i, list, outline(ball_rgb[i]), ball_name(ball_number[i]))
arc(i, list, which) = sprintf("'+' using (ball_x[%d]+ball_r[%d]*arc_x(%d,once_round($0))):(on_arc(%d,'%s',%d,once_round($0))) \
with lines lw 0.8 lc rgb '%s' title 'great circle of %s', ", i, i, which, i, list, which, \
    shade(ball_rgb[i], bright(ball_rgb[i]) > 0.18 ? -0.4 : 0.4), ball_name(ball_number[i]))
ball(i, list) = discs(i, list, layers).arc(i, list, 0).arc(i, list, 1).rims(i, list)

# A place of the canvas, and how near: is it behind the image plane, or in or behind a sphere?
in_right(x, y, n) = sin(azimuth) * x - cos(azimuth) * (sin(elevation) * y - cos(elevation) * n)
in_up(x, y, n) = cos(elevation) * y + sin(elevation) * n
in_forward(x, y, n) = cos(azimuth) * x + sin(azimuth) * (sin(elevation) * y - cos(elevation) * n)
from_eye(x, y, n) = (to_plane = (d * scale - in_forward(x, y, n)) / near(0, 0, 1), to_plane > 1e-6 * scale * d && \
    abs(in_right(x, y, n) + to_plane * near(1, 0, 0)) < scale * w / 2 && \
    abs(in_up(x, y, n) + to_plane * near(0, 1, 0)) < scale * h / 2)
behind_plane(x, y, n) = from_eye(x - X(at_x, at_y, at_z), y - Y(at_x, at_y, at_z), n - N(at_x, at_y, at_z))
N(x, y, z) = scale * seen_near(x, y, z)
behind_ball(i, x, y, n) = (off2 = (x - ball_x[i])**2 + (y - ball_y[i])**2, \
    off2 < ball_r[i]**2 && n < ball_n[i] + sqrt(ball_r[i]**2 - off2) - 1e-4 * ball_r[i])
hidden(x, y, n) = (sum [_i=1:balls] behind_ball(_i, x, y, n)) > 0 || behind_plane(x, y, n)
seen(x, y, z) = balls > 0 ? !hidden(X(x, y, z), Y(x, y, z), N(x, y, z)) : !behind_plane(X(x, y, z), Y(x, y, z), N(x, y, z))

# A letter on sphere i: in its middle, or in the first of eight places round it that is seen.
spot_x(i, k) = ball_x[i] + (k == 0 ? 0 : 0.6 * ball_r[i] * cos(45 * k + 22))
spot_y(i, k) = ball_y[i] + (k == 0 ? 0 : 0.6 * ball_r[i] * sin(45 * k + 22))
spot_seen(i, k) = !hidden(spot_x(i, k), spot_y(i, k), ball_n[i] + ball_r[i] * (k == 0 ? 1 : 0.8))
spot(i, k) = k > 8 || spot_seen(i, k) ? k : spot(i, k + 1)
letters(i, name) = ball_r[i] > 6 + 6 * strlen(name) ? name : ""
name_at(i, k) = k > 8 || letters(i, ball_name(ball_number[i])) eq "" ? "" : sprintf("'+' every ::0::0 \
using (%g):(%g):(letters(%d,'%s')) with labels tc rgb '%s' title 'name of %s', ", spot_x(i, k), spot_y(i, k), i, \
    ball_name(ball_number[i]), on_ball(ball_rgb[i]), ball_name(ball_number[i]))

# Which of the other spheres divide i: farther ones that it meets.
meets(i, j) = i != j && ball_n[j] < ball_n[i] && apart(i, j) < ball_r[i] + ball_r[j] && h_of(i, j) > -ball_r[i]
dividers(i, j) = j == 0 ? "" : dividers(i, j - 1).(meets(i, j) ? sprintf(" %d", j) : "")
farther(i) = sum [_j=1:balls] (ball_n[_j] < ball_n[i] || (ball_n[_j] == ball_n[i] && _j < i))
spheres = 'set samples places; count = 0; behind = ""; before = ""; names = ""; \
    stats $spheres index 0 using (count = count + 1, ball_number[count] = $1, ball_x[count] = X($2,$3,$4), \
        ball_y[count] = Y($2,$3,$4), ball_n[count] = N($2,$3,$4), ball_r[count] = scale * $5, ball_rgb[count] = int($6), \
        ball_h[count] = scale * (along_forward(at_x, at_y, at_z) + d - along_forward($2,$3,$4)), 1) nooutput; \
    plane_side = near(0, 0, 1) < 0 ? -1 : 1; plane_x = plane_side * across(0, 1); \
    plane_y = plane_side * above(0, 0, 1); plane_n = plane_side * near(0, 0, 1); layers = dragged ? 2 : balls > 12 ? 4 : 10; \
    do for [i=1:balls] { order[1 + farther(i)] = i; ball_h[i] = plane_side * ball_h[i]; divided[i] = dividers(i, balls) }; \
    do for [k=1:balls] { i = order[k]; \
        if (ball_h[i] > -ball_r[i]) { behind = behind.ball(i, divided[i]) }; \
        if (ball_h[i] <= -ball_r[i]) { before = before.ball(i, divided[i]) } \
        else { if (ball_h[i] < ball_r[i]) { before = before.ball(i, "0".divided[i]) } }; \
        names = names.name_at(i, spot(i, 0)) }'

# Around a hit on a sphere that is too large to draw (a ground): '@patches', drawn first.
patches = '$patches index 0 using @point:(pale($4)) with filledcurves closed fc rgb variable fs solid noborder title "patches", \
    $patches index 0 using @point with @hair lc rgb grey title "patches, outline", \
    $patch_names index 0 using @point:(ball_name($4)) with labels tc rgb ink title "patches, names",'
in_part(_) = patched ? own("Of a sphere that is not drawn as a whole there is what is round the hit.")." " : ""

# A ray's bold part, if it is visible.
bold = "(X($1,$2,$3)):($5 == 1 && seen($1,$2,$3) ? Y($1,$2,$3) : NaN)"
# The picture on the image plane, seen from the front: at the upper left of the canvas. After '@seen_front', '@front' are places
# of the plane in it.
front_size = 150.0
seen_front = 'corner(i, part) = real(word($plane[i + 1], part)); \
    side(i, j) = sqrt(sum [part=1:3] (corner(i, part) - corner(j, part))**2); front_scale = front_size / most(side(1, 2), side(2, 3)); \
    front_right = along_right(corner(1, 1), corner(1, 2), corner(1, 3)); front_up = along_up(corner(1, 1), corner(1, 2), corner(1, 3))'
front = "(24 + front_scale * (along_right($1,$2,$3) - front_right)):(height - 112 - front_scale * (front_up - along_up($1,$2,$3)))"
front_plane = '$plane index 0 using @front with filledcurves closed fc rgb surface fs solid noborder title "picture",'
front_pixels = '$pixels index 0 using @front:4 with filledcurves closed fc rgb variable fs solid noborder title "picture, pixels",'
front_pixel = '$pixel index 0 using @front with filledcurves closed fc rgb int(pixel_rgb) fs solid noborder title "picture, pixel",'
front_lines = '$grid index 0 using @front with @hair lc rgb grey title "picture, grid", \
    $plane index 0 using @front with @lines lc rgb ink title "picture, frame", \
    $once using (24):(height - 96):(own("the picture")) with labels left tc rgb grey title "picture, name"'
