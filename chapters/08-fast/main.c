// main.c - chapter 08: the same picture, faster.
//
// Casts a scene as chapter 06 does, by an engine of one's choice, and says how many rays a second.
#include "chapters/06-ray-casting/command.h"
#include "chapters/06-ray-casting/needs.h"
#include "chapters/08-fast/clock.h"
#include "chapters/08-fast/engine.h"
#include "common/text.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static bool option_engine(const char *text, void *into)
{
    // Hierarchies take longer to build than bins to cast, and a picture is cast once.
    *(const Engine **)into = engine_named(strcmp(text, "auto") == 0 ? "bins" : text);
    return *(const Engine **)into != NULL;
}

static bool option_threads(const char *text, void *into)
{
    char *end;
    long threads = strtol(text, &end, 10);
    *(int *)into = (int)threads;
    return end != text && *end == '\0' && threads >= 1 && threads <= 256;
}

static void list_engines(void)
{
    printf("08-fast: the same picture, faster\n\n");
    for (const Engine *engine = engines; engine->name != NULL; engine++)
        printf("  %-8s %s\n", engine->name, engine->idea);
    printf("\n");
}

int main(int argc, char **argv)
{
    Command command = {0};
    const Engine *engine = engine_named("bins");
    int threads = 1;
    const Option options[] = {
        COMMAND_OPTIONS(command),
        {"engine", 'e', "NAME", option_engine, &engine,
         "plain, object, bvh, packet, tiles, bins (auto)"},
        {"threads", 't', "N", option_threads, &threads, "at the same time, 1 to 256 (1)"},
        {0}};
    Usage usage = {
        "[OPTION]... [SCENE.nff]",
        "Casts a scene, flat, by an engine. Without arguments: which there are, and the\n"
        "deck's three spheres."};
    int first = options_read(argc, argv, options, usage);
    if (argc - first > 1)
        options_wrong(argv[0], "%d scenes, expected one", argc - first);
    command.scene_path = argv[first];

    static Drawing drawing;
    if (!picture_needs_are_met(IMAGE_ORDER) ||
        !drawing_begin(&drawing, argv[0], &command, "chapters/06-ray-casting/three-spheres.nff"))
        return EXIT_COULD_NOT;
    if (argc == 1)
        list_engines();
    double began = clock_seconds(), built = began;
    Work work = {&drawing.scene, drawing.camera, &drawing.image, threads, &built};
    Message message;
    if (!engine->cast(&work, &message)) {
        fprintf(stderr, "%s: %s\n", argv[0], message.text);
        return EXIT_COULD_NOT;
    }
    double took = clock_seconds() - built;
    if (built > began)
        fprintf(stderr, "%s: built in %s ms\n", engine->name,
                number_text_to(1e3 * (built - began), 3).s);
    Resolution size = drawing.image.size;
    fprintf(stderr, "%s: %d x %d rays among %d spheres in %s ms, %s million a second\n",
            engine->name, size.width, size.height, drawing.scene.sphere_count,
            number_text_to(1e3 * took, 3).s,
            number_text_to(1e-6 * size.width * size.height / took, 3).s);
    int status = drawing_end(&drawing);
    if (status == EXIT_DONE && command.output == NULL)
        printf("%s\n", drawing.output);
    return status;
}
