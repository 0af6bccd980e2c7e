// system_call.h - what a forbidden system call was for, in words.
#ifndef TESTS_JUDGE_SYSTEM_CALL_H
#define TESTS_JUDGE_SYSTEM_CALL_H

// Of any number: 'to open a file'; it comes from hostile code.
const char *system_call_purpose(int number);

#endif
