#!/bin/sh
# command_line_files.sh - tests of a program's files: scenes that are none, places to write to.
# Only reads the tree.
set -u
name=command_line_files
. tests/house/runner/command_line.sh
mkdir elsewhere
"$program" -o good.png good.nff

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
expect_bad_file 1 . 'a program is not a scene'
cp good.png bad.nff
expect_bad_file 1 . 'a picture is not a scene'
head -c 5000000 /dev/zero | tr '\0' s > bad.nff
expect_bad_file 1 'more than 1000 characters' 'a line of five million characters is refused'

expect_says 1 '^no\.nff: .*No such file' 'a missing scene is named' -o bad.png no.nff
expect_says 1 '^elsewhere:.*s a directory' 'a folder is not a scene' -o bad.png elsewhere
expect_says 1 'good.nff/: .*Not a directory' 'a file is not a folder' -o bad.png good.nff/
expect 'what is not a scene makes no picture' 'there is one' [ ! -e bad.png ]

# A readable scene may still not be a camera.
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
expect 'a disk that becomes full is reported' "$(cat "$work/said/err")" \
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
    expect 'the device that a link points to stays a device' "$(ls -l "$full")" [ -c "$full" ]
    expect_exit 0 'a device is written to' -o "$null" good.nff
    expect 'a device that was written to is a device still' "$(ls -l "$null")" [ -c "$null" ]
fi

expect_says 1 '^out: .*folder' 'a folder is not a picture' -o out good.nff
untouched 'a folder is not a picture'
expect_says 1 '^no/such/a\.png: .*No such file' 'a missing folder is named' \
    -o no/such/a.png good.nff
expect 'a missing folder is not made' 'it is' [ ! -e no ]
expect_says 1 '^good.nff/a.png: .*Not a directory' 'a file is not a folder to write to' \
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

finish
