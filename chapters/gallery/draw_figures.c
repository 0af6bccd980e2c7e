// draw_figures.c - has gnuplot draw scripts of figures: every format, theme, shape and step wanted.
//
//   draw_figures FOLDER NAME...
//   draw_figures --one FOLDER NAME     FOLDER/NAME.gp as FOLDER/NAME.svg alone, light
//
// Each figure has a folder: FOLDER/NAME/NAME.gp becomes
// FOLDER/NAME/NAME[-4x3][-stepN][-dark].FORMAT. What has been drawn from the same script is left
// alone. In the environment: FORMAT, THEME, SHAPE (lists with commas), STEPS (1: also a picture for
// each step). Pictures appear whole or not at all; the same script gives the same bytes. Exit
// status: 1 if something could not be drawn, 2 wrong usage, 3 no gnuplot.
#include "chapters/gallery/latex_picture.h"
#include "chapters/gallery/svg_picture.h"
#include "common/progress.h"

#include <dirent.h>
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

enum { MOST_WORDS = 8, MOST_NAMES = 500, ALL_STEPS = 1000 };

typedef struct {
    char s[1200];
} Path;

typedef struct {
    const char *words[MOST_WORDS];
    int count;
} List;

// A picture to be drawn, by a process of its own.
typedef struct {
    const char *name;
    char output[200];
    const char *format, *theme, *shape;
    int step;
    pid_t process;
    int said; // the reading end of a pipe
} Job;

typedef struct {
    const char *name;
    bool failed;
} Drawing;

static const char *folder;
static bool only_one; // --one: no folder for each figure
static Path work;     // a folder for what is not whole yet
static Drawing drawings[MOST_NAMES];
static int drawing_count;
static Job *jobs;
static int job_count, job_room;
static bool something_failed;
static char *words_said; // messages for the end
static size_t words_size;
static FILE *words;
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

static void could_not(const char *what)
{
    perror(what);
    exit(1);
}

// NAME/, or nothing if there is no folder for each figure.
static Path home_of(const char *name)
{
    return path_of("%s%s", only_one ? "" : name, only_one ? "" : "/");
}

// FOLDER/NAME/, with its slash.
static Path folder_of(const char *name)
{
    return path_of("%s/%s", folder, home_of(name).s);
}

// ---- files --------------------------------------------------------------------------------------

static bool exists(Path path)
{
    return access(path.s, F_OK) == 0;
}

static bool is_newer(Path path, Path other)
{
    struct stat a, b;
    if (stat(path.s, &a) != 0 || stat(other.s, &b) != 0)
        return false;
    return a.st_mtim.tv_sec != b.st_mtim.tv_sec ? a.st_mtim.tv_sec > b.st_mtim.tv_sec
                                                : a.st_mtim.tv_nsec > b.st_mtim.tv_nsec;
}

// All of a file, for freeing; "" if it cannot be read.
static char *text_of(Path path, size_t *size)
{
    char *text = NULL, part[4096];
    FILE *copy = open_memstream(&text, size), *file = fopen(path.s, "rb");
    if (copy == NULL)
        could_not("memory");
    for (size_t n; file != NULL && (n = fread(part, 1, sizeof part, file)) > 0;)
        fwrite(part, 1, n, copy);
    if (file != NULL)
        fclose(file);
    fclose(copy);
    return text;
}

static bool write_text(Path path, const char *text, size_t size)
{
    FILE *file = fopen(path.s, "wb");
    bool written = file != NULL && fwrite(text, 1, size, file) == size;
    return (file == NULL || fclose(file) == 0) && written;
}

static bool is_same(Path one, Path other)
{
    size_t a_size, b_size;
    char *a = text_of(one, &a_size), *b = text_of(other, &b_size);
    bool same = exists(other) && a_size == b_size && memcmp(a, b, a_size) == 0;
    free(a);
    free(b);
    return same;
}

static void remove_folder(const char *path)
{
    DIR *open = opendir(path);
    for (struct dirent *entry; open != NULL && (entry = readdir(open)) != NULL;) {
        if (strcmp(entry->d_name, ".") == 0 || strcmp(entry->d_name, "..") == 0)
            continue;
        Path inside = path_of("%s/%s", path, entry->d_name);
        if (unlink(inside.s) != 0)
            remove_folder(inside.s);
    }
    if (open != NULL)
        closedir(open);
    rmdir(path);
}

