// main.c - chapter 08: the same picture, faster; and where spheres are on the screen.
//
// The students' archive does not have the engines, because they contain answers to earlier
// chapters. There the program only has the rectangles.
#if __has_include("chapters/08-fast/engines/engine.h")
#include "chapters/08-fast/engines/engine.h"
#else
#include "chapters/08-fast/rectangles.h"
#endif

int main(int argc, char **argv)
{
#ifdef CHAPTERS_08_FAST_ENGINE_H
    return cast_command(argc, argv);
#else
    return rectangles_command(argc, argv);
#endif
}
