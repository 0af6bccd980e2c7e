// 02-cameras.c - tests of exercise 02. Expected: the deck's camera, cameras worked by hand, and
// that a camera taken apart along its own axes is found again.
//
// Eye and four vectors, eye and four points, and eye, corner and two vectors are three ways to
// give one rectangle, so each is asked for the same rectangles.
#include "exercises/02-cameras.h"
#include "exercises/01-corners.h"

#include "tests/judge/test.h"

static const double tolerance = 1e-9;
static const double ray_tolerance = 1e-12;

// The camera of the tests of exercise 01, left-handed: no two numbers alike, nothing 0 or 1.
static Camera oblique_camera(void)
{
    return (Camera){.origin = vec3_of(3, -5, 7),
                    .right = vec3_of(2, -2, 1) / 3,
                    .up = vec3_of(2, 1, -2) / 3,
                    .forward = vec3_of(1, 2, 2) / 3,
                    .distance = 6,
                    .width = 9,
                    .height = 3};
}

// The same picture, mirrored: the other hand.
static Camera mirrored(Camera c)
{
    c.right = -c.right;
    return c;
}

// What *camera holds before the call, and still holds after a refusal.
static Camera untouched(void)
{
    return (Camera){.origin = vec3_of(11, 12, 13),
                    .right = vec3_of(14, 15, 16),
                    .up = vec3_of(17, 18, 19),
                    .forward = vec3_of(20, 21, 22),
                    .distance = 23,
                    .width = 24,
                    .height = 25};
}

// ---- what every answer must do ----------------------------------------------------------------

static void expect_found(CameraFault fault, Camera found, Camera expected)
{
    if (fault != CAMERA_OK)
        expect_fault(fault, CAMERA_OK);
    expect_camera(found, expected, tolerance);
}

// The deck's a few times, then others.
static Camera camera_number(int i)
{
    return i < 5 ? camera_of_the_deck() : random_camera();
}

static Normalized random_place(void)
{
    return (Normalized){floor(random_number(0, 21)) / 20, floor(random_number(0, 21)) / 20};
}

// The rays through one place of the plane, and from the same eye.
static void expect_same_ray_through(Normalized place, CameraFault fault, Camera yours, Camera same)
{
    if (fault != CAMERA_OK)
        expect_fault(fault, CAMERA_OK);
    given("seen", "the ray through (s, t) = %s", pair_text(place.s, place.t).s);
    Ray ray = {yours.origin, image_plane_vector(yours, place.s, place.t)};
    Ray expected = {same.origin, vec3_unit(image_plane_vector(same, place.s, place.t))};
    expect_same_ray(ray, expected, ray_tolerance);
}

// Reasons, a bit for each: where more than one is true, any of them may be given.
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

static CameraFault first_of(int reasons)
{
    int fault = CAMERA_OK;
    while ((reasons >> fault & 1) == 0)
        fault++;
    return (CameraFault)fault;
}

static void expect_refused(CameraFault fault, Camera after, int reasons)
{
    bool is_reason = fault > CAMERA_OK && fault < CAMERA_FAULTS && (reasons >> fault & 1) == 1;
    if (!is_reason)
        expect_fault(fault, first_of(reasons));
    given("refused", "and *camera stays as it was");
    expect_camera(after, untouched(), 0);
}

// ---- the three that give a rectangle ----------------------------------------------------------

// VECTORS and POINTS: eye, upper left, upper right, lower left, lower right.
// CORNER: eye, lower left, across, up.
typedef enum { VECTORS, POINTS, CORNER } Form;
enum { MOST_PARTS = 5 };

static int parts_of(Form form)
{
    return form == CORNER ? 4 : 5;
}

