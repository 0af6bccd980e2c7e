// json.h - text for a page: a string in JSON.
#ifndef COMMON_FIGURE_JSON_H
#define COMMON_FIGURE_JSON_H

#include <stdio.h>

// In double quotes. The text has no control characters but line ends.
void json_print_string(FILE *out, const char *text);

#endif