static void remove_work(void)
{
    if (work.s[0] != '\0')
        remove_folder(work.s);
}

// ---- what is wanted -----------------------------------------------------------------------------

// The words of a variable, which may be these, up to NULL.
static List wanted(const char *variable, const char *by_default, const char *const *allowed)
{
    static char texts[4][200];
    static int used;
    List list = {.count = 0};
    const char *given = getenv(variable);
    snprintf(texts[used], sizeof *texts, "%s",
             given != NULL && *given != '\0' ? given : by_default);
    char *rest = texts[used++];
    for (char *word; (word = strtok_r(rest, ", ", &rest)) != NULL || list.count == 0;) {
        int i = 0;
        while (word != NULL && allowed[i] != NULL && strcmp(allowed[i], word) != 0)
            i++;
        if (word == NULL || allowed[i] == NULL || list.count == MOST_WORDS) {
            fprintf(stderr, "make figures: %s=%s: expected", variable,
                    word == NULL ? "nothing" : word);
            for (i = 0; allowed[i] != NULL; i++)
                fprintf(stderr, "%s %s", i == 0 ? "" : ",", allowed[i]);
            fprintf(stderr, "\n");
            exit(2);
        }
        list.words[list.count++] = allowed[i];
    }
    return list;
}

static bool has_word(const List *list, const char *word)
{
    for (int i = 0; i < list->count; i++)
        if (strcmp(list->words[i], word) == 0)
            return true;
    return false;
}

static bool has_program(const char *name)
{
    const char *path = getenv("PATH");
    char *copy = strdup(path != NULL ? path : ""), *rest = copy;
    bool found = false;
    for (char *part; !found && (part = strtok_r(rest, ":", &rest)) != NULL;)
        found = access(path_of("%s/%s", part, name).s, X_OK) == 0;
    free(copy);
    return found;
}

static char *output_of(const char *command, size_t *size)
{
    char *text = NULL, part[4096];
    FILE *copy = open_memstream(&text, size), *pipe = popen(command, "r");
    if (copy == NULL || pipe == NULL)
        could_not(command);
    for (size_t n; (n = fread(part, 1, sizeof part, pipe)) > 0;)
        fwrite(part, 1, n, copy);
    pclose(pipe);
    fclose(copy);
    return text;
}

// Without a font cairo leaves out all text without a message: then a letter leaves no mark.
static bool has_font(void)
{
    static const char *const letters[] = {"W", ""};
    size_t size, sizes[2];
    char *fonts = output_of("fc-list 2>/dev/null", &size), *pictures[2];
    free(fonts);
    if (size > 0)
        return true;
    for (int i = 0; i < 2; i++)
        pictures[i] = output_of(path_of("gnuplot -d -e \"set terminal pngcairo size 60,30; "
                                        "set label '%s' at 0,0; plot [-1:1] [-1:1] 2\"",
                                        letters[i])
                                    .s,
                                &sizes[i]);
    bool differ = sizes[0] != sizes[1] || memcmp(pictures[0], pictures[1], sizes[0]) != 0;
    free(pictures[0]);
    free(pictures[1]);
    return differ;
}

// ---- one picture --------------------------------------------------------------------------------

