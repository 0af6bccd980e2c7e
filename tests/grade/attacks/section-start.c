// section-start: code in the sections that run at the start, written out by hand.
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
