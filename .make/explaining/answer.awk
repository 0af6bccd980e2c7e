# answer.awk - the answer itself: its code without comments and strings, where functions begin.
# answer: its lines; code: without comments and strings. function_at: lines; defined_in: names.

function read_answer(   line, number, part, in_comment, at, name) {
    while ((getline line < source) > 0) {
        number++
        if (line ~ /^[ \t]*#[ \t]*include[ \t]*"/) {
            split(line, part, "\"")
            included[part[2]] = 1
        }
        answer[number] = line
        gsub(/[\t\r]/, " ", line)
        gsub(/"([^"\\]|\\.)*"/, "\"\"", line)
        gsub(/'([^'\\]|\\.)'/, "' '", line)
        if (in_comment) {
            at = index(line, "*/")
            line = at > 0 ? substr(line, at + 2) : ""
            in_comment = at == 0
        }
        sub(/\/\/.*/, "", line)
        gsub(/\/\*([^*]|\*+[^*\/])*\*+\//, " ", line)
        at = index(line, "/*")
        if (at > 0) {
            line = substr(line, 1, at - 1)
            in_comment = 1
        }
        sub(/ +$/, "", line)
        code[number] = line
        if ((match(line, /^[A-Za-z_][A-Za-z_0-9 *]*[ *][A-Za-z_0-9]+\(/) && line !~ /;$/) ||
            (match(line, /^[a-z_][a-z_0-9]*\(/) && line ~ /^[a-z_0-9]+\([A-Za-z_0-9 *,]*\) *\{?$/)) {
            line = name = substr(line, 1, RLENGTH - 1)
            sub(/.*[ *]/, "", name)
            if (line ~ /^(return|else) / || name ~ /^(if|for|while|switch)$/)
                continue
            function_at[number] = name
            defined_in[name] = number
            sub(/[A-Za-z_0-9]+$/, "", line)
            gives[name] = bare_type(line)
        }
    }
    close(source)
    last_line = number
    while (last_line > 0 && code[last_line] == "")
        last_line--
}

function bare_type(type) {
    gsub(/(^|[^A-Za-z_0-9])(const|struct|static|inline|extern) /, "", type)
    sub(/^ +/, "", type)
    sub(/ +$/, "", type)
    return type
}

# The line in which the function begins to which this line belongs; 0 where it is none.
function beginning(number) {
    while (number > 0 && !(number in function_at))
        number--
    return number
}

# The line in which the statement begins to which this line belongs.
function statement_of(number) {
    while (number > 1 && code[number - 1] !~ /[;{}]$/ && code[number - 1] != "" &&
           code[number - 1] !~ /^#/)
        number--
    return number
}

# That statement in one line.
function statement_text(number,   text) {
    for (number = statement_of(number); number <= last_line; number++) {
        text = text " " code[number]
        if (code[number] ~ /[;{}]$/)
            break
    }
    return text
}

# Where the function begins that lacks a }; 0 where none does.
function unclosed(   i, depth, last, line) {
    for (i = 1; i <= last_line; i++) {
        if (i in function_at) {
            if (depth > 0)
                break
            last = i
        }
        line = code[i]
        depth += gsub(/\{/, "", line) - gsub(/\}/, "", line)
    }
    return depth > 0 ? last : 0
}

# In a for (...); - or if, or while - nothing is left to be done.
function ends_at_once(number,   line, i, c, depth) {
    line = code[number]
    if (!match(line, /(^|[^A-Za-z_0-9])(for|if|while) *\(/))
        return 0
    for (i = RSTART + RLENGTH - 1; i <= length(line); i++) {
        c = substr(line, i, 1)
        depth += (c == "(") - (c == ")")
        if (depth == 0)
            return substr(line, i + 1) ~ /^ *;/
    }
    return 0
}

# The last line up to this one with a for that declares name; 0 where there is none.
function loop_of(name, number,   first) {
    first = beginning(number)
    while (number > first && code[number] !~ "(^|[^A-Za-z_0-9])for *\\( *[A-Za-z_0-9]+[ *]+" name " *=")
        number--
    return number > first ? number : 0
}

# Two numbers with a comma between them, and no blank, in the statement of this line: 0,5; or "".
function decimal_comma(number,   text) {
    text = statement_text(number)
    if (!match(text " ", /[^A-Za-z_0-9.,][0-9]+,[0-9]+([^A-Za-z_0-9.,]|, )/))
        return ""
    text = substr(text, RSTART + 1, RLENGTH - 1)
    match(text, /^[0-9]+,[0-9]+/)
    return substr(text, 1, RLENGTH)
}

function has_word(line, name) {
    return name ~ /^[A-Za-z_0-9]+$/ && line ~ "(^|[^A-Za-z_0-9])" name "([^A-Za-z_0-9]|$)"
}

# What stands at the end of this text as something that has a value: c.distance, v, t[i].
function expression_at_end(line) {
    return match(line, /[A-Za-z_][A-Za-z_0-9]*((\.|->)[A-Za-z_][A-Za-z_0-9]*|\[[^]]*\])*$/) \
        ? substr(line, RSTART) : ""
}
