#!/bin/sh
# command_line.sh - tests of a program's command line: options, bad scenes, places to write to.
#
# Usage: [PROGRAMS=FOLDER] tests/shell/command_line.sh
# PROGRAMS is where 06-ray-casting is: build/solutions, unless told. The last line says how many
# checks passed and failed; each that failed has a line 'not ok: what should be (what came)'.
# Only reads the tree.
set -u
LC_ALL=C
export LC_ALL
umask 022
# Seconds of work for each program, where the shell can: an endless loop is no endless test.
# shellcheck disable=SC3045
ulimit -t 20 2> /dev/null

programs=${PROGRAMS:-build/solutions}
programs=$(cd "$programs" 2> /dev/null && pwd) || programs=${PROGRAMS:-build/solutions}
program=$programs/06-ray-casting
if [ ! -x "$program" ]; then
    echo "not ok: there is a program to test (no $program)"
    echo 'command_line: 0 passed, 1 failed'
    exit 1
fi

passed=0
failed=0
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT
trap 'exit 1' HUP INT TERM
mkdir "$work/in" "$work/said"
cd "$work/in" || exit 1

# ---- checks -------------------------------------------------------------------------------------

# expect SENTENCE WHAT-CAME COMMAND...: the command succeeds.
expect() {
    sentence=$1
    came=$2
    shift 2
    if "$@" > /dev/null 2>&1; then
        passed=$((passed + 1))
    else
        failed=$((failed + 1))
        echo "not ok: $sentence ($came)"
    fi
}

# run ARGUMENTS...: the program, its words and its exit status.
run() {
    "$program" "$@" > "$work/said/out" 2> "$work/said/err" < /dev/null
    status=$?
    said="exit $status, said: $(head -c 300 "$work/said/err" | tr '\n' ' ')"
}

# Some line of stderr matches, all of it is plain text, and none is on stdout.
clean_error() {
    grep -E -q -e "$1" "$work/said/err" && [ ! -s "$work/said/out" ] &&
        [ "$(tr -d '\n -~' < "$work/said/err" | wc -c)" -eq 0 ]
}

ends() {
    [ "$status" -eq "$1" ] && clean_error "$2"
}

# expect_exit STATUS SENTENCE ARGUMENTS...: ends so, silently where 0, else with a reason.
expect_exit() {
    wanted=$1
    sentence=$2
    shift 2
    run "$@"
    if [ "$wanted" -eq 0 ]; then
        expect "$sentence" "$said" [ "$status" -eq 0 ]
    else
        expect "$sentence" "$said" ends "$wanted" .
    fi
}

# expect_says STATUS PATTERN SENTENCE ARGUMENTS...: ends so, with this on stderr.
expect_says() {
    wanted=$1
    pattern=$2
    sentence=$3
    shift 3
    run "$@"
    expect "$sentence" "$said" ends "$wanted" "$pattern"
}

# Wrong usage, of which this is said; and where help is.
expect_usage() {
    expect_says 2 "$@"
    expect "$2, and --help is named" "$said" clean_error "--help"
}

# expect_bad_file LINE WORDS SENTENCE: bad.nff is refused at this line, and no picture is made.
expect_bad_file() {
    rm -f bad.png
    expect_says 1 "^bad\.nff:$1: .*$2" "$3" -o bad.png bad.nff
    expect "$3, and no picture is made" 'there is one' [ ! -e bad.png ]
}

# expect_bad_scene LINE WORDS SENTENCE TEXT: the same of this text, as printf %b prints it.
expect_bad_scene() {
    printf '%b' "$4" > bad.nff
    expect_bad_file "$1" "$2" "$3"
}

# Width and height of a PNG, from its header: two numbers of four bytes from byte 16.
size_of() {
    od -A n -t u1 -j 16 -N 8 "$1" | awk '{ print ((($1 * 256 + $2) * 256 + $3) * 256 + $4) "x" \
        ((($5 * 256 + $6) * 256 + $7) * 256 + $8) }'
}

is_png() {
    [ "$(od -A n -t x1 -N 8 "$1" | tr -d ' \n')" = 89504e470d0a1a0a ]
}

