#!/bin/sh
# mutants.sh - are the tests strict? One slip at a time in a solution: some test must fail.
#
# Every line between BEGIN SOLUTION and END SOLUTION is taken once for each sign, factor, operand,
# comparison and index in it, with that one changed. A mutant that passes all tests of its stem,
# graded and extra, has survived: the tests have a hole, or the change changes nothing that the
# contract promises. The latter are listed, with the reason, in tests/proof/equivalent-mutants.
set -u

# ---- one mutant: compiled, linked, tested -------------------------------------------------------

# Usage: mutants.sh --one FOLDER NUMBER. Says in FOLDER/results/NUMBER how it ended.
if [ "${1:-}" = --one ]; then
    folder=$2
    mutant=$folder/mutant-$3
    mkdir "$mutant"
    IFS='	' read -r stem line text <<LINE
$(sed -n "$3p" "$folder/mutants")
LINE
    # Handed over in the environment: awk would take a backslash in -v for its own.
    text=$text awk -v line="$line" 'FNR == line { print ENVIRON["text"]; next } { print }' \
        "solutions/$stem.c" >"$mutant/$stem.c"
    # shellcheck disable=SC2086 # the compiler's flags are words
    if $COMPILER $BOUNDS -O1 -g0 -w -c -o "$mutant/answer.o" "$mutant/$stem.c" &&
        sed "s|@|$mutant|g" "$folder/link-$stem" | sh; then
        # shellcheck disable=SC3045
        ulimit -c 0 2>/dev/null # where the shell can: no core files
        if timeout 10 "$mutant/tests"; then
            result=survived
        else
            result=killed
        fi
    else
        result=invalid
    fi >/dev/null 2>&1
    printf '%s\t%s\t%s\t%s\n' "$result" "$stem" "$line" "$text" >"$folder/results/$3"
    rm -rf "$mutant"
    exit 0
fi

. tests/house/runner/library.sh
once mutants "slips in the solutions"
if [ "${BUILD:-build}" != build ]; then
    skip mutants "mutants: one compiler and the ordinary build tell enough"
fi
COMPILER=${COMPILER:-${CC:-cc} -std=c11 -D_DEFAULT_SOURCE -ffp-contract=off -Wno-psabi -I.}
# An index one too far is a crash, not luck.
BOUNDS="-fsanitize=bounds -fsanitize-undefined-trap-on-error"
# shellcheck disable=SC2086 # the compiler's flags are words
echo 'int f(void) { return 0; }' |
    $COMPILER $BOUNDS -x c -c -o "$scratch/bounds.o" - 2>/dev/null || BOUNDS=""
export COMPILER BOUNDS CK_DEFAULT_TIMEOUT=2
equivalents=tests/proof/equivalent-mutants

# ---- all mutants of a solution ------------------------------------------------------------------

# STEM, line, what that line becomes: one mutant a line.
mutants_of() {
    awk -v stem="$1" '
    BEGIN {
        swap("+", "-"); swap("-", "+"); swap("*", "/"); swap("/", "*"); swap("%", "/")
        swap("+=", "-="); swap("-=", "+="); swap("*=", "/="); swap("/=", "*=")
        swap("++", "--, += 2"); swap("--", "++")
        swap("<", "<=,>"); swap("<=", "<,>"); swap(">", ">=,<"); swap(">=", ">,<")
        swap("==", "!="); swap("!=", "=="); swap("&&", "||"); swap("||", "&&")
        swap("!", " ")

        swap("right", "up"); swap("up", "right"); swap("forward", "right")
        swap("across", "upward,up"); swap("upward", "across")
        swap("width", "height"); swap("height", "width"); swap("distance", "width")
        swap("upper_left", "upper_right,lower_left"); swap("upper_right", "upper_left,lower_right")
        swap("lower_left", "lower_right,upper_left"); swap("lower_right", "lower_left,upper_right")
        swap("column", "row"); swap("row", "column"); swap("x", "y"); swap("y", "x")
        swap("origin", "direction"); swap("direction", "origin"); swap("at", "eye"); swap("eye", "at")
        swap("s", "t"); swap("t", "s,u"); swap("u", "t"); swap("p", "v"); swap("v", "p")
        swap("c", "p"); swap("l", "r"); swap("r", "l"); swap("o", "c"); swap("k", "(-k)")
        swap("size", "speed"); swap("speed", "size"); swap("sum", "d,a"); swap("half_b", "a")
        swap("product", "lost"); swap("lost", "product"); swap("even", "q")
        swap("fmin", "fmax"); swap("fmax", "fmin"); swap("tan", "sin")
        swap("sqrt", " "); swap("fabs", " "); swap("vec3_unit", " "); swap("NO_HIT", "0")
        swap("RIGHT_HANDED", "LEFT_HANDED"); swap("CAMERA_TOLERANCE", "(1e3 * CAMERA_TOLERANCE)")
        field["a"] = "b"; field["b"] = "c"; field["c"] = "a"
    }
    function swap(token, others) { become[token] = others }

    /^ *\/\/ BEGIN SOLUTION$/ { inside = 1; next }
    /^ *\/\/ END SOLUTION$/ { inside = 0; next }
    inside { mutate($0) }

    function mutate(line, code, at, length_of, rest, token, before, i) {
        code = line
        sub(/\/\/.*/, "", code)
        declared = ""
        if (match(code, /^ *[A-Za-z_][A-Za-z_0-9]* [a-z_]+ = /)) {
            declared = substr(code, 1, RLENGTH - 3)
            sub(/.* /, "", declared)
        }
        before = ""
        for (at = 1; at <= length(code); at += length_of) {
            rest = substr(code, at)
            if (match(rest, /^[ \t]+/)) {
                length_of = RLENGTH
                continue
            }
            if (!match(rest, /^0x[0-9a-f]+p-?[0-9]+/) && !match(rest, /^[0-9]+(\.[0-9]+)?/) &&
                !match(rest, /^[A-Za-z_][A-Za-z_0-9]*/) &&
                !match(rest, /^(->|[-+]=|\+\+|--|[*\/<>=!]=|&&|\|\|)/))
                match(rest, /^./)
            length_of = RLENGTH
            token = substr(code, at, length_of)
            if (before == "." && token in field)
                change(line, at, length_of, field[token])
            else if (token in become)
                change(line, at, length_of, become[token])
            else if (token ~ /^CAMERA_/)
                change(line, at, length_of, "CAMERA_NOT_UNIT")
            else if (token ~ /^[0-9]/)
                change(line, at, length_of, other_numbers(token))
            else if (token == "vec3_cross" && match(rest, /^vec3_cross\([^(),]+, [^(),]+\)/))
                change(line, at, RLENGTH, crossed(substr(rest, 1, RLENGTH)))
            before = token
        }
    }

    function other_numbers(token) {
        if (token ~ /^0x/) {
            match(token, /p-?/)
            return substr(token, 1, RSTART + RLENGTH - 1) 2 * substr(token, RSTART + RLENGTH)
        }
        if (token == "0.5")
            return "0,1"
        if (token ~ /\./)
            return token + 0.1
        if (token == 0)
            return 1
        return token >= 100 ? 2 * token : (token - 1) "," (token + 1)
    }

    function crossed(call, part) {
        split(call, part, /[(,)] */)
        return part[1] "(" part[3] "; " part[2] ")"
    }

    # Commas part the alternatives; a semicolon stands for the one inside.
    function change(line, at, length_of, others, other, count, i, text) {
        count = split(others, other, ",")
        for (i = 1; i <= count; i++) {
            if (other[i] == declared) # a variable in its own first value: anything may come of it
                continue
            sub(/;/, ",", other[i])
            text = substr(line, 1, at - 1) other[i] substr(line, at + length_of)
            if (!((FNR, text) in seen))
                print stem "\t" FNR "\t" text
            seen[FNR, text] = 1
        }
    }' "solutions/$1.c"
}

