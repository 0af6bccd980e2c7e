# pixel-grid.gp - a pixel is a square, and its center stands for it (slide 'Normalized screen
# coordinates'). Of a large screen, only the part around the pixel is shown.
title = own("A pixel is a square, and its center stands for it")
s_is = sprintf("(%s + ½)/%s", pixel_column_text, screen_W_text)
t_is = sprintf("1 − (%s + ½)/%s", pixel_row_text, screen_H_text)
description = sprintf(own("%s %s by %s pixels. Columns count from the left, rows from the top. The pixel in column %s, \
row %s is a square, and its center, the point %s, stands for it. Normalized, the center is s = %s = %s and \
t = %s = %s. s goes from 0 at the left edge to 1 at the right edge, t from 0 at the bottom to 1 at the top."), \
    whole ? own("A screen of") : own("A part of a screen of"), screen_W_text, screen_H_text, pixel_column_text, pixel_row_text, \
    center_text, s_is, place_s_text, t_is, place_t_text)
steps = 5

# y is down. The axes of s and t are the lower and the right edge, 0 to 1 along the whole screen.
narrow = shape eq "4:3"
left = U(1, begin_x); right_edge = U(1, end_x); top = V(1, -begin_y); bottom = V(1, -end_y)
AT(s) = U(1, s * screen_W)
UP(t) = V(1, (t - 1) * screen_H)
axis_gap = 12
# If there is no room for the number of each column, only every second or fifth one is numbered, and
# always the pixel's.
every(long) = long < size[1] ? 1 : long < 2 * size[1] ? 2 : 5
numbers(number, own, long) = int(abs(number - own)) % every(long) ? "" : sprintf("%d", number)
column_number(column) = numbers(column, pixel_column, 16 * strlen(screen_W_text) + 8)
row_number(row) = numbers(row, pixel_row, 28)
# Beside the number of the last column, which may be wider than its column.
t_x = most(right_edge + axis_gap, right_edge - size[1] / 2 + 8 * strlen(column_number(end_x - 1)) + 10)
corners = "(U(1,$1+pixel_column)):(V(1,$2-pixel_row-1))"

# The text is on the right; in the narrow shape, it is below, in two columns.
words_x(column) = narrow ? (0.05 + 0.5 * column) * width : 0.645 * width
words_y(row, row_below) = narrow ? 118 - 34 * row_below : 420 - 36 * row
set label 1 sprintf(own("%s%s × %s pixels"), whole ? "" : own("part of")." ", screen_W_text, screen_H_text) \
    at words_x(0),words_y(0, 0) tc rgb grey
if (step >= 2) { set label 2 own("pixel")." ".pixel_text at words_x(0),words_y(2, 1) tc rgb blue }
if (step >= 3) { set label 3 own("center")." ".center_text at words_x(0),words_y(3, 2) tc rgb blue }
if (step >= 4) {
    set label 4 math("s")." = ".s_is at words_x(1),words_y(5, 0) tc rgb orange
    set label 5 "= ".place_s_text at words_x(1)+20,words_y(6, 1) tc rgb orange
}
if (step >= 5) {
    set label 6 math("t")." = ".t_is at words_x(1),words_y(8, 2) tc rgb green
    set label 7 "= ".place_t_text at words_x(1)+20,words_y(9, 3) tc rgb green
}
your_center = your("center_text") eq "" ? "" : sprintf("%s %s, ", own("center"), your("center_text"))
if (wrong) { set label 8 own("yours").": ".(narrow ? "" : your_center.math("(s, t)")." = ").your("place_text") at (narrow ? words_x(0) : 40),16 tc rgb ink }

plot $square using (left+$1*(right_edge-left)):(bottom+$2*(top-bottom)) with filledcurves closed fc rgb surface fs solid noborder title "surface", \
    @step2 $square using @corners with filledcurves closed fc rgb blue fs transparent solid 0.35 noborder title "pixel", \
    $grid using (U(1,$1)):(V(1,-$2)) with @hair lc rgb grey title "grid", \
    $edges using (U(1,$1)):(V(1,-$2)) with @lines lc rgb ink title "edges", \
    $columns using (U(1,$1+0.5)):(top+18):(column_number($1)) with labels tc rgb ink title "columns", \
    $once using ((left+right_edge)/2):(top+48):(own("column")) with labels tc rgb grey title "column", \
    $rows using (left-10):(V(1,-$1-0.5)):(row_number($1)) with labels right tc rgb ink title "rows", \
    $once using (left-10):(top+18):(own("row")) with labels right tc rgb grey title "row", \
    @step2 $square using @corners with @lines lc rgb blue title "pixel, outline", \
    @step3 $centers index 0 using (U(1,$1)):(V(1,-$2)) with points pt 7 ps 0.2 lc rgb grey title "centers", \
    @step3 @who $sample index who using (U(1,$1)):(V(1,-$2)) with points pt mark(who) ps 0.55 lw 1+who lc rgb blue title "center", \
    @step4 $once using (left):(bottom-axis_gap):(right_edge-left):(0) with @orange_thin_arrow title "s axis", \
    @step4 $once using (most(right_edge+26,AT(place_s)+66)):(bottom-34):(math("s")) with labels tc rgb orange title "s", \
    @step4 @who $sample index who using (U(1,$1)):(V(1,-$2)):(AT($3)-U(1,$1)):(bottom-axis_gap-V(1,-$2)) with @orange_stroke dt dash(who) title "to s", \
    @step4 $sample index 0 using (AT($3)):(bottom-34):(place_s_text) with labels tc rgb orange title "s of the center", \
    @step4 for [end=0:2*whole-1] $once using (AT(end)):(bottom-34):(abs(end-place_s)*size[1]*screen_W<70?"":sprintf("%d",end)) with labels tc rgb orange title "s of the edge", \
    @step5 $once using (right_edge+axis_gap):(bottom):(0):(top-bottom) with @green_thin_arrow title "t axis", \
    @step5 $once using (t_x):(top+20):(math("t")) with labels tc rgb green title "t", \
    @step5 @who $sample index who using (U(1,$1)):(V(1,-$2)):(right_edge+axis_gap-U(1,$1)):(UP($4)-V(1,-$2)) with @stroke lc rgb green dt dash(who) title "to t", \
    @step5 $sample index 0 using (right_edge+22):(UP($4)):(place_t_text) with labels left tc rgb green title "t of the center", \
    @step5 for [end=0:2*whole-1] $once using (right_edge+22):(UP(end)):(abs(end-place_t)*size[1]*screen_H<28?"":sprintf("%d",end)) with labels left tc rgb green title "t of the edge"
