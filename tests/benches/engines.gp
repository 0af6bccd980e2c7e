# engines.gp - spheres against rays per second, log-log, of what tests/benches/engines.c measured.
#
# gnuplot -e "csv='FILE.csv'; threads=1" engines.gp > FILE.svg
# Filled marks and full lines: the three spheres and sphereflakes; hollow and broken: random spheres.
# Bars: the quartiles. Of Embree's own spheres in packets of 8 and of 16 one is enough: they are alike.
if (!exists("threads")) threads = 1
set terminal svg size 960, 560 font "sans,13" background "white"
set datafile separator ","
set logscale xy
set format x "10^{%T}"
set format y "10^{%T}"
set xlabel "spheres"
set ylabel sprintf("rays per second, %d thread%s", threads, threads == 1 ? "" : "s")
set xrange [2:1.5e6]
set key outside right center Left reverse samplen 3 spacing 1.3
set grid lc rgb "#dddddd"
names  = "bins tiles packet bvh object plain embree-user embree-16 tachyon povray"
labels = "bins tiles packet bvh object plain 'Embree, callback' 'Embree, spheres' Tachyon POV-Ray"
colors = "#0072b2 #d55e00 #e69f00 #009e73 #cc79a7 #000000 #555555 #555555 #999999 #999999"
filled(i) = int(word("7 5 9 13 11 15 7 5 9 13", i))
color(i) = word(colors, i)
rows(random, i) = sprintf("< awk -F, '($1 ~ /^random/) == %d && $3 == \"%s\" && $4 == %d' '%s' | sort -t, -k2n", random, word(names, i), threads, csv)
is_there(i) = system(sprintf("awk -F, '$3 == \"%s\" { n = 1 } END { print n + 0 }' '%s'", word(names, i), csv)) + 0
there = ""
do for [i = 1:words(names)] { if (is_there(i)) { there = there . " " . i } }
n(k) = int(word(there, k))
plot for [random = 0:1] for [k = 1:words(there)] rows(random, n(k)) using 2:8:9:10 with yerrorbars lc rgb color(n(k)) pt 0 ps 0 notitle, \
     for [k = 1:words(there)] rows(0, n(k)) using 2:8 with linespoints lc rgb color(n(k)) lw 2 pt filled(n(k)) ps 0.8 title word(labels, n(k)), \
     for [k = 1:words(there)] rows(1, n(k)) using 2:8 with linespoints lc rgb color(n(k)) lw 1.5 dt 2 pt filled(n(k)) - 1 ps 0.9 notitle
