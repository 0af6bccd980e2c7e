# flat-and-shaded.gp - the closing slide: the same spheres, flat and shaded ('Still something missing').
title = "Flat, and shaded"
description = sprintf("The same %s spheres twice. Left, flat: each has one colour. Right, shaded: bright where the \
surface faces the light, a highlight where it mirrors the light into the eye, and only ambient light, %s of \
white, in the shadow of another sphere.", spheres_text, ambient_text)
steps = 4
low_x = 0; high_x = columns; low_y = 0; high_y = rows
panel = 1; room = "0.02 0.49 0.14 0.94"
@flat
panel = 2; room = "0.51 0.98 0.14 0.94"
@flat

# The bytes of a pixel: red, green, blue.
byte(rgb, n) = n == 1 ? int(rgb) / 65536 : n == 2 ? int(rgb) / 256 % 256 : int(rgb) % 256
pixels(panel) = sprintf("(U(%d,$1+0.5)):(V(%d,$2+0.5)):(byte($3,1)):(byte($3,2)):(byte($3,3))", panel, panel)
left_pixels = pixels(1)
right_pixels = pixels(2)
# Words on the grey of the picture, and lines to what they name.
on_picture = "black"
line_on_picture = "white"
to(x, y) = sprintf("(U(2,$1)):(V(2,$2)):(U(2,%g*columns)-U(2,$1)):(V(2,%g*rows)-V(2,$2))", x, y)
word_at(x, y) = sprintf("(U(2,%g*columns)):(V(2,%g*rows))", x, y)
to_highlight = to(0.86, 0.87)
to_shadow = to(0.2, 0.87)
at_highlight = word_at(0.86, 0.92)
at_shadow = word_at(0.18, 0.92)
below(panel) = sprintf("(U(%d,columns/2)):(V(%d,0)-26)", panel, panel)
below_left = below(1)
below_right = below(2)

plot $flat matrix using @left_pixels with rgbimage title "flat", \
    $highlight using @below_left:("flat: one colour each") with labels tc rgb ink title "flat, label", \
    @step2 $shaded matrix using @right_pixels with rgbimage title "shaded", \
    @step2 $highlight using @below_right:("shaded: what the light makes of it") with labels tc rgb ink title "shaded, label", \
    @step3 $highlight using @to_highlight with vectors nohead lw 1.6 lc rgb line_on_picture title "to the highlight", \
    @step3 $highlight using @at_highlight:(small("highlight")) with labels tc rgb on_picture title "highlight", \
    @step4 $shadow using @to_shadow with vectors nohead lw 1.6 lc rgb line_on_picture title "to the shadow", \
    @step4 $shadow using @at_shadow:(small("shadow")) with labels tc rgb on_picture title "shadow"
