#!/bin/sh
# bombs.sh - archives that grow when they are opened, and folders without end.
# Only reads the tree.
. tests/house/runner/library.sh
once bombs "archives that grow"
needs bombs 'bombs' python3
python3 -B tests/grade/check bombs test_bombs