# expect_picture WIDTHxHEIGHT FILE SENTENCE
expect_picture() {
    expect "$3" "$(size_of "$2" 2>&1)" is_png "$2"
    expect "$3, of $1" "$(size_of "$2" 2>&1)" [ "$(size_of "$2" 2> /dev/null)" = "$1" ]
}

same_file() {
    cmp -s "$1" "$2"
}

# A viewpoint, 6 lines.
view='v\nfrom 0 0 9\nat 0 0 0\nup 0 1 0\nangle 40\nresolution 20 10\n'
printf '%b' "${view}s 0 0 0 1\n" > good.nff

# ---- pictures -----------------------------------------------------------------------------------

expect_exit 0 'a scene is cast' -o good.png good.nff
expect_picture 20x10 good.png 'the picture has the resolution of its scene'
expect 'nothing is said on stderr' "$said" [ ! -s "$work/said/err" ]
expect_exit 0 '-s is taken' -s 32x24 -o sized.png good.nff
expect_picture 32x24 sized.png '-s overrides the resolution of the scene'
expect_exit 0 'options may follow the scene' good.nff -o after.png -s 32x24
expect 'the order of the arguments does not matter' 'another picture' \
    same_file sized.png after.png
expect_exit 0 'an option may be long' --size=32x24 --output=long.png good.nff
expect 'long and short options mean the same' 'another picture' same_file sized.png long.png
expect_exit 0 'names may have spaces' -o 'my picture.png' -s 32x24 ./good.nff
expect_picture 32x24 'my picture.png' 'a name with spaces is one name'
cp good.nff ./-good.nff
expect_exit 0 'behind -- a name may begin with a dash' -o dash.png -- -good.nff
expect_exit 0 'one pixel is a picture' -s 1x1 -o one.png good.nff
expect_picture 1x1 one.png 'one pixel is a picture'
expect_exit 0 'the size of a scene may be out of shape' -s 200x1 -o flat.png good.nff
expect_picture 200x1 flat.png 'a row is a picture'

expect_exit 0 "the chapter's own scene is cast" -s 64x48 -o image.png
expect_exit 0 'image order is an order' -s 64x48 --order image -o image2.png
expect_exit 0 'object order is an order' -s 64x48 --order object -o object.png
expect 'image order is the usual one' 'another picture' same_file image.png image2.png
expect 'both orders give the same picture' 'another picture' same_file image.png object.png
expect "the chapter's scene is more than its background" 'every picture is the same' \
    [ "$(wc -c < image.png)" -gt 200 ]

(cd / && "$program" -s 64x48 -o "$work/in/root.png" > /dev/null 2>&1)
expect 'the program finds its scene from any folder' 'another picture' \
    same_file image.png root.png
# Elsewhere there is a copy of the program, and first no scene for it.
mkdir elsewhere
cp "$program" elsewhere/
(cd elsewhere && ./06-ray-casting > ../said.txt 2>&1)
expect 'the exit status is 1 where the scene of the chapter is missing' "exit $?" [ $? -eq 1 ]
expect 'the missing scene is named' "$(cat said.txt)" grep -q three-spheres.nff said.txt
mkdir -p elsewhere/chapters/06-ray-casting
cp good.nff elsewhere/chapters/06-ray-casting/three-spheres.nff
(cd elsewhere && ./06-ray-casting > ../said.txt 2> ../errors.txt)
expect 'without arguments the picture is in the gallery beside the program' "$(cat errors.txt)" \
    same_file good.png elsewhere/gallery/three-spheres.png
expect 'without arguments the program tells its story' 'nothing' [ -s said.txt ]
expect 'without arguments nothing is said on stderr' "$(cat errors.txt)" [ ! -s errors.txt ]
(cd / && "$work/in/elsewhere/06-ray-casting" -s 32x24 "$work/in/good.nff" > /dev/null 2>&1)
expect_picture 32x24 elsewhere/gallery/good.png 'the picture goes by the name of its scene'

ln -s sized.png link.png
expect_exit 0 'a picture is written through a link' -o link.png good.nff
expect 'the link stays a link' 'it does not' [ -h link.png ]
expect_picture 20x10 sized.png 'the file that a link leads to is replaced'

