# pictures.gp - the pictures of a script, which are PNGs in base64.
#
# gnuplot reads a picture from a file. '@decode' makes that of 'picture' ("$NAME"), number 'cast', and
# '@forget', after the plot, removes all of them. cast_file(number) is its name, cast_title(number, words) the
# title of its plot.
#
# A gnuplot that reads no PNG is given 'framed = 1': the layout then draws each picture's frame ($square) in its
# place, and chapters/book/finish_figure.js puts the picture into it.
if (!exists("framed")) framed = 0
cast_file(number) = sprintf("%s.cast%d", output, number)
cast_title(number, words) = framed ? "picture ".cast_name[number].": ".words : words
casts = ""
array cast_name[2]
decode = 'cast_name[cast] = picture; if (!framed) { casts = casts." \"".cast_file(cast)."\""; \
    set print sprintf("| base64 -d > \"%s\"", cast_file(cast)); \
    do for [line=2:|@picture|] { print @picture[line] }; set print }'
forget = 'if (!framed) { system("rm -f".casts) }'
