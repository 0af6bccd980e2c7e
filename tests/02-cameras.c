// 02-cameras.c - tests of exercise 02. Expected values: the deck's camera, cameras worked out by
// hand, and cameras that are taken apart along their own axes and must be found again.
#include "exercises/02-cameras.h"
#include "exercises/01-corners.h"

#include "tests/judge/test.h"

#include <math.h>

#define TOLERANCE 1e-9

// Reasons, a bit for each: if more than one is true, any of them may be given. A test lists first
// the one that it is about, since that is shown to a student who gives none; then those that are
// also true.
enum {
    FINITE = 1 << CAMERA_NOT_FINITE,
    DISTANCE = 1 << CAMERA_NO_DISTANCE,
    WIDTH = 1 << CAMERA_NO_WIDTH,
    HEIGHT = 1 << CAMERA_NO_HEIGHT,
    DIRECTION = 1 << CAMERA_NO_DIRECTION,
    UP = 1 << CAMERA_UP_ALONG_VIEW,
    RECTANGLE = 1 << CAMERA_NO_RECTANGLE,
    AXIS = 1 << CAMERA_OFF_AXIS,
};

// VECTORS and POINTS: eye, upper left, upper right, lower left, lower right.
// CORNER: eye, lower left, across, up.
typedef enum { VECTORS, POINTS, CORNER } Form;

// ---- cameras, and what every answer must do with them -------------------------------------------

// The same picture, mirrored: the other handedness.
static Camera mirrored(Camera c)
{
    c.right = -c.right;
    return c;
}

// The value of *camera before the call, and still after a refusal.
static Camera untouched(void)
{
    return (Camera){{11, 12, 13}, {14, 15, 16}, {17, 18, 19}, {20, 21, 22}, 23, 24, 25};
}

static void expect_found(CameraFault fault, Camera found, Camera expected, double size)
{
    if (fault != CAMERA_OK)
        expect_fault(fault, CAMERA_OK);
    expect_camera_of_size(found, expected, TOLERANCE, size);
}

// The deck's camera a few times, then others.
static Camera camera_number(int i)
{
    return i < 5 ? camera_of_the_deck() : random_camera();
}

// In a world that is that many times as large.
static Camera scaled(Camera c, double size)
{
    c.origin *= size;
    c.distance *= size;
    c.width *= size;
    c.height *= size;
    return c;
}

enum { SIZES = 13 };

// The i-th camera in worlds of any size, from 1e-9 to 1e9, and how large that world is.
static Camera camera_of_any_size(int i, double *size)
{
    Camera c = random_camera();
    *size = pow(random_scale(i, SIZES), 1.5);
    return scaled(c, *size);
}

static Normalized random_place(void)
{
    double s = floor(random_number(0, 21)) / 20;
    return (Normalized){s, floor(random_number(0, 21)) / 20};
}

// The rays through one place of the plane, and from the same eye: to twelve digits.
static void expect_same_ray_through(Normalized place, CameraFault fault, Camera yours, Camera same)
{
    if (fault != CAMERA_OK)
        expect_fault(fault, CAMERA_OK);
    given("seen", "the ray through (s, t) = %s", pair_text(place.s, place.t).s);
    Ray ray = {yours.origin, image_plane_vector(yours, place.s, place.t)};
    Ray expected = {same.origin, vec3_unit(image_plane_vector(same, place.s, place.t))};
    expect_same_ray(ray, expected, 1e-12);
}

static CameraFault first_of(int reasons)
{
    int fault = CAMERA_OK;
    while ((reasons >> fault & 1) == 0)
        fault++;
    return (CameraFault)fault;
}

static void expect_refused(CameraFault fault, Camera after, int reasons, int also)
{
    bool is_reason =
        fault > CAMERA_OK && fault < CAMERA_FAULTS && ((reasons | also) >> fault & 1) == 1;
    expects((Expectation){.reasons = reasons | also});
    if (!is_reason)
        expect_fault(fault, first_of(reasons));
    given("refused", "and *camera stays as it was");
    expect_camera(after, untouched(), 0);
}

// NaN, infinity, minus infinity.
static double not_finite(int i)
{
    static const double values[] = {NAN, INFINITY, -INFINITY};
    return values[i % 3];
}

// Eye and four vectors, eye and four points, and eye, corner and two vectors are three ways to give
// one rectangle, so each is called with the same rectangles.

enum { MOST_PARTS = 5 };

static int parts_of(Form form)
{
    return form == CORNER ? 4 : 5;
}

static CameraFault call(Form form, const vec3 *in, Camera *camera)
{
    if (form == CORNER)
        return camera_from_corner(in[0], in[1], in[2], in[3], camera);
    Corners corners = {in[1], in[2], in[3], in[4]};
    return form == VECTORS ? camera_from_vectors(in[0], corners, camera)
                           : camera_from_points(in[0], corners, camera);
}

// Says what is given, and calls the function.
static CameraFault ask(Form form, const vec3 *in, Camera *camera)
{
    *camera = untouched();
    given_vec3("eye", in[0]);
    if (form == CORNER) {
        given_vec3("lower left", in[1]);
        given_vec3("across", in[2]);
        given_vec3("up", in[3]);
    } else
        given(form == VECTORS ? "vectors" : "points",
              "upper left %s, upper right %s, lower left %s, lower right %s",
              vec3_text_to(in[1], 10).s, vec3_text_to(in[2], 10).s, vec3_text_to(in[3], 10).s,
              vec3_text_to(in[4], 10).s);
    return call(form, in, camera);
}

// Vectors from the eye to the corners, in the words of a form.
static void put(Form form, vec3 eye, Corners v, vec3 *in)
{
    vec3 from = form == VECTORS ? vec3_of(0, 0, 0) : eye;
    in[0] = eye;
    in[1] = from + v.upper_left;
    in[2] = from + v.upper_right;
    in[3] = from + v.lower_left;
    in[4] = from + v.lower_right;
    if (form == CORNER) {
        in[1] = eye + v.lower_left;
        in[2] = v.lower_right - v.lower_left;
        in[3] = v.upper_left - v.lower_left;
    }
}

