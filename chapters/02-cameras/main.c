// main.c - chapter 02: other ways to give a camera.
//
// Shows one camera in all five forms of the slides and finds it again from each; then one look-at
// in worlds of either handedness, the angle that NFF gives, and numbers that are not a camera. Its
// picture shows both.
#include "chapters/02-cameras/figures/figures.h"
#include "chapters/02-cameras/forms.h"
#include "chapters/shared/example.h"
#include "common/answers.h"
#include "common/options.h"
#include "common/picture.h"
#include "common/story.h"
#include "common/text.h"
#include "exercises/01-corners.h"
#include "exercises/02-cameras.h"

#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

// ---- a tiled floor, seen by the same look-at in both worlds -------------------------------------

// The x axis is red, the z axis blue, both from the origin in their positive direction. In one
// world red goes to the right, in the other to the left: the pictures are mirror images.

enum { SIDE = 320 }; // pixels of each half

static Color color_of_floor(vec3 eye, vec3 v)
{
    if (v[1] >= 0)
        return vec3_of(0.75, 0.85, 0.95); // the sky
    vec3 point = eye - eye[1] / v[1] * v;
    if (fabs(point[2]) < 0.06 && point[0] > 0)
        return vec3_of(0.8, 0.1, 0.1);
    if (fabs(point[0]) < 0.06 && point[2] > 0)
        return vec3_of(0.1, 0.2, 0.8);
    bool light = fmod(floor(point[0]) + floor(point[2]), 2) == 0;
    return light ? vec3_of(0.9, 0.88, 0.8) : vec3_of(0.55, 0.55, 0.5);
}

// If the camera was refused or is not answered yet, the pixel is black.
static Color color_of_pixel(Pixel pixel, void *given)
{
    (void)given;
    const LookAt view = {vec3_of(3, 2.5, 6), vec3_of(0.5, 0, 0.5), vec3_of(0, 1, 0), 6, 1};
    Camera camera;
    Handedness hand = pixel.column < SIDE ? RIGHT_HANDED : LEFT_HANDED;
    if (camera_from_look_at(view, hand, &camera) != CAMERA_OK)
        return vec3_of(0, 0, 0);
    vec3 v = image_plane_vector(camera, pixel.column % SIDE / (SIDE - 1.0),
                                1 - pixel.row / (SIDE - 1.0));
    return color_of_floor(view.eye, v);
}

// Draws both, right-handed on the left. Returns the exit status for main.
static int floor_picture(const char *path)
{
    return picture_write(path, (Resolution){2 * SIDE, SIDE}, color_of_pixel, NULL);
}

// ---- the story ----------------------------------------------------------------------------------

static const char *const handedness_names[] = {
    [RIGHT_HANDED] = "right-handed", [LEFT_HANDED] = "left-handed"};

static bool option_handedness(const char *text, void *into)
{
    *(int *)into = strcmp(text, "left") == 0 ? LEFT_HANDED : RIGHT_HANDED;
    return strcmp(text, "left") == 0 || strcmp(text, "right") == 0;
}

static void show_corners(Corners corners)
{
    story_line("  upper left", "%s", vec3_text(corners.upper_left).s);
    story_line("  upper right", "%s", vec3_text(corners.upper_right).s);
    story_line("  lower left", "%s", vec3_text(corners.lower_left).s);
    story_line("  lower right", "%s", vec3_text(corners.lower_right).s);
}

// The largest difference between the rays of two cameras through the same places, as unit vectors.
static double rays_apart(Camera c, Camera other)
{
    double largest = 0;
    static const double places[] = {0, 0.5, 1};
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) {
            vec3 v = vec3_unit(image_plane_vector(c, places[i], places[j]));
            vec3 w = vec3_unit(image_plane_vector(other, places[i], places[j]));
            largest = fmax(largest, vec3_length(v - w));
        }
    return largest;
}

