#!/bin/sh
# animations.sh - the videos and the numbered pictures of animations: their size, their length, their bytes.
#
# MOST_ANIMATIONS says how many of the four are drawn (4), beside a small one. tests/house/figures/animations.py
# tests what they show.
# Only reads the tree.
set -u
cd "$(dirname "$0")/../.." && . tests/house/runner/library.sh
once videos "the videos of animations"

needs videos 'the videos of animations' gnuplot python3
draw_in() {
    folder=$1
    shift
    # shellcheck disable=SC2086 # names are words
    env "$@" python3 -B chapters/animations/draw_animations.py "$folder" $names >"$scratch/said" 2>&1
    status=$?
    cat "$scratch/said"
    return $status
}
fails_with() {
    wanted=$1
    shift
    "$@"
    [ $? -eq "$wanted" ]
}
# The small one is image order with 4 x 3 pixels.
sed 's/^resolution .*/resolution 4 3/' chapters/06-ray-casting/figures/four-spheres.nff >"$scratch/small.nff"
names="small $(printf '%s\n' image-order closest-hit object-order discriminant | head -n "${MOST_ANIMATIONS:-4}" | tr '\n' ' ')"
script_of() {
    case $1 in
    small) "$PROGRAMS/print_animation" image-order "$scratch/small.nff" ;;
    *) "$PROGRAMS/print_animation" "$1" ;;
    esac
}
for name in $names; do
    for folder in "$scratch/one" "$scratch/two"; do
        mkdir -p "$folder/$name"
        script_of "$name" >"$folder/$name/$name.gp" || exit 1
    done
done

# What is missing is named before anything is drawn.
check 'without ffmpeg it fails' fails_with 3 without ffmpeg draw_in "$scratch/one" FORMAT=mp4
check 'and says what to install' says "'make setup FOR=lecturer' installs it"
mkdir "$scratch/fake"
printf '#!/bin/sh\necho " V..... gif   GIF"\n' >"$scratch/fake/ffmpeg"
chmod +x "$scratch/fake/ffmpeg"
in_front_of_all() {
    (
        # shellcheck disable=SC2031 # of this subshell alone
        PATH=$scratch/fake:$PATH
        "$@"
    )
}
check 'with an ffmpeg that lacks an encoder too' fails_with 3 in_front_of_all draw_in "$scratch/one" FORMAT=gif,webm
check 'and says which' says "ffmpeg has no libvpx-vp9 here, so no webm can be made: 'make setup FOR=lecturer' installs it"
check 'an unknown format is refused' fails_with 2 draw_in "$scratch/one" FORMAT=avi
check 'and those that are known are named' says 'FORMAT=avi: expected mp4, webm, gif, apng, png'
check 'an unknown theme is refused' fails_with 2 draw_in "$scratch/one" THEME=blue