// Says what is given, and asks.
static CameraFault ask(Form form, const vec3 *in, Camera *camera)
{
    *camera = untouched();
    given_vec3("eye", in[0]);
    if (form == CORNER) {
        given_vec3("lower left", in[1]);
        given_vec3("across", in[2]);
        given_vec3("up", in[3]);
        return camera_from_corner(in[0], in[1], in[2], in[3], camera);
    }
    given(form == VECTORS ? "vectors" : "points",
          "upper left %s, upper right %s, lower left %s, lower right %s", vec3_text_to(in[1], 10).s,
          vec3_text_to(in[2], 10).s, vec3_text_to(in[3], 10).s, vec3_text_to(in[4], 10).s);
    Corners corners = {in[1], in[2], in[3], in[4]};
    return form == VECTORS ? camera_from_vectors(in[0], corners, camera)
                           : camera_from_points(in[0], corners, camera);
}

// Vectors from the eye to upper left, upper right, lower left, lower right, in the words of a form.
static void put(Form form, vec3 eye, const vec3 *vectors, vec3 *in)
{
    in[0] = eye;
    for (int i = 0; i < 4; i++)
        in[1 + i] = form == VECTORS ? vectors[i] : eye + vectors[i];
    if (form == CORNER) {
        in[1] = eye + vectors[2];
        in[2] = vectors[3] - vectors[2];
        in[3] = vectors[0] - vectors[2];
    }
}

static void take_apart(Form form, Camera c, vec3 *in)
{
    vec3 middle = c.distance * c.forward;
    vec3 right = 0.5 * c.width * c.right, up = 0.5 * c.height * c.up;
    vec3 vectors[] = {middle - right + up, middle + right + up, middle - right - up,
                      middle + right - up};
    put(form, c.origin, vectors, in);
}

static void finds(Form form, const vec3 *in, Camera expected)
{
    Camera found;
    CameraFault fault = ask(form, in, &found);
    expect_found(fault, found, expected);
}

