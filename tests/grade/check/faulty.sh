#!/bin/sh
# faulty.sh - a compiler, a linker or a judge that fails if an answer asks for it by '// fault: ...'.
#
#   faulty.sh compiler|linker COMMAND...     in the submission's folder
#   JUDGE/judge STEM ...                     a copy of this; the judge itself is JUDGE/real/judge, and
#                                            it fails by what JUDGE/real/fault says, if that is there
fault=$(sed -n 's|^// fault: ||p' ./*.c | head -n 1)
real=${0%/*}/real
if [ -d "$real" ]; then
    set -- judge "$real/${0##*/}" "$@"
    [ ! -e "$real/fault" ] || fault=$(cat "$real/fault")
fi
tool=$1
shift
case $tool,$fault in
"$tool,the $tool is killed") kill -9 $$ ;;
"$tool,the $tool sleeps") exec sleep 1000 ;;
'compiler,the step is killed') kill -9 $PPID ;;
'compiler,the compiler refuses every file') exit 90 ;;
'linker,the linker refuses every file') exit 1 ;;
'compiler,a header is away') exec "$@" -nostdinc ;;
'linker,a library is away from when it lends')
    case " $*" in *' --defsym'*) : >away ;; esac
    [ ! -e away ] || exit 1
    ;;
'judge,every answer crashes' | 'judge,an answer crashes once')
    [ ! -e refused ] || exec "$@"
    [ "$fault" = 'every answer crashes' ] || : >refused
    "$@"
    sed -i 's/^state\t.*/state\tcrashed/' "$4/report"
    exit 1
    ;;
'compiler,the compiler refuses a file once') [ -e refused ] || { : >refused; exit 90; } ;;
'linker,the linker refuses a file once') [ -e refused ] || { : >refused; exit 1; } ;;
'judge,the judge gives up') exit 2 ;;
'judge,the judge is killed when it lends') [ "$4" != --only ] || kill -9 $$ ;;
'judge,the report is cut')
    "$@"
    status=$?
    sed -i '/^function/,$d' "$4/report"
    exit $status
    ;;
'judge,every verdict is wrong')
    "$@"
    sed -i 's/\tright/\tcrashed/' "$4/report"
    exit 1
    ;;
esac
exec "$@"
