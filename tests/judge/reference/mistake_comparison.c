// mistake_comparison.c - the result of the answer for a call, and the results of known functions
// for the same call.
#include "tests/judge/reference/mistake_comparison.h"

#include "tests/judge/message.h"
#include "tests/judge/suspects.h"
#include "tests/judge/transport.h"

static Wire question, answer;
static Resolution size; // of the image of the call

Wire *hear_question(int exercise)
{
    if (!suspects_listen(exercise))
        return NULL;
    wire_clear(&question);
    return &question;
}

Wire *hear_answer(int exercise)
{
    if (!suspects_listen(exercise))
        return NULL;
    wire_clear(&answer);
    return &answer;
}

static const Numbers *by_function(int exercise, const Mistake *mistake, int nth)
{
    static Wire wire;
    static Numbers numbers;
    (void)nth;
    question.read = 0;
    wire_clear(&wire);
    apply(exercise, mistake == NULL ? exercises[exercise].reference : mistake->answer, &question,
          &wire);
    layout_read(exercises[exercise].results, &wire, &size, &numbers);
    return &numbers;
}

// By the one that answered the first time.
static const Numbers *once_more(int exercise)
{
    static Numbers numbers;
    static Wire wire;
    AnyFunction *local = local_answer(exercise);
    if (local != NULL) {
        question.read = 0;
        wire_clear(&wire);
        apply(exercise, local, &question, &wire);
        layout_read(exercises[exercise].results, &wire, &size, &numbers);
        return &numbers;
    }
    Wire *asked = transport_begin(exercise);
    wire_put(asked, question.bytes, question.size);
    asked = transport_answer(exercise);
    layout_read(exercises[exercise].results, asked, &size, &numbers);
    transport_finish(exercise);
    return &numbers;
}

void hear(int exercise)
{
    static Numbers arguments, yours;
    question.read = 0;
    layout_read(exercises[exercise].arguments, &question, &size, &arguments);
    layout_read(exercises[exercise].results, &answer, &size, &yours);
    suspects_hear(exercise, &(Heard){&arguments, &yours, by_function, once_more});
}
