# section.gp - a line past a circle: its looks, and whether it is yours.
#
# After plot.gp.

# If your number differs, 1: the number of your marks to draw.
differs(name) = exists("your_".name)
# The root that is the hit is blue, another one ahead of p is ink.
color(t) = abs(t - hit) <= 1e-6 * abs(hit) ? blue : t > 0 ? ink : grey
cross = sprintf("points pt 2 ps %g lw 2", 0.55)
square = sprintf("points pt 4 ps %g lw 2", 0.8)
squares_are_yours = own("solid: expected")."\n".own("dashed, squares: yours")
# Where v itself would be too short or too long to see, the arrow is another one.
arrow_words(stride) = stride == 1 ? "" : sprintf(" ".own("The arrow is %s v."), stride_text)
