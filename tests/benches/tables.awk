# tables.awk - a Markdown file with its tables replaced by new ones with the same first cell.
#
# Usage: awk -F'|' -f tables.awk TABLES.md FILE.md
# In both files a table ends at the first line that does not begin with '|'.
FNR == NR {
    if (/^\|/) {
        if (!inside)
            name = $2
        tables[name] = tables[name] $0 "\n"
    }
    inside = /^\|/
    next
}
/^\|/ && !skipping && ($2 in tables) {
    printf "%s", tables[$2]
    skipping = 1
}
!/^\|/ {
    skipping = 0
}
!skipping
