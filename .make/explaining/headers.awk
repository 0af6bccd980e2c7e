# headers.awk - what the headers declare, and which type an expression of the answer has.
# header_of: names; prototype_of and gives: functions; members, field_type: structs; one_of: enums.
function read_headers(   i, file, line, part, inside_of, tag, content, name) {
    if (headers_read++)
        return
    struct_names = "double|int|float|bool|vec3|Color"
    for (i = 1; i <= header_count; i++) {
        file = header[i]
        inside_of = ""
        while ((getline line < file) > 0) {
            sub(/[ \t]*\/\/.*/, "", line)
            if (inside_of == "" && match(line, /^[a-z ]*(struct|enum)[A-Za-z ]*\{/)) {
                inside_of = line ~ /enum/ ? "enum" : "struct"
                tag = substr(line, RSTART, RLENGTH - 1)
                sub(/.*(struct|enum) */, "", tag)
                line = substr(line, RLENGTH + 1)
                content = ""
            }
            if (inside_of != "") {
                content = content " " line
                if (split(content, part, "}") > 1) {
                    name = part[2]
                    gsub(/[^A-Za-z_0-9]/, "", name)
                    gsub(/ +/, "", tag)
                    list_members(inside_of, name == "" ? tag : name, part[1], file)
                    inside_of = ""
                }
            } else if (match(line, /^#define [A-Za-z_0-9]+/))
                header_of[substr(line, 9, RLENGTH - 8)] = file
            else if (line ~ /^typedef /) {
                sub(/ *(__attribute__|\(|;).*/, "", line)
                sub(/.* /, "", line)
                header_of[line] = file
            } else if (match(line, /^[A-Za-z_][A-Za-z_0-9 *]*[ *][A-Za-z_0-9]+\(/))
                list_function(line, file)
        }
        close(file)
    }
}

function is_declared(name) {
    read_headers()
    return name in header_of
}

function list_members(kind, type, content, file,
                      declaration, part, count, i, j, k, name, field, field_kind, star) {
    header_of[type] = file
    if (type != "")
        struct_names = struct_names "|" type
    if (kind == "enum") {
        gsub(/=[^,]*/, "", content)
        gsub(/ /, "", content)
        count = split(content, part, ",")
        for (i = 1; i <= count; i++) {
            header_of[part[i]] = file
            if (type != "" && i <= 3)
                one_of[type] = one_of[type] (i > 1 ? ", " : "") part[i] (i == 3 && count > 3 ? ", ..." : "")
        }
        return
    }
    count = split(content, declaration, ";")
    for (i = 1; i <= count; i++) {
        name = declaration[i]
        gsub(/[ \t]+/, " ", name)
        sub(/^ ?(const )?/, "", name)
        if (match(name, /\(\*[a-z_]+\)/)) # a pointer to a function
            name = "function " substr(name, RSTART + 2, RLENGTH - 3)
        if (split(name, part, " ") < 2)
            continue
        field_kind = part[1]
        k = split(substr(name, length(field_kind) + 1), field, ",")
        for (j = 1; j <= k; j++) {
            sub(/\[.*/, "", field[j])
            star = field[j] ~ /\*/
            gsub(/[^A-Za-z_0-9]/, "", field[j])
            members[type] = members[type] (members[type] == "" ? "" : ", ") field[j]
            field_type[type, field[j]] = field_kind
            field_pointer[type, field[j]] = star
        }
    }
}

function list_function(line, file,   name, more) {
    sub(/^static inline /, "", line)
    name = substr(line, 1, index(line, "(") - 1)
    sub(/.*[ *]/, "", name)
    while (line !~ /\)/ && (getline more < file) > 0)
        line = line more
    sub(/\).*/, ")", line)
    gsub(/  +/, " ", line)
    prototype_of[name] = line
    header_of[name] = file
    functions[++function_count] = name
    sub("[ ]*" name "\\(.*", "", line)
    gives[name] = bare_type(line)
}

# Functions of this chapter and of those before it, but this one, that make one type of another.
function makers(wanted, given, but,   i, name, arguments, found) {
    if (is_number(wanted) || wanted == "vec3" || !(wanted in members))
        return ""
    for (i = 1; i <= function_count; i++) {
        name = functions[i]
        arguments = substr(prototype_of[name], index(prototype_of[name], "("))
        if (name != but && gives[name] == wanted && header_of[name] ~ /^exercises/ &&
            header_of[name] <= contract && has_word(arguments, given) &&
            !has_word(arguments, wanted) && arguments !~ /\*/)
            found = found (found == "" ? "" : " or ") name " (" header_of[name] ") makes " \
                with_article(wanted) " of " listed_types(arguments)
    }
    return found
}

# Of (Camera c, double s): a Camera and a double.
function listed_types(arguments,   part, count, i, list) {
    count = parameter_types(arguments, part)
    for (i = 1; i <= count; i++)
        list = list (i == 1 ? "" : i < count ? ", " : " and ") with_article(part[i])
    return list
}

# The types of a prototype's parameters, without const and *.
function parameter_types(prototype, type,   count, i) {
    sub(/^[^(]*\(/, "", prototype)
    sub(/\).*/, "", prototype)
    count = split(prototype, type, /, */)
    for (i = 1; i <= count; i++) {
        sub(/^ *(const )?/, "", type[i])
        sub(/[ *].*/, "", type[i])
    }
    return count
}

# ---- types --------------------------------------------------------------------------------------

function is_number(type) {
    return type ~ /^(double|float|int|long|unsigned|unsigned int|_Bool|bool)$/
}

function with_article(type) {
    return (type ~ /^[AEIOUaeiou]/ ? "an " : "a ") type
}

# How a value of a type is written, or "". Its blanks are no places to wrap a line.
function written(type,   how) {
    read_headers()
    how = type == "vec3" ? "vec3_of(x, y, z)" : type == "Color" ? "vec3_of(r, g, b)" \
        : type in members ? "(" type "){" members[type] "}" : ""
    gsub(/ /, "\001", how)
    return how
}

# The type of an expression of this line, or "".
function type_of(expression, number,   name, first, line, element, found) {
    read_headers()
    element = gsub(/\[[^]]*\]/, "", expression) > 0
    name = expression
    sub(/.*(\.|->)/, "", name)
    if (name != expression) {
        sub(/(\.|->)[A-Za-z_0-9]*$/, "", expression)
        found = field_type[type_of(expression, number), name]
    } else if (name ~ /^[A-Za-z_][A-Za-z_0-9]*$/) {
        for (first = beginning(number); number >= first && number > 0 && found == ""; number--) {
            line = " " code[number]
            if (match(line, "[^A-Za-z_0-9](" struct_names ")[ *]+" name "([^A-Za-z_0-9]|$)"))
                found = substr(line, RSTART + 1)
            else if (line ~ "^ +(const )?(" struct_names ") ") {
                # one of several: vec3 p = f(x), v = g(y);
                while (gsub(/\([^()]*\)/, "", line) > 0)
                    ;
                if (line ~ ", *" name "([^A-Za-z_0-9]|$)")
                    found = line
            }
        }
        sub(/^ *(const )?/, "", found)
        sub(/[ *].*/, "", found)
    }
    return element && found == "vec3" ? "double" : found
}

# Which type was wanted and which was given, where the message says so.
function find_types(i,   what, line) {
    what = argument[i] != "" ? argument[i] : text[i]
    wanted[i] = given[i] = ""
    if (what ~ /^expected '.*' but argument is of type|^incompatible types when (initializing|assigning)|^initializing '.*' with an expression of incompatible|^assigning to '/) {
        wanted[i] = bare_type(quoted(what))
        given[i] = bare_type(quoted(what, "second"))
    } else if (what ~ /^incompatible types when returning|^returning '.*' from a function|^passing '.*' to parameter|^incompatible pointer types passing/) {
        given[i] = bare_type(quoted(what))
        wanted[i] = bare_type(quoted(what, "second"))
    } else if (what ~ /^invalid initializer/) {
        line = code[line_number[i]]
        wanted[i] = type_of(expression_at_end(line_before(line, "=")), line_number[i])
        sub(/[^=]*= */, "", line)
        given[i] = expression_type(line_before(line, ";"), line_number[i])
    }
    sub(/ ?\* ?const$/, " *", given[i])
}

function line_before(line, sign) {
    line = substr(line, 1, index(line, sign) - 1)
    sub(/ +$/, "", line)
    return line
}
