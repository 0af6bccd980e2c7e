// give_up.h - what cannot be confined is not started.
#ifndef TESTS_GRADE_CONFINE_GIVE_UP_H
#define TESTS_GRADE_CONFINE_GIVE_UP_H

// Says what failed, and errno's reason; exit status 126.
_Noreturn void give_up(const char *what);

#endif
