# handout.awk - of a text, what is for a handout: between '#[' and '#]' stands what it lacks, behind
# '#~ ' what it has instead; in Markdown between <!--[ --> and <!--] -->, and in <!--~ a line -->.
/^(#|<!--)\[/ {
    if (inside)
        wrong("[ inside [")
    inside = 1
    next
}
/^(#|<!--)\]/ {
    if (!inside)
        wrong("] without [")
    inside = 0
    next
}
inside {
    next
}
/^#~ / {
    print substr($0, 4)
    next
}
/^<!--~ .* -->$/ {
    print substr($0, 7, length($0) - 10)
    next
}
{
    print
}
END {
    if (inside)
        wrong("[ without ]")
}
function wrong(what) {
    print FILENAME ":" FNR ": " what > "/dev/stderr"
    exit 1
}
