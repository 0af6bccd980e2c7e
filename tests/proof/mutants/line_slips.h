// line_slips.h - the slips of the pen that can happen in one line of C.
#ifndef TESTS_PROOF_MUTANTS_LINE_SLIPS_H
#define TESTS_PROOF_MUTANTS_LINE_SLIPS_H

// Calls say for each other line that the line becomes when one sign, factor, operand, comparison,
// name or index in it is another, each once.
void line_slips(const char *line, void (*say)(const char *slip, void *context), void *context);

#endif
