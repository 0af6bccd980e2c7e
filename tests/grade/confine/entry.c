// entry.c - the first instructions of an answering process that is graded, before any of the
// student's.
//
// The kernel hands every process a clock (the vDSO and the pages of numbers before it) and 16
// random bytes. The pages are unmapped here, since an answer can find them without being told where
// they are, and the bytes are overwritten. The host's name is not asked for either: some C
// libraries do at their start, and the filter forbids it.
#include <elf.h>
#include <stddef.h>
#include <stdint.h>
#include <sys/syscall.h>
#include <sys/utsname.h>

void hide_what_differs(uintptr_t *stack);

enum { PAGES_BEFORE = 64 }; // at least as many as any kernel puts before its vDSO

#if defined(__x86_64__)
static long unmap(uintptr_t from, uintptr_t to)
{
    long result;
    __asm__ volatile("syscall"
                     : "=a"(result)
                     : "a"((long)SYS_munmap), "D"(from), "S"(to - from)
                     : "rcx", "r11", "memory");
    return result;
}
__asm__(".globl graded_start\n"
        "graded_start:\n"
        "    mov %rsp, %rdi\n"
        "    push %rdx\n"
        "    push %rdx\n"
        "    call hide_what_differs\n"
        "    pop %rdx\n"
        "    pop %rdx\n"
        "    jmp _start\n");
#elif defined(__aarch64__)
static long unmap(uintptr_t from, uintptr_t to)
{
    register long call __asm__("x8") = SYS_munmap;
    register uintptr_t result __asm__("x0") = from, size __asm__("x1") = to - from;
    __asm__ volatile("svc #0" : "+r"(result) : "r"(call), "r"(size) : "memory");
    return (long)result;
}
__asm__(".globl graded_start\n"
        "graded_start:\n"
        "    mov x19, x0\n"
        "    mov x0, sp\n"
        "    bl hide_what_differs\n"
        "    mov x0, x19\n"
        "    b _start\n");
#else
#error "Grading knows x86-64 and arm64; say here how a process of this machine begins."
#endif

static uintptr_t end_of(const Elf64_Ehdr *program, uintptr_t page)
{
    const Elf64_Phdr *part = (const Elf64_Phdr *)((uintptr_t)program + program->e_phoff);
    uintptr_t end = 0;
    for (int i = 0; i < program->e_phnum; i++)
        if (part[i].p_type == PT_LOAD && part[i].p_vaddr + part[i].p_memsz > end)
            end = part[i].p_vaddr + part[i].p_memsz;
    return ((uintptr_t)program + end + page - 1) / page * page;
}

// A program that is linked statically has nothing else there when it starts, but for its stack.
static void unmap_clock(uintptr_t vdso, uintptr_t page, uintptr_t end_of_stack)
{
    uintptr_t from = vdso - PAGES_BEFORE * page;
    if (end_of_stack <= vdso && from < end_of_stack)
        from = end_of_stack;
    unmap(from, end_of((const Elf64_Ehdr *)vdso, page));
}

// The stack of a new process: argc, the arguments, NULL, the environment, NULL, pairs of the
// kernel's.
void hide_what_differs(uintptr_t *stack)
{
    uintptr_t *at = stack + 1 + stack[0] + 1;
    while (*at != 0)
        at++;
    uintptr_t vdso = 0, page = 4096, last = (uintptr_t)stack;
    for (at++; at[0] != AT_NULL; at += 2) {
        if (at[0] == AT_PAGESZ)
            page = at[1];
        if (at[0] == AT_EXECFN)
            last = at[1]; // the name of the program is the last thing on the stack
        if (at[0] == AT_SYSINFO_EHDR) {
            vdso = at[1];
            at[0] = AT_IGNORE;
        }
        if (at[0] == AT_RANDOM)
            for (size_t i = 0; i < 16; i++)
                ((volatile uint8_t *)at[1])[i] = (uint8_t)(17 * i + 1);
    }
    if (vdso != 0)
        unmap_clock(vdso, page, (last / page + 1) * page);
}

int __uname(struct utsname *name);
int __uname(struct utsname *name)
{
    *name = (struct utsname){.sysname = "Linux", .nodename = "sandbox", .release = "6.1.0"};
    return 0;
}

int uname(struct utsname *name)
{
    return __uname(name);
}
