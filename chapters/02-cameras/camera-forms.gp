# camera-forms.gp - what a camera may be given by (slide 'Other camera representations'), and the
# camera that is found from it: its plane, and its frame r, u, f at the middle.
title = "Four other ways to give a camera"
description = sprintf("Four panels, each with the eye at %s. Look-at: the point looked at, %s, an up vector %s, width %s \
and aspect ratio %s. Four points: the corners of the image plane. Lower left corner %s and two vectors, \
%s across and %s up. Four vectors from the eye to the corners. \
From each the same image plane is found, with the same frame r, u, f at its middle. \
Look-at: %s. Points: %s. Corner and vectors: %s. Four vectors: %s.", \
    eye_text, at_text, look_up_text, w_text, aspect_text, lower_left_text, across_text, upward_text, \
    look_at_found, points_found, corner_found, vectors_found)
steps = 5
room = sprintf("0.04 %g 0.60 0.87", 0.5 - 96.0 / width)
if (!turned) azimuth = 34
@see
shift_x[2] = width / 2.0
shift_y[3] = -height / 2.0
shift_x[4] = width / 2.0
shift_y[4] = -height / 2.0

# In the middle of a panel: its title, above, and what was found, below. Where yours is another,
# that is said under it.
center = width / 4.0
title_y = height - 24
found_y = height / 2.0 + 34
if (!exists("your_look_at_found")) your_look_at_found = ""
if (!exists("your_points_found")) your_points_found = ""
if (!exists("your_corner_found")) your_corner_found = ""
if (!exists("your_vectors_found")) your_vectors_found = ""
title_place = "(shift_x[panel] + center):(shift_y[panel] + title_y)"
found_place = "(shift_x[panel] + center):(shift_y[panel] + found_y)"
yours_place = "(shift_x[panel] + center):(shift_y[panel] + found_y - 18)"
yours(text) = text eq "" ? "" : small("yours: ".text)
set arrow 1 from width / 2.0, 12 rto 0, height - 24 nohead lc rgb faint
set arrow 2 from 12, height / 2.0 rto width - 24, 0 nohead lc rgb faint
short = "vectors head filled size 9,18,90 lw 1.8"

