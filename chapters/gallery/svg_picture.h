// svg_picture.h - makes gnuplot's SVG one that can be read aloud, and that shows the same
// everywhere.
#ifndef CHAPTERS_GALLERY_SVG_PICTURE_H
#define CHAPTERS_GALLERY_SVG_PICTURE_H

#include <stdio.h>

// A figure's words as they are read: no spaces where a sentence is left out.
void tidy_words(char *text);

// A figure in words, as the layout says it (NAME.txt): its title; the text has the description
// left, in one line.
const char *split_words(char *text);

// Writes the SVG that gnuplot has drawn, with these words. svg is used up. script: if gnuplot drew
// frames for the pictures of this script (common/figure/pictures.gp), the pictures are put into
// them; NULL if it drew the pictures.
void write_svg_picture(FILE *out, char *svg, const char *title, const char *description,
                       const char *script);

#endif
