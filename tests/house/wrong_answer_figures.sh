#!/bin/sh
# wrong_answer_figures.sh - a wrong answer is drawn beside the right one: under its verdict, and in every figure
# (wrong_answer_figures.txt).
# Builds only below its answers.
. tests/house/runner/library.sh
once wrong_answer_figures "the figures of wrong answers"
needs wrong_answer_figures 'yours beside right' gnuplot python3
unset ANSWERS
NO_COLOR=1 counted python3 tests/house/figures/wrong_answers.py "$scratch/python"
counted python3 -B tests/house/runner/transcript.py tests/house/wrong_answer_figures.txt
finish wrong_answer_figures
