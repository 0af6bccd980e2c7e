# proxies.awk - makes C from tests/exercises.table.
#
#   -v make=weak        a pragma per exercise: its definition gives way to another
#   -v make=reference   a define per exercise: the reference goes by reference_NAME
#                       (-v stem=NN-stem: only of that chapter, right_NAME: it calls the other chapters
#                       by their contract names)
#   -v make=rights      for a picture: a table of those
#   -v make=proxies     for the judge: each exercise under its own name, asking whoever answers;
#                       what came out is held against the mistakes and the laws
#   -v make=dispatch -v stem=NN-stem   for the answering process: one call of one exercise
#                       (stem=all: of any)
#   -v make=apply       the same by a function that is given: the reference, or a known mistake
#   -v make=lent -v stem=NN-stem       for it, too: lent_NAME asks the judge for the reference's answer
#   -v make=layouts     which types each takes and gives, as words (tests/told/layout.h)
#   -v make=exercises   their names, where there is no reference
#
# How a type crosses the pipe follows from how it is passed: by value as it is; a const Scene with
# its arrays; a Camera or an Image there and back; doubles one per pixel of the image, there and back.
BEGIN {
    FS = " [|] "
}
/^#/ || NF == 0 {
    next
}
{
    number++
    open = index($2, "(")
    head = substr($2, 1, open - 1)
    name = head
    sub(/.*[ *]/, "", name)
    result = substr(head, 1, length(head) - length(name))
    sub(/ +$/, "", result)
    list = substr($2, open + 1, length($2) - open - 1)
    count = split(list, parts, /, */)
    names = ""
    for (i = 1; i <= count; i++) {
        variable[i] = parts[i]
        sub(/.*[ *]/, "", variable[i])
        type[i] = substr(parts[i], 1, length(parts[i]) - length(variable[i]))
        sub(/ +$/, "", type[i])
        names = names (i > 1 ? ", " : "") variable[i]
    }
}
make == "weak" {
    # What is in another chapter is not declared here, which clang warns of, but not in system headers.
    print (number == 1 ? "#pragma GCC system_header\n" : "") "#pragma weak " name
}
make == "reference" && (stem == "" || stem == $1) {
    print "#define " name " " (stem == "" ? "reference_" : "right_") name
}
make == "rights" {
    if (number == 1)
        print "// Made from tests/exercises.table by .make/proxies.awk.\n" \
            "#include \"tests/judge/exercise.h\"\n"
    print "void right_" name "(void);"
    table = table "    right_" name ",\n"
}
make == "proxies" {
    if (number == 1)
        proxies_head()
    include_contract()
    proxy()
    table = table sprintf("    {\"%s\", \"%s\", \"%s\", \"%s\", (AnyFunction *)reference_%s},\n",
                          name, $1, $3, $4, name)
}
make == "lent" && $1 == stem {
    if (!lent++) {
        includes()
        print "#include \"tests/judge/call.h\"\n"
        include_contract()
    }
    lend()
}
make == "layouts" {
    print (number == 1 ? "#include \"tests/told/layout.h\"\n\nconst Layout layouts[] = {\n" : "") \
        "    {\"" layout(0) "\", \"" layout(1) "\"},"
}
make == "exercises" {
    print (number == 1 ? "#include \"tests/judge/exercise.h\"\n\n#include <stddef.h>\n\n" \
           "const Exercise exercises[] = {\n" : "") \
        sprintf("    {\"%s\", \"%s\", \"%s\", \"%s\", NULL},", name, $1, $3, $4)
}
make == "dispatch" || make == "apply" {
    if ($1 == stem || stem == "all") {
        if (!dispatched++)
            dispatch_head()
        dispatch()
    }
}
END {
    if (make == "layouts")
        print "};"
    if (make == "exercises")
        print "    {0},\n};"
    if (make == "proxies")
        print "const Exercise exercises[] = {\n" table "    {0},\n};"
    if (make == "rights")
        print "extern AnyFunction *const rights[];\nAnyFunction *const rights[] = {\n" table "};"
    if (make == "dispatch" || make == "apply")
        print "    default:\n        return false;\n    }\n}"
}