plot $eye using @title_place:("look-at") with labels tc rgb ink title "look_at", \
    $plane index 0 using @point with filledcurves closed fc rgb surface fs solid noborder title "look_at surface", \
    @step5 @who $look_at_plane index who using @point with @thick lc rgb ink dt dash(who) title "look_at plane", \
    $view index 0 using @vector with @leg lc rgb pink dt 3 title "view", \
    $at index 0 using @point with @dot lc rgb pink title "at", \
    $at index 0 using (@point_x - 12):(@point_y + 12):(small("at")) with labels tc rgb pink title "at, label", \
    $up_arrow using @vector with @arrow lc rgb green title "up", \
    $up_arrow using (@tip_x):(@tip_y + 14):(small("up")) with labels tc rgb green title "up, label", \
    $across index 0 using (@point_x):(Y($1+up_x*h,$2+up_y*h,$3+up_z*h) + 12):@moved with @dimension lc rgb ink title "width", \
    $across index 0 using (@half_x + 6):(Y($1+$4/2+up_x*h,$2+$5/2+up_y*h,$3+$6/2+up_z*h) + 24):(small(math("w")." = ".w_text)) with labels left tc rgb ink title "width, label", \
    $look_at_plane index 0 every ::2::2 using (@point_x + 10):(@point_y + 22):(small(math("w/h")." = ".aspect_text)) with labels left tc rgb ink title "aspect", \
    $eye using @point with @dot lc rgb blue title "look_at eye", \
    $eye using (@point_x):(@point_y - 16):(small("eye")) with labels tc rgb blue title "look_at eye, label", \
    @step2 @panel2 $eye using @title_place:("eye and four points") with labels tc rgb ink title "points", \
    @step2 @panel2 $plane index 0 using @point with filledcurves closed fc rgb surface fs solid noborder title "points surface", \
    @step5 @who @panel2 $points_plane index who using @point with @thick lc rgb ink dt dash(who) title "points plane", \
    @step2 @panel2 $points index 0 using @point with @dot lc rgb orange title "points", \
    @step2 @panel2 $eye using @point with @dot lc rgb blue title "points eye", \
    @step2 @panel2 $eye using (@point_x):(@point_y - 16):(small("eye")) with labels tc rgb blue title "points eye, label", \
    @step3 @panel3 $eye using @title_place:("eye, lower left corner, two vectors") with labels tc rgb ink title "corner", \
    @step3 @panel3 $plane index 0 using @point with filledcurves closed fc rgb surface fs solid noborder title "corner surface", \
    @step5 @who @panel3 $corner_plane index who using @point with @thick lc rgb ink dt dash(who) title "corner plane", \
    @step3 @panel3 $across index 0 using @vector with @arrow lc rgb orange title "across", \
    @step3 @panel3 $upward index 0 using @vector with @arrow lc rgb green title "upward", \
    @step3 @panel3 $lower_left index 0 using @point with @dot lc rgb ink title "lower left", \
    @step3 @panel3 $eye using @point with @dot lc rgb blue title "corner eye", \
    @step3 @panel3 $eye using (@point_x):(@point_y - 16):(small("eye")) with labels tc rgb blue title "corner eye, label", \
    @step4 @panel4 $eye using @title_place:("eye and four vectors") with labels tc rgb ink title "vectors", \
    @step4 @panel4 $plane index 0 using @point with filledcurves closed fc rgb surface fs solid noborder title "vectors surface", \
    @step5 @who @panel4 $vectors_plane index who using @point with @thick lc rgb ink dt dash(who) title "vectors plane", \
    @step4 @panel4 $vectors index 0 using @vector with @arrow lc rgb blue title "vectors", \
    @step4 @panel4 $eye using @point with @dot lc rgb blue title "vectors eye", \
    @step4 @panel4 $eye using (@point_x):(@point_y - 16):(small("eye")) with labels tc rgb blue title "vectors eye, label", \
    @step5 @who $look_at_frame index who every ::0::0 using @vector with @short lc rgb orange dt dash(who) title "look_at r", \
    @step5 @who $look_at_frame index who every ::1::1 using @vector with @short lc rgb green dt dash(who) title "look_at u", \
    @step5 @who $look_at_frame index who every ::2::2 using @vector with @short lc rgb pink dt dash(who) title "look_at f", \
    @step5 $look_at_frame index 0 using @beyond:(math(word("r u f", int($0) + 1))) with labels tc rgb ink title "look_at r u f", \
    @step5 $eye using @found_place:(small(look_at_found)) with labels tc rgb grey title "look_at found", \
    @step5 $eye using @yours_place:(yours(your_look_at_found)) with labels tc rgb grey title "look_at yours", \
    @step5 @who @panel2 $points_frame index who every ::0::0 using @vector with @short lc rgb orange dt dash(who) title "points r", \
    @step5 @who @panel2 $points_frame index who every ::1::1 using @vector with @short lc rgb green dt dash(who) title "points u", \
    @step5 @who @panel2 $points_frame index who every ::2::2 using @vector with @short lc rgb pink dt dash(who) title "points f", \
    @step5 @panel2 $points_frame index 0 using @beyond:(math(word("r u f", int($0) + 1))) with labels tc rgb ink title "points r u f", \
    @step5 @panel2 $eye using @found_place:(small(points_found)) with labels tc rgb grey title "points found", \
    @step5 @panel2 $eye using @yours_place:(yours(your_points_found)) with labels tc rgb grey title "points yours", \
    @step5 @who @panel3 $corner_frame index who every ::0::0 using @vector with @short lc rgb orange dt dash(who) title "corner r", \
    @step5 @who @panel3 $corner_frame index who every ::1::1 using @vector with @short lc rgb green dt dash(who) title "corner u", \
    @step5 @who @panel3 $corner_frame index who every ::2::2 using @vector with @short lc rgb pink dt dash(who) title "corner f", \
    @step5 @panel3 $corner_frame index 0 using @beyond:(math(word("r u f", int($0) + 1))) with labels tc rgb ink title "corner r u f", \
    @step5 @panel3 $eye using @found_place:(small(corner_found)) with labels tc rgb grey title "corner found", \
    @step5 @panel3 $eye using @yours_place:(yours(your_corner_found)) with labels tc rgb grey title "corner yours", \
    @step5 @who @panel4 $vectors_frame index who every ::0::0 using @vector with @short lc rgb orange dt dash(who) title "vectors r", \
    @step5 @who @panel4 $vectors_frame index who every ::1::1 using @vector with @short lc rgb green dt dash(who) title "vectors u", \
    @step5 @who @panel4 $vectors_frame index who every ::2::2 using @vector with @short lc rgb pink dt dash(who) title "vectors f", \
    @step5 @panel4 $vectors_frame index 0 using @beyond:(math(word("r u f", int($0) + 1))) with labels tc rgb ink title "vectors r u f", \
    @step5 @panel4 $eye using @found_place:(small(vectors_found)) with labels tc rgb grey title "vectors found", \
    @step5 @panel4 $eye using @yours_place:(yours(your_vectors_found)) with labels tc rgb grey title "vectors yours"
