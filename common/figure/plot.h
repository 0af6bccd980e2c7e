// plot.h - figures: numbers and a layout become one gnuplot script that needs nothing else.
//
// A figure is a layout, chapters/NN-stem/figures/NAME.gp, and the data that the chapter's program
// computes for it: numbers, points, vectors, tables. The script holds both, after
// common/figure/plot.gp (formats, themes, projection), so that 'gnuplot NAME.gp' draws it anywhere.
// Another layout of the same data, by anybody, is given with --layout.
//
// All data are the world's: the script projects them. If the data of right answers are also
// given (--beside), those are index 0 of each block, and yours, drawn dashed beside them, are
// index 1; of variables, NAME is right and your_NAME is yours.
#ifndef COMMON_FIGURE_PLOT_H
#define COMMON_FIGURE_PLOT_H

#include "common/camera.h"
#include "common/image.h"
#include "common/options.h"
#include "common/shown.h"
#include "common/vec3.h"

#include <stdio.h>

typedef struct Plot Plot;

// ---- by name: numbers, words, points, vectors (plot.c) ----------------------------------------

// NAME = x, and NAME_text = "x" as labels show it (common/shown.h).
void plot_number(Plot *plot, const char *name, double x);
void plot_number_to(Plot *plot, const char *name, double x, int digits);

// That number as the figure shows it: the right one, if it is known.
double plot_shown(const Plot *plot, const char *name);

// Do the words of NAME differ from those that are right? Then labels can say {your_NAME}.
bool plot_says_yours(const Plot *plot, const char *name);

// NAME = "text"; backslashes, quotes and the like are taken care of. UTF-8.
void plot_text(Plot *plot, const char *name, const char *text);

// NAME_text = "label".
void plot_label(Plot *plot, const char *name, const char *label);

// $NAME: x y z, and NAME_text = "(x, y, z)".
void plot_point(Plot *plot, const char *name, vec3 point);

// $NAME: x y z of where it starts, x y z of the vector, and NAME_text = "(x, y, z)" of the vector.
void plot_vector(Plot *plot, const char *name, vec3 from, vec3 vector);

// The same, and both of its ends have to be seen (plot_fit).
void plot_seen_vector(Plot *plot, const char *name, vec3 from, vec3 vector);

// NAME_x, NAME_y, NAME_z and NAME_text: a direction that the layout computes with.
void plot_direction(Plot *plot, const char *name, vec3 v);

// $NAME: first second, NAME_text = "(first, second)", and the two alone as NAME_<first's name> and
// NAME_<second's>, each with its _text: plot_pair(plot, "point", "x", 300, "y", 400).
void plot_pair(Plot *plot, const char *name, const char *first_name, double first,
               const char *second_name, double second);
void plot_pair_to(Plot *plot, const char *name, const char *first_name, double first,
                  const char *second_name, double second, int digits);

// ---- tables (plot.c) --------------------------------------------------------------------------

// $NAME: a table, row by row; columns says what they are. Numbers that are not finite are NaN. It
// ends where the next thing of the figure begins.
void plot_block(Plot *plot, const char *name, const char *columns);
#define plot_row(plot, ...) plot_row_of(plot, PLOT_NUMBERS(__VA_ARGS__))
#define plot_row_at(plot, place, ...) plot_row_at_of(plot, place, PLOT_NUMBERS(__VA_ARGS__))
#define plot_row_dot(plot, place, ...) plot_row_dot_of(plot, place, PLOT_NUMBERS(__VA_ARGS__))
void plot_row_point(Plot *plot, vec3 point);              // x y z
void plot_row_vector(Plot *plot, vec3 from, vec3 vector); // x y z of its start, x y z of the vector
void plot_gap(Plot *plot); // an empty line: what follows is not joined with what went before

// The same, of numbers in an array: alone, after x y z of a place, and after those of a dot.
void plot_row_of(Plot *plot, int count, const double *numbers);
void plot_row_at_of(Plot *plot, vec3 place, int count, const double *numbers);
void plot_row_dot_of(Plot *plot, vec3 place, int count, const double *numbers);
#define PLOT_NUMBERS(...)                                                                          \
    sizeof((const double[]){__VA_ARGS__}) / sizeof(double), (const double[])                       \
    {                                                                                              \
        __VA_ARGS__                                                                                \
    }

// ---- pictures (plot_picture.c) ----------------------------------------------------------------

// $NAME: a picture, as a PNG in base64, which the layout decodes for gnuplot
// (common/figure/plot.gp). If right answers make another picture, $NAME is that one, and
// $your_NAME yours. Right answers may round in different ways, so pictures are compared by the mean
// colors of their parts, bytes from 0 to 255, which may differ by so much: by COLOR_ROUNDING,
// mostly.
void plot_picture(Plot *plot, const char *name, const Image *image, double allowed);
#define COLOR_ROUNDING 1.0

// Is the figure dragged just now, so that a coarser picture will do?
bool plot_is_dragged(const Plot *plot);

// ---- what the layout starts from (plot_view.c, plot_script.c) -----------------------------------

