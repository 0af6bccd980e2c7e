# messages.awk - reads what the compiler said: messages about the answer, and what follows them.
#
# Knows the words of gcc and clang; what they say of other files serves only to write the help.
# In the environment: source, the answer; stem, its chapter; headers, whose names it may use.
BEGIN {
    source = ENVIRON["source"]
    contract = "exercises/" ENVIRON["stem"] ".h"
    header_count = split(ENVIRON["headers"], header)
    most = 3     # messages
    columns = 79 # of a line
    enough = 60  # that are looked at; of the rest, how many there are
    read_answer()

    # What students call a function elsewhere, and what it is here.
    known_as("dot dotp dot_product dotProduct vec3Dot vec_dot scalar_product", "vec3_dot")
    known_as("cross crossp cross_product crossProduct vec3Cross vec_cross", "vec3_cross")
    known_as("length len norm magnitude mag vec3_norm vec3_len vec3_magnitude vec_length abs_vec3",
             "vec3_length")
    known_as("unit unit_vector normalize normalise normalized vec3_normalize vec3_normalise " \
             "vec3_normalized vec_normalize", "vec3_unit")
    known_as("vec vec_of make_vec3 new_vec3 vec3_new vec3_make vec3_create Vec3 Vector vector",
             "vec3_of")
    known_as("print println echo cout console", "printf, of <stdio.h>")
    known_as("max maximum", "fmax, of <math.h>")
    known_as("min minimum", "fmin, of <math.h>")
    known_as("infinity Infinity INF inf HUGE", "INFINITY, of <math.h>")
    known_as("True TRUE", "true")
    known_as("False FALSE", "false")

    # Not every compiler says in which header of the C library something is.
    is_in("<stdio.h>", "printf fprintf sprintf snprintf puts putchar fputs scanf fflush stdout stderr")
    is_in("<stdlib.h>", "malloc calloc realloc free abs exit rand srand qsort atof atoi")
    is_in("<string.h>", "memcpy memset memcmp strlen strcmp")
    is_in("<math.h>", "sqrt fabs tan sin cos atan atan2 acos asin pow floor ceil round fmin fmax hypot " \
          "exp log isnan isfinite signbit copysign INFINITY NAN")
    is_in("<stdbool.h>", "bool true false")
    is_in("<stddef.h>", "NULL size_t")
    is_in("<stdint.h>", "uint8_t")
    is_in("<float.h>", "DBL_MAX DBL_MIN DBL_EPSILON FLT_MAX FLT_EPSILON")
    is_in("<limits.h>", "INT_MAX INT_MIN")
    is_in("<assert.h>", "assert")
}

function is_in(library, names,   part, i) {
    for (i = split(names, part, " "); i > 0; i--)
        library_of[part[i]] = library
}

function known_as(names, name,   part, i) {
    for (i = split(names, part, " "); i > 0; i--)
        known[part[i]] = name
}


