// exit-in-preinit: .preinit_array runs before any constructor.
// stem: 01-corners
// expect: crashed
// earns: nothing
// says: by itself | was killed | no answer
#include "exercises/01-corners.h"
#include <unistd.h>

static void leave(void)
{
    _exit(0);
}

__attribute__((section(".preinit_array"), used)) static void (*const first)(void) = leave;
