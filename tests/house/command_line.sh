#!/bin/sh
# command_line.sh - tests of a program's command line: pictures, options, help, pixels explained.
# Only reads the tree.
set -u
name=command_line
. tests/house/runner/command_line.sh

# ---- pictures -----------------------------------------------------------------------------------

expect_exit 0 'a scene is cast' -o good.png good.nff
expect_picture 20x10 good.png 'the picture has the resolution of its scene'
expect 'nothing is printed on stderr' "$said" [ ! -s "$work/said/err" ]
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
expect_exit 0 'after -- a name may begin with a dash' -o dash.png -- -good.nff
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
expect 'without arguments nothing is printed on stderr' "$(cat errors.txt)" [ ! -s errors.txt ]
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

expect_exit 0 '--help is not an error' --help
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
expect_usage 'value is missing' 'an order is needed after --order' --order
expect_usage '-o.*value is missing' 'a file is needed after -o' -o
expect_usage '-s.*value is missing' 'a size is needed after -s' good.nff -s
expect_usage 'FILE.png' 'an empty name is refused' -o '' good.nff
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

finish
