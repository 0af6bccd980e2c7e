// draw_animations.c - draws the frames of animations, and makes videos of them.
//
//   draw_animations FOLDER NAME...                           of the scripts FOLDER/NAME/NAME.gp
//   draw_animations FOLDER --turn NAME SCENE.nff PROGRAM...  PROGRAM casts a frame, --turn DEGREES
//
// In the environment: FORMAT (mp4, webm, gif, apng, png), THEME (light, dark), as lists with
// commas. gnuplot draws a frame for each step of a script, FOLDER/NAME/frames[-dark]/0001.png and
// so on; the steps at which a lecturer stops are also steps[-dark]/01.png and so on; the videos are
// FOLDER/NAME/NAME[-dark].FORMAT. As many processes run as there are processors. If the script is
// the same, a frame that is there is not drawn again. ffmpeg works with one thread and writes no
// dates, so the same frames give the same bytes. Exit status: 1 if something could not be made, 2
// wrong usage, 3 a program is missing.
#include "chapters/animations/animation.h"
#include "common/progress.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { TURNS = 90, TURN_SECONDS = 6 };

Path home_of(const Animation *a)
{
    return path_of("%s/%s", a->folder, a->name);
}

Path frames_of(const Animation *a)
{
    return path_of("%s/%s/frames%s", a->folder, a->name, a->suffix);
}

Path frame_path(const Animation *a, int frame)
{
    return path_of("%s/%04d.png", frames_of(a).s, frame);
}

// What a process draws, before it is whole; and the file with what it says.
static Path new_frame(const Animation *a, int frame)
{
    return path_of("%s/.%04d", frames_of(a).s, frame);
}

// ---- frames -----------------------------------------------------------------------------------

// Asks the script how many steps it has, how fast they go, and at which a lecturer stops.
static void ask_script(Animation *a)
{
    Path said = path_of("%s/.said%s", home_of(a).s, a->suffix);
    Path words = path_of("format='txt'; output='%s/%s'", home_of(a).s, a->name);
    char *const arguments[] = {"gnuplot",
                               "-d",
                               "-e",
                               words.s,
                               a->source.s,
                               "-e",
                               "set print '-'; print steps, rate; print stops",
                               NULL};
    if (!run(arguments, said)) {
        show(said);
        fail("%s: gnuplot cannot draw it\n", a->source.s);
    }
    FILE *file = fopen(said.s, "r");
    if (file == NULL || fscanf(file, "%d %d%3999[^\n]", &a->frames, &a->rate, a->stops) < 2 ||
        a->frames < 1 || a->frames > 9999 || a->rate < 1)
        fail("%s: expected steps and a rate, both greater than 0\n", a->source.s);
    if (fscanf(file, " %3999[^\n]", a->stops) != 1)
        a->stops[0] = '\0';
    fclose(file);
    remove(said.s);
}

// It is drawn under another name, so that half a frame is never taken for one.
static void begin_frame(int place, const Animation *a, int frame)
{
    Path new = new_frame(a, frame), said = path_of("%s.said", new.s);
    if (a->cast == NULL) {
        Path settings =
            path_of("format='png'; theme='%s'; step=%d; output='%s'", a->theme, frame, new.s);
        char *const arguments[] = {"gnuplot", "-d", "-e", settings.s, (char *)a->source.s, NULL};
        start(place, arguments, said);
        return;
    }
    char *arguments[MOST_WORDS + 8];
    int count = 0;
    while (a->cast[count] != NULL && count < MOST_WORDS) {
        arguments[count] = a->cast[count];
        count++;
    }
    Path turn = path_of("%.10g", 360.0 * (frame - 1) / a->frames), file = path_of("%s.png", new.s);
    arguments[count++] = "--turn";
    arguments[count++] = turn.s;
    arguments[count++] = "-o";
    arguments[count++] = file.s;
    arguments[count++] = (char *)a->source.s;
    arguments[count] = NULL;
    start(place, arguments, said);
}

static void end_frame(Animation *a, int frame, bool succeeded)
{
    Path new = path_of("%s.png", new_frame(a, frame).s);
    Path said = path_of("%s.said", new_frame(a, frame).s);
    a->drawn_now = true;
    if (succeeded && rename(new.s, frame_path(a, frame).s) == 0) {
        remove(said.s);
        return;
    }
    show(said);
    remove(new.s);
    fprintf(stderr, "%s%s: frame %d of %d was not drawn\n", a->name, a->suffix, frame, a->frames);
    end_all();
}

static bool is_drawn(const Animation *a, int frame, Path copy_of_source)
{
    return is_newer(frame_path(a, frame), copy_of_source) &&
           (a->cast == NULL || is_newer(frame_path(a, frame), path_of("%s", a->cast[0])));
}

