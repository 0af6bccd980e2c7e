# standing.awk - from what object files refer to: which answers stand on others that are not right.
#
#   -v folders='FOLDER EARLIER...' < for each a line 'FOLDER name', then objdump -r of its answer.o
BEGIN {
    count = split(folders, folder, " ")
    while (("build/judge/list" | getline line) > 0) {
        split(line, part, "\t")
        stem_of[part[2]] = part[1]
    }
    for (i = 1; i <= count; i++)
        read_table(folder[i], i)
}
/^FOLDER / {
    here = $2
    next
}
/^RELOCATION RECORDS FOR/ {
    sub(/.*\[/, "")
    sub(/\].*/, "")
    sub(/^\.text\./, "")
    from = node($0)
    next
}
$3 != "" {
    to = $3
    sub(/[-+]0x.*/, "", to)
    sub(/^\.text\./, "", to)
    calls[from] = calls[from] " " node(to)
}
END {
    for (i = 1; i <= lines; i++) {
        split(text[i], part, " ")
        if (part[1] !~ /^\+/ && part[2] != "right" && part[2] != "unanswered")
            text[i] = judged(part[1], part[2], text[i])
        print text[i] > (folder[1] "/table.new")
    }
    printf "" > (folder[1] "/stands")
    for (i = 2; i <= count; i++) {
        stem = folder[i]
        sub(/.*\//, "", stem)
        if (stands[stem] != "")
            print stem stands[stem] > (folder[1] "/stands")
    }
}

# Helpers of two chapters may have one name; exercises have their own.
function node(name) {
    return name in stem_of ? name : here ":" name
}

function read_table(f, nth,   line, part, stem) {
    stem = f
    sub(/.*\//, "", stem)
    while ((getline line < (f "/table")) > 0) {
        split(line, part, " ")
        if (nth == 1)
            text[++lines] = line
        if (part[1] == "!") {
            for (name in stem_of)
                if (stem_of[name] == stem)
                    not_right[name] = 1
        } else if (part[1] !~ /^\+/ && part[2] != "right")
            not_right[part[1]] = 1
    }
    close(f "/table")
}

function reach(name, reached,   n, to, i) {
    n = split(calls[name], to, " ")
    for (i = 1; i <= n; i++)
        if (!(to[i] in reached)) {
            reached[to[i]] = 1
            reach(to[i], reached)
        }
}

# Two that call each other do not excuse each other.
function judged(name, state, line,   reached, back, other, others, mine) {
    split("", reached)
    reach(name, reached)
    mine = stem_of[name]
    for (other in not_right) {
        if (other == name || !(other in reached))
            continue
        split("", back)
        reach(other, back)
        if (name in back)
            continue
        others = others " " other
        if (stem_of[other] != mine && index(stands[stem_of[other]] " ", " " other " ") == 0)
            stands[stem_of[other]] = stands[stem_of[other]] " " other
    }
    return state == "wrong" && others != "" ? name " unsure" others : line
}
