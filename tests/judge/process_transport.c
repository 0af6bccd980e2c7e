// process_transport.c - one call to the answering process, whatever becomes of it.
#include "tests/judge/process.h"

#include "tests/judge/exercise.h"
#include "tests/judge/message.h"
#include "tests/judge/runner.h"

#include <errno.h>
#include <math.h>
#include <signal.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/random.h>
#include <sys/wait.h>

// ---- why a call brought no answer, in words ----------------------------------------------------

static void describe_signal(char *why, size_t size, int number)
{
    if (number == SIGXFSZ) {
        snprintf(why, size, "printed more than a million characters");
        return;
    }
    const char *words = number == SIGFPE    ? "it divided an integer by zero"
                        : number == SIGABRT ? "it was aborted (did an assertion fail?)"
                        : number == SIGILL  ? "it went beyond the end of an array"
                        : number == SIGKILL ? "it was killed"
                        : number == SIGSYS  ? "it made a system call that no answer needs"
                                            : strsignal(number);
    snprintf(why, size, "crashed: %s", words);
}

static void describe_failed_check(char *why, size_t size, const FailedCheck *failed)
{
    char text[200];
    failed_check_text(failed, !record_now()->hidden, text, sizeof text);
    snprintf(why, size, "stopped in line %d: %s", failed->line, text);
}

// An address or an exit status could be a number of a hidden test.
// From what the process said before it ended: hostile words, of which only numbers are looked at.
static void describe_crash(char *why, size_t size, const Crash *crash)
{
    static const char *const access[] = {"read of", "write to"};
    if (crash->stack_overflow)
        snprintf(why, size, "crashed: stack overflow (does it call itself without end?)");
    else if (crash->signal == SIGSYS)
        snprintf(why, size, "wanted %s, which no answer needs",
                 system_call_purpose(crash->system_call));
    else if (crash->failed_check.kind > NO_CHECK && crash->failed_check.kind < CHECK_KINDS)
        describe_failed_check(why, size, &crash->failed_check);
    else if (crash->out_of_memory)
        snprintf(why, size, "ran out of memory");
    else if (crash->signal == SIGSEGV && crash->no_address)
        snprintf(why, size, "crashed: used a pointer that was never set, or was overwritten");
    else if (crash->signal == SIGSEGV || crash->signal == SIGBUS) {
        const char *how = crash->access < 0 ? "access to" : access[crash->access != 0];
        if (record_now()->hidden && crash->address != 0)
            snprintf(why, size, "crashed: %s an invalid address", how);
        else
            snprintf(why, size, "crashed: %s address %s%llx", how, crash->address == 0 ? "" : "0x",
                     (unsigned long long)crash->address);
    } else
        describe_signal(why, size, crash->signal);
}

// From its wait status; -1: it closed its pipe.
static void describe_end(char *why, size_t size, int status)
{
    if (status < 0)
        snprintf(why, size, "closed its pipe and gave no answer");
    else if (WIFSIGNALED(status))
        describe_signal(why, size, WTERMSIG(status));
    else if (WEXITSTATUS(status) == 127)
        snprintf(why, size, "could not be started");
    else if (record_now()->hidden)
        snprintf(why, size, "ended the program by itself");
    else
        snprintf(why, size, "ended the program by itself (exit status %d)", WEXITSTATUS(status));
}

// ---- one call ----------------------------------------------------------------------------------

enum {
    MOST_CALLS = 5,  // times the work of one call, for all calls of an exercise together
    LENT_ROOM = 512, // numbers by which a question may be larger than the call
};

static Numbers message;
static uint64_t nonce; // of the call, so that an answer cannot be sent before it
static struct {
    How how;
    char why[240]; // an exercise is not called any more
} broken[EXERCISE_COUNT];
static double work_of[EXERCISE_COUNT]; // seconds, so far
static int called;                     // the exercise that is being answered
static int size_of_call;
static bool is_lent[EXERCISE_COUNT], was_lent[EXERCISE_COUNT];
static bool has_entered[EXERCISE_COUNT][EXERCISE_COUNT];

static Transport ask;
static void refuse(int exercise);

void call_answers_from(const char *answering, int printed)
{
    transport_use(ask, refuse);
    process_begin(answering, printed);
}

void call_stop(void)
{
    process_stop(false);
}

void call_lend(int exercise)
{
    is_lent[exercise] = true;
}

bool call_has_lent(int exercise)
{
    return was_lent[exercise];
}

bool call_has_entered(int exercise, int other)
{
    return has_entered[exercise][other];
}

static void copy(Numbers *into, const Numbers *from)
{
    numbers_clear(into);
    numbers_add_all(into, from);
}

