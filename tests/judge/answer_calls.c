// answer_calls.c - answers the judge's calls, however its messages arrive.

#include "common/answers.h"
#include "tests/judge/message.h"

#include <errno.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>

static MessageHeader current; // the call that is being answered

static bool send(MessageHeader header, const Numbers *numbers)
{
    size_t size;
    const void *block = message_block(header, numbers, &size);
    return answer_write(block, size);
}

void answer_crashed(const Crash *crash)
{
    MessageHeader header = current;
    header.kind = MESSAGE_CRASH;
    header.size = sizeof *crash;
    answer_write(&header, sizeof header);
    answer_write(crash, sizeof *crash);
}

// Reads a message. False if there is none.
static bool receive(MessageHeader *header, Numbers *numbers)
{
    return answer_read(header, sizeof *header) && message_make_room(header, numbers) &&
           answer_read(numbers->at, (size_t)header->size);
}

// If an exercise of this chapter is lent, its calls come here (lent_answers.c) and the judge
// answers them: this process never holds the reference of the chapter that is judged.
static Numbers *ask_judge(int exercise, Numbers *question)
{
    static Numbers lent;
    MessageHeader ask = {MESSAGE_MAGIC, exercise, current.nonce, 0, MESSAGE_ASK, 0, 0, ""}, answer;
    if (!send(ask, question) || !receive(&answer, &lent) || answer.kind != MESSAGE_LENT)
        answer_end();
    return &lent;
}

static void say_entered(int exercise)
{
    MessageHeader header = {MESSAGE_MAGIC, exercise, current.nonce, 0, MESSAGE_ENTERED, 0, 0, ""};
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
    answer_crashed(&(Crash){.signal = SIGABRT, .access = -1, .failed_check = *failed});
    answer_end();
}

void answer_begin(void)
{
    transport_use(ask_judge, NULL);
    setvbuf(stdout, NULL, _IONBF, 0); // so that the text printed before a crash is not lost
    before_call = fill_memory;
    tell_failed_check = say_failed_check;
}

bool answer_call(void)
{
    static Numbers in, out;
    if (!receive(&current, &in))
        return false;
    numbers_clear(&out);
    numbers_fill_padding_with(padding_of_call());
    errno = 0;
    trace_calls_of(current.exercise, say_entered);
    if (!dispatch(current.exercise, &in, &out))
        answer_end();
    trace_end();
    fflush(NULL); // the printed text is there before the answer
    MessageHeader header = current;
    header.kind = MESSAGE_ANSWER;
    header.overran = out.overran;
    if (answers_missing() > 0)
        snprintf(header.missing, sizeof header.missing, "%s", answer_missing(0));
    answers_forget();
    if (!send(header, &out))
        answer_end();
    return true;
}
