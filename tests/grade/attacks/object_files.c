// object_files.c - sections, symbols and code that give orders to linkers, loaders and processors.
// cases.py reads it: each section is one submission, and states the result that it must get.

// ---- c-plus-plus: another language.
// stem: 01-corners
// expect: does not compile
// earns: nothing
// rest: none
#include <iostream>
template <class T> T upper_left(T c)
{
    std::cout << "forged-mark";
    return c;
}

// ---- pragma-other-name: the answer goes by the reference's name, and another by the answer's.
// stem: 01-corners
// expect: does not compile | graded
// earns: nothing
#pragma redefine_extname upper_left reference_upper_left
#pragma redefine_extname upper_right upper_left
#include "exercises/01-corners.h"

vec3 upper_left(Camera c)
{
    return c.up;
}

// ---- pragma-poison: words that whatever is read after the student's file may not use any more.
// stem: 01-corners
// expect: does not compile
// earns: nothing
#include "exercises/01-corners.h"
#pragma GCC poison return vec3 main Camera
#pragma GCC system_header
#pragma GCC diagnostic error "-Weverything"
#pragma GCC visibility push(hidden)

// ---- pragma-target: code for another processor, which passes a vec3 in another way.
// stem: 01-corners
// expect: graded | crashed | does not compile
// earns: nothing
#if defined(__x86_64__)
#pragma GCC target("avx512f")
#endif
#include "exercises/01-corners.h"

vec3 upper_left(Camera c)
{
    return c.up * 2.5;
}

// ---- pragma-weak: one answer for all questions, by weak names.
// stem: 01-corners
// expect: graded | does not compile | crashed
// earns: upper_right
// rest: none
#include "exercises/01-corners.h"
#pragma weak upper_left = right
#pragma weak across_30_up_10 = right
#pragma weak image_plane_vector = right
#pragma weak with_unit_distance = right
#pragma weak main = right
#pragma weak dispatch = right

vec3 right(Camera c)
{
    return c.distance * c.forward + c.width / 2 * c.right + c.height / 2 * c.up;
}

vec3 upper_right(Camera c)
{
    return right(c);
}

// ---- section-dynamic: entries for the loader: a library and a path of the student's.
// stem: 01-corners
// expect: crashed | graded | does not compile
// earns: perhaps upper_right
#include "exercises/01-corners.h"

__attribute__((section(".dynamic"), used)) static long entries[] = {15, 1, 29, 1, 0x6ffffefc, 1};
__asm__(".section .dynstr,\"a\",@progbits\n.asciz \"\\0/tmp/hostile-was-here.so\"\n.text\n");

vec3 upper_right(Camera c)
{
    return c.distance * c.forward + c.width / 2 * c.right + c.height / 2 * c.up;
}

// ---- section-for-the-linker: sections in which linkers look for options, and for code to
// optimise.
// stem: 01-corners
// expect: graded | crashed | does not compile
// earns: perhaps upper_right
#include "exercises/01-corners.h"

__asm__(".section .drectve,\"e\",@progbits\n.ascii \" -defaultlib:hostile \"\n"
        ".section .deplibs,\"MS\",@progbits,1\n.asciz \"hostile\"\n"
        ".section .linker-options,\"e\",@progbits\n.asciz \"lib\"\n.asciz \"hostile\"\n"
        ".section .gnu.lto_.opts,\"e\",@progbits\n"
        ".asciz \"'-fplugin=/tmp/hostile-was-here.so' '-wrapper' '/bin/sh,-c,id'\"\n"
        ".section .gnu.lto_upper_left.1,\"e\",@progbits\n.long 1, 2, 3\n"
        ".section .gnu_debuglink,\"\",@progbits\n.asciz \"@TREE@/build/judge\"\n"
        ".text\n");

vec3 upper_right(Camera c)
{
    return c.distance * c.forward + c.width / 2 * c.right + c.height / 2 * c.up;
}

// ---- section-interpreter: names the program that is to load the answering program.
// stem: 01-corners
// expect: crashed | graded | does not compile
// earns: perhaps upper_right
#include "exercises/01-corners.h"

__attribute__((section(".interp"), used)) static const char loader[] =
    "@TREE@/tests/grade/attacks/no-loader";

vec3 upper_right(Camera c)
{
    return c.distance * c.forward + c.width / 2 * c.right + c.height / 2 * c.up;
}

// ---- section-notes: forged notes: a stack that may be run, processor features, a build id.
// stem: 01-corners
// expect: graded | crashed | does not compile
// earns: perhaps upper_right
#include "exercises/01-corners.h"

__asm__(".section .note.gnu.property,\"a\",@note\n.long 4, 16, 5\n.asciz \"GNU\"\n"
        ".long 0xc0000002, 4, 0xffffffff, 0\n"
        ".section .note.gnu.build-id,\"a\",@note\n.long 4, 4, 3\n.asciz \"GNU\"\n.long 0\n"
        ".section .note.GNU-stack,\"x\",@progbits\n.text\n");

vec3 upper_right(Camera c)
{
    return c.distance * c.forward + c.width / 2 * c.right + c.height / 2 * c.up;
}

// ---- section-start: code in the sections that run at the start, written out by hand.
// stem: 01-corners
// expect: crashed | graded | does not compile
// earns: nothing
#include "exercises/01-corners.h"

#if defined(__x86_64__)
__asm__(".section .init,\"ax\",@progbits\n mov $231, %eax\n xor %edi, %edi\n syscall\n"
        ".section .ctors,\"aw\",@progbits\n .quad 1\n"
        ".section .init_array.00001,\"aw\",@init_array\n .quad leave\n"
        ".text\nleave: mov $231, %eax\n xor %edi, %edi\n syscall\n");
#else
__attribute__((section(".ctors"), used)) static void *const first = (void *)1;
#endif
