# plot.gp - what every figure begins with: formats, themes, text, projection.
#
#   gnuplot NAME.gp                                      draws NAME.svg, light, 16:9
#   gnuplot -e 'format="png"; theme="dark"' NAME.gp
#
# Settings for -e: format svg, pdf, png, tex (cairolatex) or txt (the figure in words); theme
# light or dark; shape 16:9 or 4:3; step (what is drawn up to there); output (the file, without its
# ending); background (a color).
if (!exists("format")) format = "svg"
if (!exists("theme")) theme = "light"
if (!exists("shape")) shape = "16:9"
if (!exists("step")) step = 1000
if (!exists("output")) output = name
if (!exists("wrong")) wrong = 0
if (!exists("note")) note = ""
# While something is dragged, a figure of many marks has fewer.
if (!exists("dragged")) dragged = 0
# In units of the canvas.
if (!exists("text_size")) text_size = 24
if (!exists("strip_count")) strip_count = 0
# In another locale (C, say) gnuplot warns that it has no degree sign, which no figure needs. Version 6 can
# be asked not to; before it, the warning is harmless, and LC_ALL=C.UTF-8 avoids it.
if (GPVAL_VERSION >= 6) eval "unset warnings"
set encoding utf8
if (GPVAL_VERSION >= 6) eval "set warnings"
set minussign
set macros

# ---- theme: each color has a contrast of 4.5 or more on its background --------------------------

dark = theme eq "dark"
if (!exists("background")) background = dark ? "#16191d" : "#ffffff"
ink = dark ? "#e8eaed" : "#1a1c20"
grey = dark ? "#9aa3ad" : "#626a73"
faint = dark ? "#3c434b" : "#d0d6dc"
surface = dark ? "#252b33" : "#edf1f5"
blue = dark ? "#45a6ed" : "#0069a8"
orange = dark ? "#f79454" : "#b84a00"
green = dark ? "#48cea1" : "#005939"
pink = dark ? "#eba3e0" : "#802e77"

# ---- the canvas: 1 unit is 1/540 of its height, from the lower left, in every format -------------

width = shape eq "4:3" ? 720 : 960
height = 540
# Words in lines of at most n letters: how many, and line k.
cut(s, n) = n <= 1 ? strlen(s) + 1 : s[n:n] eq " " ? n : cut(s, n - 1)
lines_of(s, n) = strlen(s) <= n ? 1 : 1 + lines_of(s[cut(s, n + 1) + 1:*], n)
line_of(s, n, k) = strlen(s) <= n ? s : k == 1 ? s[1:cut(s, n + 1) - 1] : line_of(s[cut(s, n + 1) + 1:*], n, k - 1)
# Below the canvas, a strip for words: paragraphs, strip_text[1] and so on (plot_below); and where something is
# wrong, what the dashes mean. down(i) is how far below it paragraph i ends.
line_height = 1.25 * text_size
strip_room = int((width - 32) / (0.58 * text_size))
down(i) = i < 1 ? 8 : down(i - 1) + line_height * lines_of(strip_text[i], strip_room)
strip = strip_count == 0 && !wrong ? 0 : down(strip_count) + wrong * line_height + 8
tall_cm = (height + strip) / 60.0
tex = format eq "tex"
# Text, lines and points come out at other sizes in each terminal: these make them one.
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
    # for LaTeX by chapters/gallery/latex_picture.py.
    points = text_size / 2.0
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

# Letters in italics, all else upright, and indices smaller: math("d f − ½ w r"), math("t_0"). In LaTeX, its own
# mathematics.
is_letter(c) = strstrt("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ", c) > 0
italic(s) = strlen(s) == 0 ? "" : s[1:1] eq "_" ? "_{".s[2:2]."}".italic(s[3:*]) : \
    (is_letter(s[1:1]) ? "{/'DejaVu Serif':Italic ".s[1:1]."}" : s[1:1]).italic(s[2:*])
math(s) = tex ? "$".s."$" : italic(s)

# Words are said by own("eye"), so that a lecturer can say others: those of own_words.c, if there are any.
if (!exists("own_count")) own_count = 0
own_at(s) = sum [_i=1:own_count] (own_english[_i] eq s ? _i : 0)
own(s) = own_at(s) > 0 ? own_text[own_at(s)] : s

# ---- steps, and what is yours ---------------------------------------------------------------------

