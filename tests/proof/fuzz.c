// fuzz.c - two libFuzzer targets, which tests/proof/fuzz.sh builds and runs.
//
// SCENES: any bytes are a scene, or are refused with a message; the sanitizers see the rest.
// Otherwise any answer and any output of a compiler or a linker are explained. An input is like the
// cases in tests/explain/cases.txt: an answer after '-- ', the compiler's words after the next line
// of that kind. The headers of the tree are read.
#include "common/scene.h"
#include "tests/explain/explain.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

// A longer input only repeats the cases of one line.
enum { LONGEST_INPUT = 1 << 14, LONGEST_LINE = 79 };

#define MUST(holds)                                                                                \
    do {                                                                                           \
        if (!(holds)) {                                                                            \
            fprintf(stderr, "%s:%d: not true: %s\n", __FILE__, __LINE__, #holds);                  \
            abort();                                                                               \
        }                                                                                          \
    } while (0)

#ifdef SCENES

// What a scene may be is tested in tests/house/common/scene.c.
int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    if (size > LONGEST_INPUT)
        return -1; // not for the corpus
    // Some C libraries refuse an empty buffer; a file without bytes is then /dev/null.
    FILE *file =
        size > 0 ? fmemopen((void *)(uintptr_t)data, size, "rb") : fopen("/dev/null", "rb");
    if (file == NULL)
        return 0;
    Scene scene;
    Message message, warning;
    bool good = scene_read(file, "fuzz.nff", &scene, &message, &warning);
    fclose(file);
    MUST(good || strncmp(message.text, "fuzz.nff:", 9) == 0);
    scene_free(&scene);
    return 0;
}

#else

// The answer, in a folder of its own. In the corpus its path is NAME.
#define NAME "01-corners.c"
static char folder[] = "/tmp/fuzz-explain-XXXXXX";
static char source[sizeof folder + sizeof NAME];

static void remove_folder(void)
{
    unlink(source);
    rmdir(folder);
}

static void write_answer(const char *text)
{
    if (source[0] == '\0') {
        MUST(mkdtemp(folder) != NULL);
        snprintf(source, sizeof source, "%s/" NAME, folder);
        atexit(remove_folder);
    }
    FILE *file = fopen(source, "w");
    MUST(file != NULL && fputs(text, file) >= 0 && fclose(file) == 0);
}

// The output with the source's path. To free.
static char *words_about_source(const char *words)
{
    char *text = NULL;
    size_t size;
    FILE *out = open_memstream(&text, &size);
    MUST(out != NULL);
    for (const char *name; (name = strstr(words, NAME)) != NULL; words = name + strlen(NAME))
        fprintf(out, "%.*s%s", (int)(name - words), words, source);
    fputs(words, out);
    MUST(fclose(out) == 0);
    return text;
}

// Plain text, in lines that fit.
static void check_said(const char *said)
{
    size_t length = 0;
    for (; *said != '\0'; said++) {
        MUST(*said == '\n' || (*said >= ' ' && *said <= '~'));
        length = *said == '\n' ? 0 : length + 1;
        MUST(length <= LONGEST_LINE);
    }
    MUST(length == 0);
}

typedef void Explainer(FILE *out, const char *path, const char *words);

// To free.
static char *said_by(Explainer *explainer, const char *words)
{
    char *said = NULL;
    size_t size;
    FILE *out = open_memstream(&said, &size);
    MUST(out != NULL);
    explainer(out, source, words);
    MUST(fclose(out) == 0);
    return said;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    if (size > LONGEST_INPUT)
        return -1; // not for the corpus
    char *text = calloc(1, size + 1);
    MUST(text != NULL);
    for (size_t i = 0; i < size; i++)
        text[i] = (char)(data[i] == '\0' ? '?' : data[i]);
    char *answer = strstr(text, "-- "), *rest = answer == NULL ? NULL : strstr(answer + 1, "\n-- ");
    if (rest != NULL) {
        *++rest = '\0';
        write_answer(answer + strcspn(answer, "\n"));
        char *words = words_about_source(rest + 1 + strcspn(rest + 1, "\n"));
        char *said = said_by(explain, words);
        check_said(said);
        free(said);
        free(said_by(explain_linker, words));
        static const char *const judged[] = {"upper_left", "upper_right"};
        free(explain_slips(source, words, "upper_left", judged, 2).help);
        free(words);
    }
    free(text);
    return 0;
}

#endif