// gnuplot's messages, with the lines of the layout: gnuplot counts those of the script. For a
// command on several lines it names the last line and a place in it: the text of that place is
// shown.
static void complain(FILE *out, const char *name, Path said)
{
    Path script = path_of("%s%s.gp", folder_of(name).s, name), layout = {""};
    char line[4000], before[4000] = "", near[100] = "";
    int number = 0, first = 0, last = 0;
    bool found = false;
    FILE *file = fopen(script.s, "r");
    for (number = 1; file != NULL && fgets(line, sizeof line, file) != NULL; number++)
        if (strcmp(line, "# ---- the layout\n") == 0)
            first = number;
        else if (number < 4)
            sscanf(line, "layout_file = \"%1100[^\"]", layout.s);
    if (file != NULL)
        fclose(file);
    if (layout.s[0] != '\0' && (file = fopen(layout.s, "r")) != NULL) {
        while (fgets(line, sizeof line, file) != NULL)
            last++;
        fclose(file);
    }
    size_t size;
    char *all = text_of(said, &size), *rest = all;
    for (char *at; (at = strsep(&rest, "\n")) != NULL;) {
        const char *points = at + strspn(at, " "), *words_of_line = strstr(at, "line ");
        int end = 0;
        if (strcmp(points, "^") == 0) {
            size_t column = strlen(at);
            snprintf(near, sizeof near, "%.60s", before + (column > 30 ? column - 31 : 0));
        } else if (words_of_line != NULL &&
                   sscanf(words_of_line, "line %d: %n", &number, &end) == 1 && end > 0) {
            int line_of_layout = number - first - 1;
            if (layout.s[0] != '\0' && line_of_layout > 0)
                fprintf(out, "%s:%d", layout.s, line_of_layout < last ? line_of_layout : last);
            else
                fprintf(out, "%s:%d", script.s, number);
            fprintf(out, ": gnuplot: %s\n", words_of_line + end);
            if (near[0] != '\0')
                fprintf(out, "    near: %s\n", near);
            near[0] = '\0';
            found = true;
        }
        snprintf(before, sizeof before, "%s", at);
    }
    free(all);
    if (found)
        return;
    fprintf(out, "%s: gnuplot %s\n", script.s, size == 0 ? "crashes" : "says:");
    file = fopen(said.s, "r");
    while (file != NULL && fgets(line, sizeof line, file) != NULL)
        fprintf(out, "  %s", line);
    if (file != NULL)
        fclose(file);
}

static int run(char *const *arguments, const char *in_folder, const char *said)
{
    pid_t process = fork();
    if (process == 0) {
        int out = open(said, O_WRONLY | O_CREAT | O_TRUNC, 0666);
        if (out < 0 || dup2(out, STDOUT_FILENO) < 0 || dup2(out, STDERR_FILENO) < 0 ||
            (in_folder != NULL && chdir(in_folder) != 0))
            _exit(126);
        execvp(arguments[0], arguments);
        _exit(127);
    }
    int status = -1;
    while (process > 0 && waitpid(process, &status, 0) < 0 && errno == EINTR)
        ;
    return status;
}

static bool make_svg(Path path, Path in_words)
{
    size_t size, new_size, words_length;
    char *svg = text_of(path, &size), *text = text_of(in_words, &words_length), *new = NULL;
    const char *description = split_words(text);
    FILE *out = open_memstream(&new, &new_size);
    if (out == NULL)
        could_not("memory");
    write_svg_picture(out, svg, text, description, NULL);
    fclose(out);
    bool made = write_text(path, new, new_size);
    free(svg);
    free(text);
    free(new);
    return made;
}

// The date of making, by another of the same length: a PDF says where in it things are.
static bool undate(Path path)
{
    static const char key[] = "CreationDate (D:", date[] = "19700101000000";
    size_t size;
    char *pdf = text_of(path, &size);
    for (size_t i = 0; i + sizeof key + sizeof date < size; i++)
        if (memcmp(pdf + i, key, sizeof key - 1) == 0 &&
            strspn(pdf + i + sizeof key - 1, "0123456789") >= sizeof date - 1)
            memcpy(pdf + i + sizeof key - 1, date, sizeof date - 1);
    bool written = write_text(path, pdf, size);
    free(pdf);
    return written;
}

static bool move(Path from, Path to)
{
    return rename(from.s, to.s) == 0;
}

static bool make_latex(Path path, Path in_words, Path graphics)
{
    size_t size, words_length, new_size;
    char *drawn = text_of(path, &size), *text = text_of(in_words, &words_length), *new = NULL;
    FILE *out = open_memstream(&new, &new_size);
    if (out == NULL)
        could_not("memory");
    bool made = size > 0 && write_latex_picture(out, drawn, text, graphics.s);
    fclose(out);
    made = made && write_text(path, new, new_size);
    free(drawn);
    free(text);
    free(new);
    return made;
}

