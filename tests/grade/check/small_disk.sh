#!/bin/sh
# small_disk.sh - SIZE FOLDER KEPT COMMAND...: runs the command while FOLDER is a disk of this size, in a
# name space of mounts, and keeps a copy of what is there at the end.
size=$1
folder=$2
kept=$3
shift 3
mount -t tmpfs -o size="$size" none "$folder" || exit 1
"$@"
status=$?
cp -r "$folder" "$kept"
exit $status
