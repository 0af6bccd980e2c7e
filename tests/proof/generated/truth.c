// truth.c - whether an answer is right, independent of the tests.
#include "tests/proof/generated/generated.h"

#include "tests/judge/message.h"
#include "tests/judge/runner.h"

#include <setjmp.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/time.h>

enum { MOST_QUESTIONS = 4000, DIGITS = 100000 };
enum { MOST_MILLISECONDS = 200 }; // of work, for one call

static const Subject *subject;
static AnyFunction *reference;
static Question *questions; // with the arrays of their scenes
static Answer *right;

// ---- calling what may crash or never come to an end --------------------------------------------

// In the judge the answer is another process. Here it is a function of this one, so that thousands
// can be tried: a crash or a timeout ends only the call, and the test gets the same message.
static sigjmp_buf out;
static Numbers to_answer, from_answer;
static AnyFunction *answering;
static const char *broken; // how the answer ended; it is not called any more

static const int signals[] = {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGTRAP, SIGABRT, SIGVTALRM};

static void leave(int signal)
{
    siglongjmp(out, signal);
}

void guard_begin(void)
{
    static char stack[1 << 16]; // the usual stack may have overflowed
    sigaltstack(&(stack_t){.ss_sp = stack, .ss_size = sizeof stack}, NULL);
    struct sigaction action = {.sa_handler = leave, .sa_flags = SA_ONSTACK | SA_NODEFER};
    for (size_t i = 0; i < sizeof signals / sizeof signals[0]; i++)
        sigaction(signals[i], &action, NULL);
}

static void patience(int milliseconds)
{
    struct itimerval time = {.it_value = {.tv_usec = 1000 * milliseconds}};
    setitimer(ITIMER_VIRTUAL, &time, NULL);
}

static Numbers *begin(int exercise)
{
    (void)exercise;
    if (broken != NULL)
        record_how(HOW_CRASHED, broken);
    numbers_clear(&to_answer);
    return &to_answer;
}

static void call(int exercise)
{
    int signal = sigsetjmp(out, 1);
    if (signal == 0) {
        patience(MOST_MILLISECONDS);
        answer_here(exercise, answering, &to_answer, &from_answer);
        patience(0);
        if (from_answer.overran)
            record_overran();
        return;
    }
    patience(0);
    broken = signal == SIGVTALRM ? "was still running: an endless loop?" : "crashed";
    record_how(signal == SIGVTALRM ? HOW_TIMED_OUT : HOW_CRASHED, broken);
}

static Numbers *receive(int exercise)
{
    (void)exercise;
    return &from_answer;
}

void guard_answer_by(AnyFunction *by)
{
    static const Transport guarded = {begin, call, receive, NULL};
    transport_use(&guarded);
    answering = by;
    broken = NULL;
}

static void guarded_ask(AnyFunction *by, Question *question, Answer *said)
{
    said->count = 0;
    if (sigsetjmp(out, 1) == 0) {
        patience(MOST_MILLISECONDS);
        subject->ask(by, question, said);
    } else {
        said->count = 0;
    }
    patience(0);
}

// ---- right or wrong -----------------------------------------------------------------------------

static const Subject *subject_of(const char *exercise)
{
    for (int i = 0; subjects[i].exercise != NULL; i++)
        if (strcmp(subjects[i].exercise, exercise) == 0)
            return &subjects[i];
    return NULL;
}

// The pointers of a scene lead into its question, wherever that is now.
static void ask(AnyFunction *answer, const Question *question, Answer *said)
{
    static Question asked;
    asked = *question;
    point_into(&asked);
    guarded_ask(answer, &asked, said);
}

bool truth_begin(const char *exercise, AnyFunction *answer, uint64_t seed)
{
    subject = subject_of(exercise);
    if (subject == NULL || subject->questions > MOST_QUESTIONS)
        return false;
    reference = answer;
    draw_begin(seed);
    if (questions == NULL) {
        questions = calloc(MOST_QUESTIONS, sizeof *questions);
        right = calloc(MOST_QUESTIONS, sizeof *right);
    }
    if (questions == NULL || right == NULL)
        abort();
    for (int i = 0; i < subject->questions; i++) {
        questions[i] = (Question){0};
        subject->draw(&questions[i]);
        ask(reference, &questions[i], &right[i]);
    }
    return true;
}

// Within a multiple of the tolerance.
static bool agree_to(double times, const Answer *a, const Answer *b)
{
    if (a->count != b->count)
        return false;
    for (int i = 0; i < a->count; i++) {
        double x = a->number[i], y = b->number[i];
        bool same = isnan(x) || isnan(y) ? isnan(x) && isnan(y)
                                         : x == y || fabs(x - y) <= times * b->tolerance[i];
        if (!same)
            return false;
    }
    return true;
}

static bool agree(const Answer *a, const Answer *b)
{
    return agree_to(1, a, b);
}

// Whether the result of this function changes if only the last digits of the question change.
static bool is_shaky(AnyFunction *answer, const Question *question, const Answer *said)
{
    static Answer other;
    for (int i = 0; i < 6; i++) {
        Question near = *question;
        nudge(&near);
        ask(answer, &near, &other);
        if (!agree(&other, said))
            return true;
    }
    return false;
}

