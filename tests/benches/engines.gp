# engines.gp - spheres against rays per second, log-log, of what tests/benches/engines.c measured.
#
# gnuplot -e "csv='FILE.csv'; threads=1" engines.gp > FILE.svg
# Full lines: the three spheres and sphereflakes; broken: random spheres. Bars: the quartiles.
if (!exists("threads")) threads = 1
set terminal svg size 900, 600 font "sans,13" background "white"
set datafile separator ","
set logscale xy
set format x "10^{%T}"
set format y "10^{%T}"
set xlabel "spheres"
set ylabel "rays per second, 1920 x 1080"
set title sprintf("%d thread%s", threads, threads == 1 ? "" : "s")
set key outside right top Left reverse
set grid
names = system(sprintf("awk -F, 'NR > 1 && !seen[$3]++ { print $3 }' '%s'", csv))
rows(random, name) = sprintf("< awk -F, '($1 ~ /^random/) == %d && $3 == \"%s\" && $4 == %d' '%s' | sort -t, -k2n", random, name, threads, csv)
plot for [i = 1:words(names)] rows(0, word(names, i)) using 2:8 with lines lt i lw 2 title word(names, i), \
     for [i = 1:words(names)] rows(0, word(names, i)) using 2:8:9:10 with yerrorbars lt i pt 7 ps 0.5 notitle, \
     for [i = 1:words(names)] rows(1, word(names, i)) using 2:8 with lines lt i lw 2 dashtype 2 notitle, \
     for [i = 1:words(names)] rows(1, word(names, i)) using 2:8:9:10 with yerrorbars lt i pt 6 ps 0.5 notitle
