// crash_reason.h - why a call brought no answer, in words.
#ifndef TESTS_JUDGE_CRASH_REASON_H
#define TESTS_JUDGE_CRASH_REASON_H

#include "tests/judge/wire.h"

// From what the process said before it ended: hostile words, of which only numbers are looked at.
void describe_crash(char *why, size_t size, const WireCrash *crash);

// From its wait status; -1: it closed its pipe.
void describe_end(char *why, size_t size, int status);

#endif
