#!/bin/sh
# own_figures.sh - make figures FIGURES=folder: the example of chapters/README.md, what is refused (own_figures.txt).
# Builds only below its answers.
. tests/house/runner/library.sh
once own_figures "a lecturer's own figures"
needs own_figures "a lecturer's own figures" gnuplot
unset ANSWERS
exec python3 -B tests/house/runner/transcript.py tests/house/own_figures.txt
