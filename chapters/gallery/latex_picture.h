// latex_picture.h - makes gnuplot's LaTeX picture one that any document can take in.
#ifndef CHAPTERS_GALLERY_LATEX_PICTURE_H
#define CHAPTERS_GALLERY_LATEX_PICTURE_H

#include <stdbool.h>
#include <stdio.h>

// Writes the picture that gnuplot has drawn: first the figure in words, as comments; labels as
// LaTeX writes them (gnuplot leaves them as they are); a background that is not larger than the
// picture; and the name of the graphics without a folder. False, and a message on stderr, if a
// label would be misplaced.
bool write_latex_picture(FILE *out, const char *drawn, const char *words, const char *graphics);

#endif