# A layout says how many steps it has: steps = 5.
steps = 1
# In a plot: '@step2 ...' is drawn from step 2 on; '@who $DATA index who ...' draws what is right and,
# if something is wrong, yours beside it, dashed.
# gnuplot's plot has no if: 'for [_=1:condition] ...' draws once if the condition is 1, and nothing if it is 0.
do for [n=2:6] { eval sprintf("step%d = 'for [_=%d:step:1000]'", n, n) }
who = "for [who=0:wrong]"
dash(who) = who == 0 ? 1 : 2

# ---- looks: with vectors @arrow, with points @dot --------------------------------------------------

lines = "lines lw 1.2"
thick = "lines lw 2.2"
hair = "lines lw 0.8"
arrow = sprintf("vectors head filled size %g,18,90 lw 2.2", 12)
thin_arrow = sprintf("vectors head filled size %g,18,90 lw 1.2", 9)
dimension = sprintf("vectors heads filled size %g,16,90 lw 1", 8)
# A ray, and its parts that a sphere or the image plane hides: dots that are seen from the last row.
ray = "lines lw 3"
hidden = "lines lw 3 dt (3.4,3)"
# Without a head; of the world; and a plane that lets the things behind it shine through.
segment = "vectors nohead lw 1.2"
axis = sprintf("vectors head filled size %g,18,90 lw 1", 9)
glass = "transparent solid 0.6"
dot = sprintf("points pt 7 ps %g", 0.55)
ring = sprintf("points pt 6 ps %g lw 2", 0.55)

stroke = "vectors nohead lw 2.2"
# In a grey print all hues look alike, so each has an arrowhead and a width of its own: @orange_arrow, @pink_lines, and for blue
# and green, which have one width, '@lines lc rgb green'.
head_of(hue, n) = hue eq "orange" ? sprintf("%g,40,90", 0.85 * n) : hue eq "green" ? sprintf("%g,27,138", 1.05 * n) : \
    sprintf("%g,26,45", 1.25 * n)
weight(hue) = hue eq "orange" ? 1.4 : hue eq "pink" ? 2 : 1
headed(hue, ends, n, w) = sprintf("vectors %s filled size %s lw %g lc rgb %s", ends, head_of(hue, n), w, hue)
weighted(hue, kind, w) = sprintf("%s lw %g lc rgb %s", kind, w * weight(hue), hue)
do for [hue in "orange green pink"] {
    eval hue."_arrow = headed(hue, 'head', 12, 2.2)"
    eval hue."_thin_arrow = headed(hue, 'head', 9, 1.6)"
    eval hue."_dimension = headed(hue, 'heads', 8, 1)"
    eval hue."_segment = weighted(hue, 'vectors nohead', 1.2)"
    eval hue."_stroke = weighted(hue, 'vectors nohead', 2.2)"
    eval hue."_lines = weighted(hue, 'lines', 1.2)"
    eval hue."_thick = weighted(hue, 'lines', 2.2)"
}

# ---- projection: from the right side of the camera, a little behind and above it -------------------

# across and above are the paper's two directions, near points out of it. They are unit vectors,
# at right angles, made of the camera's own: right, up, forward.
azimuth = 28
elevation = 16
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
X(x, y, z) = zero_x[panel] + size[panel] * seen_x(x, y, z)
Y(x, y, z) = zero_y[panel] + size[panel] * seen_y(x, y, z)
# Several pictures side by side are panels 1 to 8; C says where each is, and how large
# (common/figure/plot_view.c). '@panel2 $DATA using @point ...' draws in one. In a flat one, U(panel, x) and
# V(panel, y) are places on the canvas, and size[panel] is one unit.
array zero_x[8]
array zero_y[8]
array size[8]
panel = 1
do for [n=2:4] { eval sprintf("panel%d = 'for [panel=%d:%d]'", n, n, n) }
U(panel, x) = zero_x[panel] + size[panel] * x
V(panel, y) = zero_y[panel] + size[panel] * y

# Columns of data as places on the canvas: x y z, or x y z and a vector dx dy dz.
point = "(X($1,$2,$3)):(Y($1,$2,$3))"
vector = "(X($1,$2,$3)):(Y($1,$2,$3)):(scale*seen_x($4,$5,$6)):(scale*seen_y($4,$5,$6))"
tip = "(X($1+$4,$2+$5,$3+$6)):(Y($1+$4,$2+$5,$3+$6))"
# The same in a flat panel: '$DATA using @flat2 ...' in the second.
do for [n=1:4] {
    eval sprintf("flat%d = '(U(%d,$1)):(V(%d,$2))'", n, n, n)
    eval sprintf("along%d = flat%d.':(size[%d]*$4):(size[%d]*$5)'", n, n, n, n)
}

