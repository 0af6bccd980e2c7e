// reference-next-door: when another answer is replaced by the reference, its own is not far from
// there. Calls what lies around it, until something knows the deck's corner.
// stem: 01-corners
// expect: graded | crashed | timed out
// earns: nothing
#include "exercises/01-corners.h"
#include <setjmp.h>
#include <signal.h>
#include <stddef.h>

typedef vec3 Function(Camera c);
static sigjmp_buf before;

static void back(int number)
{
    siglongjmp(before, 1);
}

static bool is_upper_left(Function *f)
{
    bool good = false;
    if (sigsetjmp(before, 1) == 0) {
        vec3 v = f(camera_of_the_deck());
        good = v[0] == -1 && v[1] == 1 && v[2] == 4;
    }
    return good;
}

vec3 upper_left(Camera c)
{
    static Function *found;
    signal(SIGSEGV, back), signal(SIGILL, back), signal(SIGBUS, back), signal(SIGFPE, back);
    for (int i = -64; i < 64 && found == NULL; i++)
        for (int j = 0; j < 3 && found == NULL; j++) {
            Function *near[] = {upper_right, across_30_up_10, (Function *)image_plane_vector};
            Function *f = (Function *)((char *)near[j] + 16 * i);
            if (f != upper_left && is_upper_left(f))
                found = f;
        }
    return found != NULL ? found(c) : c.up;
}

vec3 upper_right(Camera c)
{
    return c.up;
}

vec3 across_30_up_10(Camera c)
{
    return c.up;
}

vec3 image_plane_vector(Camera c, double s, double t)
{
    return c.up;
}