static void show_back(const char *form, CameraFault fault, Camera found, Camera wanted)
{
    if (answers_missing() > 0)
        story_line(form, "not answered yet");
    else if (fault != CAMERA_OK)
        story_line(form, "refused: %s", camera_fault_text(fault));
    else
        story_line(form, "d %s, w %s, h %s; rays differ by %s", number_text(found.distance).s,
                   number_text(found.width).s, number_text(found.height).s,
                   number_text_to(rays_apart(wanted, found), 2).s);
}

static void five_forms(Camera c)
{
    Forms forms = forms_of(c);
    LookAt view = forms.look_at;

    story_heading("1. A frame <p, r, u, f, d, w, h>: %s", handedness_names[handedness_of(c)]);
    story_camera(c);
    story_heading("2. Look-at");
    story_line("eye", "%s", vec3_text(view.eye).s);
    story_line("at", "%s", vec3_text(view.at).s);
    story_line("up", "%s", vec3_text(view.up).s);
    story_line("width, aspect ratio", "%s, %s", number_text(view.width).s,
               number_text(view.aspect).s);
    story_heading("3. Eye and four points");
    story_line("eye", "%s", vec3_text(c.origin).s);
    show_corners(forms.points);
    story_heading("4. Eye, lower left corner, two vectors");
    story_line("eye", "%s", vec3_text(c.origin).s);
    story_line("  lower left corner", "%s", vec3_text(forms.points.lower_left).s);
    story_line("  across, up", "%s, %s", vec3_text(forms.across).s, vec3_text(forms.upward).s);
    story_heading("5. Eye and four vectors");
    story_line("eye", "%s", vec3_text(c.origin).s);
    show_corners(forms.vectors);

    story_heading("And back: the frame that was found from each form");
    Camera found = c;
    CameraFault fault = camera_from_look_at(view, handedness_of(c), &found);
    show_back("from the look-at", fault, found, c);
    fault = camera_from_points(c.origin, forms.points, &found);
    show_back("from four points", fault, found, c);
    fault =
        camera_from_corner(c.origin, forms.points.lower_left, forms.across, forms.upward, &found);
    show_back("from corner and vectors", fault, found, c);
    fault = camera_from_vectors(c.origin, forms.vectors, &found);
    show_back("from four vectors", fault, found, c);
}

static void both_worlds(Camera c)
{
    story_heading("The same look-at in a right-handed and in a left-handed world");
    for (Handedness hand = RIGHT_HANDED; hand <= LEFT_HANDED; hand++) {
        Camera found = c;
        CameraFault fault = camera_from_look_at(forms_of(c).look_at, hand, &found);
        if (answers_missing() > 0)
            story_line(handedness_names[hand], "not answered yet");
        else if (fault != CAMERA_OK)
            story_line(handedness_names[hand], "refused: %s", camera_fault_text(fault));
        else
            story_line(handedness_names[hand], "right %s", vec3_text(found.right).s);
    }
    printf("  If you mix them up, the picture is mirrored.\n");
}

static void angles(Camera c)
{
    double degrees = 2 * atan2(c.width / 2, c.distance) * 180 / PI;
    story_heading("The width from an angle, as NFF scenes give it");
    story_line("this camera sees", "%s degrees across", number_text(degrees).s);
    story_line("width from that angle", "%s", number_text(width_from_angle(degrees, c.distance)).s);
    story_line("90 degrees, distance 1", "%s", number_text(width_from_angle(90, 1)).s);
}

static void refusals(Camera c)
{
    Camera unused = c;
    LookAt at_the_eye = forms_of(c).look_at, up_along_view = at_the_eye;
    at_the_eye.at = at_the_eye.eye;
    up_along_view.up = 2 * (up_along_view.at - up_along_view.eye);
    Corners skew = forms_of(c).vectors, sideways = skew;
    skew.upper_right += 0.1 * c.width * c.right;
    sideways.upper_left += c.width * c.right;
    sideways.upper_right += c.width * c.right;
    sideways.lower_left += c.width * c.right;
    sideways.lower_right += c.width * c.right;

    story_heading("Numbers that are not a camera");
    const struct {
        const char *description;
        CameraFault fault;
    } tries[] = {
        {"looking at the eye", camera_from_look_at(at_the_eye, handedness_of(c), &unused)},
        {"up along the view", camera_from_look_at(up_along_view, handedness_of(c), &unused)},
        {"one corner moved", camera_from_vectors(c.origin, skew, &unused)},
        {"a plane not straight ahead", camera_from_vectors(c.origin, sideways, &unused)}};
    for (int i = 0; i < 4; i++)
        story_line(tries[i].description, "%s",
                   answers_missing() > 0 ? "not answered yet" : camera_fault_text(tries[i].fault));
}