# ---- single marks, and what is yours -------------------------------------------------------------------

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
least(a, b) = a < b ? a : b
most(a, b) = a > b ? a : b

# A point that is yours is a ring beside the right one's dot: pt mark(who).
mark(who) = who == 0 ? 7 : 6
# Your result in words, if it is wrong: your("place_text"); else nothing.
your(name) = exists("your_".name) ? value("your_".name) : ""

# ---- a line past a circle: its looks ----------------------------------------------------------------

# If your number differs, 1: the number of your marks to draw.
differs(name) = exists("your_".name)
# The root that is the hit is blue, another one ahead of p is ink.
color(t) = abs(t - hit) <= 1e-6 * abs(hit) ? blue : t > 0 ? ink : grey
cross = sprintf("points pt 2 ps %g lw 2", 0.55)
square = sprintf("points pt 4 ps %g lw 2", 0.8)
squares_are_yours = own("solid: expected")."\n".own("dashed, squares: yours")
# Where v itself would be too short or too long to see, the arrow is another one.
arrow_words(stride) = stride == 1 ? "" : sprintf(" ".own("The arrow is %s v."), stride_text)

# ---- pictures, which are PNGs in base64 -------------------------------------------------------------

# gnuplot reads a picture from a file. '@decode' makes that of 'picture' ("$NAME"), number 'cast', and
# '@forget', after the plot, removes all of them. cast_file(number) is its name, cast_title(number, words) the
# title of its plot.
#
# A gnuplot that reads no PNG is given 'framed = 1': the layout then draws each picture's frame ($square) in its
# place, and chapters/book/figure.js puts the picture into it.
if (!exists("framed")) framed = 0
cast_file(number) = sprintf("%s.cast%d", output, number)
cast_title(number, words) = framed ? "picture ".cast_name[number].": ".words : words
casts = ""
array cast_name[2]
decode = 'cast_name[cast] = picture; if (!framed) { casts = casts." \"".cast_file(cast)."\""; \
    set print sprintf("| base64 -d > \"%s\"", cast_file(cast)); \
    do for [line=2:|@picture|] { print @picture[line] }; set print }'
forget = 'if (!framed) { system("rm -f".casts) }'

# ---- labels: on the canvas, whatever the numbers ----------------------------------------------------

# (percent is for labels of plots, where gnuplot reads a backslash twice.)
percent = tex ? '\\%' : "%"

# Places on the canvas, to add to: a point's; and what a vector adds to a place.
point_x = "X($1,$2,$3)"
point_y = "Y($1,$2,$3)"
moved = "(scale*seen_x($4,$5,$6)):(scale*seen_y($4,$5,$6))"

# '@labels', last in a plot: those that C has placed, with their leaders (common/figure/plot_view.c).

# ---- yours beside the right one --------------------------------------------------------------------

# What is right, what is yours, by how much it is off, and why, for readers who do not see it.
why = ""
beside_words(_) = sprintf(own("Expected is %s; yours%s is %s%s."), answer_text, drawn eq "" ? "" : ", ".own("drawn")." ".drawn.",", yours_text, \
    off_text eq "" ? "" : ", ".off_text).(why eq "" ? "" : " ".why)

# ---- the end --------------------------------------------------------------------------------------

# A layout says title and description before it plots; a figure in words is just these.
differs = " ".own("Some of it differs from what is right: that is drawn dashed, beside what is right.")
say = 'print title; print ""; print description.(wrong ? differs : "").(wrong && note ne "" ? " ".note : "")'
finish = 'unset output; if (format eq "txt") { set print output.".txt"; @say; unset print }'

# The words below the canvas. Their labels have high numbers: a layout has labels 1, 2 and so on of its own.
legend = 'if (strip > 0) { set arrow 99 from 0, 0 to width, 0 nohead lc rgb faint lw 1 }; \
    do for [i=1:strip_count] { do for [k=1:lines_of(strip_text[i], strip_room)] { \
        strip_label = 100 * (i + 1) + k; \
        set label strip_label line_of(strip_text[i], strip_room, k) at 16, -down(i - 1) - line_height * (k - 0.5) left noenhanced \
            tc rgb value(strip_color[i]) front } }; \
    if (wrong) { set label 99 own("solid: expected; dashed: yours") at 16, -down(strip_count) - line_height / 2 left tc rgb grey front }'
