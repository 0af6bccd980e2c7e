// forged_output.c - output, reports and messages to the judge that imitate the grader's own.

// ---- forged-answer-by-halves: half a header, then nothing more, so that the judge waits for ever.
// -> timed out | crashed; earns upper_right; says still running | invalid answer | never comes
vec3 upper_left(Camera c)
{
    if (write(4, "CyaR\0\0\0", 8) == 8)
        for (;;)
            pause();
    return c.up;
}

// ---- forged-answer-byte-by-byte: feeds the judge a byte now and then, each just before it gives
// up.
// -> timed out | crashed
vec3 upper_left(Camera c)
{
    for (int i = 0; i < 60; i++) {
        if (write(4, "C", 1) != 1)
            break;
        usleep(900000);
    }
    return c.up;
}

// ---- forged-answer-early: finds the call and its nonce in memory, and answers before it is asked
// to.
// -> crashed | graded
vec3 upper_left(Camera c)
{
    vec3 answer = vec3_of(-1, 1, 4);
    WireHeader found;
    for (char *at = __bss_start; find_call(&at, &found); at += 8) {
        for (int i = 0; i < 9; i++, found.nonce++) {
            found.kind = WIRE_ANSWER;
            found.size = sizeof answer;
            if (write(4, &found, sizeof found) < 0 || write(4, &answer, sizeof answer) < 0)
                return c.up;
        }
    }
    return answer;
}

// ---- forged-answer-guessed: an answer for the judge's pipe with a nonce that is a guess.
// -> crashed; earns upper_right; says invalid answer | no answer | was killed | by itself
vec3 upper_left(Camera c)
{
    WireHeader header = {.magic = WIRE_MAGIC, .nonce = 1, .size = sizeof c.up, .kind = WIRE_ANSWER};
    vec3 answer = vec3_of(-1, 1, 4);
    if (write(4, &header, sizeof header) < 0 || write(4, &answer, sizeof answer) < 0)
        return c.up;
    return c.right;
}

// ---- forged-answer-without-end: fills the judge's pipe for as long as there is anybody to read
// it.
// -> crashed | timed out; earns upper_right
vec3 upper_left(Camera c)
{
    static char page[1 << 16];
    while (write(4, page, sizeof page) > 0)
        ;
    return c.up;
}

// ---- forged-answer-wrong-size: the right nonce, and a message that says it is enormous.
// -> crashed | timed out | graded; earns upper_right
vec3 upper_left(Camera c)
{
    static int calls;
    WireHeader found;
    for (char *at = __bss_start; find_call(&at, &found); at += 8) {
        found.kind = WIRE_ANSWER;
        found.size = calls++ % 2 ? ~(uint64_t)0 : 64 << 20;
        if (write(4, &found, sizeof found) < 0)
            return c.up;
    }
    return c.right;
}

// ---- forged-blank: names a 'blank' with a newline, so that the verdict gets a line of its own.
// -> graded | crashed
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

// ---- forged-crash: reports a crash that never was, with a signal and an address of its own
// making.
// -> crashed | graded; earns upper_right
vec3 upper_left(Camera c)
{
    WireCrash crash = {.signal = -2147483647, .access = 1 << 30, .address = ~(uint64_t)0};
    WireHeader found;
    for (char *at = __bss_start; find_call(&at, &found); at += 8) {
        found.kind = WIRE_CRASH;
        found.size = sizeof crash;
        if (write(4, &found, sizeof found) < 0 || write(4, &crash, sizeof crash) < 0)
            return c.up;
    }
    return c.right;
}

// ---- forged-on-every-descriptor: says 'right' on all of 0 to 63, the judge's pipes among them.
// -> crashed; earns upper_right; says invalid answer | no answer | was killed | by itself
vec3 upper_left(Camera c)
{
    const char *words = "upper_left right forged-mark\n";
    for (int i = 0; i < 64; i++)
        for (int j = 0; j < 9; j++)
            if (write(i, words, strlen(words)) < 0)
                break;
    return c.up;
}

// ---- forged-on-the-terminal: opens the instructor's terminal itself, and writes there.
// -> graded | crashed
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

// ---- forged-reports: prints text that imitates a row, a result or the markup of each report.
// -> graded
vec3 upper_left(Camera c)
{
    puts("=HYPERLINK(\"http://forged-mark\")\n@SUM(1)\n+1\n-1\nforged-reports,graded,100,100");
    fputs("\r\x1b[1A\x1b[2Kforged-reports  graded  100 of 100\n", stderr);
    return c.up;
}

vec3 upper_right(Camera c)
{
    for (int i = 1; i < 4; i++)
        fprintf(i < 3 ? stdout : stderr, "TAP version 14\n1..1\nok 1 - forged-mark\nBail out! "
                                         "forged-mark\x1b[2J\x1b]0;forged-mark\x07\n");
    return c.up;
}

vec3 across_30_up_10(Camera c)
{
    puts("]]></failure></testcase><testcase name=\"forged-mark\"/></testsuite></testsuites>"
         "<script>alert('forged-mark')</script><!--");
    return c.up;
}

vec3 image_plane_vector(Camera c, double s, double t)
{
    puts("{\"score\": 100, \"tests\": [{\"name\": \"forged-mark\"}]}");
    return c.up;
}

// ---- forged-wait: calls a blank and throws away what comes, to pass as 'waiting' with full marks.
// -> graded
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
// -> graded
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

// ---- forged-what-was-printed: rewinds, empties and stretches the file that catches what is
// printed.
// -> graded | crashed
vec3 upper_left(Camera c)
{
    fcntl(1, F_SETFL, O_NONBLOCK);
    if (ftruncate(1, 0) != 0 || ftruncate(1, 1 << 19) != 0 || lseek(1, 1 << 18, SEEK_SET) < 0 ||
        write(1, "forged-mark\x1b[2J\n", 16) < 0 || ftruncate(1, 1L << 40) != 0)
        return c.right;
    return c.up;
}

// ---- read-the-pipe: eats the judge's next call, and waits for the one behind it.
// -> timed out | crashed; earns upper_right
vec3 upper_left(Camera c)
{
    char bytes[64];
    while (read(3, bytes, sizeof bytes) > 0)
        ;
    return c.up;
}
