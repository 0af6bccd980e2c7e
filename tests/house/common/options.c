// options.c - tests of common/options.c: what a program says of its command line.
// Expected: the contract in common/options.h. options_read ends the program, so it runs in a
// child; its exit status and what it printed are looked at.
#include "common/options.h"

#include "tests/judge/test.h"

#include <getopt.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

static struct {
    const char *out;
    Resolution size;
    bool flat;
    Camera camera;
} values;

static const Option options[] = {
    {"output", 'o', "FILE.png", option_string, &values.out, "where the picture goes"},
    {"size", 's', "WIDTHxHEIGHT", option_size, &values.size, "how large it is"},
    {"flat", 0, NULL, option_flag, &values.flat, "without shading"},
    CAMERA_OPTIONS(values.camera),
    {0}};

static const Usage usage = {"[-o FILE.png] [SCENE.nff]", "Casts a scene."};

// How a command line ended, and what it printed.
typedef struct {
    int status;
    char out[4000], err[1000];
} Ending;

static void take_all(FILE *file, char *words, size_t size)
{
    rewind(file);
    words[fread(words, 1, size - 1, file)] = '\0';
    fclose(file);
}

enum { WENT_ON = 77, MOST_ARGUMENTS = 10 };

// A program of these options, told so: exits with WENT_ON where options_read comes back.
static Ending ending_of(const char *const *words)
{
    Ending ending;
    FILE *out = tmpfile(), *err = tmpfile();
    ck_assert(out != NULL && err != NULL);
    fflush(NULL);
    pid_t child = fork();
    ck_assert_int_ge(child, 0);
    if (child == 0) {
        char *argv[MOST_ARGUMENTS + 2] = {"program"};
        int argc = 1;
        for (; words[argc - 1] != NULL && argc <= MOST_ARGUMENTS; argc++)
            argv[argc] = strdup(words[argc - 1]);
        dup2(fileno(out), STDOUT_FILENO);
        dup2(fileno(err), STDERR_FILENO);
        options_read(argc, argv, options, usage);
        _exit(WENT_ON);
    }
    int status;
    ck_assert_int_eq(waitpid(child, &status, 0), child);
    ck_assert(WIFEXITED(status));
    ending.status = WEXITSTATUS(status);
    take_all(out, ending.out, sizeof ending.out);
    take_all(err, ending.err, sizeof ending.err);
    return ending;
}

#define ENDING(...) ending_of((const char *const[]){__VA_ARGS__, NULL})

// Wrong usage: exit 2, nothing on stdout, and on stderr these words and where help is.
static void expect_wrong_usage(Ending ending, const char *words)
{
    expect_int(ending.status, EXIT_WRONG_USAGE);
    expect_text(ending.out, "");
    expect_law(strncmp(ending.err, "program: ", 9) == 0, "program: ...", "%s", ending.err);
    expect_law(strstr(ending.err, words) != NULL, words, "%s", ending.err);
    expect_law(strstr(ending.err, "\nTry 'program --help'.\n") != NULL, "Try 'program --help'.",
               "%s", ending.err);
}

START_TEST(the_exit_codes_are_0_1_and_2)
{
    expect_int(EXIT_DONE, 0);
    expect_int(EXIT_COULD_NOT, 1);
    expect_int(EXIT_WRONG_USAGE, 2);
}
END_TEST

START_TEST(values_are_read_and_operands_come_last)
{
    char *argv[] = {"program",        "-s",          "64x48",     "scene.nff",
                    "--output=a.png", "--eye=1,2,3", "--flat",    "--right=4,5,6",
                    "--up",           "7,8,9",       "--forward", "1,1,1",
                    "--distance",     "-4",          "--width",   "5",
                    "--height=6",     NULL};
    optind = 0;
    int first = options_read(17, argv, options, usage);
    expect_int(first, 16);
    expect_text(argv[first], "scene.nff");
    expect_pair(values.size.width, values.size.height, 64, 48, 0);
    expect_text(values.out, "a.png");
    ck_assert(values.flat);
    expect_camera(values.camera,
                  (Camera){.origin = vec3_of(1, 2, 3),
                           .right = vec3_of(4, 5, 6),
                           .up = vec3_of(7, 8, 9),
                           .forward = vec3_of(1, 1, 1),
                           .distance = -4,
                           .width = 5,
                           .height = 6},
                  0);
}
END_TEST

START_TEST(behind_two_dashes_all_are_operands)
{
    char *argv[] = {"program", "-s", "8x6", "--", "--flat", NULL};
    optind = 0;
    expect_int(options_read(5, argv, options, usage), 4);
    ck_assert(!values.flat);
}
END_TEST

