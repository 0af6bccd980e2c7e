// options.h - command lines: a table of options, read by getopt_long.
//
// Every program of the toolkit describes its options in one table; --help, the messages about
// wrong usage and their exit codes (0 done, 1 could not, 2 wrong usage) come with it.
#ifndef COMMON_OPTIONS_H
#define COMMON_OPTIONS_H

#include <stdbool.h>

enum { EXIT_DONE = 0, EXIT_COULD_NOT = 1, EXIT_WRONG_USAGE = 2 };

// Reads what was given for an option; false where it is not what was expected.
typedef bool OptionReader(const char *text, void *into);

typedef struct {
    const char *name;     // the long form, without its dashes
    char letter;          // the short form, or 0
    const char *expected; // what follows, as the help shows it: "X,Y,Z"; NULL where nothing does
    OptionReader *read;
    void *into;       // what read is given
    const char *help; // one line; NULL: --help does not list it
} Option;

// The text of a program for --help.
typedef struct {
    const char *synopsis; // what follows the program's name
    const char *purpose;  // one sentence or two
} Usage;

// Reads the options up to the one that has no name. Returns the index in argv of the first
// operand. On --help it prints and exits with 0; on an error it says which and exits with 2.
int options_read(int argc, char **argv, const Option *options, Usage usage);

// Says what is wrong with the command line and exits with 2.
_Noreturn void options_wrong(const char *program, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

OptionReader option_flag;   // bool: set to true
OptionReader option_string; // const char *
OptionReader option_number; // double: 0, or 1e-60 to 1e60, or minus that
OptionReader option_vec3;   // vec3:        X,Y,Z, the same three times
OptionReader option_pair;   // double[2]:   X,Y, the same twice
OptionReader option_pixel;  // Pixel:       COLUMN,ROW
OptionReader option_size;   // Resolution:  WIDTHxHEIGHT, 1 to IMAGE_MAX_SIDE each (image.h)

// One whole number in decimal digits, and nothing else; false if it is not from least to most.
bool option_whole(const char *text, int least, int most, int *number);

// The options that describe a camera by its frame, for a table: <p, r, u, f, d, w, h>.
#define CAMERA_OPTIONS(camera)                                                                     \
    {"eye", 0, "X,Y,Z", option_vec3, &(camera).origin, "p, the eye"},                              \
        {"right", 0, "X,Y,Z", option_vec3, &(camera).right, "r, unit"},                            \
        {"up", 0, "X,Y,Z", option_vec3, &(camera).up, "u, unit"},                                  \
        {"forward", 0, "X,Y,Z", option_vec3, &(camera).forward, "f, unit"},                        \
        {"distance", 0, "D", option_number, &(camera).distance, "d, to the image plane"},          \
        {"width", 0, "W", option_number, &(camera).width, "w, of the image plane"},                \
    {                                                                                              \
        "height", 0, "H", option_number, &(camera).height, "h, of the image plane"                 \
    }

// ---- was all printed? ---------------------------------------------------------------------------

// To be called once, before anything is printed. When the program ends, what it printed must have
// arrived: on a full disk it says so on stderr, and its exit status is EXIT_COULD_NOT.
void printed_or_failed(const char *program);

#endif