// The calls that were answered by passing the question on, and the calls to which something was
// lent but that were answered in another way.
static struct {
    Numbers question, answers[16]; // of this call, and what was lent to the same question
    int count;
    bool has_lent;
    int passed, others;
} pass_on;

bool call_only_passes_on(void)
{
    return pass_on.passed > 0 && pass_on.others == 0;
}

static bool begins_with(const Numbers *whole, const Numbers *part)
{
    size_t bytes = (size_t)part->count * sizeof *part->at;
    return part->count <= whole->count && memcmp(whole->at, part->at, bytes) == 0;
}

// A question whose numbers were moved a little is the same one.
static bool begins_like(const Numbers *whole, const Numbers *part)
{
    if (part->count > whole->count)
        return false;
    for (int i = 0; i < part->count; i++)
        if (!same_within(whole->at[i], part->at[i], 1e-6))
            return false;
    return true;
}

static void pass_on_call(const Numbers *question)
{
    pass_on.count = 0;
    pass_on.has_lent = false;
    copy(&pass_on.question, question);
}

static void pass_on_begin(const Numbers *question, const Numbers *answer)
{
    const int most = sizeof pass_on.answers / sizeof pass_on.answers[0];
    pass_on.has_lent = true;
    if (pass_on.count < most && begins_like(&pass_on.question, question))
        copy(&pass_on.answers[pass_on.count++], answer);
}

static void pass_on_end(const Numbers *answer)
{
    bool passed = false;
    for (int i = 0; i < pass_on.count; i++)
        passed = passed || begins_with(answer, &pass_on.answers[i]);
    pass_on.passed += pass_on.has_lent && passed;
    pass_on.others += pass_on.has_lent && !passed;
}

static void break_off(int exercise)
{
    record_how(broken[exercise].how, broken[exercise].why);
}

// The name of the called blank comes from a process that may lie.
static bool is_name_or_empty(const char *missing, size_t size)
{
    return memchr(missing, '\0', size) != NULL &&
           (missing[0] == '\0' || exercise_number(missing) >= 0);
}

// So does the reason of its crash.
static bool is_crash(const MessageHeader *answer)
{
    Crash crash;
    if (answer->kind != MESSAGE_CRASH || answer->size != sizeof crash)
        return false;
    memcpy(&crash, message.at, sizeof crash);
    return crash.signal > 0 && crash.signal < NSIG;
}

static int send(int kind, int exercise, const Numbers *numbers, Patience *left)
{
    MessageHeader header = {MESSAGE_MAGIC, exercise, nonce, 0, kind, 0, 0, ""};
    size_t size;
    if (kind == MESSAGE_CALL)
        header.paint = paint_of_call(exercise);
    const void *block = message_block(header, numbers, &size);
    return process_send(block, size, left);
}

// 2 if it arrived and is valid
static int receive(MessageHeader *header, Numbers *numbers, Patience *left)
{
    int moved = process_receive(header, sizeof *header, left);
    if (moved != 1 || header->nonce != nonce || header->exercise < 0 ||
        header->exercise >= EXERCISE_COUNT ||
        !is_name_or_empty(header->missing, sizeof header->missing) ||
        !message_make_room(header, numbers))
        return moved;
    moved = process_receive(numbers->at, (size_t)header->size, left);
    return moved == 1 ? 2 : moved;
}

// The process calls another exercise of its chapter: if that is lent, the reference answers.
static bool lend(int exercise, Numbers *question)
{
    static Numbers answer;
    numbers_clear(&answer);
    question->is_hostile = true;
    // The judge does no more work than it has asked for itself.
    AnyFunction *reference = exercises[exercise].reference;
    if (!is_lent[exercise] || reference == NULL || question->count > size_of_call + LENT_ROOM ||
        !apply(exercise, reference, question, &answer))
        return false;
    was_lent[exercise] = true;
    pass_on_begin(question, &answer);
    Patience left = patience_begin();
    return send(MESSAGE_LENT, exercise, &answer, &left) == 1;
}

// The process reports that it has entered another exercise. It may lie: then the call is repeated
// without that exercise, and fails anyway.
static bool is_entered(int exercise, const MessageHeader *header)
{
    if (header->kind != MESSAGE_ENTERED || header->size != 0)
        return false;
    has_entered[exercise][header->exercise] = true;
    return true;
}

bool call_serve(void)
{
    MessageHeader asked = {0};
    Patience left = patience_begin();
    int moved = receive(&asked, &message, &left);
    while (moved == 2 && is_entered(called, &asked))
        moved = receive(&asked, &message, &left);
    return moved == 2 && asked.kind == MESSAGE_ASK && lend(asked.exercise, &message);
}