static vec3 corner(Camera c, double x, double y)
{
    return c.distance * c.forward + x * c.width / 2 * c.right + y * c.height / 2 * c.up;
}

static Corners corners_of(Camera c)
{
    return (Corners){corner(c, -1, 1), corner(c, 1, 1), corner(c, -1, -1), corner(c, 1, -1)};
}

static void take_apart(Form form, Camera c, vec3 *in)
{
    put(form, c.origin, corners_of(c), in);
}

// Calls with these numbers, in a world of that size.
static void finds_of_size(Form form, const vec3 *in, Camera expected, double size)
{
    Camera found;
    CameraFault fault = ask(form, in, &found);
    expect_found(fault, found, expected, size);
}

static void finds(Form form, const vec3 *in, Camera expected)
{
    finds_of_size(form, in, expected, 1);
}

// Calls with random cameras of both handednesses, taken apart.
// Some large and some small: rounding grows with the numbers, so the tolerance for a rectangle
// depends on its size. One looks from the origin.
static void finds_random_cameras(Form form)
{
    for (int i = 0; i < 15; i++) {
        Camera c = random_camera();
        vec3 origin = i == 8 ? vec3_of(0, 0, 0) : c.origin, in[MOST_PARTS];
        c = scaled(c, i < 9 ? 1 : i % 2 == 0 ? 1e4 : 1e-4);
        c.origin = origin;
        take_apart(form, c, in);
        finds(form, in, c);
    }
}

// The laws of scale: calls with cameras in worlds of any size; and again with shapes that must be
// refused, in a tiny world and in an enormous one.
static void finds_cameras_of_any_size(Form form)
{
    for (int i = 0; i < SIZES; i++) {
        double size;
        Camera c = camera_of_any_size(i, &size);
        vec3 in[MOST_PARTS];
        take_apart(form, c, in);
        finds_of_size(form, in, c, size);
    }
}

static void keeps_the_rays(Form form)
{
    for (int i = 0; i < 15; i++) {
        Camera c = camera_number(i), found;
        Normalized place = random_place();
        vec3 in[MOST_PARTS];
        take_apart(form, c, in);
        CameraFault fault = ask(form, in, &found);
        expect_same_ray_through(place, fault, found, c);
    }
}

// Vectors that do not give a camera: upper left, upper right, lower left, lower right. If the edges
// or the middle of the corners are not straight ahead, the reason may also be 'off the axis'; an
// eye in the very middle is not off the axis. A line or a point may be refused as not a rectangle.
// A test ends at the first that is accepted, so the first one is one that half a check refuses.
static const struct {
    const char *what;
    Corners vectors;
    int reasons;
} no_cameras[] = {
    {"a trapezoid", {{-1, 1, 4}, {1, 1, 4}, {-2, -1, 4}, {2, -1, 4}}, RECTANGLE},
    {"a parallelogram", {{-0.5, 1, 4}, {1.5, 1, 4}, {-1.5, -1, 4}, {0.5, -1, 4}}, RECTANGLE},
    {"a parallelogram that hardly leans",
     {{-1.001, 1, 4}, {0.999, 1, 4}, {-0.999, -1, 4}, {1.001, -1, 4}},
     RECTANGLE},
    {"a parallelogram that leans by a ten millionth",
     {{-1.0000001, 1, 4}, {0.9999999, 1, 4}, {-0.9999999, -1, 4}, {1.0000001, -1, 4}},
     RECTANGLE},
    {"a rectangle except for one corner",
     {{-1.5, 1, 4}, {0.5, 1, 4}, {-1.5, -1, 4}, {2.5, -1, 4}},
     RECTANGLE | AXIS},
    {"a rectangle except for one corner, slightly moved",
     {{-1, 1, 4}, {1, 1, 4}, {-1, -1, 4}, {1.001, -1, 4}},
     RECTANGLE | AXIS},
    {"a rectangle, far away, except for one corner, moved by a millionth",
     {{-1, 1, 1000}, {1, 1, 1000}, {-1, -1, 1000}, {1.000001, -1, 1000}},
     RECTANGLE | AXIS},
    {"a rectangle except for its upper left corner",
     {{-1.5, 1, 4}, {1, 1, 4}, {-1, -1, 4}, {1, -1, 4}},
     RECTANGLE | AXIS},
    {"a rectangle except for its upper right corner",
     {{-1, 1, 4}, {1, 1.5, 4}, {-1, -1, 4}, {1, -1, 4}},
     RECTANGLE | AXIS},
    {"a rectangle except for its lower left corner",
     {{-1, 1, 4}, {1, 1, 4}, {-1.5, -1.5, 4}, {1, -1, 4}},
     RECTANGLE | AXIS},
    {"a rectangle except for one corner, bent back",
     {{-1, 1, 4}, {1, 1, 4}, {-1, -1, 4}, {1, -1, 5}},
     RECTANGLE | AXIS},
    {"a rectangle with its lower corners swapped",
     {{-1, 1, 4}, {1, 1, 4}, {1, -1, 4}, {-1, -1, 4}},
     RECTANGLE},
    // Opposite edges are of equal length, and so are the diagonals.
    {"a saddle", {{-1, 1, 5}, {1, 1, 3}, {-1, -1, 3}, {1, -1, 5}}, RECTANGLE | AXIS},

    {"a rectangle above and to the side", {{0, 2, 4}, {2, 2, 4}, {0, 0, 4}, {2, 0, 4}}, AXIS},
    {"a rectangle to the side", {{0, 1, 4}, {2, 1, 4}, {0, -1, 4}, {2, -1, 4}}, AXIS},
    {"a rectangle slightly to the side",
     {{-1.001, 1, 4}, {0.999, 1, 4}, {-1.001, -1, 4}, {0.999, -1, 4}},
     AXIS},
    {"a rectangle, far away, slightly to the side",
     {{-0.9999, 1, 1000}, {1.0001, 1, 1000}, {-0.9999, -1, 1000}, {1.0001, -1, 1000}},
     AXIS},
    {"a rectangle to the side by four ten millionths",
     {{-1.0000004, 1, 4}, {0.9999996, 1, 4}, {-1.0000004, -1, 4}, {0.9999996, -1, 4}},
     AXIS},
    {"a rectangle below by four ten millionths",
     {{-1, 0.9999996, 4}, {1, 0.9999996, 4}, {-1, -1.0000004, 4}, {1, -1.0000004, 4}},
     AXIS},
    {"a rectangle above", {{-1, 2, 4}, {1, 2, 4}, {-1, 0, 4}, {1, 0, 4}}, AXIS},
    {"a rectangle slightly below",
     {{-1, 0.999, 4}, {1, 0.999, 4}, {-1, -1.001, 4}, {1, -1.001, 4}},
     AXIS},
    {"a rectangle that leans back", {{-1, 1, 5}, {1, 1, 5}, {-1, -1, 3}, {1, -1, 3}}, AXIS},
    {"a rectangle turned to the side", {{-1, 1, 3}, {1, 1, 5}, {-1, -1, 3}, {1, -1, 5}}, AXIS},

    {"a rectangle around the eye",
     {{-1, 1, 0}, {1, 1, 0}, {-1, -1, 0}, {1, -1, 0}},
     DISTANCE | AXIS},
    {"a rectangle beside the eye", {{1, 1, 0}, {3, 1, 0}, {1, -1, 0}, {3, -1, 0}}, DISTANCE | AXIS},
    {"the eye itself, four times",
     {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}},
     DISTANCE | WIDTH | HEIGHT | RECTANGLE | AXIS},
    {"a vertical line", {{0, 1, 4}, {0, 1, 4}, {0, -1, 4}, {0, -1, 4}}, WIDTH | RECTANGLE},
    {"one point, four times",
     {{0, 0, 4}, {0, 0, 4}, {0, 0, 4}, {0, 0, 4}},
     WIDTH | HEIGHT | RECTANGLE},
    {"a triangle", {{0, 1, 4}, {0, 1, 4}, {-1, -1, 4}, {1, -1, 4}}, WIDTH | RECTANGLE},
    {"a horizontal line", {{-1, 0, 4}, {1, 0, 4}, {-1, 0, 4}, {1, 0, 4}}, HEIGHT | RECTANGLE},
};

