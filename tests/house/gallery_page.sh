#!/bin/sh
# gallery_page.sh - the page of pictures follows the lecture, and describes everything on it (gallery_page.txt).
# Only reads the tree.
. tests/house/runner/library.sh
once gallery_page "the page of pictures, its order and words"
exec python3 -B tests/house/runner/transcript.py tests/house/gallery_page.txt
