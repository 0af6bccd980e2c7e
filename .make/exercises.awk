# exercises.awk - what .make/verdict left, as a student reads it: the first thing that wants work, how
# far all chapters are, what next. One process, since it stands between saving and reading.
#
#   -v verdicts=FOLDER -v answers=FOLDER -v stems='01-a 02-b' -v all=1 -v colour=1
#   -v figures=FOLDER -v gnuplot=1    FOLDER/drawn gets the names of the figures that are shown
# Exit status: 0 all right, 1 something is wrong or does not compile, 2 only blanks are left.
BEGIN {
    count = split(stems, stem, " ")
    printf "" > (verdicts "/drawn")
    for (i = 1; i <= count; i++)
        read_table(stem[i])
    next_stem = ""
    for (i = count; i > 0; i--)
        if (state[stem[i]] != "right" && (has_wrong[stem[i]] || !has_wrong[next_stem]))
            next_stem = stem[i]
    for (i = 1; i <= count; i++)
        if (all ? state[stem[i]] != "right" : stem[i] == next_stem)
            show_troubles(stem[i])
    for (i = 1; i <= count; i++)
        show_progress(stem[i])
    print ""
    if (next_stem != "") {
        work = trouble[next_stem] == "" && stands_on[next_stem] != "" ? stands_on[next_stem] : next_stem
        print "Next: " answers "/" work ".c"
        print "      the lesson is chapters/" work "/README.md"
    }
    exit next_stem == "" ? 0 : is_wrong ? 1 : 2
}

# state: right, wrong, begun, blank; or compiler, linker, stopped.
function read_table(s,   file, line, part, n, wrong, unsure, right, total, i, names, blanks) {
    file = verdicts "/" s "/table"
    while ((getline line < file) > 0) {
        n = split(line, part, " ")
        if (part[1] == "!") {
            state[s] = part[2]
            is_wrong = has_wrong[s] = 1
            return
        }
        if (part[1] ~ /^\+/) {
            if (part[2] == "wrong")
                extra[s] = extra[s] (extra[s] == "" ? " " : ", ") substr(part[1], 2)
            continue
        }
        total++
        right += part[2] == "right"
        wrong += part[2] == "wrong"
        if (part[2] == "wrong")
            trouble[s] = trouble[s] " " part[1]
        else if (part[2] == "unanswered")
            blanks = blanks " " part[1]
        unsure += part[2] == "unsure"
        if (part[2] == "waiting" || part[2] == "unsure") {
            names = ""
            for (i = 3; i <= n; i++)
                names = names (i > 3 ? ", " : "") part[i]
            part[1] = part[1] (part[2] == "waiting" ? " (for " : " (it calls ") names ")"
        }
        listed[s, part[2]] = listed[s, part[2]] (listed[s, part[2]] == "" ? "" : ", ") part[1]
    }
    close(file)
    # Wrong comes before unanswered.
    has_wrong[s] = wrong > 0
    trouble[s] = trouble[s] blanks
    counted[s] = right + 0 " of " total + 0
    state[s] = total > 0 && right == total ? "right" : wrong + unsure ? "wrong" : right ? "begun" : "blank"
    is_wrong = is_wrong || wrong + unsure
}

function show_troubles(s,   n, name, i) {
    if (state[s] == "compiler" || state[s] == "linker" || state[s] == "stopped") {
        print painted(s "  " (state[s] == "compiler" ? "does not compile:" \
                              : state[s] == "linker" ? "cannot be linked:" : "could not be judged:"), "1")
        in_words = 1
        show_file(verdicts "/" s "/words")
        in_words = 0
        print ""
        return
    }
    n = split(trouble[s], name, " ")
    for (i = 1; i <= n && (i == 1 || all); i++) {
        show_file(verdicts "/" s "/" name[i], name[i])
        show_file(verdicts "/" s "/warnings")
        print ""
    }
}

function painted(text, code) {
    return colour ? sprintf("%c[%sm%s%c[0m", 27, code, text, 27) : text
}

# Headings bold, what was expected green, what came red, what it looks like yellow.
function show_file(file, name,   line, lines, code) {
    code = ""
    while ((getline line < file) > 0 && lines++ < 40) {
        if (name != "" && line ~ /^  try /)
            show_figure(name)
        if (line ~ /^[0-9][0-9]-/)
            line = painted(line, "1")
        else if (line ~ /^  help:/)
            line = painted(line, "33")
        else if (line !~ /^             / && !in_words)
            code = line ~ /^  expected / ? "32" : line ~ /^  (yours|it)    / ? "31" \
                : line ~ /^  (looks like|but) / ? "33" : ""
        print (code == "" || substr(line, 14) == "" ? line : substr(line, 1, 13) painted(substr(line, 14), code))
    }
    close(file)
}

# Where the judge has left one: a picture, or the script of a figure, which is drawn then.
function show_figure(name,   line) {
    if ((getline line < (figures "/" name ".png")) >= 0)
        print "  see        " figures "/" name ".png"
    else if (gnuplot != "" && (getline line < (figures "/" name ".gp")) >= 0) {
        print "  see        " figures "/" name ".svg"
        print name > (verdicts "/drawn")
    }
}

function show_progress(s,   words) {
    words = state[s] == "compiler" ? "does not compile" : state[s] == "linker" ? "cannot be linked" \
        : state[s] == "stopped" ? "could not be judged" : state[s] == "right" ? "done" \
        : state[s] == "blank" ? "not yet" : counted[s]
    printf "  %-16s %s\n", s, words (s == next_stem ? "   <- next" : "")
    if (s == next_stem) {
        show_names("wrong", listed[s, "wrong"])
        show_names("waiting", listed[s, "waiting"])
        show_names("cannot be told yet", listed[s, "unsure"])
        show_standing(s)
        show_names("not answered yet", listed[s, "unanswered"])
    }
    if (state[s] == "right" && extra[s] != "")
        show_names("extra, no marks", "more digits in" extra[s] \
            ", see 'Losing digits' in chapters/" s "/README.md")
}

# Where there is no reference: which answers of earlier chapters these stand on that are not right.
function show_standing(s,   file, line, names, earlier) {
    file = verdicts "/" s "/stands"
    while ((getline line < file) > 0) {
        earlier = substr(line, 1, index(line, " ") - 1)
        names = substr(line, index(line, " ") + 1)
        gsub(/ /, ", ", names)
        show_names("stands on your " earlier ", which is not right yet", names)
        if (stands_on[s] == "")
            stands_on[s] = earlier
    }
    close(file)
}

function show_names(label, names,   word, n, i, line) {
    if (names == "")
        return
    n = split(label ": " names, word, " ")
    line = "                    " word[1]
    for (i = 2; i <= n; i++) {
        if (length(line) + 1 + length(word[i]) > 79) {
            print line
            line = "                     "
        }
        line = line " " word[i]
    }
    print line
}
