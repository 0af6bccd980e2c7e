# calls.awk - which functions of a chapter that failed call others of it that are not right.
#
#   objdump -r ANSWER.o | awk -v table=FOLDER/table -v states='wrong ...' -f calls.awk
#
# A call, direct or not, shows as a relocation. Lines: NAME, then those others; of names whose state
# in the judge's table is one of these. With -v may=FILE only those others that the file allows: a line
# for each NAME, and then those others.
BEGIN {
    while ((getline line < table) > 0) {
        split(line, part, " ")
        if (part[1] !~ /^\+/ && part[2] != "right") {
            order[++count] = part[1]
            state[part[1]] = part[2]
        }
    }
    while (may != "" && (getline line < may) > 0) {
        n = split(line, part, " ")
        for (i = 2; i <= n; i++)
            allowed[part[1], part[i]] = 1
    }
}
/^RELOCATION RECORDS FOR/ {
    sub(/.*\[/, "")
    sub(/\].*/, "")
    sub(/^\.text\./, "")
    from = $0
    next
}
$3 != "" {
    to = $3
    sub(/[-+]0x.*/, "", to)
    sub(/^\.text\./, "", to)
    calls_of[from] = calls_of[from] " " to
}
END {
    for (i = 1; i <= count; i++) {
        if (index(" " states " ", " " state[order[i]] " ") == 0)
            continue
        split("", reached)
        reach(order[i], reached)
        others = ""
        for (j = 1; j <= count; j++)
            if (j != i && (order[j] in reached) && !calls(order[j], order[i]) && \
                (may == "" || (order[i], order[j]) in allowed))
                others = others " " order[j]
        if (others != "")
            print order[i] others
    }
}

# Two that call each other do not excuse each other.
function calls(from, to,   seen) {
    reach(from, seen)
    return to in seen
}

function reach(name, reached,   n, to, i) {
    n = split(calls_of[name], to, " ")
    for (i = 1; i <= n; i++)
        if (!(to[i] in reached)) {
            reached[to[i]] = 1
            reach(to[i], reached)
        }
}
