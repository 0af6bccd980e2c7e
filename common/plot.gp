# plot.gp - what every figure begins with: formats, themes, text, projection.
#
#   gnuplot NAME.gp                                      draws NAME.svg, light, 16:9
#   gnuplot -e 'format="png"; theme="dark"' NAME.gp
#
# What can be said with -e: format svg, pdf, png, tex (cairolatex) or txt (the figure in words); theme
# light or dark; shape 16:9 or 4:3; step (what is drawn up to there); output (the file, without its
# ending); background (a colour); azimuth, elevation (degrees: from where it is seen).
if (!exists("format")) format = "svg"
if (!exists("theme")) theme = "light"
if (!exists("shape")) shape = "16:9"
if (!exists("step")) step = 1000
if (!exists("output")) output = name
set encoding utf8
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
tex = format eq "tex"
# Text, lines and points come out at other sizes in each terminal: these make them one.
cairo = format eq "png" || format eq "pdf" || tex
if (format eq "svg") {
    set terminal svg size width,height font "DejaVu Sans,17" enhanced background rgb background
    set output output.".svg"
}
if (format eq "pdf") {
    set terminal pdfcairo size (width / 60.0) cm,(height / 60.0) cm font "DejaVu Sans,6.02" fontscale 1 \
        enhanced linewidth 0.945 background rgb background
    set output output.".pdf"
}
if (format eq "png") {
    set terminal pngcairo size 2 * width,2 * height font "DejaVu Sans,25.5" enhanced linewidth 2 pointscale 4 dashlength 0.5 \
        background rgb background
    set output output.".png"
}
if (tex) {
    # The slides' own font, as large as the others' looks; \small and \large beside it. Labels are made fit
    # for LaTeX by .make/figure-tex.awk.
    set terminal cairolatex pdf input colortext header '\def\small{\fontsize{7.5}{9}\selectfont}\
\def\large{\fontsize{11}{13}\selectfont}\fontsize{9}{11}\selectfont' size (width / 60.0) cm,(height / 60.0) cm \
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
set yrange [0:height]

# ---- text -----------------------------------------------------------------------------------------

# Letters in italics, all else upright: math("d f − ½ w r"). In LaTeX, its own mathematics.
is_letter(c) = strstrt("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ", c) > 0
italic(s) = strlen(s) == 0 ? "" : \
    (is_letter(s[1:1]) ? "{/'DejaVu Serif':Italic ".s[1:1]."}" : s[1:1]).italic(s[2:*])
math(s) = tex ? "$".s."$" : italic(s)
# Smaller and larger text, mathematics in it or not. (LaTeX's terminal takes a label that begins with a
# brace for something else; .make/figure-tex.awk drops the bar.)
sized(s, by) = s eq "" ? "" : (tex ? "¦" : "").sprintf("{/*%g %s}", by, s)
small(s) = sized(s, 0.8)
large(s) = sized(s, 1.25)

# ---- steps, and what is yours ---------------------------------------------------------------------

# A layout says how many steps it has: steps = 5.
steps = 1
# In a plot: '@step2 ...' is drawn from step 2 on; '@who $DATA index who ...' draws what is right and,
# where there is something wrong, yours beside it, dashed.
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
dimension = sprintf("vectors heads filled size %g,16,90 lw 1", 8)
dot = sprintf("points pt 7 ps %g", 0.55)
ring = sprintf("points pt 6 ps %g lw 2", 0.55)

# ---- projection: from the right side of the camera, a little behind and above it -------------------

# across and above are the paper's two directions, near points out of it. They are unit vectors,
# at right angles, made of the camera's own: right, up, forward.
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
X(x, y, z) = middle_x + scale * (seen_x(x, y, z) - center_x)
Y(x, y, z) = middle_y + scale * (seen_y(x, y, z) - center_y)

# '@see' chooses scale and center so that $fit fills the room left, right, bottom, top of the canvas.
room = "0.10 0.90 0.12 0.82"
see = 'set autoscale; stats $fit using (seen_x($1,$2,$3)-$4):(seen_y($1,$2,$3)-$4) name "low" nooutput; \
    stats $fit using (seen_x($1,$2,$3)+$4):(seen_y($1,$2,$3)+$4) name "high" nooutput; \
    center_x = (low_min_x + high_max_x) / 2; center_y = (low_min_y + high_max_y) / 2; \
    middle_x = width * (word(room, 1) + word(room, 2)) / 2; \
    middle_y = height * (word(room, 3) + word(room, 4)) / 2; \
    scale = width * (word(room, 2) - word(room, 1)) / (high_max_x - low_min_x); \
    tall = height * (word(room, 4) - word(room, 3)) / (high_max_y - low_min_y); \
    scale = scale < tall ? scale : tall; set xrange [0:width]; set yrange [0:height]'

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
panel = 1
flat = 'flat_w = width * (word(room, 2) - word(room, 1)); flat_h = height * (word(room, 4) - word(room, 3)); \
    size[panel] = flat_w / (high_x - low_x); tall = flat_h / (high_y - low_y); \
    size[panel] = size[panel] < tall ? size[panel] : tall; \
    zero_x[panel] = width * (word(room, 1) + word(room, 2)) / 2 - size[panel] * (low_x + high_x) / 2; \
    zero_y[panel] = height * (word(room, 3) + word(room, 4)) / 2 - size[panel] * (low_y + high_y) / 2'
U(panel, x) = zero_x[panel] + size[panel] * x
V(panel, y) = zero_y[panel] + size[panel] * y

# ---- the end --------------------------------------------------------------------------------------

# A layout says title and description before it plots; a figure in words is just these.
finish = 'unset output; \
    if (format eq "txt") { set print output.".txt"; print title; print ""; print description; unset print }'

# Where something is wrong, a word on what is dashed.
legend = 'if (wrong) { set label 99 "solid: right, dashed: yours" at width - 16, 16 right tc rgb grey front }'
