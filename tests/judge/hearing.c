// hearing.c - what the answer made of a call, beside what known functions make of the same.
#include "tests/judge/hearing.h"

#include "tests/judge/apply.h"
#include "tests/judge/call.h"
#include "tests/judge/suspects.h"

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
    layout_read(layouts[exercise].results, &wire, &size, &numbers);
    return &numbers;
}

// By whoever answered the first time.
static const Numbers *once_more(int exercise)
{
    static Numbers numbers;
    static Wire wire;
    AnyFunction *local = local_answer(exercise);
    if (local != NULL) {
        question.read = 0;
        wire_clear(&wire);
        apply(exercise, local, &question, &wire);
        layout_read(layouts[exercise].results, &wire, &size, &numbers);
        return &numbers;
    }
    Wire *asked = call_begin(exercise);
    wire_put(asked, question.bytes, question.size);
    asked = call_finish(exercise);
    layout_read(layouts[exercise].results, asked, &size, &numbers);
    call_end(exercise);
    return &numbers;
}

void hear(int exercise)
{
    static Numbers arguments, yours;
    question.read = 0;
    layout_read(layouts[exercise].arguments, &question, &size, &arguments);
    layout_read(layouts[exercise].results, &answer, &size, &yours);
    suspects_hear(exercise, &(Heard){&arguments, &yours, by_function, once_more});
}
