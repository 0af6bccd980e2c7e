# plot.gp - what every figure begins with: formats, themes, text, projection.
#
#   gnuplot NAME.gp                                      draws NAME.svg, light, 16:9
#   gnuplot -e 'format="png"; theme="dark"' NAME.gp
#
# Settings for -e: format svg, pdf, png, tex (cairolatex) or txt (the figure in words); theme
# light or dark; shape 16:9 or 4:3; step (what is drawn up to there); output (the file, without its
# ending); background (a colour); azimuth, elevation (degrees: from where it is seen).
if (!exists("format")) format = "svg"
if (!exists("theme")) theme = "light"
if (!exists("shape")) shape = "16:9"
if (!exists("step")) step = 1000
if (!exists("output")) output = name
if (!exists("wrong")) wrong = 0
if (!exists("note")) note = ""
# In units of the canvas. A figure that says 24 has its labels placed by C (common/figure/plot_view.c).
placed = exists("text_size")
if (!placed) text_size = 17
# In another locale (C, say) gnuplot warns that it has no degree sign, which no figure needs. Version 6 can
# be asked not to; before it, the warning is harmless, and LC_ALL=C.UTF-8 avoids it.
if (GPVAL_VERSION >= 6) eval "unset warnings"
set encoding utf8
if (GPVAL_VERSION >= 6) eval "set warnings"
set minussign
set macros

# ---- theme: each colour has a contrast of 4.5 or more on its background --------------------------

dark = theme eq "dark"
if (!exists("background")) background = dark ? "#16191d" : "#ffffff"
ink = dark ? "#e8eaed" : "#1a1c20"
grey = dark ? "#9aa3ad" : "#626a73"
faint = dark ? "#3c434b" : "#d0d6dc"
surface = dark ? "#252b33" : "#edf1f5"
blue = dark ? "#64b5f0" : "#0069a8"
orange = dark ? "#f79454" : "#b84a00"
green = dark ? "#3ecb9c" : "#00775a"
pink = dark ? "#e893c6" : "#a03a7c"

# ---- the canvas: 1 unit is 1/540 of its height, from the lower left, in every format -------------

width = shape eq "4:3" ? 720 : 960
height = 540
# Words in lines of at most n letters; how many lines.
cut(s, n) = n <= 1 ? strlen(s) + 1 : s[n:n] eq " " ? n : cut(s, n - 1)
wrap(s, n) = strlen(s) <= n ? s : s[1:cut(s, n + 1) - 1]."\n".wrap(s[cut(s, n + 1) + 1:*], n)
lines_of(s, n) = strlen(s) <= n ? 1 : 1 + lines_of(s[cut(s, n + 1) + 1:*], n)
# Below the canvas, where something is wrong, a strip for words on it.
note_room = (width - 220) / 8
strip_lines = lines_of(note, note_room)
strip = wrong ? 24 + 18 * (strip_lines > 2 ? strip_lines : 2) : 0
tall_cm = (height + strip) / 60.0
tex = format eq "tex"
# Text, lines and points come out at other sizes in each terminal: these make them one.
cairo = format eq "png" || format eq "pdf" || tex
if (format eq "svg") {
    set terminal svg size width,(height + strip) font sprintf("DejaVu Sans,%d", text_size) enhanced background rgb background
    set output output.".svg"
}
if (format eq "pdf") {
    set terminal pdfcairo size (width / 60.0) cm,tall_cm cm font sprintf("DejaVu Sans,%.2f", 0.3541 * text_size) fontscale 1 \
        enhanced linewidth 0.945 background rgb background
    set output output.".pdf"
}
if (format eq "png") {
    set terminal pngcairo size 2 * width,2 * (height + strip) font sprintf("DejaVu Sans,%.1f", 1.5 * text_size) enhanced linewidth 2 \
        pointscale 4 dashlength 0.5 \
        background rgb background
    set output output.".png"
}
if (tex) {
    # The slides' own font, as large as the others' looks; \small and \large beside it. Labels are made fit
    # for LaTeX by chapters/gallery/latex_picture.c.
    points = text_size == 17 ? 9 : text_size / 2.0
    set terminal cairolatex pdf input colortext header sprintf('\def\small{\fontsize{%g}{%g}\selectfont}\
\def\large{\fontsize{%g}{%g}\selectfont}\fontsize{%g}{%g}\selectfont', points / 1.2, points, points * 1.22, \
        points * 1.44, points, points * 1.22) size (width / 60.0) cm,tall_cm cm \
        linewidth 1.89 background rgb background
    set output output.".tex"
}
if (format eq "txt") {
    set terminal dumb
    set output "/dev/null"
}
unset border
unset tics
unset key
set lmargin at screen 0
set rmargin at screen 1
set bmargin at screen 0
set tmargin at screen 1
set xrange [0:width]
set yrange [-strip:height]

