# equation.gp - a quadratic as its parabola over the t axis: its roots, or another quadratic.
title = asked.": yours beside the right one"
description = sprintf("The parabola f(t) of the quadratic with %s, over the t axis. ", equation_text).beside_words(0)
steps = 2
two = are_roots ? "for [_=1:0]" : "for [_=0:0]"

plot $axis using @flat1:(size[1]*$4):(size[1]*$5) with @axis lc rgb grey title "axis", \
    $ticks using (U(1,$1)):(V(1,$2)-4):(0):(8) with @segment lc rgb grey title "ticks", \
    $curve using @flat1 with @thick lc rgb (are_roots ? ink : blue) title "curve", \
    @two @step2 $your_curve using @flat1 with @thick lc rgb ink dt 2 title "your curve", \
    $answer using @flat1 with @dot lc rgb blue title "right", \
    @step2 $yours using @flat1 with @ring lc rgb ink title "yours", \
    @labels
