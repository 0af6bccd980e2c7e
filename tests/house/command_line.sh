#!/bin/sh
# command_line.sh - what the programs say of their command lines, scenes and files (command_line.txt).
# Only reads the tree.
[ -n "${TRANSCRIPT:-}" ] || exec python3 -B tests/house/runner/transcript.py tests/house/command_line.txt

# The functions of the text.
umask 022
PATH=$PATH:$BUILD/chapters/06-ray-casting
scene() { # LINES...: a viewpoint of six lines, and these, as printf prints them
    printf 'v\nfrom 0 0 9\nat 0 0 0\nup 0 1 0\nangle 40\nresolution 20 10\n'
    printf '%b\n' "$@"
}
told() { # PROGRAM ARGUMENTS...: what it says, all of it on stderr
    "$@" >.out
    told=$?
    [ ! -s .out ] && return $told
}
wrong() { # PROGRAM ARGUMENTS...: wrong usage, of which the sentence is shown
    "$@" >.out 2>.said
    [ $? -eq 2 ] && [ ! -s .out ] && tail -n 1 .said | grep -q "^Try '.* --help'\.$" && sed '1s/^[^:]*: //; $d' .said
}
taken() { # PROGRAM OPTION VALUES...: those that are not wrong
    taker=$1 option=$2
    shift 2
    for value; do
        wrong "$taker" "$option" "$value" >/dev/null || echo "'$value'"
    done
}
size() { # FILE.png: width and height, from its header
    od -A n -t u1 -j 16 -N 8 "$1" | tr -s ' '
}
broken() { # LINES...: a scene with these, that is refused without a picture
    scene "$@" >bad.nff
    told 06-ray-casting -o bad.png bad.nff && echo 'it is a scene'
}
kept() { # whether the older picture is as it was, and alone
    cksum <out/old.png | cmp - before && ls -A out
}
full() { # COMMAND...: with its output on a full device
    "$@" >/dev/full
}
limited() { # COMMAND...: files have at most a block
    (trap '' XFSZ && ulimit -f 1 && "$@")
}
reader() { # COMMAND...: as somebody who is not root, who may write everywhere
    if [ "$(id -u)" -ne 0 ]; then "$@"; else setpriv --reuid=65534 --regid=65534 --clear-groups "$@"; fi
}
# A device. Root gets copies: should a program ever rename over a device again, the machine's own would be gone.
device() { # NAME MINOR
    if [ "$(id -u)" -eq 0 ] && mknod "$1" c 1 "$2"; then chmod 666 "$1"; else ln -s "/dev/$1" "$1"; fi
}
