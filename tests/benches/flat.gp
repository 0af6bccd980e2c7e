# flat.gp - spheres against rays per second, log-log, of what tests/benches/flat.c measured.
#
# gnuplot -e "theme='dark'" DATA.gp flat.gp > FILE.svg
# The first file has the data, from tests/benches/tables.py.
# Filled marks and full lines: the three spheres and sphereflakes; hollow and broken: random spheres.
# Bars: the quartiles. Of Embree's own spheres in packets of 8 and of 16 one is enough: they are alike.
if (!exists("theme")) theme = "light"
# The colors are those of the figures (common/figure/plot.gp), and so is the size of text.
dark = theme eq "dark"
ink = dark ? "#e8eaed" : "#1a1c20"
set terminal svg size 960, 600 font "DejaVu Sans,24" enhanced background dark ? "#16191d" : "#ffffff"
set border lc rgb ink
set tics textcolor rgb ink
set logscale xy
# Exponents are as large as the rest.
set format x "10^{/*1.25 %T}"
set format y "10^{/*1.25 %T}"
set ytics 100
set xlabel "spheres" tc rgb ink
set ylabel sprintf("rays per second, %d thread%s", threads, threads == 1 ? "" : "s") tc rgb ink offset -1,0
set lmargin 9
set xrange [2:1.5e6]
set key outside right center Left reverse samplen 1.5 spacing 1.1 tc rgb ink
set grid lc rgb dark ? "#3c434b" : "#d0d6dc"
names  = "bins tiles packet bvh object plain embree-user embree-16 povray"
labels = "bins tiles packet bvh object plain 'Embree, callback' 'Embree, spheres' POV-Ray"
colors = dark ? "#45a6ed #f79454 #e0b83c #48cea1 #eba3e0 #e8eaed #c3c8ce #c3c8ce #9aa3ad" : \
    "#0069a8 #b84a00 #8a6a00 #005939 #802e77 #1a1c20 #4a5058 #4a5058 #626a73"
filled(i) = int(word("7 5 9 13 11 15 7 5 13", i))
color(i) = word(colors, i)
# An engine's number in the list of names, and its block of data.
style_of(engine) = sum [i = 1:words(names)] (word(names, i) eq engine ? i : 0)
there = ""
do for [i = 1:words(names)] { do for [k = 1:words(engines)] { if (word(engines, k) eq word(names, i)) { there = there . " " . k } } }
block(random, k) = sprintf("$engine%s_%d", word(there, k), random)
n(k) = style_of(word(engines, int(word(there, k))))
plot for [random = 0:1] for [k = 1:words(there)] block(random, k) using 1:2:3:4 with yerrorbars lc rgb color(n(k)) pt 0 ps 0 notitle, \
     for [k = 1:words(there)] block(0, k) using 1:2 with linespoints lc rgb color(n(k)) lw 2 pt filled(n(k)) ps 0.8 title word(labels, n(k)), \
     for [k = 1:words(there)] block(1, k) using 1:2 with linespoints lc rgb color(n(k)) lw 1.5 dt 2 pt filled(n(k)) - 1 ps 0.9 notitle
