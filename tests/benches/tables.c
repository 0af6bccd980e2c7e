// tables.c - the numbers of the bench in chapter 08's lesson: from CSV files to Markdown tables.
//
// Usage: tables FOLDER [LESSON.md], or tables -f THREADS FOLDER
//
// Reads rays-per-second.csv, ratios.csv and shaded-pictures.csv of the folder, each if it is there,
// and prints their tables. With a lesson, it prints the lesson instead, with each table in place of
// the lesson's table that has the same first cell. With -f it prints the data of the figure
// (engines.gp): rays a second by so many threads.
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_ROWS = 4000, MOST_FIELDS = 16, MOST_NAMES = 64, MOST_TABLES = 8, LINE = 2000 };

typedef struct {
    char text[LINE];
    const char *fields[MOST_FIELDS];
} Record;

typedef struct {
    Record *rows;
    int count;
} Csv;

// Names in the order in which they were added.
typedef struct {
    const char *names[MOST_NAMES];
    int count;
} Names;

static FILE *out; // where tables go

// ---- reading ----------------------------------------------------------------------------------

static void stop(const char *path, const char *why)
{
    fprintf(stderr, "tables: %s: %s\n", path, why);
    exit(1);
}

// Without its first line, which has the names of the fields. None if there is no such file.
static Csv csv_read(const char *folder, const char *name)
{
    char path[LINE];
    snprintf(path, sizeof path, "%s/%s", folder, name);
    Csv csv = {calloc(MOST_ROWS, sizeof(Record)), 0};
    FILE *file = fopen(path, "r");
    if (csv.rows == NULL)
        stop(path, "no memory");
    for (bool header = true; file != NULL && csv.count < MOST_ROWS; header = false) {
        Record *record = &csv.rows[csv.count];
        if (fgets(record->text, LINE, file) == NULL)
            break;
        record->text[strcspn(record->text, "\n")] = '\0';
        char *field = record->text;
        for (int i = 0; i < MOST_FIELDS; i++) {
            record->fields[i] = field;
            field += strcspn(field, ",");
            if (*field == ',')
                *field++ = '\0';
        }
        csv.count += !header;
    }
    if (file != NULL)
        fclose(file);
    return csv;
}

static double number(const Record *record, int field)
{
    return atof(record->fields[field]);
}

static void add_name(Names *names, const char *name)
{
    for (int i = 0; i < names->count; i++)
        if (strcmp(names->names[i], name) == 0)
            return;
    if (names->count < MOST_NAMES)
        names->names[names->count++] = name;
}

static Names names_in(const Csv *csv, int field)
{
    Names names = {.count = 0};
    for (int i = 0; i < csv->count; i++)
        add_name(&names, csv->rows[i].fields[field]);
    return names;
}

// The row with these fields; NULL if there is none.
typedef struct {
    int field;
    const char *is;
} Key;

static const Record *find(const Csv *csv, const Key *keys, int count)
{
    for (int i = 0; i < csv->count; i++) {
        bool fits = true;
        for (int k = 0; k < count; k++)
            fits &= strcmp(csv->rows[i].fields[keys[k].field], keys[k].is) == 0;
        if (fits)
            return &csv->rows[i];
    }
    return NULL;
}

// ---- cells ------------------------------------------------------------------------------------

// Three digits: 1094, 48.9, 0.0102.
static void put_number(double x)
{
    int digits = x > 0 ? 2 - (int)floor(log10(x) + 1e-9) : 0;
    fprintf(out, "%.*f", digits > 0 ? digits : 0, x);
}

static void put_cell(double x)
{
    fprintf(out, " | ");
    if (x > 0)
        put_number(x);
}

static void begin_table(const char *first)
{
    fprintf(out, "| %s", first);
}

static void end_head(int columns)
{
    fprintf(out, " |\n|---");
    for (int i = 0; i < columns; i++)
        fprintf(out, "|---:");
    fprintf(out, "|\n");
}

