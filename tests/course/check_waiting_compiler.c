// check_waiting_compiler.c - tests of compilers that are started before an answer is saved, and of
// precompiled contracts. Expected: waiting_compiler.h and precompiled.h. The compiler is cat, so
// that its object shows what it has read.
#include "tests/course/waiting_compiler.h"

#include "tests/course/precompiled.h"
#include "tests/course/programs.h"
#include "tests/course/whole_text.h"
#include "tests/judge/test.h"

#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#define STEM "01-corners"
#define CONTRACT "#include \"exercises/" STEM ".h\"\n"

static PlanPath folder;
static PlanPath in_folder(const char *name)
{
    return path_of(folder.s, name, "");
}

static void write_file(const char *name, const char *text)
{
    FILE *file = fopen(in_folder(name).s, "w");
    if (file == NULL || fputs(text, file) < 0 || fclose(file) != 0)
        abort();
}

static void is_written_at(const char *name, time_t seconds)
{
    const struct timespec times[2] = {{seconds, 0}, {seconds, 0}};
    if (utimensat(AT_FDCWD, in_folder(name).s, times, 0) != 0)
        abort();
}

enum { LATE = 2000000000, LATER };
static PlanPath header;
static JudgingPlan plan_begin(const char *compile_early)
{
    strcpy(folder.s, "/tmp/waiting-XXXXXX");
    if (mkdtemp(folder.s) == NULL || mkdir(in_folder(STEM).s, 0777) != 0 ||
        mkdir(in_folder("exercises").s, 0777) != 0)
        abort();
    write_file("header.h", "");
    is_written_at("header.h", LATE);
    write_file("exercises/" STEM ".h.gch", "");
    is_written_at("exercises/" STEM ".h.gch", LATE);
    write_file(STEM ".c", "");
    header = in_folder("header.h");
    return (JudgingPlan){.verdict = folder.s,
                         .precompiled = folder.s,
                         .headers = header.s,
                         .compile_early = compile_early,
                         .count = 1,
                         .chapters = {{.stem = STEM}}};
}

static void folder_end(void)
{
    Command command = {.count = 0};
    command_words(&command, "rm -r");
    command_add(&command, folder.s);
    program_run(&command, NULL);
    command_free(&command);
}

static bool compiles(const JudgingPlan *plan, const char *text)
{
    write_file("answer.c", text);
    return waiting_compiler_compiles(plan, 0, in_folder("answer.c").s, in_folder("said").s);
}

static const bool first[MOST_CHAPTERS] = {true};
static const char quick[] = "cat /dev/stdin | cp /dev/stdin OBJECT";

START_TEST(an_answer_that_waits_for_nothing_else_is_included)
{
    const char *const texts[] = {
        CONTRACT "int a;\n",
        "// a comment, a blank line\n\n" CONTRACT
        "\n#include \"common/answers.h\"\n#include <math.h>\n",
        "\r\n// x\r\n" CONTRACT "#define TWO 2\n#if TWO\nint a;\n#endif\n",
        CONTRACT "#include \"mine.h\"\n/* a comment \\\n */\n",
    };
    for (size_t i = 0; i < sizeof texts / sizeof texts[0]; i++) {
        given("answer", "%s", texts[i]);
        expect_law(may_be_included(texts[i], STEM), "included", "compiled in the ordinary way");
    }
}
END_TEST

START_TEST(an_answer_that_could_mean_something_else_is_not)
{
    const char *const texts[] = {
        "",
        "int a;\n",
        "#include \"exercises/02-cameras.h\"\n",
        "int a;\n" CONTRACT,
        "// a comment that goes on \\\n" CONTRACT,
        "/* a comment\n" CONTRACT "*/\n",
        "#if 0\n" CONTRACT "#endif\n",
        "// a comment that goes on ?\?/\n" CONTRACT,
        CONTRACT "#include_next <math.h>\n",
        CONTRACT "#pragma once\n",
        CONTRACT "_Pragma(\"GCC system_header\")\n",
        CONTRACT "const char *file = __FILE__;\n",
        CONTRACT "#include <assert.h>\n",
        CONTRACT "int a = __INCLUDE_LEVEL__;\n",
    };
    for (size_t i = 0; i < sizeof texts / sizeof texts[0]; i++) {
        given("answer", "%s", texts[i]);
        expect_law(!may_be_included(texts[i], STEM), "compiled in the ordinary way", "included");
    }
}
END_TEST

