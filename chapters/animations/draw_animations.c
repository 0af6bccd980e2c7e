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
#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

enum { MOST_WORDS = 40, MOST_RUNNING = 64, TURNS = 90, TURN_RATE = 15, MOST_BYTES = 3000000 };

typedef struct {
    char s[1200];
} Path;

// An animation in one theme.
typedef struct {
    const char *name, *theme;
    const char *suffix; // "" or "-dark"
    Path source;        // the script, or the turntable's scene
    char *
        *cast; // the program that casts a frame of the turntable, and its arguments; NULL: gnuplot
    int frames, rate;
    char stops[4000];
    bool drawn_now;
} Animation;

static const char *folder;
static pid_t running[MOST_RUNNING];
static volatile sig_atomic_t told_to_end;

__attribute__((format(printf, 1, 2))) static Path path_of(const char *format, ...)
{
    Path path;
    va_list list;
    va_start(list, format);
    vsnprintf(path.s, sizeof path.s, format, list);
    va_end(list);
    return path;
}

__attribute__((format(printf, 1, 2), noreturn)) static void fail(const char *format, ...)
{
    va_list list;
    va_start(list, format);
    vfprintf(stderr, format, list);
    va_end(list);
    exit(1);
}

static Path home_of(const Animation *a)
{
    return path_of("%s/%s", folder, a->name);
}

static Path frames_of(const Animation *a)
{
    return path_of("%s/%s/frames%s", folder, a->name, a->suffix);
}

static Path frame_path(const Animation *a, int frame)
{
    return path_of("%s/%04d.png", frames_of(a).s, frame);
}

// What a process draws, before it is whole; and the file with what it says.
static Path new_frame(const Animation *a, int frame)
{
    return path_of("%s/.%04d", frames_of(a).s, frame);
}

// ---- files ------------------------------------------------------------------------------------

// Whether it is there, and was written after the other.
static bool is_newer(Path path, Path other)
{
    struct stat a, b;
    if (stat(path.s, &a) != 0 || stat(other.s, &b) != 0)
        return false;
    return a.st_mtim.tv_sec != b.st_mtim.tv_sec ? a.st_mtim.tv_sec > b.st_mtim.tv_sec
                                                : a.st_mtim.tv_nsec > b.st_mtim.tv_nsec;
}

static bool is_same(Path one, Path other)
{
    FILE *a = fopen(one.s, "r"), *b = fopen(other.s, "r");
    bool same = a != NULL && b != NULL;
    for (int c = 0; same && c != EOF;)
        same = (c = getc(a)) == getc(b);
    if (a != NULL)
        fclose(a);
    if (b != NULL)
        fclose(b);
    return same;
}

static void copy(Path from, Path to)
{
    Path new = path_of("%s.new", to.s);
    FILE *in = fopen(from.s, "r"), *out = fopen(new.s, "w");
    if (in == NULL || out == NULL)
        fail("%s cannot be copied to %s: %s\n", from.s, to.s, strerror(errno));
    for (int c; (c = getc(in)) != EOF;)
        putc(c, out);
    fclose(in);
    if (fclose(out) != 0 || rename(new.s, to.s) != 0)
        fail("%s cannot be written: %s\n", to.s, strerror(errno));
}

static void make_folder(Path path)
{
    if (mkdir(path.s, 0777) != 0 && errno != EEXIST)
        fail("%s cannot be made: %s\n", path.s, strerror(errno));
}

// The frames or steps from a number on, left by an earlier run that had more of them.
static void remove_from(const char *in, const char *format, int number)
{
    char name[40];
    do
        snprintf(name, sizeof name, format, number++);
    while (remove(path_of("%s/%s", in, name).s) == 0);
}

// ---- processes --------------------------------------------------------------------------------

static void end_all(void)
{
    for (int i = 0; i < MOST_RUNNING; i++)
        if (running[i] > 0)
            kill(running[i], SIGTERM);
    while (waitpid(-1, NULL, 0) > 0 || errno == EINTR)
        ;
    exit(1);
}

static void note_end(int signal_number)
{
    (void)signal_number;
    told_to_end = 1;
}

