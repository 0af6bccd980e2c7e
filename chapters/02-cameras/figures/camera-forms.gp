# camera-forms.gp - four ways to give a camera (slide 'Other camera representations'), and the camera
# that is found from each: its plane, and its frame r, u, f at the middle.
title = "Four other ways to give a camera"
description = sprintf("Four panels show one camera with the eye at %s, given in four ways. Look-at: the look-at point %s, \
the up vector %s, the width %s and the aspect ratio %s. Four points: the corners of the image plane. \
Corner and vectors: the lower left corner %s and two vectors, %s across and %s up. \
Four vectors: those from the eye to the corners. \
Each gives an image plane, and a frame r, u, f at its middle. \
From the look-at: %s. From four points: %s. From corner and vectors: %s. From four vectors: %s.", \
    eye_text, at_text, look_up_text, w_text, aspect_text, lower_left_text, across_text, upward_text, \
    look_at_found, points_found, corner_found, vectors_found)
steps = 5
room = sprintf("0.04 %g 0.62 0.87", 0.5 - 96.0 / width)
if (!turned) azimuth = 34
@see
shift_x[2] = width / 2.0
shift_y[3] = -height / 2.0
shift_x[4] = width / 2.0
shift_y[4] = -height / 2.0

# A panel for each form. Its title is above the middle, and the camera that was found is below. If
# the user's answer gives another camera, that one is below the right one.
forms = "look_at points corner vectors"
array titles[4] = ["look-at", "eye and four points", "eye, lower left corner, two vectors", "eye and four vectors"]
found(panel) = value(word(forms, panel)."_found")
your_name(panel) = "your_".word(forms, panel)."_found"
yours(panel) = exists(your_name(panel)) ? small("yours: ".value(your_name(panel))) : ""
title_place = "(shift_x[panel] + width / 4.0):(shift_y[panel] + height - 24)"
found_place = "(shift_x[panel] + width / 4.0):(shift_y[panel] + height / 2.0 + 50)"
yours_place = "(shift_x[panel] + width / 4.0):(shift_y[panel] + height / 2.0 + 34)"

# Each of the first four steps adds a panel. The fifth adds the cameras that were found.
panels = "for [panel=1:(step < 4 ? step : 4)]"
this = "panel - 1"
short = "vectors head filled size 9,18,90 lw 1.8"
gap = 12

plot $eye every ::0::0 using (width / 2.0):(12):(0):(height - 24) with vectors nohead lw 1 lc rgb faint title "between columns", \
    $eye every ::0::0 using (12):(height / 2.0):(width - 24):(0) with vectors nohead lw 1 lc rgb faint title "between rows", \
    @panels $eye using @title_place:(titles[panel]) with labels tc rgb ink title "title", \
    @panels $plane index 0 using @point with filledcurves closed fc rgb surface fs solid noborder title "surface", \
    @step5 @who @panels $planes index who every :::@this::@this using @point with @thick lc rgb ink dt dash(who) title "found", \
    $view index 0 using @vector with @leg lc rgb pink dt 3 title "view", \
    $at index 0 using @point with @dot lc rgb pink title "at", \
    $at index 0 using (@point_x - 12):(@point_y + 12):(small("at")) with labels tc rgb pink title "at, label", \
    $up_arrow index 0 using @vector with @arrow lc rgb green title "up", \
    $up_arrow index 0 using (@tip_x):(@tip_y + 14):(small("up")) with labels tc rgb green title "up, label", \
    $upper_edge index 0 using (@point_x):(@point_y + gap):@moved with @dimension lc rgb ink title "w", \
    $upper_edge index 0 using (@half_x + 6):(@half_y + gap + 12):(small(math("w")." = ".w_text)) with labels left tc rgb ink title "w, label", \
    $lower_right index 0 using (@point_x + 10):(@point_y + 22):(small(math("w/h")." = ".aspect_text)) \
        with labels left tc rgb ink title "aspect, label", \
    @step2 @panel2 $upper_left index 0 using @point with @dot lc rgb orange title "points", \
    @step2 @panel2 $upper_right index 0 using @point with @dot lc rgb orange title "points", \
    @step2 @panel2 $lower_left index 0 using @point with @dot lc rgb orange title "points", \
    @step2 @panel2 $lower_right index 0 using @point with @dot lc rgb orange title "points", \
    @step3 @panel3 $across index 0 using @vector with @arrow lc rgb orange title "across", \
    @step3 @panel3 $upward index 0 using @vector with @arrow lc rgb green title "upward", \
    @step3 @panel3 $lower_left index 0 using @point with @dot lc rgb ink title "lower left", \
    @step4 @panel4 $vectors index 0 using @vector with @arrow lc rgb blue title "vectors", \
    @panels $eye using @point with @dot lc rgb blue title "eye", \
    @panels $eye using (@point_x):(@point_y - 16):(small("eye")) with labels tc rgb blue title "eye, label", \
    @step5 @who @panels $frames index who every ::0:@this:0:@this using @vector with @short lc rgb orange dt dash(who) title "r", \
    @step5 @who @panels $frames index who every ::1:@this:1:@this using @vector with @short lc rgb green dt dash(who) title "u", \
    @step5 @who @panels $frames index who every ::2:@this:2:@this using @vector with @short lc rgb pink dt dash(who) title "f", \
    @step5 @panels $frames index 0 every ::0:@this:0:@this using (@tip_x - 9):(@tip_y - 9):(small(math("r"))) with labels tc rgb ink title "r, label", \
    @step5 @panels $frames index 0 every ::1:@this:1:@this using (@tip_x - 9):(@tip_y - 5):(small(math("u"))) with labels tc rgb ink title "u, label", \
    @step5 @panels $frames index 0 every ::2:@this:2:@this using @beyond:(small(math("f"))) with labels tc rgb ink title "f, label", \
    @step5 @panels $eye using @found_place:(small(found(panel))) with labels tc rgb grey title "found, in numbers", \
    @step5 @panels $eye using @yours_place:(yours(panel)) with labels tc rgb grey title "yours, in numbers"