# ---- text -----------------------------------------------------------------------------------------

# Letters in italics, all else upright: math("d f − ½ w r"). In LaTeX, its own mathematics.
is_letter(c) = strstrt("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ", c) > 0
italic(s) = strlen(s) == 0 ? "" : \
    (is_letter(s[1:1]) ? "{/'DejaVu Serif':Italic ".s[1:1]."}" : s[1:1]).italic(s[2:*])
math(s) = tex ? "$".s."$" : italic(s)
# Smaller and larger text, mathematics in it or not. (LaTeX's terminal takes a label that begins with a
# brace for something else; chapters/gallery/latex_picture.c drops the bar.)
sized(s, by) = s eq "" ? "" : (tex ? "¦" : "").sprintf("{/*%g %s}", by, slim(s))
# The SVG of gnuplot 5.4 forgets a size after a change of font that has none.
slim(s) = strstrt(s, ":Italic ") == 0 ? s : \
    s[1:strstrt(s, ":Italic ")+6]."*0.99".slim(s[strstrt(s, ":Italic ")+7:*])
small(s) = sized(s, 0.8)
large(s) = sized(s, 1.25)

# ---- steps, and what is yours ---------------------------------------------------------------------

# A layout says how many steps it has: steps = 5.
steps = 1
# In a plot: '@step2 ...' is drawn from step 2 on; '@who $DATA index who ...' draws what is right and,
# if something is wrong, yours beside it, dashed.
step2 = "for [_=2:step:1000]"
step3 = "for [_=3:step:1000]"
step4 = "for [_=4:step:1000]"
step5 = "for [_=5:step:1000]"
step6 = "for [_=6:step:1000]"
who = "for [who=0:wrong]"
dash(who) = who == 0 ? 1 : 2

# ---- looks: with vectors @arrow, with points @dot --------------------------------------------------

lines = "lines lw 1.2"
thick = "lines lw 2.2"
hair = "lines lw 0.8"
arrow = sprintf("vectors head filled size %g,18,90 lw 2.2", 12)
thin_arrow = sprintf("vectors head filled size %g,18,90 lw 1.2", 9)
dimension = sprintf("vectors heads filled size %g,16,90 lw 1", 8)
# Without a head; of the world; and a plane that lets the things behind it shine through.
leg = "vectors nohead lw 1.2"
axis = sprintf("vectors head filled size %g,18,90 lw 1", 9)
glass = "transparent solid 0.6"
dot = sprintf("points pt 7 ps %g", 0.55)
ring = sprintf("points pt 6 ps %g lw 2", 0.55)

# ---- projection: from the right side of the camera, a little behind and above it -------------------

# across and above are the paper's two directions, near points out of it. They are unit vectors,
# at right angles, made of the camera's own: right, up, forward.
# A layout may turn it: if (!turned) azimuth = 40.
turned = exists("azimuth")
if (!exists("azimuth")) azimuth = 28
if (!exists("elevation")) elevation = 16
set angles degrees
across(r, f) = cos(azimuth) * f + sin(azimuth) * r
above(r, u, f) = cos(elevation) * u - sin(elevation) * (cos(azimuth) * r - sin(azimuth) * f)
near(r, u, f) = sin(elevation) * u + cos(elevation) * (cos(azimuth) * r - sin(azimuth) * f)

# Coordinates of the world in units of the world, seen from there; then on the canvas.
along_right(x, y, z) = right_x * x + right_y * y + right_z * z
along_up(x, y, z) = up_x * x + up_y * y + up_z * z
along_forward(x, y, z) = forward_x * x + forward_y * y + forward_z * z
seen_x(x, y, z) = across(along_right(x, y, z), along_forward(x, y, z))
seen_y(x, y, z) = above(along_right(x, y, z), along_up(x, y, z), along_forward(x, y, z))
seen_near(x, y, z) = near(along_right(x, y, z), along_up(x, y, z), along_forward(x, y, z))
X(x, y, z) = placed ? zero_x[panel] + size[panel] * seen_x(x, y, z) : \
    shift_x[panel] + middle_x + scale * (seen_x(x, y, z) - center_x)