// Draws the frames that are missing, as many at a time as there are processors.
static void draw_frames(Animation *a)
{
    Path in = frames_of(a), source = path_of("%s/.source", in.s);
    long processors = sysconf(_SC_NPROCESSORS_ONLN);
    int most = processors < 1 ? 1 : processors > MOST_RUNNING ? MOST_RUNNING : (int)processors;
    int missing = 0, begun = 0, done = 0, frames[MOST_RUNNING];
    char what[100];
    make_folder(in);
    if (!is_same(a->source, source))
        copy(a->source, source);
    for (int frame = 1; frame <= a->frames; frame++)
        missing += !is_drawn(a, frame, source);
    snprintf(what, sizeof what, "%s%s, frames", a->name, a->suffix);
    Progress progress = progress_begin(what, missing, true);
    while (done < missing) {
        for (int place = 0; place < most; place++) {
            while (is_free(place) && begun < a->frames) {
                frames[place] = ++begun;
                if (!is_drawn(a, begun, source))
                    begin_frame(place, a, begun);
            }
        }
        bool succeeded;
        int place = wait_for_one(&succeeded);
        end_frame(a, frames[place], succeeded);
        progress_show(&progress, ++done);
    }
    progress_end(&progress);
    remove_from(in.s, "%04d.png", a->frames + 1);
}

// The frames at which a lecturer stops, numbered by themselves.
static void copy_steps(const Animation *a)
{
    Path in = path_of("%s/steps%s", home_of(a).s, a->suffix);
    int number = 0, used;
    make_folder(in);
    for (const char *rest = a->stops; sscanf(rest, "%d%n", &(int){0}, &used) == 1; rest += used) {
        int frame = atoi(rest);
        if (frame >= 1 && frame <= a->frames)
            copy(frame_path(a, frame), path_of("%s/%02d.png", in.s, ++number));
    }
    remove_from(in.s, "%02d.png", number + 1);
}

// ---- what is wanted ---------------------------------------------------------------------------

static List list_of(const char *variable, const char *otherwise)
{
    const char *text = getenv(variable);
    List list = {0};
    char *copied = strdup(text != NULL && text[0] != '\0' ? text : otherwise);
    for (char *word = strtok(copied, ", "); word != NULL && list.count < MOST_WORDS;
         word = strtok(NULL, ", "))
        list.words[list.count++] = word;
    return list;
}

// FRAMES: of a turntable.
static int turns(void)
{
    const char *text = getenv("FRAMES");
    int frames = text == NULL || text[0] == '\0' ? TURNS : atoi(text);
    if (frames < 2 || frames > 9999) {
        fprintf(stderr, "FRAMES=%s: expected a number from 2 to 9999\n", text);
        exit(2);
    }
    return frames;
}

static void make_animation(Animation *a, const List *wanted)
{
    if (a->cast == NULL)
        ask_script(a);
    draw_frames(a);
    if (a->stops[0] != '\0')
        copy_steps(a);
    make_videos(a, wanted);
    printf("  %s%s: %d frames, %.0f s%s\n", a->name, a->suffix, a->frames,
           (double)a->frames / a->rate, a->drawn_now ? "" : " (all were there)");
    fflush(stdout);
}

int main(int argc, char **argv)
{
    bool turntable = argc >= 6 && strcmp(argv[2], "--turn") == 0;
    if (argc < 3 || (argv[2][0] == '-' && !turntable)) {
        fprintf(stderr,
                "Usage: %s FOLDER NAME...\n       %s FOLDER --turn NAME SCENE.nff PROGRAM...\n",
                argv[0], argv[0]);
        return 2;
    }
    List wanted = list_of("FORMAT", "mp4,webm,gif"), themes = list_of("THEME", "light,dark");
    for (int t = 0; t < themes.count; t++)
        if (strcmp(themes.words[t], "light") != 0 && strcmp(themes.words[t], "dark") != 0) {
            fprintf(stderr, "THEME=%s: expected light or dark\n", themes.words[t]);
            return 2;
        }
    const char *folder = argv[1];
    make_folder(path_of("%s", folder));
    end_with_processes();
    setenv("LC_ALL", "C.UTF-8", 1);
    if (turntable)
        make_folder(path_of("%s/%s", folder, argv[3]));
    if (!turntable && !has_program("gnuplot")) {
        fprintf(stderr, "gnuplot is missing, so no frame is drawn: 'make setup' installs it.\n");
        return 3;
    }
    check_formats(&wanted, folder);
    static Animation a;
    if (turntable) {
        a = (Animation){.folder = folder,
                        .name = argv[3],
                        .theme = "light",
                        .suffix = "",
                        .source = path_of("%s", argv[4]),
                        .cast = argv + 5,
                        .frames = turns(),
                        .rate = turns() < TURN_SECONDS ? 1 : turns() / TURN_SECONDS};
        make_animation(&a, &wanted);
        return 0;
    }
    for (int i = 2; i < argc; i++)
        for (int t = 0; t < themes.count; t++) {
            a = (Animation){.folder = folder,
                            .name = argv[i],
                            .theme = themes.words[t],
                            .suffix = strcmp(themes.words[t], "dark") == 0 ? "-dark" : "",
                            .source = path_of("%s/%s/%s.gp", folder, argv[i], argv[i])};
            make_animation(&a, &wanted);
        }
    return 0;
}
