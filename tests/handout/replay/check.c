// check.c - is a table strict, and does its judge recognise mistakes?
//
//   check STEM
//
// The right values must pass without naming a mistake; the values of each known mistake must fail,
// and name it. The other end of the pipe gives what the table has.

#include "tests/judge/message.h"
#include "tests/judge/questions.h"
#include "tests/judge/runner.h"
#include "tests/judge/stem.h"
#include "tests/judge/suspects.h"

#include <string.h>

static Outcomes outcomes;
static int gives = -1;  // which mistake of the function; -1: what is right
static bool gives_last; // of several reasons to refuse a camera the last, not the first
static int passed, failed;
static Wire answer;

static Wire *begin(int exercise)
{
    static Wire wire;
    (void)exercise;
    wire_clear(&wire);
    return &wire;
}

static Numbers result_of(int exercise, const Question *question)
{
    Numbers result =
        numbers_copy(question_result(question, gives < 0 ? 0 : question->of_mistake[gives]));
    if (!has_reasons(exercise) || result.at[0] == CAMERA_OK)
        return result;
    int reasons = gives < 0 ? question->reasons : reasons_in(&result), first = reasons & -reasons;
    while (gives_last && reasons != first) {
        reasons -= first;
        first = reasons & -reasons;
    }
    set_reasons(&result, first);
    return result;
}

static void look_up(int exercise)
{
    static Wire in;
    static Numbers ignored;
    Resolution size;
    const Question *question = question_now();
    wire_clear(&in);
    layout_write(exercises[exercise].arguments, &question->arguments, &size, &in);
    layout_read(exercises[exercise].arguments, &in, &size, &ignored);
    wire_clear(&answer);
    Numbers result = result_of(exercise, question);
    layout_write(exercises[exercise].results, &result, &size, &answer);
    numbers_free(&result);
}

static Wire *receive(int exercise)
{
    (void)exercise;
    return &answer;
}

static const Transport recorded = {begin, look_up, receive, NULL};

static int run(const char *function, bool extra)
{
    int count = 0;
    suspects_begin();
    run_tests(function, NULL, ANSWERS_APART, &outcomes);
    for (int i = 0; i < outcomes.count; i++)
        count += !outcomes.tests[i].passed && (extra || !outcomes.tests[i].extra);
    records_end();
    for (int i = 0; exercises[i].name != NULL; i++) {
        static Outcomes probes;
        if (function != NULL && strcmp(exercises[i].name, function) != 0)
            continue;
        run_probes(exercises[i].name, NULL, &probes);
        records_end();
    }
    return count;
}

static void settle(bool good, const char *what, const char *function, const char *why)
{
    if (!good)
        printf("not ok: %s %s: %s\n", what, function, why);
    *(good ? &passed : &failed) += 1;
}

static void check_mistake(const TableMistake *mistake)
{
    int exercise = exercise_number(mistake->function);
    int count = run(mistake->function, mistake->digits);
    const Mistake *named = suspect(exercise, 0, mistake->digits);
    settle(count > 0, "mistake fails no test:", mistake->function, mistake->why);
    settle(named != NULL && strcmp(named->why, mistake->why) == 0,
           "mistake is not named:", mistake->function, mistake->why);
}

static void check_all(const Table *table)
{
    gives = -1;
    settle(run(NULL, true) == 0 && outcomes.count > 0, "what is right", "", "does not pass");
    for (int i = 0; i < table->mistake_count; i++)
        settle(suspect(exercise_number(table->mistakes[i].function), 0, true) == NULL,
               "what is right is accused:", table->mistakes[i].function, table->mistakes[i].why);
    for (int i = 0; i < table->mistake_count; i++) {
        // Mistakes of a function are counted in the order of the list, wherever they are in it.
        gives = 0;
        for (int k = 0; k < i; k++)
            gives += strcmp(table->mistakes[k].function, table->mistakes[i].function) == 0;
        check_mistake(&table->mistakes[i]);
    }
}

int main(int argc, char **argv)
{
    const char *stem = argc > 1 ? argv[1] : NULL;
    choose_stem(stem);
    const Table *table = table_now();
    transport_use(&recorded);
    for (int last = 0; last < 2; last++) {
        gives_last = last == 1;
        check_all(table);
    }
    printf("table of %s (%d mistakes, %d tests): %d passed, %d failed\n", stem,
           table->mistake_count, table->test_count, passed, failed);
    return failed == 0 ? 0 : 1;
}
