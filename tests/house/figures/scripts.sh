# scripts.sh - for the tests of figures: their scripts, and commands that are not there.
# shellcheck shell=sh disable=SC2154 # scratch is the library's

# Has the programs print the script of every figure into a folder, FOLDER/NAME/NAME.gp; their names are in
# 'names'.
scripts_into() {
    names=""
    for layout in chapters/*/figures/*.gp; do
        name=$(basename "$layout" .gp)
        names="$names $name"
        mkdir -p "$1/$name"
        "$PROGRAMS/$(basename "${layout%/figures/*}")" --figure "$name" >"$1/$name/$name.gp" || return 1
    done
}

# Runs a command where others are missing: without 'gnuplot fc-list' COMMAND...
without() {
    mkdir "$scratch/bin"
    for folder in $(echo "$PATH" | tr ':' ' '); do
        ln -s "$folder"/* "$scratch/bin" 2>/dev/null
    done
    for missing in $1; do
        rm -f "$scratch/bin/$missing"
    done
    shift
    (
        PATH=$scratch/bin
        "$@"
    )
    status=$?
    rm -rf "${scratch:?}/bin"
    return $status
}
