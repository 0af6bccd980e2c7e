// include-system-files: files that are no C, so that the compiler quotes them in its complaints.
// stem: 01-corners
// expect: does not compile
// earns: nothing
// rest: none
#include "@HOME@/.netrc"
#include "/etc/passwd"
#include "/etc/shadow"
#include "/proc/self/cmdline"
#include "/proc/self/environ"
#include "/proc/self/mountinfo"
