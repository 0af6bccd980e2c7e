// stored_zip.h - a zip of small files as they are: any system opens it, and the same files give the
// same bytes.
#ifndef TESTS_SUBMISSION_STORED_ZIP_H
#define TESTS_SUBMISSION_STORED_ZIP_H

#include <stddef.h>
#include <stdio.h>

typedef struct {
    const char *name; // in the archive: ASCII, no folder
    char *bytes;
    size_t length; // less than 4 GB, like all of them together
} ZipMember;

// Without compression, owner and date. Whether it was written is what ferror and fclose say.
void zip_write(FILE *file, const ZipMember members[], size_t count);

#endif
