#!/bin/sh
# progress.sh - long work says how far it is: on a terminal, and in a log if it is make's.
# Only reads the tree.
set -u
cd "$(dirname "$0")/../.." && . tests/house/runner/library.sh
once progress "progress"

needs progress 'progress on a terminal' python3
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
finish progress
