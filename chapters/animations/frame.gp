# frame.gp - what every animation begins with, after plot.gp: frames of 1280 x 720, and large text.
#
# Text is 24 units of the canvas' 540 high or more, small letters too. A layout says how many steps it has, how
# many it shows in a second (rate), and which of them a lecturer stops at (stops).
unset output
if (format eq "png") {
    set terminal pngcairo size 1280,720 font "DejaVu Sans,24" enhanced linewidth 1.5 pointscale 4 dashlength 0.7 \
        background rgb background
}
if (format eq "svg") { set terminal svg size 960,540 font "DejaVu Sans,24" enhanced background rgb background }
set output format eq "txt" ? "/dev/null" : output.".".format
# Larger text, mathematics in it or not. (The SVG of gnuplot 5.4 forgets a size after a change of font that has
# none.)
slim(s) = strstrt(s, ":Italic ") == 0 ? s : \
    s[1:strstrt(s, ":Italic ")+6]."*0.99".slim(s[strstrt(s, ":Italic ")+7:*])
large(s) = s eq "" ? "" : sprintf("{/*1.25 %s}", slim(s))
# All frames are seen from the same place: '@see' chooses scale and place so that $fit fills the room left, right,
# bottom, top of the canvas; '@flat', so that low_x .. high_x by low_y .. high_y does.
see = 'set autoscale; stats $fit using (seen_x($1,$2,$3)-$4):(seen_y($1,$2,$3)-$4) name "low" nooutput; \
    stats $fit using (seen_x($1,$2,$3)+$4):(seen_y($1,$2,$3)+$4) name "high" nooutput; \
    low_x = low_min_x; high_x = high_max_x; low_y = low_min_y; high_y = high_max_y; @flat; scale = size[panel]; \
    set xrange [0:width]; set yrange [-strip:height]'
flat = 'flat_w = width * (word(room, 2) - word(room, 1)); flat_h = height * (word(room, 4) - word(room, 3)); \
    size[panel] = least(flat_w / (high_x - low_x), flat_h / (high_y - low_y)); \
    zero_x[panel] = width * (word(room, 1) + word(room, 2)) / 2 - size[panel] * (low_x + high_x) / 2; \
    zero_y[panel] = height * (word(room, 3) + word(room, 4)) / 2 - size[panel] * (low_y + high_y) / 2'
# A number in a text that moves, as figures show it when it rests: at most three decimals, and a minus sign.
shown(x) = (x < -0.0005 ? "−" : "").sprintf("%.4g", floor(1000 * abs(x) + 0.5) / 1000.0)
# A number in a row of a block: $name[k + 1] is row k, after the comment in its first line.
cell(row, column) = real(word(row, column))
whole(row, column) = int(cell(row, column))
# Around what is outlined in a picture: seen on every color, '@halo' below '@thick'.
halo = "lines lw 5 lc rgb background"
# Two halves of a frame: the scene, and the picture that is being made.
scene_room = "0.035 0.65 0.17 0.95"
picture_x = 800
picture_y = 320
picture_size = 270.0
# '@place_picture' chooses the size of its pixels, which are squares, and its place. Of 'sets', the first 'done' are shown.
place_picture = 'side = picture_size / most(columns, rows); left = picture_x - side * columns / 2; \
    upper = picture_y + side * rows / 2'
in_picture = "(left+side*($5+0.5)):(upper-side*($6+0.5)):(left+side*$5):(left+side*($5+1)):(upper-side*($6+1)):(upper-side*$6)"
plane_and_pixels = '$plane using @point with filledcurves closed fc rgb surface fs solid noborder title "surface", \
    for [k=0:done-1] $sets every :::k::k using @point:4 with filledcurves closed fc rgb variable fs solid noborder \
        title "pixels", \
    $grid using @point with @hair lc rgb grey title "grid", \
    $plane using @point with @lines lc rgb ink title "plane",'
eye_and_picture = '$eye using @point with @dot lc rgb blue title "eye", \
    $eye using @point:(own("eye")) with labels left tc rgb blue offset -1,-1 title "eye, label", \
    $square using (left+side*columns*$1):(upper-side*rows*$2) with filledcurves closed fc rgb surface fs solid noborder \
        title "picture", \
    for [_=1:done>0] $sets every 1:1:0:0:0:(done-1) using @in_picture:4 with boxxyerror fc rgb variable fs solid noborder \
        title "picture, pixels", \
    $square using (left+side*columns*$1):(upper-side*rows*$2) with @lines lc rgb ink title "picture, outline", \
    $once using (picture_x):(upper + 26):(own("the picture")) with labels tc rgb ink title "picture, name",'
