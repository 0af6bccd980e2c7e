// 08-fast.c - tests of exercise 08. Expected values: rectangles worked out by hand from right
// triangles with whole sides, and rectangles from angles.
#include "exercises/08-fast.h"

#include "tests/judge/test.h"

static const double tolerance = 1e-6; // of a pixel

// Sees 45 degrees to each side: its plane is 1 ahead and 2 wide and high. It is not at the origin.
static Camera camera_of_45_degrees(void)
{
    return (Camera){.origin = vec3_of(1, -2, 3),
                    .right = vec3_of(1, 0, 0),
                    .up = vec3_of(0, 1, 0),
                    .forward = vec3_of(0, 0, 1),
                    .distance = 1,
                    .width = 2,
                    .height = 2};
}

// Three different sizes, and no axis of the world: every number of it counts.
static Camera oblique_camera(void)
{
    return (Camera){.origin = vec3_of(3, -5, 7),
                    .right = vec3_of(2, -2, 1) / 3,
                    .up = vec3_of(2, 1, -2) / 3,
                    .forward = vec3_of(1, 2, 2) / 3,
                    .distance = 6,
                    .width = 24,
                    .height = 9};
}

// A sphere whose center is at this distance to the right, up and ahead.
static Sphere sphere_at(Camera c, double right, double up, double ahead, double radius)
{
    return (Sphere){c.origin + right * c.right + up * c.up + ahead * c.forward, radius, 0};
}

static void given_view(Camera camera, Resolution screen, Sphere sphere)
{
    vec3 c = sphere.center - camera.origin;
    given_camera(camera);
    given("screen", "%d x %d", screen.width, screen.height);
    given_sphere(sphere);
    given("seen from the eye", "%s right, %s up, %s ahead",
          number_text(vec3_dot(c, camera.right)).s, number_text(vec3_dot(c, camera.up)).s,
          number_text(vec3_dot(c, camera.forward)).s);
}

static void expect_rectangle(Camera camera, Resolution screen, Sphere sphere,
                             ScreenRectangle expected)
{
    given_view(camera, screen, sphere);
    given("looking at", "left and right");
    ScreenRectangle yours = sphere_rectangle(camera, screen, sphere);
    expect_pair(yours.left, yours.right, expected.left, expected.right, tolerance);
    given_view(camera, screen, sphere);
    given("looking at", "top and bottom");
    expect_pair(yours.top, yours.bottom, expected.top, expected.bottom, tolerance);
}

// By hand: sides 9, 40, 41. The tangent has m = 9/40 = 0.225 of 0.25 on each side of the middle.
TEST(sphere_rectangle, a_sphere_straight_ahead_of_the_camera_of_the_deck)
{
    Camera c = camera_of_the_deck();
    expect_rectangle(c, (Resolution){640, 480}, sphere_at(c, 0, 0, 41, 9),
                     (ScreenRectangle){32, 608, 24, 456});
}

// By hand: 5 ahead, radius 3, 3 to the side: g = 16, m = (15 -+ 15) / 16, that is 0 and 15/8. In
// the middle: m = -+3/4.
TEST(sphere_rectangle, a_sphere_whose_edge_is_straight_ahead)
{
    Camera c = camera_of_45_degrees();
    c.width = 8;
    c.height = 4;
    Resolution screen = {800, 200};
    expect_rectangle(c, screen, sphere_at(c, 3, 0, 5, 3),
                     (ScreenRectangle){400, 587.5, 62.5, 137.5});
    expect_rectangle(c, screen, sphere_at(c, -3, 0, 5, 3),
                     (ScreenRectangle){212.5, 400, 62.5, 137.5});
}

// By hand: m = 0 and 15/8 to the right, of 2 on the plane; also m = (-20 -+ 3 * sqrt(32)) / 16
// upwards.
TEST(sphere_rectangle, a_sphere_on_the_right_and_below_for_an_oblique_camera)
{
    Camera c = oblique_camera();
    Resolution screen = {320, 90};
    double high = (-20 + 3 * sqrt(32)) / 16; // up; the lower end is below the screen
    expect_rectangle(c, screen, sphere_at(c, 3, -4, 5, 3),
                     (ScreenRectangle){160, 310, 45 - 60 * high, 90});
}

TEST(sphere_rectangle, a_sphere_between_the_eye_and_the_image_plane_is_seen)
{
    Camera c = camera_of_the_deck();
    expect_rectangle(c, (Resolution){640, 480}, sphere_at(c, 0, 0, 0.41, 0.09),
                     (ScreenRectangle){32, 608, 24, 456});
}