// A corner and two vectors can give no shapes but parallelograms.
static bool can_say(Form form, Corners v)
{
    vec3 gap = v.upper_right - v.upper_left - (v.lower_right - v.lower_left);
    return form != CORNER || vec3_length(gap) == 0;
}

// In a world of that size: the eye's coordinates and all lengths are multiplied by it.
static void refuses_one(Form form, size_t shape, double size)
{
    vec3 in[MOST_PARTS];
    Corners v = no_cameras[shape].vectors;
    Camera after;
    put(form, vec3_of(2, 2, -4), v, in);
    for (int i = 0; i < MOST_PARTS; i++)
        in[i] *= size;
    given("corners of", "%s", no_cameras[shape].what);
    CameraFault fault = ask(form, in, &after);
    expect_refused(fault, after, no_cameras[shape].reasons, 0);
}

// Calls with each shape that is not a rectangle, or not straight ahead, and whose first reason is
// one of these.
static void refuses(Form form, int reasons)
{
    for (size_t i = 0; i < sizeof no_cameras / sizeof no_cameras[0]; i++)
        if ((reasons >> first_of(no_cameras[i].reasons) & 1) == 1 &&
            can_say(form, no_cameras[i].vectors))
            refuses_one(form, i, 1);
}

// Powers of two, which round nothing: about 1e-9 and 1e9.
static void refuses_in_worlds_of_any_size(Form form)
{
    for (size_t i = 0; i < sizeof no_cameras / sizeof no_cameras[0]; i++)
        if (can_say(form, no_cameras[i].vectors))
            refuses_one(form, i, i % 3 == 2 ? 0x1p30 : 0x1p-30);
}

// Calls with the rectangles of random cameras, pushed out of shape or place.
static void refuses_what_was_pushed(Form form)
{
    for (int i = 0; i < 12; i++) {
        Camera c = random_camera(), after;
        double by = random_number(0.1, 0.9);
        vec3 aside = by * c.width * c.right, ahead = by * c.distance * c.forward;
        const struct {
            const char *what;
            vec3 upper, lower, lower_right; // how far these are pushed, the last one more
            int reasons;
        } pushes[] = {
            {"a rectangle pushed to the side", aside, aside, 0 * aside, AXIS},
            {"a rectangle pushed into a parallelogram", aside, -aside, 0 * aside, RECTANGLE},
            {"a rectangle pushed until it leans", ahead, -ahead, 0 * aside, AXIS},
            {"a rectangle with one corner pushed", 0 * aside, 0 * aside, aside, RECTANGLE | AXIS},
        };
        int push = i % (form == CORNER ? 3 : 4);
        vec3 in[MOST_PARTS];
        Corners v = corners_of(c);
        v.upper_left += pushes[push].upper;
        v.upper_right += pushes[push].upper;
        v.lower_left += pushes[push].lower;
        v.lower_right += pushes[push].lower + pushes[push].lower_right;
        put(form, c.origin, v, in);
        given("corners of", "%s", pushes[push].what);
        CameraFault fault = ask(form, in, &after);
        expect_refused(fault, after, pushes[push].reasons, 0);
    }
}

