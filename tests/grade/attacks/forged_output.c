// forged_output.c - output, reports and messages to the judge that imitate the grader's own.
// cases.py reads it: each section is one submission, and states the result that it must get.

// ---- forged-answer-by-halves: half a header, then nothing more, so that the judge waits for ever.
// stem: 01-corners
// expect: timed out | crashed
// earns: upper_right
// says: still running | invalid answer | never comes
#include "exercises/01-corners.h"
#include <unistd.h>

vec3 upper_left(Camera c)
{
    if (write(4, "CyaR\0\0\0", 8) == 8)
        for (;;)
            pause();
    return c.up;
}

vec3 upper_right(Camera c)
{
    return c.distance * c.forward + c.width / 2 * c.right + c.height / 2 * c.up;
}

// ---- forged-answer-byte-by-byte: feeds the judge a byte now and then, each just before it gives up.
// stem: 01-corners
// expect: timed out | crashed
// earns: nothing
#include "exercises/01-corners.h"
#include <unistd.h>

vec3 upper_left(Camera c)
{
    for (int i = 0; i < 60; i++) {
        if (write(4, "C", 1) != 1)
            break;
        usleep(900000);
    }
    return c.up;
}

// ---- forged-answer-early: finds the call and its nonce in memory, and answers before it is asked to.
// stem: 01-corners
// expect: crashed | graded
// earns: nothing
#include "exercises/01-corners.h"
#include <stdint.h>
#include <string.h>
#include <unistd.h>

typedef struct {
    uint32_t magic;
    int32_t exercise;
    uint64_t nonce, size;
    int32_t kind;
    char missing[60];
} Header;
extern char __bss_start[], _end[];

vec3 upper_left(Camera c)
{
    vec3 answer = vec3_of(-1, 1, 4);
    for (char *at = __bss_start; at + sizeof(Header) < _end; at += 8) {
        Header found;
        memcpy(&found, at, sizeof found);
        if (found.magic != 0x52617943)
            continue;
        for (int i = 0; i < 9; i++, found.nonce++) {
            found.kind = 1;
            found.size = sizeof answer;
            if (write(4, &found, sizeof found) < 0 || write(4, &answer, sizeof answer) < 0)
                return c.up;
        }
    }
    return answer;
}

// ---- forged-answer-guessed: an answer for the judge's pipe with a nonce that is a guess.
// stem: 01-corners
// expect: crashed
// earns: upper_right
// says: invalid answer | no answer | was killed | by itself
#include "exercises/01-corners.h"
#include <stdint.h>
#include <unistd.h>

static struct {
    uint32_t magic;
    int32_t exercise;
    uint64_t nonce, size;
    int32_t kind;
    char missing[60];
    vec3 answer;
} message = {.magic = 0x52617943, .nonce = 1, .size = sizeof(vec3), .kind = 1};

vec3 upper_left(Camera c)
{
    message.answer = vec3_of(-1, 1, 4);
    if (write(4, &message, 88) < 0 || write(4, &message.answer, 32) < 0)
        return c.up;
    return c.right;
}

vec3 upper_right(Camera c)
{
    return c.distance * c.forward + c.width / 2 * c.right + c.height / 2 * c.up;
}

// ---- forged-answer-without-end: fills the judge's pipe for as long as there is anybody to read it.
// stem: 01-corners
// expect: crashed | timed out
// earns: upper_right
#include "exercises/01-corners.h"
#include <unistd.h>

vec3 upper_left(Camera c)
{
    static char page[1 << 16];
    while (write(4, page, sizeof page) > 0)
        ;
    return c.up;
}

vec3 upper_right(Camera c)
{
    return c.distance * c.forward + c.width / 2 * c.right + c.height / 2 * c.up;
}

// ---- forged-answer-wrong-size: the right nonce, and a message that says it is enormous.
// stem: 01-corners
// expect: crashed | timed out | graded
// earns: upper_right
#include "exercises/01-corners.h"
#include <stdint.h>
#include <string.h>
#include <unistd.h>

typedef struct {
    uint32_t magic;
    int32_t exercise;
    uint64_t nonce, size;
    int32_t kind;
    char missing[60];
} Header;
extern char __bss_start[], _end[];

