// message.h - one call of an exercise as a message: its arguments there, its results back.
#ifndef TESTS_JUDGE_MESSAGE_H
#define TESTS_JUDGE_MESSAGE_H

#include "tests/judge/exercise.h"
#include "tests/judge/wire.h"

#include <stdbool.h>

// arguments: the address of each, or the pointer itself (exercise.h). result: of the return value.
void put_arguments(Wire *wire, int exercise, void *const *arguments);
void put_results(Wire *wire, int exercise, const void *result, void *const *arguments);
void get_results(Wire *wire, int exercise, void *result, void *const *arguments);

// Gets the arguments, calls this function, puts the results. False if the message is bad.
bool apply(int exercise, AnyFunction *function, Wire *in, Wire *out);

// Called just before such a function is, if it is not NULL, with the memory for its result.
extern void (*before_call)(void *result, size_t size);

// Gets the arguments, calls the answer, puts the results. False if the message is bad or the
// exercise is of another chapter.
bool dispatch(int exercise, Wire *in, Wire *out);

// ---- how a call reaches its answer -------------------------------------------------------------

// The tests call exercises by their contract names; the main program chooses what answers: a
// process over a pipe (process_transport.h), a table of recorded answers (table.h), a function of
// this process, or anything else that has these functions.

typedef struct {
    Wire *(*begin)(int exercise);   // an empty message, for the arguments
    void (*send)(int exercise);     // they are all in it
    Wire *(*receive)(int exercise); // waits for the results
    void (*finish)(int exercise);   // all of them were read; may be NULL
} Transport;

// From now on calls go this way.
void transport_use(const Transport *transport);

// One call: put the arguments into the message that begins it, read the results from the answer.
Wire *transport_begin(int exercise);
Wire *transport_answer(int exercise);
void transport_finish(int exercise);

// The same with the values of a call.
void transport_call(int exercise, void *result, void *const *arguments);

// Another way: from now on this function of this process answers, as if the call had crossed the
// pipe. And one call of it.
void answer_here_by(AnyFunction *answer);
void answer_here(int exercise, AnyFunction *answer, Wire *in, Wire *out);

// ---- the memory that nobody has set ------------------------------------------------------------

// In the answering process it is filled with bytes that cannot pass for a right value: its stack,
// before a call and whenever one of the answer's functions is entered (calls_traced.h), its result,
// and the padding of its arguments. A result that was never set is recognised by them.

// Bytes. Two, so that no number is taken for paint by chance; they differ in the sign of a number
// and in the last bit of a bool.
enum { NO_PAINT, PAINT = 0x6b, OTHER_PAINT = 0xcc };
// Of a call: the bits of its byte; padding is 0, as it is in most programs by chance; the byte is
// 0.
enum { PAINT_BYTE = 0xff, EMPTY_PADDING = 0x100, EMPTY_STACK = 0x200 };

// For the next calls. NO_PAINT: each call of an exercise has another byte than the one before.
void paint_calls(int paint);
int paint_of_call(int exercise);

// Whether a number consists only of paint: of a double, or of an int.
bool is_paint(double number, int paint);

#endif
