// plot_view.c - figures: from where they are seen, how large, and where their labels stand.
//
// What is drawn is known from the blocks (plot.c). Here it is projected onto both canvases,
// 16:9 and 4:3, as large as the labels around it allow (labels.h), and the script is told: scale,
// place, labels.
#include "common/figure/labels.h"
#include "common/figure/plot_internal.h"

#include <stdlib.h>
#include <string.h>

enum { PANELS = 9, SHAPES = 2, NAME_SIZE = 40 };
enum { HEIGHT = 540, EDGE = 10, TITLE = 76 }; // of the canvas; and the room of a slide's title
enum { MARGIN = 36 };                         // of a slide, left of its text (lecture.sty)
enum { LINE = 3, DOT = 6 };                   // how wide a line is drawn, and half a dot

static const int canvas_width[SHAPES] = {960, 720};

// What is drawn from one place to another of the world (or at one), in a panel, and moved on the
// canvas.
typedef struct {
    char block[NAME_SIZE]; // "" for what is in none
    int row, panel;
    int from_panel; // where it begins: mostly the same
    bool yours;     // beside what is right
    bool is_arrow;  // else a point, to, with a line from the one before it
    vec3 from, to;
    double radius; // of a ball
    double moved_u, moved_v;
} Mark;

typedef struct {
    char name[NAME_SIZE];
    char value[200]; // as gnuplot reads it
} Words;

typedef struct {
    Label label;
    char *text;
    char block[NAME_SIZE];
    int panel;
    int lines;          // 0: it names a place; else it begins a block of so many lines of text
    double across, up;  // where that stands
    bool pinned;        // exactly there
    double wide, high;  // its text, once it was measured; for a block of them, of that
    int number[SHAPES]; // of the label that was placed
} Wanted;

typedef struct {
    vec3 center;
    double radius;
    int panel;
} Fit;

// A growing list of anything.
typedef struct {
    void *items;
    int count, room;
} List;

// Directions of the world: to the right on the canvas, and up.
typedef struct {
    bool flat;
    vec3 u, v;
} Look;

struct PlotView {
    bool looks, apart, fills, is_held;
    int only; // the shape that is placed; SHAPES: all of them
    Look look[PANELS];
    Room room[PANELS][SHAPES];
    List clear; // where no label may be: Rooms, for one canvas and the other
    int panel;
    List marks, words, wanted, fits;
    // The block that is being written.
    const char *block;
    bool is_drawn, joins;
    double moved_u, moved_v;
    Area around[PANELS]; // how far what is moved may be outside of what has to be seen
    vec3 last;
    int row;
    // What was found, for each shape.
    double size[SHAPES][PANELS], zero_u[SHAPES][PANELS], zero_v[SHAPES][PANELS];
    Area seen[SHAPES][PANELS]; // what has to be seen
    Area over[SHAPES][PANELS]; // by how much labels are outside of it
    Labels *labels[SHAPES];
};

// Room for one more, at the end of the list.
static void *add(List *list, size_t size)
{
    if (list->count == list->room) {
        list->room = 2 * list->room + 16;
        list->items = realloc(list->items, (size_t)list->room * size);
        if (list->items == NULL)
            abort();
    }
    char *item = (char *)list->items + (size_t)list->count++ * size;
    memset(item, 0, size);
    return item;
}

PlotView *plot_view_new(void)
{
    PlotView *view = calloc(1, sizeof *view);
    if (view == NULL)
        abort();
    view->panel = 1;
    view->only = SHAPES;
    for (int i = 0; i < PANELS; i++)
        for (int shape = 0; shape < SHAPES; shape++)
            view->room[i][shape] = (Room){0.03, 0.97, 0.04, 1 - (double)(TITLE + DOT) / HEIGHT};
    return view;
}

void plot_view_free(PlotView *view)
{
    Wanted *wanted = view->wanted.items;
    for (int i = 0; i < view->wanted.count; i++)
        free(wanted[i].text);
    free(view->clear.items);
    free(view->marks.items);
    free(view->words.items);
    free(view->wanted.items);
    free(view->fits.items);
    for (int shape = 0; shape < SHAPES; shape++)
        if (view->labels[shape] != NULL)
            labels_free(view->labels[shape]);
    free(view);
}

// ---- what the figure says -----------------------------------------------------------------------

// At first for all panels, then for this one and those after it.
static void look(PlotView *view, Look look)
{
    for (int i = view->looks ? view->panel : 0; i < PANELS; i++)
        view->look[i] = look;
    view->looks = true;
}

// The layout looks along the right directions (NAME_x and so on).
static vec3 right_direction(const Plot *plot, const char *name, vec3 yours)
{
    static const char axes[] = "xyz";
    vec3 right = yours;
    for (int i = 0; i < 3; i++) {
        char key[40];
        const char *value;
        snprintf(key, sizeof key, "%s_%c", name, axes[i]);
        if (plot_right_value(plot, key, &value) > 0)
            right[i] = strtod(value, NULL);
    }
    return right;
}

void plot_look(Plot *plot, vec3 right, vec3 up, vec3 forward, double azimuth, double elevation)
{
    right = right_direction(plot, "right", right);
    up = right_direction(plot, "up", up);
    forward = right_direction(plot, "forward", forward);
    plot_number(plot, "azimuth", azimuth);
    plot_number(plot, "elevation", elevation);
    if (plot->right != NULL) {
        azimuth = plot_shown(plot, "azimuth");
        elevation = plot_shown(plot, "elevation");
    }
    double a = azimuth * PI / 180, e = elevation * PI / 180;
    vec3 aside = cos(a) * right - sin(a) * forward;
    look(plot->view,
         (Look){false, cos(a) * forward + sin(a) * right, cos(e) * up - sin(e) * aside});
}