# Typographic quotes become plain ones, colours go, and so does what gcc and clang add to say what a
# vec3 is made of: it helps nobody.
function plain(line) {
    gsub(/\033\[[0-9;]*[mK]/, "", line)
    gsub(/\342\200[\230\231]/, "'", line)
    gsub(/\t/, " ", line)
    gsub(/[\300-\377][\200-\277]*/, "?", line)
    gsub(/[^ -~]/, "?", line)
    gsub(/ \{aka [^}]*\}/, "", line)
    gsub(/ \(aka '[^']*'\)/, "", line)
    gsub(/ \(vector of 4 '[a-z ]*' values\)/, "", line)
    gsub(/__attribute__\(\(__vector_size__\([^)]*\)\)+ [a-z ]*/, "vector", line)
    gsub(/'__vector\(4\) double'/, "'vec3'", line)
    sub(/ +$/, "", line)
    return line
}

# The part of the line that stands in single quotes: the first, or the second.
function quoted(line, second,   part, count) {
    count = split(line, part, "'")
    return second ? (count > 3 ? part[4] : "") : count > 1 ? part[2] : ""
}

{
    line = plain($0)
    if (raw_count < most && line ~ /error|Error/)
        raw[++raw_count] = line
}

line ~ /^cc1: |^compilation terminated|^fatal error: too many errors|^[0-9]+ (warning|error).* generated\.$/ {
    inside = 0
    next
}

line ~ /^(In file included from|  +from) / {
    inside = 0
    at = index(line, source ":")
    if (at > 0) {
        where_included = substr(line, at)
        sub(/[:,]$/, "", where_included)
    }
    next
}

# In function 'f':
index(line, source ": ") == 1 { inside = 0; next }

match(line, /^[^ |][^:]*:[0-9]+:([0-9]+:)? (fatal error|error|warning|note): /) {
    head = substr(line, 1, RLENGTH)
    words = substr(line, RLENGTH + 1)
    own = index(line, source ":") == 1
    inside = 0
    if (head ~ / note: $/) {
        note()
        next
    }
    where = head
    sub(/: [a-z ]+: $/, "", where)
    if (!own) {
        if (head ~ /error: $/ && elsewhere == "")
            elsewhere = line
        in_macro = head ~ /error: $/ ? words : ""
        next
    }
    begin(line, words, head ~ /warning: $/)
    next
}

inside && !pointed {
    body[n] = body[n] "\n" line
    if (!inside_note && line ~ /\^/ && before != "")
        find_place(n, before, line)
    else if (line ~ /^[ |~]*\^/)
        pointed = 1
    before = line
    next
}
# After the caret come the repair and the labels; what gcc quotes of the lines that follow, not.
inside && line !~ /^ *([0-9]+|\+\+\+) \|/ && line != "" { body[n] = body[n] "\n" line; next }
inside { inside = 0 }

function begin(line, what, warning,   part) {
    inside = 0
    if (n == enough) {
        unread++
        return
    }
    n++
    message[n] = line
    text[n] = what
    is_warning[n] = warning
    split(substr(line, length(source) + 2), part, ":")
    line_number[n] = part[1] + 0
    column[n] = part[2] + 0
    inside = 1
    inside_note = pointed = 0
    before = ""
    in_macro = ""
}

function note() {
    if (own && words ~ /^in expansion of macro/ && in_macro != "") {
        # gcc places an error in a macro where the macro is defined.
        where = head
        sub(/: note: $/, "", where)
        begin(where ": error: " in_macro, in_macro, 0)
        return
    }
    if (n == 0 || unread || words ~ /column-tracking|silence this warning|near initialization/)
        return
    if (words ~ /include .*<[a-z_\/0-9]+\.h>/) {
        match(words, /<[a-z_\/0-9]+\.h>/)
        library[n] = substr(words, RSTART, RLENGTH)
    } else if (words ~ /^expected .* but argument is of type/)
        argument[n] = words
    else if (words ~ /^('[^']*' )?declared here/) {
        if (quoted(words) != "")
            declared[n] = quoted(words)
    } else if (own && words !~ /each undeclared identifier|^passing argument to parameter/) {
        body[n] = body[n] "\n" line
        inside = inside_note = 1
        pointed = 0
        before = ""
    }
}

# What stands before the caret, and what from there on: in the text, without the gcc margin.
function find_place(i, text_line, caret_line,   at) {
    at = index(caret_line, "^")
    ahead[i] = substr(text_line, 1, at - 1)
    sub(/^ *[0-9]+ \|/, "", ahead[i])
    behind[i] = substr(text_line, at)
    quoted_line[i] = text_line
    pointed = 1
}

# gcc does not quote again what it quoted for the message before; which may be left out.
function quote_again(i,   text_line, caret_line) {
    text_line = sprintf("%5d | %s", line_number[i], plain(answer[line_number[i]]))
    caret_line = sprintf("      | %" column[i] "s", "^")
    body[i] = "\n" text_line "\n" caret_line body[i]
    find_place(i, text_line, caret_line)
}