// Calls with each number in turn not finite, and all others those of the deck's camera.
// Corners that are NaN or infinitely far away are not those of a rectangle straight ahead; nor are
// points seen from such an eye.
static void refuses_what_is_not_finite(Form form)
{
    for (int part = 0; part < parts_of(form); part++)
        for (int axis = 0; axis < 3; axis++) {
            vec3 in[MOST_PARTS];
            Camera after;
            take_apart(form, camera_of_the_deck(), in);
            in[part][axis] = not_finite(part + axis);
            CameraFault fault = ask(form, in, &after);
            bool is_only_the_eye = form == VECTORS && part == 0;
            expect_refused(fault, after, FINITE, is_only_the_eye ? 0 : RECTANGLE | AXIS);
        }
}

// ---- eye and four vectors ----------------------------------------------------------------------

TEST(camera_from_vectors, the_four_vectors_of_the_deck_give_its_camera)
{
    vec3 in[] = {{2, 2, -4}, {-1, 1, 4}, {1, 1, 4}, {-1, -1, 4}, {1, -1, 4}};
    finds(VECTORS, in, camera_of_the_deck());
}

// By hand: (2, 4, 4), then 4.5 r = (3, -3, 1.5) and 1.5 u = (1, 0.5, -1), to and fro.
TEST(camera_from_vectors, four_vectors_give_an_oblique_camera_of_either_hand)
{
    vec3 in[] = {{3, -5, 7}, {0, 7.5, 1.5}, {6, 1.5, 4.5}, {-2, 6.5, 3.5}, {4, 0.5, 6.5}};
    vec3 swapped[] = {in[0], in[2], in[1], in[4], in[3]};
    finds(VECTORS, swapped, mirrored(tilted_camera()));
    finds(VECTORS, in, tilted_camera());
}

TEST_LINE(camera_from_vectors, four_vectors_of_any_camera_give_it_back,
          finds_random_cameras(VECTORS))
TEST_LINE(camera_from_vectors, four_vectors_keep_the_rays_to_twelve_digits, keeps_the_rays(VECTORS))
TEST_LINE(camera_from_vectors, four_vectors_that_do_not_end_in_a_rectangle_are_refused,
          refuses(VECTORS, RECTANGLE))
TEST_LINE(camera_from_vectors, four_vectors_to_a_rectangle_not_straight_ahead_are_refused,
          refuses(VECTORS, AXIS))
TEST_LINE(camera_from_vectors, four_vectors_that_leave_no_distance_width_or_height_are_refused,
          refuses(VECTORS, DISTANCE | WIDTH | HEIGHT))
TEST_LINE(camera_from_vectors, four_vectors_pushed_out_of_shape_or_place_are_refused,
          refuses_what_was_pushed(VECTORS))
TEST_LINE(camera_from_vectors, four_vectors_that_are_not_finite_are_refused,
          refuses_what_is_not_finite(VECTORS))
TEST_LINE(camera_from_vectors, four_vectors_in_worlds_of_any_size_give_the_camera,
          finds_cameras_of_any_size(VECTORS))
TEST_LINE(camera_from_vectors, four_vectors_of_an_invalid_camera_are_refused_in_worlds_of_any_size,
          refuses_in_worlds_of_any_size(VECTORS))

// ---- eye and four points -----------------------------------------------------------------------

// The deck draws the plane at z = 0, with x and y from 1 to 3.
TEST(camera_from_points, the_four_points_of_the_deck_give_its_camera)
{
    vec3 in[] = {{2, 2, -4}, {1, 3, 0}, {3, 3, 0}, {1, 1, 0}, {3, 1, 0}};
    finds(POINTS, in, camera_of_the_deck());
}

TEST_LINE(camera_from_points, four_points_of_any_camera_give_it_back, finds_random_cameras(POINTS))
TEST_LINE(camera_from_points, four_points_keep_the_rays_to_twelve_digits, keeps_the_rays(POINTS))
TEST_LINE(camera_from_points, four_points_that_are_not_a_rectangle_are_refused,
          refuses(POINTS, RECTANGLE))
TEST_LINE(camera_from_points, four_points_of_a_rectangle_not_straight_ahead_are_refused,
          refuses(POINTS, AXIS))
TEST_LINE(camera_from_points, four_points_that_leave_no_distance_width_or_height_are_refused,
          refuses(POINTS, DISTANCE | WIDTH | HEIGHT))
TEST_LINE(camera_from_points, four_points_pushed_out_of_shape_or_place_are_refused,
          refuses_what_was_pushed(POINTS))
TEST_LINE(camera_from_points, four_points_that_are_not_finite_are_refused,
          refuses_what_is_not_finite(POINTS))
TEST_LINE(camera_from_points, four_points_in_worlds_of_any_size_give_the_camera,
          finds_cameras_of_any_size(POINTS))
TEST_LINE(camera_from_points, four_points_of_an_invalid_camera_are_refused_in_worlds_of_any_size,
          refuses_in_worlds_of_any_size(POINTS))

// ---- eye, lower left corner and two vectors ----------------------------------------------------

TEST(camera_from_corner, the_corner_and_two_vectors_of_the_deck_give_its_camera)
{
    vec3 in[] = {{2, 2, -4}, {1, 1, 0}, {2, 0, 0}, {0, 2, 0}};
    finds(CORNER, in, camera_of_the_deck());
}

// By hand: the lower left point above, 9 r = (6, -6, 3), 3 u = (2, 1, -2); mirrored, the corner is
// the lower right point.
TEST(camera_from_corner, a_corner_and_two_vectors_give_an_oblique_camera_of_either_hand)
{
    vec3 in[] = {{3, -5, 7}, {1, 1.5, 10.5}, {6, -6, 3}, {2, 1, -2}};
    vec3 swapped[] = {{3, -5, 7}, {7, -4.5, 13.5}, {-6, 6, -3}, {2, 1, -2}};
    finds(CORNER, swapped, mirrored(tilted_camera()));
    finds(CORNER, in, tilted_camera());
}

TEST_LINE(camera_from_corner, the_corner_and_two_vectors_of_any_camera_give_it_back,
          finds_random_cameras(CORNER))