void plot_apart(Plot *plot)
{
    plot->view->apart = true;
}

void plot_look_flat(Plot *plot)
{
    look(plot->view, (Look){true, vec3_of(1, 0, 0), vec3_of(0, 1, 0)});
}

void plot_room(Plot *plot, Room wide, Room narrow)
{
    plot->view->room[plot->view->panel][0] = wide;
    plot->view->room[plot->view->panel][1] = narrow;
}

void plot_fill_room(Plot *plot)
{
    plot->view->fills = true;
}

void plot_panel(Plot *plot, int panel)
{
    plot_block_end(plot);
    plot->view->panel = panel;
}

void plot_fit(Plot *plot, vec3 center, double radius)
{
    if (vec3_is_finite(center) && isfinite(radius))
        *(Fit *)add(&plot->view->fits, sizeof(Fit)) = (Fit){center, radius, plot->view->panel};
}

// Is a part of a wrong figure so near to what is right that the rest remains legible?
static bool is_near(Fit part, const Fit *right, int count)
{
    enum { TIMES = 3 };
    double far = 0, away = INFINITY;
    const Fit *first = NULL;
    for (const Fit *fit = right; fit < right + count; fit++) {
        if (fit->panel != part.panel)
            continue;
        first = first == NULL ? fit : first;
        far = fmax(far, vec3_length(fit->center - first->center) + fit->radius);
        away = fmin(away, vec3_length(part.center - fit->center) + part.radius);
    }
    return first == NULL || away <= TIMES * far;
}

// With as many digits as the right numbers are written with: labels find the same places.
static double as_written(double x)
{
    return strtod(gnuplot_number(x).s, NULL);
}

// The right parts must be visible, however wrong the others are.
static void fit_right_parts(List *fits, const char *rows, size_t size)
{
    const List yours = *fits;
    *fits = (List){0};
    double x, y, z, radius;
    int panel, used = 0;
    for (const char *end = rows + size; rows < end && sscanf(rows, "%lf %lf %lf %lf %d\n%n", &x, &y,
                                                             &z, &radius, &panel, &used) == 5;
         rows += used)
        *(Fit *)add(fits, sizeof(Fit)) = (Fit){vec3_of(x, y, z), radius, panel};
    int right = fits->count;
    for (const Fit *fit = yours.items, *end = fit + yours.count; fit < end; fit++) {
        vec3 c = fit->center;
        Fit part = {vec3_of(as_written(c[0]), as_written(c[1]), as_written(c[2])),
                    as_written(fit->radius), fit->panel};
        if (is_near(part, fits->items, right))
            *(Fit *)add(fits, sizeof(Fit)) = part;
    }
    free(yours.items);
}

void plot_view_fits_end(Plot *plot)
{
    List *fits = &plot->view->fits;
    const char *right;
    size_t size = plot_right_rows(plot, "fit", &right);
    plot_block_end(plot);
    if (size > 0)
        fit_right_parts(fits, right, size);
    fputs("$fit << EOD\n# x y z radius of what has to be seen, and its panel\n", plot->script);
    for (const Fit *fit = fits->items, *end = fit + fits->count; fit < end; fit++) {
        for (int i = 0; i < 3; i++)
            fprintf(plot->script, "%s ", gnuplot_number(fit->center[i]).s);
        fprintf(plot->script, "%s %d\n", gnuplot_number(fit->radius).s, fit->panel);
    }
    fputs("EOD\n", plot->script);
}

void plot_view_words(Plot *plot, const char *name, const char *value, size_t size)
{
    Words *words = add(&plot->view->words, sizeof(Words));
    snprintf(words->name, sizeof words->name, "%s", name);
    snprintf(words->value, sizeof words->value, "%.*s", (int)size, value);
}

double plot_shown(const Plot *plot, const char *name)
{
    const Words *words = plot->view->words.items;
    for (int i = plot->view->words.count - 1; i >= 0; i--)
        if (strcmp(words[i].name, name) == 0)
            return strtod(words[i].value, NULL);
    return NAN;
}

void plot_name(Plot *plot, Label label)
{
    Wanted *wanted = add(&plot->view->wanted, sizeof(Wanted));
    wanted->label = label;
    wanted->text = own_words(label.text);
    wanted->panel = plot->view->panel;
    snprintf(wanted->block, sizeof wanted->block, "%s", label.block != NULL ? label.block : "");
}

void plot_names_of(Plot *plot, int count, const Label *labels)
{
    for (int i = 0; i < count; i++)
        if (labels[i].text[0] != '\0')
            plot_name(plot, labels[i]);
}

static void say(Plot *plot, int count, const Label *lines, Wanted block)
{
    List *all = &plot->view->wanted;
    int first = all->count;
    plot_names_of(plot, count, lines);
    for (int i = first; i < all->count; i++) {
        Wanted *wanted = (Wanted *)all->items + i;
        wanted->lines = i == first ? all->count - first : -1; // -1: in the block of one before it
        wanted->across = block.across;
        wanted->up = block.up;
        wanted->pinned = i == first && block.pinned;
    }
}

void plot_say_of(Plot *plot, double across, double up, int count, const Label *lines)
{
    say(plot, count, lines, (Wanted){.across = across, .up = up});
}

