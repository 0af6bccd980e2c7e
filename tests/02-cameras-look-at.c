// 02-cameras-look-at.c - tests of the look-at: the cameras that it must find.
#include "tests/02-cameras.h"

CameraFault look(LookAt view, Handedness world, Camera *camera)
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

LookAt deck_with(vec3 up, double width, double aspect)
{
    return (LookAt){vec3_of(2, 2, -4), vec3_of(2, 2, 0), up, width, aspect};
}

LookAt look_at_of_the_deck(void)
{
    return deck_with(vec3_of(0, 1, 0), 2, 1);
}

LookAt deck_with_size(double width, double aspect)
{
    return deck_with(vec3_of(0, 1, 0), width, aspect);
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

// By hand: u + f = (1, 1, 0), whose part across the view is 1 long; (4 u + 3 f) / 5, which is 1
// long itself; 3 u + 3 f = (3, 3, 0), 3 u - 3 f = (1, -1, -4), 30 u = (20, 10, -20). The last is
// very short, but not 0.
START_TEST(up_may_lean_and_have_any_length)
{
    static const vec3 ups[] = {
        {1, 1, 0},     {11.0 / 15, 2.0 / 3, -2.0 / 15}, {3, 3, 0}, {1, -1, -4},
        {20, 10, -20}, {2e-12, 1e-12, -2e-12},
    };
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
    look_finds(deck_with(vec3_of(0, 0.001, 1), 2, 1), LEFT_HANDED, camera_of_the_deck());
    look_finds(deck_with(vec3_of(0, 1e-7, 1), 2, 1), LEFT_HANDED, camera_of_the_deck());
}
END_TEST

// By hand: 4 wide on a screen of 640 x 480 is 3 high.
START_TEST(the_height_is_the_width_by_the_aspect)
{
    Camera c = camera_of_the_deck();
    c.width = 4;
    c.height = 3;
    look_finds(deck_with_size(4, 640.0 / 480), LEFT_HANDED, c);
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
        vec3 eye = whole_numbers(), at = whole_numbers(), up = whole_numbers();
        LookAt view = {eye, at, up, 2, 1};
        if (vec3_length(vec3_cross(at - eye, up)) == 0)
            continue; // there is no camera, by chance
        Camera found;
        CameraFault fault = look(view, i % 2 == 0 ? RIGHT_HANDED : LEFT_HANDED, &found);
        if (fault != CAMERA_OK)
            expect_fault(fault, CAMERA_OK);
        given("seen", "the middle of the plane");
        expect_vec3(found.origin + found.distance * found.forward, view.at, TOLERANCE);
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

// The law of scale: with eye, at and width k times as large the camera is; the length of up is
// free.
START_TEST(a_look_at_in_worlds_of_any_size_gives_the_camera)
{
    enum { COUNT = 13 };
    for (int i = 0; i < COUNT; i++) {
        double size;
        Camera c = camera_of_any_size(i, COUNT, &size), found;
        LookAt view = random_look_at(c);
        view.up *= random_scale((5 * i) % COUNT, COUNT);
        CameraFault fault = look(view, hand_of(c), &found);
        expect_found_of_size(fault, found, c, size);
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

// The cross product is then a hundred millionth long, and rounding shows: right must be made
// perpendicular once more, or there is no camera. Extra: the deck's formula need not.
START_TEST(up_may_be_almost_along_an_oblique_view)
{
    for (int i = 0; i < 15; i++) {
        Camera c = random_camera(), found;
        LookAt view = {c.origin, c.origin + c.distance * c.forward, c.forward + 1e-8 * c.up,
                       c.width, c.width / c.height};
        expect_fault(look(view, hand_of(c), &found), CAMERA_OK);
    }
}
END_TEST

void list_tests_of_look_at(void)
{
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
    test(a_look_at_in_worlds_of_any_size_gives_the_camera);
    test(a_look_at_keeps_the_rays_to_twelve_digits);
    list_refusals_of_look_at();
    tests_of_extra("camera_from_look_at");
    test(up_may_be_almost_along_an_oblique_view);
}