// A thing that the picture must show: a point, or a sphere of a radius.
void plot_fit(Plot *plot, vec3 center, double radius);

// Puts a file of gnuplot's words before the data: what some layouts have in common, common/NAME.gp.
void plot_include(Plot *plot, const char *path);

// ---- from where it is seen, and its labels (plot_view.c) ----------------------------------------

enum { TEXT_SIZE = 24 }; // in units of the canvas, which is 540 tall

// A figure that says from where it is seen leaves it to C to place its labels
// (common/figure/labels.h): the picture is as large as its labels allow, and they meet neither each
// other nor anything that is drawn. For this, the tables with columns "x y z" are lines and points,
// and those with a vector are arrows. The layout then draws '@labels' last, and its text is
// TEXT_SIZE units tall.

// In space, along these directions of the world (unit vectors, at right angles), from their right
// side, turned by azimuth and raised by elevation, in degrees. The first call of this function and
// the next is for all panels; later ones are for the current panel and those after it.
void plot_look(Plot *plot, vec3 right, vec3 up, vec3 forward, double azimuth, double elevation);

// Flat: x to the right, y up (z is not used).
void plot_look_flat(Plot *plot);

// The part of the canvas that the picture may fill, as parts of its width and height; else nearly
// all that a slide's title leaves. Of the 16:9 canvas, and of the 4:3 one.
typedef struct {
    double left, right, bottom, top;
} Room;
void plot_room(Plot *plot, Room wide, Room narrow);

// The picture fills its room, and its labels find theirs in it, if they can: for figures that must
// look alike.
void plot_fill_room(Plot *plot);

// In space, the panels show different things (plot_fit), all in one size.
void plot_apart(Plot *plot);

// What follows, up to the next call, is in another panel, 1 to 8, each with a room and a scale of
// its own. Layouts: '@panel2 ...'; at first, it is panel 1.
void plot_panel(Plot *plot, int panel);

// The next block is not drawn as it is, so labels may cover it.
void plot_undrawn(Plot *plot);

// The layout draws the next block moved by so many units of the canvas: a dimension beside its
// edge.
void plot_moved(Plot *plot, double u, double v);

// A part of each canvas in which the layout draws or writes by itself: labels keep out of it. There
// may be several.
void plot_keep_clear(Plot *plot, Room wide, Room narrow);

// The layout draws this, besides the blocks: a ball, a circle as it is seen, a line. Moved: by so
// many units of the canvas.
void plot_ball(Plot *plot, vec3 center, double radius);
void plot_circle(Plot *plot, vec3 center, double radius);
void plot_line(Plot *plot, vec3 from, vec3 to, double moved_u, double moved_v);

// The same, from a place in another panel to one in this.
void plot_line_from(Plot *plot, int panel, vec3 from, vec3 to);

// A label, and what it names: a row of a block, or where 'block' is NULL a place of its own.
// text: $...$ is mathematics, {NAME} is the words of NAME (plot_number, plot_vector, ...), and
// {NAME!} is the same, and yours if it differs. A label may have several lines. Of a row that is
// not there or not finite, there is no label.
typedef struct {
    const char *text;
    const char *color; // of common/figure/plot.gp: "blue"
    int step;          // from this step on
    const char *block;
    int row;     // 0, 1, ... of the block
    double part; // of a vector, 0 to 1: a place on it; ANYWHERE along it
    vec3 place;  // where block is NULL
    double ball; // or the ball of this radius there; without a label where it is tiny
    vec3 aside;  // the number of a mark on an axis: straight in this direction of the world from
                 // it, or in the other one; if neither is free, it has none
} Label;
#define ANYWHERE (-1)
void plot_name(Plot *plot, Label label);
#define plot_names(plot, ...) plot_names_of(plot, PLOT_LABELS(__VA_ARGS__))

// A paragraph below the canvas, in lines as long as the canvas is wide.
void plot_below(Plot *plot, const char *color, const char *words);

// How wide the text of one line is, in units of the canvas.
double plot_width(const Plot *plot, const char *text);

// Lines of text that name no place, together in a block: near a corner of the canvas, where there
// is room. 0, 1 is the upper left. Pinned, the block has its middle exactly there.
#define plot_say(plot, across, up, ...) plot_say_of(plot, across, up, PLOT_LABELS(__VA_ARGS__))
#define plot_pin(plot, across, up, ...) plot_pin_of(plot, across, up, PLOT_LABELS(__VA_ARGS__))

// The same, of labels in an array: {"$p$", "blue", .block = "p"}. One without a text is left out.
void plot_names_of(Plot *plot, int count, const Label *labels);
void plot_say_of(Plot *plot, double across, double up, int count, const Label *lines);
void plot_pin_of(Plot *plot, double across, double up, int count, const Label *lines);
#define PLOT_LABELS(...)                                                                           \
    sizeof((const Label[]){__VA_ARGS__}) / sizeof(Label), (const Label[])                          \
    {                                                                                              \
        __VA_ARGS__                                                                                \
    }

// ---- what can be dragged (plot_handle.c) --------------------------------------------------------