// Of both hands.
static void finds_random_cameras(Form form)
{
    for (int i = 0; i < 15; i++) {
        Camera c = random_camera();
        vec3 in[MOST_PARTS];
        take_apart(form, c, in);
        finds(form, in, c);
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

// Vectors that lead to no camera: upper left, upper right, lower left, lower right. The eye may be
// called off the axis of four corners whose edges or whose middle are not straight ahead.
static const struct {
    const char *what;
    vec3 vectors[4];
    int reasons;
} no_cameras[] = {
    {"a parallelogram", {{-0.5, 1, 4}, {1.5, 1, 4}, {-1.5, -1, 4}, {0.5, -1, 4}}, RECTANGLE},
    {"a parallelogram that hardly leans",
     {{-1.001, 1, 4}, {0.999, 1, 4}, {-0.999, -1, 4}, {1.001, -1, 4}},
     RECTANGLE},
    {"a trapezoid", {{-1, 1, 4}, {1, 1, 4}, {-2, -1, 4}, {2, -1, 4}}, RECTANGLE},
    {"a rectangle but for one corner, astray",
     {{-1.5, 1, 4}, {0.5, 1, 4}, {-1.5, -1, 4}, {2.5, -1, 4}},
     RECTANGLE | AXIS},
    {"a rectangle but for one corner, hardly astray",
     {{-1, 1, 4}, {1, 1, 4}, {-1, -1, 4}, {1.001, -1, 4}},
     RECTANGLE | AXIS},
    {"a rectangle but for one corner, bent back",
     {{-1, 1, 4}, {1, 1, 4}, {-1, -1, 4}, {1, -1, 5}},
     RECTANGLE | AXIS},
    {"a rectangle, its lower corners swapped",
     {{-1, 1, 4}, {1, 1, 4}, {1, -1, 4}, {-1, -1, 4}},
     RECTANGLE},
    // Opposite edges are of equal length, and so are the diagonals.
    {"a saddle", {{-1, 1, 5}, {1, 1, 3}, {-1, -1, 3}, {1, -1, 5}}, RECTANGLE | AXIS},

    {"a rectangle aside", {{0, 1, 4}, {2, 1, 4}, {0, -1, 4}, {2, -1, 4}}, AXIS},
    {"a rectangle hardly aside",
     {{-1.001, 1, 4}, {0.999, 1, 4}, {-1.001, -1, 4}, {0.999, -1, 4}},
     AXIS},
    {"a rectangle above", {{-1, 2, 4}, {1, 2, 4}, {-1, 0, 4}, {1, 0, 4}}, AXIS},
    {"a rectangle hardly below",
     {{-1, 0.999, 4}, {1, 0.999, 4}, {-1, -1.001, 4}, {1, -1.001, 4}},
     AXIS},
    {"a rectangle that leans back", {{-1, 1, 5}, {1, 1, 5}, {-1, -1, 3}, {1, -1, 3}}, AXIS},
    {"a rectangle turned aside", {{-1, 1, 3}, {1, 1, 5}, {-1, -1, 3}, {1, -1, 5}}, AXIS},

    {"a rectangle around the eye", {{-1, 1, 0}, {1, 1, 0}, {-1, -1, 0}, {1, -1, 0}}, DISTANCE},
    {"a rectangle beside the eye", {{1, 1, 0}, {3, 1, 0}, {1, -1, 0}, {3, -1, 0}}, DISTANCE | AXIS},
    {"the eye itself, four times",
     {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}},
     DISTANCE | WIDTH | HEIGHT},
    {"a line upright", {{0, 1, 4}, {0, 1, 4}, {0, -1, 4}, {0, -1, 4}}, WIDTH},
    {"one point, four times", {{0, 0, 4}, {0, 0, 4}, {0, 0, 4}, {0, 0, 4}}, WIDTH | HEIGHT},
    {"a triangle", {{0, 1, 4}, {0, 1, 4}, {-1, -1, 4}, {1, -1, 4}}, WIDTH | RECTANGLE},
    {"a line across", {{-1, 0, 4}, {1, 0, 4}, {-1, 0, 4}, {1, 0, 4}}, HEIGHT},
};

// A corner and two vectors cannot say anything else.
static bool is_parallelogram(const vec3 *corners)
{
    return vec3_length(corners[1] - corners[0] - (corners[3] - corners[2])) == 0;
}

// Asks for each of them whose first reason is among these.
static void refuses(Form form, int reasons)
{
    for (size_t i = 0; i < sizeof no_cameras / sizeof no_cameras[0]; i++) {
        const vec3 *vectors = no_cameras[i].vectors;
        if ((reasons >> first_of(no_cameras[i].reasons) & 1) == 0 ||
            (form == CORNER && !is_parallelogram(vectors)))
            continue;
        vec3 in[MOST_PARTS];
        Camera after;
        put(form, vec3_of(2, 2, -4), vectors, in);
        given("corners of", "%s", no_cameras[i].what);
        CameraFault fault = ask(form, in, &after);
        expect_refused(fault, after, no_cameras[i].reasons);
    }
}

static const double not_finite[] = {NAN, INFINITY, -INFINITY};

// Each number in turn, in what is otherwise the deck's camera.
static void refuses_what_is_not_finite(Form form)
{
    for (int part = 0; part < parts_of(form); part++)
        for (int axis = 0; axis < 3; axis++) {
            vec3 in[MOST_PARTS];
            Camera after;
            take_apart(form, camera_of_the_deck(), in);
            in[part][axis] = not_finite[(part + axis) % 3];
            CameraFault fault = ask(form, in, &after);
            expect_refused(fault, after, FINITE);
        }
}

// ---- eye and four vectors ---------------------------------------------------------------------

START_TEST(the_four_vectors_of_the_deck_give_its_camera)
{
    vec3 in[] = {{2, 2, -4}, {-1, 1, 4}, {1, 1, 4}, {-1, -1, 4}, {1, -1, 4}};
    finds(VECTORS, in, camera_of_the_deck());
}
END_TEST

// By hand: (2, 4, 4), then 4.5 r = (3, -3, 1.5) and 1.5 u = (1, 0.5, -1), to and fro.
START_TEST(four_vectors_give_an_oblique_camera_of_either_hand)
{
    vec3 in[] = {{3, -5, 7}, {0, 7.5, 1.5}, {6, 1.5, 4.5}, {-2, 6.5, 3.5}, {4, 0.5, 6.5}};
    finds(VECTORS, in, oblique_camera());
    vec3 swapped[] = {in[0], in[2], in[1], in[4], in[3]};
    finds(VECTORS, swapped, mirrored(oblique_camera()));
}
END_TEST

START_TEST(four_vectors_of_any_camera_give_it_back)
{
    finds_random_cameras(VECTORS);
}
END_TEST

START_TEST(four_vectors_keep_the_rays_to_twelve_digits)
{
    keeps_the_rays(VECTORS);
}
END_TEST

START_TEST(four_vectors_that_end_in_no_rectangle_are_refused)
{
    refuses(VECTORS, RECTANGLE);
}
END_TEST

START_TEST(four_vectors_to_a_rectangle_not_straight_ahead_are_refused)
{
    refuses(VECTORS, AXIS);
}
END_TEST

START_TEST(four_vectors_that_leave_no_distance_width_or_height_are_refused)
{
    refuses(VECTORS, DISTANCE | WIDTH | HEIGHT);
}
END_TEST

START_TEST(four_vectors_that_are_not_finite_are_refused)
{
    refuses_what_is_not_finite(VECTORS);
}
END_TEST

// ---- eye and four points ----------------------------------------------------------------------

// The deck draws the plane at z = 0, with x and y from 1 to 3.
START_TEST(the_four_points_of_the_deck_give_its_camera)
{
    vec3 in[] = {{2, 2, -4}, {1, 3, 0}, {3, 3, 0}, {1, 1, 0}, {3, 1, 0}};
    finds(POINTS, in, camera_of_the_deck());
}
END_TEST

// By hand: the four vectors above, from the eye on.
START_TEST(four_points_give_an_oblique_camera_of_either_hand)
{
    vec3 in[] = {{3, -5, 7}, {3, 2.5, 8.5}, {9, -3.5, 11.5}, {1, 1.5, 10.5}, {7, -4.5, 13.5}};
    finds(POINTS, in, oblique_camera());
    vec3 swapped[] = {in[0], in[2], in[1], in[4], in[3]};
    finds(POINTS, swapped, mirrored(oblique_camera()));
}
END_TEST

START_TEST(four_points_of_any_camera_give_it_back)
{
    finds_random_cameras(POINTS);
}
END_TEST

START_TEST(four_points_keep_the_rays_to_twelve_digits)
{
    keeps_the_rays(POINTS);
}
END_TEST

START_TEST(four_points_that_are_no_rectangle_are_refused)
{
    refuses(POINTS, RECTANGLE);
}
END_TEST

START_TEST(four_points_of_a_rectangle_not_straight_ahead_are_refused)
{
    refuses(POINTS, AXIS);
}
END_TEST

START_TEST(four_points_that_leave_no_distance_width_or_height_are_refused)
{
    refuses(POINTS, DISTANCE | WIDTH | HEIGHT);
}
END_TEST

START_TEST(four_points_that_are_not_finite_are_refused)
{
    refuses_what_is_not_finite(POINTS);
}
END_TEST

// ---- eye, lower left corner, two vectors ------------------------------------------------------

START_TEST(the_corner_and_two_vectors_of_the_deck_give_its_camera)
{
    vec3 in[] = {{2, 2, -4}, {1, 1, 0}, {2, 0, 0}, {0, 2, 0}};
    finds(CORNER, in, camera_of_the_deck());
}
END_TEST

// By hand: the lower left point above, 9 r = (6, -6, 3), 3 u = (2, 1, -2); mirrored, the corner is
// the lower right point.
START_TEST(a_corner_and_two_vectors_give_an_oblique_camera_of_either_hand)
{
    vec3 in[] = {{3, -5, 7}, {1, 1.5, 10.5}, {6, -6, 3}, {2, 1, -2}};
    finds(CORNER, in, oblique_camera());
    vec3 swapped[] = {{3, -5, 7}, {7, -4.5, 13.5}, {-6, 6, -3}, {2, 1, -2}};
    finds(CORNER, swapped, mirrored(oblique_camera()));
}
END_TEST

START_TEST(the_corner_and_two_vectors_of_any_camera_give_it_back)
{
    finds_random_cameras(CORNER);
}
END_TEST

START_TEST(a_corner_and_two_vectors_keep_the_rays_to_twelve_digits)
{
    keeps_the_rays(CORNER);
}
END_TEST

START_TEST(two_vectors_that_are_not_at_right_angles_are_refused)
{
    refuses(CORNER, RECTANGLE);
}
END_TEST

START_TEST(a_corner_and_two_vectors_of_a_rectangle_not_straight_ahead_are_refused)
{
    refuses(CORNER, AXIS);
}
END_TEST

START_TEST(a_corner_and_two_vectors_that_leave_no_distance_width_or_height_are_refused)
{
    refuses(CORNER, DISTANCE | WIDTH | HEIGHT);
}
END_TEST

START_TEST(a_corner_and_two_vectors_that_are_not_finite_are_refused)
{
    refuses_what_is_not_finite(CORNER);
}
END_TEST

// ---- look-at ----------------------------------------------------------------------------------

// Says what is given, and asks.
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
    expect_found(fault, found, expected);
}