# ---- everything that is not the mutant, once ----------------------------------------------------

# The command that links the tests of a stem, with @ for the folder of the mutant; then the reference
# takes the mutant's place.
prepare() {
    make --no-print-directory "objects-of-$1" >"$scratch/made" 2>&1 || {
        cat "$scratch/made"
        return 1
    }
    mkdir "$scratch/reference"
    echo "${CC:-cc} -o @/tests @/answer.o $(tail -n 1 "$scratch/made")" >"$scratch/link-$1"
    # shellcheck disable=SC2086 # the compiler's flags are words
    $COMPILER -c -o "$scratch/reference/answer.o" "solutions/$1.c" &&
        sed "s|@|$scratch/reference|g" "$scratch/link-$1" | sh && "$scratch/reference/tests"
    prepared=$?
    rm -r "$scratch/reference"
    return $prepared
}

mkdir "$scratch/results"
for solution in solutions/*.c; do
    stem=$(basename "$solution" .c)
    check "the solution of $stem passes its own tests" prepare "$stem"
    mutants_of "$stem" >>"$scratch/mutants"
done
if [ "$failed" -ne 0 ]; then
    finish mutants
    exit 1
fi

awk '{ print NR }' "$scratch/mutants" |
    xargs -n 1 -P "$(getconf _NPROCESSORS_ONLN 2>/dev/null || echo 2)" \
        "$0" --one "$scratch"
cat "$scratch"/results/* >"$scratch/all"

# ---- the sum ------------------------------------------------------------------------------------

# Mutants in the order of the sources; what is no C does not count.
sort -t '	' -k 2,2 -k 3,3n "$scratch/all" | awk -F '\t' -v equivalents="$equivalents" '
    function trimmed(text) { gsub(/^[ \t]+|[ \t]+$/, "", text); return text }
    BEGIN {
        while ((getline line < equivalents) > 0) {
            number++
            if (line ~ /^#/ || line ~ /^ *$/)
                continue
            if (split(line, part, / \| /) != 3) {
                print "not ok: " equivalents ":" number ": expected: stem | mutated line | reason"
                wrong++
                continue
            }
            listed[trimmed(part[1]) "\t" trimmed(part[2])] = number
        }
    }
    $1 == "invalid" { next }
    {
        key = $2 "\t" trimmed($4)
        if (!($2 in mutants))
            order[++stems] = $2
        mutants[$2]++
        occurs[key] = 1
        if ($1 == "killed") {
            killed[$2]++
            if (key in listed)
                killed_key[key] = 1
        } else if (key in listed) {
            equivalent[$2]++
            survived_key[key] = 1
        } else {
            survived[$2]++
            print "not ok: survived: solutions/" $2 ".c:" $3 ": " trimmed($4)
        }
    }
    END {
        for (key in listed)
            if (!(key in occurs)) {
                wrong++
                print "not ok: stale: " equivalents ":" listed[key] ": no such mutant"
            } else if (!(key in survived_key)) {
                wrong++
                print "not ok: stale: " equivalents ":" listed[key] ": not equivalent, a test fails"
            }
        for (i = 1; i <= stems; i++) {
            stem = order[i]
            printf "+ %s: %d mutants, %d killed, %d survived, %d of them equivalent\n", stem,
                mutants[stem], killed[stem], survived[stem] + equivalent[stem], equivalent[stem]
            good += killed[stem] + equivalent[stem]
            wrong += survived[stem]
        }
        printf "mutants: %d passed, %d failed\n", good, wrong
        exit wrong > 0 || good == 0
    }'
