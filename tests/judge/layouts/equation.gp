# equation.gp - a quadratic as its parabola over the t axis: its roots, or another quadratic.
title = asked.": yours beside the right one"
description = sprintf("The parabola f(t) of the quadratic with %s, over the t axis. ", equation_text).beside_words(0)
steps = 2
beside_room = width / 8
@beside
minus(x) = x < 0 ? sprintf("−%g", -x) : sprintf("%g", x)
# Both axes have scales of their own here.
across(t) = width * (0.07 + 0.84 * (t - low) / (high - low))
upward(f) = height * (0.14 + 0.50 * (f - bottom) / (top - bottom))
$here << EOD
0
EOD
two = are_roots ? "for [_=1:0]" : "for [_=0:0]"
plot $here using (across(low)):(upward(0)):(across(high)-across(low)):(0) with vectors head filled size 9,18,90 lw 1 lc rgb grey title "axis", \
    $here using (across(high)):(upward(0)):(math("t")) with labels left offset 0.8,0 tc rgb grey title "t", \
    $ticks using (across($2)):(upward(0)-4):(0):(8) with vectors nohead lw 1 lc rgb grey title "ticks", \
    $ticks using (across($2)):(upward(0)):(minus($1)) with labels font small_font offset 0,-0.9 tc rgb grey title "tick, label", \
    $curve using (across($1)):(upward($2)) with @thick lc rgb (are_roots ? green : blue) title "curve", \
    @two @step2 $your_curve using (across($1)):(upward($2)) with @thick lc rgb orange dt 2 title "your curve", \
    $answer using (across($2)):(upward(0)) with @dot lc rgb blue title "right", \
    $answer using (across($2)):(upward(0)):("right") with labels font small_font offset 0,1.2 tc rgb blue title "right, label", \
    @step2 $yours using (across($2)):(upward(0)):(0):(-52) with vectors nohead lw 1.2 dt 2 lc rgb orange title "yours, line", \
    @step2 $yours using (across($2)):(upward(0)) with @ring lc rgb orange title "yours", \
    @step2 $yours using (across($2)):(upward(0)):("yours") with labels font small_font offset 0,-3.6 tc rgb orange title "yours, label"
