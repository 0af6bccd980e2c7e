#!/bin/sh
# shading.sh - shadows and mirrors: how much sooner chapter 08's hierarchy draws chapter 07's picture.
#
# Whole processes, from the scene's file to the picture's; they take turns. The pictures are compared
# first. Usage: shading.sh SCENE.nff; in the environment PROGRAMS from the Makefile, ROUNDS (5), SIZE
# (160x120), DEPTH (3), THREADS ('1 2').
set -u
scene=$1
size=${SIZE:-160x120}
depth=${DEPTH:-3}
scratch=$(mktemp -d) || exit 1
trap 'rm -rf "$scratch"' EXIT

# draw NAME: 'plain', or a number of threads.
draw() {
    case $1 in
    plain) set -- 07-shading plain ;;
    *) set -- 08-fast "$1" --shaded --threads "$1" ;;
    esac
    program=$1
    picture=$scratch/$2.png
    shift 2
    "$PROGRAMS/$program" "$@" --depth "$depth" -s "$size" -o "$picture" "$scene" 2>"$scratch/said" ||
        { cat "$scratch/said"; exit 1; }
}

for name in plain ${THREADS:-1 2}; do
    draw "$name"
    cmp "$scratch/plain.png" "$scratch/$name.png" || exit 1
done
round=0
while [ $round -lt "${ROUNDS:-5}" ]; do
    for name in plain ${THREADS:-1 2}; do
        from=$(date +%s%N)
        draw "$name"
        to=$(date +%s%N)
        echo "$name $round $(((to - from) / 1000))" >>"$scratch/times"
    done
    round=$((round + 1))
done

echo "$(basename "$scene" .nff), shaded, $size, $depth mirrors deep, scene to picture: medians of ${ROUNDS:-5}, the same bytes"
awk '
    function median(list, n, i, k, x) {
        for (i = 2; i <= n; i++) {
            x = list[i]
            for (k = i - 1; k > 0 && list[k] > x; k--) list[k + 1] = list[k]
            list[k + 1] = x
        }
        least = list[1]; most = list[n]
        return n % 2 ? list[(n + 1) / 2] : (list[n / 2] + list[n / 2 + 1]) / 2
    }
    !($1 in count) { order[++rows] = $1 }
    { took[$1, $2] = $3 / 1000; count[$1]++ }
    END {
        for (r = 1; r <= rows; r++) {
            name = order[r]
            for (i = 1; i <= count[name]; i++) {
                list[i] = took[name, i - 1]
                ratio[i] = took["plain", i - 1] / list[i]
            }
            line = sprintf("%10.4g ms", median(list, count[name]))
            if (name == "plain")
                printf "  %-34s %s\n", "07-shading", line
            else {
                line = line sprintf("   %.3g times sooner", median(ratio, count[name]))
                printf "  %-34s %s (%.3g to %.3g)\n", "08-fast --shaded --threads " name, line, least, most
            }
        }
    }' "$scratch/times"