TEST_LINE(camera_from_corner, a_corner_and_two_vectors_keep_the_rays_to_twelve_digits,
          keeps_the_rays(CORNER))
TEST_LINE(camera_from_corner, two_vectors_that_are_not_at_right_angles_are_refused,
          refuses(CORNER, RECTANGLE))
TEST_LINE(camera_from_corner,
          a_corner_and_two_vectors_of_a_rectangle_not_straight_ahead_are_refused,
          refuses(CORNER, AXIS))
TEST_LINE(camera_from_corner,
          a_corner_and_two_vectors_that_leave_no_distance_width_or_height_are_refused,
          refuses(CORNER, DISTANCE | WIDTH | HEIGHT))
TEST_LINE(camera_from_corner, a_corner_and_two_vectors_pushed_out_of_shape_or_place_are_refused,
          refuses_what_was_pushed(CORNER))
TEST_LINE(camera_from_corner, a_corner_and_two_vectors_that_are_not_finite_are_refused,
          refuses_what_is_not_finite(CORNER))
TEST_LINE(camera_from_corner, a_corner_and_two_vectors_in_worlds_of_any_size_give_the_camera,
          finds_cameras_of_any_size(CORNER))
TEST_LINE(camera_from_corner,
          corner_and_vectors_of_an_invalid_camera_are_refused_in_worlds_of_any_size,
          refuses_in_worlds_of_any_size(CORNER))

// ---- look-at: the cameras that it must find ----------------------------------------------------

// Says what is given, and calls the function.
static CameraFault look(LookAt view, Handedness world, Camera *camera)
{
    *camera = untouched();
    given_vec3("eye", view.eye);
    given_vec3("at", view.at);
    given_vec3("up", view.up);
    given_number("width", view.width);
    given_number("aspect", view.aspect);
    given("world", world == RIGHT_HANDED ? "right-handed" : "left-handed");
    return camera_from_look_at(view, world, camera);
}

static void look_finds(LookAt view, Handedness world, Camera expected)
{
    Camera found;
    CameraFault fault = look(view, world, &found);
    expect_found(fault, found, expected, 1);
}

// The deck's, except for these.
static LookAt deck_with(vec3 up, double width, double aspect)
{
    return (LookAt){vec3_of(2, 2, -4), vec3_of(2, 2, 0), up, width, aspect};
}

static LookAt look_at_of_the_deck(void)
{
    return deck_with(vec3_of(0, 1, 0), 2, 1);
}

static LookAt deck_with_size(double width, double aspect)
{
    return deck_with(vec3_of(0, 1, 0), width, aspect);
}

// By hand: the eye and 6 f = (2, 4, 4) are the point looked at; up is 3 u.
static LookAt oblique_look_at(void)
{
    return (LookAt){vec3_of(3, -5, 7), vec3_of(5, -1, 11), vec3_of(2, 1, -2), 9, 3};
}

// A look-at that must give the camera; its up leans towards the view or away from it.
static LookAt random_look_at(Camera c)
{
    double lean = random_number(-2, 2), size = random_number(0.1, 9);
    return (LookAt){c.origin, c.origin + c.distance * c.forward, size * (c.up + lean * c.forward),
                    c.width, c.width / c.height};
}

// The hand whose thumb, first and middle finger are right, up and forward.
static Handedness handedness_of(Camera c)
{
    return vec3_dot(vec3_cross(c.right, c.up), c.forward) > 0 ? LEFT_HANDED : RIGHT_HANDED;
}

TEST_LINE(camera_from_look_at, the_look_at_of_the_deck_gives_its_camera_in_a_left_handed_world,
          look_finds(look_at_of_the_deck(), LEFT_HANDED, camera_of_the_deck()))
TEST_LINE(camera_from_look_at, the_look_at_of_the_deck_is_mirrored_in_a_right_handed_world,
          look_finds(look_at_of_the_deck(), RIGHT_HANDED, mirrored(camera_of_the_deck())))

// As in scenes: x to the right, y up, and z towards the eye.
TEST(camera_from_look_at, along_minus_z_in_a_right_handed_world_x_is_to_the_right)
{
    LookAt view = {vec3_of(1, 2, 9), vec3_of(1, 2, 4), vec3_of(0, 1, 0), 4, 2};
    Camera c = {vec3_of(1, 2, 9), vec3_of(1, 0, 0), vec3_of(0, 1, 0), vec3_of(0, 0, -1), 5, 4, 2};
    look_finds(view, RIGHT_HANDED, c);
}

TEST(camera_from_look_at, an_oblique_look_at_in_a_world_of_either_hand)
{
    look_finds(oblique_look_at(), LEFT_HANDED, tilted_camera());
    look_finds(oblique_look_at(), RIGHT_HANDED, mirrored(tilted_camera()));
}

// By hand: u + f = (1, 1, 0), whose part across the view is 1 long; (4 u + 3 f) / 5, which is 1
// long itself; 3 u + 3 f = (3, 3, 0), 3 u - 3 f = (1, -1, -4), 30 u = (20, 10, -20). The last is
// very short, but not 0.
TEST(camera_from_look_at, up_may_lean_and_have_any_length)
{
    static const vec3 ups[] = {
        {1, 1, 0},     {11.0 / 15, 2.0 / 3, -2.0 / 15}, {3, 3, 0}, {1, -1, -4},
        {20, 10, -20}, {2e-12, 1e-12, -2e-12},
    };
    for (size_t i = 0; i < sizeof ups / sizeof ups[0]; i++) {
        LookAt view = oblique_look_at();
        view.up = ups[i];
        look_finds(view, LEFT_HANDED, tilted_camera());
        look_finds(view, RIGHT_HANDED, mirrored(tilted_camera()));
    }
}

TEST(camera_from_look_at, up_may_lean_until_it_is_almost_along_the_view)
{
    look_finds(deck_with(vec3_of(0, 0.001, 1), 2, 1), LEFT_HANDED, camera_of_the_deck());
    look_finds(deck_with(vec3_of(0, 1e-7, 1), 2, 1), LEFT_HANDED, camera_of_the_deck());
}