// Makes the wanted files of those that gnuplot has drawn in the folder 'in'.
static bool finish(const Job *job, Path in)
{
    Path drawn = path_of("%s/%s.%s", in.s, job->output, job->format);
    Path in_words = path_of("%s%s.txt", folder_of(job->name).s, job->name);
    if (strcmp(job->format, "txt") == 0) {
        size_t size;
        char *text = text_of(drawn, &size);
        tidy_words(text);
        bool written = exists(drawn) && write_text(drawn, text, strlen(text));
        free(text);
        return written &&
               move(path_of("%s/words", in.s), path_of("%s/.drawn/%s.words", folder, job->name)) &&
               move(path_of("%s/steps", in.s), path_of("%s/.drawn/%s.steps", folder, job->name));
    }
    if (strcmp(job->format, "svg") == 0)
        return exists(drawn) && make_svg(drawn, in_words);
    if (strcmp(job->format, "tex") == 0) {
        // LaTeX draws its text over a PDF, which needs another name than the figure's own PDF.
        Path graphics = path_of("%s/%s-tex.pdf", in.s, job->output);
        return move(path_of("%s/%s.pdf", in.s, job->output), graphics) && undate(graphics) &&
               make_latex(drawn, in_words, path_of("%s-tex", job->output));
    }
    if (strcmp(job->format, "pdf") == 0)
        return exists(drawn) && undate(drawn);
    return exists(drawn);
}

static bool move_all(Path in, const char *name)
{
    static const char *const ours[] = {".", "..", "words", "steps"};
    DIR *open = opendir(in.s);
    bool moved = open != NULL;
    for (struct dirent *entry; open != NULL && (entry = readdir(open)) != NULL;) {
        bool skip = false;
        for (int i = 0; i < 4; i++)
            skip = skip || strcmp(entry->d_name, ours[i]) == 0;
        if (!skip)
            moved = move(path_of("%s/%s", in.s, entry->d_name),
                         path_of("%s%s", folder_of(name).s, entry->d_name)) &&
                    moved;
    }
    if (open != NULL)
        closedir(open);
    return moved;
}

static bool draw_one(const Job *job, FILE *out)
{
    Path in = path_of("%s/%s.%s", work.s, job->output, job->format);
    Path said = path_of("%s/words", in.s), known = path_of("%s/.drawn/%s.words", folder, job->name);
    Path settings = path_of("format='%s'; theme='%s'; shape='%s'; step=%d; output='%s'",
                            job->format, job->theme, job->shape, job->step, job->output);
    Path script = path_of("../../../%s%s.gp", home_of(job->name).s, job->name);
    if (mkdir(in.s, 0777) != 0) {
        fprintf(out, "%s: %s\n", in.s, strerror(errno));
        return false;
    }
    char *absolute = realpath(in.s, NULL);
    Path said_there = path_of("%s/words", absolute != NULL ? absolute : in.s);
    free(absolute);
    char *const arguments[] = {
        "gnuplot", "-d", "-e", settings.s, script.s, "-e", "set print \"steps\"; print steps",
        NULL};
    bool drawn = run(arguments, in.s, said_there.s) == 0;
    struct stat about;
    // A warning about the data comes with each format; it is printed once.
    if (!drawn || (stat(said.s, &about) == 0 && about.st_size > 0 && !is_same(said, known)))
        complain(out, job->name, said);
    if (!drawn)
        return false;
    if (finish(job, in) && move_all(in, job->name))
        return true;
    fprintf(out, "%s%s.%s could not be made of what gnuplot drew\n", folder_of(job->name).s,
            job->output, job->format);
    return false;
}

// ---- all pictures -------------------------------------------------------------------------------

// Adds a picture, unless it is newer than the copy of the script that it was drawn from.
static void add_job(const char *name, const char *output, const char *format, const char *theme,
                    const char *shape, int step)
{
    Path picture = path_of("%s%s.%s", folder_of(name).s, output, format);
    if (is_newer(picture, path_of("%s/.drawn/%s.gp", folder, name)) &&
        is_newer(picture, path_of("chapters/gallery/draw_figures.c")) &&
        is_newer(picture, path_of("chapters/gallery/latex_picture.c")) &&
        is_newer(picture, path_of("chapters/gallery/svg_picture.c")))
        return;
    if (job_count == job_room) {
        job_room = 2 * job_room + 100;
        jobs = realloc(jobs, sizeof *jobs * (size_t)job_room);
        if (jobs == NULL)
            could_not("memory");
    }
    jobs[job_count] =
        (Job){.name = name, .format = format, .theme = theme, .shape = shape, .step = step};
    snprintf(jobs[job_count++].output, sizeof jobs->output, "%s", output);
}

