# section.gp - a line past a circle: the section through a ray and a sphere's centre, and its labels.
#
# After plot.gp, whose @see gives the places on the canvas.

# ---- numbers that are computed here, and what is not there --------------------------------------------

# A number with a minus sign.
number(x) = (x < 0 ? "−" : "").sprintf("%.10g", abs(x))
# If your number differs, both are shown, yours after the right one; or the number of your marks to draw.
differs(name) = exists("your_".name)
yours(name) = differs(name) ? ", yours ".value("your_".name."_text") : ""
# A label needs a place, even one that says nothing: gnuplot 5.4 crashes where it has none.
here(x) = x == x ? x : 100
cross = sprintf("points pt 2 ps %g lw 2", 0.55)
square = sprintf("points pt 4 ps %g lw 2", 0.8)

# ---- a line past a circle: labels that touch neither ------------------------------------------------

# '@beside_line', after '@see': where the line (direction line_x, line_y, line_z, speed long) and the circle
# (ball_x, ball_y, ball_z, radius r) are on the canvas. off_x, off_y, off_z is at right angles to the line,
# away from the circle's centre.
beside_line = 'line_u = seen_x(line_x, line_y, line_z); line_v = seen_y(line_x, line_y, line_z); \
    off_u = seen_x(off_x, off_y, off_z); off_v = seen_y(off_x, off_y, off_z); \
    ball_u = X(ball_x, ball_y, ball_z); ball_v = Y(ball_x, ball_y, ball_z)'
t_u(t) = ball_u + scale * (off_u * away + line_u * speed * (t - t_nearest))
t_v(t) = ball_v + scale * (off_v * away + line_v * speed * (t - t_nearest))
# Half the width of a label of n characters, and how far from the line its middle has to be.
half(n) = 4.9 * n + 2
clear(n) = 9 + half(n) * abs(off_u) + 10 * abs(off_v)
beside_u(x, n) = x + off_u * sgn(n) * clear(abs(n))
beside_v(y, n) = y + off_v * sgn(n) * clear(abs(n))
# From a box with this middle, half so wide and high, to the circle.
from_circle(u, v, w, h) = sqrt(most(abs(u - ball_u) - w, 0)**2 + most(abs(v - ball_v) - h, 0)**2) - scale * r
# Do a label of n characters at u, v and one of m at x, y overlap?
overlap(u, v, n, x, y, m) = abs(u - x) < half(n) + half(m) + 4 && abs(v - y) < 22
# '@beside_roots': hit0_u, hit0_v, hit1_u, hit1_v for the labels of n0 and n1 characters at the two roots,
# moved apart until they touch neither the circle nor each other. (Without a root, NaN < 4 holds.)
label_u(t, n, e) = beside_u(t_u(t), n) + e * line_u
label_v(t, n, e) = beside_v(t_v(t), n) + e * line_v
from_label(e) = most(abs(label_u(t0, n0, -e0 - e) - label_u(t1, n1, e1 + e)) - half(n0) - half(n1), \
    abs(label_v(t0, n0, -e0 - e) - label_v(t1, n1, e1 + e)) - 22)
beside_roots = 'e0 = 0; e1 = 0; apart = 0; \
    while (from_circle(label_u(t0, n0, -e0), label_v(t0, n0, -e0), half(n0), 10) < 4 && e0 < width) { e0 = e0 + 3 }; \
    while (from_circle(label_u(t1, n1, e1), label_v(t1, n1, e1), half(n1), 10) < 4 && e1 < width) { e1 = e1 + 3 }; \
    while (from_label(apart) < 4 && apart < width) { apart = apart + 3 }; \
    hit0_u = here(label_u(t0, n0, -e0 - apart)); hit0_v = here(label_v(t0, n0, -e0 - apart)); \
    hit1_u = here(label_u(t1, n1, e1 + apart)); hit1_v = here(label_v(t1, n1, e1 + apart))'
