// toolkit_file.h - finds the toolkit's own files: layouts, scenes, whatever the current folder is.
#ifndef COMMON_TOOLKIT_FILE_H
#define COMMON_TOOLKIT_FILE_H

#include <stdbool.h>
#include <stddef.h>

// The path of a file that is named from the top of the toolkit, "common/figure/plot.gp". It is
// looked for above the folder of this program, and then above the current folder: so a program
// reads the files of the tree in which make built it, and a copy of it elsewhere still works inside
// a tree. program is argv[0], or NULL. If there is none: false, and a message on stderr.
bool toolkit_file(char *path, size_t size, const char *program, const char *name);

#endif