static bool is_on_edge(AnyFunction *answer, const Question *question, const Answer *said)
{
    return !question->exact && is_shaky(answer, question, said);
}

static bool is_right(int i, const Answer *said)
{
    return agree(said, &right[i]) || (said->count > 0 && subject->is_right != NULL &&
                                      subject->is_right(&questions[i], said, &right[i]));
}

Truth truth_of(AnyFunction *answer, int *question)
{
    static Answer said;
    Truth truth = RIGHT;
    for (int i = 0; i < subject->questions; i++) {
        ask(answer, &questions[i], &said);
        if (is_right(i, &said)) {
            // Right, but by fewer digits than are left of any usual way to compute it.
            if (truth == RIGHT && agree(&said, &right[i]) && !agree_to(0.001, &said, &right[i]))
                truth = AT_THE_EDGE;
            continue;
        }
        if (!questions[i].edge && !is_on_edge(reference, &questions[i], &right[i])) {
            *question = i;
            return WRONG;
        }
        if (questions[i].edge)
            truth = AT_THE_EDGE;
    }
    return truth;
}

void truth_words(char *words, size_t size, AnyFunction *answer, int question)
{
    static Answer said;
    ask(answer, &questions[question], &said);
    int used = snprintf(words, size, "question %d:", question);
    for (int i = 0; i < said.count && i < right[question].count; i++)
        if (said.number[i] != right[question].number[i] && used > 0 && (size_t)used < size)
            used += snprintf(words + used, size - (size_t)used, " %g for %g", said.number[i],
                             right[question].number[i]);
}

static bool is_camera_form(void)
{
    return strncmp(subject->exercise, "camera_from_", 12) == 0;
}

// The pixels of pictures are counted.
static void count_numbers(Likeness *it, const Answer *yours, const Answer *theirs, const Answer *so)
{
    for (int i = 0; i < yours->count && yours->count == theirs->count && yours->count == so->count;
         i++) {
        bool wrong = fabs(yours->number[i] - so->number[i]) > so->tolerance[i];
        it->wrong_numbers += wrong;
        it->alike_numbers +=
            wrong && fabs(yours->number[i] - theirs->number[i]) <= so->tolerance[i];
    }
}

// If there are several reasons, any of them may be checked first.
static bool both_refuse(const Answer *yours, const Answer *theirs)
{
    return is_camera_form() && yours->number[0] != CAMERA_OK && theirs->number[0] != CAMERA_OK;
}

// A result that changes with the last digits of the question, for example a variable that was never
// set, is evidence neither for a mistake nor against it; nor is a result that the contract leaves
// free.
Likeness likeness(AnyFunction *answer, AnyFunction *mistake)
{
    static Answer yours, theirs;
    Likeness it = {.questions = subject->questions};
    for (int i = 0; i < subject->questions; i++) {
        ask(answer, &questions[i], &yours);
        ask(mistake, &questions[i], &theirs);
        bool alike = agree(&yours, &theirs), wrong = !is_right(i, &yours);
        bool free = is_right(i, &theirs) && (!wrong || both_refuse(&yours, &theirs));
        bool apart = !alike && !free && !is_shaky(mistake, &questions[i], &theirs) &&
                     !is_shaky(answer, &questions[i], &yours);
        it.wrong += wrong && (alike || apart);
        it.alike += wrong && alike;
        it.apart += apart;
        it.question_apart = apart ? i : it.question_apart;
        bool clearly = !agree_to(DIGITS, &yours, &right[i]);
        it.clearly_wrong += wrong && clearly;
        it.clearly_alike += wrong && clearly && agree_to(DIGITS, &yours, &theirs);
        count_numbers(&it, &yours, &theirs, &right[i]);
    }
    return it;
}

// The two mistakes refuse for different reasons: an answer with both of them refuses for neither.
static bool one_refuses_for_the_other(const Answer *one, const Answer *two)
{
    return is_camera_form() && one->number[0] != two->number[0] && one->number[0] != CAMERA_OK &&
           two->number[0] != CAMERA_OK;
}

Likeness likeness_to_both(AnyFunction *answer, AnyFunction *mistake, AnyFunction *other)
{
    static Answer yours, one, two;
    Likeness it = {.questions = subject->questions};
    for (int i = 0; i < subject->questions; i++) {
        ask(answer, &questions[i], &yours);
        ask(mistake, &questions[i], &one);
        ask(other, &questions[i], &two);
        bool wrong = !is_right(i, &yours);
        bool first = !is_right(i, &one), second = !is_right(i, &two);
        bool so = first && second ? wrong
                  : first         ? agree(&yours, &one)
                  : second        ? agree(&yours, &two)
                                  : !wrong || one_refuses_for_the_other(&one, &two);
        bool apart = !so && !is_on_edge(answer, &questions[i], &yours) &&
                     !is_on_edge(mistake, &questions[i], &one) &&
                     !is_on_edge(other, &questions[i], &two);
        it.wrong += wrong && (so || apart);
        it.alike += wrong && so;
        it.apart += apart;
    }
    return it;
}
