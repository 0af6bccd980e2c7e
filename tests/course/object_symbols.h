// object_symbols.h - the global symbols of a compiled file, without a program that reads it.
#ifndef TESTS_COURSE_OBJECT_SYMBOLS_H
#define TESTS_COURSE_OBJECT_SYMBOLS_H

#include <stdbool.h>

typedef struct {
    const char *name;
    bool is_defined, is_function;
    // A function or a variable of the ordinary kind: visible to all, no version, not chosen when
    // the program starts, not one for each thread.
    bool is_plain;
} ObjectSymbol;

// Calls look for each, as long as it returns true. False if it once did not, or if the file is not
// an ELF object of this machine.
bool object_symbols(const char *path, bool (*look)(const ObjectSymbol *symbol, void *given),
                    void *given);

#endif