// At last with an up that is very short.
TEST(camera_from_look_at, the_look_at_of_any_camera_gives_it_back)
{
    for (int i = 0; i < 15; i++) {
        Camera c = random_camera();
        LookAt view = random_look_at(c);
        if (i > 12)
            view.up *= 1e-11;
        look_finds(view, handedness_of(c), c);
    }
}

// The law of scale: with eye, at and width k times as large, the camera is k times as large; the
// length of up is free.
TEST(camera_from_look_at, a_look_at_in_worlds_of_any_size_gives_the_camera)
{
    for (int i = 0; i < SIZES; i++) {
        double size;
        Camera c = camera_of_any_size(i, &size), found;
        LookAt view = random_look_at(c);
        view.up *= random_scale((5 * i) % SIZES, SIZES);
        CameraFault fault = look(view, handedness_of(c), &found);
        expect_found(fault, found, c, size);
    }
}

TEST(camera_from_look_at, a_look_at_keeps_the_rays_to_twelve_digits)
{
    for (int i = 0; i < 15; i++) {
        Camera c = camera_number(i), found;
        Normalized place = random_place();
        CameraFault fault = look(random_look_at(c), handedness_of(c), &found);
        expect_same_ray_through(place, fault, found, c);
    }
}

// The cross product is then a hundred millionth long, and rounding shows: right must be made
// perpendicular once more, or the camera is refused. Extra: the deck's formula need not do that.
EXTRA_TEST(camera_from_look_at, up_may_be_almost_along_an_oblique_view)
{
    for (int i = 0; i < 15; i++) {
        Camera c = random_camera(), found;
        LookAt view = {c.origin, c.origin + c.distance * c.forward, c.forward + 1e-8 * c.up,
                       c.width, c.width / c.height};
        expect_fault(look(view, handedness_of(c), &found), CAMERA_OK);
    }
}

// ---- look-at: what must be refused -------------------------------------------------------------

// In either world.
static void look_refuses_also(LookAt view, int reasons, int also)
{
    Camera after;
    CameraFault fault = look(view, RIGHT_HANDED, &after);
    expect_refused(fault, after, reasons, also);
    fault = look(view, LEFT_HANDED, &after);
    expect_refused(fault, after, reasons, also);
}

static void look_refuses(LookAt view, int reasons)
{
    look_refuses_also(view, reasons, 0);
}

// The plane passes through the point looked at, so the distance is 0 as well.
TEST(camera_from_look_at, looking_at_the_eye_itself_is_refused)
{
    LookAt view = look_at_of_the_deck();
    view.at = view.eye;
    look_refuses_also(view, DIRECTION, DISTANCE);
}

TEST_LINE(camera_from_look_at, an_up_of_zero_is_refused,
          look_refuses(deck_with(vec3_of(0, 0, 0), 2, 1), UP))

// Once in round numbers, then with numbers whose rounding leaves a little to the side.
static void look_refuses_an_up_along_the_view(double sign)
{
    LookAt view = deck_with(vec3_of(0, 0, 5 * sign), 2, 1);
    look_refuses(view, UP);
    for (int i = 0; i < 10; i++) {
        vec3 forward = random_unit();
        view.eye = random_vec3(-5, 5);
        view.at = view.eye + (i % 3 == 0 ? 0.3 : 3) * forward;
        view.up = sign * random_number(0.1, i % 2 == 0 ? 0.9 : 9) * forward;
        look_refuses(view, UP);
    }
}

TEST_LINE(camera_from_look_at, an_up_along_the_view_is_refused,
          look_refuses_an_up_along_the_view(1))
TEST_LINE(camera_from_look_at, an_up_against_the_view_is_refused,
          look_refuses_an_up_along_the_view(-1))

TEST(camera_from_look_at, a_width_that_is_not_positive_is_refused)
{
    look_refuses(deck_with_size(0, 1), WIDTH | HEIGHT);
    look_refuses(deck_with_size(-2, 1), WIDTH | HEIGHT);
    for (int i = 0; i < 5; i++)
        look_refuses(deck_with_size(-random_number(0.1, 9), 1.5), WIDTH | HEIGHT);
}

// With an aspect of 0 the height is infinite.
TEST(camera_from_look_at, an_aspect_that_is_not_positive_is_refused)
{
    look_refuses_also(deck_with_size(2, 0), HEIGHT, FINITE);
    look_refuses(deck_with_size(2, -1), HEIGHT);
    for (int i = 0; i < 6; i++)
        look_refuses(deck_with_size(i % 2 == 0 ? 3 : 0.3, -random_number(0.1, 9)), HEIGHT);
}

// From infinitely far above, the view is along up, and so is an up that is infinite along the view.
TEST(camera_from_look_at, a_look_at_whose_vectors_are_not_finite_is_refused)
{
    for (int axis = 0; axis < 3; axis++) {
        LookAt view = look_at_of_the_deck();
        view.eye[axis] = not_finite(axis);
        look_refuses_also(view, FINITE, axis == 1 ? UP : 0);
        view = look_at_of_the_deck();
        view.at[axis] = not_finite(axis + 1);
        look_refuses_also(view, FINITE, axis == 1 ? UP : 0);
        view = look_at_of_the_deck();
        view.up[axis] = not_finite(axis + 2);
        look_refuses_also(view, FINITE, axis == 2 ? UP : 0);
    }
}

// NaN and minus infinity are not positive either, and an infinite aspect leaves no height.
TEST(camera_from_look_at, a_width_or_aspect_that_is_not_finite_is_refused)
{
    for (int i = 0; i < 3; i++) {
        look_refuses(deck_with_size(not_finite(i), 1), FINITE | WIDTH | HEIGHT);
        look_refuses(deck_with_size(2, not_finite(i)), FINITE | HEIGHT);
        look_refuses(deck_with_size(0.2, not_finite(i)), FINITE | HEIGHT);
    }
}