void plot_pin_of(Plot *plot, double across, double up, int count, const Label *lines)
{
    say(plot, count, lines, (Wanted){.across = across, .up = up, .pinned = true});
}

// ---- what is drawn ------------------------------------------------------------------------------

static Mark *mark(Plot *plot, vec3 from, vec3 to)
{
    Mark *mark = add(&plot->view->marks, sizeof(Mark));
    mark->panel = mark->from_panel = plot->view->panel;
    mark->from = from;
    mark->to = to;
    return mark;
}

void plot_ball(Plot *plot, vec3 center, double radius)
{
    mark(plot, center, center)->radius = radius;
}

// Room is left for it around the picture.
static void move(PlotView *view, Mark *mark, double u, double v)
{
    Area *around = &view->around[mark->panel];
    mark->moved_u = u;
    mark->moved_v = v;
    around->left = fmax(around->left, -u);
    around->right = fmax(around->right, u);
    around->bottom = fmax(around->bottom, -v);
    around->top = fmax(around->top, v);
}

void plot_line(Plot *plot, vec3 from, vec3 to, double moved_u, double moved_v)
{
    move(plot->view, mark(plot, from, to), moved_u, moved_v);
}

void plot_line_from(Plot *plot, int panel, vec3 from, vec3 to)
{
    mark(plot, from, to)->from_panel = panel;
}

void plot_undrawn(Plot *plot)
{
    plot_block_end(plot);
    plot->view->block = "";
}

void plot_moved(Plot *plot, double u, double v)
{
    plot_block_end(plot);
    plot->view->moved_u = u;
    plot->view->moved_v = v;
}

void plot_circle(Plot *plot, vec3 center, double radius)
{
    enum { SIDES = 36 };
    const Look *look = &plot->view->look[plot->view->panel];
    const vec3 u = radius * look->u, v = radius * look->v;
    for (int i = 0; i < SIDES; i++) {
        double a = 2 * PI * i / SIDES, b = 2 * PI * (i + 1) / SIDES;
        plot_line(plot, center + cos(a) * u + sin(a) * v, center + cos(b) * u + sin(b) * v, 0, 0);
    }
}

void plot_keep_clear(Plot *plot, Room wide, Room narrow)
{
    *(Room *)add(&plot->view->clear, sizeof(Room)) = wide;
    *(Room *)add(&plot->view->clear, sizeof(Room)) = narrow;
}

static void mark_row(Plot *plot, vec3 from, vec3 vector, bool yours)
{
    PlotView *view = plot->view;
    bool is_arrow = vec3_length(vector) > 0;
    Mark *row = mark(plot, view->joins && !is_arrow ? view->last : from, from + vector);
    snprintf(row->block, sizeof row->block, "%s", view->block);
    row->row = view->row++;
    row->is_arrow = is_arrow;
    row->yours = yours;
    move(view, row, view->moved_u, view->moved_v);
    view->joins = !is_arrow;
    view->last = from;
}

void plot_view_block(Plot *plot)
{
    PlotView *view = plot->view;
    bool undrawn = view->block != NULL && *view->block == '\0';
    view->is_drawn = !undrawn && strncmp(plot->columns, "x y z", 5) == 0;
    view->block = plot->block;
    view->row = 0;
    view->joins = false;
}

void plot_view_row(Plot *plot, vec3 from, vec3 vector)
{
    if (plot->view->is_drawn)
        mark_row(plot, from, vector, false);
}

void plot_view_gap(Plot *plot)
{
    plot->view->joins = false;
}

// Where there are right rows, those that were written are yours.
void plot_view_block_end(Plot *plot, const char *right, size_t size)
{
    PlotView *view = plot->view;
    Mark *marks = view->marks.items;
    for (int i = 0; size > 0 && view->is_drawn && i < view->marks.count; i++)
        marks[i].yours = marks[i].yours || strcmp(marks[i].block, view->block) == 0;
    view->row = 0;
    view->joins = false;
    for (const char *end = size > 0 ? right + size : NULL; view->is_drawn && right < end;) {
        char row[400]; // alone: sscanf would go on in the next one
        size_t length = strcspn(right, "\n");
        snprintf(row, sizeof row, "%.*s", (int)length, right);
        double n[6] = {0};
        int count =
            sscanf(row, "%lf %lf %lf %lf %lf %lf", &n[0], &n[1], &n[2], &n[3], &n[4], &n[5]);
        if (length == 0)
            view->joins = false;
        else if (count == 3 || count == 6)
            mark_row(plot, vec3_of(n[0], n[1], n[2]), vec3_of(n[3], n[4], n[5]), false);
        right += length + 1;
    }
    view->block = NULL;
    view->is_drawn = false;
    view->moved_u = view->moved_v = 0;
}

// ---- onto the canvas ----------------------------------------------------------------------------

static Spot spot_of(const PlotView *view, int shape, int panel, vec3 place)
{
    double size = view->size[shape][panel];
    return (Spot){view->zero_u[shape][panel] + size * vec3_dot(view->look[panel].u, place),
                  view->zero_v[shape][panel] + size * vec3_dot(view->look[panel].v, place)};
}

static double *side_of(Area *area, int i)
{
    return (double *[]){&area->left, &area->right, &area->bottom, &area->top}[i];
}

