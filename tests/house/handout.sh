#!/bin/sh
# handout.sh - the students' archive: what is in it, what is not, and that it is the same each time.
set -u
cd "$(dirname "$0")/../.." && . tests/house/runner/library.sh
once handout "the students' archive"

archive=build/handout.tar.gz
make_handout() {
    make --no-print-directory -s handout
}
# The archive unpacked, and the names in it.
look_into() {
    rm -rf "$scratch/tree" && mkdir "$scratch/tree" && tar xzf "$1" -C "$scratch/tree" &&
        tar xf "$scratch/tree/ray-casting/tests/given.tar" -C "$scratch/tree/ray-casting" --one-top-level=build &&
        { tar tzf "$1"; tar tf "$scratch/tree/ray-casting/tests/given.tar" | sed 's|^|ray-casting/build/|'; } >"$scratch/names"
}
none_of_these() {
    ! grep -E "$1" "$scratch/names"
}
# No file of the handout, but for the lessons, has any of these lines (fixed strings).
holds_none_of() {
    [ -s "$1" ] || { echo "nothing to look for"; return 1; }
    ! find "$scratch/tree" -type f ! -path '*/chapters/*/README.md' -exec grep -aoHFf "$1" {} +
}

# Made from a copy of the tree, with an answer in it, no git, and the date of the archive.
elsewhere() {
    mkdir "$scratch/copy" "$scratch/out" &&
        cp -r .make .github .clang-format .editorconfig .gitignore Makefile README.md common chapters \
            exercises tests "$scratch/copy" &&
        echo '// my answer' >>"$scratch/copy/exercises/01-corners.c" &&
        SOURCE_DATE_EPOCH=$(date -r "$scratch/tree/ray-casting/Makefile" +%s) && export SOURCE_DATE_EPOCH &&
        (cd "$scratch/copy" && tests/handout/pack "$scratch/out" "$here/build/tables/handout" "$here/build/blanks" \
            "$here/build/solutions/figures") &&
        cmp "$archive" "$scratch/out/handout.tar.gz"
}
in_one_folder() {
    ! grep -v '^ray-casting/' "$scratch/names"
}
nobody_s() {
    tar tvzf "$archive" --numeric-owner >"$scratch/long"
    awk '$2 != "0/0" { print; bad = 1 } { dates[$4 $5] } END { exit bad || length(dates) != 1 }' \
        "$scratch/long"
}
check 'make handout makes the archive' make_handout
check 'it can be unpacked' look_into "$archive"
check 'made in another tree with answers in exercises/, it has the same bytes' elsewhere
unset SOURCE_DATE_EPOCH
check 'all of it is in one folder' in_one_folder
few_files() {
    [ "$(tar tzf "$archive" | grep -vc '/$')" -le 300 ]
}
check 'it has at most 300 files' few_files
check 'nobody owns it, and all of it has one date' nobody_s

check 'there are no solutions, tests, mistakes, nor what makes the tables or grades in it' none_of_these \
    'solutions|/tests/([0-9][0-9]-[^/]*(\.c$|/(wrong|right|free|verdicts|facts|figures))|proof|house|benches|grade|handout)|/judge/reference|/\.make/toolkit|\.git/|\.ci/|CONTRIBUTING'
