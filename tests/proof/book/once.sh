#!/bin/sh
# once.sh - runs a command of a compiler, 'once.sh FOLDER cc ... -o OUTPUT ...', unless it ran before: the same words have
# the same output, which is kept in the folder. In a program of known answers, KNOWN_ANSWER says which of them it has
# (answer_by_number.c).
set -u
folder=$1
shift
kept=$folder/$(printf '%s' "$*" | cksum | tr ' ' -)
before=""
for word in "$@"; do
    [ "$before" != -o ] || output=$word
    before=$word
done
if [ ! -f "$kept" ]; then
    "$@" || exit
    cp "$output" "$kept"
fi
case $output in
*.o) cp "$kept" "$output" ;;
*) cp "$kept" "$output" && LC_ALL=C sed "s/known answer 000000/$KNOWN_ANSWER/" "$kept" >"$output" ;;
esac