static void begin(Job *job)
{
    int ends[2];
    if (pipe(ends) != 0)
        could_not("a pipe");
    fcntl(ends[0], F_SETFD, FD_CLOEXEC);
    fcntl(ends[1], F_SETFD, FD_CLOEXEC);
    job->process = fork();
    if (job->process < 0)
        could_not("a process for gnuplot");
    if (job->process == 0) {
        FILE *out = fdopen(ends[1], "w");
        bool drawn = draw_one(job, out);
        fclose(out);
        _exit(drawn ? 0 : 1);
    }
    close(ends[1]);
    job->said = ends[0];
}

static void hear(Job *job, int status)
{
    char part[4096];
    bool spoke = false;
    for (ssize_t n; (n = read(job->said, part, sizeof part)) > 0; spoke = true)
        fwrite(part, 1, (size_t)n, words);
    close(job->said);
    job->process = -1;
    if (status == 0)
        return;
    something_failed = true;
    for (int i = 0; i < drawing_count; i++)
        if (drawings[i].name == job->name)
            drawings[i].failed = true;
    if (!spoke)
        fprintf(words, "%s%s.%s was not drawn\n", folder_of(job->name).s, job->output, job->format);
}

static void end_all(void)
{
    for (int i = 0; i < job_count; i++)
        if (jobs[i].process > 0)
            kill(jobs[i].process, SIGTERM);
    while (waitpid(-1, NULL, 0) > 0 || errno == EINTR)
        ;
    exit(1);
}

// Does the jobs, as many at a time as there are processors.
static void draw(void)
{
    long at_a_time = sysconf(_SC_NPROCESSORS_ONLN);
    int begun = 0, done = 0;
    Progress progress = progress_begin("figures", job_count, true);
    while (done < job_count) {
        for (; begun < job_count && begun - done < (at_a_time > 0 ? at_a_time : 2); begun++)
            begin(&jobs[begun]);
        int status;
        pid_t process = waitpid(-1, &status, 0);
        if (told_to_end)
            end_all();
        for (int i = 0; i < begun && process > 0; i++)
            if (jobs[i].process == process) {
                hear(&jobs[i], status);
                progress_show(&progress, ++done);
            }
    }
    progress_end(&progress);
}

static void note_end(int signal_number)
{
    (void)signal_number;
    told_to_end = 1;
}

static void prepare(void)
{
    Path drawn = path_of("%s/.drawn", folder);
    work = path_of("%s/.XXXXXX", drawn.s);
    if ((mkdir(drawn.s, 0777) != 0 && errno != EEXIST) || mkdtemp(work.s) == NULL) {
        perror(drawn.s);
        work.s[0] = '\0';
        exit(1);
    }
    atexit(remove_work);
    struct sigaction action = {.sa_handler = note_end};
    sigaction(SIGINT, &action, NULL);
    sigaction(SIGTERM, &action, NULL);
    sigaction(SIGHUP, &action, NULL);
    words = open_memstream(&words_said, &words_size);
    if (words == NULL)
        could_not("memory");
    // Numbers and letters are the same everywhere; and cairo writes its date without a zone.
    setenv("LC_ALL", "C.UTF-8", 1);
    setenv("TZ", "UTC", 1);
    setenv("SOURCE_DATE_EPOCH", "0", 1);
}

// First the figures in words, because the others contain these. Without a script there is no
// picture.
static void draw_words(char **names)
{
    for (; *names != NULL && drawing_count < MOST_NAMES; names++) {
        Path script = path_of("%s%s.gp", folder_of(*names).s, *names);
        Path copy = path_of("%s/.drawn/%s.gp", folder, *names), new = path_of("%s/new", work.s);
        if (!exists(script))
            continue;
        drawings[drawing_count++].name = *names;
        if (!is_same(script, copy)) {
            size_t size;
            char *text = text_of(script, &size);
            if (!write_text(new, text, size) || !move(new, copy))
                could_not(copy.s);
            free(text);
        }
        add_job(*names, *names, "txt", "light", "16:9", ALL_STEPS);
    }
    draw();
}

