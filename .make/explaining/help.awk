# help.awk - a line of help for each of the common mistakes.
function help(i,   line) {
    line = code[line_number[i]]
    if (pasted[i])
        return "a character that is not C was pasted there: a dash, a quote, a sign or a space " \
            "that only looks like one. Delete it and type it anew."
    if (keyword[i] != "")
        return slip[i] " is misspelled: " keyword[i] "."
    if (decimal[i] != "") {
        line = decimal[i]
        sub(/,/, ".", line)
        return decimal[i] " is two numbers in C. If it is meant as one, write " line "."
    }
    if (missing_brace[i])
        return help_brace(i)
    if (outside[i])
        return "this stands outside of every function: before it there is a } too many."
    if (line ~ /^ *(import|using|from) /)
        return "C has no import: headers are included, as in #include \"" contract "\""
    if (text[i] ~ /^expected/ && behind[i] ~ /^ *(and|or|not) /)
        return "and, or and not are written &&, || and ! in C."
    if (text[i] ~ /operand of '[&|]'|^[&|] has lower precedence/)
        return "&& is and, || is or; & and | work on bits."
    if (text[i] ~ /^comparisons like/)
        return "two comparisons are joined by &&: 0 < x && x < 1."
    if (text[i] ~ /^expected identifier or '\('( before '\{')?/ && line ~ /^\{/ && code[code_before(line_number[i])] ~ /\);$/)
        return "the ; at the end of line " code_before(line_number[i]) " parts the function from its { }: take it away."
    if (text[i] ~ /^expected expression/ && ahead[i] ~ /^ *$/ && code[code_before(line_number[i])] ~ /,$/)
        return "line " code_before(line_number[i]) " ends in a comma, where a semicolon belongs."
    if (is_unused_value(i) && line ~ /==/)
        return "== compares; to give a variable a value, write =."
    if (text[i] ~ /used uninitialized|uninitialized when used/)
        return quoted(text[i]) " is declared, but has no value yet."
    if (text[i] ~ /No such file or directory|file not found/)
        return "the contract of this chapter is #include \"" contract "\"; other headers are in common/."
    if (text[i] ~ /^expected/ && (behind[i] ~ /^ *x [A-Za-z(]/))
        return "x is no operator in C: * multiplies, and the cross product is vec3_cross(v, w)."
    if (text[i] ~ /^expected '\)'/ && brackets(line_number[i]) > 0)
        return "a ) is missing: here are more ( than )."
    if (text[i] ~ /before '\)' token|^extraneous '\)'|^expected expression$/ && brackets(line_number[i]) < 0)
        return "a ) too many: here are more ) than (."
    if (text[i] ~ /^expected '\('/ && line ~ /(^|[^A-Za-z_0-9])(if|while|for) +[^ (]/)
        return "after if, while and for comes a bracket: if (x > 0)."
    if (text[i] ~ /^expected '[})]'/ && ahead[i] ~ /[A-Za-z_0-9)] *$/ && behind[i] ~ /^ *[A-Za-z_(]/)
        return "an operator or a comma is missing there (2 t is 2 * t)."
    if (text[i] ~ /^expected expression/ && behind[i] ~ /^[<>]/ && ahead[i] ~ /= *$/)
        return "C writes >= and <=, not => and =<."
    if (text[i] ~ /^(expected expression( before '[A-Za-z]|$)|unexpected type name)/ && ahead[i] ~ /^ *$/ &&
        behind[i] ~ "^(" struct_names ") +[A-Za-z_]")
        return "a declaration after if, else or for needs braces round it: { }."
    if (text[i] ~ /^subscripted value/)
        return help_subscript(i)
    if (text[i] ~ /^invalid operands to binary|^cannot convert between vector and non-scalar/ && behind[i] !~ /^\^/)
        return help_operands(i)
    if (text[i] ~ /assignment used as truth value|result of an assignment as a condition/)
        return "= assigns; to compare, write ==."
    if (text[i] ~ /^(expected expression|unexpected type name)/)
        return help_expression(i, line)
    if (is_semicolon(i))
        return help_semicolon(i)
    if (text[i] ~ /invalid type argument of '->'|^member reference type .* is (not )?a pointer|is a pointer; did you mean/)
        return help_arrow(i)
    if (text[i] ~ /^request for member|^member reference base type/)
        return help_parts(i)
    if (text[i] ~ /no member named|does not refer to any field/)
        return help_member(i)
    if (text[i] ~ /^invalid operands to binary/ && behind[i] ~ /^\^/)
        return help_power(i, "^ is exclusive or in C", line)
    if (text[i] ~ /^invalid type argument of unary '\*'|^indirection requires pointer/ && line ~ /\*\*/)
        return help_power(i, "C has no **", line)
    if (text[i] ~ /^invalid type argument of unary '\*'|^indirection requires pointer/)
        return "a * in front asks what a pointer points to, and this is no pointer: take the * away."
    if (text[i] ~ /^invalid (suffix|digit) .* (integer|decimal|floating) constant/)
        return help_times(line)
    if (text[i] ~ /^called object/ && match(line, /[A-Za-z_0-9]+(\.|->)[A-Za-z_0-9]+ *\(/)) {
        line = line_before(substr(line, RSTART, RLENGTH), "(")
        return line "(...) is a call of a function; an element of an array is " line "[...]."
    }
    if (text[i] ~ /^called object/)
        return line ~ /(^|[^A-Za-z_0-9])[0-9.]+ *\(|\) *\(/ \
            ? "a * is missing before the bracket: 2(x) is 2 * (x)." : ""
    if (text[i] ~ /^conversion to non-scalar type|^used type '[A-Za-z]*' where arithmetic|^cannot convert a value of type .* to vector type|^invalid conversion between vector type/ &&
        cast_to(line) != "")
        return with_article(cast_to(line)) " is written " written(cast_to(line)) "."
    if (is_comma(i) || wanted[i] != "" && comma_in[statement[i]])
        return help_comma(i)
    if (is_vector(i) && has_vector_product(line, line_number[i]))
        return "v * w multiplies component by component and is a vector; for a number, say " \
            "vec3_dot(v, w)."
    if (is_vector(i))
        return "a vector stands where a number is wanted. v * w is a vector, too; for a number, " \
            "say vec3_dot(v, w), vec3_length(v) or v[0]." \
            (text[i] ~ /initializ/ ? " Or is the type of the variable wrong?" : "")
    if (wanted[i] != "" && given[i] != "")
        return help_types(i)
    if (ends_at_once(line_number[i]) && text[i] ~ /clause does not guard|empty body/)
        return help_loop(line_number[i])
    if (text[i] ~ /clause does not guard|^misleading indentation/)
        return "without braces { } only one statement belongs to it."
    if (text[i] ~ /^type defaults to 'int'|^type specifier missing/ && line ~ /^ *auto /)
        return help_type_missing("auto")
    if (is_unknown(i))
        return help_unknown(i)
    if (is_count(i))
        return help_count(i)
    if (is_signature(i))
        return help_signature(i)
    if (text[i] ~ /discards '?(const|qualifiers)/)
        return "what it points to is not yours to change: put const in front of the pointer's type."
    if (text[i] ~ /^parameter names .without types|^a parameter list without types/)
        return "that declares a function. A variable gets its value by =, as in Pixel pixel = {column, row};"
    if (text[i] ~ /^invalid initializer/ && wanted[i] in members)
        return with_article(wanted[i]) " is wanted here: " written(wanted[i]) "."
    if (text[i] ~ /^'return' with no value|should return a value/)
        return "this return gives nothing back: behind it belongs what it is to give back."
    if (is_missing_return(i))
        return help_missing_return(lost_in[beginning(line_number[i])])
    return ""
}

# Whether two vectors are multiplied in this line.
function has_vector_product(line, number,   i, left, right) {
    for (i = 2; i < length(line); i++)
        if (substr(line, i, 1) == "*") {
            left = line_before(substr(line, 1, i), "*")
            right = substr(line, i + 1)
            sub(/^ */, "", right)
            match(right, /^[A-Za-z_0-9.]*(->[A-Za-z_0-9.]*)*/)
            right = substr(right, 1, RLENGTH)
            if (type_of(expression_at_end(left), number) == "vec3" && type_of(right, number) == "vec3")
                return 1
        }
    return 0
}

function help_missing_return(lost) {
    return "the function ends without return: what it gives back is then whatever is lying about." \
        (lost ? " Line " lost " computes something and does not give it back." : "")
}

function help_brace(i) {
    if (line_number[i] < last_line && text[i] !~ /^function/)
        return "a } is missing in line " line_number[i] "."
    return "a } is missing, in or before the function that begins in line " open_function "."
}

# A type, or a { or [, where there should be a value.
function help_expression(i, line,   type, how) {
    type = text[i] ~ /^unexpected type|'[A-Za-z]/ ? quoted(text[i]) : ""
    if (type != "") {
        how = written(type)
        if (substr(behind[i], length(type) + 1) ~ /^ *[({]/ && how != "")
            return type " is a type and no function: " (type == "vec3" ? "write " how "." \
                : how " makes one.")
        return ahead[i] ~ /[(,] *$/ && how != "" \
            ? "a call has values in its brackets, without their types." : ""
    }
    if (behind[i] !~ /^[{[]/)
        return ""
    type = type_here(i, line)
    how = written(type)
    return type == "vec3" ? "a vec3 is written " how "." \
        : "braces make a value with their type in front of them" \
          (how != "" ? ": " how "." : ", as in (Ray){origin, direction}.")
}

# The type that a return or an assignment wants.
function type_here(i, line) {
    read_headers()
    if (line ~ /(^|[^A-Za-z_0-9])return[^A-Za-z_0-9]/)
        return gives[function_at[beginning(line_number[i])]]
    return type_of(expression_at_end(line_before(line, "=")), line_number[i])
}

function help_semicolon(i,   rest) {
    rest = behind[i]
    sub(/^\^?/, "", rest)
    sub(/\/\/.*/, "", rest)
    if (code[line_number[i]] ~ /(^|[^A-Za-z_0-9])for *\([^;]*(;[^;]*)?$/)
        return "for (...; ...; ...) has two semicolons between its three parts."
    if (quoted_line[i] == "")
        return "a semicolon is missing in line " line_number[i] ", or at the end of the one before."
    if (ahead[i] ~ /^ *$/)
        return "a semicolon is missing at the end of line " code_before(line_number[i]) "."
    gsub(/[ })]/, "", rest)
    if (rest == "")
        return "a semicolon is missing at the end of line " line_number[i] "."
    return "in line " line_number[i] " a semicolon is missing, or an operator (2 t is 2 * t)."
}

# The last line with code in it, before this one.
function code_before(number) {
    for (number--; number > 0 && code[number] ~ /^ *$/; number--)
        ;
    return number
}

function help_subscript(i,   type) {
    type = type_of(expression_at_end(ahead[i]), line_number[i])
    return type in members ? with_article(type) " has no numbered parts: they are called " members[type] "." : ""
}

# A struct in a sum or a product.
function help_operands(i,   part, k, type) {
    for (k = split(text[i], part, "'"); k > 0; k--) {
        type = bare_type(part[k])
        read_headers()
        if (type in members)
            return "there is no arithmetic with " with_article(type) " as a whole: its parts are " members[type] "."
    }
    return ""
}

# How many more ( than ) the statement of this line has.
function brackets(number,   text) {
    text = statement_text(number)
    return gsub(/\(/, "", text) - gsub(/\)/, "", text)
}

function help_arrow(i,   name, member, type) {
    name = expression_at_end(ahead[i])
    member = behind[i]
    sub(/^(\.|->) */, "", member)
    match(member, /^[A-Za-z_0-9]*/)
    member = substr(member, 1, RLENGTH)
    if (member == "")
        return ""
    if (name == "")
        return text[i] ~ /did you mean to use '->'/ ? "after a pointer comes -> and not a dot: ->" member "." : ""
    type = type_of(name, line_number[i])
    if (type in members && !((type, member) in field_type))
        return name (text[i] ~ /to use '->'/ ? " points to " : " is ") with_article(type) ", whose parts are " members[type] "." \
            (type == "Sphere" && ("Surface", member) in field_type \
                ? " How it looks is said by scene_surface(scene, i)->" member "." : "")
    if (text[i] ~ /did you mean to use '->'/)
        return name " is a pointer: say " name "->" member "."
    return name " is no pointer: say " name "." member "."
}

function help_parts(i,   name, type, member) {
    name = expression_at_end(ahead[i])
    type = text[i] ~ /base type/ ? bare_type(quoted(text[i])) : type_of(name, line_number[i])
    member = behind[i]
    sub(/^(\.|->) */, "", member)
    sub(/[^A-Za-z_0-9].*/, "", member)
    read_headers()
    if (ahead[i] ~ / $/)
        return "a dot between blanks is no product: numbers are multiplied by *, and v . w is vec3_dot(v, w)."
    if (type == "vec3" || type == "Color")
        return "a vec3 has no parts with names: its components are v[0], v[1], v[2]."
    if (is_number(type))
        return (name == "" ? "this" : name) " is a number and has no parts." \
            (whole_of(member, line_number[i]) != "" \
                ? " " member " is a part of " (owner == "" ? "others" : with_article(owner)) ". Say " whole_of(member, line_number[i]) "." : "")
    return "what stands before the dot has no parts with names: a number has none, and those of " \
        "a vec3 are v[0], v[1], v[2]."
}

function help_member(i,   type) {
    type = bare_type(quoted(text[i], text[i] !~ /^'/))
    read_headers()
    return type in members ? "the parts of " with_article(type) " are " members[type] " (" \
        header_of[type] ")." (translation[i] != "" ? " The slide's " letters_of[begins[i]] "." : "") : ""
}

function help_power(i, what, line,   name) {
    name = ahead[i]
    sub(/[ *]*$/, "", name)
    name = expression_at_end(name)
    if (name == "")
        name = "x"
    if (text[i] ~ /'vec3'/ || type_of(name, line_number[i]) == "vec3")
        return what ": for v . v, write vec3_dot(" name ", " name ")."
    line = behind[i]
    sub(/^[*^ ]+/, "", line)
    if (line !~ /^2([^0-9.]|$)/ && match(line, /^[A-Za-z_0-9.]+/))
        return what ": write pow(" name ", " substr(line, 1, RLENGTH) ")."
    return what ": write " name " * " name "."
}

function help_times(line,   digits, name) {
    if (!match(" " line, /[^A-Za-z_0-9.][0-9][0-9.]*[A-Za-z_][A-Za-z_0-9.]*/))
        return "a * is missing: 2x is 2 * x."
    name = digits = substr(line, RSTART, RLENGTH - 1)
    sub(/[A-Za-z_].*/, "", digits)
    return "a * is missing: " digits " * " substr(name, length(digits) + 1) "."
}

# The type whose name stands in brackets before other brackets, if that is how students make one.
function cast_to(line,   type) {
    if (!match(line, /\([A-Za-z0-9]+\) *\(/))
        return ""
    type = substr(line, RSTART + 1, RLENGTH - 1)
    sub(/\).*/, "", type)
    return written(type) != "" ? type : ""
}

function capital(words) {
    return toupper(substr(words, 1, 1)) substr(words, 2)
}

function help_comma(i,   type) {
    type = wanted[i] != "" ? wanted[i] : type_here(i, code[line_number[i]])
    return "a, b is only b, in brackets too: what stands before the comma is lost." \
        (written(type) != "" ? " " capital(with_article(type)) " is written " written(type) "." : "")
}

function help_types(i,   here, what, called, by, how) {
    read_headers()
    if (given[i] ~ /\(\*\)/)
        return expression_here(i) " is a function here. A variable gets its value by =, as in Pixel pixel = {column, row};"
    here = function_at[beginning(line_number[i])]
    called = text[i] ~ /argument|^passing/ ? called_at(i) : ""
    if (text[i] ~ /returning/)
        what = here " gives back " with_article(wanted[i]) \
            (here in header_of ? " (" header_of[here] ")" : "")
    else
        what = called != "" ? called " wants " with_article(wanted[i]) " there" \
            : with_article(wanted[i]) " is wanted here"
    what = what ", and this is " with_article(given[i]) "."
    by = makers(wanted[i], given[i], here)
    if (called in prototype_of && is_swapped(called, line_number[i]))
        return substr(what, 1, length(what) - 1) ": the arguments are in another order. Its prototype is  " \
            prototype_of[called] "  in " header_of[called] "."
    if (text[i] ~ /assigning/ && wanted[i] == given[i] " *") {
        how = expression_at_end(line_before(code[line_number[i]], "="))
        return what (is_number(given[i]) ? " One of the numbers there is " how "[i]." \
            : " To store it where " how " points, say *" how " = ...")
    }
    if (text[i] ~ /assigning/ && code[line_number[i]] ~ /[^=<>!]=[^=].*\?/)
        return what " To compare, write ==."
    if (given[i] == wanted[i] " *" || given[i] == wanted[i] "*")
        return what " " (behind[i] ~ /^&/ ? "Take the & away." \
            : expression_here(i) ~ /(spheres|lights|surfaces)$/ ? "One of them is " expression_here(i) "[i]." \
            : "A * in front of a pointer is what it points to.")
    if (wanted[i] == given[i] " *")
        return what " " (behind[i] ~ /^\*/ ? "Take the * away: without it, it is a pointer." \
            : "A & in front makes a pointer to it.")
    if (by != "")
        return what " " by "."
    if (called in prototype_of)
        return what " Its prototype is  " prototype_of[called] "  in " header_of[called] "."
    if (match(code[line_number[i]], "^ *(const )?" wanted[i] " +[A-Za-z_0-9]+ *="))
        return what " Is the type of the variable right?"
    how = written(wanted[i])
    if (how != "")
        return what " Write " how "."
    if (wanted[i] in one_of)
        return what " " capital(with_article(wanted[i])) " is one of " one_of[wanted[i]] " (" header_of[wanted[i]] ")."
    return what (given[i] in members ? " Its parts are " members[given[i]] "." : "")
}

# What begins at the caret, as far as it is a name with its parts.
function expression_here(i,   first) {
    first = behind[i] ~ /^(\.|->)/ ? expression_at_end(ahead[i]) : ""
    return match(first behind[i], /^[A-Za-z_][A-Za-z_0-9]*((\.|->)[A-Za-z_][A-Za-z_0-9]*)*/) \
        ? substr(first behind[i], 1, RLENGTH) : ""
}

# Whether a call of this function, in this statement, has its arguments in another order than the
# prototype: two of them where the other is wanted, or all of the types that are wanted.
function is_swapped(called, number,   text, at, part, type, count, k, l, left) {
    text = statement_text(number)
    while (match(text, "[^A-Za-z_0-9]" called " *\\(")) {
        text = substr(text, RSTART + RLENGTH)
        count = split_arguments(text, part)
        if (count != parameter_types(prototype_of[called], type))
            continue
        split("", left)
        for (k = 1; k <= count; k++) {
            part[k] = expression_type(part[k], number)
            part[k] = is_number(part[k]) ? "double" : part[k]
            type[k] = is_number(type[k]) ? "double" : type[k]
            left[type[k]]++
            left[part[k]]--
        }
        at = 0
        for (k = 1; k <= count; k++) {
            at += left[type[k]] != 0
            for (l = 1; l < k; l++)
                if (part[k] == type[l] && part[l] == type[k] && part[k] != part[l])
                    return 1
        }
        for (k = 1; k <= count && !at; k++)
            if (part[k] != type[k])
                return 1
    }
    return 0
}

# The arguments of a call, from behind its bracket on.
function split_arguments(text, part,   i, c, depth, count) {
    split("", part)
    count = 1
    for (i = 1; i <= length(text); i++) {
        c = substr(text, i, 1)
        depth += (c ~ /[({[]/) - (c ~ /[])}]/)
        if (depth < 0)
            break
        if (c == "," && depth == 0)
            count++
        else
            part[count] = part[count] c
    }
    return count
}

# The type of an argument where it can be seen, or "".
function expression_type(text, number,   type) {
    gsub(/^[ *&-]+|[ ]+$/, "", text)
    if (text ~ /^[0-9.][0-9.e]*$/)
        return text ~ /[.e]/ ? "double" : "int"
    if (match(text, /^[A-Za-z_0-9]+ *\(.*\)$/))
        type = gives[line_before(text, "(")]
    else if (match(text, /^\([A-Za-z0-9]+\) *\{.*\}$/))
        type = substr(text, 2, index(text, ")") - 2)
    else if (expression_at_end(text) == text)
        type = type_of(text, number)
    return type
}

# The function whose argument is wrong.
function called_at(i,   line) {
    if (text[i] ~ / of '/)
        return quoted(text[i])
    line = ahead[i]
    while (gsub(/\([^()]*\)/, "", line) > 0)
        ;
    return match(line, /[A-Za-z_0-9]+\([^()]*$/) ? line_before(substr(line, RSTART), "(") : ""
}

function help_loop(number) {
    return "the ; behind " (code[number] ~ /(^|[^A-Za-z_0-9])for *\(/ \
        ? "for (...) in line " number " ends the loop" \
        : "the bracket in line " number " ends the statement") \
        ": what follows is no longer part of it. Take the ; away."
}

function help_type_missing(name) {
    return "C has no " name ": in front of a new variable stands its type, as in double x or " \
        "vec3 v."
}

function help_unknown(i,   name, number, line) {
    name = quoted(text[i])
    number = line_number[i]
    read_headers()
    if (name == "M_PI")
        return "C11 has no M_PI: say PI (common/vec3.h)."
    if (name == "std")
        return "C has no std:: - the functions of <math.h> have no such prefix, as in sqrt(x)."
    if (name == "new")
        return "C has no new: a struct is written (Ray){origin, direction}, a vec3 " \
            "vec3_of(x, y, z)."
    if (name ~ /^(let|var|auto|def)$/)
        return help_type_missing(name)
    if (name ~ /^return[a-z]/)
        return "a blank is missing: return " substr(name, 7)
    if (library[i] != "" || name in library_of)
        return name " is in the standard library: #include " (library[i] != "" ? library[i] : library_of[name])
    if (name in defined_in && defined_in[name] > number && text[i] ~ /function '/)
        return name " is defined further down, in line " defined_in[name] ": move it above its use."
    if (lacks_contract[i])
        return "#include \"" contract "\" is missing at the top of this file."
    if (translation[i] != "")
        return "the slide's " letters_of[begins[i]] "."
    line = behind[i]
    if (sub("^" name "(\\.|->)", "", line) && match(line, /^[A-Za-z_0-9]+/)) {
        line = whole_of(substr(line, 1, RLENGTH), number)
        if (line != "")
            return "nothing here is called " name ". " (owner == "" ? "It" : "The " owner) \
                " has another name here: say " line "."
    }
    if (text[i] !~ /function '/ && whole_of(name, number) != "")
        return name (owner == "" ? " is the name of parts" \
            : " is a part of " with_article(owner) " (" header_of[owner] ")") ": say " whole_of(name, number) "."
    if (name in header_of && !(header_of[name] in included) && header_of[name] != contract)
        return name " is declared elsewhere: #include \"" header_of[name] "\""
    if (text[i] ~ /^unknown type name/ && tolower(name) ~ /^(d?vec[34]?|vector3?|point3?|float3|double3)$/)
        return "the type of points, vectors and colours is vec3 (common/vec3.h)."
    if (name in known)
        return known[name] in prototype_of ? "here its name is " known[name] ": " \
            prototype_of[known[name]] "  in " header_of[known[name]] "." \
            : "in C its name is " known[name] "."
    if (name ~ /^(sqr|sq|square|squared)$/)
        return "C has no square: write x * x."
    if (code[number] ~ "(^|[^A-Za-z_0-9])for *\\( *" name " *=")
        return name " is not declared: for (int " name " = ...; ...; ...)."
    line = loop_of(name, number)
    if (line && ends_at_once(line))
        return help_loop(line)
    if (line)
        return name " is known only inside the loop of line " line "."
    for (line in header_of)
        if (tolower(line) == tolower(name) && line != name &&
            (line ~ /^[A-Z][A-Z_0-9]+$/ || text[i] ~ /unknown type/) && (header_of[line] !~ /^exercises/ || header_of[line] <= contract))
            return "nothing here is called " name ". It is written " line " (" header_of[line] ")."
    if (match(text[i] body[i], /did you mean '[A-Za-z_0-9]+'/)) {
        line = quoted(substr(text[i] body[i], RSTART, RLENGTH))
        if (line in header_of && tolower(line) != tolower(name))
            return "nothing here is called " name ". " line " is in " header_of[line] "."
    }
    if (text[i] !~ /function '|unknown type/ && capital(name) in members)
        return "nothing here is called " name ". A " capital(name) " of your own is declared first: " \
            capital(name) "\001" name "\001=\001...;"
    line = text[i] ~ /function '|unknown type/ ? "" : parameters(number)
    line = line == "" ? "" : " " function_at[begins[i]] " is given " line "."
    if (length(name) > 1)
        return "nothing here is called " name ". Is it spelled as in the contract, " contract "?" line
    return "nothing here is called " (is_letter[i] ? strange_letters[begins[i]] : name) "." line \
        " A variable of your own is declared first, with its type."
}

function help_signature(i,   name, first) {
    name = text[i] ~ /^argument/ ? function_at[begins[i]] : quoted(text[i])
    read_scope(line_number[i])
    for (first = 1; first <= parameter_count; first++)
        if (in_scope[first] == name)
            return name " is given to " function_at[begins[i]] " already: give yours another name."
    if (text[i] ~ /^redefinition/) {
        for (first = 1; first < line_number[i] && function_at[first] != name; first++)
            ;
        return first < line_number[i] ? name " is defined already, in line " first "." \
            : name in header_of ? name " is in " header_of[name] " already: use that one, or give yours another name." \
            : ""
    }
    if (!(name in prototype_of))
        return ""
    if (text[i] ~ /static declaration/)
        return "take the static in front of " name " away: it is called from other files."
    return header_of[name] == contract ? "the contract, " contract ", says  " prototype_of[name] \
        ": your function has to begin like that." \
        : name " is in " header_of[name] " already, as  " prototype_of[name] ": give yours another name."
}

function help_count(i,   name) {
    name = declared[i] != "" ? declared[i] : quoted(substr(text[i], index(text[i], "function")))
    # clang tells the name only in its note, and none where the function is built in.
    if (name == "" || text[i] ~ /function call/ && declared[i] == "")
        return "look at the prototype of the function: it says what it takes."
    read_headers()
    if (name in prototype_of)
        return "its prototype is  " prototype_of[name] "  in " header_of[name] "."
    return "look at the prototype of " name ": it says what it takes."
}