// What has to be seen in a panel. (In space, all panels show the same, unless they are apart.)
static Area to_be_seen(const PlotView *view, int panel)
{
    const Fit *fits = view->fits.items;
    Area all = {INFINITY, -INFINITY, INFINITY, -INFINITY};
    for (int i = 0; i < view->fits.count; i++) {
        int other = fits[i].panel;
        if (other != panel && (view->look[panel].flat || view->look[other].flat || view->apart))
            continue;
        double u = vec3_dot(view->look[panel].u, fits[i].center);
        double v = vec3_dot(view->look[panel].v, fits[i].center);
        all.left = fmin(all.left, u - fits[i].radius);
        all.right = fmax(all.right, u + fits[i].radius);
        all.bottom = fmin(all.bottom, v - fits[i].radius);
        all.top = fmax(all.top, v + fits[i].radius);
    }
    return all.left <= all.right ? all : (Area){0};
}

// The part of the canvas for it, without the labels around it.
static Area room_of(const PlotView *view, int shape, int panel)
{
    Room room = view->room[panel][shape];
    Area over = view->over[shape][panel], around = view->around[panel];
    double width = canvas_width[shape];
    return (Area){width * room.left + fmax(over.left, around.left),
                  width * room.right - fmax(over.right, around.right),
                  HEIGHT * room.bottom + fmax(over.bottom, around.bottom),
                  HEIGHT * room.top - fmax(over.top, around.top)};
}

// How large a panel can be; infinite if nothing has to be seen in it. Where its labels want the
// whole room, a little is left for it.
static double size_of(const PlotView *view, int shape, int panel)
{
    const double least = 10;
    Area seen = to_be_seen(view, panel), room = room_of(view, shape, panel);
    return fmin(fmax(room.right - room.left, least) / (seen.right - seen.left),
                fmax(room.top - room.bottom, least) / (seen.top - seen.bottom));
}

// Chooses how large the panels are: so that all that has to be seen, and the labels around it, fill
// 'part' of their rooms. A view that is held stays.
static void see(PlotView *view, int shape, double part)
{
    if (view->is_held)
        return;
    double least = INFINITY;
    for (int panel = 1; panel < PANELS; panel++)
        least = fmin(least, size_of(view, shape, panel));
    for (int panel = 1; panel < PANELS; panel++) {
        double size = part * (view->apart ? least : size_of(view, shape, panel));
        size = isfinite(size) ? size : 1;
        Area seen = to_be_seen(view, panel), room = room_of(view, shape, panel);
        double u = (room.left + room.right) / 2 - size * (seen.left + seen.right) / 2;
        double v = (room.bottom + room.top) / 2 - size * (seen.bottom + seen.top) / 2;
        view->size[shape][panel] = size;
        view->zero_u[shape][panel] = u;
        view->zero_v[shape][panel] = v;
        view->seen[shape][panel] = (Area){u + size * seen.left, u + size * seen.right,
                                          v + size * seen.bottom, v + size * seen.top};
    }
}

// The words of BEFORE and a name, without gnuplot's quotes, as they were said last; NULL if they
// were not.
static const char *words_said(const PlotView *view, const char *before, const char *name,
                              size_t length)
{
    char key[NAME_SIZE];
    snprintf(key, sizeof key, "%s%.*s_text", before, (int)length, name);
    const Words *words = view->words.items;
    for (int i = view->words.count - 1; i >= 0; i--)
        if (strcmp(words[i].name, key) == 0)
            return words[i].value;
    return NULL;
}

static const char *words_of(const PlotView *view, const char *name, size_t length)
{
    const char *words = words_said(view, "", name, length);
    if (words != NULL)
        return words;
    fprintf(stderr, "a label's {%.*s}: no number or vector of this figure has that name\n",
            (int)length, name);
    abort();
}

bool plot_says_yours(const Plot *plot, const char *name)
{
    return words_said(plot->view, "your_", name, strlen(name)) != NULL;
}

static void plain_words(const char *words, FILE *out)
{
    for (; *words != '\0'; words++)
        if (*words != '"' && *words != '\\')
            putc(*words, out);
}

// {NAME!}: yours is beside the right words, if it differs.
static bool says_yours(const PlotView *view, const char *name, size_t *size)
{
    if (*size == 0 || name[*size - 1] != '!')
        return false;
    --*size;
    return words_said(view, "your_", name, *size) != NULL;
}

#define YOURS "yours"

// One line of a label as it is read: without $ and the marks of indices, and with words for names.
static void plain_line(const PlotView *view, const char *line, size_t length, FILE *out)
{
    for (const char *c = line; c < line + length; c++) {
        if (*c == '{') {
            size_t size = strcspn(c + 1, "}"), name = size;
            bool beside = says_yours(view, c + 1, &name);
            plain_words(words_of(view, c + 1, name), out);
            if (beside) {
                fputs(", ", out);
                own_words_print(out, YOURS, strlen(YOURS));
                putc(' ', out);
                plain_words(words_said(view, "your_", c + 1, name), out);
            }
            c += size + 1;
        } else if (strchr("$_^", *c) == NULL) {
            putc(*c, out);
        }
    }
}

static double line_width(const PlotView *view, const char *line, size_t length)
{
    char *plain;
    size_t size;
    FILE *out = open_memstream(&plain, &size);
    plain_line(view, line, length, out);
    fclose(out);
    double width = labels_text_width(plain, TEXT_SIZE);
    free(plain);
    return width;
}

double plot_width(const Plot *plot, const char *text)
{
    char *own = own_words(text);
    double width = line_width(plot->view, own, strlen(own));
    free(own);
    return width;
}

#define LINE_HEIGHT (1.35 * TEXT_SIZE)