TEST(sphere_rectangle, a_sphere_behind_the_eye_has_no_rectangle)
{
    for (int i = 0; i < 10; i++) {
        Camera c = random_camera();
        Resolution screen = random_screen(2, 900);
        double radius = random_number(0.2, 3),
               behind = radius * random_number(1.001, i % 2 == 0 ? 1.2 : 5);
        double aside = random_number(-2, 2), up = random_number(-2, 2);
        expect_rectangle(c, screen, sphere_at(c, aside, up, -behind, radius),
                         (ScreenRectangle){0, 0, 0, 0});
    }
}

TEST(sphere_rectangle, a_sphere_around_the_eye_covers_the_whole_screen)
{
    for (int i = 0; i < 10; i++) {
        Camera c = random_camera();
        Resolution screen = random_screen(2, 900);
        double radius = random_number(0.5, 3);
        Sphere sphere = {c.origin + radius * random_number(0, 0.9) * random_unit(), radius, 0};
        expect_rectangle(c, screen, sphere, (ScreenRectangle){0, screen.width, 0, screen.height});
    }
}

// The sphere reaches behind the eye, but the eye is outside: the argument is how far ahead the
// center is.
TEST(sphere_rectangle, a_sphere_beside_the_eye_covers_the_whole_screen)
{
    for (int i = 0; i < 10; i++) {
        Camera c = random_camera();
        Resolution screen = random_screen(2, 900);
        double radius = random_number(0.5, 3), angle = random_number(0, 2 * PI);
        double aside = radius * random_number(1.2, 4), ahead = radius * random_number(-0.9, 0.9);
        expect_rectangle(c, screen,
                         sphere_at(c, aside * cos(angle), aside * sin(angle), ahead, radius),
                         (ScreenRectangle){0, screen.width, 0, screen.height});
    }
}

// By hand: m from 0 to 15/8, and from -3/4 to 3/4; the plane has -1 to 1.
TEST(sphere_rectangle, the_part_beyond_the_edges_is_cut_off)
{
    Camera c = camera_of_45_degrees();
    Resolution screen = {200, 100};
    expect_rectangle(c, screen, sphere_at(c, 3, 0, 5, 3), (ScreenRectangle){100, 200, 12.5, 87.5});
    expect_rectangle(c, screen, sphere_at(c, -3, 0, 5, 3), (ScreenRectangle){0, 100, 12.5, 87.5});
    expect_rectangle(c, screen, sphere_at(c, 0, 3, 5, 3), (ScreenRectangle){25, 175, 0, 50});
    expect_rectangle(c, screen, sphere_at(c, 0, -3, 5, 3), (ScreenRectangle){25, 175, 50, 100});
}

// By hand: 20 to the side, 5 ahead, radius 3: m is above 2 on that side, and the plane ends at 1.
TEST(sphere_rectangle, a_sphere_beside_the_screen_has_no_rectangle)
{
    Camera c = camera_of_45_degrees();
    Resolution screen = {320, 200};
    for (int way = -1; way <= 1; way += 2) {
        expect_rectangle(c, screen, sphere_at(c, way * 20, 0, 5, 3), (ScreenRectangle){0, 0, 0, 0});
        expect_rectangle(c, screen, sphere_at(c, 0, way * 20, 5, 3), (ScreenRectangle){0, 0, 0, 0});
    }
}

// ---- any camera, any sphere --------------------------------------------------------------------

// Somewhere in front of the camera, most of them in its view, large and small.
static Sphere random_sphere_in_view(Camera c)
{
    double radius = random_number(0.1, 2), ahead = radius * random_number(1.2, 12);
    double right = ahead * c.width / c.distance * random_number(-0.6, 0.6);
    double up = ahead * c.height / c.distance * random_number(-0.6, 0.6);
    return sphere_at(c, right, up, ahead, radius);
}

static double limited(double x, double most)
{
    return x < 0 ? 0 : x > most ? most : x;
}

// Seen along one axis, the angle to the center and the angle between the center and the tangents.
// In numbers of half the screen.
static void angles(double ahead, double aside, double radius, double half, double edges[2])
{
    double middle = atan2(aside, ahead), around = asin(radius / hypot(aside, ahead));
    edges[0] = tan(middle - around) / half;
    edges[1] = tan(middle + around) / half;
}

static ScreenRectangle rectangle_by_angles(Camera c, Resolution screen, Sphere sphere)
{
    vec3 to = sphere.center - c.origin;
    double x[2], y[2], ahead = vec3_dot(to, c.forward), w = screen.width, h = screen.height;
    angles(ahead, vec3_dot(to, c.right), sphere.radius, c.width / 2 / c.distance, x);
    angles(ahead, vec3_dot(to, c.up), sphere.radius, c.height / 2 / c.distance, y);
    if (x[0] >= 1 || x[1] <= -1 || y[0] >= 1 || y[1] <= -1)
        return (ScreenRectangle){0, 0, 0, 0};
    return (ScreenRectangle){limited((1 + x[0]) / 2 * w, w), limited((1 + x[1]) / 2 * w, w),
                             limited((1 - y[1]) / 2 * h, h), limited((1 - y[0]) / 2 * h, h)};
}

