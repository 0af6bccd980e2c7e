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
    char value[200]; // without gnuplot's quotes
} Words;

typedef struct {
    Label label;
    char *text;
    char block[NAME_SIZE];
    int panel;
    int lines;         // 0: it names a place; else it begins a block of so many lines of text
    double across, up; // where that stands
    bool pinned;       // exactly there
    double wide, high; // of its text
    int number;        // of the label that was placed; NOWHERE
} Wanted;

// What it names is not there.
enum { NOWHERE = -1 };

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
    // One canvas after the other: its shape, and what was found for it.
    int shape;
    double size[PANELS], zero_u[PANELS], zero_v[PANELS];
    Area seen[PANELS]; // what has to be seen
    Area over[PANELS]; // by how much labels are outside of it
    Labels *labels;
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
    if (view->labels != NULL)
        labels_free(view->labels);
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
    const char *value;
    for (int i = 0; i < 3; i++)
        if (plot_right_value(plot, text_of("%s_%c", name, "xyz"[i]).s, &value) > 0)
            yours[i] = strtod(value, NULL);
    return yours;
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
    size_t used = 0;
    for (const char *c = value; c < value + size && used + 1 < sizeof words->value; c++)
        if (*c != '"' && (*c != '\\' || ++c < value + size))
            words->value[used++] = *c;
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

