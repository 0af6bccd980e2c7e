# pictures.gp - the pictures of a script, which are PNGs in base64.
#
# gnuplot reads a picture from a file. '@decode' makes that of 'picture' ("$NAME"), number 'cast', and
# '@forget', after the plot, removes all of them. cast_file(number) is its name.
cast_file(number) = sprintf("%s.cast%d", output, number)
casts = ""
decode = 'casts = casts." \"".cast_file(cast)."\""; set print sprintf("| base64 -d > \"%s\"", cast_file(cast)); \
    do for [line=2:|@picture|] { print @picture[line] }; set print'
forget = 'system("rm -f".casts)'
