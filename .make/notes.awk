# notes.awk - what the judge says of the wrong answers that a figure is made of.
#
#   -v figure=NAME -v verdicts=FOLDER  chapters/*/*.c chapters/*/figures/*.c
#
# Which answers those are is read from the chapters' sources: what the function that writes the
# figure's data calls, and what that calls.
BEGIN {
    while (("build/judge/list" | getline line) > 0) {
        split(line, part, "\t")
        stem_of[part[2]] = part[1]
        listed[++exercises] = part[2]
    }
}
FNR == 1 {
    whole = ""
}
# A definition begins at the left edge; its body is indented.
/^[a-zA-Z].*\(/ && !/;$/ {
    here = $0
    sub(/\(.*/, "", here)
    sub(/.*[ *]/, "", here)
    defined[FILENAME, here] = 1
    if (!/^static/)
        home[here] = FILENAME
}
/^}/ {
    here = ""
}
/^[ {]/ && here != "" {
    rest = $0
    while (match(rest, /[a-z_0-9]+/)) {
        calls[FILENAME, here] = calls[FILENAME, here] " " substr(rest, RSTART, RLENGTH)
        rest = substr(rest, RSTART + RLENGTH)
    }
}
{
    # The list of figures: {"NAME", function}
    whole = whole " " $0
    if (match(whole, "\\{\"" figure "\", *[a-z_0-9]+")) {
        start = substr(whole, RSTART, RLENGTH)
        sub(/.* /, "", start)
        start_file = FILENAME
        whole = ""
    }
}
END {
    if (start == "")
        exit
    reach(start_file, start)
    for (i = 1; i <= exercises; i++)
        if (listed[i] in used)
            follow(listed[i])
    for (i = 1; i <= exercises; i++)
        if (listed[i] in blamed)
            note = note (note == "" ? "" : " ") words(listed[i])
    print note
}

function reach(file, name,   n, called, i) {
    if ((file, name) in seen)
        return
    seen[file, name] = 1
    n = split(calls[file, name], called, " ")
    for (i = 1; i <= n; i++) {
        if (called[i] in stem_of)
            used[called[i]] = 1
        if ((file, called[i]) in defined)
            reach(file, called[i])
        else if (called[i] in home)
            reach(home[called[i]], called[i])
    }
}

# Wrong, or waiting for one that is.
function follow(name,   i, n, part) {
    if (name in followed)
        return
    followed[name] = 1
    read_verdict(stem_of[name])
    n = split(state[name], part, " ")
    if (part[1] == "wrong")
        blamed[name] = 1
    for (i = 2; i <= n; i++)
        follow(part[i])
}

function read_verdict(stem,   file, line, part, name) {
    if (stem in read)
        return
    read[stem] = 1
    file = verdicts "/" stem ".record"
    while ((getline line < file) > 0) {
        split(line, part, "\t")
        gsub(/\\[nt]/, " ", part[2])
        if (part[1] == "function")
            name = part[2]
        else if (part[1] == "state" && name != "")
            state[name] = part[2] ~ /crashed|timed out/ ? "wrong" : part[2]
        else if (part[1] == "missing" && state[name] == "waiting")
            state[name] = "waiting " part[2]
        else if (part[1] ~ /^(waits|unsure)$/)
            state[name] = "waiting " part[2]
        said[name, part[1]] = part[2]
    }
    close(file)
}

function words(name,   formula) {
    formula = said[name, "formula"]
    if (said[name, "why"] == "")
        return name " is not right yet."
    # A minus sign is no hyphen.
    gsub(/- /, "\342\210\222 ", formula)
    return name (formula == "" ? ": " : " looks like " formula ": ") said[name, "why"]
}
