// tool.h - how a part of the compiler ended, and whether processes can be started at all.
#ifndef TESTS_GRADE_CONFINE_TOOL_H
#define TESTS_GRADE_CONFINE_TOOL_H

// The exit statuses of run_tool, as tests/grade/mark/building.py reads them. All but the last are
// due to the text that was compiled.
enum {
    TOOL_REFUSES = 90, // exit status 1: it says what is wrong with the text
    TOOL_WORK = 91,    // more work than the limit
    TOOL_FILE = 92,    // a larger file than the limit
    TOOL_CRASHED = 93, // a fault of its own: memory, stack, assertion
    TOOL_ODD = 94,     // another exit status: it found an error in itself
    TOOL_ENDED = 99,   // ended by somebody else, or could not be started
};

// Runs the command and waits for it.
int run_tool(char **command);

// 0 if that number of processes can exist at a time.
int room_for(int processes);

#endif
