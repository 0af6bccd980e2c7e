# camera-forms.gp - four ways to give a camera (slide 'Other camera representations'), and the camera
# that is found from each: its plane, and its frame r, u, f at the middle.
title = own("Four other ways to give a camera")
description = sprintf(own("Four panels show one camera with the eye at %s, given in four ways. Look-at: the look-at point %s, \
the up vector %s, the width %s and the aspect ratio %s. Four points: the corners of the image plane. \
Corner and vectors: the lower left corner %s and two vectors, %s across and %s up. \
Four vectors: those from the eye to the corners. \
Each gives an image plane, and a frame r, u, f at its middle. \
From the look-at: %s. From four points: %s. From corner and vectors: %s. From four vectors: %s."), \
    eye_text, at_text, look_up_text, w_text, aspect_text, lower_left_text, across_text, upward_text, \
    look_at_found_text, points_found_text, corner_found_text, vectors_found_text)
steps = 5

# Each of the first four steps adds a panel. The fifth adds the cameras that were found.
found = "for [panel=1:(step >= 5 ? 4 : 0)] for [who=0:wrong]"

plot for [panel=1:(step < 4 ? step : 4)] $plane index 0 using @point with filledcurves closed fc rgb surface fs solid noborder title "surface", \
    @found "$found".panel index who using @point with @thick lc rgb ink dt dash(who) title "found", \
    $view index 0 using @vector with @pink_segment dt 3 title "view", \
    $at index 0 using @point with @dot lc rgb pink title "at", \
    $up_arrow index 0 using @vector with @green_arrow title "up", \
    @step2 @panel2 $points index 0 using @point with @dot lc rgb ink title "points", \
    @step3 @panel3 $across index 0 using @vector with @orange_arrow title "across", \
    @step3 @panel3 $upward index 0 using @vector with @green_arrow title "upward", \
    @step3 @panel3 $lower_left index 0 using @point with @dot lc rgb ink title "lower left", \
    @step4 @panel4 $vectors index 0 using @vector with @arrow lc rgb blue title "vectors", \
    for [panel=1:(step < 4 ? step : 4)] $eye using @point with @dot lc rgb blue title "eye", \
    @found "$frame".panel index who every ::0::0 using @vector with @orange_thin_arrow dt dash(who) title "r", \
    @found "$frame".panel index who every ::1::1 using @vector with @green_thin_arrow dt dash(who) title "u", \
    @found "$frame".panel index who every ::2::2 using @vector with @pink_thin_arrow dt dash(who) title "f", \
    @labels