// In either world.
static void look_refuses(LookAt view, int reasons)
{
    Camera after;
    CameraFault fault = look(view, RIGHT_HANDED, &after);
    expect_refused(fault, after, reasons);
    fault = look(view, LEFT_HANDED, &after);
    expect_refused(fault, after, reasons);
}

static LookAt look_at_of_the_deck(void)
{
    return (LookAt){vec3_of(2, 2, -4), vec3_of(2, 2, 0), vec3_of(0, 1, 0), 2, 1};
}

// By hand: the eye and 6 f = (2, 4, 4) are the point looked at; up is 3 u.
static LookAt oblique_look_at(void)
{
    return (LookAt){vec3_of(3, -5, 7), vec3_of(5, -1, 11), vec3_of(2, 1, -2), 9, 3};
}

// What a camera looks at, with an up that leans towards the view or away from it.
static LookAt random_look_at(Camera c)
{
    double lean = random_number(-2, 2), size = random_number(0.1, 9);
    return (LookAt){c.origin, c.origin + c.distance * c.forward, size * (c.up + lean * c.forward),
                    c.width, c.width / c.height};
}

// The hand whose thumb, first and middle finger are right, up and forward.
static Handedness hand_of(Camera c)
{
    return vec3_dot(vec3_cross(c.right, c.up), c.forward) > 0 ? LEFT_HANDED : RIGHT_HANDED;
}

