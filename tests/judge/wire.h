// wire.h - one message between the judge and the answering process: bytes, put and got in order.
//
// Both ends are of one build on one machine, so a value crosses as it lies in memory, with zeros
// for its padding; the items that it points to follow it. Getting never reads beyond the end: it
// marks the message as bad.
#ifndef TESTS_JUDGE_WIRE_H
#define TESTS_JUDGE_WIRE_H

#include "common/failed_check.h"
#include "tests/judge/types.h"

#include <stdint.h>
#include <stdlib.h>

enum { WIRE_MOST_BYTES = 64 << 20 };

typedef struct {
    uint8_t *bytes;  // after room for a header, from malloc
    size_t size;     // how many were put
    size_t room;     // how many there is room for
    size_t read;     // bytes read so far
    bool bad;        // too short, too long, or invalid
    bool is_hostile; // a question of a student's process: the conditions of the reference are
                     // checked
    bool
        overran; // the process that made this answer wrote past the end of an array of the question
} Wire;

// In front of every message.
typedef struct {
    uint32_t magic;
    int32_t exercise;
    uint64_t nonce; // new for every call; the answer must bring it back
    uint64_t size;  // of the message that follows
    int32_t kind;
    int32_t paint;    // of a call: what memory is filled with that nobody has set (message.h)
    int32_t overran;  // in an answer: it wrote past the end of the image or of depth
    char missing[60]; // in an answer: the first blank that was called; empty if none was
} WireHeader;

enum { WIRE_MAGIC = 0x52617943 };
// The judge calls and lends; the answering process answers, calls a lent exercise, or crashes; and
// it reports which other exercises it enters meanwhile (calls_traced.h).
enum { WIRE_CALL, WIRE_ANSWER, WIRE_CRASH, WIRE_ASK, WIRE_LENT, WIRE_ENTERED };

// The message of a crash.
typedef struct {
    int32_t signal;
    int32_t access; // of memory: 0 a read, 1 a write, -1 not known
    uint64_t address;
    int32_t stack_overflow;
    int32_t out_of_memory; // an allocation had failed before
    int32_t no_address;    // the pointer is none: the machine has no such address
    int32_t system_call;   // of SIGSYS: which one is forbidden
    FailedCheck failed_check;
} WireCrash;

void wire_clear(Wire *wire);
void wire_free(Wire *wire);
bool wire_make_room(Wire *wire, uint64_t size); // for a message of this many bytes
void wire_put(Wire *wire, const void *value, size_t size);
void wire_get(Wire *wire, void *value, size_t size);
bool wire_is_read(const Wire *wire); // to its end, and nothing was invalid
// The header and the message behind it, as one block of bytes: written at once, it wakes the other
// end once. NULL if there is no memory.
const void *wire_block(Wire *wire, const WireHeader *header, size_t *size);

bool is_light_kind(LightKind kind); // and not another number

// A value of any type: the parts of the type, and zeros for its padding, which could hold data of
// the judge. In a value that was read, padding has this byte: nobody should use it, and numbers
// made of it spoil any result. To begin with it is 0xff (NaN).
void wire_fill_padding_with(int byte);
void wire_put_value(Wire *wire, const Type *type, const void *value);
void wire_get_value(Wire *wire, const Type *type, void *value);
void wire_free_value(const Type *type, void *value); // memory that reading it took from malloc

// Arrays that were read have a guard before their first item and after their last, for loops that
// run once too often. A sphere around the whole world, with a colour that no scene has, and a very
// bright light: one item too many shows in the result. The guards of pixels and depths are checked
// afterwards: one item too many that was written shows there, and the guard's depth is farther than
// any hit, so that a hit replaces it.
#define GUARD_SPHERE ((Sphere){{0, 0, 0}, 1e100, 0})
#define GUARD_LIGHT ((Light){{0.48, 0.6, 0.64}, {1, 1, 1}, LIGHT_DISTANT})

void wire_put_pixels(Wire *wire, const Image *image);
void wire_get_pixels(Wire *wire, Image *image); // into an image of the same size
// The memory after the pixels of an image that was read, or after the depths of wire_get_doubles,
// has changed.
bool wire_pixels_overran(const Image *image);
bool wire_doubles_overran(const double *doubles, const Image *image);

// One per pixel of the image.
void wire_put_doubles(Wire *wire, const double *doubles, const Image *image);
double *wire_get_doubles(Wire *wire, const Image *image);
void wire_free_doubles(double *doubles); // which wire_get_doubles has made
void wire_get_into_doubles(Wire *wire, double *doubles, const Image *image);

#endif