static void measure(const PlotView *view, const char *text, double *width, double *height)
{
    *height = 1.1 * TEXT_SIZE - LINE_HEIGHT;
    *width = 0;
    for (const char *line = text;; line++) {
        size_t length = strcspn(line, "\n");
        *width = fmax(*width, line_width(view, line, length));
        *height += LINE_HEIGHT;
        line += length;
        if (*line == '\0')
            return;
    }
}

// NULL: there is no such row.
static const Mark *mark_of(const PlotView *view, const Wanted *wanted)
{
    const Mark *marks = view->marks.items;
    for (int i = 0; i < view->marks.count; i++)
        if (!marks[i].yours && marks[i].row == wanted->label.row &&
            strcmp(marks[i].block, wanted->block) == 0)
            return &marks[i];
    for (int i = 0; i < view->marks.count; i++)
        if (marks[i].row == wanted->label.row && strcmp(marks[i].block, wanted->block) == 0)
            return &marks[i];
    return NULL;
}

static Spot moved(Spot spot, const Mark *mark)
{
    return (Spot){spot.u + mark->moved_u, spot.v + mark->moved_v};
}

// A part of the canvas, as a thick line along its longer side.
static void draw_room(Room room, double width, Labels *labels)
{
    double left = width * room.left, right = width * room.right;
    double bottom = HEIGHT * room.bottom, top = HEIGHT * room.top;
    double thick = fmin(right - left, top - bottom), u = (left + right) / 2, v = (bottom + top) / 2;
    if (right - left > top - bottom)
        labels_line(labels, (Spot){left, v}, (Spot){right, v}, thick);
    else
        labels_line(labels, (Spot){u, bottom}, (Spot){u, top}, thick);
}

// Draws, as far as labels care.
static void draw(const PlotView *view, int shape, Labels *labels)
{
    const Mark *marks = view->marks.items;
    for (int i = shape; i < view->clear.count; i += SHAPES)
        draw_room(((const Room *)view->clear.items)[i], canvas_width[shape], labels);
    for (int i = 0; i < view->marks.count; i++) {
        const Mark *mark = &marks[i];
        Spot from = moved(spot_of(view, shape, mark->from_panel, mark->from), mark);
        Spot to = moved(spot_of(view, shape, mark->panel, mark->to), mark);
        if (mark->radius > 0)
            labels_disc(labels, from, mark->radius * view->size[shape][mark->panel]);
        else if (from.u == to.u && from.v == to.v)
            labels_disc(labels, from, DOT);
        else
            labels_line(labels, from, to, LINE);
    }
}

// The number of a label that names what is not there.
enum { NOWHERE = -1 };

static bool is_somewhere(Spot spot)
{
    const double far = 1e7; // plot.c draws there what is not to be seen
    return fabs(spot.u) < far && fabs(spot.v) < far;
}

// Its text does not change while places for it are tried.
static void measure_once(const PlotView *view, Wanted *wanted)
{
    if (wanted->high > 0)
        return;
    for (int i = 0; i < wanted->lines; i++)
        wanted->wide = fmax(wanted->wide, line_width(view, wanted[i].text, strlen(wanted[i].text)));
    wanted->high = LINE_HEIGHT * wanted->lines;
    if (wanted->lines == 0)
        measure(view, wanted->text, &wanted->wide, &wanted->high);
}

static void want(const PlotView *view, int shape, Labels *labels, Wanted *wanted)
{
    PlacedLabel label = {.free = wanted->lines > 0 && !wanted->pinned, .pinned = wanted->pinned};
    if (wanted->lines > 0) {
        label.from = (Spot){wanted->across * canvas_width[shape], wanted->up * (HEIGHT - TITLE)};
        label.margin = MARGIN - EDGE;
    } else if (wanted->block[0] == '\0') {
        enum { TINY = 8 };
        label.from = label.to = spot_of(view, shape, wanted->panel, wanted->label.place);
        label.radius = wanted->label.ball * view->size[shape][wanted->panel];
        if (label.radius > 0 && label.radius < TINY) {
            wanted->number[shape] = NOWHERE;
            return;
        }
    } else {
        const Mark *mark = mark_of(view, wanted);
        if (mark == NULL) {
            wanted->number[shape] = NOWHERE;
            return;
        }
        double part = wanted->label.part;
        vec3 all = mark->to - mark->from;
        // Near its ends, other arrows may begin.
        bool is_point = part == 0 && !mark->is_arrow;
        double first = is_point ? 1 : part < 0 ? 0.15 : part;
        double last = is_point ? 1 : part < 0 ? 0.85 : part;
        label.from = moved(spot_of(view, shape, wanted->panel, mark->from + first * all), mark);
        label.to = moved(spot_of(view, shape, wanted->panel, mark->from + last * all), mark);
    }
    if (vec3_length(wanted->label.aside) > 0) {
        const Look *look = &view->look[wanted->panel];
        double u = vec3_dot(look->u, wanted->label.aside),
               v = vec3_dot(look->v, wanted->label.aside);
        double length = hypot(u, v);
        label.aside = length > 0 ? (Spot){u / length, v / length} : (Spot){0, 1};
        label.says_what = strchr(wanted->text, '=') != NULL;
    }
    measure_once(view, wanted);
    label.width = wanted->wide;
    label.height = wanted->high;
    wanted->number[shape] =
        is_somewhere(label.from) && is_somewhere(label.to) ? labels_add(labels, label) : NOWHERE;
}

