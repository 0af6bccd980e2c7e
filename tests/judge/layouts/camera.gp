# camera.gp - a camera by its three steps from the eye, and another one dashed beside it.
title = asked.": yours beside the right one"
description = sprintf("A camera's steps from its eye at %s: d f ahead, w r aside, h u up. ", eye_text).beside_words(0)
steps = 2
step_name(i) = i == 0 ? "d f" : i == 1 ? "w r" : "h u"
step_color(i) = i == 0 ? pink : i == 1 ? orange : green

plot for [i=0:2] $answer every ::i::i using @vector with @arrow lc rgb step_color(i) title "right ".step_name(i), \
    for [i=0:2] @step2 $yours every ::i::i using @vector with @arrow lc rgb step_color(i) dt 2 title "yours ".step_name(i), \
    @step2 $yours every ::0::0 using @point with @ring lc rgb ink title "yours, eye", \
    $eye using @point with @dot lc rgb blue title "eye", \
    @labels
