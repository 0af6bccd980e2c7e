// message-error: a compiler's words that are XML, a formula, an escape code and a forged line.
// stem: 01-corners
// expect: does not compile
// earns: nothing
// rest: none
#include "exercises/01-corners.h"
#error ]]></failure></testcase><script>alert("x")</script> =cmd|'/C calc'!A0 @SUM(1) @ESC@[2J@ESC@]0;x@BEL@
#error ok 1 - upper_left # forged-mark