only_for_students() {
    ! grep -nE '^(grade|bench|skeletons|handout|check-all):|^KIT' "$scratch/tree/ray-casting/Makefile" \
        "$scratch"/tree/ray-casting/.make/*.mk
}
check 'its Makefile makes nothing that is not for students' only_for_students

# Lines that occur only in answers, not in a blank, in common/ or in a chapter.
awk '/BEGIN SOLUTION/ { inside = 1; next } /END SOLUTION/ { inside = 0 } inside && !/\/\/~/' solutions/*.c |
    sed 's/^ *//; s/ *$//' | awk 'length > 25' | sort -u >"$scratch/answers"
cat build/blanks/*.c common/*.[ch] common/figure/*.[ch] chapters/*/*.[ch] chapters/*/figures/*.[ch] |
    awk 'FNR == NR { given = given "\n" $0; next } index(given, $0) == 0' - "$scratch/answers" >"$scratch/secret"
check 'no line of a solution is in it' holds_none_of "$scratch/secret"
for contract in exercises/*.h; do
    build/tests/matrix "$(basename "$contract" .h)" --formulas
done | grep '[-+*/^|=]' | awk 'length > 7' | sort -u >"$scratch/formulas"
check 'no formula of a mistake is in it' holds_none_of "$scratch/formulas"
# No function of it is an answer in another form: it calls what the reference of that answer calls, in a
# body of its own. (A function that only calls each answer once, to see which are missing, is none.)
repeats_no_answer() {
    find "$scratch/tree" -name '*.c' ! -path '*/exercises/*' ! -path '*/blanks/*' -exec awk '
        function check(answer, calls,    called, i, count) {
            count = split(calls, called, " ")
            for (i = 1; i <= count; i++)
                if (body !~ ("(^|[^a-z_0-9])" called[i] "\\("))
                    return
            if (name !~ /needs_are_met|call_the_rest/) {
                print FILENAME ": " name " does what " answer " is asked for"
                bad = 1
            }
        }
        /^[a-z].*\(/ { name = $0 }
        /^\{/ { body = "" }
        { body = body "\n" $0 }
        /^\}/ {
            check("pixel_ray", "pixel_center screen_to_normalized image_plane_vector")
            check("cast_image_order", "pixel_ray nearest_hit scene_surface")
            check("cast_image_order", "pixel_ray nearest_hit image_set")
            check("cast_image_order", "pixel_ray nearest_hit putchar")
            check("cast_object_order", "pixel_ray hit_sphere scene_surface")
            check("shade", "visibility diffuse_term")
            check("shade", "visibility phong_term")
            check("trace_ray", "hierarchy_nearest mirror_direction")
            check("trace_ray", "nearest_hit mirror_direction")
        }
        /origin\[i\] \* .*direction\[i\]|2 \* p \* v|\+ 2 \* pv/ { print FILENAME ": " $0; bad = 1 }
        END { exit bad }' {} +
}
check 'no function of it is an answer in another form' repeats_no_answer
check 'nor the engines of chapter 08, which are made of answers' none_of_these '08-fast/engines/'

# The right data are there for every figure: variables, and blocks of numbers.
right_data_are_numbers() {
    status=0
    for layout in chapters/*/figures/*.gp; do
        data=$scratch/tree/ray-casting/build/right-figures/${layout##*/}
        [ -s "$data" ] || { echo "$data"; status=1; }
        awk '/^\$[a-z_0-9]+ << EOD$/ { inside = 1; next } /^EOD$/ { inside = 0; next }
            inside && /^# a PNG in base64$/ { inside = 2 }
            inside == 2 ? !/^(#.*|[A-Za-z0-9+\/]+=*)$/ : inside ? !/^(#|$)/ && /[^-0-9.e Na]/ : NF && !/^(#|[a-zA-Z_0-9]+ = ("[^"]*"|[-0-9.eNa]+)$)/ {
                print FILENAME ": " $0; bad = 1 }
            END { exit bad }' "$data" || status=1
    done
    return $status
}
check 'what is right of each figure is in it, as numbers and pictures' right_data_are_numbers
names_no_solutions() {
    ! grep -rI 'solutions/' "$scratch/tree" --include='*.md'
}
check 'a lesson calls programs where they are' names_no_solutions