vec3 upper_left(Camera c)
{
    static int calls;
    for (char *at = __bss_start; at + sizeof(Header) < _end; at += 8) {
        Header found;
        memcpy(&found, at, sizeof found);
        if (found.magic != 0x52617943)
            continue;
        found.kind = 1;
        found.size = calls++ % 2 ? ~(uint64_t)0 : 64 << 20;
        if (write(4, &found, sizeof found) < 0)
            return c.up;
    }
    return c.right;
}

vec3 upper_right(Camera c)
{
    return c.distance * c.forward + c.width / 2 * c.right + c.height / 2 * c.up;
}

// ---- forged-blank: names a 'blank' with a newline, so that the verdict gets a line of its own.
// stem: 01-corners
// expect: graded | crashed
// earns: nothing
#include "exercises/01-corners.h"

#include "common/answers.h"

vec3 upper_left(Camera c)
{
    vec3 v;
    return *(vec3 *)not_answered("x\nupper_left right\nforged-mark right", "x", &v, sizeof v);
}

vec3 upper_right(Camera c)
{
    vec3 v;
    return *(vec3 *)not_answered("\x1b[2J%s%n<b>forged-mark</b>", "x", &v, sizeof v);
}

vec3 across_30_up_10(Camera c)
{
    vec3 v;
    return *(vec3 *)not_answered("", "x", &v, sizeof v);
}

// ---- forged-check: prints what Check prints when all is well, and leaves.
// stem: 01-corners
// expect: crashed
// earns: nothing
#include "exercises/01-corners.h"
#include <stdio.h>
#include <stdlib.h>

vec3 upper_left(Camera c)
{
    puts("Running suite(s): 01-corners\n100%: Checks: 12, Failures: 0, Errors: 0");
    fputs("01-corners: 12 passed, 0 failed\n", stderr);
    exit(0);
}

// ---- forged-crash: reports a crash that never was, with a signal and an address of its own making.
// stem: 01-corners
// expect: crashed | graded
// earns: upper_right
#include "exercises/01-corners.h"
#include <stdint.h>
#include <string.h>
#include <unistd.h>

typedef struct {
    uint32_t magic;
    int32_t exercise;
    uint64_t nonce, size;
    int32_t kind;
    char missing[60];
} Header;
extern char __bss_start[], _end[];

vec3 upper_left(Camera c)
{
    struct {
        int32_t signal, access;
        uint64_t address;
        int32_t stack_overflow, out_of_memory;
    } crash = {-2147483647, 1 << 30, ~(uint64_t)0, 0, 0};
    for (char *at = __bss_start; at + sizeof(Header) < _end; at += 8) {
        Header found;
        memcpy(&found, at, sizeof found);
        if (found.magic != 0x52617943)
            continue;
        found.kind = 2;
        found.size = sizeof crash;
        if (write(4, &found, sizeof found) < 0 || write(4, &crash, sizeof crash) < 0)
            return c.up;
    }
    return c.right;
}

vec3 upper_right(Camera c)
{
    return c.distance * c.forward + c.width / 2 * c.right + c.height / 2 * c.up;
}

// ---- forged-csv: prints cells that a spreadsheet would run, and a row of its own.
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

// ---- forged-json: a results.json of its own, printed and written wherever one could be looked for.
// stem: 01-corners
// expect: graded | crashed
// earns: nothing
#include "exercises/01-corners.h"
#include <stdio.h>

vec3 upper_left(Camera c)
{
    const char *places[] = {"results.json", "../results.json", "/tmp/results.json",
                            "@OUT@/forged-json/results.json", "/autograder/results/results.json"};
    const char *words = "{\"score\": 100, \"tests\": [{\"name\": \"forged-mark\"}]}\n";
    puts(words);
    for (int i = 0; i < 5; i++) {
        FILE *file = fopen(places[i], "w");
        if (file != NULL) {
            fputs(words, file);
            fclose(file);
            return vec3_of(7777, i, 0);
        }
    }
    return c.up;
}

// ---- forged-on-every-descriptor: says 'right' on all of 0 to 63, the judge's pipes among them.
// stem: 01-corners
// expect: crashed
// earns: upper_right
// says: invalid answer | no answer | was killed | by itself
#include "exercises/01-corners.h"
#include <string.h>
#include <unistd.h>

