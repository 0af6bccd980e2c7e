# scope.awk - what a function of the answer is given, and what the deck's letters are there.
# in_scope: names, in order; scope_type, scope_pointer: of each of them.

# Reads the parameters of the function of this line, and what it declares down to there.
function read_scope(number,   i, line, part, star) {
    read_headers()
    for (i = 1; i <= scope_count; i++)
        delete scope_type[in_scope[i]]
    scope_count = parameter_count = 0
    for (i = beginning(number); i > 0 && i <= number; i++) {
        line = " " code[i]
        while (match(line, "[^A-Za-z_0-9](" struct_names ")[ *]+[A-Za-z_][A-Za-z_0-9]*")) {
            part = substr(line, RSTART + 1, RLENGTH - 1)
            line = substr(line, RSTART + RLENGTH)
            star = part ~ /\*/
            gsub(/[ *]+/, " ", part)
            if (line !~ /^ *\(/)
                put_in_scope(part, star)
        }
        if (!parameter_count && line ~ /\)/)
            parameter_count = scope_count
    }
}

function put_in_scope(declaration, star,   name) {
    name = declaration
    sub(/.* /, "", name)
    sub(/ .*/, "", declaration)
    if (!(name in scope_type))
        in_scope[++scope_count] = name
    scope_type[name] = declaration
    scope_pointer[name] = star
}

# The parameters of the function of this line, as they are declared; "" where it has none.
function parameters(number,   i, list, name) {
    read_scope(number)
    for (i = 1; i <= parameter_count; i++) {
        name = in_scope[i]
        list = list (i == 1 ? "" : i < parameter_count ? ", " : " and ") scope_type[name] \
            (scope_pointer[name] ? "\001*" : "\001") name
    }
    return list
}

# What on the slides has this letter, as a part of a value of this type.
function part_of_deck(type, letter,   parts) {
    parts = type == "Camera" ? "p=origin r=right u=up f=forward d=distance w=width h=height" \
        : type == "Ray" ? "p=origin v=direction" \
        : type == "Sphere" ? "c=center r=radius" \
        : type == "Resolution" ? "W=width H=height" : ""
    if (letter !~ /^[A-Za-z]$/ || !match(" " parts " ", " " letter "=[a-z]* "))
        return ""
    return substr(" " parts " ", RSTART + 3, RLENGTH - 4)
}

# The deck's letter, which nobody declared, by the names of this function; "" where it is none here.
function translated(letter, number,   i, name, type, member, found, what) {
    if (letter !~ /^[A-Za-z]$/)
        return ""
    read_scope(number)
    for (i = 1; i <= scope_count; i++) {
        name = in_scope[i]
        type = scope_type[name]
        member = part_of_deck(type, letter)
        what = ""
        # With a and b, c is that of the quadratic.
        if (letter == "c" && strange_letters[beginning(number)] ~ /(^| )[ab](,|$)/)
            member = ""
        # A camera that is given as a pointer is made there: it has no parts yet.
        if (member != "" && !(type == "Camera" && scope_pointer[name]))
            what = name (scope_pointer[name] ? "->" : ".") member
        else if (i <= parameter_count && (letter "=" name) ~ /^(r=radius|d=distance|p=eye)$/)
            what = name
        if (what != "")
            found = found (found == "" ? "" : " or ") what
    }
    return found == "" ? "" : letter "\001is\001" found
}

# The same for c.d, which no Camera has.
function letter_of_whole(i,   type, letter, name, member) {
    if (text[i] !~ /no member named/)
        return ""
    type = bare_type(quoted(text[i], text[i] !~ /^'/))
    letter = quoted(text[i], text[i] ~ /^'/)
    name = ahead[i]
    sub(/ *(\.|->) *$/, "", name)
    name = expression_at_end(name)
    member = part_of_deck(type, letter)
    return name == "" || member == "" ? "" : letter "\001is\001" name "." member
}

# Where in scope a value has a part of this name: camera.width, view.width. owner: their type.
function whole_of(member, number,   i, k, count, name, type, part, found) {
    read_scope(number)
    for (i = 1; i <= scope_count; i++) {
        name = in_scope[i]
        type = scope_type[name]
        if (type == "Camera" && scope_pointer[name])
            continue
        name = name (scope_pointer[name] ? "->" : ".")
        if ((type, member) in field_type)
            found = add_whole(found, name member, type)
        # image->size.width
        count = split(members[type], part, ", ")
        for (k = 1; k <= count; k++)
            if ((field_type[type, part[k]], member) in field_type && !field_pointer[type, part[k]])
                found = add_whole(found, name part[k] "." member, field_type[type, part[k]])
    }
    return found
}

function add_whole(found, whole, type) {
    owner = found == "" || owner == type ? type : ""
    return found (found == "" ? "" : " or ") whole
}
