# help.awk - what can be made: the targets behind which stands '## ' and what for, in the Makefile and in
# the parts that it includes (-v parts='...': those that it found), in the order in which make reads them.
function list(file,    line, words, i, count) {
    while ((getline line < file) > 0)
        if (line ~ /^include /) {
            count = split(line, words, /[ $(),]+/)
            for (i = 2; i <= count; i++)
                if (index(" " parts " ", " " words[i] " "))
                    list(words[i])
        } else if (line ~ /^[a-z-]+:.*## / && split(line, words, /:.*## /) == 2)
            printf "  make %-13s %s\n", words[1], words[2]
    close(file)
}
BEGIN {
    list("Makefile")
}