static void begin_means(const char *what, const char *threads)
{
    fprintf(out, "| **%s, %s thread%s**", what, threads, strcmp(threads, "1") == 0 ? "" : "s");
}

// The geometric mean of all positive values.
typedef struct {
    double log_sum;
    int count;
} Mean;

static void mean_add(Mean *mean, double x)
{
    if (x > 0) {
        mean->log_sum += log(x);
        mean->count++;
    }
}

static double mean_of(Mean mean)
{
    return mean.count > 0 ? exp(mean.log_sum / mean.count) : 0;
}

// ---- engines ----------------------------------------------------------------------------------

// Fields of engines.csv and ratios.csv.
enum {
    SCENE,
    SPHERES,
    ENGINE,
    THREADS,
    WIDTH,
    HEIGHT,
    ROUNDS,
    RATE,
    LOW,
    HIGH,
    BUILD,
    FRAME,
    TIMES
};
enum { R_SCENE, R_ENGINE, R_THREADS, R_PEER, R_ROUNDS, R_TIMES, R_LOW, R_HIGH };

static const struct {
    const char *engine, *title;
} titles[] = {
    {"embree-8", "Embree, its spheres"},
    {"embree-16", "Embree, its spheres"},
    {"embree-user", "Embree, 16-lane callback"},
    {"povray", "POV-Ray"},
    {"tachyon", "Tachyon"},
};

// NULL for an engine of the lesson.
static const char *title_of(const char *engine)
{
    for (size_t i = 0; i < sizeof titles / sizeof titles[0]; i++)
        if (strcmp(titles[i].engine, engine) == 0)
            return titles[i].title;
    return NULL;
}

// Embree's two kinds of packets are one column: the better one.
static Names columns_of(const Csv *csv, int field)
{
    Names columns = {.count = 0};
    for (int i = 0; i < csv->count; i++) {
        const char *engine = csv->rows[i].fields[field], *title = title_of(engine);
        add_name(&columns, title != NULL ? title : engine);
    }
    return columns;
}

static void put_head(const char *first, const Names *columns)
{
    begin_table(first);
    for (int i = 0; i < columns->count; i++) {
        bool ours = strchr("abcdefghijklmnopqrstuvwxyz", columns->names[i][0]) != NULL;
        fprintf(out, ours ? " | `%s`" : " | %s", columns->names[i]);
    }
    end_head(columns->count);
}

static const Record *best_of(const Csv *csv, const char *scene, const char *column,
                             const char *threads)
{
    const Record *best = NULL;
    for (int i = 0; i < csv->count; i++) {
        const Record *row = &csv->rows[i];
        const char *title = title_of(row->fields[ENGINE]);
        if (strcmp(row->fields[SCENE], scene) == 0 && strcmp(row->fields[THREADS], threads) == 0 &&
            strcmp(title != NULL ? title : row->fields[ENGINE], column) == 0 &&
            (best == NULL || number(row, RATE) > number(best, RATE)))
            best = row;
    }
    return best;
}

static double largest_width(const Csv *csv)
{
    double width = 0;
    for (int i = 0; i < csv->count; i++)
        width = fmax(width, number(&csv->rows[i], WIDTH));
    return width;
}