static void add_pictures(const char *name, const List *formats, const List *themes,
                         const List *shapes, int step)
{
    for (int s = 0; s < shapes->count; s++) {
        const char *shape = shapes->words[s];
        Path at = path_of("%s%s", name, strcmp(shape, "16:9") == 0 ? "" : "-4x3");
        if (step != ALL_STEPS)
            at = path_of("%s-step%d", path_of("%s", at.s).s, step);
        for (int t = 0; t < themes->count; t++) {
            bool light = strcmp(themes->words[t], "light") == 0;
            Path output = path_of("%s%s", at.s, light ? "" : "-dark");
            for (int f = 0; f < formats->count; f++)
                add_job(name, output.s, formats->words[f], themes->words[t], shape, step);
        }
    }
}

static int draw_pictures(const List *formats, const List *themes, const List *shapes, bool steps)
{
    job_count = 0;
    for (int i = 0; i < drawing_count; i++) {
        const char *name = drawings[i].name;
        if (drawings[i].failed)
            continue;
        add_pictures(name, formats, themes, shapes, ALL_STEPS);
        int count = 0;
        FILE *file = fopen(path_of("%s/.drawn/%s.steps", folder, name).s, "r");
        if (file != NULL && fscanf(file, "%d", &count) != 1)
            count = 0;
        if (file != NULL)
            fclose(file);
        for (int step = 1; steps && step <= count; step++)
            add_pictures(name, formats, themes, shapes, step);
    }
    draw();
    return job_count;
}

// Without a font there are only the formats that need none.
static void leave_out_what_needs_fonts(List *formats)
{
    List kept = {.count = 0};
    if ((!has_word(formats, "pdf") && !has_word(formats, "png")) || has_font())
        return;
    fprintf(stderr, "There is no font, so PDFs and PNGs would have no text and are not drawn: "
                    "'make setup' installs one.\n");
    for (int i = 0; i < formats->count; i++)
        if (strcmp(formats->words[i], "pdf") != 0 && strcmp(formats->words[i], "png") != 0)
            kept.words[kept.count++] = formats->words[i];
    *formats = kept;
    something_failed = true;
}

int main(int argc, char **argv)
{
    static const char *const all_formats[] = {"svg", "pdf", "png", "tex", NULL};
    static const char *const all_themes[] = {"light", "dark", NULL};
    static const char *const all_shapes[] = {"16:9", "4:3", NULL};
    static const char *const yes_or_no[] = {"0", "1", NULL};
    only_one = argc == 4 && strcmp(argv[1], "--one") == 0;
    if (argc < 3) {
        fprintf(stderr, "Usage: %s [--one] FOLDER NAME...\n", argv[0]);
        return 2;
    }
    if (only_one) {
        setenv("FORMAT", "svg", 1);
        setenv("THEME", "light", 1);
        setenv("SHAPE", "16:9", 1);
        setenv("STEPS", "0", 1);
    }
    List formats = wanted("FORMAT", "svg,pdf,png", all_formats);
    List themes = wanted("THEME", "light,dark", all_themes);
    List shapes = wanted("SHAPE", "16:9", all_shapes);
    List steps = wanted("STEPS", "0", yes_or_no);
    folder = argv[only_one ? 2 : 1];
    if (!has_program("gnuplot")) {
        fprintf(stderr,
                "gnuplot is missing, so no figure is drawn: 'make setup' installs it.\n"
                "The scripts are written: %s/%s*.gp\n",
                folder, only_one ? "" : "*/");
        return 3;
    }
    prepare();
    draw_words(argv + (only_one ? 3 : 2));
    leave_out_what_needs_fonts(&formats);
    int drawn = draw_pictures(&formats, &themes, &shapes, strcmp(steps.words[0], "1") == 0);
    fclose(words);
    fputs(words_said, stderr);
    if (something_failed)
        return 1;
    if (only_one)
        return 0;
    printf("Figures: %d as", drawing_count);
    for (int i = 0; i < formats.count; i++)
        printf(" %s", formats.words[i]);
    printf(" in %s/ (%d drawn now)\n", folder, drawn);
    return 0;
}