START_TEST(the_look_at_of_the_deck_gives_its_camera_in_a_left_handed_world)
{
    look_finds(look_at_of_the_deck(), LEFT_HANDED, camera_of_the_deck());
}
END_TEST

START_TEST(the_look_at_of_the_deck_is_mirrored_in_a_right_handed_world)
{
    look_finds(look_at_of_the_deck(), RIGHT_HANDED, mirrored(camera_of_the_deck()));
}
END_TEST

// As in scenes: x to the right, y up, and z towards the eye.
START_TEST(along_minus_z_in_a_right_handed_world_x_is_to_the_right)
{
    LookAt view = {vec3_of(1, 2, 9), vec3_of(1, 2, 4), vec3_of(0, 1, 0), 4, 2};
    Camera c = {vec3_of(1, 2, 9), vec3_of(1, 0, 0), vec3_of(0, 1, 0), vec3_of(0, 0, -1), 5, 4, 2};
    look_finds(view, RIGHT_HANDED, c);
}
END_TEST

START_TEST(an_oblique_look_at_in_a_world_of_either_hand)
{
    look_finds(oblique_look_at(), LEFT_HANDED, oblique_camera());
    look_finds(oblique_look_at(), RIGHT_HANDED, mirrored(oblique_camera()));
}
END_TEST

