// check_shared_answer.c - tests of which answers are linked as shared objects.
// Expected: what the linker says of them, and shared_answer.h. 08-fast has one exercise.
#include "tests/course/shared_answer.h"

#include "tests/course/object_symbols.h"
#include "tests/course/programs.h"
#include "tests/course/whole_text.h"
#include "tests/judge/test.h"

#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#ifdef __linux__
static char folder[] = "/tmp/shared-XXXXXX";

static void in_folder(char path[200], const char *name)
{
    snprintf(path, 200, "%s/%s", folder, name);
}

static void write_file(const char *path, const char *bytes, size_t size)
{
    FILE *file = fopen(path, "w");
    if (file == NULL || fwrite(bytes, 1, size, file) != size || fclose(file) != 0)
        abort();
}

static void folder_begin(void)
{
    char path[200];
    strcpy(folder, "/tmp/shared-XXXXXX");
    if (mkdtemp(folder) == NULL)
        abort();
    in_folder(path, "08-fast");
    mkdir(path, 0777);
    in_folder(path, "loading");
    mkdir(path, 0777);
    in_folder(path, "loading/08-fast");
    write_file(path, "", 0);
    in_folder(path, "loading/08-fast.names");
    write_file(path, "main\nsqrt\nwire_put\n_GLOBAL_OFFSET_TABLE_\n", 42);
}

static void folder_end(void)
{
    Command command = {.count = 0};
    command_add(&command, "rm");
    command_add(&command, "-r");
    command_add(&command, folder);
    program_run(&command, NULL);
    command_free(&command);
}

static bool is_linked(void)
{
    char loading[200], program[200];
    in_folder(loading, "loading");
    in_folder(program, "08-fast/answering");
    JudgingPlan plan = {.verdict = folder,
                        .loading = loading,
                        .shared = "true",
                        .lend_shared = "",
                        .lent = "",
                        .count = 1,
                        .chapters = {{.stem = "08-fast", .objects = "", .stands_on = ""}}};
    unlink(program);
    bool linked = shared_answer_link(&plan, 0, program, "");
    if (linked != (access(program, F_OK) == 0))
        abort();
    return linked;
}

static void compile(const char *text)
{
    char source[200], object[200];
    in_folder(source, "answer.c");
    in_folder(object, "08-fast/answer.o");
    write_file(source, text, strlen(text));
    Command command = {.count = 0};
    const char *compiler = getenv("CC");
    command_words(&command, compiler != NULL ? compiler : "cc");
    command_words(&command, "-w -fPIC -c -o");
    command_add(&command, object);
    command_add(&command, source);
    if (program_run(&command, NULL) != 0)
        abort();
    command_free(&command);
}

#define ANSWER "void sphere_rectangle(void) {}\n"

static void expect_linked(bool expected, int count, const char *const *texts)
{
    folder_begin();
    for (int i = 0; i < count; i++) {
        compile(texts[i]);
        given("answer", "%s", texts[i]);
        expect_law(is_linked() == expected, expected ? "a shared object" : "a whole program",
                   expected ? "a whole program" : "a shared object");
    }
    folder_end();
}

START_TEST(ordinary_answers_are)
{
    const char *const texts[] = {
        ANSWER,
        "#pragma weak sphere_rectangle\n" ANSWER,
        ANSWER "static int main_helper;\nint helper(void) { return main_helper; }\n",
        ANSWER "double sqrt(double); double root(double x) { return sqrt(x); }\n",
        ANSWER "void hit_sphere(void); void hit(void) { hit_sphere(); }\n",
        ANSWER "__attribute__((constructor)) static void begin(void) {}\n",
    };
    expect_linked(true, sizeof texts / sizeof texts[0], texts);
}
END_TEST

START_TEST(answers_of_which_the_linker_has_something_to_say_are_not)
{
    const char *const texts[] = {
        "int nothing;\n",
        ANSWER "int main(void) { return 0; }\n",
        ANSWER "double sqrt(double x) { return x; }\n",
        ANSWER "int wire_put;\n",
        ANSWER "void hit_sphere(void) {}\n",
        ANSWER "void lost(void); void find(void) { lost(); }\n",
        ANSWER "#pragma weak lost\nvoid lost(void); void find(void) { lost(); }\n",
        "int sphere_rectangle = 1;\n",
        "__attribute__((visibility(\"hidden\"))) " ANSWER,
        ANSWER "__thread int of_thread;\n",
        ANSWER "static void *pick(void) { return 0; }\n"
               "void picked(void) __attribute__((ifunc(\"pick\")));\n",
        ANSWER "void old(void) {}\n__asm__(\".symver old, sqrt@@GLIBC_2.2.5\");\n",
    };
    expect_linked(false, sizeof texts / sizeof texts[0], texts);
}
END_TEST

static bool reads_name(const ObjectSymbol *symbol, void *given)
{
    (void)given;
    return strlen(symbol->name) < SIZE_MAX;
}

static void put_byte(FILE *file, size_t at, int byte)
{
    fseek(file, (long)at, SEEK_SET);
    putc(byte, file);
    fflush(file);
}

// Under a sanitizer this fails if something outside the file is read.
START_TEST(damaged_objects_do_no_harm)
{
    size_t size;
    char object[200];
    folder_begin();
    compile(ANSWER "double sqrt(double); double root(double x) { return sqrt(x); }\n");
    in_folder(object, "08-fast/answer.o");
    char *bytes = whole_text(object, &size);
    given("object", "its first half");
    write_file(object, bytes, size / 2);
    expect_law(!is_linked(), "a whole program", "a shared object");
    write_file(object, bytes, size);
    FILE *file = fopen(object, "r+");
    for (size_t i = 0; file != NULL && i < size; i++) {
        put_byte(file, i, bytes[i] ^ 0xff);
        object_symbols(object, reads_name, NULL);
        put_byte(file, i, bytes[i]);
    }
    if (file == NULL || fclose(file) != 0)
        abort();
    free(bytes);
    folder_end();
}
END_TEST
#endif

static void list_tests(void)
{
    tests_of("shared_answer");
#ifdef __linux__
    test(ordinary_answers_are);
    test(answers_of_which_the_linker_has_something_to_say_are_not);
    test(damaged_objects_do_no_harm);
#endif
}

OF_STEM(list_tests)
