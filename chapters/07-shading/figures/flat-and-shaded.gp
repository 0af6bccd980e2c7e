# flat-and-shaded.gp - the closing slide: the same spheres, flat and shaded ('Still something missing').
title = "Flat, and shaded"
description = sprintf("The same %s spheres twice. Left, flat: each has one colour. Right, shaded: bright where the \
surface faces the light.", spheres_text).(has_highlight ? " A highlight is where the surface mirrors the light into the eye." : ""). \
    (has_shadow ? sprintf(" In the shadow of a sphere there is only ambient light, %s of white.", ambient_text) : "")
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
# Words above the picture, and lines to the places that they name: white in black, visible on any colour.
shadow_at = shadow_first ? 0.2 : 0.84
highlight_at = shadow_first ? 0.84 : 0.2
from_word(at) = sprintf("(U(2,%g*columns)):(V(2,rows)+8):(U(2,$1)-U(2,%g*columns)):(V(2,$2)-V(2,rows)-8)", at, at)
word_at(at) = sprintf("(U(2,%g*columns)):(V(2,rows)+22)", at)
to_highlight = from_word(highlight_at)
to_shadow = from_word(shadow_at)
at_highlight = word_at(highlight_at)
at_shadow = word_at(shadow_at)
shining = sprintf("for [_=3:%d:1000]", has_highlight * step)
shadowed = sprintf("for [_=4:%d:1000]", has_shadow * step)
black_line = "vectors nohead lw 3.4 lc rgb 'black'"
white_line = "vectors nohead lw 1.4 lc rgb 'white'"
below(panel) = sprintf("(U(%d,columns/2)):(V(%d,0)-26)", panel, panel)
below_left = below(1)
below_right = below(2)

plot $flat matrix using @left_pixels with rgbimage title "flat", \
    $highlight using @below_left:("flat: one colour each") with labels tc rgb ink title "flat, label", \
    @step2 $shaded matrix using @right_pixels with rgbimage title "shaded", \
    @step2 $highlight using @below_right:("shaded: what the light makes of it") with labels tc rgb ink title "shaded, label", \
    @shining $highlight using @to_highlight with @black_line title "to the highlight", \
    @shining $highlight using @to_highlight with @white_line title "to the highlight, inside", \
    @shining $highlight using @at_highlight:(small("highlight")) with labels tc rgb ink title "highlight", \
    @shadowed $shadow using @to_shadow with @black_line title "to the shadow", \
    @shadowed $shadow using @to_shadow with @white_line title "to the shadow, inside", \
    @shadowed $shadow using @at_shadow:(small("shadow")) with labels tc rgb ink title "shadow"
