// message.h - one call of an exercise as a message: its arguments there, its results back.
//
// Both ends are of one build on one machine. A message is a header and the numbers of a call, or
// how it crashed.
#ifndef TESTS_JUDGE_MESSAGE_H
#define TESTS_JUDGE_MESSAGE_H

#include "common/failed_check.h"
#include "tests/judge/numbers.h"

#include <stdbool.h>

typedef struct {
    uint32_t magic;
    int32_t exercise;
    uint64_t nonce; // new for every call; the answer must bring it back
    uint64_t size;  // in bytes, of what follows
    int32_t kind;
    int32_t paint;    // of a call: what memory is filled with that nobody has set (below)
    int32_t overran;  // in an answer: it wrote past the end of the image or of depth
    char missing[60]; // in an answer: the first blank that was called; empty if none was
} MessageHeader;

enum { MESSAGE_MAGIC = 0x52617943 };
// The judge calls and lends; the answering process answers, calls a lent exercise, or crashes; and
// it reports which other exercises it enters meanwhile.
enum { MESSAGE_CALL, MESSAGE_ANSWER, MESSAGE_CRASH, MESSAGE_ASK, MESSAGE_LENT, MESSAGE_ENTERED };

// What follows the header of a crash.
typedef struct {
    int32_t signal;
    int32_t access; // of memory: 0 a read, 1 a write, -1 not known
    uint64_t address;
    int32_t stack_overflow;
    int32_t out_of_memory; // an allocation had failed before
    int32_t no_address;    // the pointer is none: the machine has no such address
    int32_t system_call;   // of SIGSYS: which one is forbidden
    FailedCheck failed_check;
} Crash;

// The header, with the size of the numbers behind it, as one block of bytes: written at once, it
// wakes the other end once.
const void *message_block(MessageHeader header, const Numbers *numbers, size_t *size);
// Room for what follows this header. False if it cannot be a message.
bool message_make_room(const MessageHeader *header, Numbers *numbers);

// arguments: the address of each, or the pointer itself (exercise.h). result: of the return value.
void get_results(Numbers *numbers, int exercise, void *result, void *const *arguments);

// The size of the image among the arguments of a call.
Resolution image_size(int exercise, const Numbers *arguments);

// Gets the arguments, calls this function, puts the results. False if the message is bad.
bool apply(int exercise, AnyFunction *function, Numbers *in, Numbers *out);

// Called just before such a function is, if it is not NULL, with the memory for its result.
extern void (*before_call)(void *result, size_t size);

// Gets the arguments, calls the answer, puts the results. False if the message is bad or the
// exercise is of another chapter.
bool dispatch(int exercise, Numbers *in, Numbers *out);

// ---- how a call reaches its answer -------------------------------------------------------------

// The tests call exercises by their contract names; the main program chooses what answers: a
// process over a pipe (process.h), a function of this process, or anything else that makes the
// results of a call from its arguments.
typedef Numbers *Transport(int exercise, Numbers *question);

// From now on calls go this way. refuse: called with answers that are not the results of this
// exercise; NULL: there are none.
void transport_use(Transport *transport, void (*refuse)(int exercise));

// One call; and whether its results are all that is in the answer, after they were read.
Numbers *transport_ask(int exercise, Numbers *question);
void transport_check(int exercise, const Numbers *answer);

// The same with the values of a call.
void transport_call(int exercise, void *result, void *const *arguments);

// Another way: from now on this function of this process answers, as if the call had crossed the
// pipe. And one call of it.
void answer_here_by(AnyFunction *answer);
void answer_here(int exercise, AnyFunction *answer, Numbers *in, Numbers *out);

// Of an exercise that is called by its contract name, as tests do (reference/proxies.c): from now
// on this function answers; NULL: the transport. To begin with, the reference.
void answer_by(int exercise, AnyFunction *answer);

// Answers that are linked into this program, in the list's order; NULL: it has none. The linker has
// renamed them: an answer's upper_left is answer_upper_left here, so that upper_left is the proxy.
// Those of the stem that is chosen are called in this process, and the reference answers for all
// other stems, so that one mistake costs once. An answer calls the exercises of its own stem
// directly, and those of other stems through the proxies.
extern AnyFunction *const direct_answers[];

// ---- the memory that nobody has set ------------------------------------------------------------

// In the answering process it is filled with bytes that cannot pass for a right value: its stack,
// before a call and whenever one of the answer's functions is entered (calls_traced.c), its result,
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

// ---- the other end (answer_calls.c), also in a page, in a WebAssembly instance (chapters/book/)
// ---

// The program round it moves the bytes: all of them, or false.
bool answer_read(void *bytes, size_t size);
bool answer_write(const void *bytes, size_t size);
// Ends the program: the judge cannot be understood, or is gone.
_Noreturn void answer_end(void);

void answer_begin(void);
// Waits for a call and answers it. False if there is none, or it is not one of this chapter.
bool answer_call(void);
// Reports that the call that is being answered has crashed.
void answer_crashed(const Crash *crash);

// ---- when a function of the answer is entered (calls_traced.c) ---------------------------------

// Answers are compiled with -finstrument-functions, so that each of their functions reports when it
// is entered. An exercise that a call enters, directly or through others, may be the reason why the
// call is wrong.

// From now on each exercise that is entered is reported once, except the one that is called.
void trace_calls_of(int exercise, void (*entered)(int other));
void trace_end(void);

// Before any function of the answer runs, the stack below is filled with this byte: now, and
// whenever one is entered. So a variable that was never set is wrong in every call, and not only
// when an earlier call has left something else there.
void fill_stack_with(int byte);

#endif