static bool given(vec3 v)
{
    return !isnan(v[0]);
}

static double or_else(double x, double replacement)
{
    return isnan(x) ? replacement : x;
}

// The camera of a look-at. Exits with the reason if there is none.
static Camera camera_looking_at(const char *program, LookAt view, Handedness hand)
{
    Camera c = example_camera();
    CameraFault fault = camera_from_look_at(view, hand, &c);
    if (answers_report() != 0)
        exit(EXIT_COULD_NOT);
    if (fault != CAMERA_OK) {
        fprintf(stderr, "%s: this is not a camera: %s\n", program, camera_fault_text(fault));
        exit(EXIT_COULD_NOT);
    }
    return c;
}

int main(int argc, char **argv)
{
    const vec3 no = vec3_of(NAN, NAN, NAN);
    const Camera example = example_camera();
    Camera c = {no, no, no, no, NAN, NAN, NAN};
    vec3 at = no, lean = no;
    double aspect = NAN;
    int hand = -1;
    FigureCommand figure = {0};
    const char *picture = NULL;
    const Option options[] = {
        CAMERA_OPTIONS(c),
        {"at", 'a', "X,Y,Z", option_vec3, &at, "the look-at point, with --eye, --up, --width"},
        {"aspect", 0, "RATIO", option_number, &aspect, "of a look-at: width / height (1)"},
        {"handedness", 0, "left|right", option_handedness, &hand,
         "of a look-at: the handedness of the world (right)"},
        {"picture", 0, "FILE.png", option_string, &picture,
         "draw a floor in a right-handed and a left-handed world"},
        {"lean", 0, "X,Y,Z", option_vec3, &lean, NULL},
        FIGURE_OPTIONS(figure),
        {0}};
    Usage usage = {"[OPTION]...", "One camera in the five forms of the deck, and found from each.\n"
                                  "Without options: the lecture's camera."};
    if (options_read(argc, argv, options, usage) != argc)
        options_wrong(argv[0], "expected options only");
    if (picture != NULL)
        return floor_picture(picture);
    bool frame_only = given(c.right) || given(c.forward) || !isnan(c.distance) || !isnan(c.height);
    if (given(at) && frame_only)
        options_wrong(argv[0], "--at already gives right, forward, distance and height");
    if (!given(at) && (!isnan(aspect) || hand >= 0))
        options_wrong(argv[0], "--aspect and --handedness need --at");

    vec3 up = given(c.up) ? c.up : example.up;
    c.origin = given(c.origin) ? c.origin : example.origin;
    c.right = given(c.right) ? c.right : example.right;
    c.up = up;
    c.forward = given(c.forward) ? c.forward : example.forward;
    c.distance = or_else(c.distance, example.distance);
    c.width = or_else(c.width, example.width);
    c.height = or_else(c.height, example.height);
    if (given(at)) {
        LookAt view = {c.origin, at, up, c.width, or_else(aspect, 1)};
        c = camera_looking_at(argv[0], view, hand < 0 ? RIGHT_HANDED : (Handedness)hand);
    }
    story_needs_camera(argv[0], c);
    if (figure.name != NULL)
        return plot_figure(argv[0], "chapters/02-cameras", camera_figures, figure,
                           &(Given){c, up, lean});

    printf("02-cameras: one camera, given in five ways\n");
    if (given(at)) {
        story_heading("Up was given as %s", vec3_text(up).s);
        story_line("at right angles to f", "%s", vec3_text(c.up).s);
    }
    five_forms(c);
    both_worlds(c);
    angles(c);
    refusals(c);
    return story_end();
}