START_TEST(no_options_are_fine)
{
    char *argv[] = {"program", NULL};
    optind = 0;
    expect_int(options_read(1, argv, options, usage), 1);
    ck_assert_ptr_null(values.out);
}
END_TEST

START_TEST(help_names_every_option_and_is_no_error)
{
    const char *const asked[] = {"--help", "-h", "--hel"};
    const char *const named[] = {"Usage: program [-o FILE.png] [SCENE.nff]\n",
                                 "Casts a scene.",
                                 "-o, --output FILE.png",
                                 "where the picture goes",
                                 "-s, --size WIDTHxHEIGHT",
                                 "--flat",
                                 "--eye X,Y,Z",
                                 "--height H",
                                 "-h, --help"};
    for (int i = 0; i < 3; i++) {
        Ending ending = ENDING(asked[i]);
        expect_int(ending.status, EXIT_DONE);
        expect_text(ending.err, "");
        for (size_t k = 0; k < sizeof named / sizeof named[0]; k++)
            expect_law(strstr(ending.out, named[k]) != NULL, named[k], "%s", ending.out);
    }
}
END_TEST

START_TEST(unknown_options_are_named)
{
    expect_wrong_usage(ENDING("--sideways"), "'--sideways'");
    expect_wrong_usage(ENDING("scene.nff", "--sideways=3"), "'--sideways=3'");
    expect_wrong_usage(ENDING("-x"), "'-x'");
    expect_wrong_usage(ENDING("-xo"), "'-x'");
    expect_wrong_usage(ENDING("-\xc3\xa9"), "'-?'");
    expect_wrong_usage(ENDING("--\x1b[2J"), "'--?[2J'");
}
END_TEST

START_TEST(a_missing_value_is_said_of_its_option)
{
    expect_wrong_usage(ENDING("-s"), "-s: a value is missing");
    expect_wrong_usage(ENDING("--size"), "--size: a value is missing");
    expect_wrong_usage(ENDING("scene.nff", "-o"), "-o: a value is missing");
}
END_TEST

START_TEST(a_value_where_none_is_taken_is_refused)
{
    expect_wrong_usage(ENDING("--flat=yes"), "'--flat=yes'");
    expect_wrong_usage(ENDING("--help=yes"), "'--help=yes'");
}
END_TEST

START_TEST(a_bad_value_is_shown_with_what_was_expected)
{
    expect_wrong_usage(ENDING("-s", "10"), "--size: '10', expected WIDTHxHEIGHT: how large it is");
    expect_wrong_usage(ENDING("--size=0x0"), "--size: '0x0', expected WIDTHxHEIGHT");
    expect_wrong_usage(ENDING("--eye", "1,2"), "--eye: '1,2', expected X,Y,Z");
    expect_wrong_usage(ENDING("--width=nan"), "--width: 'nan', expected W");
    expect_wrong_usage(ENDING("-o", ""), "--output: '', expected FILE.png");
    expect_wrong_usage(ENDING("-s", "\x1b[31m"), "--size: '?[31m'");
}
END_TEST

START_TEST(what_a_program_finds_wrong_itself_ends_alike)
{
    FILE *err = tmpfile();
    ck_assert_ptr_nonnull(err);
    fflush(NULL);
    pid_t child = fork();
    if (child == 0) {
        dup2(fileno(err), STDERR_FILENO);
        options_wrong("program", "%d scenes, expected one", 2);
    }
    int status;
    char words[200];
    ck_assert_int_eq(waitpid(child, &status, 0), child);
    take_all(err, words, sizeof words);
    expect_int(WEXITSTATUS(status), EXIT_WRONG_USAGE);
    expect_text(words, "program: 2 scenes, expected one\nTry 'program --help'.\n");
}
END_TEST

static void list_tests(void)
{
    tests_of("options_read");
    test(the_exit_codes_are_0_1_and_2);
    test(values_are_read_and_operands_come_last);
    test(behind_two_dashes_all_are_operands);
    test(no_options_are_fine);
    test(help_names_every_option_and_is_no_error);
    test(unknown_options_are_named);
    test(a_missing_value_is_said_of_its_option);
    test(a_value_where_none_is_taken_is_refused);
    test(a_bad_value_is_shown_with_what_was_expected);
    tests_of("options_wrong");
    test(what_a_program_finds_wrong_itself_ends_alike);
}

OF_STEM(list_tests)
