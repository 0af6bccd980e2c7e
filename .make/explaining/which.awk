# which.awk - which of the common mistakes a message is.
function is_syntax(i) {
    return text[i] ~ /^expected |^unexpected type name|^extraneous|^invalid (suffix|digit) /
}

# A semicolon among what was expected, not in what came instead.
function is_semicolon(i,   expected) {
    expected = text[i]
    if (expected ~ / before '\{'|or '\)'/)
        return 0
    sub(/ before .*/, "", expected)
    return expected ~ /^expected .*';'/
}

function is_pasted(i) {
    return text[i] ~ /\\U0000|identifier '\?/ ||
        (text[i] ~ /^expected/ && behind[i] ~ /^ *\?/ && answer[line_number[i]] ~ /[\200-\377]/) || text[i] ~ /^stray '\\[23][0-7][0-7]'|^(unexpected )?character <?U\+|^treating Unicode|^non-ASCII|^source file is not valid UTF-8|^extended character/
}

function is_unknown(i) {
    return text[i] ~ /undeclared|^implicit declaration of function|^implicitly declaring|^unknown type name|^call to undeclared/
}

function is_count(i) {
    return text[i] ~ /^too (few|many) arguments to function/
}

function is_signature(i) {
    return text[i] ~ /^conflicting types for|^redefinition of|^static declaration of|doesn't match prototype$|redeclared as different kind/
}

function is_missing_return(i) {
    return text[i] ~ /control reaches end of non-void|no return statement in function|non-void function .*return a value|^'return' with no value/
}

function is_unused_value(i) {
    return text[i] ~ /^value computed is not used|^expression result unused|^statement with no effect|^equality comparison result unused/
}

function is_comma(i) {
    return text[i] ~ /left(-hand)? operand of comma|misuse of comma/
}

function may_be_decimal_comma(i) {
    return is_comma(i) || is_unused_value(i) ||
        text[i] ~ /^too many arguments|^excess elements|^expected identifier or '\('( before numeric constant|$)/
}

function is_missing_brace(i) {
    return open_function && text[i] ~ /^expected declaration or statement at end of input|^expected '\}'|^function definition is not allowed here/
}

# A statement, or a }, where only functions may be.
function is_outside(i) {
    return text[i] ~ /^expected identifier or '\(' before ('\}'|'(for|if|while|return|else|switch|do)')|^extraneous closing brace/ ||
        text[i] ~ /^expected identifier or '\('$/ &&
        code[line_number[i]] ~ /^ *(for|if|while|return|else|switch|do|\})([^A-Za-z_0-9]|$)/
}

# A vector where there should be a number.
function is_vector(i) {
    if (wanted[i] != "")
        return given[i] ~ /^(vec3|Color)$/ && is_number(wanted[i])
    return text[i] ~ /(double|float|int)' (using|from) type 'vec3'|used vector type where|^wrong type argument to unary|^aggregate value used where|requires expression of scalar type|invalid conversion between vector type|logical expression with vector type|^used type .*vector|^invalid argument type .*vector|(convert|conversion).*vec3.*double/
}

# The keyword that a name in this line was meant to be, by its letters and what stands around it.
function misspelled(name, number,   word, i, count, before, after) {
    if (!has_word(code[number], name))
        return ""
    match(" " code[number] " ", "[^A-Za-z_0-9]" name "[^A-Za-z_0-9]")
    before = substr(code[number], 1, RSTART - 1)
    after = substr(code[number], RSTART + length(name))
    count = split("return else while for if switch break continue " \
                  "double float int bool const void static struct", word, " ")
    for (i = 1; i <= count; i++) {
        if (!is_near(name, word[i]))
            continue
        # The first eight begin a statement; a type stands before a name.
        if (i <= 8 ? before !~ /(^|[;{})]|[^A-Za-z_0-9]else) *$/ || after ~ /^ *([+*=.,)]|\/|])/ \
                   : after !~ /^ *\*?[A-Za-z_]/)
            continue
        if (word[i] ~ /^(while|for|if|switch)$/ && after !~ /^ *\(/)
            continue
        return word[i]
    }
    return ""
}

# One slip of the fingers; in short words only two letters the wrong way round.
function is_near(name, word,   i, size) {
    size = length(word)
    if (tolower(name) == word)
        return 1
    for (i = 1; i <= size + 1; i++) {
        if (name == substr(word, 1, i - 1) substr(word, i + 1, 1) substr(word, i, 1) \
                    substr(word, i + 2) ||
            size > 3 && name == substr(word, 1, i - 1) substr(word, i + 1) ||
            size > 3 && word == substr(name, 1, i - 1) substr(name, i + 1) ||
            size > 5 && length(name) == size && substr(name, 1, i - 1) substr(name, i + 1) == \
                substr(word, 1, i - 1) substr(word, i + 1))
            return 1
    }
    return 0
}
