// 01-corners.c - tests of exercise 01. Expected values: the lecture's example, component by
// component, and what a projection onto the camera's own axes must give back.
#include "exercises/01-corners.h"

#include "chapters/shared/example.h"
#include "tests/judge/test.h"

static const double tolerance = 1e-9;

// How far a vector from the eye goes along forward, right and up.
static vec3 along_axes(Camera c, vec3 v)
{
    return vec3_of(vec3_dot(v, c.forward), vec3_dot(v, c.right), vec3_dot(v, c.up));
}

// The i-th of count cameras, in worlds of any size, wide and narrow, near and far.
static Camera camera_of_any_size(int i, int count)
{
    Camera c = random_camera();
    double world = random_scale(i, count);
    c.origin *= world;
    c.distance *= world * pow(10, random_number(-2, 2));
    c.width *= world * pow(10, random_number(-2, 2));
    c.height *= world * pow(10, random_number(-2, 2));
    return c;
}

static double size_of(Camera c)
{
    return c.distance + c.width + c.height;
}

// The vector that goes so far along each of the camera's axes. For the deck's camera these are x, y
// and z: its upper left corner is (-1, 1, 4), its upper right corner (1, 1, 4), and the point 30%
// across and 10% up is (-0.4, -0.8, 4).
static vec3 along(Camera c, double right, double up, double forward)
{
    vec3 v = vec3_of(0, 0, 0);
    for (int i = 0; i < 3; i++)
        v[i] = right * c.right[i] + up * c.up[i] + forward * c.forward[i];
    return v;
}

// The answer for the example, that far across and up from the middle, in shares of the plane.
static void expect_of_example(vec3 (*answer)(Camera), double across, double upward)
{
    Camera c = example_camera();
    given_camera(c);
    expect_vec3(answer(c), along(c, across * c.width, upward * c.height, c.distance),
                tolerance * fmax(1, size_of(c)));
}

static void expect_of_oblique(vec3 (*answer)(Camera), vec3 expected)
{
    Camera c = tilted_camera();
    given_camera(c);
    expect_vec3(answer(c), expected, tolerance);
}

static void expect_seen(vec3 (*answer)(Camera), Camera c, double across, double upward,
                        double within)
{
    given_camera(c);
    given("seen along", "forward, right, up");
    expect_vec3(along_axes(c, answer(c)), vec3_of(c.distance, across * c.width, upward * c.height),
                within);
}

static void expect_of_any_camera(vec3 (*answer)(Camera), double across, double upward)
{
    for (int i = 0; i < 10; i++)
        expect_seen(answer, random_camera(), across, upward, tolerance);
}

enum { SIZES = 13 };

// The law of scale: in a world that is k times as large, the vector is k times as long.
static void expect_in_any_world(vec3 (*answer)(Camera), double across, double upward)
{
    for (int i = 0; i < SIZES; i++) {
        Camera c = camera_of_any_size(i, SIZES);
        expect_seen(answer, c, across, upward, tolerance * size_of(c));
    }
}

TEST_LINE(upper_left, the_upper_left_corner_of_the_example,
          expect_of_example(upper_left, -0.5, 0.5))
TEST_LINE(upper_right, the_upper_right_corner_of_the_example,
          expect_of_example(upper_right, 0.5, 0.5))
// From the middle, the point is 20% of the width to the left, and 40% of the height down.
TEST_LINE(across_30_up_10, the_point_30_percent_across_and_10_percent_up_of_the_example,
          expect_of_example(across_30_up_10, -0.2, -0.4))

// By hand: 6 f = (2, 4, 4), 9/2 r = (3, -3, 1.5), 3/2 u = (1, 0.5, -1).
TEST_LINE(upper_left, the_upper_left_corner_of_an_oblique_camera,
          expect_of_oblique(upper_left, vec3_of(0, 7.5, 1.5)))
TEST_LINE(upper_right, the_upper_right_corner_of_an_oblique_camera,
          expect_of_oblique(upper_right, vec3_of(6, 1.5, 4.5)))
// By hand: (2, 4, 4) - 0.2 * (6, -6, 3) - 0.4 * (2, 1, -2).
TEST_LINE(across_30_up_10, the_point_30_percent_across_and_10_percent_up_of_an_oblique_camera,
          expect_of_oblique(across_30_up_10, vec3_of(0, 4.8, 4.2)))

TEST_LINE(upper_left, the_corners_do_not_depend_on_where_the_eye_is,
          expect_of_any_camera(upper_left, -0.5, 0.5))
TEST_LINE(upper_right, the_upper_right_corner_does_not_depend_on_where_the_eye_is,
          expect_of_any_camera(upper_right, 0.5, 0.5))
TEST_LINE(across_30_up_10, the_point_30_percent_across_and_10_percent_up_of_any_camera,
          expect_of_any_camera(across_30_up_10, -0.2, -0.4))

TEST_LINE(upper_left, the_upper_left_corner_in_worlds_of_any_size,
          expect_in_any_world(upper_left, -0.5, 0.5))
TEST_LINE(upper_right, the_upper_right_corner_in_worlds_of_any_size,
          expect_in_any_world(upper_right, 0.5, 0.5))