// Places labels: on the canvas, with the blocks of text; or without them, and as if the canvas had
// no end. Returns what it costs.
static double place_in(PlotView *view, int shape, double part, bool blocks)
{
    const double endless = INFINITY;
    const Area canvas = {EDGE, canvas_width[shape] - EDGE, EDGE, HEIGHT - TITLE};
    const Area area = blocks ? canvas : (Area){-endless, endless, -endless, endless};
    see(view, shape, part);
    Labels *labels = labels_new(area);
    Wanted *wanted = view->wanted.items;
    for (int i = 0; i < view->wanted.count; i++)
        if (wanted[i].lines == 0 || (blocks && wanted[i].lines > 0))
            want(view, shape, labels, &wanted[i]);
    draw(view, shape, labels);
    labels_place(labels);
    if (view->labels[shape] != NULL)
        labels_free(view->labels[shape]);
    view->labels[shape] = labels;
    return labels_cost(labels);
}

// How far labels go beyond what has to be seen, if the canvas had no end.
static void measure_over(PlotView *view, int shape)
{
    place_in(view, shape, 1, false);
    const Wanted *wanted = view->wanted.items;
    memset(view->over[shape], 0, sizeof view->over[shape]);
    for (int i = 0; i < view->wanted.count; i++) {
        if (wanted[i].lines != 0 || wanted[i].number[shape] == NOWHERE)
            continue;
        PlacedLabel label = labels_get(view->labels[shape], wanted[i].number[shape]);
        if (label.is_left_out)
            continue;
        Area seen = view->seen[shape][wanted[i].panel], *over = &view->over[shape][wanted[i].panel];
        over->left = fmax(over->left, seen.left - (label.middle.u - label.width / 2));
        over->right = fmax(over->right, label.middle.u + label.width / 2 - seen.right);
        over->bottom = fmax(over->bottom, seen.bottom - (label.middle.v - label.height / 2));
        over->top = fmax(over->top, label.middle.v + label.height / 2 - seen.top);
    }
    for (int panel = 0; panel < PANELS; panel++)
        for (int i = 0; i < 4; i++) {
            double *side = side_of(&view->over[shape][panel], i);
            *side = fmin(*side, 0.3 * (i < 2 ? canvas_width[shape] : HEIGHT));
        }
}

// Leaves room for the largest block of text, on this side of the picture: 0 left, 1 right, 2
// bottom, 3 top. False if there is no such block.
static bool leave_room(PlotView *view, int shape, int side)
{
    const Wanted *wanted = view->wanted.items;
    double width = 0, height = 0;
    for (int i = 0; i < view->wanted.count; i++) {
        if (wanted[i].lines <= 0 || wanted[i].pinned)
            continue;
        PlacedLabel label = labels_get(view->labels[shape], wanted[i].number[shape]);
        width = fmax(width, label.width);
        height = fmax(height, label.height);
    }
    *side_of(&view->over[shape][1], side) += side < 2 ? width : height;
    return width > 0;
}

enum { TRIES = 5 };

typedef struct {
    double cost, part; // of its room
    Area over[PANELS];
} Choice;

// A smaller picture, if it is a better one: half the size costs as much as a distance of 350.
static void choose(PlotView *view, int shape, double full, int tries, Choice *best)
{
    static const double parts[TRIES] = {1, 0.88, 0.76, 0.64, 0.52};
    enum { SMALLER = 700 };
    for (int i = 0; i < tries; i++) {
        see(view, shape, parts[i]);
        double cost = SMALLER * (1 - view->size[shape][1] / full);
        if (cost >= best->cost)
            return;
        cost += place_in(view, shape, parts[i], true);
        if (cost >= best->cost)
            continue;
        best->cost = cost;
        best->part = parts[i];
        memcpy(best->over, view->over[shape], sizeof best->over);
    }
}

// The best picture: a large one, whose labels meet nothing and are near.
static void place(PlotView *view, int shape)
{
    enum { SIDES = 4 };
    if (view->is_held) {
        place_in(view, shape, 1, true);
        return;
    }
    see(view, shape, 1);
    double full = view->size[shape][1];
    Choice best = {.cost = INFINITY, .part = 1};
    choose(view, shape, full, view->fills ? 1 : TRIES, &best);
    if (!view->fills || best.cost >= LABEL_FINE) {
        Area over[PANELS];
        measure_over(view, shape);
        memcpy(over, view->over[shape], sizeof over);
        choose(view, shape, full, TRIES, &best);
        bool is_crowded = best.cost >= LABEL_FINE;
        for (int side = 0; side < SIDES && is_crowded; side++) {
            memcpy(view->over[shape], over, sizeof over);
            if (leave_room(view, shape, side))
                choose(view, shape, full, TRIES, &best);
        }
    }
    memcpy(view->over[shape], best.over, sizeof best.over);
    place_in(view, shape, best.part, true);
    Wanted *wanted = view->wanted.items;
    for (int i = 0; i < view->wanted.count; i++)
        if (wanted[i].lines == 0 && wanted[i].number[shape] != NOWHERE &&
            labels_get(view->labels[shape], wanted[i].number[shape]).is_left_out)
            wanted[i].number[shape] = NOWHERE;
}

// ---- what the script is told --------------------------------------------------------------------

static void write_both(FILE *out, const char *name, int number, double wide, double narrow)
{
    fprintf(out, "%s", name);
    if (number > 0)
        fprintf(out, "[%d]", number);
    if (wide == narrow)
        fprintf(out, " = %s\n", gnuplot_number(wide).s);
    else
        fprintf(out, " = shape eq \"4:3\" ? %s : %s\n", gnuplot_number(narrow).s,
                gnuplot_number(wide).s);
}

