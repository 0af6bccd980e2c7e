#!/bin/sh
# other_machines.sh - other machines: locales, names of folders, trees that cannot be written.
# Only reads the tree.
set -u
cd "$(dirname "$0")/../.." && . tests/house/runner/library.sh
once other_machines "other machines"

# ---- locales ------------------------------------------------------------------------------------

script=$scratch/figure.gp
"$PROGRAMS/05-quadratic" --figure parabola >"$script"
draws_in() {
    (cd "$scratch" && LC_ALL=$1 gnuplot -e "output='$1'" figure.gp >"$scratch/said" 2>&1) && [ -s "$scratch/$1.svg" ]
}
# gnuplot 6 says nothing, and earlier ones nothing but this.
no_other_word() {
    grep -v 'iconv failed to convert degree sign' "$scratch/said"
    [ $? -eq 1 ] && { [ ! -s "$scratch/said" ] || gnuplot --version | grep -q 'gnuplot [1-5]\.'; }
}
if command -v gnuplot >/dev/null; then
    check 'gnuplot draws a figure' draws_in C.UTF-8
    check 'and in locale C' draws_in C
    check 'without a word that matters' no_other_word
    check 'the same bytes' cmp "$scratch/C.svg" "$scratch/C.UTF-8.svg"
else
    echo "skipped: figures in locale C: gnuplot is missing ('make setup' installs it)"
fi

# ---- names of folders, trees that cannot be written -------------------------------------------------

tree=$scratch/100%-mine
copy_of_the_tree() {
    mkdir "$tree" && cp -r Makefile .make common chapters exercises solutions tests "$tree" && chmod -R a+rX "$scratch"
}
says_in_the_copy() {
    words=$1
    shift
    "$@" >"$scratch/said" 2>&1
    status=$?
    says "$words" && [ "$(wc -l <"$scratch/said")" -eq 1 ] && [ $status -ne 0 ]
}
knows_its_answers() {
    make -s -C "$tree" -n all ANSWERS="$1" >"$scratch/said" 2>&1 || { tail -n 3 "$scratch/said"; return 1; }
    ! find "$tree/build" -name '*.o' | grep . # with -n nothing is built
}
# Root may write everywhere, so it becomes somebody else.
as_another() {
    if [ "$(id -u)" -ne 0 ]; then
        "$@"
    else
        setpriv --reuid=65534 --regid=65534 --clear-groups "$@"
    fi
}
check 'there is a copy of the tree' copy_of_the_tree
check "a '%' in the path of the tree spoils nothing" knows_its_answers solutions
check 'nor do answers by their whole path' knows_its_answers "$tree/solutions"
rm -rf "$tree/build"
mkdir "$scratch/50%" && cp solutions/*.c "$scratch/50%"
check "answers elsewhere must have none, and that is said" says_in_the_copy "expected a folder whose path has no '%'" \
    make --no-print-directory -C "$tree" ANSWERS="$scratch/50%"
chmod a-w "$tree"
check 'a tree that can only be read is reported as such' says_in_the_copy 'make cannot write into' \
    as_another make --no-print-directory -C "$tree"
chmod u+w "$tree"
mkdir "$tree/build" && : >"$tree/build/flags" && chmod a-w "$tree/build/flags" "$tree/build"
check 'so is one that somebody else has built' says_in_the_copy "make cannot write to 'build" \
    as_another make --no-print-directory -C "$tree"
chmod -R u+w "$tree"

# ---- what drives gnuplot --------------------------------------------------------------------------

# If gnuplot draws nothing and prints nothing, make does not claim a figure.
draws_nothing() {
    mkdir -p "$scratch/bin" "$scratch/figures/figure"
    printf '#!/bin/sh\nexit 0\n' >"$scratch/bin/gnuplot"
    chmod +x "$scratch/bin/gnuplot"
    cp "$script" "$scratch/figures/figure/figure.gp"
    PATH=$scratch/bin:$PATH FORMAT=svg python3 chapters/gallery/draw_figures.py "$scratch/figures" figure >"$scratch/said" 2>&1
    [ $? -eq 1 ] && says 'could not be made of what gnuplot drew' && says_not 'Figures: 1'
}
# One gnuplot draws several, and ends at a fault.
draws_the_others() {
    rm -rf "$scratch/figures" && mkdir "$scratch/figures"
    for name in one two three four; do
        mkdir "$scratch/figures/$name" && cp "$script" "$scratch/figures/$name/$name.gp"
    done
    echo 'if (step == 1 && dark) plot nothing' >>"$scratch/figures/three/three.gp"
    FORMAT=svg STEPS=1 python3 chapters/gallery/draw_figures.py "$scratch/figures" one two three four >"$scratch/said" 2>&1
    [ $? -eq 1 ] && says 'undefined variable: nothing' && [ "$(grep -c 'gnuplot:' "$scratch/said")" -eq 1 ] &&
        [ -e "$scratch/figures/three/three-step1.svg" ] && [ ! -e "$scratch/figures/three/three-step1-dark.svg" ] &&
        [ "$(find "$scratch/figures" -name '*.svg' | wc -l)" -eq $((4 * $(find "$scratch/figures/one" -name '*.svg' | wc -l) - 1)) ]
}
if command -v gnuplot >/dev/null; then
    check 'pictures that were not drawn are not counted' draws_nothing
    check 'a picture that cannot be drawn is named, and the others are drawn' draws_the_others
fi

# ---- setup ----------------------------------------------------------------------------------------

# No package is installed, sudo asks for a password, and there is no terminal.
advises() {
    mkdir -p "$scratch/sudo"
    for tool in sh cat mktemp rm id printf sed grep uname dirname; do
        ln -sf "$(command -v $tool)" "$scratch/sudo/$tool"
    done
    printf '#!/bin/sh\nexit 1\n' >"$scratch/sudo/sudo"
    cp "$scratch/sudo/sudo" "$scratch/sudo/apt-get"
    printf '#!/bin/sh\necho 1000\n' >"$scratch/sudo/id.new"
    chmod +x "$scratch"/sudo/*
    mv "$scratch/sudo/id.new" "$scratch/sudo/id"
    PATH=$scratch/sudo .make/setup </dev/null >"$scratch/said" 2>&1
    [ $? -eq 1 ] && says '  sudo apt-get install -y' && says_not 'sudo -n'
}
check 'setup without a terminal advises what works on one' advises
# 'make setup all' builds with what setup has just installed: here the compiler.
late=$scratch/late
waits_for_setup() {
    mkdir "$late" && cp -r Makefile .make common chapters exercises solutions tests "$late" || return 1
    # shellcheck disable=SC2016 # the other shell expands it
    printf '#!/bin/sh\nsleep 1\nln -s "$(command -v %s)" %s/cc\n' "${CC:-cc}" "$late" >"$late/.make/setup"
    make --no-print-directory -C "$late" setup build/list_exercises CC="$late/cc" >"$scratch/said" 2>&1
}
check 'what is built waits for setup' waits_for_setup

finish other_machines