// Starts a program; what it says goes into a file.
static pid_t start(char *const arguments[], Path said)
{
    pid_t process = fork();
    if (process < 0)
        fail("a process cannot be started: %s\n", strerror(errno));
    if (process > 0)
        return process;
    int in = open("/dev/null", O_RDONLY),
        out = open(said.s, O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
    dup2(in, STDIN_FILENO);
    dup2(out, STDOUT_FILENO);
    dup2(out, STDERR_FILENO);
    execvp(arguments[0], arguments);
    _exit(127);
}

static void show(Path said)
{
    FILE *file = fopen(said.s, "r");
    for (int c; file != NULL && (c = getc(file)) != EOF;)
        fputc(c, stderr);
    if (file != NULL)
        fclose(file);
    remove(said.s);
}

static bool run(char *const arguments[], Path said)
{
    int status = -1;
    running[0] = start(arguments, said);
    while (waitpid(running[0], &status, 0) < 0 && !told_to_end)
        ;
    if (told_to_end)
        end_all();
    running[0] = 0;
    return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

static bool has_program(const char *name)
{
    char all[4096];
    snprintf(all, sizeof all, "%s", getenv("PATH") != NULL ? getenv("PATH") : "");
    for (char *in = strtok(all, ":"); in != NULL; in = strtok(NULL, ":"))
        if (access(path_of("%s/%s", in, name).s, X_OK) == 0)
            return true;
    return false;
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
static pid_t begin_frame(const Animation *a, int frame)
{
    Path new = new_frame(a, frame), said = path_of("%s.said", new.s);
    if (a->cast == NULL) {
        Path settings =
            path_of("format='png'; theme='%s'; step=%d; output='%s'", a->theme, frame, new.s);
        char *const arguments[] = {"gnuplot", "-d", "-e", settings.s, (char *)a->source.s, NULL};
        return start(arguments, said);
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
    return start(arguments, said);
}

static void end_frame(Animation *a, int frame, int status)
{
    Path new = path_of("%s.png", new_frame(a, frame).s);
    Path said = path_of("%s.said", new_frame(a, frame).s);
    a->drawn_now = true;
    if (WIFEXITED(status) && WEXITSTATUS(status) == 0 &&
        rename(new.s, frame_path(a, frame).s) == 0) {
        remove(said.s);
        return;
    }
    show(said);
    remove(new.s);
    fprintf(stderr, "%s%s: frame %d of %d was not drawn\n", a->name, a->suffix, frame, a->frames);
    end_all();
}

static void show_progress(const Animation *a, int done)
{
    if (isatty(STDERR_FILENO))
        fprintf(stderr, done < a->frames ? "\r  %s%s: frame %d of %d " : "\r\033[K", a->name,
                a->suffix, done, a->frames);
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
    long at_a_time = sysconf(_SC_NPROCESSORS_ONLN);
    int most = at_a_time < 1 ? 1 : at_a_time > MOST_RUNNING ? MOST_RUNNING : (int)at_a_time;
    int frames[MOST_RUNNING], begun = 0, done = 0;
    make_folder(in);
    if (!is_same(a->source, source))
        copy(a->source, source);
    while (done < a->frames) {
        show_progress(a, done);
        for (int i = 0; i < most; i++) {
            while (running[i] == 0 && begun < a->frames && is_drawn(a, begun + 1, source)) {
                begun++;
                done++;
            }
            if (running[i] != 0 || begun == a->frames)
                continue;
            frames[i] = ++begun;
            running[i] = begin_frame(a, begun);
        }
        int status;
        pid_t process = done < a->frames ? waitpid(-1, &status, 0) : 0;
        if (told_to_end)
            end_all();
        for (int i = 0; i < most && process > 0; i++)
            if (running[i] == process) {
                running[i] = 0;
                end_frame(a, frames[i], status);
                done++;
            }
    }
    show_progress(a, done);
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

// ---- videos -----------------------------------------------------------------------------------

// Frames are RGB, and videos have the colours of HDTV. A story rests on its last frame; a turntable
// does not.
#define VIDEO                                                                                      \
    "scale=out_color_matrix=bt709:out_range=tv:flags=accurate_rnd+full_chroma_int,format=yuv420p"
#define HDTV "-colorspace", "bt709", "-color_primaries", "bt709", "-color_trc", "bt709"

// A format, the encoder of ffmpeg that it takes, and how it is asked.
typedef struct {
    const char *name, *encoder;
    const char *filter, *turning_filter; // of a story, and of a turntable
    char *settings[MOST_WORDS];
} Format;

static const Format formats[] = {
    {"mp4",
     "libx264",
     "tpad=stop_mode=clone:stop_duration=2," VIDEO,
     VIDEO,
     {"-preset", "slow", "-crf", "24", "-g", "60", "-movflags", "+faststart", HDTV}},
    {"webm",
     "libvpx-vp9",
     "tpad=stop_mode=clone:stop_duration=2," VIDEO,
     VIDEO,
     {"-crf", "36", "-b:v", "0", "-deadline", "good", "-cpu-used", "3", "-g", "60", HDTV}},
    // A turntable in 256 colours has no two equal pixels, so it is smaller and slower.
    {"gif",
     "gif",
     "split[a][b];[a]palettegen=max_colors=128[p];[b][p]paletteuse=dither=none:diff_mode=rectangle",
     "fps=5,scale=480:-1:flags=lanczos,split[a][b];[a]palettegen=max_colors=128[p];"
     "[b][p]paletteuse=dither=none",
     {"-loop", "0", "-final_delay", "200"}},
    {"apng",
     "apng",
     "tpad=stop_mode=clone:stop_duration=2",
     "fps=5,scale=480:-1:flags=lanczos,split[a][b];[a]palettegen=max_colors=128[p];"
     "[b][p]paletteuse=dither=none",
     {"-plays", "0", "-pred", "mixed"}},
    {"png", NULL, NULL, NULL, {NULL}},
    {NULL, NULL, NULL, NULL, {NULL}}};

typedef struct {
    int count;
    char *words[MOST_WORDS];
} List;

static const Format *format_named(const char *name)
{
    const Format *format = formats;
    while (format->name != NULL && strcmp(format->name, name) != 0)
        format++;
    if (format->name == NULL) {
        fprintf(stderr, "FORMAT=%s: expected mp4, webm, gif, apng or png\n", name);
        exit(2);
    }
    return format;
}

static pid_t begin_video(const Animation *a, const Format *format, Path new, Path said)
{
    Path frames = path_of("%s/%%04d.png", frames_of(a).s), rate = path_of("%d", a->rate);
    Path filter = path_of("%s", a->cast != NULL ? format->turning_filter : format->filter);
    char *arguments[3 * MOST_WORDS] = {"ffmpeg",
                                       "-nostdin",
                                       "-v",
                                       "error",
                                       "-y",
                                       "-framerate",
                                       rate.s,
                                       "-i",
                                       frames.s,
                                       "-filter_complex",
                                       filter.s,
                                       "-an",
                                       "-c:v",
                                       (char *)format->encoder,
                                       "-threads",
                                       "1",
                                       "-map_metadata",
                                       "-1",
                                       "-fflags",
                                       "+bitexact",
                                       "-flags:v",
                                       "+bitexact"};
    int count = 0;
    while (arguments[count] != NULL)
        count++;
    for (int i = 0; format->settings[i] != NULL; i++)
        arguments[count++] = format->settings[i];
    arguments[count++] = "-f";
    arguments[count++] = (char *)format->name;
    arguments[count++] = new.s;
    return start(arguments, said);
}

// A video is made again if a frame is newer, or this program is.
static bool is_made(const Animation *a, Path video)
{
    for (int frame = 1; frame <= a->frames; frame++)
        if (!is_newer(video, frame_path(a, frame)))
            return false;
    return is_newer(video, path_of("chapters/animations/draw_animations.c"));
}

static Path new_video(const Animation *a, const Format *format)
{
    return path_of("%s/.new%s.%s", home_of(a).s, a->suffix, format->name);
}

static void end_video(const Animation *a, const Format *format, int status)
{
    Path video = path_of("%s/%s%s.%s", home_of(a).s, a->name, a->suffix, format->name);
    Path new = new_video(a, format), said = path_of("%s.said", new.s);
    struct stat about;
    if (!WIFEXITED(status) || WEXITSTATUS(status) != 0 || rename(new.s, video.s) != 0) {
        show(said);
        remove(new.s);
        fprintf(stderr, "%s: ffmpeg could not make it\n", video.s);
        end_all();
    }
    remove(said.s);
    if (stat(video.s, &about) == 0 && about.st_size > MOST_BYTES)
        fprintf(stderr, "%s: %.1f MB is more than %.0f; fewer frames or colours make it smaller\n",
                video.s, (double)about.st_size / 1e6, MOST_BYTES / 1e6);
}

// All wanted formats at the same time, because each is made by one thread.
static void make_videos(const Animation *a, const List *wanted)
{
    const Format *made[MOST_RUNNING];
    int count = 0;
    for (int i = 0; i < wanted->count && count < MOST_RUNNING; i++) {
        const Format *format = format_named(wanted->words[i]);
        Path video = path_of("%s/%s%s.%s", home_of(a).s, a->name, a->suffix, format->name);
        if (format->encoder == NULL || is_made(a, video))
            continue;
        Path new = new_video(a, format);
        made[count] = format;
        running[count++] = begin_video(a, format, new, path_of("%s.said", new.s));
    }
    for (int left = count; left > 0;) {
        int status;
        if (isatty(STDERR_FILENO))
            fprintf(stderr, "\r\033[K  %s%s: video %d of %d ", a->name, a->suffix, count - left + 1,
                    count);
        pid_t process = waitpid(-1, &status, 0);
        if (told_to_end)
            end_all();
        for (int i = 0; i < count && process > 0; i++)
            if (running[i] == process) {
                running[i] = 0;
                end_video(a, made[i], status);
                left--;
            }
    }
    if (count > 0 && isatty(STDERR_FILENO))
        fprintf(stderr, "\r\033[K");
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

static bool has_encoder(const char *encoder)
{
    Path said = path_of("%s/.encoders", folder), line, wanted = path_of(" %s ", encoder);
    char *const arguments[] = {"ffmpeg", "-hide_banner", "-encoders", NULL};
    bool has = false, asked = run(arguments, said);
    FILE *file = fopen(said.s, "r");
    while (asked && file != NULL && fgets(line.s, sizeof line.s, file) != NULL)
        has = has || strstr(line.s, wanted.s) != NULL;
    if (file != NULL)
        fclose(file);
    remove(said.s);
    return has;
}

// Nothing is begun that cannot be finished.
static void check_programs(const List *wanted, bool turntable)
{
    if (!turntable && !has_program("gnuplot")) {
        fprintf(stderr, "gnuplot is missing, so no frame is drawn: 'make setup' installs it.\n");
        exit(3);
    }
    for (int i = 0; i < wanted->count; i++) {
        const Format *format = format_named(wanted->words[i]);
        if (format->encoder == NULL)
            continue;
        bool ffmpeg = has_program("ffmpeg");
        if (ffmpeg && has_encoder(format->encoder))
            continue;
        fprintf(
            stderr,
            ffmpeg
                ? "ffmpeg has no %s here, so no %s can be made: 'make setup FOR=lecturer' installs "
                  "it.\nFORMAT=png makes the numbered pictures alone.\n"
                : "ffmpeg is missing, so no video can be made: 'make setup FOR=lecturer' installs "
                  "it.\nFORMAT=png makes the numbered pictures alone.\n",
            format->encoder, format->name);
        exit(3);
    }
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
    folder = argv[1];
    make_folder(path_of("%s", folder));
    struct sigaction action = {.sa_handler = note_end};
    sigaction(SIGINT, &action, NULL);
    sigaction(SIGTERM, &action, NULL);
    sigaction(SIGHUP, &action, NULL);
    setenv("LC_ALL", "C.UTF-8", 1);
    if (turntable)
        make_folder(path_of("%s/%s", folder, argv[3]));
    check_programs(&wanted, turntable);
    static Animation a;
    if (turntable) {
        a = (Animation){.name = argv[3],
                        .theme = "light",
                        .suffix = "",
                        .source = path_of("%s", argv[4]),
                        .cast = argv + 5,
                        .frames = turns(),
                        .rate = TURN_RATE};
        make_animation(&a, &wanted);
        return 0;
    }
    for (int i = 2; i < argc; i++)
        for (int t = 0; t < themes.count; t++) {
            a = (Animation){.name = argv[i],
                            .theme = themes.words[t],
                            .suffix = strcmp(themes.words[t], "dark") == 0 ? "-dark" : "",
                            .source = path_of("%s/%s/%s.gp", folder, argv[i], argv[i])};
            make_animation(&a, &wanted);
        }
    return 0;
}
