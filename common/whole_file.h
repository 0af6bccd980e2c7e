// whole_file.h - files that are written whole or not at all.
//
// The new file is written beside its place under another name and renamed when it is complete. So
// every reader sees the old file or the new one, never half of one. A program that is ended
// meanwhile (by Ctrl-C, say) leaves the other file, '.' and six letters.
#ifndef COMMON_WHOLE_FILE_H
#define COMMON_WHOLE_FILE_H

#include "common/text.h"

#include <stdbool.h>
#include <stdio.h>

// Writes what is given to a file. False, and a message that names path, where it could not.
typedef bool FileWriter(FILE *file, const void *given, const char *path, Message *message);

// False, and a message, if it is clear before any work that path cannot be written.
bool file_path_is_writable(const char *path, Message *message);

// Whether two paths lead to one and the same ordinary file, by whatever links.
bool file_is_same(const char *one, const char *other);

// On failure an older file stays as it was. A device or a pipe is written to directly. False, and a
// message, where it could not.
bool file_write_whole(const char *path, FileWriter *write, const void *given, Message *message);

#endif
