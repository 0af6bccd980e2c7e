#!/bin/sh
# terminal.sh - what is shown on a terminal of 24 x 80: by 'make watch', and how far long work is, which a log has as well
# if it is make's.
# Builds only below its answers.
set -u
cd "$(dirname "$0")/../.." && . tests/house/runner/library.sh
once terminal "terminals"
needs terminal "what is shown on a terminal" python3

answers=$scratch/answers
export NO_COLOR=1

mkdir "$answers" && cp solutions/*.c "$answers" && make -s exercises EX=03 ANSWERS="$answers" >"$scratch/said" || exit 1
plan=build$answers/verdict/plan
all_stems=$(for contract in exercises/*.h; do basename "$contract" .h; done)
# The solutions, but for a function that begins with this statement.
begins_with() {
    cp solutions/*.c "$answers"
    sed "/^[A-Z a-z0-9]* $2(/,/^{/s|^{|{\n    $3|" "solutions/$1.c" >"$answers/$1.c"
}
# What watch shows of these chapters is in $scratch/said.
on_screen() {
    env -u NO_COLOR -u COLUMNS python3 -B tests/house/runner/terminal.py build/course watch "$plan" "$@" >"$scratch/said" 2>&1
}
begins_at_the_top() {
    cat "$scratch/said"
    sed -n "${2:-1}p" "$scratch/said" | grep -q "^$1"
}
# All lines of the verdict as it is elsewhere, up to the result.
shows_the_arguments() {
    build/course exercises "$plan" "$1" | sed '/^  yours/q' >"$scratch/elsewhere"
    grep -q '^  yours' "$scratch/elsewhere" && head -n "$(grep -c '' "$scratch/elsewhere")" "$scratch/said" | diff "$scratch/elsewhere" -
}
without_what_is_the_same() {
    says_not 'Next: ' && says_not 'the lesson is'
}
# The functions with the longest arguments of each chapter.
while read -r stem name statement; do
    begins_with "$stem" "$name" "$statement"
    on_screen "$stem"
    check "on 24 rows: $name and its arguments" begins_at_the_top "$stem  $name "
    check "on 24 rows: $name: all arguments, and the result" shows_the_arguments "$stem"
    check "on 24 rows: $name: nothing that is the same each time" without_what_is_the_same
    check "on 24 rows: $name: how it goes on" says 'Ctrl-C ends.'
done <<'ANSWERS'
01-corners image_plane_vector return c.up;
02-cameras camera_from_look_at if (world == RIGHT_HANDED) return 0;
03-screen screen_to_normalized return (Normalized){0};
04-pixel-ray pixel_ray return (Ray){{0}};
05-quadratic sphere_roots return (Roots){0};
06-ray-casting nearest_hit return (Hit){1};
07-shading trace_ray return scene->background;
08-fast sphere_rectangle return (ScreenRectangle){0};
ANSWERS
# A scene of more spheres than there are rows.
begins_with 06-ray-casting nearest_hit 'if (scene->sphere_count > 11) return (Hit){1};'
on_screen 06-ray-casting
check 'of a scene that is too long, the function is named' says 'wrong: nearest_hit'
check 'and the result is there' says '  yours '
check 'what can be said about it' says '  but '

# A line for the picture of what is wrong, and one for the last of those that have become right.
begins_with 07-shading phong_term 'return (Color){0};'
rm -f "build$answers"/verdict/*.drawn
on_screen 07-shading
check 'a wrong function does not hide what has become right' [ "$(grep -c '^  picture .*\(gamma\|highlights\)' "$scratch/said")" -eq 2 ]

# By make, which would have words of its own about an end that is no error.
ended_by_interrupt() {
    env -u NO_COLOR -u COLUMNS python3 -B tests/house/runner/terminal.py make --no-print-directory watch EX=03 \
        ANSWERS="$answers" >"$scratch/said" 2>&1
    tail -n 1 "$scratch/said" | grep -q 'Ctrl-C ends.$'
}
check 'Ctrl-C ends it without a word' ended_by_interrupt

# Warnings are above the verdict.
begins_with 03-screen screen_to_normalized 'int a; int b; int c; int d; int e; return (Normalized){0};'
on_screen 03-screen
check 'warnings do not push the function away' says '03-screen  screen_to_normalized'
check 'nor its arguments' says '  point  '

# At the start: chapters that have become right come first, then the verdict.
begins_with 05-quadratic hit_sphere 'return 1;'
rm -f "build$answers"/verdict/*.rewarded
# shellcheck disable=SC2086 # several stems
on_screen $all_stems
check 'seven rewards leave the function visible' says '05-quadratic  hit_sphere'
check 'its arguments' says '  sphere     center'
check 'its result' says '  yours '
cp build/blanks/0[1-8]*.c "$answers" && cp solutions/01*.c solutions/03*.c "$answers"
rm -f "build$answers"/verdict/*.rewarded
# shellcheck disable=SC2086
on_screen $all_stems
check 'a reward is a line' begins_at_the_top "01-corners is right: build$answers/gallery/01-corners.png"
check 'each' begins_at_the_top '03-screen is right:' 2
check 'and the verdict follows' begins_at_the_top '02-cameras  camera_from_vectors' 3
rm -rf "build$answers"

# ---- long work ------------------------------------------------------------------------------------

on_terminal() { # PATTERN COMMAND...
    python3 -B tests/house/runner/terminal.py --until "$@"
}
# So many spheres and pixels that no machine draws them in a second.
slow="-s 4000x3000 -o $scratch/slow.png $BUILD/scenes/sphereflake-7381.nff"
left='[0-9]+ % \([0-9]+ of 12000000\), about [0-9].* (h|min|s|ms)( [0-9]+ (min|s))? left'
# shellcheck disable=SC2086 # words
check 'chapter 06 shows how many pixels are set, and the time that is left' \
    on_terminal "pixels +$left" "$PROGRAMS/06-ray-casting" $slow
# shellcheck disable=SC2086
check 'so does chapter 07' on_terminal "pixels +$left" "$PROGRAMS/07-shading" $slow
# shellcheck disable=SC2086
check 'and the slowest engine of chapter 08' on_terminal "pixels +$left" \
    "$PROGRAMS/08-fast" --engine plain $slow

# A gnuplot that takes its time; --one draws a figure in words and then as SVG.
mkdir "$scratch/bin" "$scratch/figures"
cat >"$scratch/bin/gnuplot" <<'END'
#!/bin/sh
sleep 2.5
exit 1
END
chmod +x "$scratch/bin/gnuplot"
for name in one two three; do
    mkdir "$scratch/figures/$name"
    echo 'plot 1' >"$scratch/figures/$name/$name.gp"
done
check 'figures show their progress on a terminal' on_terminal 'figures +33 % \(1 of 3\), about .* left' \
    /usr/bin/env PATH="$scratch/bin:$PATH" python3 chapters/gallery/draw_figures.py "$scratch/figures" one two three
in_a_log() {
    env PATH="$scratch/bin:$PATH" python3 chapters/gallery/draw_figures.py "$scratch/figures" one two three >"$scratch/said" 2>&1
    cat "$scratch/said"
    grep -Eqx '  figures   33 % \(1 of 3\), about .* left' "$scratch/said"
}
check 'and in a log' in_a_log

# Times are words: 08 prints how long it took.
took() {
    "$PROGRAMS/08-fast" -s 32x24 -o "$scratch/small.png" 2>"$scratch/said" && cat "$scratch/said" &&
        grep -Eq ' spheres in [0-9.]+ (ms|s), ' "$scratch/said"
}
check 'a program names its unit of time' took
finish terminal
