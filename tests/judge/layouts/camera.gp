# camera.gp - a camera by its three steps from the eye, and another one dashed beside it.
title = asked.": yours beside the right one"
description = sprintf("A camera's steps from its eye at %s: d f ahead, w r aside, h u up. ", eye_text).beside_words(0)
steps = 2

plot $answer every ::0::0 using @vector with @pink_arrow title "right d f", \
    $answer every ::1::1 using @vector with @orange_arrow title "right w r", \
    $answer every ::2::2 using @vector with @green_arrow title "right h u", \
    @step2 $yours every ::0::0 using @vector with @pink_arrow dt 2 title "yours d f", \
    @step2 $yours every ::1::1 using @vector with @orange_arrow dt 2 title "yours w r", \
    @step2 $yours every ::2::2 using @vector with @green_arrow dt 2 title "yours h u", \
    @step2 $yours every ::0::0 using @point with @ring lc rgb ink title "yours, eye", \
    $eye using @point with @dot lc rgb blue title "eye", \
    @labels