// After a call without an answer: nothing that holds for answers can be checked.
static _Noreturn void give_up_on_machine(const char *what, int error)
{
    process_stop(false);
    fprintf(stderr, "%s%s%s\n", what, error != 0 ? ": " : "", error != 0 ? strerror(error) : "");
    exit(3);
}

// Under confine an answer can send no signal, and the grader does not link one that the kernel
// would kill for its size. So only these are its own: of its instructions, and of confine's limits.
static bool is_from_outside(int number)
{
    static const int own[] = {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGTRAP, SIGSYS, SIGXFSZ};
    for (size_t i = 0; i < sizeof own / sizeof own[0]; i++)
        if (number == own[i])
            return false;
    return true;
}

// A process that ended, and one that was never started or that somebody else ended.
static void check_machine(int status)
{
    int error = process_start_error();
    // Any other error is about the program: its interpreter does not exist, for example.
    bool is_the_machines = error == EAGAIN || error == EPERM || error == ENOMEM ||
                           error == EMFILE || error == ENFILE || error == EIO || error == ENOSPC ||
                           error == ETXTBSY;
    if (is_the_machines)
        give_up_on_machine("an answering process cannot be started", error);
    if (process_is_confined() && status >= 0 && WIFSIGNALED(status) &&
        is_from_outside(WTERMSIG(status))) {
        char words[60];
        snprintf(words, sizeof words, "signal %d ended an answering process", WTERMSIG(status));
        give_up_on_machine(words, 0);
    }
}

static uint64_t next_nonce(void)
{
    static uint64_t fresh[32]; // the system is not asked for each call
    static size_t left;
    if (left == 0 && getrandom(fresh, sizeof fresh, 0) == sizeof fresh)
        left = sizeof fresh / sizeof fresh[0];
    return left > 0 ? fresh[--left] : nonce + 1;
}

// moved: the result of process_send. If no answer comes: why, and the process has ended.
static bool wait_for_answer(int exercise, Patience left, int moved)
{
    How *how = &broken[exercise].how;
    char *why = broken[exercise].why;
    const size_t size = sizeof broken[exercise].why;
    MessageHeader answer = {0};
    *how = HOW_CRASHED;
    // A process that has ended may have reported why.
    if (moved != 0)
        moved = receive(&answer, &message, &left);
    while (moved == 2 && (is_entered(exercise, &answer) ||
                          (answer.kind == MESSAGE_ASK && lend(answer.exercise, &message))))
        moved = patience_is_over(&left) ? 0 : receive(&answer, &message, &left);
    message.is_hostile = false;
    bool sane = moved == 2 && answer.exercise == exercise;
    if (moved == 0) {
        *how = HOW_TIMED_OUT;
        if (left.end == MACHINE_TOO_BUSY)
            give_up_on_machine("an answer did not get a processor", 0);
        snprintf(why, size,
                 left.end == TOO_MUCH_WORK ? "was still running after %g s (an endless loop?)"
                                           : "waited for something that never comes",
                 process_most_work());
    } else if (moved < 0) {
        int status = process_stop(true);
        check_machine(status);
        describe_end(why, size, status);
    } else if (sane && is_crash(&answer)) {
        Crash crash;
        memcpy(&crash, message.at, sizeof crash);
        describe_crash(why, size, &crash);
    } else if (!sane || answer.kind != MESSAGE_ANSWER) {
        snprintf(why, size, "sent an invalid answer");
    } else {
        if (answer.missing[0] != '\0')
            record_missing(answer.missing);
        if (answer.overran != 0)
            record_overran();
        pass_on_end(&message);
        work_of[exercise] += process_work() - left.work_before;
        if (work_of[exercise] <= MOST_CALLS * process_most_work())
            return true;
        *how = HOW_TIMED_OUT;
        snprintf(why, size, "takes far too long: %g s for all its calls",
                 MOST_CALLS * process_most_work());
    }
    process_stop(false);
    return false;
}

static Numbers *ask(int exercise, Numbers *question)
{
    if (broken[exercise].why[0] != '\0')
        break_off(exercise);
    if (!process_start())
        give_up_on_machine("an answering process cannot be started", errno);
    called = exercise;
    nonce = next_nonce();
    size_of_call = question->count;
    pass_on_call(question);
    Patience left = patience_begin();
    int moved = send(MESSAGE_CALL, exercise, question, &left);
    if (!wait_for_answer(exercise, left, moved))
        break_off(exercise);
    return &message;
}

static void refuse(int exercise)
{
    broken[exercise].how = HOW_CRASHED;
    snprintf(broken[exercise].why, sizeof broken[exercise].why, "sent an invalid answer");
    process_stop(false);
    break_off(exercise);
}
