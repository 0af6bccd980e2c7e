#!/bin/sh
# wait.sh - what the user waits for: from the scene's file to the picture's, whole processes.
#
# Chapter 08's program, and beside it only reading the scene and only writing the picture (alone.c), which
# is the least there could be; with PEERS=1 also POV-Ray, Tachyon and an Embree program. They take turns;
# the pictures are compared first. The scene is given to POV-Ray and to Tachyon in their own
# languages. Usage: wait.sh SCENE.nff; in the environment PROGRAMS and BUILD from the Makefile,
# ROUNDS (7), THREADS ('1 2'), ENGINE (auto, if it exists).
set -u
scene=$1
width=1920
height=1080
scratch=$(mktemp -d) || exit 1
trap 'rm -rf "$scratch"' EXIT
engine=${ENGINE:-$("$PROGRAMS/08-fast" --help | grep -q auto && echo auto || echo object)}

# Each program by a name: $1 threads. Draws $scratch/NAME.png.
ours() {
    "$PROGRAMS/08-fast" -e "$engine" -t "$1" -s ${width}x$height -o "$scratch/ours.png" "$scene"
}
# Prints the microseconds itself.
alone() {
    "$BUILD/tests/benches/alone" "$scene" "$scratch/alone.png" $width $height "$1"
}
embree() {
    "$BUILD/tests/benches/peers/embree_wait" "$scene" "$scratch/embree.png" $width $height "$1"
}
povray() {
    command povray "+I$scratch/peer.pov" "+O$scratch/povray.png" +W$width +H$height "+WT$1" -A -D
}
# A row and a column more: peers/programs.c says why.
tachyon() {
    command tachyon "$scratch/peer.dat" -lowestshade -numthreads "$1" -format PNG \
        -o "$scratch/tachyon.png"
}

programs='ours alone'
if [ -n "${PEERS:-}" ]; then
    for name in povray tachyon; do
        command -v $name >/dev/null || { echo "$name is not installed: make setup FOR=bench"; continue; }
        # One picture writes the scene in its language, and is compared.
        BENCH_SCRATCH=$scratch "$BUILD/tests/benches/engines-and-peers" -r 1 -l 600 -e $name \
            -s ${width}x$height "$scene" >"$scratch/said" 2>&1
        if grep -q "^  $name" "$scratch/said"; then
            programs="$programs $name"
        else
            cat "$scratch/said"
        fi
    done
    if [ ! -x "$BUILD/tests/benches/peers/embree_wait" ]; then
        echo 'Embree 3 is not installed: make setup FOR=bench'
    elif ours 1 2>/dev/null && embree 1 &&
        "$BUILD/tests/same_picture" "$scratch/ours.png" "$scratch/embree.png" 1000; then
        programs="$programs embree"
    fi
fi

round=0
while [ $round -lt "${ROUNDS:-7}" ]; do
    for threads in ${THREADS:-1 2}; do
        for name in $programs; do
            from=$(date +%s%N)
            $name "$threads" >"$scratch/printed" 2>/dev/null || echo "$name fails"
            to=$(date +%s%N)
            took=$(((to - from) / 1000))
            if [ "$name" = alone ]; then
                read -r reading writing <"$scratch/printed"
                took=$((reading + writing))
            fi
            echo "$threads $name $round $took" >>"$scratch/times"
        done
    done
    round=$((round + 1))
done

echo "$(basename "$scene" .nff), scene to picture, ${width}x$height, engine $engine: medians"
echo '  program      threads        ms   quartiles          times ours (median of ratios)'
sort -n -k1,1 "$scratch/times" | awk '
    function sorted(list, n, i, k, x) {
        for (i = 2; i <= n; i++) {
            x = list[i]
            for (k = i - 1; k > 0 && list[k] > x; k--) list[k + 1] = list[k]
            list[k + 1] = x
        }
    }
    function at(list, n, share, p, i) {
        p = 1 + share * (n - 1); i = int(p)
        return list[i] + (i < n ? (p - i) * (list[i + 1] - list[i]) : 0)
    }
    !(($1, $2) in count) { order[++rows] = $1 SUBSEP $2 }
    { took[$1, $2, $3] = $4 / 1000; count[$1, $2]++ }
    END {
        for (r = 1; r <= rows; r++) {
            split(order[r], key, SUBSEP)
            n = count[key[1], key[2]]
            for (i = 1; i <= n; i++) {
                list[i] = took[key[1], key[2], i - 1]
                ratio[i] = list[i] / took[key[1], "ours", i - 1]
            }
            sorted(list, n); sorted(ratio, n)
            printf "  %-12s %7d %9.4g   %-18s %.3g\n", key[2], key[1], at(list, n, .5),
                sprintf("%.4g..%.4g", at(list, n, .25), at(list, n, .75)), at(ratio, n, .5)
        }
    }'