TEST(sphere_rectangle, the_edges_are_where_the_angles_of_the_tangents_say)
{
    for (int i = 0; i < 60; i++) {
        Camera c = random_camera();
        Resolution screen = random_screen(2, 900);
        Sphere sphere = random_sphere_in_view(c);
        expect_rectangle(c, screen, sphere, rectangle_by_angles(c, screen, sphere));
    }
}

// Its edge is up to three pixels inside the screen, or up to one outside: on each of the four
// sides.
TEST(sphere_rectangle, a_sphere_whose_edge_is_within_a_pixel_or_two_of_the_screens)
{
    for (int i = 0; i < 40; i++) {
        Camera c = camera_of_45_degrees();
        Resolution screen = random_screen(100, 900);
        int across = i % 4 < 2 ? screen.width : screen.height;
        double edge = 2 * random_number(i < 20 ? -0.95 : 0.05, i < 20 ? 0.95 : 3) / across - 1;
        double around = random_number(0.05, 0.4), away = random_number(2, 9);
        double middle = atan(edge) - around, side = i % 2 == 0 ? 1 : -1;
        double aside = side * away * sin(middle), ahead = away * cos(middle);
        Sphere sphere =
            sphere_at(c, i % 4 < 2 ? aside : 0, i % 4 < 2 ? 0 : aside, ahead, away * sin(around));
        if (ahead > 1.05 * sphere.radius)
            expect_rectangle(c, screen, sphere, rectangle_by_angles(c, screen, sphere));
    }
}

TEST(sphere_rectangle, worlds_of_any_size_have_the_same_rectangles)
{
    enum { COUNT = 26 };
    for (int i = 0; i < COUNT; i++) {
        Camera c = random_camera();
        Resolution screen = random_screen(2, 900);
        Sphere sphere = random_sphere_in_view(c);
        ScreenRectangle expected = rectangle_by_angles(c, screen, sphere);
        double world = random_scale(i, COUNT);
        c.origin *= world;
        c.distance *= world;
        c.width *= world;
        c.height *= world;
        sphere.center *= world;
        sphere.radius *= world;
        expect_rectangle(c, screen, sphere, expected);
    }
}

// ---- probes -------------------------------------------------------------------------------------

// Calls that distinguish the mistakes of exercise 08: any camera, any sphere.

PROBE(sphere_rectangle, any_sphere_anywhere)
{
    for (int i = 0; i < 60; i++) {
        Camera camera = random_camera();
        Resolution screen = random_screen(2, 900);
        Sphere sphere = {camera.origin + random_vec3(-8, 8), random_number(0.1, 5), 0};
        sphere_rectangle(camera, screen, sphere);
    }
}

// All of it on the screen, large and small.
PROBE(sphere_rectangle, spheres_near_the_middle)
{
    for (int i = 0; i < 40; i++) {
        Camera camera = random_camera();
        Resolution screen = random_screen(20, 900);
        double radius = random_number(0.1, 3), ahead = radius * random_number(3, 20);
        vec3 aside = random_number(-0.2, 0.2) * camera.width / camera.distance * camera.right +
                     random_number(-0.2, 0.2) * camera.height / camera.distance * camera.up;
        Sphere sphere = {camera.origin + ahead * (camera.forward + aside), radius, 0};
        sphere_rectangle(camera, screen, sphere);
    }
}

// Within three pixels of the left, the right, the upper or the lower edge of the screen.
PROBE(sphere_rectangle, spheres_that_only_just_reach_the_screen)
{
    for (int i = 0; i < 80; i++) {
        Camera camera = random_camera();
        Resolution screen = random_screen(20, 900);
        bool across = i % 4 < 2;
        double half = (across ? camera.width : camera.height) / 2 / camera.distance;
        double pixels = across ? screen.width : screen.height;
        double around = random_number(0.05, 0.2), away = random_number(2, 9);
        double middle = atan(half * (random_number(0, 3) / pixels - 1)) - around;
        double aside = (i % 2 == 0 ? 1 : -1) * away * sin(middle), ahead = away * cos(middle);
        vec3 to = ahead * camera.forward + aside * (across ? camera.right : camera.up);
        if (ahead > 0.3 * away)
            sphere_rectangle(camera, screen, (Sphere){camera.origin + to, away * sin(around), 0});
    }
}