START_TEST(a_compiler_that_waits_compiles_one_answer)
{
    JudgingPlan plan = plan_begin(quick);
    expect_law(!compiles(&plan, CONTRACT), "none waits", "one does");
    compilers_wait(&plan, first);
    expect_law(compiles(&plan, CONTRACT "int a;\n"), "compiled", "not compiled");
    size_t size;
    char expected[2 * MOST_PLAN_PATH],
        *object = whole_text(plan_file(&plan, 0, "answer.o").s, &size);
    snprintf(expected, sizeof expected, "#include \"%s\"\n", in_folder("answer.c").s);
    expect_law(object != NULL && strcmp(object, expected) == 0, expected, "another input");
    free(object);
    expect_law(!compiles(&plan, CONTRACT), "none waits", "one does");
    folder_end();
}
END_TEST

START_TEST(it_still_waits_after_an_answer_that_is_not_included)
{
    JudgingPlan plan = plan_begin(quick);
    compilers_wait(&plan, first);
    expect_law(!compiles(&plan, "int a;\n"), "compiled in the ordinary way", "included");
    expect_law(compiles(&plan, CONTRACT), "compiled", "not compiled");
    folder_end();
}
END_TEST

START_TEST(one_that_has_read_another_header_is_not_used)
{
    JudgingPlan plan = plan_begin(quick);
    compilers_wait(&plan, first);
    is_written_at("header.h", LATER);
    expect_law(!compiles(&plan, CONTRACT), "compiled in the ordinary way", "included");
    compilers_wait(&plan, first);
    expect_law(!compiles(&plan, CONTRACT), "none waits: the copy is old", "one does");
    is_written_at("exercises/" STEM ".h.gch", LATER);
    compilers_wait(&plan, first);
    expect_law(compiles(&plan, CONTRACT), "compiled", "not compiled");
    folder_end();
}
END_TEST

START_TEST(one_that_fails_or_says_something_has_not_compiled)
{
    const char *const commands[] = {"false | cp /dev/stdin OBJECT",
                                    "cat /dev/stdin | false",
                                    "cat /dev/stdin | cp -v /dev/stdin OBJECT",
                                    "ls /dev/null/nothing | cp /dev/stdin OBJECT",
                                    "there-is-no-such-program | cp /dev/stdin OBJECT",
                                    "cat /dev/stdin"};
    for (size_t i = 0; i < sizeof commands / sizeof commands[0]; i++) {
        JudgingPlan plan = plan_begin(commands[i]);
        compilers_wait(&plan, first);
        given("command", "%s", commands[i]);
        expect_law(!compiles(&plan, CONTRACT), "not compiled", "compiled");
        folder_end();
    }
}
END_TEST

START_TEST(a_contract_is_current_until_a_header_is_newer)
{
    JudgingPlan plan = plan_begin(quick);
    expect_law(precompiled_is_current(&plan, 0), "current", "old");
    is_written_at("header.h", LATER);
    expect_law(!precompiled_is_current(&plan, 0), "old", "current");
    is_written_at("exercises/" STEM ".h.gch", LATER);
    expect_law(precompiled_is_current(&plan, 0), "current", "old");
    folder_end();
}
END_TEST

static void list_tests(void)
{
    tests_of("waiting_compiler");
    test(an_answer_that_waits_for_nothing_else_is_included);
    test(an_answer_that_could_mean_something_else_is_not);
    test(a_compiler_that_waits_compiles_one_answer);
    test(it_still_waits_after_an_answer_that_is_not_included);
    test(one_that_has_read_another_header_is_not_used);
    test(one_that_fails_or_says_something_has_not_compiled);
    tests_of("precompiled");
    test(a_contract_is_current_until_a_header_is_newer);
}

OF_STEM(list_tests)