TEST_LINE(across_30_up_10, the_point_30_percent_across_and_10_percent_up_in_worlds_of_any_size,
          expect_in_any_world(across_30_up_10, -0.2, -0.4))

static void expect_vector(Camera c, double s, double t, vec3 expected)
{
    given_camera(c);
    given_number("s", s);
    given_number("t", t);
    expect_vec3(image_plane_vector(c, s, t), expected, tolerance);
}

TEST_LINE(image_plane_vector, the_middle_of_the_plane_is_straight_ahead,
          expect_vector(tilted_camera(), 0.5, 0.5, vec3_of(2, 4, 4)))

TEST(image_plane_vector, s_and_t_are_counted_from_the_lower_left_corner)
{
    expect_vector(tilted_camera(), 0, 0, vec3_of(-2, 6.5, 3.5));
    expect_vector(tilted_camera(), 0.25, 0.75, vec3_of(1, 5.75, 2.75));
}

// Every place is d ahead, and its share of w and h aside.
static void expect_place(Camera c, double s, double t, double within)
{
    given_camera(c);
    given_number("s", s);
    given_number("t", t);
    given("seen along", "forward, right, up");
    expect_vec3(along_axes(c, image_plane_vector(c, s, t)),
                vec3_of(c.distance, s * c.width - c.width / 2, t * c.height - c.height / 2),
                within);
}

// No place is a special case, and neither is a place just beside the middle or an edge.
TEST(image_plane_vector, a_place_just_beside_the_middle_or_an_edge_is_right)
{
    const double shares[] = {0.499, 0.501, 0.001, 0.999, 1.001, -0.001};
    for (int i = 0; i < 6; i++)
        expect_place(tilted_camera(), shares[i], shares[5 - i], tolerance);
}

// Beyond the plane the same formula holds, however far.
TEST(image_plane_vector, every_place_in_worlds_of_any_size)
{
    for (int i = 0; i < 2 * SIZES; i++) {
        Camera c = camera_of_any_size(i, 2 * SIZES);
        double far = i % 2 == 0 ? 1 : 100, s = far * random_number(-1, 2);
        expect_place(c, s, far * random_number(-1, 2), tolerance * far * size_of(c));
    }
}

TEST(with_unit_distance, unit_distance_halves_the_plane_of_a_camera_with_distance_2)
{
    Camera c = camera_of_the_deck(), same = c;
    c.distance = 2;
    c.width = 6;
    c.height = 4;
    same.distance = 1;
    same.width = 3;
    same.height = 2;
    given_camera(c);
    expect_camera(with_unit_distance(c), same, tolerance);
}

// The width and the height to within these.
static void expect_same_rays(Camera c, double of_width, double of_height)
{
    given_camera(c);
    Camera same = with_unit_distance(c);
    expect_number(same.distance, 1, 0);
    given_camera(c);
    expect_number(same.width * c.distance, c.width, of_width);
    given_camera(c);
    expect_number(same.height * c.distance, c.height, of_height);
    given_camera(c);
    expect_vec3(same.origin, c.origin, 0);
    const vec3 yours[] = {same.right, same.up, same.forward}, frame[] = {c.right, c.up, c.forward};
    for (int i = 0; i < 3; i++) {
        given_camera(c);
        given("seen", "%s", (const char *[]){"right", "up", "forward"}[i]);
        expect_vec3(yours[i], frame[i], tolerance);
    }
}

TEST(with_unit_distance, unit_distance_gives_the_same_rays)
{
    for (int i = 0; i < 20; i++)
        expect_same_rays(random_camera(), tolerance, tolerance);
}

TEST(with_unit_distance, unit_distance_gives_the_same_rays_in_worlds_of_any_size)
{
    for (int i = 0; i < SIZES; i++) {
        Camera c = camera_of_any_size(i, SIZES);
        expect_same_rays(c, tolerance * c.width, tolerance * c.height);
    }
}

// ---- probes -------------------------------------------------------------------------------------

// Calls that distinguish the mistakes of exercise 01: any cameras, and places on and beyond the
// plane.

enum { MANY = 12 };

static void ask_of_any_camera(vec3 (*answer)(Camera))
{
    for (int i = 0; i < MANY; i++)
        answer(random_camera());
}

PROBE_LINE(upper_left, upper_left_of_any_camera, ask_of_any_camera(upper_left))
PROBE_LINE(upper_right, upper_right_of_any_camera, ask_of_any_camera(upper_right))
PROBE_LINE(across_30_up_10, across_30_up_10_of_any_camera, ask_of_any_camera(across_30_up_10))

PROBE(image_plane_vector, any_place_of_any_camera)
{
    for (int i = 0; i < 2 * MANY; i++) {
        Camera camera = random_camera();
        double s = random_number(-1, 2);
        image_plane_vector(camera, s, random_number(-1, 2));
    }
}

PROBE(with_unit_distance, unit_distance_of_any_camera)
{
    for (int i = 0; i < 2 * MANY; i++) {
        Camera camera = random_camera();
        if (i % 2 == 0)
            camera.distance = random_number(0.1, 0.9);
        with_unit_distance(camera);
    }
}