static void engine_tables(const Csv *csv)
{
    const Names scenes = names_in(csv, SCENE), threads = names_in(csv, THREADS);
    const Names columns = columns_of(csv, ENGINE);
    put_head("millions of rays a second", &columns);
    for (int s = 0; s < scenes.count; s++) {
        fprintf(out, "| %s", scenes.names[s]);
        for (int c = 0; c < columns.count; c++) {
            const Record *row = best_of(csv, scenes.names[s], columns.names[c], threads.names[0]);
            put_cell(row == NULL ? 0 : 1e-6 * number(row, RATE));
        }
        fprintf(out, " |\n");
    }
    for (int t = 0; t < threads.count; t++) {
        begin_means("times Embree", threads.names[t]);
        for (int c = 0; c < columns.count; c++) {
            Mean mean = {0};
            for (int s = 0; s < scenes.count; s++) {
                const Record *row =
                    best_of(csv, scenes.names[s], columns.names[c], threads.names[t]);
                mean_add(&mean, row == NULL ? 0 : number(row, TIMES));
            }
            put_cell(mean_of(mean));
        }
        fprintf(out, " |\n");
    }

    // A slow engine cast a smaller picture, so its time says nothing here.
    fprintf(out, "\n");
    put_head("milliseconds to the first picture", &columns);
    for (int s = 0; s < scenes.count; s++) {
        const Record *any = find(csv, (Key[]){{SCENE, scenes.names[s]}}, 1);
        if (number(any, SPHERES) < 50000)
            continue;
        fprintf(out, "| %s", scenes.names[s]);
        for (int c = 0; c < columns.count; c++) {
            const Record *row = best_of(csv, scenes.names[s], columns.names[c], threads.names[0]);
            bool whole = row != NULL && number(row, WIDTH) == largest_width(csv);
            put_cell(whole ? number(row, FRAME) : 0);
        }
        fprintf(out, " |\n");
    }
    fprintf(out, "\n");
}

// 'bins' beside each peer: the median of the ratios, and their quartiles.
static void ratio_table(const Csv *csv)
{
    const Names scenes = names_in(csv, R_SCENE), threads = names_in(csv, R_THREADS);
    const Names seen = names_in(csv, R_PEER);
    begin_table("`bins`, times as fast as");
    for (int p = 0; p < seen.count; p++)
        fprintf(out, " | %s%s", title_of(seen.names[p]),
                strcmp(seen.names[p], "embree-8") == 0    ? ", 8 rays at a time"
                : strcmp(seen.names[p], "embree-16") == 0 ? ", 16 rays at a time"
                                                          : "");
    end_head(seen.count);
    for (int s = 0; s < scenes.count; s++) {
        fprintf(out, "| %s", scenes.names[s]);
        for (int p = 0; p < seen.count; p++) {
            const Record *row = find(csv,
                                     (Key[]){{R_SCENE, scenes.names[s]},
                                             {R_ENGINE, "bins"},
                                             {R_THREADS, threads.names[0]},
                                             {R_PEER, seen.names[p]}},
                                     4);
            put_cell(row == NULL ? 0 : number(row, R_TIMES));
            if (row != NULL && number(row, R_ROUNDS) > 1) {
                fprintf(out, " (");
                put_number(number(row, R_LOW));
                fprintf(out, " to ");
                put_number(number(row, R_HIGH));
                fprintf(out, ")");
            }
        }
        fprintf(out, " |\n");
    }
    for (int t = 0; t < threads.count; t++) {
        begin_means("mean", threads.names[t]);
        for (int p = 0; p < seen.count; p++) {
            Mean mean = {0};
            for (int i = 0; i < csv->count; i++)
                if (strcmp(csv->rows[i].fields[R_ENGINE], "bins") == 0 &&
                    strcmp(csv->rows[i].fields[R_THREADS], threads.names[t]) == 0 &&
                    strcmp(csv->rows[i].fields[R_PEER], seen.names[p]) == 0)
                    mean_add(&mean, number(&csv->rows[i], R_TIMES));
            put_cell(mean_of(mean));
        }
        fprintf(out, " |\n");
    }
    fprintf(out, "\n");
}

// ---- shaded pictures --------------------------------------------------------------------------

// Fields of shaded.csv.
enum {
    S_SCENE,
    S_SPHERES,
    S_RENDERER,
    S_SAMPLES,
    S_THREADS,
    S_ROUNDS,
    S_MS,
    S_TIMES,
    S_LEAST,
    S_MOST
};

static const Record *shaded_row(const Csv *csv, const char *scene, const char *renderer,
                                const char *samples, const char *threads)
{
    return find(
        csv,
        (Key[]){
            {S_SCENE, scene}, {S_RENDERER, renderer}, {S_SAMPLES, samples}, {S_THREADS, threads}},
        4);
}

