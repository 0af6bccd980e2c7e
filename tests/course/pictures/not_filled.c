// not_filled.c - what happens when a function of an answer is entered while a chapter's program
// draws: nothing. The chapter is right, so none of its values is undefined, and filling the stack
// (tests/judge/calls_traced.c) would make its picture take eight times as long.

void __cyg_profile_func_enter(void *function, void *from);
void __cyg_profile_func_exit(void *function, void *from);

void __cyg_profile_func_enter(void *function, void *from)
{
    (void)function;
    (void)from;
}

void __cyg_profile_func_exit(void *function, void *from)
{
    (void)function;
    (void)from;
}

// On x86-64 it is called before the function has saved its arguments: no register may change.
#ifdef __x86_64__
__asm__(".text\n"
        ".globl __fentry__\n"
        ".type __fentry__, @function\n"
        "__fentry__:\n"
        "    ret\n"
        ".size __fentry__, . - __fentry__\n");
#endif
