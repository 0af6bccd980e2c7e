# help.awk - what can be made: the targets behind which stands '## ' and what for, in the Makefile and in
# what it includes, in the order in which make reads them.
function list(file,    line, parts) {
    while ((getline line < file) > 0)
        if (line ~ /^include /)
            list(substr(line, 9))
        else if (line ~ /^[a-z-]+:.*## / && split(line, parts, /:.*## /) == 2)
            printf "  make %-13s %s\n", parts[1], parts[2]
    close(file)
}
BEGIN {
    list("Makefile")
}