static void shaded_table(const Csv *csv)
{
    const Names scenes = names_in(csv, S_SCENE), renderers = names_in(csv, S_RENDERER);
    const Names samples = names_in(csv, S_SAMPLES), threads = names_in(csv, S_THREADS);
    begin_table("milliseconds for a shaded picture");
    for (int n = 0; n < samples.count; n++) {
        fprintf(out, " | %s sample%s", samples.names[n],
                strcmp(samples.names[n], "1") == 0 ? "" : "s");
        for (int k = 1; k < renderers.count; k++)
            fprintf(out, " | %s, times",
                    strcmp(renderers.names[k], "povray") == 0 ? "POV-Ray" : "Embree");
    }
    end_head(samples.count * renderers.count);
    for (int s = 0; s < scenes.count; s++) {
        fprintf(out, "| %s", scenes.names[s]);
        for (int n = 0; n < samples.count; n++)
            for (int k = 0; k < renderers.count; k++) {
                const Record *row = shaded_row(csv, scenes.names[s], renderers.names[k],
                                               samples.names[n], threads.names[0]);
                put_cell(row == NULL ? 0 : number(row, k == 0 ? S_MS : S_TIMES));
                if (k > 0 && row != NULL && number(row, S_ROUNDS) > 1) {
                    fprintf(out, " (");
                    put_number(number(row, S_LEAST));
                    fprintf(out, " to ");
                    put_number(number(row, S_MOST));
                    fprintf(out, ")");
                }
            }
        fprintf(out, " |\n");
    }
    for (int t = 0; t < threads.count; t++) {
        begin_means("mean", threads.names[t]);
        for (int n = 0; n < samples.count; n++)
            for (int k = 0; k < renderers.count; k++) {
                Mean mean = {0};
                for (int s = 0; s < scenes.count; s++) {
                    const Record *row = shaded_row(csv, scenes.names[s], renderers.names[k],
                                                   samples.names[n], threads.names[t]);
                    mean_add(&mean, k == 0 || row == NULL ? 0 : number(row, S_TIMES));
                }
                put_cell(mean_of(mean));
            }
        fprintf(out, " |\n");
    }
    fprintf(out, "\n");
}

// ---- the figure -------------------------------------------------------------------------------

// For each engine two blocks of data: the scenes with random spheres, and the others.
static void print_figure_data(const Csv *csv, const char *threads)
{
    const Names engines = names_in(csv, ENGINE);
    printf("threads = %s\nengines = \"", threads);
    for (int e = 0; e < engines.count; e++)
        printf(e == 0 ? "%s" : " %s", engines.names[e]);
    printf("\"\n");
    for (int e = 0; e < engines.count; e++)
        for (int random = 0; random < 2; random++) {
            printf("$engine%d_%d << END\n", e + 1, random);
            for (int i = 0; i < csv->count; i++) {
                const Record *row = &csv->rows[i];
                if (strcmp(row->fields[ENGINE], engines.names[e]) == 0 &&
                    strcmp(row->fields[THREADS], threads) == 0 &&
                    (strncmp(row->fields[SCENE], "random", 6) == 0) == random)
                    printf("%s %s %s %s\n", row->fields[SPHERES], row->fields[RATE],
                           row->fields[LOW], row->fields[HIGH]);
            }
            printf("END\n");
        }
}

// ---- the lesson -------------------------------------------------------------------------------

// The length of a table's first cell, with the bars around it.
static size_t first_cell(const char *table)
{
    return table[0] == '|' ? 2 + strcspn(table + 1, "|\n") : 0;
}

// The table in the text that has the same first cell; NULL if there is none. Tables end with a line
// that does not begin with '|'.
static const char *table_like(const char *text, const char *like)
{
    bool inside = false;
    while (*text != '\0') {
        if (*text == '|' && !inside && first_cell(text) == first_cell(like) &&
            strncmp(text, like, first_cell(like)) == 0)
            return text;
        inside = *text == '|';
        text += strcspn(text, "\n");
        text += *text == '\n';
    }
    return NULL;
}