# The frames need no ffmpeg.
check 'without ffmpeg the frames are drawn' without 'ffmpeg ffprobe' draw_in "$scratch/one" FORMAT=png THEME=light
for name in $names; do
    frames=$scratch/one/$name/frames
    last=$(sed -n "s/^  $name: \([0-9]*\) frames.*/\1/p" "$scratch/said")
    all_are_there() {
        [ "$last" -gt 0 ] && [ "$(ls "$frames")" = "$(seq -f '%04.0f.png' "$last")" ]
    }
    check "$name: all its frames, numbered from 0001 on" all_are_there
    stops_are_frames() {
        first=$scratch/one/$name/steps/01.png
        [ -s "$first" ] && for frame in "$frames"/*; do ! cmp -s "$first" "$frame" || return 0; done
    }
    check "$name: its steps for slides are some of them" stops_are_frames
done

# A frame that is lost is drawn again, and no other.
frames=$scratch/one/small/frames
cp "$frames/0005.png" "$scratch/lost.png"
rm "$frames/0005.png"
touch "$scratch/before"
check 'a lost frame is drawn again' draw_in "$scratch/one" FORMAT=png THEME=light
check 'as it was' cmp "$frames/0005.png" "$scratch/lost.png"
check 'and no other' test "$(find "$scratch/one" -name '????.png' -newer "$scratch/before" | wc -l)" -eq 1
check 'then all are there' draw_in "$scratch/one" FORMAT=png THEME=light
check 'and this is said' says '(all were there)'

# A turntable: chapter 08 from all sides.
turn() {
    env FORMAT=png FRAMES=4 python3 -B chapters/animations/draw_animations.py "$scratch/one" --turn table \
        chapters/06-ray-casting/three-spheres.nff "$PROGRAMS/08-fast" --shaded -s 64x36
}
check 'a turntable is drawn' turn
check 'it has as many sides as are wanted' test "$(find "$scratch/one/table/frames" -name '????.png' | wc -l)" -eq 4
check 'all differ' test "$(cksum "$scratch"/one/table/frames/* | cut -d' ' -f1 | sort -u | wc -l)" -eq 4
check 'the scene without a turn' "$PROGRAMS/08-fast" --shaded -s 64x36 -o "$scratch/front.png" chapters/06-ray-casting/three-spheres.nff
check 'is its first frame' cmp "$scratch/front.png" "$scratch/one/table/frames/0001.png"
check 'and its last, after all the way round' "$PROGRAMS/08-fast" --shaded -s 64x36 --turn -360 -o "$scratch/round.png" chapters/06-ray-casting/three-spheres.nff
check 'the same picture' same_picture "$scratch/front.png" "$scratch/round.png" 20 1

for program in ffmpeg ffprobe; do
    command -v $program >/dev/null || skip videos "videos, which need ffmpeg (make setup FOR=lecturer)"
done
for encoder in libx264 libvpx-vp9; do
    ffmpeg -hide_banner -encoders 2>/dev/null | grep -q " $encoder " || skip videos "videos, which need ffmpeg with $encoder"
done
check 'videos are made' draw_in "$scratch/one" FORMAT=mp4,webm,gif,apng THEME=light
check 'in another folder also' draw_in "$scratch/two" FORMAT=mp4,webm,gif,apng THEME=light
asked() {
    ffprobe -v error -count_packets -select_streams v:0 -show_entries "$2" -of csv=p=0 "$1"
}
# All the way round in 6 s, so every fifth of 90 frames, as large as they are.
turn_in_few_pictures() {
    env FORMAT=gif,apng FRAMES=90 python3 -B chapters/animations/draw_animations.py "$scratch/one" --turn around \
        chapters/06-ray-casting/three-spheres.nff "$PROGRAMS/08-fast" --shaded -s 256x144
}
check 'a turntable in few pictures is made' turn_in_few_pictures
for format in gif apng; do
    check "a turntable's $format is as large as its frames, and every fifth of them" \
        test "$(asked "$scratch/one/around/around.$format" stream=width,height,nb_read_packets)" = 256,144,18
done
for name in $names; do
    last=$(find "$scratch/one/$name/frames" -name '????.png' | wc -l)
    for format in mp4 webm gif apng; do
        video=$scratch/one/$name/$name.$format
        check "$name.$format has 1280 x 720 pixels" test "$(asked "$video" stream=width,height)" = 1280,720
        check "$name.$format has less than 3 MB" test "$(wc -c <"$video")" -lt 3000000
        check "$name.$format has the same bytes each time" cmp "$video" "$scratch/two/$name/$name.$format"
        # A story rests on its last frame: as a delay, or as more frames.
        case $format in mp4 | webm) rest=10 ;; *) rest=0 ;; esac
        check "$name.$format shows every frame, and rests at its end" \
            test "$(asked "$video" stream=nb_read_packets)" -ge $((last + rest))
    done
    check "$name: its frames have the same bytes each time" diff -r "$scratch/one/$name/frames" "$scratch/two/$name/frames"
done
finish videos
