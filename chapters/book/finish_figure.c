// finish_figure.c - makes of gnuplot's SVG, figure's words and script the figure that a page shows:
// by the code that makes the figures of 'make figures', in a page.
//
//   finish_figure DRAWN.svg WORDS SCRIPT.gp     prints the SVG
#include "chapters/gallery/svg_picture.h"

#include <stdio.h>
#include <stdlib.h>

// All of a file, for freeing.
static char *text_of(const char *path)
{
    char *text = NULL, part[4096];
    size_t size;
    FILE *file = fopen(path, "rb"), *copy = open_memstream(&text, &size);
    if (file == NULL || copy == NULL) {
        perror(path);
        exit(1);
    }
    for (size_t n; (n = fread(part, 1, sizeof part, file)) > 0;)
        fwrite(part, 1, n, copy);
    fclose(file);
    fclose(copy);
    return text;
}

int main(int argc, char **argv)
{
    if (argc != 4) {
        fprintf(stderr, "Usage: %s DRAWN.svg WORDS SCRIPT.gp\n", argv[0]);
        return 2;
    }
    char *svg = text_of(argv[1]), *words = text_of(argv[2]), *script = text_of(argv[3]);
    tidy_words(words);
    const char *description = split_words(words);
    write_svg_picture(stdout, svg, words, description, script);
    free(svg);
    free(words);
    free(script);
    return 0;
}
