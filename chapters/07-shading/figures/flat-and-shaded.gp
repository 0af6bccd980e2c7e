# flat-and-shaded.gp - the closing slide: the same spheres, flat and shaded ('Still something missing').
#
# If something is wrong, the two pictures are the right one, shaded, and yours.
title = own("Flat, and shaded")
description = sprintf(own("The same %s spheres twice. Left, flat: each has one color. Right, shaded: bright where the \
surface faces the light."), spheres_text).(has_highlight ? " ".own("A highlight is where the surface mirrors the light into the eye.") : ""). \
    (has_shadow ? sprintf(" ".own("In the shadow of a sphere there is only ambient light, %s of white."), ambient_text) : "")
if (wrong) {
    description = sprintf(own("The same %s spheres twice, shaded: left with right answers, right with yours."), spheres_text)
    differs = ""
    unset label 99
}
steps = 4

picture = wrong ? "$shaded" : "$flat"
cast = 1
@decode
picture = wrong && exists("$your_shaded") ? "$your_shaded" : "$shaded"
cast = 2
@decode
in_panel = 'cast_file(panel) binary filetype=png origin=(U(panel,0.5),V(panel,0.5)) dx=size[panel] dy=size[panel] with rgbimage'
if (framed) in_panel = '$square using (U(panel,columns*$1)):(V(panel,rows*$2)) with lines lc rgb ink'

# Words above the picture, and lines to what they name: white in black, visible on any color. The one
# to the highlight ends a little before it.
above = 21
at_x(left) = left ? 0.24 : 0.875
from_x(left) = most(80, least(width - 80, U(2, at_x(left) * columns)))
from_y = V(2, rows) + above - 15
short(x, y, left) = left == shadow_first ? 1 : 1 - 9 / sqrt((U(2, x) - from_x(left))**2 + (V(2, y) - from_y)**2)
line_to(left) = sprintf("(from_x(%d)):(from_y):(short($1,$2,%d)*(U(2,$1)-from_x(%d))):(short($1,$2,%d)*(V(2,$2)-from_y))", \
    left, left, left, left)
word_at(left) = sprintf("(from_x(%d)):(V(2,rows)+above)", left)
to_shadow = line_to(int(shadow_first))
to_highlight = line_to(1 - int(shadow_first))
at_shadow = word_at(int(shadow_first))
at_highlight = word_at(1 - int(shadow_first))
shining = sprintf("for [_=3:%d:1000]", has_highlight && !wrong ? step : 0)
shadowed = sprintf("for [_=4:%d:1000]", has_shadow && !wrong ? step : 0)
black_line = "vectors nohead lw 4 lc rgb 'black'"
white_line = "vectors nohead lw 1.8 lc rgb 'white'"
# Below the picture, two lines of words.
below(panel, line) = sprintf("(U(%d,columns/2.0)):(V(%d,0)-24-31*%d)", panel, panel, line)
name_1 = below(1, 0)
name_2 = below(2, 0)
more_1 = below(1, 1)
more_2 = below(2, 1)

plot for [panel=1:1] @in_panel title cast_title(1, "flat"), \
    $once using @name_1:(wrong ? own("right") : own("flat")) with labels tc rgb ink title "flat, label", \
    $once using @more_1:(wrong ? "" : own("one color each")) with labels tc rgb grey title "flat, in words", \
    for [_=2:step:1000] for [panel=2:2] @in_panel title cast_title(2, "shaded"), \
    @step2 $once using @name_2:(wrong ? own("yours") : own("shaded")) with labels tc rgb ink title "shaded, label", \
    @step2 $once using @more_2:(wrong ? "" : own("with light and shadow")) with labels tc rgb grey title "shaded, in words", \
    @shining $highlight using @to_highlight with @black_line title "to the highlight", \
    @shining $highlight using @to_highlight with @white_line title "to the highlight, inside", \
    @shining $highlight using @at_highlight:(own("highlight")) with labels tc rgb ink title "highlight", \
    @shadowed $shadow using @to_shadow with @black_line title "to the shadow", \
    @shadowed $shadow using @to_shadow with @white_line title "to the shadow, inside", \
    @shadowed $shadow using (U(2,$1)):(V(2,$2)) with points pt 7 ps 0.55 lc rgb "black" title "in the shadow", \
    @shadowed $shadow using (U(2,$1)):(V(2,$2)) with points pt 7 ps 0.35 lc rgb "white" title "in the shadow, inside", \
    @shadowed $shadow using @at_shadow:(own("shadow")) with labels tc rgb ink title "shadow"
@forget