// ---- width from angle -------------------------------------------------------------------------

static void expect_width_of_size(double degrees, double distance, double width, double size)
{
    given_number("degrees", degrees);
    given_number("distance", distance);
    expect_number(width_from_angle(degrees, distance), width, TOLERANCE * size);
}

static void expect_width(double degrees, double distance, double width)
{
    expect_width_of_size(degrees, distance, width, 1);
}

// Half of the picture is a right-angled triangle with two equal legs.
TEST(width_from_angle, at_90_degrees_the_plane_is_twice_as_wide_as_its_distance)
{
    expect_width(90, 1, 2);
    expect_width(90, 3.5, 7);
}

// By hand: eye and edges are an equilateral triangle, its height the distance.
TEST(width_from_angle, at_60_degrees_the_plane_is_as_wide_as_the_distance_to_its_edges)
{
    expect_width(60, 1, 2 / sqrt(3));
    expect_width(60, sqrt(3), 2);
}

// By hand: the tangent of 22.5 degrees is sqrt(2) - 1, of 15 it is 2 - sqrt(3), of 60 sqrt(3).
TEST(width_from_angle, at_30_45_and_120_degrees_the_tangents_are_known)
{
    expect_width(45, 1, 2 * sqrt(2) - 2);
    expect_width(30, 1, 4 - 2 * sqrt(3));
    expect_width(120, 1, 2 * sqrt(3));
}

// For a small x the tangent is x + x^3 / 3 + 2 x^5 / 15 + 17 x^7 / 315.
TEST(width_from_angle, at_any_small_angle_the_width_is_that_of_the_tangent_series)
{
    for (int i = 0; i < 10; i++) {
        double degrees = pow(10, -6 + 0.6 * i) * random_number(1, 2), distance = 2;
        double x = degrees * PI / 360;
        double series = x + pow(x, 3) / 3 + 2 * pow(x, 5) / 15 + 17 * pow(x, 7) / 315;
        expect_width_of_size(degrees, distance, 2 * distance * series, 2 * distance * series);
    }
}

// Whole numbers first: they are shorter to read.
TEST(width_from_angle, seen_from_the_eye_the_edges_are_the_given_angle_apart)
{
    for (int i = 0; i < 25; i++) {
        double degrees = random_number(1, 175), distance = random_number(1, 20);
        if (i < 15) {
            degrees = floor(degrees);
            distance = floor(distance);
        }
        given_number("degrees", degrees);
        given_number("distance", distance);
        given("seen", "the angle between the edges, in degrees");
        double half = atan2(width_from_angle(degrees, distance) / 2, distance);
        expect_number(2 * half * 180 / PI, degrees, TOLERANCE);
    }
}

// ---- probes -------------------------------------------------------------------------------------

// Calls that distinguish the mistakes of exercise 02: any cameras in each form, of both
// handednesses, and some that must be refused.

enum { MANY = 16 };

// *camera holds another camera before each call.
static void ask_form(Form form, Camera c, Corners from_the_eye)
{
    vec3 in[MOST_PARTS];
    put(form, c.origin, from_the_eye, in);
    Camera before = random_camera();
    call(form, in, &before);
}

// Any; seen from its own axis, where points could also be read as vectors; narrow or low beside its
// distance, by any amount; and small, with a fixed limit between its sides.
static void ask_of_rectangles(Form form)
{
    for (int i = 0; i < MANY; i++) {
        Camera c = random_camera();
        if (i % 4 == 3) // the mean is a unit vector
            c.distance = 1;
        if (i % 8 == 1)
            c.height = c.width;
        if (i % 8 == 6) // vectors and points are the same
            c.origin = vec3_of(0, 0, 0);
        ask_form(form, c, corners_of(c));
        c = random_camera();
        c.origin = random_number(0.3, 4) * c.forward;
        ask_form(form, c, corners_of(c));
        c = random_camera();
        *(i % 2 == 0 ? &c.width : &c.height) *= pow(10, random_number(-4, -1));
        ask_form(form, c, corners_of(c));
        double small = pow(10, random_number(-6.3, -5.7));
        c = random_camera();
        c.origin = vec3_of(0, 0, 0);
        c.distance = 4 * small;
        c.width = (i % 2 == 0 ? 4 : 0.3) * small;
        c.height = (i % 2 == 0 ? 0.3 : 4) * small;
        ask_form(form, c, corners_of(c));
    }
}

// One thing wrong with the corners at a time: off the axis, sheared, one corner elsewhere, flat, or
// not finite.
static Corners spoilt_corners(Camera c, int i)
{
    double off = random_number(0.05, 2);
    if (i % 8 == 4)
        c.distance = 0;
    if (i % 8 == 5)
        *(i / 8 % 2 == 0 ? &c.width : &c.height) = 0;
    Corners v = corners_of(c);
    vec3 *corners[] = {&v.upper_left, &v.upper_right, &v.lower_left, &v.lower_right};
    vec3 side = i / 8 % 2 == 0 ? c.right : c.up;
    int kind = i % 8, which = i / 8;
    for (int k = 0; k < 4; k++)
        if (kind == 0 || (kind == 1 && k < 2) || (kind == 2 && k >= 2))
            *corners[k] += off * side;
    if (kind == 3)
        *corners[which % 4] += off * random_unit();
    if (kind == 6)
        (*corners[which % 4])[which % 3] = not_finite(which % 3);
    if (kind == 7)
        *corners[3] += off * (which % 2 == 0 ? random_unit() : c.forward);
    return v;
}