awk '{ printf "%s\r\n", $0 }' good.nff > windows.nff
expect_exit 0 'lines may end as on Windows' -o windows.png windows.nff
expect 'line ends do not change the picture' 'another picture' same_file windows.png good.png
printf '%b' "${view}c\n0 0 0 1\n0 1 0 1\np 3\n0 0 0\n1 0 0\n1 1 0\ns 0 0 0 1\n" > mixed.nff
expect_exit 0 'cones and polygons are left out' -o mixed.png mixed.nff
expect 'what is left out is named in one line' "$said" \
    grep -q '^mixed.nff: warning: .*1 cones.*1 polygons' "$work/said/err"
expect 'what is left out is named once' "$said" [ "$(wc -l < "$work/said/err")" -eq 1 ]
expect 'what is left out does not change the picture' 'another picture' \
    same_file mixed.png good.png

# ---- help and wrong usage -----------------------------------------------------------------------

expect_exit 0 '--help is no error' --help
for word in Usage --output --size --order image object WIDTHxHEIGHT SCENE.nff FILE.png --help; do
    expect "--help names $word" "$(head -c 300 "$work/said/out")" \
        grep -q -e "$word" "$work/said/out"
done
expect '--help writes to stdout' "$said" [ ! -s "$work/said/err" ]
expect_exit 0 '-h is --help' -h

expect_usage "--sideways" 'an unknown option is refused' --sideways
expect_usage "'-x'" 'an unknown letter is refused' -x good.nff
expect_usage "2 scenes" 'two scenes are refused' good.nff good.nff
expect_usage "order.*sideways.*image\|object" 'an unknown order is refused' --order sideways
expect_usage 'value is missing' 'an order is needed behind --order' --order
expect_usage '-o.*value is missing' 'a file is needed behind -o' -o
expect_usage '-s.*value is missing' 'a size is needed behind -s' good.nff -s
expect_usage 'FILE.png' 'an empty name is no file' -o '' good.nff
for size in 0x0 0x5 5x0 -1x5 5x-1 10 10x x10 axb '' 5x5x5 '5 x 5' 1.5x2 1e2x5 nanxnan infx1 \
    16385x1 1000000000x1000000000 18446744073709551617x1; do
    expect_usage 'WIDTHxHEIGHT' "the size '$size' is refused" -s "$size" -o size.png good.nff
done
expect 'wrong usage makes no picture' 'there is one' [ ! -e size.png ]
expect_usage "'\?\[2Jx'" 'escape codes are not passed on' -s "$(printf '\033[2Jx')"

# ---- one pixel, explained, and figures ------------------------------------------------------------

expect_exit 0 'a pixel is explained' --explain 9,4 good.nff
expect 'the story goes to stdout' "$said" [ ! -s "$work/said/err" ]
for words in 'pixel (column, row)         (9, 4)' 'normalized (s, t)' 'vector from the eye' \
    'a, b, c' 'b^2 - 4ac' 'roots' 'In all: 1 hit, 0 behind the eye, 0 missed.' ': nearest' \
    'as bytes, round(255 c)      255, 255, 255  #ffffff' 'in the picture              255, 255, 255, the same'; do
    expect "the story says $words" "$(cat "$work/said/out")" grep -qF -e "$words" "$work/said/out"
done
expect 'the story fits into 80 columns' 'it does not' \
    [ "$(awk 'length > longest { longest = length } END { print longest }' "$work/said/out")" -le 80 ]
expect 'a story makes no picture' 'there is one' [ ! -e "$programs/gallery/good.png" ]
expect_exit 0 'a pixel of the background is explained' --explain 0,0 good.nff
expect 'the background is named' "$said" grep -q 'of the background' "$work/said/out"
expect_exit 0 '-s is taken for the story' -s 40x20 --explain 39,19 good.nff
expect_exit 0 'without a scene the story is of the own scene' --explain 300,200
expect 'the own scene is named' "$said" grep -q three-spheres.nff "$work/said/out"
for pixel in 20,0 0,10 500,500; do
    expect_usage 'not in a picture of 20 x 10' "the pixel $pixel is outside" --explain "$pixel" good.nff
done
for pixel in '' 5 5,5,5 -1,0 a,b 1.5,2 5x5; do
    expect_usage 'COLUMN,ROW' "the pixel '$pixel' is refused" --explain "$pixel" good.nff
