// own_figure.c - main of a program that only prints a figure of somebody's own.
#include "chapters/shared/own_figure.h"

#include <string.h>

static void data(Plot *plot, void *given)
{
    (void)given;
    figure_data(plot);
}

int main(int argc, char **argv)
{
    FigureCommand command = {0};
    const Option options[] = {FIGURE_OPTIONS(command), {0}};
    Usage usage = {"--figure NAME --layout FILE.gp",
                   "Prints the gnuplot script of a figure of your own."};
    if (options_read(argc, argv, options, usage) < argc)
        options_wrong(argv[0], "expected no file");
    if (command.name == NULL || command.layout == NULL)
        options_wrong(argv[0], "expected --figure NAME --layout FILE.gp");
    const char *slash = strrchr(argv[0], '/');
    const Figure figures[] = {{slash != NULL ? slash + 1 : argv[0], data}, {0}};
    return plot_figure(argv[0], "", figures, command, NULL);
}
