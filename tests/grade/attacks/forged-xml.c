// forged-xml: JUnit XML that closes whatever is open, and HTML that runs.
// stem: 01-corners
// expect: graded
// earns: nothing
#include "exercises/01-corners.h"
#include <stdio.h>

vec3 upper_left(Camera c)
{
    puts("]]></failure></testcase><testcase name=\"forged-mark\"/></testsuite></testsuites>"
         "<script>alert('forged-mark')</script><!--");
    return c.up;
}
