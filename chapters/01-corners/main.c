// main.c - chapter 01: from the eye to the image plane.
//
// Answers the questions of the slides 'Camera' and 'Finding vectors from the eye to the image
// plane' step by step, for the lecture's camera or for the user's own. Its picture is the image
// plane: the color of each place shows the direction of its vector, and the three answers are
// white dots.
#include "chapters/01-corners/figures/figures.h"
#include "chapters/shared/example.h"
#include "common/options.h"
#include "common/picture.h"
#include "common/story.h"
#include "common/text.h"
#include "exercises/01-corners.h"

#include <stdio.h>

enum { PICTURE = 320 }; // pixels of the longer side

static void three_questions(Camera c)
{
    story_heading("Vectors from the eye to the image plane");
    story_line("upper left", "%s", vec3_text(upper_left(c)).s);
    story_line("upper right", "%s", vec3_text(upper_right(c)).s);
    story_line("30% across, 10% up", "%s", vec3_text(across_30_up_10(c)).s);
}

static void steps_to(Camera c, double s, double t)
{
    vec3 middle = image_plane_vector(c, 0.5, 0.5);
    vec3 sideways = image_plane_vector(c, s, 0.5);
    vec3 there = image_plane_vector(c, s, t);
    story_heading("From the eye to s = %s across, t = %s up", number_text(s).s, number_text(t).s);
    story_line("forward to the middle", "%s", vec3_text(middle).s);
    story_line("then sideways", "%-24s adds %s", vec3_text(sideways).s,
               vec3_text(sideways - middle).s);
    story_line("then up or down", "%-24s adds %s", vec3_text(there).s,
               vec3_text(there - sideways).s);
    story_line("as a point of the world", "%-24s adds the eye", vec3_text(c.origin + there).s);
}

static void doubling(Camera c)
{
    Camera twice = c;
    twice.distance *= 2;
    twice.width *= 2;
    twice.height *= 2;
    Camera unit = with_unit_distance(c);

    story_heading("Would it matter if d, w, h were all doubled?");
    printf("  %-10s %-10s %-10s %s\n", "d", "w", "h", "upper left");
    const Camera cameras[] = {c, twice, unit};
    for (int i = 0; i < 3; i++)
        printf("  %-10s %-10s %-10s %s\n", number_text(cameras[i].distance).s,
               number_text(cameras[i].width).s, number_text(cameras[i].height).s,
               vec3_text(image_plane_vector(cameras[i], 0, 1)).s);
    printf("  Only the lengths differ, not the directions: the same rays, the same picture.\n");
}

// Here s and t reach 0 and 1, so that the corners are in the picture.
static Color color_of_vector(Pixel pixel, void *given)
{
    const Camera *c = given;
    Resolution size = picture_shaped(c->width, c->height, PICTURE);
    vec3 v = image_plane_vector(*c, pixel.column / (size.width - 1.0),
                                1 - pixel.row / (size.height - 1.0));
    const vec3 dots[] = {upper_left(*c), upper_right(*c), across_30_up_10(*c)};
    for (int i = 0; i < 3; i++)
        if (vec3_length(v - dots[i]) < 0.03 * c->width)
            return vec3_of(1, 1, 1);
    vec3 along = vec3_of(vec3_dot(v, c->right), vec3_dot(v, c->up), vec3_dot(v, c->forward));
    return (vec3_unit(along) * 1.6 + vec3_of(1, 1, 0)) / 2;
}

int main(int argc, char **argv)
{
    View view = {example_camera(), NAN, NAN, vec3_of(NAN, NAN, NAN)};
    FigureCommand figure = {0};
    const char *picture = NULL;
    const Option options[] = {
        CAMERA_OPTIONS(view.camera),
        {"s", 's', "S", option_number, &view.s, "how far across the plane, 0 to 1"},
        {"t", 't', "T", option_number, &view.t, "how far up the plane, 0 to 1"},
        {"picture", 0, "FILE.png", option_string, &picture, "draw the image plane instead of text"},
        {"yours", 0, "X,Y,Z", option_vec3, &view.yours,
         "your vector in the figure yours-and-right"},
        FIGURE_OPTIONS(figure),
        {0}};
    Usage usage = {"[OPTION]...",
                   "From the eye to the image plane, step by step. Without options:\n"
                   "the lecture's camera, and the vector to its upper left corner."};
    if (options_read(argc, argv, options, usage) != argc)
        options_wrong(argv[0], "expected options only");
    Camera c = view.camera;
    story_needs_camera(argv[0], c);
    // By default the text shows the upper left corner, and a figure the place of the example.
    bool drawn = figure.name != NULL;
    view.s = isnan(view.s) ? (drawn ? example_place().s : 0) : view.s;
    view.t = isnan(view.t) ? (drawn ? example_place().t : 1) : view.t;
    if (drawn)
        return plot_figure(argv[0], "chapters/01-corners", corner_figures, figure, &view);
    if (picture != NULL)
        return picture_write(picture, picture_shaped(c.width, c.height, PICTURE), color_of_vector,
                             &c);

    printf("01-corners: from the eye to the image plane\n");
    story_heading("The camera <p, r, u, f, d, w, h>");
    story_camera(c);
    three_questions(c);
    steps_to(c, view.s, view.t);
    doubling(c);
    return story_end();
}