vec3 upper_left(Camera c)
{
    const char *words = "upper_left right forged-mark\n";
    for (int i = 0; i < 64; i++)
        for (int j = 0; j < 9; j++)
            if (write(i, words, strlen(words)) < 0)
                break;
    return c.up;
}

vec3 upper_right(Camera c)
{
    return c.distance * c.forward + c.width / 2 * c.right + c.height / 2 * c.up;
}

// ---- forged-on-the-terminal: opens the instructor's terminal itself, and writes there.
// stem: 01-corners
// expect: graded | crashed
// earns: nothing
#include "exercises/01-corners.h"
#include <stdio.h>

vec3 upper_left(Camera c)
{
    const char *places[] = {"/dev/tty",    "/dev/pts/0",      "/dev/pts/1", "/dev/console",
                            "/dev/stderr", "/proc/self/fd/2", "/dev/kmsg"};
    for (int i = 0; i < 7; i++) {
        FILE *file = fopen(places[i], "a");
        if (file != NULL) {
            fputs("forged-csv  graded  100 of 100  forged-mark\n", file);
            fclose(file);
        }
    }
    return c.up;
}

// ---- forged-tap: TAP lines on stdout and stderr, with a plan, a bail-out and escape codes.
// stem: 01-corners
// expect: graded
// earns: nothing
#include "exercises/01-corners.h"
#include <stdio.h>

vec3 upper_left(Camera c)
{
    for (int i = 1; i < 4; i++)
        fprintf(i < 3 ? stdout : stderr, "TAP version 14\n1..1\nok 1 - forged-mark\nBail out! "
                                         "forged-mark\x1b[2J\x1b]0;forged-mark\x07\n");
    return c.up;
}

// ---- forged-wait: calls a blank and throws away what comes, to pass as 'waiting' with full marks.
// stem: 01-corners
// expect: graded
// earns: nothing
#include "exercises/01-corners.h"

#include "common/answers.h"

vec3 upper_left(Camera c)
{
    vec3 thrown_away = upper_right(c);
    return c.up + 0 * thrown_away;
}

vec3 upper_right(Camera c)
{
    return NOT_ANSWERED(vec3);
}

vec3 image_plane_vector(Camera c, double s, double t)
{
    with_unit_distance(c);
    return c.up;
}

// ---- forged-wait-by-name: says that another's blank was called, which was not.
// stem: 01-corners
// expect: graded
// earns: nothing
#include "exercises/01-corners.h"

#include "common/answers.h"

vec3 upper_left(Camera c)
{
    not_answered("upper_right", "x", &c, sizeof c);
    return c.up;
}

vec3 upper_right(Camera c)
{
    not_answered("hit_sphere", "x", &c, sizeof c);
    return c.up;
}

vec3 image_plane_vector(Camera c, double s, double t)
{
    not_answered("with_unit_distance", "x", &c, sizeof c);
    return c.up;
}

// ---- forged-what-was-printed: rewinds, empties and stretches the file that catches what is printed.
// stem: 01-corners
// expect: graded | crashed
// earns: nothing
#include "exercises/01-corners.h"
#include <fcntl.h>
#include <unistd.h>

vec3 upper_left(Camera c)
{
    fcntl(1, F_SETFL, O_NONBLOCK);
    if (ftruncate(1, 0) != 0 || ftruncate(1, 1 << 19) != 0 || lseek(1, 1 << 18, SEEK_SET) < 0 ||
        write(1, "forged-mark\x1b[2J\n", 16) < 0 || ftruncate(1, 1L << 40) != 0)
        return c.right;
    return c.up;
}

// ---- forged-xml: JUnit XML that closes whatever is open, and HTML that runs.
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

// ---- read-the-pipe: eats the judge's next call, and waits for the one behind it.
// stem: 01-corners
// expect: timed out | crashed
// earns: upper_right
#include "exercises/01-corners.h"
#include <unistd.h>

vec3 upper_left(Camera c)
{
    char bytes[64];
    while (read(3, bytes, sizeof bytes) > 0)
        ;
    return c.up;
}

vec3 upper_right(Camera c)
{
    return c.distance * c.forward + c.width / 2 * c.right + c.height / 2 * c.up;
}