// By hand: 3 u + 3 f = (3, 3, 0), 3 u - 3 f = (1, -1, -4), 30 u = (20, 10, -20).
// The last is very short, but not 0.
START_TEST(up_may_lean_and_have_any_length)
{
    static const vec3 ups[] = {{3, 3, 0}, {1, -1, -4}, {20, 10, -20}, {2e-12, 1e-12, -2e-12}};
    for (size_t i = 0; i < sizeof ups / sizeof ups[0]; i++) {
        LookAt view = oblique_look_at();
        view.up = ups[i];
        look_finds(view, LEFT_HANDED, oblique_camera());
        look_finds(view, RIGHT_HANDED, mirrored(oblique_camera()));
    }
}
END_TEST

START_TEST(up_may_lean_until_it_is_almost_along_the_view)
{
    LookAt view = look_at_of_the_deck();
    view.up = vec3_of(0, 0.001, 1);
    look_finds(view, LEFT_HANDED, camera_of_the_deck());
}
END_TEST

// By hand: 4 wide on a screen of 640 x 480 is 3 high.
START_TEST(the_height_is_the_width_by_the_aspect)
{
    LookAt view = look_at_of_the_deck();
    Camera c = camera_of_the_deck();
    view.width = c.width = 4;
    view.aspect = 640.0 / 480;
    c.height = 3;
    look_finds(view, LEFT_HANDED, c);
}
END_TEST

static vec3 whole_numbers(void)
{
    vec3 v = random_vec3(-9, 10);
    return vec3_of(floor(v[0]), floor(v[1]), floor(v[2]));
}

START_TEST(the_plane_passes_through_the_point_looked_at)
{
    for (int i = 0; i < 15; i++) {
        LookAt view = {whole_numbers(), whole_numbers(), whole_numbers(), 2, 1};
        Camera found;
        CameraFault fault = look(view, i % 2 == 0 ? RIGHT_HANDED : LEFT_HANDED, &found);
        if (fault != CAMERA_OK)
            expect_fault(fault, CAMERA_OK);
        given("seen", "the middle of the plane");
        expect_vec3(found.origin + found.distance * found.forward, view.at, tolerance);
    }
}
END_TEST

START_TEST(the_look_at_of_any_camera_gives_it_back)
{
    for (int i = 0; i < 15; i++) {
        Camera c = random_camera();
        look_finds(random_look_at(c), hand_of(c), c);
    }
}
END_TEST

START_TEST(a_look_at_keeps_the_rays_to_twelve_digits)
{
    for (int i = 0; i < 15; i++) {
        Camera c = camera_number(i), found;
        Normalized place = random_place();
        CameraFault fault = look(random_look_at(c), hand_of(c), &found);
        expect_same_ray_through(place, fault, found, c);
    }
}
END_TEST

START_TEST(looking_at_the_eye_itself_is_refused)
{
    LookAt view = look_at_of_the_deck();
    view.at = view.eye;
    look_refuses(view, DIRECTION);
}
END_TEST

START_TEST(an_up_of_zero_is_refused)
{
    LookAt view = look_at_of_the_deck();
    view.up = vec3_of(0, 0, 0);
    look_refuses(view, UP);
}
END_TEST

// Once in round numbers, then where rounding leaves a little to the side.
START_TEST(an_up_along_the_view_is_refused)
{
    LookAt view = look_at_of_the_deck();
    view.up = vec3_of(0, 0, 5);
    look_refuses(view, UP);
    for (int i = 0; i < 10; i++) {
        vec3 forward = random_unit();
        view.at = view.eye + 3 * forward;
        view.up = random_number(0.1, 9) * forward;
        look_refuses(view, UP);
    }
}
END_TEST

