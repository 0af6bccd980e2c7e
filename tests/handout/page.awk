# page.awk - a page for readers who have less than its writer: a paragraph, an item of a list or a row of a
# table that links to a file that is not there is left out.
#   -v folder=FOLDER (that of the page)
function leads_nowhere(text,    link) {
    while (match(text, /\]\([^)#]+/)) {
        link = substr(text, RSTART + 2, RLENGTH - 2)
        text = substr(text, RSTART + RLENGTH)
        if (link !~ /^https?:/ && system("test -e \"" folder "/" link "\"") != 0)
            return 1
    }
    return 0
}
function flush() {
    if (paragraph != "" && leads_nowhere(paragraph))
        gone = 1
    else
        printf "%s", paragraph
    paragraph = ""
}
/^(\||- |$)/ {
    flush()
}
/^$/ {
    # Of the empty lines around what is left out, one.
    if (!gone)
        print
    gone = 0
    next
}
{
    paragraph = paragraph $0 "\n"
}
/^\|/ {
    flush()
    gone = 0
}
END {
    flush()
}