done
expect_usage '-o: no picture' 'a story has no file' --explain 9,4 -o no.png good.nff
expect_usage 'pixel belongs to --figure' '--pixel alone is refused' --pixel 9,4 good.nff
expect_says 2 'expected object-order or' 'an unknown figure is refused' --figure sideways good.nff
expect_says 1 '^no\.nff: .*No such file' 'a missing scene is named in the story' --explain 9,4 no.nff
expect_says 1 '^no\.nff: .*No such file' 'a missing scene is named for a figure' --figure ray-casting no.nff
printf '%b' "${view}s 0 0 0 -1\n" > bad.nff
expect_says 1 '^bad\.nff:7: .*radius' 'a bad scene has no story' --explain 9,4 bad.nff
(cd / && "$program" --explain 9,4 "$work/in/good.nff" > "$work/said/out" 2> "$work/said/err")
status=$?
expect 'a pixel is explained from any folder' "$(cat "$work/said/err")" [ $status -eq 0 ]

# ---- scenes that are none -----------------------------------------------------------------------

expect_bad_scene 1 "'v'" 'an empty scene is refused' ''
expect_bad_scene 2 "'v'" 'a scene of comments is refused' '# one\n# two\n'
expect_bad_scene 1 "'v'" 'a scene without a viewpoint is refused' 's 0 0 0 1\n'
expect_bad_scene 2 "'at'" 'a viewpoint without at is refused' \
    '#\nv\nfrom 0 0 9\nup 0 1 0\nangle 40\nresolution 20 10\n'
expect_bad_scene 3 '2 numbers, expected at X Y Z' 'a scene that breaks off is refused' \
    'v\nfrom 0 0 9\nat 0 0'
expect_bad_scene 7 "'sphere', expected" 'an unknown word is refused' "${view}sphere 0 0 0 1\n"
expect_bad_scene 8 '3 numbers, expected s X Y Z RADIUS' 'a number too few is refused' \
    "$view\ns 0 0 0\n"
for number in nan inf -inf 1e999 0x10 one 1,5; do
    expect_bad_scene 7 "'$number'" "the number $number is refused" "${view}s 0 0 $number 1\n"
done
expect_bad_scene 7 'radius of 0' 'a radius of 0 is refused' "${view}s 0 0 0 0\n"
expect_bad_scene 7 'radius of -1' 'a negative radius is refused' "${view}s 0 0 0 -1\n"
expect_bad_scene 7 'colour of 2' 'a colour above 1 is refused' "${view}b 2 0 0\n"
expect_bad_scene 2 'angle of 180' 'an angle of 180 degrees is refused' 'v\nangle 180\n'
for number in 0 -20 1000000000 2.5; do
    expect_bad_scene 2 'resolution of' "a resolution of $number is refused" \
        "v\nresolution $number 10\n"
done
expect_bad_scene 9 'end of the file' 'a polygon that breaks off is refused' \
    "${view}p 3\n0 0 0\n1 0 0\n"
expect_bad_scene 7 'zero byte' 'a zero byte is refused' "${view}s 0 0 \0000 1\n"
expect_bad_scene 7 "'\?\[2J'" 'escape codes of a scene are not passed on' "$view\0033[2J\n"
head -c 3000 "$program" > bad.nff
expect_bad_file 1 . 'a program is no scene'
cp good.png bad.nff
expect_bad_file 1 . 'a picture is no scene'
head -c 5000000 /dev/zero | tr '\0' s > bad.nff
expect_bad_file 1 'more than 1000 characters' 'a line of five million characters is refused'

expect_says 1 '^no\.nff: .*No such file' 'a missing scene is named' -o bad.png no.nff
expect_says 1 '^elsewhere:.*s a directory' 'a folder is no scene' -o bad.png elsewhere
expect_says 1 'good.nff/: .*Not a directory' 'a file is no folder' -o bad.png good.nff/
expect 'what is no scene makes no picture' 'there is one' [ ! -e bad.png ]