START_TEST(an_up_against_the_view_is_refused)
{
    LookAt view = look_at_of_the_deck();
    view.up = vec3_of(0, 0, -5);
    look_refuses(view, UP);
}
END_TEST

START_TEST(a_width_that_is_not_positive_is_refused)
{
    LookAt view = look_at_of_the_deck();
    view.width = 0;
    look_refuses(view, WIDTH | HEIGHT);
    view.width = -2;
    look_refuses(view, WIDTH | HEIGHT);
}
END_TEST

START_TEST(an_aspect_that_is_not_positive_is_refused)
{
    LookAt view = look_at_of_the_deck();
    view.aspect = 0;
    look_refuses(view, HEIGHT);
    view.aspect = -1;
    look_refuses(view, HEIGHT);
}
END_TEST

START_TEST(a_look_at_whose_vectors_are_not_finite_is_refused)
{
    for (int axis = 0; axis < 3; axis++) {
        LookAt view = look_at_of_the_deck();
        view.eye[axis] = not_finite[axis];
        look_refuses(view, FINITE);
        view = look_at_of_the_deck();
        view.at[axis] = not_finite[(axis + 1) % 3];
        look_refuses(view, FINITE);
        view = look_at_of_the_deck();
        view.up[axis] = not_finite[(axis + 2) % 3];
        look_refuses(view, FINITE);
    }
}
END_TEST

// NaN and minus infinity are not positive either, and an infinite aspect leaves no height.
START_TEST(a_width_or_aspect_that_is_not_finite_is_refused)
{
    for (int i = 0; i < 3; i++) {
        LookAt view = look_at_of_the_deck();
        view.width = not_finite[i];
        look_refuses(view, FINITE | WIDTH | HEIGHT);
        view = look_at_of_the_deck();
        view.aspect = not_finite[i];
        look_refuses(view, FINITE | HEIGHT);
    }
}
END_TEST

// ---- width from angle -------------------------------------------------------------------------

static void expect_width(double degrees, double distance, double width)
{
    given_number("degrees", degrees);
    given_number("distance", distance);
    expect_number(width_from_angle(degrees, distance), width, tolerance);
}

// Half of the picture is a right-angled triangle with two equal legs.
START_TEST(under_90_degrees_the_plane_is_twice_as_wide_as_far)
{
    expect_width(90, 1, 2);
    expect_width(90, 3.5, 7);
}
END_TEST

// By hand: eye and edges are an equilateral triangle, its height the distance.
START_TEST(under_60_degrees_the_plane_is_as_wide_as_the_edges_are_far)
{
    expect_width(60, 1, 2 / sqrt(3));
    expect_width(60, sqrt(3), 2);
}
END_TEST

// By hand: the tangent of 22.5 degrees is sqrt(2) - 1, of 15 it is 2 - sqrt(3), of 60 sqrt(3).
START_TEST(under_45_30_and_120_degrees)
{
    expect_width(45, 1, 2 * sqrt(2) - 2);
    expect_width(30, 1, 4 - 2 * sqrt(3));
    expect_width(120, 1, 2 * sqrt(3));
}
END_TEST

START_TEST(twice_as_far_away_is_twice_as_wide)
{
    double degrees[] = {20, 50, 100};
    for (int i = 0; i < 3; i++) {
        given_number("degrees", degrees[i]);
        given("distance", "6 and 3");
        given("seen", "the width at 6, by the width at 3");
        expect_number(width_from_angle(degrees[i], 6) / width_from_angle(degrees[i], 3), 2,
                      tolerance);
    }
}
END_TEST

// There an arc and its tangent are the same to 20 digits.
START_TEST(under_a_very_small_angle_the_width_is_that_of_the_arc)
{
    given_number("degrees", 1e-6);
    given_number("distance", 180e6);
    expect_number(width_from_angle(1e-6, 180e6), PI, tolerance);
}
END_TEST

