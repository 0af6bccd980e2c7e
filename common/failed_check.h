// failed_check.h - a call that the toolkit cannot answer: image_set of a pixel outside the image,
// scene_surface of a sphere that does not exist. The program ends, and says so.
#ifndef COMMON_FAILED_CHECK_H
#define COMMON_FAILED_CHECK_H

#include <stdbool.h>
#include <stddef.h>

typedef enum { NO_CHECK, CHECKED_PIXEL, CHECKED_SPHERE, CHECK_KINDS } CheckKind;

typedef struct {
    int kind; // a CheckKind
    int line; // of the call
    // Of a pixel: column, row, width, height, and how many pixels were set before; of a sphere: its
    // index, and how many there are.
    long numbers[5];
} FailedCheck;

// The last call of one of these functions: they are macros, so that each call says where it is.
void called_in(const char *file, int line);

// Says so on stderr, with the file and the line, and ends the program by abort.
_Noreturn void check_failed(CheckKind kind, const long numbers[5]);

// The judge's answering process says it in another way; NULL: there is none.
extern void (*tell_failed_check)(const FailedCheck *failed);

// The sentence. The numbers of a hidden test are left out.
void failed_check_text(const FailedCheck *failed, bool with_numbers, char *text, size_t size);

#endif
