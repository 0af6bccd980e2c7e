// fuzz.c - two libFuzzer targets, which tests/proof/fuzz.sh builds and runs.
//
// SCENES: any bytes are a scene, or are refused with a message.
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

static void check_color(Color color)
{
    for (int i = 0; i < 3; i++)
        MUST(color[i] >= 0 && color[i] <= 1);
}

static void check_viewpoint(const Viewpoint *view)
{
    MUST(vec3_is_finite(view->from) && vec3_is_finite(view->at) && vec3_is_finite(view->up));
    MUST(view->angle > 0 && view->angle < 180);
    MUST(view->resolution.width >= 1 && view->resolution.width <= IMAGE_MAX_SIDE);
    MUST(view->resolution.height >= 1 && view->resolution.height <= IMAGE_MAX_SIDE);
}

// A scene with this number of lines: each holds at most one thing.
static void check_scene(const Scene *scene, int lines)
{
    check_viewpoint(&scene->view);
    check_color(scene->background);
    MUST(scene->sphere_count >= 0 && scene->light_count >= 0 && scene->surface_count >= 1);
    MUST(scene->sphere_count + scene->light_count + scene->surface_count - 1 + 6 <= lines);
    int surface = 0;
    for (int i = 0; i < scene->sphere_count; i++) {
        const Sphere *sphere = &scene->spheres[i];
        MUST(vec3_is_finite(sphere->center));
        MUST(isfinite(sphere->radius) && sphere->radius > 0);
        MUST(sphere->surface >= surface && sphere->surface < scene->surface_count);
        surface = sphere->surface;
    }
    for (int i = 0; i < scene->surface_count; i++) {
        const Surface *s = &scene->surfaces[i];
        check_color(s->color);
        MUST(isfinite(s->diffuse) && isfinite(s->specular) && isfinite(s->shine));
        MUST(isfinite(s->transmittance) && isfinite(s->refraction));
    }
    for (int i = 0; i < scene->light_count; i++) {
        MUST(vec3_is_finite(scene->lights[i].position));
        check_color(scene->lights[i].color);
    }
}

// One line of plain characters, that begins so. Returns what follows.
static const char *check_line(const char *text, const char *start)
{
    MUST(strncmp(text, start, strlen(start)) == 0);
    MUST(strlen(text) > strlen(start));
    for (const char *c = text; *c != '\0'; c++)
        MUST(*c >= ' ' && *c <= '~');
    return text + strlen(start);
}

static void check_message(const Message *message, int lines)
{
    const char *number = check_line(message->text, "fuzz.nff:");
    MUST(*number >= '1' && *number <= '9');
    char *end;
    long line = strtol(number, &end, 10);
    MUST(line <= lines);
    MUST(strncmp(end, ": ", 2) == 0 && strlen(end) > 2);
}

static bool is_empty(const Scene *scene)
{
    return scene->spheres == NULL && scene->surfaces == NULL && scene->lights == NULL &&
           scene->sphere_count == 0 && scene->surface_count == 0 && scene->light_count == 0;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    if (size > LONGEST_INPUT)
        return -1; // not for the corpus
    int lines = 1;
    for (size_t i = 0; i < size; i++)
        lines += data[i] == '\n';

    // Some C libraries refuse an empty buffer; a file without bytes is then /dev/null.
    FILE *file =
        size > 0 ? fmemopen((void *)(uintptr_t)data, size, "rb") : fopen("/dev/null", "rb");
    if (file == NULL)
        return 0;
    Scene scene;
    Message message, warning;
    memset(&message, 0, sizeof message);
    memset(&warning, 0xff, sizeof warning);
    bool good = scene_read(file, "fuzz.nff", &scene, &message, &warning);
    fclose(file);
    if (good)
        check_scene(&scene, lines);
    else
        check_message(&message, lines);
    if (warning.text[0] != '\0')
        check_line(warning.text, "fuzz.nff: warning: ");
    if (!good)
        MUST(is_empty(&scene));
    scene_free(&scene);
    MUST(is_empty(&scene));
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