START_TEST(from_the_eye_the_edges_are_that_angle_apart)
{
    for (int i = 0; i < 15; i++) {
        double degrees = floor(random_number(1, 175)), distance = floor(random_number(1, 20));
        given_number("degrees", degrees);
        given_number("distance", distance);
        given("seen", "the angle between the edges, in degrees");
        double half = atan2(width_from_angle(degrees, distance) / 2, distance);
        expect_number(2 * half * 180 / PI, degrees, tolerance);
    }
}
END_TEST

void list_tests(void)
{
    tests_of("camera_from_vectors");
    test(the_four_vectors_of_the_deck_give_its_camera);
    test(four_vectors_give_an_oblique_camera_of_either_hand);
    test(four_vectors_of_any_camera_give_it_back);
    test(four_vectors_keep_the_rays_to_twelve_digits);
    test(four_vectors_that_end_in_no_rectangle_are_refused);
    test(four_vectors_to_a_rectangle_not_straight_ahead_are_refused);
    test(four_vectors_that_leave_no_distance_width_or_height_are_refused);
    test(four_vectors_that_are_not_finite_are_refused);
    tests_of("camera_from_points");
    test(the_four_points_of_the_deck_give_its_camera);
    test(four_points_give_an_oblique_camera_of_either_hand);
    test(four_points_of_any_camera_give_it_back);
    test(four_points_keep_the_rays_to_twelve_digits);
    test(four_points_that_are_no_rectangle_are_refused);
    test(four_points_of_a_rectangle_not_straight_ahead_are_refused);
    test(four_points_that_leave_no_distance_width_or_height_are_refused);
    test(four_points_that_are_not_finite_are_refused);
    tests_of("camera_from_corner");
    test(the_corner_and_two_vectors_of_the_deck_give_its_camera);
    test(a_corner_and_two_vectors_give_an_oblique_camera_of_either_hand);
    test(the_corner_and_two_vectors_of_any_camera_give_it_back);
    test(a_corner_and_two_vectors_keep_the_rays_to_twelve_digits);
    test(two_vectors_that_are_not_at_right_angles_are_refused);
    test(a_corner_and_two_vectors_of_a_rectangle_not_straight_ahead_are_refused);
    test(a_corner_and_two_vectors_that_leave_no_distance_width_or_height_are_refused);
    test(a_corner_and_two_vectors_that_are_not_finite_are_refused);
    tests_of("camera_from_look_at");
    test(the_look_at_of_the_deck_gives_its_camera_in_a_left_handed_world);
    test(the_look_at_of_the_deck_is_mirrored_in_a_right_handed_world);
    test(along_minus_z_in_a_right_handed_world_x_is_to_the_right);
    test(an_oblique_look_at_in_a_world_of_either_hand);
    test(up_may_lean_and_have_any_length);
    test(up_may_lean_until_it_is_almost_along_the_view);
    test(the_height_is_the_width_by_the_aspect);
    test(the_plane_passes_through_the_point_looked_at);
    test(the_look_at_of_any_camera_gives_it_back);
    test(a_look_at_keeps_the_rays_to_twelve_digits);
    test(looking_at_the_eye_itself_is_refused);
    test(an_up_of_zero_is_refused);
    test(an_up_along_the_view_is_refused);
    test(an_up_against_the_view_is_refused);
    test(a_width_that_is_not_positive_is_refused);
    test(an_aspect_that_is_not_positive_is_refused);
    test(a_look_at_whose_vectors_are_not_finite_is_refused);
    test(a_width_or_aspect_that_is_not_finite_is_refused);
    tests_of("width_from_angle");
    test(under_90_degrees_the_plane_is_twice_as_wide_as_far);
    test(under_60_degrees_the_plane_is_as_wide_as_the_edges_are_far);
    test(under_45_30_and_120_degrees);
    test(twice_as_far_away_is_twice_as_wide);
    test(under_a_very_small_angle_the_width_is_that_of_the_arc);
    test(from_the_eye_the_edges_are_that_angle_apart);
}