Y(x, y, z) = placed ? zero_y[panel] + size[panel] * seen_y(x, y, z) : \
    shift_y[panel] + middle_y + scale * (seen_y(x, y, z) - center_y)
# Several pictures side by side: panel 2 is panel 1 moved by shift_x[2] to the right and
# shift_y[2] up; '@panel2 $DATA using @point ...' draws in it.
panel = 1
array shift_x[8]
array shift_y[8]
do for [i = 1:8] { shift_x[i] = 0; shift_y[i] = 0 }
panel2 = "for [panel=2:2]"
panel3 = "for [panel=3:3]"
panel4 = "for [panel=4:4]"

# '@see' chooses scale and center so that $fit fills the room left, right, bottom, top of the canvas.
room = "0.10 0.90 0.12 0.82"
see = 'set autoscale; stats $fit using (seen_x($1,$2,$3)-$4):(seen_y($1,$2,$3)-$4) name "low" nooutput; \
    stats $fit using (seen_x($1,$2,$3)+$4):(seen_y($1,$2,$3)+$4) name "high" nooutput; \
    center_x = (low_min_x + high_max_x) / 2; center_y = (low_min_y + high_max_y) / 2; \
    middle_x = width * (word(room, 1) + word(room, 2)) / 2; \
    middle_y = height * (word(room, 3) + word(room, 4)) / 2; \
    scale = width * (word(room, 2) - word(room, 1)) / (high_max_x - low_min_x); \
    tall = height * (word(room, 4) - word(room, 3)) / (high_max_y - low_min_y); \
    scale = scale < tall ? scale : tall; set xrange [0:width]; set yrange [-strip:height]'

# Columns of data as places on the canvas: x y z, or x y z and a vector dx dy dz.
point = "(X($1,$2,$3)):(Y($1,$2,$3))"
vector = "(X($1,$2,$3)):(Y($1,$2,$3)):(scale*seen_x($4,$5,$6)):(scale*seen_y($4,$5,$6))"
tip = "(X($1+$4,$2+$5,$3+$6)):(Y($1+$4,$2+$5,$3+$6))"
half_way = "(X($1+$4/2,$2+$5/2,$3+$6/2)):(Y($1+$4/2,$2+$5/2,$3+$6/2))"

# ---- flat: a figure in two dimensions, or several of them side by side ------------------------------

# '@flat' maps low_x .. high_x by low_y .. high_y into the room, equal in both directions, as panel
# number 'panel'; then U(panel, x) and V(panel, y) are places on the canvas, size[panel] is one unit.
array zero_x[8]
array zero_y[8]
array size[8]
flat = 'flat_w = width * (word(room, 2) - word(room, 1)); flat_h = height * (word(room, 4) - word(room, 3)); \
    size[panel] = flat_w / (high_x - low_x); tall = flat_h / (high_y - low_y); \
    size[panel] = size[panel] < tall ? size[panel] : tall; \
    zero_x[panel] = width * (word(room, 1) + word(room, 2)) / 2 - size[panel] * (low_x + high_x) / 2; \
    zero_y[panel] = height * (word(room, 3) + word(room, 4)) / 2 - size[panel] * (low_y + high_y) / 2'
U(panel, x) = zero_x[panel] + size[panel] * x
V(panel, y) = zero_y[panel] + size[panel] * y

# ---- flat: axes, single marks, and what is yours -------------------------------------------------------

# '$once using (x):(y) ...' draws one mark at a place that the layout computes.
$once << EOD
0
EOD
$square << EOD
# the corners of the unit square, from the lower left on
0 0
1 0
1 1
0 1
0 0
EOD
stroke = "vectors nohead lw 2.2"
least(a, b) = a < b ? a : b
most(a, b) = a > b ? a : b

# A point that is yours is a ring beside the right one's dot: pt mark(who).
mark(who) = who == 0 ? 7 : 6
# Your result in words, if it is wrong: your("place_text"); else nothing.
your(name) = exists("your_".name) ? value("your_".name) : ""

