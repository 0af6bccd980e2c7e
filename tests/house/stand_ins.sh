#!/bin/sh
# stand_ins.sh - a file that cannot be compiled to WebAssembly has one of the same name in chapters/book/instead/. This
# has all functions of the file that it replaces, so a new function is missed here, and not when the page is built.
# Compiles both for this machine, into a folder of its own.
set -u
. tests/house/runner/library.sh

functions_of() { # FILE.c: the names that it defines
    # shellcheck disable=SC2086 # several words
    ${CC:-cc} -std=c11 -D_DEFAULT_SOURCE -I. -w -O0 -c -o "$scratch/object.o" "$1" &&
        nm -g --defined-only "$scratch/object.o" | sed 's/.* //' | sort
}
has_all_functions() { # FILE.c
    instead=chapters/book/instead/${1##*/}
    functions_of "$1" >"$scratch/here" && functions_of "$instead" >"$scratch/instead" || return 1
    comm -23 "$scratch/here" "$scratch/instead" | sed "s|.*|$instead lacks &(), which $1 has|" >"$scratch/missing"
    cat "$scratch/missing"
    [ -s "$scratch/here" ] && [ ! -s "$scratch/missing" ]
}
for file in common/image_png.c common/toolkit_file.c common/whole_file.c tests/course/programs.c \
    tests/judge/process.c tests/judge/system_call.c; do
    check "$file has all its functions in a page" has_all_functions "$file"
done
finish stand_ins
