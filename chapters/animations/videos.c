// videos.c - videos of frames that are drawn, by ffmpeg.
//
// One thread, and no dates and versions in the file: the same frames give the same bytes.
#include "chapters/animations/animation.h"
#include "common/progress.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

enum { MOST_BYTES = 3000000 };

// Frames are RGB, and videos have the colours of HDTV. A story rests on its last frame; a turntable
// does not.
#define VIDEO                                                                                      \
    "scale=out_color_matrix=bt709:out_range=tv:flags=accurate_rnd+full_chroma_int,format=yuv420p"
// 128 colours, of which flat drawings need few. A turntable has no two equal pixels, so it has
// fewer pictures, smoothed a little, in so few colours that it has less than 3 MB. Its frames may
// be PNGs of two kinds, with and without a palette, so all become RGB.
#define IN_COLORS(most)                                                                            \
    "split[a][b];[a]palettegen=max_colors=" most                                                   \
    "[p];[b][p]paletteuse=dither=none:diff_mode=rectangle"
#define SMALLER "scale,format=rgb24,fps=3,median=radius=1,"
#define HDTV "-colorspace", "bt709", "-color_primaries", "bt709", "-color_trc", "bt709"

// A format, the encoder of ffmpeg that it takes, and how it is asked.
typedef struct {
    const char *name, *encoder;
    const char *filter, *turning_filter; // of a story, and of a turntable
    char *settings[MOST_WORDS];
    char *turning[8]; // settings that a turntable has beside these: 6 s in less than 3 MB
} Format;

static const Format formats[] = {
    {"mp4",
     "libx264",
     "tpad=stop_mode=clone:stop_duration=2," VIDEO,
     VIDEO,
     {"-preset", "slow", "-crf", "24", "-g", "60", "-movflags", "+faststart", HDTV},
     {"-maxrate", "3400k", "-bufsize", "3400k"}},
    {"webm",
     "libvpx-vp9",
     "tpad=stop_mode=clone:stop_duration=2," VIDEO,
     VIDEO,
     {"-crf", "36", "-b:v", "0", "-deadline", "good", "-cpu-used", "3", "-g", "60", HDTV},
     {"-b:v", "3200k"}},
    {"gif",
     "gif",
     IN_COLORS("128"),
     SMALLER IN_COLORS("28"),
     {"-loop", "0", "-final_delay", "200"},
     {"-final_delay", "-1"}},
    {"apng",
     "apng",
     IN_COLORS("128"),
     SMALLER IN_COLORS("64"),
     {"-plays", "0", "-final_delay", "2"},
     {"-final_delay", "1/3"}},
    {"png", NULL, NULL, NULL, {NULL}, {NULL}},
    {NULL, NULL, NULL, NULL, {NULL}, {NULL}}};

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

static void begin_video(int place, const Animation *a, const Format *format, Path new)
{
    Path frames = path_of("%s/%%04d.png", frames_of(a).s), rate = path_of("%d", a->rate);
    Path filter = path_of("%s", a->cast != NULL ? format->turning_filter : format->filter);
    char *arguments[3 * MOST_WORDS] = {"ffmpeg",
                                       "-nostdin",
                                       "-v",
                                       "error",
                                       "-y",
                                       "-reinit_filter",
                                       "0",
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
    for (int i = 0; a->cast != NULL && format->turning[i] != NULL; i++)
        arguments[count++] = format->turning[i];
    arguments[count++] = "-f";
    arguments[count++] = (char *)format->name;
    arguments[count++] = new.s;
    start(place, arguments, path_of("%s.said", new.s));
}

// A video is made again if a frame is newer, or this program is.
static bool is_made(const Animation *a, Path video)
{
    for (int frame = 1; frame <= a->frames; frame++)
        if (!is_newer(video, frame_path(a, frame)))
            return false;
    return is_newer(video, path_of("chapters/animations/videos.c"));
}

static Path new_video(const Animation *a, const Format *format)
{
    return path_of("%s/.new%s.%s", home_of(a).s, a->suffix, format->name);
}

static void end_video(const Animation *a, const Format *format, bool succeeded)
{
    Path video = path_of("%s/%s%s.%s", home_of(a).s, a->name, a->suffix, format->name);
    Path new = new_video(a, format), said = path_of("%s.said", new.s);
    struct stat about;
    if (!succeeded || rename(new.s, video.s) != 0) {
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

void make_videos(const Animation *a, const List *wanted)
{
    const Format *made[MOST_WORDS];
    char what[100];
    int count = 0, done = 0;
    for (int i = 0; i < wanted->count; i++) {
        const Format *format = format_named(wanted->words[i]);
        Path video = path_of("%s/%s%s.%s", home_of(a).s, a->name, a->suffix, format->name);
        if (format->encoder != NULL && !is_made(a, video))
            made[count++] = format;
    }
    snprintf(what, sizeof what, "%s%s, videos", a->name, a->suffix);
    Progress progress = progress_begin(what, count, true);
    // All at the same time, because each is made by one thread.
    for (int i = 0; i < count; i++)
        begin_video(i, a, made[i], new_video(a, made[i]));
    while (done < count) {
        bool succeeded;
        progress_show(&progress, done);
        int place = wait_for_one(&succeeded);
        end_video(a, made[place], succeeded);
        done++;
    }
    progress_end(&progress);
}

// ---- what they take ---------------------------------------------------------------------------

static bool has_encoder(const char *encoder, const char *folder)
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

void check_formats(const List *wanted, const char *folder)
{
    for (int i = 0; i < wanted->count; i++) {
        const Format *format = format_named(wanted->words[i]);
        if (format->encoder == NULL)
            continue;
        bool ffmpeg = has_program("ffmpeg");
        if (ffmpeg && has_encoder(format->encoder, folder))
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