// A line's text as an expression of gnuplot: "".math("d")." = ".d_text
static void write_text(const PlotView *view, FILE *out, const char *text, size_t length)
{
    const char *end = text + length;
    fputs("\"\"", out);
    while (text < end) {
        size_t size = strcspn(text, "${%\n");
        if (size > 0)
            fprintf(out, ".\"%.*s\"", (int)size, text);
        text += size;
        if (text >= end)
            break;
        if (*text == '%') { // it begins a comment in LaTeX
            fputs(".percent", out);
            text++;
            continue;
        }
        size = strcspn(text + 1, *text == '$' ? "$" : "}");
        size_t name = size;
        bool beside = *text == '{' && says_yours(view, text + 1, &name);
        fprintf(out, *text == '$' ? ".math(\"%.*s\")" : ".%.*s_text", (int)name, text + 1);
        if (beside)
            fprintf(out, ".\", \".own(\"" YOURS "\").\" \".your_%.*s_text", (int)name, text + 1);
        text += size + 2;
    }
    putc('\n', out);
}

// One line of text, at this height above the middle of its label.
typedef struct {
    const PlacedLabel *placed; // on each canvas
    const bool *is_there;      // a ball may be too small for a name on one canvas, not on the other
    const Label *label;
    const char *text, *names;
    size_t length;
    double above;
    bool is_left;
} Line;

// A line from a label to what it names.
typedef struct {
    int label;
    Spot start, end;
} Leader;

// What it names: nothing draws that, but who reads the script can tell (tests/house/figures).
static void write_anchor(FILE *out, int number, const PlacedLabel *placed)
{
    write_both(out, "anchor_u", number, placed[0].from.u, placed[1].from.u);
    write_both(out, "anchor_v", number, placed[0].from.v, placed[1].from.v);
    write_both(out, "anchor_to_u", number, placed[0].to.u, placed[1].to.u);
    write_both(out, "anchor_to_v", number, placed[0].to.v, placed[1].to.v);
    write_both(out, "anchor_r", number, placed[0].radius, placed[1].radius);
}

static void write_line(const PlotView *view, FILE *out, int number, Line line)
{
    double u[SHAPES], v[SHAPES];
    for (int shape = 0; shape < SHAPES; shape++) {
        PlacedLabel label = line.placed[shape];
        u[shape] = label.middle.u - (line.is_left ? label.width / 2 : 0);
        v[shape] = label.middle.v + line.above;
    }
    fprintf(out, "label_text[%d] = ", number);
    for (int shape = 0; shape < SHAPES; shape++)
        if (!line.is_there[shape])
            fprintf(out, "shape %s \"4:3\" ? \"\" : ", shape == 1 ? "eq" : "ne");
    write_text(view, out, line.text, line.length);
    fprintf(out, "label_color[%d] = %s\nlabel_step[%d] = %d\n", number, line.label->color, number,
            line.label->step);
    fprintf(out, "label_title[%d] = \"label of ", number);
    for (const char *c = line.names; *c != '\0'; c++)
        putc(*c == '_' ? ' ' : *c, out);
    fputs("\"\n", out);
    write_both(out, "label_u", number, u[0], u[1]);
    write_both(out, "label_v", number, v[0], v[1]);
    if (!line.placed[0].free && !line.placed[0].pinned && view->only == SHAPES)
        write_anchor(out, number, line.placed);
}

static int lines_of(const Wanted *wanted)
{
    int lines = 1;
    for (const char *c = wanted->text; *c != '\0'; c++)
        lines += *c == '\n';
    return lines;
}

// The shape of the canvas that is meant by the first or the second place, of two.
static int shape_at(const PlotView *view, int place)
{
    return view->only < SHAPES ? view->only : place;
}

// On one of the canvases.
static bool is_placed(const PlotView *view, const Wanted *wanted)
{
    return wanted->number[shape_at(view, 0)] != NOWHERE ||
           wanted->number[shape_at(view, 1)] != NOWHERE;
}

// Lines of labels: those of one label, or of a block of text. The first has the leader.
static int write_wanted(const PlotView *view, FILE *out, int number, const Wanted *first,
                        List leaders[SHAPES])
{
    PlacedLabel placed[SHAPES];
    bool is_there[SHAPES];
    for (int i = 0; i < SHAPES; i++) {
        int shape = shape_at(view, i);
        is_there[i] = first->number[shape] != NOWHERE;
        placed[i] =
            is_there[i] ? labels_get(view->labels[shape], first->number[shape]) : (PlacedLabel){0};
        if (placed[i].leads)
            *(Leader *)add(&leaders[i], sizeof(Leader)) =
                (Leader){number, placed[i].start, placed[i].end};
    }
    bool is_block = first->lines > 0;
    int lines = is_block ? first->lines : lines_of(first);
    const char *text = first->text;
    for (int i = 0; i < lines; i++) {
        const Wanted *wanted = is_block ? first + i : first;
        text = is_block ? wanted->text : text;
        size_t length = strcspn(text, "\n");
        double above = LINE_HEIGHT * ((lines - 1) / 2.0 - i);
        write_line(view, out, number++,
                   (Line){placed, is_there, &wanted->label, text, is_block ? "words" : first->block,
                          length, above, is_block});
        text += length + 1;
    }
    return number;
}

static void write_arrays(FILE *out, const char *const *names, int size)
{
    for (; *names != NULL; names++)
        fprintf(out, "array %s[%d]\n", *names, size > 0 ? size : 1);
}

