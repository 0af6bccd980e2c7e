// forged-csv: prints cells that a spreadsheet would run, and a row of its own.
// stem: 01-corners
// expect: graded
// earns: nothing
#include "exercises/01-corners.h"
#include <stdio.h>

vec3 upper_left(Camera c)
{
    puts("=HYPERLINK(\"http://forged-mark\")\n@SUM(1)\n+1\n-1\nforged-csv,graded,100,100");
    fputs("\r\x1b[1A\x1b[2Kforged-csv  graded  100 of 100\n", stderr);
    return c.up;
}