# The grader's result if somebody hands it in unchanged.
grader_finds() {
    (cd "$scratch/tree" && zip_it ray-casting) && python3 -B - "$scratch/handed-in" <<'PYTHON'
import sys
sys.path.insert(0, "tests")
from grade import exercises
from grade.collect import submissions
stems = exercises.stems(exercises.read())
found, _ = submissions.find(sys.argv[1], stems)
assert len(found) == 2
for submission in found:
    collected = submissions.collect(submission, stems)
    for stem, answer in collected.answers.items():
        print(submission.name, stem, answer.state, answer.file, answer.words)
        assert answer.state == "found" and answer.file.endswith(f"exercises/{stem}.c") and not answer.words
    assert collected.words == ""
PYTHON
}
zip_it() {
    mkdir -p "$scratch/handed-in" && cp -r "$1" "$scratch/handed-in/a folder" &&
        python3 -c 'import shutil, sys; shutil.make_archive(*sys.argv[1:])' "$scratch/handed-in/zipped" zip . "$1"
}
if command -v python3 >/dev/null; then
    check 'handed in as it is, its exercises/ are the answers' grader_finds
fi

for page in README.md $(cd "$scratch/tree/ray-casting" && ls ./*/README.md chapters/*/*.md); do
    check "the links of its $page lead somewhere" links_lead_somewhere "$scratch/tree/ray-casting/$page"
done
# make has a rule for each of its files: nothing is built, so that takes seconds.
has_rules() {
    (cd "$scratch/tree/ray-casting" && unset ANSWERS BUILD KIT PROGRAMS CC COMPILER && make -n all check exercises >/dev/null)
}
check 'make has a rule for each file that it needs' has_rules

# Of what is not there, a page says nothing: no paragraph, no row.
leaves_out() {
    printf '%s\n' 'a [x](here)' 'b' '' 'c' '[y](gone)' '' 'd' '' '| e |' '| [z](gone) |' '| [f](here) |' '' '- [g](gone)' '- h' '' 'i' >"$scratch/page"
    : >"$scratch/here"
    printf '%s\n' 'a [x](here)' 'b' '' 'd' '' '| e |' '| [f](here) |' '' '- h' '' 'i' >"$scratch/wanted"
    tests/handout/pack --page "$scratch" "$scratch/page" | diff "$scratch/wanted" -
}
check 'of what is not there a page says nothing' leaves_out
same_page() {
    cmp exercises/README.md "$scratch/tree/ray-casting/exercises/README.md"
}
check "the students' page is that of the toolkit" same_page


# Before anything is built an editor (clangd) reads compile_flags.txt; it must say no more than the judge does.
first_flags() {
    # shellcheck disable=SC2046 # options without blanks in them
    (cd "$scratch/tree/ray-casting" && "$1" $(cat compile_flags.txt) -Werror -fsyntax-only exercises/*.c)
}
for compiler in gcc clang; do
    ! command -v $compiler >/dev/null || check "in it, an editor has flags before anything is built ($compiler)" first_flags $compiler
done

# An editor finds the flags of each answer: it compiles as it is judged.
editor_finds() {
    (cd "$1" && unset ANSWERS BUILD KIT PROGRAMS COMPILER && make --no-print-directory -s build/compile_commands.json \
        CC="$2" && python3 -B - exercises/*.c exercises/optional/*.c) <<'PYTHON'
import json, subprocess, sys
entries = {entry["file"]: entry for entry in json.load(open("build/compile_commands.json"))}
for answer in sys.argv[1:]:
    command = entries[answer]["command"]
    assert "-Wno-unused-parameter" in command, command
    done = subprocess.run(command + " -fsyntax-only", shell=True, cwd=entries[answer]["directory"],
                          capture_output=True, text=True)
    assert (done.returncode, done.stderr) == (0, ""), done.stderr
PYTHON
}
if command -v python3 >/dev/null; then
    for compiler in gcc clang; do
        command -v $compiler >/dev/null || continue
        check "in it, an editor finds how each answer is compiled by $compiler" \
            editor_finds "$scratch/tree/ray-casting" $compiler
    done
fi

finish handout
