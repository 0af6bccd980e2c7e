#!/bin/sh
# handout.sh - the students' archive, as a student has it: a clean folder, no git, no home, and the
# README's two commands; then right answers, wrong ones, missing ones, with gcc and with clang.
set -u
cd "$(dirname "$0")/../.." && . tests/house/runner/library.sh
once handout "the handout"
export NO_COLOR=1 LC_ALL=C
unset ANSWERS # a student's are in exercises/

archive=build/handout.tar.gz
make_handout() {
    make --no-print-directory -s handout
}
# From a clone the archive is the same, byte by byte.
from_a_clone() {
    git clone -q . "$scratch/clone" && (cd "$scratch/clone" && make_handout) &&
        cmp $archive "$scratch/clone/build/handout.tar.gz"
}
make --no-print-directory -s all handout >/dev/null || exit 1
if [ -z "$(git status --porcelain 2>&1)" ]; then
    check 'a clone makes the same archive' from_a_clone
else
    echo 'skipped: a clone of what is not committed (or no git)'
fi

# A command in the unpacked archive; no git is to be found there, and no home.
mkdir "$scratch/bin"
printf '#!/bin/sh\nexit 127\n' >"$scratch/bin/git"
chmod +x "$scratch/bin/git"
inside() {
    (cd "$tree" && env -u HOME -u MAKEFLAGS -u MAKELEVEL -u T PATH="$scratch/bin:$PATH" CC="$compiler" "$@") >"$scratch/said" 2>&1
}
fails() {
    ! inside "$@"
}
answers() {
    cp solutions/*.c "$tree/exercises"
}
blank() {
    cp "build/blanks/$1.c" "$tree/exercises"
}
spoil() {
    sed "$2" "solutions/$1.c" >"$tree/exercises/$1.c"
    ! cmp -s "solutions/$1.c" "$tree/exercises/$1.c"
}

# A step of the workflow that judges each push to a repository made from the archive.
workflow() {
    sed -n "/- name: $1\$/,/^\$/ s/^          //p" "$tree/.github/workflows/exercises.yml" >"$scratch/step" &&
        test -s "$scratch/step" && inside env GITHUB_STEP_SUMMARY="$scratch/summary" bash -eo pipefail "$scratch/step"
}

# While chapter 03 is saved wrong: the verdict on chapter 04, which depends on it.
watches_dependents() {
    start env -u MAKEFLAGS CC="$compiler" make -C "$tree" watch >"$scratch/watched" 2>&1
    wait_until grep -q Watching "$scratch/watched" || return 1
    spoil 03-screen 's|1 - point.y|point.y|'
    wait_until grep -q '^waits' "$tree/build/exercises/verdict/04-pixel-ray.record"
    status=$?
    end_started
    return $status
}

for compiler in ${HANDOUT_COMPILERS:-gcc clang}; do
    command -v "$compiler" >/dev/null || continue
    tree=$scratch/my-course-$compiler
    mkdir "$scratch/unpacked" && tar xzf $archive -C "$scratch/unpacked" &&
        mv "$scratch/unpacked/ray-casting" "$tree" && rmdir "$scratch/unpacked"

    check "$compiler: it builds from a clean folder" inside make setup all
    check "$compiler: without a warning" says_not 'warning'
    check "$compiler: and says what is missing for a picture" says 'not yet'
    check "$compiler: an editor can read what opens it" inside python3 -m json.tool .vscode/tasks.json
    check "$compiler: and so can what makes its container" inside python3 -m json.tool .devcontainer/devcontainer.json
    check "$compiler: blanks are not wrong" inside make exercises
    check "$compiler: but the first is next" says 'upper_left  is not answered yet'
    check "$compiler: blanks are reported when answers are packed" inside make submission
    check "$compiler: by chapter" says '05-quadratic.c       still blank'
    cp solutions/01-corners.c solutions/07-shading.c "$tree/exercises"
    check "$compiler: one answered chapter draws spheres" inside make exercises EX=01
    check "$compiler: by that answer and what is recorded" says 'Yours: image_plane_vector.'
    check "$compiler: where it says" test -s "$tree/build/exercises/so-far/01-spheres.png"
    inside make exercises EX=07
    check "$compiler: what needs a reference is not drawn" [ "$(ls "$tree/build/exercises/so-far")" = 01-spheres.png ]
    check "$compiler: since there is none" sh -c "! grep -E '^(reference|right)' '$tree/build/exercises/verdict/plan'"
    answers
    check "$compiler: the answers are packed" inside make submission
    check "$compiler: and the place is printed" says 'Hand in this file: build/submission.zip (8 files)'
    check "$compiler: right answers are right, every chapter" inside make exercises
    check "$compiler: and said to be" says 'All right, every chapter.'
    check "$compiler: their pictures are drawn" inside make
    check "$compiler: all of them" test -s "$tree/build/exercises/gallery/sphereflake-7381.png"
    for stem in 01-corners 02-cameras 04-pixel-ray 06-ray-casting; do
        check "$compiler: the picture of $stem is the solution's" same_picture \
            "build/solutions/gallery/$(echo "$stem" | sed 's/06.*/three-spheres/').png" \
            "$tree/build/exercises/gallery/$(echo "$stem" | sed 's/06.*/three-spheres/').png"
    done

    spoil 03-screen 's|1 - point.y|point.y|'
    check "$compiler: a wrong answer is a failure" fails make status EX=03
    inside make exercises EX=03
    check "$compiler: what went in is shown" says 'screen     640 x 480'
    check "$compiler: the mistake is named" says 'looks like a known mistake: y counts down'
    if command -v gnuplot >/dev/null; then
        check "$compiler: and drawn" says 'see        build/exercises/figures/screen_to_normalized.svg'
        check "$compiler: beside what is right" grep -q '(0.46875, 0.166667); yours' \
            "$tree/build/exercises/figures/screen_to_normalized.txt"
    fi
    check "$compiler: a push of it is judged on GitHub" workflow Verdicts
    check "$compiler: in the words of the terminal" grep -q '^      looks like a known mistake: y counts down' "$scratch/summary"
    workflow Annotations
    check "$compiler: with a mark at the function" says "::error file=exercises/03-screen.c,line=$(grep -n \
        '^Normalized screen_to_normalized' "$tree/exercises/03-screen.c" | cut -d: -f1),title=screen_to_normalized::wrong"
    check "$compiler: and at what waits for it" says 'title=pixel_ray::waits'
    inside make exercises EX=04
    check "$compiler: a chapter that depends on it is not called wrong" says 'waiting: pixel_ray (for screen_to_normalized)'
    check "$compiler: with the chapter it depends on" says 'depends on your 03-screen, which is not right yet:'
    check "$compiler: and where to begin" says 'Next: exercises/03-screen.c'
    blank 03-screen
    inside make exercises EX=04
    check "$compiler: a missing answer is also reported" says 'depends on your 03-screen'
    check "$compiler: as the reason for waiting" says 'waiting: pixel_ray'
    echo 'this is not C' >"$tree/exercises/03-screen.c"
    check "$compiler: one that does not compile spoils nothing else" inside make exercises
    check "$compiler: and it says so" says '03-screen        does not compile'
    inside make exercises EX=04
    check "$compiler: and so does the chapter that depends on it" says 'depends on your 03-screen'
    answers
    spoil 01-corners 's|c.distance \* c.forward - c.width / 2|c.distance * c.forward - c.width|'
    if command -v gnuplot >/dev/null; then
        check "$compiler: figures are drawn" inside make figures FORMAT=svg
        in_any_folder() {
            (cd / && "$tree/build/exercises/03-screen" --figure pixel-grid) >"$scratch/pixel-grid.gp" &&
                inside build/exercises/03-screen --figure pixel-grid && cmp "$scratch/pixel-grid.gp" "$scratch/said"
        }
        check "$compiler: a program prints them in any folder" in_any_folder
        check "$compiler: what is wrong is named in them" grep -q 'upper_left: the whole width' \
            "$tree/build/exercises/figures/corner-vectors/corner-vectors.svg"
        blank 01-corners
        check "$compiler: a figure that lacks an answer stops no other" inside make figures FORMAT=svg
        check "$compiler: and is reported" says 'not yet   build/exercises/figures/corner-vectors: needs'
    fi
    answers
    check "$compiler: then all is right again" inside make status
    check "$compiler: but the formulas of the slides keep not all digits" grep -q '^extra	wrong' \
        "$tree/build/exercises/verdict/05-quadratic.record"
    check "$compiler: watch also judges the chapters that depend on the saved answer" watches_dependents
    answers

    check "$compiler: reset keeps the answer" inside make reset EX=02
    check "$compiler: beside the blank" test -e "$tree/exercises/02-cameras.c.backup-1"
    answers
    spoil 05-quadratic 's|ray.origin - sphere.center|ray.origin + sphere.center|'
    inside env GDB_FLAGS=-batch make debug EX=05
    check "$compiler: debug stops in the call that failed" says '#0  to_object_coordinates'
done

finish handout