// A handle: a place that a page lets its reader drag, and the options of the chapter's program that
// move it there. It belongs to the panel that is chosen.
typedef struct {
    const char *words;     // what it is: "the eye"
    vec3 place;            // of the world
    const char *option[2]; // the second NULL: one option has it all, "A,B" or "X,Y,Z"
    int count;             // how many numbers: 1 or 2; 3: a point or vector
    vec3 value;            // the numbers now
    vec3 along[2]; // how far the place goes, for each unit of a number; of a point or vector, in
                   // which two directions it can be dragged
    vec3 way[2];   // of a point or vector, if its handle goes elsewhere than it does
    double least[2], most[2]; // of the numbers; both 0: any
    bool whole;               // whole numbers only
    bool typed; // it has no place and cannot be dragged: its numbers can only be typed
    int panel;  // plot_handle knows it
} Handle;
void plot_handle(Plot *plot, Handle handle);

// Of a point that is dragged in these two directions; of a vector from there; of a pixel, from one
// to the next in its row and its column; of a length from 0.01 to 1000, along this way.
void plot_handle_point(Plot *plot, const char *words, const char *option, vec3 point, vec3 across,
                       vec3 up);
void plot_handle_vector(Plot *plot, const char *words, const char *option, vec3 from, vec3 vector,
                        vec3 across, vec3 up);
void plot_handle_pixel(Plot *plot, vec3 place, Pixel pixel, Resolution size, vec3 across,
                       vec3 down);
void plot_handle_length(Plot *plot, const char *words, const char *option, double length,
                        vec3 place, vec3 along);

// ---- a wrong answer beside the right one (beside.c) ---------------------------------------------

// Their layouts draw $answer and $yours. What is right is blue, yours is ink and dashed.
// answer_text, yours_text and off_text are also in the figure's description (beside_words in
// plot.gp).

// $answer (what is right), $yours, and $off from tip to tip; all of it has to be seen.
void beside_vectors(Plot *plot, vec3 right_from, vec3 right, vec3 yours_from, vec3 yours);

// What is right, what is yours, and by how much it is off ("" if nobody can say). drawn: how yours
// is, 'dashed' or 'as a ring'; "" if it is not.
typedef struct {
    const char *right, *yours, *off, *drawn;
} BesideWords;

// answer_text, yours_text, off_text and drawn.
void beside_words(Plot *plot, BesideWords words);

// A figure of the judge: which function it is about, those words, and why yours is wrong. They are
// below the canvas, because they may be long.
void beside_below(Plot *plot, const char *asked, const char *why, BesideWords words);

// 'expected' and 'yours' beside the two arrows.
void beside_names(Plot *plot);

// off by (1, 1, 0) = ½ w r + ½ h u: in the camera's own steps, where those are simple
// fractions.
Text beside_off(Camera camera, vec3 off);

// ---- a chapter's figures (plot_script.c) ------------------------------------------------------

// A figure's name, and what writes its data.
typedef struct {
    const char *name;
    void (*data)(Plot *plot, void *given);
} Figure;

// The command line's options for figures.
typedef struct {
    const char *name;   // which; "list": their names; NULL for a story or a picture
    const char *layout; // a layout of somebody's own; NULL: the chapter's
    const char *right;  // the script of the same figure by right answers; NULL: there is none
    const char *note;   // a note if something differs; NULL: none
    bool answers;       // instead of the script, the names of the answers that its data call
    // For a page:
    const char *live;  // a folder for what it needs besides the script; NULL: no page
    const char *shape; // the script is for this shape alone; NULL: for both
    const char *held;  // the view of a script before (plot_view.c), which is kept; NULL: a new view
    const char *drag;  // instead of the script, the options of a handle that is put there
} FigureCommand;

// Make and the page give them: --help does not list them.
#define FIGURE_OPTIONS(command)                                                                    \
    {"figure", 0, "NAME", option_string, &(command).name, NULL},                                   \
        {"layout", 0, "FILE.gp", option_string, &(command).layout, NULL},                          \
        {"beside", 0, "FILE.gp", option_string, &(command).right, NULL},                           \
        {"answers", 0, NULL, option_flag, &(command).answers, NULL},                               \
        {"live", 0, "FOLDER", option_string, &(command).live, NULL},                               \
        {"shape", 0, "16:9|4:3", option_string, &(command).shape, NULL},                           \
        {"held", 0, "VIEW", option_string, &(command).held, NULL},                                 \
        {"drag", 0, "HANDLE,U,V", option_string, &(command).drag, NULL},                           \
    {                                                                                              \
        "note", 0, "WORDS", option_string, &(command).note, NULL                                   \
    }

// Prints the script. chapter is the folder of the layouts; figures ends with one that has no name.
// Returns what main returns; messages name the program.
int plot_figure(const char *program, const char *chapter, const Figure *figures,
                FigureCommand command, void *given);

// The script alone, for callers other than the chapter programs, by the layout in that file. False,
// and a message on stderr, if a file cannot be read.
bool plot_script(FILE *out, const char *layout, const Figure *figure, const char *right,
                 const char *note, void *given);

#endif
