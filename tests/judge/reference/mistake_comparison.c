// mistake_comparison.c - the result of the answer for a call, and the results of known functions
// for the same call.
#include "tests/judge/reference/mistake_comparison.h"

#include "tests/judge/figure.h"
#include "tests/judge/message.h"
#include "tests/judge/suspects.h"
#include "tests/judge/switchboard.h"

#include <string.h>

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

bool known_result(int exercise, AnyFunction *function, Wire *arguments, Resolution *size_of_image,
                  Numbers *result)
{
    static Wire wire;
    static Numbers other;
    int style = answer_style, reasons = 0;
    bool good = true;
    answer_style = 0;
    do {
        arguments->read = 0;
        wire_clear(&wire);
        good = good && apply(exercise, function, arguments, &wire) &&
               layout_read(exercises[exercise].results, &wire, size_of_image,
                           answer_style == 0 ? result : &other);
        reasons |= reasons_in(answer_style == 0 ? result : &other);
    } while (good && has_reasons(exercise) && result->at[0] != CAMERA_OK &&
             ++answer_style < chosen_stem()->styles);
    answer_style = style;
    if (good && has_reasons(exercise) && result->at[0] != CAMERA_OK)
        set_reasons(result, reasons & ~(1 << CAMERA_OK));
    return good;
}

AnyFunction *right_function(int exercise)
{
    for (const KnownAnswer *it = known_answers(FREE_ANSWERS); it != NULL; it = it->next)
        if (strcmp(it->exercise, exercises[exercise].name) == 0)
            return it->answer;
    return exercises[exercise].reference;
}

static const Numbers *by_function(int exercise, const Mistake *mistake, int nth)
{
    static Numbers numbers;
    (void)nth;
    known_result(exercise, mistake == NULL ? right_function(exercise) : mistake->answer, &question,
                 &size, &numbers);
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

// ---- the corners of the image plane, by the reference ------------------------------------------

typedef vec3 PlaneVector(Camera camera, double s, double t);

void reference_corners(Camera camera, vec3 corners[4])
{
    static const double places[4][2] = {{0, 1}, {1, 1}, {1, 0}, {0, 0}};
    int exercise = exercise_number("image_plane_vector");
    PlaneVector *vector = (PlaneVector *)exercises[exercise].reference;
    for (int i = 0; i < 4; i++)
        corners[i] = vector(camera, places[i][0], places[i][1]);
}

// ---- the right result for a call that was kept (figure.h) --------------------------------------

bool right_answer(const Record *record, Kept *kept, Wire *right)
{
    (void)record;
    kept->question.read = 0;
    wire_clear(right);
    return apply(kept->exercise, exercises[kept->exercise].reference, &kept->question, right);
}

bool right_corners(const Record *record, Camera camera, vec3 corners[4])
{
    (void)record;
    reference_corners(camera, corners);
    return true;
}