// Straight ahead, but not a rectangle: sheared, leaning, one corner elsewhere, or bent; and
// rectangles that are only shifted to the side or up, or turned. In worlds of any size.
static Corners spoilt_alone(Camera c, int i)
{
    Corners v = corners_of(c);
    vec3 *corners[] = {&v.upper_left, &v.upper_right, &v.lower_left, &v.lower_right};
    double off = (i % 2 == 0 ? 1 : -1) * pow(10, random_number(-4, 0)) * c.distance;
    vec3 way = random_unit();
    int astray = i / 7 % 2 == 0 ? 3 : i / 14 % 3; // mostly the one that edges do not begin at
    for (int k = 0; k < 4; k++) {
        double x = k % 2 == 0 ? -1 : 1, y = k < 2 ? 1 : -1;
        *corners[k] += i % 7 == 0   ? y * off * c.right
                       : i % 7 == 1 ? x * off * c.up
                       : i % 7 == 2 ? (k == astray ? 1 : -1 / 3.) * off * way
                       : i % 7 == 3 ? x * y * off * c.forward
                       : i % 7 == 4 ? off * c.right
                       : i % 7 == 5 ? off * c.up
                                    : (i / 7 % 2 == 0 ? x : y) * off * c.forward;
    }
    return v;
}

static void ask_of_faults(Form form)
{
    for (int i = 0; i < 4 * MANY; i++) {
        Camera c = random_camera();
        Corners v = i % 16 == 14 ? corners_of(c) : spoilt_corners(c, i);
        if (i % 16 == 14)
            c.origin[i / 16 % 3] = not_finite(i / 16 % 3);
        if (i % 16 == 11)
            c.origin = vec3_of(0, 0, 0);
        ask_form(form, c, v);

        c = scaled(random_camera(), pow(10, random_number(-9, 6)));
        if (i / 2 % 2 == 1) { // wide and high
            double width = c.width;
            c.width = c.height;
            c.height = width;
        }
        ask_form(form, c, spoilt_alone(c, i));
    }
}

PROBE_LINE(camera_from_vectors, vectors_to_any_rectangle, ask_of_rectangles(VECTORS))
PROBE_LINE(camera_from_vectors, vectors_to_what_is_none, ask_of_faults(VECTORS))
PROBE_LINE(camera_from_points, points_of_any_rectangle, ask_of_rectangles(POINTS))
PROBE_LINE(camera_from_points, points_of_what_is_none, ask_of_faults(POINTS))
PROBE_LINE(camera_from_corner, corner_of_any_rectangle, ask_of_rectangles(CORNER))

// Edges that are unit vectors, at any distance.
PROBE(camera_from_corner, corner_of_a_unit_square)
{
    for (int i = 0; i < MANY; i++) {
        Camera c = random_camera();
        c.width = c.height = 1;
        ask_form(CORNER, c, corners_of(c));
    }
}

PROBE(camera_from_corner, corner_of_what_is_none)
{
    ask_of_faults(CORNER);
    for (int i = 0; i < MANY; i++) { // up along across, straight ahead
        Camera before = random_camera();
        vec3 across = random_vec3(-2, 2), corner = random_vec3(-5, 5);
        vec3 up = random_number(-2, 2) * across;
        vec3 ahead = random_number(1, 5) * vec3_unit(vec3_cross(across, random_unit()));
        camera_from_corner(corner + across / 2 + up / 2 - ahead, corner, across, up, &before);
    }
}

// One thing wrong with a view at a time.
static LookAt spoilt(LookAt view, int i)
{
    vec3 forward = view.at - view.eye;
    int way = i / 12;
    if (way % 2 == 1) { // close by
        forward *= random_number(0.05, 0.9) / vec3_length(forward);
        view.at = view.eye + forward;
    }
    int kind = i % 12;
    vec3 *vectors[] = {&view.eye, &view.at, &view.up};
    double *numbers[] = {&view.width, &view.aspect};
    if (kind == 0)
        view.at = view.eye;
    else if (kind < 3)
        view.up = (kind == 1 ? 1 : -1) * random_number(0.2, 4) * forward;
    else if (kind == 3)
        view.up = vec3_of(0, 0, 0);
    else if (kind < 6)
        *numbers[kind - 4] = way % 2 == 0 ? 0 : -random_number(0.1, 3);
    else if (kind < 8)
        *numbers[kind - 6] = not_finite(way % 3);
    else if (kind < 11)
        (*vectors[kind - 8])[way % 3] = not_finite(way % 3);
    else // nothing: up leans, and is short
        view.up = random_number(1e-6, 1e-3) * (forward + random_number(0.05, 0.3) * random_unit());
    return view;
}

static LookAt any_look_at(void)
{
    vec3 eye = random_vec3(-5, 5);
    vec3 at = eye + random_number(0.3, 6) * random_unit();
    vec3 up = random_number(0.3, 3) * random_unit();
    double width = random_number(0.5, 4);
    return (LookAt){
        .eye = eye, .at = at, .up = up, .width = width, .aspect = random_number(0.4, 2.5)};
}

static void look_once(LookAt view, int i)
{
    Camera before = random_camera();
    camera_from_look_at(view, i % 2 == 0 ? RIGHT_HANDED : LEFT_HANDED, &before);
}

PROBE(camera_from_look_at, any_view)
{
    for (int i = 0; i < 2 * MANY; i++)
        look_once(any_look_at(), i);
}

// Near, narrow, or with a short up; alone.
PROBE(camera_from_look_at, any_small_view)
{
    for (int i = 0; i < 2 * MANY; i++) {
        LookAt view = any_look_at();
        double small = pow(10, random_number(-13, -5));
        if (i % 3 == 0) {
            view.at = small * (view.at - view.eye);
            view.eye = vec3_of(0, 0, 0);
        }
        if (i % 3 == 1)
            view.width *= small;
        if (i % 3 == 2)
            view.up *= small;
        look_once(view, i);
    }
}

PROBE(camera_from_look_at, views_that_are_none)
{
    for (int i = 0; i < 48; i++)
        look_once(spoilt(any_look_at(), i), i);
}

PROBE(width_from_angle, any_angle)
{
    for (int i = 0; i < MANY; i++) {
        double degrees = random_number(5, 175);
        width_from_angle(degrees, random_number(0.2, 7));
    }
}