# What is read well may still be no camera.
no_camera() {
    printf '%b' "v\nfrom 0 0 9\nat $1\nup $2\nangle 40\nresolution 20 10\n" > bad.nff
    expect_says 1 "^bad\.nff:.*$3" "$4" -o bad.png bad.nff
    expect "$4, and no picture is made" 'there is one' [ ! -e bad.png ]
}
no_camera '0 0 9' '0 1 0' 'looked at are the same' 'an eye that looks at itself is refused'
no_camera '0 0 0' '0 0 2' 'up is zero, or along' 'up along the view is refused'
no_camera '0 0 0' '0 0 -2' 'up is zero, or along' 'up against the view is refused'
no_camera '0 0 0' '0 0 0' 'up is zero, or along' 'an up of zero is refused'

# ---- where it cannot be written -----------------------------------------------------------------

mkdir out
expect_exit 0 'an older picture is there' -o out/old.png good.nff
before=$(cksum < out/old.png)
printf '%b' "${view}s 0 0 0 nan\n" > bad.nff

untouched() {
    expect "$1, and the older picture stays" "$(cksum < out/old.png)" \
        [ "$(cksum < out/old.png)" = "$before" ]
    expect "$1, and no other file is left" "$(ls -A out)" [ "$(ls -A out)" = old.png ]
}

expect_exit 1 'a bad scene is refused over a picture' -o out/old.png bad.nff
untouched 'a bad scene is refused over a picture'
expect_exit 1 'a missing scene is refused over a picture' -o out/old.png no.nff
untouched 'a missing scene is refused over a picture'
expect_exit 2 'a bad size is refused over a picture' -s 0x0 -o out/old.png good.nff
untouched 'a bad size is refused over a picture'

# A limit on the size of files breaks a write in the middle, as a full disk does.
(
    trap '' XFSZ
    ulimit -f 1
    "$program" -s 1200x1200 -o out/old.png > /dev/null 2> "$work/said/err"
)
expect 'a disk that is full in the middle is an error' "exit $?" [ $? -eq 1 ]
expect 'a disk that is full in the middle is said' "$(cat "$work/said/err")" \
    grep -q 'out/old.png: cannot write' "$work/said/err"
untouched 'a disk is full in the middle'

# Devices are written to. Root gets copies of them: should the program ever rename over a device
# again, the machine's own would be gone.
device() {
    if [ "$(id -u)" -ne 0 ]; then
        echo "/dev/$1"
    elif mknod "$work/$1" c 1 "$2" && chmod 666 "$work/$1" && : > "$work/$1"; then
        echo "$work/$1"
    fi
} 2> "$work/said/mknod"
full=$(device full 7)
null=$(device null 3)
if [ -z "$full" ] || [ -z "$null" ]; then
    echo 'skipped: writing to devices as root, who cannot make any'
else
    expect_says 1 "^$full: .*No space left" 'a full device is an error' -o "$full" good.nff
    expect 'the full device is a device still' "$(ls -l "$full")" [ -c "$full" ]
    ln -s "$full" full.png
    expect_says 1 '^full.png: .*No space left' 'a link to a full device is an error' \
        -o full.png good.nff
    expect 'the link to a device is a link still' "$(ls -l full.png)" [ -h full.png ]
    expect 'the device behind a link is a device still' "$(ls -l "$full")" [ -c "$full" ]
    expect_exit 0 'a device is written to' -o "$null" good.nff
    expect 'a device that was written to is a device still' "$(ls -l "$null")" [ -c "$null" ]
fi

expect_says 1 '^out: .*folder' 'a folder is no picture' -o out good.nff
untouched 'a folder is no picture'
expect_says 1 '^no/such/a\.png: .*No such file' 'a missing folder is named' \
    -o no/such/a.png good.nff
expect 'a missing folder is not made' 'it is' [ ! -e no ]
expect_says 1 '^good.nff/a.png: .*Not a directory' 'a file is no folder to write to' \
    -o good.nff/a.png good.nff
if [ "$(id -u)" -ne 0 ]; then
    chmod a-w out
    expect_says 1 '^out/new.png: .*Permission' 'a read-only folder is refused' \
        -o out/new.png good.nff
    chmod u+w out
    untouched 'a read-only folder is refused'
fi

expect_exit 0 'an older picture is replaced at last' -s 32x24 -o out/old.png good.nff
expect_picture 32x24 out/old.png 'an older picture is replaced at last'
expect 'no other file is left beside a new picture' "$(ls -A out)" [ "$(ls -A out)" = old.png ]

echo "command_line: $passed passed, $failed failed"
[ "$failed" -eq 0 ]