static size_t table_length(const char *table)
{
    const char *end = table;
    while (*end == '|') {
        end += strcspn(end, "\n");
        end += *end == '\n';
    }
    return (size_t)(end - table);
}

// A table may be new in the lesson: then its place is after the paragraph with these words.
static const struct {
    const char *table, *paragraph;
} places[] = {
    {"| `bins`, times as fast as |", "`make bench-engines PEERS=1`"},
    {"| milliseconds for a shaded picture |", "`make bench-shaded PEERS=1`"},
};

// The end of that paragraph in the lesson; NULL if there is none.
static const char *new_place(const char *lesson, const char *table)
{
    for (size_t i = 0; i < sizeof places / sizeof places[0]; i++)
        if (strncmp(table, places[i].table, strlen(places[i].table)) == 0) {
            const char *words = strstr(lesson, places[i].paragraph);
            const char *end = words == NULL ? NULL : strstr(words, "\n\n");
            return end == NULL ? NULL : end + 1;
        }
    return NULL;
}

// Replaces a table of the lesson; returns false if it has no place.
static bool replace_table(char *lesson, size_t room, const char *table)
{
    const size_t length = table_length(table);
    const char *old = table_like(lesson, table);
    const char *at = old != NULL ? old : new_place(lesson, table);
    if (at == NULL)
        return false;
    const size_t before = (size_t)(at - lesson), gone = old != NULL ? table_length(old) : 0;
    const size_t blank = old == NULL; // a line between the paragraph and the table
    if (strlen(lesson) + blank + length >= room)
        return false;
    memmove(lesson + before + blank + length, at + gone, strlen(at + gone) + 1);
    lesson[before] = '\n';
    memcpy(lesson + before + blank, table, length);
    return true;
}

static void print_lesson(const char *path, const char *tables)
{
    static char lesson[1 << 20];
    FILE *file = fopen(path, "r");
    if (file == NULL)
        stop(path, "cannot be read");
    lesson[fread(lesson, 1, sizeof lesson - 1, file)] = '\0';
    fclose(file);
    for (const char *table = tables; *table == '|';) {
        if (!replace_table(lesson, sizeof lesson, table)) {
            fprintf(stderr, "tables: %s has no table that begins with %.*s\n", path,
                    (int)first_cell(table), table);
            exit(1);
        }
        table += table_length(table);
        table += *table == '\n';
    }
    fputs(lesson, stdout);
}

int main(int argc, char **argv)
{
    const bool figure = argc == 4 && strcmp(argv[1], "-f") == 0;
    if (argc != 2 && argc != 3 && !figure) {
        fprintf(stderr, "Usage: tables FOLDER [LESSON.md], or tables -f THREADS FOLDER\n");
        return 2;
    }
    const char *folder = figure ? argv[3] : argv[1];
    Csv engines = csv_read(folder, "rays-per-second.csv"), ratios = csv_read(folder, "ratios.csv");
    Csv shaded = csv_read(folder, "shaded-pictures.csv");
    if ((figure || argc == 3) && engines.count == 0)
        stop(folder, "rays-per-second.csv has no numbers");
    char *tables = NULL;
    size_t size = 0;
    out = open_memstream(&tables, &size);
    if (out == NULL)
        stop(folder, "no memory");
    if (engines.count > 0)
        engine_tables(&engines);
    if (ratios.count > 0)
        ratio_table(&ratios);
    if (shaded.count > 0)
        shaded_table(&shaded);
    fclose(out);
    if (figure)
        print_figure_data(&engines, argv[2]);
    else if (argc == 3)
        print_lesson(argv[2], tables);
    else
        printf("%s", tables);
    free(tables);
    free(engines.rows);
    free(ratios.rows);
    free(shaded.rows);
    return 0;
}