# The types that go in, or that come out.
function layout(out,   i, word, words) {
    words = out && result != "void" ? " " result : ""
    for (i = 1; i <= count; i++) {
        word = type[i]
        if (out && word !~ /^(Camera|Image|double) \*$/)
            continue
        if (word ~ /^(Image|double) \*$/)
            word = word == "double *" ? "Doubles" : out ? "Pixels" : "Image"
        gsub(/^const | \*$/, "", word)
        words = words " " word
    }
    return substr(words, 2)
}

function includes() {
    print "// Made from tests/exercises.table by .make/proxies.awk."
    print "#include \"tests/judge/wire.h\""
}

function proxies_head() {
    includes()
    print "#include \"tests/judge/call.h\"\n#include \"tests/judge/exercise.h\""
    print "#include \"tests/judge/hearing.h\"\n#include \"tests/judge/suspects.h\"\n"
}

# What the answer made of the call is heard beside the known mistakes (tests/judge/hearing.h).
function proxy(   i, is_void, cast) {
    is_void = result == "void"
    cast = result " (*)(" list ")"
    print "// " name
    print result " reference_" name "(" list ");"
    print "void law_" name "(" (is_void ? "" : result " yours, ") list ");\n"
    print result " " name "(" list ")\n{\n    enum { ME = " number - 1 " };"
    if (!is_void)
        print "    " result " yours;"
    print "    Wire *heard = hear_question(ME);\n    if (heard != NULL) {"
    for (i = 1; i <= count; i++)
        put("        ", i, "heard")
    print "    }"
    print "    AnyFunction *local = local_answer(ME);\n    if (local != NULL) {"
    print "        " (is_void ? "" : "yours = ") "((" cast ")local)(" names ");"
    print "    } else {"
    ask("        ", is_void)
    print "    }"
    print "    heard = hear_answer(ME);\n    if (heard != NULL) {"
    if (!is_void)
        print "        wire_put(heard, &yours, sizeof yours);"
    for (i = 1; i <= count; i++)
        put_back("        ", i, "heard", "")
    print "        hear(ME);\n    }"
    print "    if (law_begin(ME))\n        law_" name "(" (is_void ? "" : "yours, ") names ");"
    if (!is_void)
        print "    return yours;"
    print "}\n"
}

# Puts the arguments, waits, gets what came out.
function ask(indent, is_void,   i) {
    print indent "Wire *wire = call_begin(ME);"
    for (i = 1; i <= count; i++)
        put(indent, i, "wire")
    print indent "wire = call_finish(ME);"
    if (!is_void)
        print indent "wire_get(wire, &yours, sizeof yours);"
    for (i = 1; i <= count; i++)
        get_back(indent, i)
    print indent "call_end(ME);"
}

function lend(   is_void) {
    is_void = result == "void"
    print result " lent_" name "(" list ");"
    print result " lent_" name "(" list ")\n{\n    enum { ME = " number - 1 " };"
    if (!is_void)
        print "    " result " yours;"
    ask("    ", is_void)
    print (is_void ? "" : "    return yours;\n") "}\n"
}

function put(indent, i, wire) {
    if (type[i] == "const Scene *")
        print indent "wire_put_scene(" wire ", " variable[i] ");"
    else if (type[i] == "Image *")
        print indent "wire_put_image(" wire ", " variable[i] ");"
    else if (type[i] == "double *")
        print indent "wire_put_doubles(" wire ", " variable[i] ", image);"
    else if (type[i] ~ /^(Camera( \*)?|Sphere|Light|Hit)$/)
        print indent "wire_put_" tolower(substr(type[i] " ", 1, index(type[i] " ", " ") - 1)) "(" wire ", " \
            (type[i] ~ /\*$/ ? "" : "&") variable[i] ");"
    else if (type[i] ~ /\*$/)
        print indent "wire_put(" wire ", " variable[i] ", sizeof *" variable[i] ");"
    else
        print indent "wire_put(" wire ", &" variable[i] ", sizeof " variable[i] ");"
}

# What comes out by a pointer. given: behind the names of what it points to, as it was given.
function put_back(indent, i, wire, given,   v) {
    v = variable[i]
    if (type[i] == "Camera *")
        print indent "wire_put(" wire ", " v ", sizeof *" v ");"
    if (type[i] == "Image *")
        print indent "wire_put_pixels(" wire ", " (given == "" ? v : "&" v given) ");"
    if (type[i] == "double *")
        print indent "wire_put_doubles(" wire ", " v given ", " (given == "" ? "image" : "&image" given) ");"
    if (given != "" && type[i] == "Image *")
        print indent wire "->overran |= wire_pixels_overran(&" v given ");"
    if (given != "" && type[i] == "double *")
        print indent wire "->overran |= wire_doubles_overran(" v given ", &image" given ");"
}

