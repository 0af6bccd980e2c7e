// memorised_answers.c - an answer that is a table of the earlier questions, and nothing else.
#include "tests/proof/memorised_answers.h"

#include "tests/judge/message.h"
#include "tests/judge/transport.h"

#include <stdio.h>
#include <string.h>

typedef struct Line {
    struct Line *next;
    int exercise;
    Wire question, answer;
} Line;

static Line *lines;
static bool learning;
static uint8_t garbage;
static Wire wire;

static Wire *begin(int exercise);
static void look_up_or_learn(int exercise);
static Wire *receive(int exercise);
static void finish(int exercise);

void table_learn(void)
{
    static const Transport table = {begin, look_up_or_learn, receive, finish};
    transport_use(&table);
    while (lines != NULL) {
        Line *line = lines;
        lines = line->next;
        wire_free(&line->question);
        wire_free(&line->answer);
        free(line);
    }
    learning = true;
}

void table_recite(uint8_t for_others)
{
    learning = false;
    garbage = for_others;
}

static const Line *look_up(int exercise, const Wire *question)
{
    for (const Line *line = lines; line != NULL; line = line->next)
        if (line->exercise == exercise && line->question.size == question->size &&
            memcmp(line->question.bytes, question->bytes, question->size) == 0)
            return line;
    return NULL;
}

static void learn(int exercise, const Wire *question, const Wire *answer)
{
    Line *line = calloc(1, sizeof *line);
    if (line == NULL)
        abort();
    line->exercise = exercise;
    wire_put(&line->question, question->bytes, question->size);
    wire_put(&line->answer, answer->bytes, answer->size);
    line->next = lines;
    lines = line;
}

static Wire *begin(int exercise)
{
    (void)exercise;
    wire_clear(&wire);
    return &wire;
}

static void look_up_or_learn(int exercise)
{
    Wire answer = {0};
    if (!apply(exercise, exercises[exercise].reference, &wire, &answer)) {
        fprintf(stderr, "a question that cannot be read\n");
        abort();
    }
    const Line *line = look_up(exercise, &wire);
    if (learning && line == NULL)
        learn(exercise, &wire, &answer);
    else if (line != NULL)
        memcpy(answer.bytes, line->answer.bytes, answer.size);
    else
        memset(answer.bytes, garbage, answer.size);
    wire_clear(&wire);
    wire_put(&wire, answer.bytes, answer.size);
    wire_free(&answer);
}

static Wire *receive(int exercise)
{
    (void)exercise;
    return &wire;
}

static void finish(int exercise)
{
    if (!wire_is_read(&wire)) {
        fprintf(stderr, "exercise %d: an answer that cannot be read\n", exercise);
        abort();
    }
}
