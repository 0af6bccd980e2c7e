// printed.h - a program whose output could not be printed says so, and does not end well.
#ifndef COMMON_PRINTED_H
#define COMMON_PRINTED_H

// To be called once, before anything is printed. When the program ends, what it printed must have
// arrived: on a full disk it says so on stderr, and its exit status is EXIT_COULD_NOT.
void printed_or_failed(const char *program);

#endif
