# slips.awk - what the text of a wrong answer explains and its values do not: 1/2, and 0,5.
#
# FOLDER/NAME of each function that is wrong gets a line for each division of two whole numbers that
# leaves a remainder. If a decimal comma was warned of there, no mistake is named: it is the comma.
# In the environment: source, the answer; folder, of its verdict.
BEGIN {
    source = ENVIRON["source"]
    folder = ENVIRON["folder"]
    read_answer()
    while ((getline line < (folder "/table")) > 0) {
        split(line, part, " ")
        state[part[1]] = part[2]
    }
    while ((getline line < (folder "/compiler")) > 0)
        if (index(line, source ":") == 1 && line ~ /comma|excess elements|not used|unused/) {
            split(substr(line, length(source) + 2), part, ":")
            if (decimal_comma(part[1] + 0) != "")
                has_comma[part[1] + 0] = 1
        }
    for (name in state)
        if (state[name] == "wrong" && name in defined_in) {
            split("", seen)
            divisions = ""
            comma = 0
            look_at(name, defined_in[name])
            if (divisions != "" || comma)
                tell(folder "/" name)
        }
}

# The lines of a function, and of the helpers and macros that it uses.
function look_at(name, number,   line, other, i) {
    seen[name] = 1
    do {
        line = code[number]
        find_divisions(number)
        comma = comma || number in has_comma
        for (other in defined_in)
            if (!(other in seen) && !(other in state) && has_word(line, other))
                look_at(other, defined_in[other])
        for (i = 1; i <= last_line; i++)
            if (match(code[i], /^ *# *define +[A-Za-z_0-9]+/)) {
                other = substr(code[i], 1, RLENGTH)
                sub(/.* /, "", other)
                if (!(other in seen) && has_word(line, other)) {
                    seen[other] = 1
                    find_divisions(i)
                }
            }
        number++
    } while (number <= last_line && !(number in function_at))
}

# x * 1/2, (double)1/2 and 1/2.0 are no such divisions.
function find_divisions(number,   line, before, ahead, joined, pair) {
    line = code[number]
    while (match(line, /[0-9]+ *\/ *[0-9]+/)) {
        ahead = ahead substr(line, 1, RSTART - 1)
        before = ahead
        joined = before ~ /[A-Za-z_0-9.]$/ || before ~ /[0-9.][eE][-+]$/
        sub(/ +$/, "", before)
        ahead = ahead substr(line, RSTART, RLENGTH)
        split(substr(line, RSTART, RLENGTH), pair, /[ \/]+/)
        line = substr(line, RSTART + RLENGTH)
        if (joined || before ~ /[*\/%)]$/ || line ~ /^[A-Za-z_0-9.]/ ||
            pair[2] + 0 == 0 || pair[1] % pair[2] == 0)
            continue
        before = "  help: in line " number ", " pair[1] "/" pair[2] " is " int(pair[1] / pair[2]) \
            ": C divides whole numbers without a remainder.\n        Write " pair[1] ".0/" pair[2] ".\n"
        if (index(divisions, before) == 0)
            divisions = divisions before
    }
}

function tell(file,   line, count, text, i) {
    while ((getline line < file) > 0) {
        if (comma && line ~ /^  (looks like|you'd see|but) /)
            leave_out = 1
        else if (line !~ /^             /)
            leave_out = 0
        if (!leave_out)
            text[++count] = line
    }
    close(file)
    for (i = 1; i <= count; i++)
        printf "%s%s\n", (i == count ? divisions : ""), text[i] > file
    close(file)
}