# ---- labels: on the canvas, whatever the numbers ----------------------------------------------------

# How long a text is at most, in units of the canvas; and where to anchor it, at x, or as near to x as
# the canvas allows: its left end, its middle, its right end.
# (percent is for labels of plots, where gnuplot reads a backslash twice.)
small_size = 14
long(text, size) = 0.6 * size * strlen(text)
between(low, x, high) = x < low ? low : x > high ? high : x
left_at(x, long) = between(12, x, width - 12 - long)
middle_at(x, long) = between(12 + long / 2, x, width - 12 - long / 2)
right_at(x, long) = between(12 + long, x, width - 12)
percent = tex ? '\\%' : "%"

# Places on the canvas, to add to: a point's, a vector's tip, its middle; what a vector adds to a place;
# and where the name of an arrow stands.
point_x = "X($1,$2,$3)"
point_y = "Y($1,$2,$3)"
tip_x = "X($1+$4,$2+$5,$3+$6)"
tip_y = "Y($1+$4,$2+$5,$3+$6)"
half_x = "X($1+$4/2,$2+$5/2,$3+$6/2)"
half_y = "Y($1+$4/2,$2+$5/2,$3+$6/2)"
moved = "(scale*seen_x($4,$5,$6)):(scale*seen_y($4,$5,$6))"
beyond = "(X($1+1.2*$4,$2+1.2*$5,$3+1.2*$6)):(Y($1+1.2*$4,$2+1.2*$5,$3+1.2*$6))"

# '@labels', last in a plot: those that C has placed, with their leaders.
labels = 'for [i=1:label_count] $once using (leader_u[i]):(step < label_step[i] ? 1e9 : leader_v[i]):(leader_du[i]):(leader_dv[i]) \
    with vectors nohead lw 0.8 lc rgb label_color[i] title "leader", \
    for [i=1:label_count] $once using (label_u[i]):(label_v[i]):(label_is_left[i] || step < label_step[i] ? "" : label_text[i]) \
    with labels tc rgb label_color[i] title label_title[i], \
    for [i=1:label_count] $once using (label_u[i]):(label_v[i]):(label_is_left[i] && step >= label_step[i] ? label_text[i] : "") \
    with labels left tc rgb label_color[i] title label_title[i]'

# ---- yours beside the right one --------------------------------------------------------------------

# Small letters, the same in every format.
small_font = format eq "png" ? ",20.5" : format eq "pdf" ? ",4.84" : ",13.7"

# '@beside' writes down, at the upper left, what is right, what is yours, by how much it is off, and why.
why = ""
beside_x = 24
beside_room = 36
beside = 'set label 90 "right:" at beside_x, height - 36 left tc rgb blue front; \
    set label 91 answer_text at beside_x + 64, height - 36 left noenhanced tc rgb blue front; \
    set label 92 "yours:" at beside_x, height - 62 left tc rgb orange front; \
    set label 93 yours_text at beside_x + 64, height - 62 left noenhanced tc rgb orange front; \
    set label 94 off_text at beside_x, height - 88 left noenhanced font small_font tc rgb ink front; \
    set label 95 wrap(why, beside_room) at beside_x, height - (off_text eq "" ? 88 : 112) left noenhanced font small_font tc rgb grey front'
# The same for readers who do not see it.
beside_words(_) = sprintf("Right is %s; yours, drawn dashed, is %s%s.", answer_text, yours_text, \
    off_text eq "" ? "" : ", ".off_text).(why eq "" ? "" : " ".why)

# ---- the end --------------------------------------------------------------------------------------

# A layout says title and description before it plots; a figure in words is just these.
differs = " Some of it differs from what is right: that is drawn dashed, beside what is right."
say = 'print title; print ""; print description.(wrong ? differs : "").(wrong && note ne "" ? " ".note : "")'
finish = 'unset output; if (format eq "txt") { set print output.".txt"; @say; unset print }'

# If something is wrong, words about the dashed lines, and the reason.
legend = 'if (wrong) { \
    set arrow 99 from 0, 0 to width, 0 nohead lc rgb faint lw 1; \
    set label 99 "solid: right\ndashed: yours" at width - 16, -24 right font small_font tc rgb grey front; \
    set label 98 wrap(note, note_room) at 16, -24 left noenhanced font small_font tc rgb ink front }'
