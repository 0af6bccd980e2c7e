#!/bin/sh
# answer_pictures.sh - the pictures that a student's answers draw before all is right, the words about them, and how
# far all chapters are (answer_pictures.txt).
# Builds only below its answers.
. tests/house/runner/library.sh
once answer_pictures "the pictures of answers"
exec python3 -B tests/house/runner/transcript.py tests/house/answer_pictures.txt