static void write_leaders(FILE *out, const List leaders[SHAPES])
{
    static const char *const arrays[] = {"leader",    "leader_u",  "leader_v",
                                         "leader_du", "leader_dv", NULL};
    int wide = leaders[0].count, narrow = leaders[1].count;
    write_both(out, "leader_count", 0, wide, narrow);
    write_arrays(out, arrays, wide > narrow ? wide : narrow);
    for (int i = 0; i < wide || i < narrow; i++) {
        Leader of[SHAPES] = {0};
        for (int shape = 0; shape < SHAPES; shape++)
            if (i < leaders[shape].count)
                of[shape] = ((const Leader *)leaders[shape].items)[i];
        write_both(out, "leader", i + 1, of[0].label, of[1].label);
        write_both(out, "leader_u", i + 1, of[0].start.u, of[1].start.u);
        write_both(out, "leader_v", i + 1, of[0].start.v, of[1].start.v);
        write_both(out, "leader_du", i + 1, of[0].end.u - of[0].start.u,
                   of[1].end.u - of[1].start.u);
        write_both(out, "leader_dv", i + 1, of[0].end.v - of[0].start.v,
                   of[1].end.v - of[1].start.v);
    }
}

// First those that are centered, then the lines of blocks, which begin at their left edge.
static void write_labels(const PlotView *view, FILE *out)
{
    static const char *const arrays[] = {"label_text",  "label_color", "label_step", "label_title",
                                         "label_u",     "label_v",     "anchor_u",   "anchor_v",
                                         "anchor_to_u", "anchor_to_v", "anchor_r",   NULL};
    const Wanted *wanted = view->wanted.items;
    List leaders[SHAPES] = {0};
    int centered = 0, in_blocks = 0, number = 1;
    for (int i = 0; i < view->wanted.count; i++)
        if (wanted[i].lines != 0)
            in_blocks++;
        else if (is_placed(view, &wanted[i]))
            centered += lines_of(&wanted[i]);
    fprintf(out, "centered_count = %d\nlabel_count = %d\n", centered, centered + in_blocks);
    write_arrays(out, arrays, centered + in_blocks);
    for (int blocks = 0; blocks < 2; blocks++)
        for (int i = 0; i < view->wanted.count; i++)
            if (wanted[i].lines >= 0 && (wanted[i].lines > 0) == blocks &&
                is_placed(view, &wanted[i]))
                number = write_wanted(view, out, number, &wanted[i], leaders);
    write_leaders(out, leaders);
    for (int shape = 0; shape < SHAPES; shape++)
        free(leaders[shape].items);
    fputs("@place_labels\n", out);
}

bool plot_view_end(Plot *plot)
{
    PlotView *view = plot->view;
    if (!view->looks)
        return false;
    if (plot->is_moved && view->is_held) // only the handles are asked for, and the view is known
        return true;
    for (int shape = 0; shape < SHAPES; shape++)
        if (view->only == SHAPES || view->only == shape)
            place(view, shape);
    for (int panel = 1; panel < PANELS; panel++) {
        write_both(plot->script, "size", panel, view->size[0][panel], view->size[1][panel]);
        write_both(plot->script, "zero_x", panel, view->zero_u[0][panel], view->zero_u[1][panel]);
        write_both(plot->script, "zero_y", panel, view->zero_v[0][panel], view->zero_v[1][panel]);
    }
    fputs("scale = size[1]\n", plot->script);
    write_labels(view, plot->script);
    return true;
}

// ---- a view that is kept, and places in it (plot_handle.c) --------------------------------------

void plot_view_only(Plot *plot, int shape)
{
    plot->view->only = shape;
}

static int shape_of(const PlotView *view)
{
    return view->only < SHAPES ? view->only : 0;
}

bool plot_view_hold(Plot *plot, const char *text)
{
    PlotView *view = plot->view;
    int shape = shape_of(view);
    for (int panel = 1; panel < PANELS; panel++) {
        int used = 0;
        if (sscanf(text, "%lf,%lf,%lf;%n", &view->size[shape][panel], &view->zero_u[shape][panel],
                   &view->zero_v[shape][panel], &used) != 3 ||
            used == 0 || !(view->size[shape][panel] > 0))
            return false;
        text += used;
    }
    view->is_held = true;
    return *text == '\0';
}

void plot_view_print(const Plot *plot, FILE *out)
{
    const PlotView *view = plot->view;
    int shape = shape_of(view);
    for (int panel = 1; view->looks && panel < PANELS; panel++)
        fprintf(out, "%s,%s,%s;", gnuplot_number(view->size[shape][panel]).s,
                gnuplot_number(view->zero_u[shape][panel]).s,
                gnuplot_number(view->zero_v[shape][panel]).s);
}

bool plot_view_is_held(const Plot *plot)
{
    return plot->view->is_held;
}

int plot_view_panel(const Plot *plot)
{
    return plot->view->panel;
}

bool plot_view_spot(const Plot *plot, int panel, vec3 place, double uv[2])
{
    Spot spot = spot_of(plot->view, shape_of(plot->view), panel, place);
    uv[0] = spot.u;
    uv[1] = spot.v;
    return plot->view->looks && is_somewhere(spot);
}

void plot_view_way(const Plot *plot, int panel, vec3 way, double uv[2])
{
    double size = plot->view->size[shape_of(plot->view)][panel];
    uv[0] = size * vec3_dot(plot->view->look[panel].u, way);
    uv[1] = size * vec3_dot(plot->view->look[panel].v, way);
}
