# frame.gp - what every animation begins with, after plot.gp: frames of 1280 x 720, and large text.
#
# Text is 24 units of the canvas' 540 high or more, small letters too. A layout says how many steps it has, how
# many it shows in a second (rate), and which of them a lecturer stops at (stops).
unset output
if (format eq "png") {
    set terminal pngcairo size 1280,720 font "DejaVu Sans,24" enhanced linewidth 1.5 pointscale 4 dashlength 0.7 \
        background rgb background
}
if (format eq "svg") { set terminal svg size 960,540 font "DejaVu Sans,24" enhanced background rgb background }
set output format eq "txt" ? "/dev/null" : output.".".format
small(s) = s
small_font = ",24"
# A number in a text that moves: always two decimals, and a minus sign.
two(x) = (x < -0.005 ? "−" : "").sprintf("%.2f", abs(x))
# A number in a row of a block: $name[k + 1] is row k, after the comment in its first line.
cell(row, column) = real(word(row, column))
whole(row, column) = int(cell(row, column))
# Around what is outlined in a picture: seen on every colour, '@halo' below '@thick'.
halo = "lines lw 5 lc rgb background"
# Two halves of a frame: the scene, and the picture that is being made.
scene_room = "0.035 0.65 0.17 0.95"
picture_x = 800
picture_y = 320
picture_size = 270.0