static Spot spot_of(const PlotView *view, int panel, vec3 place)
{
    double size = view->size[panel];
    return (Spot){view->zero_u[panel] + size * vec3_dot(view->look[panel].u, place),
                  view->zero_v[panel] + size * vec3_dot(view->look[panel].v, place)};
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
static Area room_of(const PlotView *view, int panel)
{
    Room room = view->room[panel][view->shape];
    Area over = view->over[panel], around = view->around[panel];
    double width = canvas_width[view->shape];
    return (Area){width * room.left + fmax(over.left, around.left),
                  width * room.right - fmax(over.right, around.right),
                  HEIGHT * room.bottom + fmax(over.bottom, around.bottom),
                  HEIGHT * room.top - fmax(over.top, around.top)};
}

// How large a panel can be; infinite if nothing has to be seen in it. Where its labels want the
// whole room, a little is left for it.
static double size_of(const PlotView *view, int panel)
{
    const double least = 10;
    Area seen = to_be_seen(view, panel), room = room_of(view, panel);
    return fmin(fmax(room.right - room.left, least) / (seen.right - seen.left),
                fmax(room.top - room.bottom, least) / (seen.top - seen.bottom));
}

// Chooses how large the panels are: so that all that has to be seen, and the labels around it, fill
// 'part' of their rooms. A view that is held stays.
static void see(PlotView *view, double part)
{
    if (view->is_held)
        return;
    double least = INFINITY;
    for (int panel = 1; panel < PANELS; panel++)
        least = fmin(least, size_of(view, panel));
    for (int panel = 1; panel < PANELS; panel++) {
        double size = part * (view->apart ? least : size_of(view, panel));
        size = isfinite(size) ? size : 1;
        Area seen = to_be_seen(view, panel), room = room_of(view, panel);
        double u = (room.left + room.right) / 2 - size * (seen.left + seen.right) / 2;
        double v = (room.bottom + room.top) / 2 - size * (seen.bottom + seen.top) / 2;
        view->size[panel] = size;
        view->zero_u[panel] = u;
        view->zero_v[panel] = v;
        view->seen[panel] = (Area){u + size * seen.left, u + size * seen.right,
                                   v + size * seen.bottom, v + size * seen.top};
    }
}

// The words of BEFORE and a name, as they were said last; NULL if they were not.
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

// The text with the words of its names, for freeing. {NAME!}: and yours, if it differs.
static char *with_words(const PlotView *view, const char *text)
{
    char *said;
    size_t size;
    FILE *out = open_memstream(&said, &size);
    for (const char *c = text; *c != '\0'; c++) {
        if (*c != '{') {
            putc(*c, out);
            continue;
        }
        size_t length = strcspn(c + 1, "}"), name = length - (length > 0 && c[length] == '!');
        const char *yours = name < length ? words_said(view, "your_", c + 1, name) : NULL;
        fputs(words_of(view, c + 1, name), out);
        if (yours != NULL) {
            char *own = own_words("yours");
            fprintf(out, ", %s %s", own, yours);
            free(own);
        }
        c += length + 1;
    }
    fclose(out);
    return said;
}

// Of a line with its words, as it is read: without $ and the marks of indices.
static double line_width(const char *line, size_t length)
{
    char plain[1000];
    size_t used = 0;
    for (size_t i = 0; i < length && used + 1 < sizeof plain; i++)
        if (strchr("$_^", line[i]) == NULL)
            plain[used++] = line[i];
    plain[used] = '\0';
    return labels_text_width(plain, TEXT_SIZE);
}

double plot_width(const Plot *plot, const char *text)
{
    char *own = own_words(text), *said = with_words(plot->view, own);
    double width = line_width(said, strlen(said));
    free(said);
    free(own);
    return width;
}

#define LINE_HEIGHT (1.35 * TEXT_SIZE)

static void measure(Wanted *wanted)
{
    wanted->high = 1.1 * TEXT_SIZE;
    for (const char *line = wanted->text;; line++, wanted->high += LINE_HEIGHT) {
        size_t length = strcspn(line, "\n");
        wanted->wide = fmax(wanted->wide, line_width(line, length));
        line += length;
        if (*line == '\0')
            return;
    }
}

// The right one, if there is one; NULL: there is no such row.
static const Mark *mark_of(const PlotView *view, const Wanted *wanted)
{
    const Mark *found = NULL, *marks = view->marks.items;
    for (const Mark *it = marks; it < marks + view->marks.count && (found == NULL || found->yours);
         it++)
        if (it->row == wanted->label.row && strcmp(it->block, wanted->block) == 0 &&
            (found == NULL || !it->yours))
            found = it;
    return found;
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
static void draw(const PlotView *view, Labels *labels)
{
    const Mark *marks = view->marks.items;
    for (int i = view->shape; i < view->clear.count; i += SHAPES)
        draw_room(((const Room *)view->clear.items)[i], canvas_width[view->shape], labels);
    for (int i = 0; i < view->marks.count; i++) {
        const Mark *mark = &marks[i];
        Spot from = moved(spot_of(view, mark->from_panel, mark->from), mark);
        Spot to = moved(spot_of(view, mark->panel, mark->to), mark);
        if (mark->radius > 0)
            labels_disc(labels, from, mark->radius * view->size[mark->panel]);
        else if (from.u == to.u && from.v == to.v)
            labels_disc(labels, from, DOT);
        else
            labels_line(labels, from, to, LINE);
    }
}

static bool is_somewhere(Spot spot)
{
    const double far = 1e7; // plot.c draws there what is not to be seen
    return fabs(spot.u) < far && fabs(spot.v) < far;
}

static void want(const PlotView *view, Labels *labels, Wanted *wanted)
{
    PlacedLabel label = {.free = wanted->lines > 0 && !wanted->pinned, .pinned = wanted->pinned};
    wanted->number = NOWHERE;
    if (wanted->lines > 0) {
        label.from =
            (Spot){wanted->across * canvas_width[view->shape], wanted->up * (HEIGHT - TITLE)};
        label.margin = MARGIN - EDGE;
    } else if (wanted->block[0] == '\0') {
        enum { TINY = 8 };
        label.from = label.to = spot_of(view, wanted->panel, wanted->label.place);
        label.radius = wanted->label.ball * view->size[wanted->panel];
        if (label.radius > 0 && label.radius < TINY)
            return;
    } else {
        const Mark *mark = mark_of(view, wanted);
        if (mark == NULL)
            return;
        double part = wanted->label.part;
        vec3 all = mark->to - mark->from;
        // Near its ends, other arrows may begin.
        bool is_point = part == 0 && !mark->is_arrow;
        double first = is_point ? 1 : part < 0 ? 0.15 : part;
        double last = is_point ? 1 : part < 0 ? 0.85 : part;
        label.from = moved(spot_of(view, wanted->panel, mark->from + first * all), mark);
        label.to = moved(spot_of(view, wanted->panel, mark->from + last * all), mark);
    }
    if (vec3_length(wanted->label.aside) > 0) {
        const Look *look = &view->look[wanted->panel];
        double u = vec3_dot(look->u, wanted->label.aside),
               v = vec3_dot(look->v, wanted->label.aside);
        double length = hypot(u, v);
        label.aside = length > 0 ? (Spot){u / length, v / length} : (Spot){0, 1};
        label.says_what = strchr(wanted->text, '=') != NULL;
    }
    label.width = wanted->wide;
    label.height = wanted->lines > 0 ? LINE_HEIGHT * wanted->lines : wanted->high;
    for (int i = 1; i < wanted->lines; i++)
        label.width = fmax(label.width, wanted[i].wide);
    if (is_somewhere(label.from) && is_somewhere(label.to))
        wanted->number = labels_add(labels, label);
}

// Places labels: on the canvas, with the blocks of text; or without them, and as if the canvas had
// no end. Returns what it costs.
static double place_in(PlotView *view, double part, bool blocks)
{
    const double endless = INFINITY;
    const Area canvas = {EDGE, canvas_width[view->shape] - EDGE, EDGE, HEIGHT - TITLE};
    const Area area = blocks ? canvas : (Area){-endless, endless, -endless, endless};
    see(view, part);
    Labels *labels = labels_new(area);
    Wanted *wanted = view->wanted.items;
    for (int i = 0; i < view->wanted.count; i++)
        if (wanted[i].lines == 0 || (blocks && wanted[i].lines > 0))
            want(view, labels, &wanted[i]);
    draw(view, labels);
    labels_place(labels);
    if (view->labels != NULL)
        labels_free(view->labels);
    view->labels = labels;
    return labels_cost(labels);
}

// How far labels go beyond what has to be seen, if the canvas had no end.
static void measure_over(PlotView *view)
{
    place_in(view, 1, false);
    const Wanted *wanted = view->wanted.items;
    memset(view->over, 0, sizeof view->over);
    for (int i = 0; i < view->wanted.count; i++) {
        if (wanted[i].lines != 0 || wanted[i].number == NOWHERE)
            continue;
        PlacedLabel label = labels_get(view->labels, wanted[i].number);
        if (label.is_left_out)
            continue;
        Area seen = view->seen[wanted[i].panel], *over = &view->over[wanted[i].panel];
        over->left = fmax(over->left, seen.left - (label.middle.u - label.width / 2));
        over->right = fmax(over->right, label.middle.u + label.width / 2 - seen.right);
        over->bottom = fmax(over->bottom, seen.bottom - (label.middle.v - label.height / 2));
        over->top = fmax(over->top, label.middle.v + label.height / 2 - seen.top);
    }
    for (int panel = 0; panel < PANELS; panel++)
        for (int i = 0; i < 4; i++) {
            double *side = side_of(&view->over[panel], i);
            *side = fmin(*side, 0.3 * (i < 2 ? canvas_width[view->shape] : HEIGHT));
        }
}

// Leaves room for the largest block of text, on this side of the picture: 0 left, 1 right, 2
// bottom, 3 top. False if there is no such block.
static bool leave_room(PlotView *view, int side)
{
    const Wanted *wanted = view->wanted.items;
    double width = 0, height = 0;
    for (int i = 0; i < view->wanted.count; i++) {
        if (wanted[i].lines <= 0 || wanted[i].pinned)
            continue;
        PlacedLabel label = labels_get(view->labels, wanted[i].number);
        width = fmax(width, label.width);
        height = fmax(height, label.height);
    }
    *side_of(&view->over[1], side) += side < 2 ? width : height;
    return width > 0;
}

enum { TRIES = 5 };

typedef struct {
    double cost, part; // of its room
    Area over[PANELS];
} Choice;

// A smaller picture, if it is a better one: half the size costs as much as a distance of 350.
static void choose(PlotView *view, double full, int tries, Choice *best)
{
    static const double parts[TRIES] = {1, 0.88, 0.76, 0.64, 0.52};
    enum { SMALLER = 700 };
    for (int i = 0; i < tries; i++) {
        see(view, parts[i]);
        double cost = SMALLER * (1 - view->size[1] / full);
        if (cost >= best->cost)
            return;
        cost += place_in(view, parts[i], true);
        if (cost >= best->cost)
            continue;
        best->cost = cost;
        best->part = parts[i];
        memcpy(best->over, view->over, sizeof best->over);
    }
}

// The best picture: a large one, whose labels meet nothing and are near.
static void place(PlotView *view)
{
    enum { SIDES = 4 };
    memset(view->over, 0, sizeof view->over);
    if (view->is_held) {
        place_in(view, 1, true);
        return;
    }
    see(view, 1);
    double full = view->size[1];
    Choice best = {.cost = INFINITY, .part = 1};
    choose(view, full, view->fills ? 1 : TRIES, &best);
    if (!view->fills || best.cost >= LABEL_FINE) {
        Area over[PANELS];
        measure_over(view);
        memcpy(over, view->over, sizeof over);
        choose(view, full, TRIES, &best);
        bool is_crowded = best.cost >= LABEL_FINE;
        for (int side = 0; side < SIDES && is_crowded; side++) {
            memcpy(view->over, over, sizeof over);
            if (leave_room(view, side))
                choose(view, full, TRIES, &best);
        }
    }
    memcpy(view->over, best.over, sizeof best.over);
    place_in(view, best.part, true);
    Wanted *wanted = view->wanted.items;
    for (int i = 0; i < view->wanted.count; i++)
        if (wanted[i].lines == 0 && wanted[i].number != NOWHERE &&
            labels_get(view->labels, wanted[i].number).is_left_out)
            wanted[i].number = NOWHERE;
}

// ---- what the script is told --------------------------------------------------------------------

// A part of a text as a string of gnuplot's, within a string in single quotes.
static void write_string(FILE *out, const char *text, size_t length)
{
    char *part = strndup(text, length), *string = gnuplot_string(part);
    for (const char *c = string; *c != '\0'; c++)
        fprintf(out, *c == '\'' ? "''" : "%c", *c);
    free(string);
    free(part);
}

// A line's text as an expression of gnuplot: math("d")." = 4"
static void write_text(FILE *out, const char *text, size_t length)
{
    const char *before = "";
    for (const char *end = text + length; text < end; before = ".") {
        size_t size = strcspn(text, "$%\n");
        fputs(before, out);
        if (*text == '%') { // it begins a comment in LaTeX
            fputs("percent", out);
            size = 1;
        } else if (*text == '$') {
            size = 1 + strcspn(text + 1, "$");
            fputs("math(", out);
            write_string(out, text + 1, size - 1);
            fputs(")", out);
            size += text + size < end;
        } else {
            write_string(out, text, size);
        }
        text += size;
    }
    fputs(*before == '\0' ? "\"\"" : "", out);
}

static int lines_of(const Wanted *wanted)
{
    int lines = 1;
    for (const char *c = wanted->text; *c != '\0'; c++)
        lines += *c == '\n';
    return lines;
}

// Plots of gnuplot, of a label or a block of text: each line of it, and a leader. Behind them, what
// the label names: nothing draws that, but who reads the script can tell (tests/house/figures).
// count: the lines of all labels before, and then with these.
static void write_wanted(const PlotView *view, FILE *out, const Wanted *first, int *count)
{
    PlacedLabel placed = labels_get(view->labels, first->number);
    bool is_block = first->lines > 0;
    int lines = is_block ? first->lines : lines_of(first);
    double left = placed.middle.u - (is_block ? placed.width / 2 : 0);
    const char *text = first->text;
    if (placed.leads)
        fprintf(out,
                "leaders = leaders.'$once using (%s):(step < %d ? 1e9 : %s):(%s):(%s) with vectors "
                "nohead lw 0.8 lc rgb %s title \"leader\", ' # of label %d\n",
                gnuplot_number(placed.start.u).s, first->label.step,
                gnuplot_number(placed.start.v).s, gnuplot_number(placed.end.u - placed.start.u).s,
                gnuplot_number(placed.end.v - placed.start.v).s, first->label.color, *count + 1);
    for (int i = 0; i < lines; i++) {
        const Wanted *wanted = is_block ? first + i : first;
        text = is_block ? wanted->text : text;
        size_t length = strcspn(text, "\n");
        double middle = placed.middle.v + LINE_HEIGHT * ((lines - 1) / 2.0 - i);
        fprintf(out, "labels = labels.'%s$once using (%s):(%s):(step < %d ? \"\" : ",
                (*count)++ > 0 ? ", " : "", gnuplot_number(left).s, gnuplot_number(middle).s,
                wanted->label.step);
        write_text(out, text, length);
        fprintf(out, ") with labels %stc rgb %s title \"label of ", is_block ? "left " : "",
                wanted->label.color);
        for (const char *c = is_block ? "words" : first->block; *c != '\0'; c++)
            putc(*c == '_' ? ' ' : *c, out);
        fputs("\"'", out);
        if (!is_block)
            fprintf(out, " # names %s %s %s %s %s", gnuplot_number(placed.from.u).s,
                    gnuplot_number(placed.from.v).s, gnuplot_number(placed.to.u).s,
                    gnuplot_number(placed.to.v).s, gnuplot_number(placed.radius).s);
        putc('\n', out);
        text += length + 1;
    }
}

// The panels, and all labels: first those that are centered, then the lines of blocks, which begin
// at their left edge. Each is a line.
static void write_view(const PlotView *view, FILE *out)
{
    const Wanted *wanted = view->wanted.items;
    int count = 0;
    for (int panel = 1; panel < PANELS; panel++)
        fprintf(out, "size[%d] = %s\nzero_x[%d] = %s\nzero_y[%d] = %s\n", panel,
                gnuplot_number(view->size[panel]).s, panel, gnuplot_number(view->zero_u[panel]).s,
                panel, gnuplot_number(view->zero_v[panel]).s);
    fputs("leaders = ''\nlabels = ''\n", out);
    for (int blocks = 0; blocks < 2; blocks++)
        for (int i = 0; i < view->wanted.count; i++)
            if (wanted[i].number != NOWHERE && wanted[i].lines >= 0 &&
                (wanted[i].lines > 0) == blocks)
                write_wanted(view, out, &wanted[i], &count);
    fputs("labels = leaders.labels\n", out);
}

// The same, each line for one shape. (Behind a block in braces of 1,000 bytes gnuplot 5.4 counts a
// line too many, and a mistake in a layout is named with a wrong line.)
static void write_for_shape(const PlotView *view, FILE *out)
{
    char *lines = NULL, *rest = NULL;
    size_t size;
    FILE *written = open_memstream(&lines, &size);
    write_view(view, written);
    fclose(written);
    for (char *line = strtok_r(lines, "\n", &rest); line != NULL;
         line = strtok_r(NULL, "\n", &rest))
        fprintf(out, "if (shape %s \"4:3\") %s\n", view->shape == 0 ? "ne" : "eq", line);
    free(lines);
}

bool plot_view_end(Plot *plot)
{
    PlotView *view = plot->view;
    Wanted *wanted = view->wanted.items;
    if (!view->looks)
        return false;
    if (plot->is_moved && view->is_held) // only the handles are asked for, and the view is known
        return true;
    for (int i = 0; i < view->wanted.count; i++) {
        char *text = with_words(view, wanted[i].text);
        free(wanted[i].text);
        wanted[i].text = text;
        measure(&wanted[i]);
    }
    bool both = view->only == SHAPES;
    for (int shape = SHAPES - 1; shape >= 0; shape--) { // of both, handles are on the last
        if (!both && shape != view->only)
            continue;
        view->shape = shape;
        place(view);
        (both ? write_for_shape : write_view)(view, plot->script);
    }
    fputs("scale = size[1]\n", plot->script);
    return true;
}

// ---- a view that is kept, and places in it (plot_handle.c) --------------------------------------

void plot_view_only(Plot *plot, int shape)
{
    plot->view->only = plot->view->shape = shape;
}

bool plot_view_hold(Plot *plot, const char *text)
{
    PlotView *view = plot->view;
    for (int panel = 1; panel < PANELS; panel++) {
        int used = 0;
        if (sscanf(text, "%lf,%lf,%lf;%n", &view->size[panel], &view->zero_u[panel],
                   &view->zero_v[panel], &used) != 3 ||
            used == 0 || !(view->size[panel] > 0))
            return false;
        text += used;
    }
    view->is_held = true;
    return *text == '\0';
}

void plot_view_print(const Plot *plot, FILE *out)
{
    const PlotView *view = plot->view;
    for (int panel = 1; view->looks && panel < PANELS; panel++)
        fprintf(out, "%s,%s,%s;", gnuplot_number(view->size[panel]).s,
                gnuplot_number(view->zero_u[panel]).s, gnuplot_number(view->zero_v[panel]).s);
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
    Spot spot = spot_of(plot->view, panel, place);
    uv[0] = spot.u;
    uv[1] = spot.v;
    return plot->view->looks && is_somewhere(spot);
}

void plot_view_way(const Plot *plot, int panel, vec3 way, double uv[2])
{
    double size = plot->view->size[panel];
    uv[0] = size * vec3_dot(plot->view->look[panel].u, way);
    uv[1] = size * vec3_dot(plot->view->look[panel].v, way);
}
