// answer_calls.c - answers the judge's calls, however its messages arrive.
#include "tests/judge/answer_calls.h"

#include "common/answers.h"
#include "tests/judge/calls_traced.h"
#include "tests/judge/message.h"

#include <errno.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>

static WireHeader current; // the call that is being answered

static bool send(const WireHeader *header, Wire *message)
{
    size_t size;
    const void *block = wire_block(message, header, &size);
    return block != NULL && answer_write(block, size);
}

void answer_crashed(const WireCrash *crash)
{
    WireHeader header = current;
    header.kind = WIRE_CRASH;
    header.size = sizeof *crash;
    answer_write(&header, sizeof header);
    answer_write(crash, sizeof *crash);
}

// Reads a message into the wire. False if there is none.
static bool receive(WireHeader *header, Wire *wire)
{
    wire_clear(wire);
    if (!answer_read(header, sizeof *header) || header->magic != WIRE_MAGIC ||
        !wire_make_room(wire, header->size))
        return false;
    wire->size = (size_t)header->size;
    return answer_read(wire->bytes, wire->size);
}

// If an exercise of this chapter is lent, its calls come here (lent_answers.c) and the judge
// answers them: this process never holds the reference of the chapter that is judged.
static Wire lent;

static Wire *begin_asking(int exercise)
{
    (void)exercise;
    wire_clear(&lent);
    return &lent;
}

static void ask_judge(int exercise)
{
    WireHeader ask = {WIRE_MAGIC, exercise, current.nonce, lent.size, WIRE_ASK, 0, 0, ""};
    if (!send(&ask, &lent))
        answer_end();
}

static Wire *receive_lent(int exercise)
{
    WireHeader answer;
    (void)exercise;
    if (!receive(&answer, &lent) || answer.kind != WIRE_LENT)
        answer_end();
    return &lent;
}

static void say_entered(int exercise)
{
    WireHeader header = {WIRE_MAGIC, exercise, current.nonce, 0, WIRE_ENTERED, 0, 0, ""};
    if (!answer_write(&header, sizeof header))
        answer_end();
}

// What the answer does not set keeps these bytes (message.h).
static void fill_memory(void *result, size_t size)
{
    int byte = current.paint & PAINT_BYTE;
    memset(result, byte, size);
    fill_stack_with(byte);
}

// No call passes because its padding is 0.
static int padding_of_call(void)
{
    int byte = current.paint & PAINT_BYTE;
    return current.paint & EMPTY_PADDING ? 0 : byte != 0 ? byte : 0xff;
}

static void say_failed_check(const FailedCheck *failed)
{
    fflush(NULL);
    answer_crashed(&(WireCrash){.signal = SIGABRT, .access = -1, .failed_check = *failed});
    answer_end();
}

void answer_begin(void)
{
    static const Transport judge = {begin_asking, ask_judge, receive_lent, NULL};
    transport_use(&judge);
    setvbuf(stdout, NULL, _IONBF, 0); // so that the text printed before a crash is not lost
    before_call = fill_memory;
    tell_failed_check = say_failed_check;
}

bool answer_call(void)
{
    static Wire in, out;
    if (!receive(&current, &in))
        return false;
    wire_clear(&out);
    wire_fill_padding_with(padding_of_call());
    errno = 0;
    trace_calls_of(current.exercise, say_entered);
    if (!dispatch(current.exercise, &in, &out))
        answer_end();
    trace_end();
    fflush(NULL); // the printed text is there before the answer
    WireHeader header = current;
    header.kind = WIRE_ANSWER;
    header.size = out.size;
    header.overran = out.overran;
    if (answers_missing() > 0)
        snprintf(header.missing, sizeof header.missing, "%s", answer_missing(0));
    answers_forget();
    if (!send(&header, &out))
        answer_end();
    return true;
}