function get_back(indent, i) {
    if (type[i] == "Camera *")
        print indent "wire_get(wire, " variable[i] ", sizeof *" variable[i] ");"
    if (type[i] == "Image *")
        print indent "wire_get_pixels(wire, " variable[i] ");"
    if (type[i] == "double *")
        print indent "wire_get_into_doubles(wire, " variable[i] ", image);"
}

# Before the first exercise of a stem.
function include_contract() {
    if (!($1 in included))
        print "#include \"exercises/" $1 ".h\"\n"
    included[$1] = 1
}

function dispatch_head(   line, part) {
    includes()
    if (stem == "all")
        while ((getline line < FILENAME) > 0)
            if (split(line, part, FS) > 1 && line !~ /^#/ && !seen[part[1]]++)
                print "#include \"exercises/" part[1] ".h\""
    if (stem != "all")
        include_contract()
    print "#include \"tests/judge/" make ".h\"\n"
    if (make == "dispatch")
        print "void (*before_dispatched_call)(void);\n"
    print "bool " make "(int exercise, " (make == "apply" ? "AnyFunction *answer, " : "") \
        "Wire *in, Wire *wire)\n{\n    switch (exercise) {"
}

# One call, by the exercise's name or by a function that is given.
# What the reference relies on, if a student's process asks for it.
function conditions(   i, text) {
    for (i = 1; i <= count; i++) {
        if (type[i] == "Hit")
            text = text " || !wire_allows_hit(in, " variable[i] ", scene)"
        if (type[i] == "int")
            text = text " || !wire_allows_depth(in, " variable[i] ")"
        if (type[i] == "Light")
            text = text " || !wire_allows_light(in, " variable[i] ")"
        if (type[i] == "Handedness")
            text = text " || !wire_allows_world(in, " variable[i] ")"
    }
    return text
}

function dispatch(   i, v, called) {
    called = make == "apply" ? "((" result " (*)(" list "))answer)" : name
    print "    case " number - 1 ": {"
    for (i = 1; i <= count; i++) {
        v = variable[i]
        if (type[i] == "const Scene *")
            print "        Scene " v "_value;\n        const Scene *" v " = &" v "_value;\n" \
                "        wire_get_scene(in, &" v "_value);"
        else if (type[i] == "Image *")
            print "        Image " v "_value;\n        Image *" v " = &" v "_value;\n" \
                "        wire_get_image(in, &" v "_value);\n        const Image " v "_given = " v "_value;"
        else if (type[i] == "double *")
            print "        double *" v " = wire_get_doubles(in, image);\n        double *" v "_given = " v ";"
        else if (type[i] ~ /\*$/)
            print "        " substr(type[i], 1, length(type[i]) - 2) " " v "_value;\n        " type[i] v \
                " = &" v "_value;\n        wire_get(in, " v ", sizeof *" v ");"
        else
            print "        " type[i] " " v ";\n        wire_get(in, &" v ", sizeof " v ");"
    }
    print "        if (!wire_is_read(in)" conditions() ") {"
    free_arguments("            ")
    print "            return false;\n        }"
    if (make == "dispatch")
        print "        if (before_dispatched_call != NULL)\n            before_dispatched_call();"
    if (result == "void")
        print "        " called "(" names ");"
    else
        print "        " result " yours = " called "(" names ");\n        wire_put(wire, &yours, sizeof yours);"
    for (i = 1; i <= count; i++) {
        put_back("        ", i, "wire", "_given")
    }
    free_arguments("        ")
    print "        return true;\n    }"
}

function free_arguments(indent,   i, v) {
    for (i = count; i >= 1; i--) {
        v = variable[i]
        if (type[i] == "double *")
            print indent "free(" v "_given);"
        if (type[i] == "Image *")
            print indent "free(" v "_given.rgb);"
        if (type[i] == "const Scene *")
            print indent "scene_free(&" v "_value);"
    }
}
