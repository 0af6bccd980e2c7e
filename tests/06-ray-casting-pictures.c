// 06-ray-casting-pictures.c - tests of both orders: what the picture shows.
#include "tests/06-ray-casting.h"

#include "exercises/04-pixel-ray.h"

static void leaves_nothing_of_what_was_in_the_image(Cast *cast)
{
    Scene scene = scene_of(0, NULL);
    // Neither 1 nor next to nothing survives what is done to colours by mistake.
    scene.background = vec3_of(1, 0.4, 0.002);
    Resolution sizes[] = {{5, 3}, {1, 1}, {1, 2}, {6, 2}};
    const char *pictures[] = {"...............", ".", "..", "............"};
    for (int i = 0; i < 4; i++)
        expect_picture(cast, &scene, camera_with_pixels_of_1(sizes[i]), sizes[i], pictures[i]);
}
IN_BOTH_ORDERS(leaves_nothing_of_what_was_in_the_image)

// From the eye the sphere, 10 away, is a cone; on the plane, 1 away, a disc whose radius squared is
// r^2 / (100 - r^2). So 3 for r^2 = 75: pixels with x^2 + y^2 < 3.
static void draws_a_sphere_straight_ahead_as_a_disc(Cast *cast)
{
    Sphere spheres[] = {sphere_at(0, 0, -10, 8.660254037844386, RED)};
    Scene scene = scene_of(1, spheres);
    Resolution size = {7, 5};
    expect_picture(cast, &scene, camera_with_pixels_of_1(size), size,
                   "......."
                   "..rrr.."
                   "..rrr.."
                   "..rrr.."
                   ".......");
}
IN_BOTH_ORDERS(draws_a_sphere_straight_ahead_as_a_disc)

// One sphere straight behind each coloured pixel, and none is near another. Green is farther away
// than what comes before it.
static void has_left_and_right_and_up_and_down_where_they_are(Cast *cast)
{
    Sphere spheres[] = {sphere_at(-20, 10, -10, 2, RED), sphere_at(0, 10, -10, 2, RED),
                        sphere_at(-10, -10, -10, 2, BLUE), sphere_at(20, 0, -10, 2, GREEN)};
    Scene scene = scene_of(4, spheres);
    Resolution size = {5, 3};
    expect_picture(cast, &scene, camera_with_pixels_of_1(size), size,
                   "r.r.."
                   "....g"
                   ".b...");
}
IN_BOTH_ORDERS(has_left_and_right_and_up_and_down_where_they_are)

// A picture that is higher than wide.
static void fills_the_first_and_the_last_row_and_column(Cast *cast)
{
    Sphere spheres[] = {sphere_at(-10, 20, -10, 2, RED), sphere_at(10, 20, -10, 2, GREEN),
                        sphere_at(-10, -20, -10, 2, BLUE), sphere_at(10, -20, -10, 2, WHITE)};
    Scene scene = scene_of(4, spheres);
    Resolution size = {3, 5};
    expect_picture(cast, &scene, camera_with_pixels_of_1(size), size,
                   "r.g"
                   "..."
                   "..."
                   "..."
                   "b.w");
}
IN_BOTH_ORDERS(fills_the_first_and_the_last_row_and_column)

// All straight ahead: on the plane the radius squared of the farther's disc is 225 / 175, of the
// nearer's 1 / 15.
static void shows_the_nearer_sphere_in_any_order_of_the_scene(Cast *cast)
{
    Sphere near = sphere_at(0, 0, -4, 1, RED), far = sphere_at(0, 0, -20, 15, GREEN);
    Sphere near_first[] = {near, far}, far_first[] = {far, near};
    Scene scenes[] = {scene_of(2, near_first), scene_of(2, far_first)};
    Resolution size = {5, 3};
    for (int i = 0; i < 2; i++)
        expect_picture(cast, &scenes[i], camera_with_pixels_of_1(size), size,
                       "..g.."
                       ".grg."
                       "..g..");
}
IN_BOTH_ORDERS(shows_the_nearer_sphere_in_any_order_of_the_scene)

static void colours_equals_as_the_lower_index(Cast *cast)
{
    Sphere spheres[] = {sphere_at(0, 0, -10, 8, BLUE), sphere_at(0, 0, -10, 8, RED)};
    Scene scene = scene_of(2, spheres);
    Resolution size = {3, 3};
    expect_picture(cast, &scene, camera_with_pixels_of_1(size), size,
                   ".b."
                   "bbb"
                   ".b.");
}
IN_BOTH_ORDERS(colours_equals_as_the_lower_index)

// From the middle of a sphere every pixel is blue, unless something stands inside it.
static void looks_out_from_inside_a_sphere(Cast *cast)
{
    Sphere spheres[] = {sphere_at(0, 0, 0, 50, BLUE), sphere_at(10, 0, -10, 2, RED)};
    Scene scene = scene_of(2, spheres);
    Resolution size = {4, 1};
    Camera camera = camera_with_pixels_of_1(size);
    camera.width = 8; // pixels 2 wide: centres at -3, -1, 1, 3
    expect_picture(cast, &scene, camera, size, "bbrb");
}
IN_BOTH_ORDERS(looks_out_from_inside_a_sphere)

// The plane is 8 away; red stands before it, blue behind it, green behind the eye.
static void shows_what_is_before_the_image_plane_and_nothing_behind_the_eye(Cast *cast)
{
    Sphere spheres[] = {sphere_at(-2, 0, -4, 0.5, RED), sphere_at(0, 0, 5, 2, GREEN),
                        sphere_at(8, 0, -16, 2, BLUE)};
    Scene scene = scene_of(3, spheres);
    Resolution size = {3, 1};
    Camera camera = camera_with_pixels_of_1(size);
    camera.distance = 8;
    camera.width = 12;
    expect_picture(cast, &scene, camera, size, "r.b");
}
IN_BOTH_ORDERS(shows_what_is_before_the_image_plane_and_nothing_behind_the_eye)

// The deck's camera: eye (2, 2, -4), plane x 1 to 3, y 1 to 3 at z = 0. Four pixels each way: the
// centre of the upper left one is (1.25, 2.75, 0), where red stands; green is in the lower row.
static void draws_with_the_left_handed_camera_of_the_deck(Cast *cast)
{
    Sphere spheres[] = {sphere_at(1.25, 2.75, 0, 0.1, RED), sphere_at(2.25, 1.25, 0, 0.1, GREEN)};
    Scene scene = scene_of(2, spheres);
    expect_picture(cast, &scene, camera_of_the_deck(), (Resolution){4, 4},
                   "r..."
                   "...."
                   "...."
                   "..g.");
}
IN_BOTH_ORDERS(draws_with_the_left_handed_camera_of_the_deck)

// Seen from z = 400 the rays are nearly along -z. Five pixels each way, 2 wide at z = 0: their
// centres are -4, -2 .. 4. By hand, as above: on each of them red is before green, green before
// blue.
static void draws_the_three_spheres_of_the_deck(Cast *cast)
{
    Scene scene = scene_of_the_deck();
    Resolution size = {5, 5};
    Camera camera = camera_with_pixels_of_1(size);
    camera.origin = vec3_of(0, 0, 400);
    camera.distance = 400;
    camera.width = camera.height = 10;
    expect_picture(cast, &scene, camera, size,
                   "..rrr"
                   "bbrrr"
                   "bbrrr"
                   "bbggg"
                   "..ggg");
}
IN_BOTH_ORDERS(draws_the_three_spheres_of_the_deck)

static void draws_what_cones_say_of_spheres_one_behind_the_other(Cast *cast)
{
    Resolution size = {16, 9};
    int checked = 0;
    for (int i = 0; i < 12 || checked < 6; i++) {
        Sphere spheres[SHELLS];
        Camera camera = random_camera();
        random_shells(camera, spheres);
        Scene scene = scene_of(SHELLS, spheres);
        Surface painted[SURFACES] = {{.color = scene.background}};
        for (int color = RED; color < COLORS; color++)
            painted[color].color = random_vec3(0.1, 0.9);
        scene.background = random_vec3(0.1, 0.9);
        scene.surfaces = painted;
        char picture[16 * 9 + 1] = "";
        bool doubtful = false;
        for (int k = 0; k < 16 * 9; k++) {
            vec3 direction = pixel_ray(camera, size, (Pixel){k % 16, k / 16}).direction;
            int seen = shell_seen(camera.origin, direction, SHELLS, spheres);
            doubtful = doubtful || seen == -2;
            picture[k] = seen < 0 ? '.' : letter_of(spheres[seen].surface);
        }
        if (doubtful)
            continue;
        expect_picture(cast, &scene, camera, size, picture);
        checked++;
    }
}
IN_BOTH_ORDERS(draws_what_cones_say_of_spheres_one_behind_the_other)

void list_tests_of_pictures(void)
{
    tests_of("cast_image_order");
    test(image_order_leaves_nothing_of_what_was_in_the_image);
    test(image_order_draws_a_sphere_straight_ahead_as_a_disc);
    test(image_order_has_left_and_right_and_up_and_down_where_they_are);
    test(image_order_fills_the_first_and_the_last_row_and_column);
    test(image_order_shows_the_nearer_sphere_in_any_order_of_the_scene);
    test(image_order_colours_equals_as_the_lower_index);
    test(image_order_looks_out_from_inside_a_sphere);
    test(image_order_shows_what_is_before_the_image_plane_and_nothing_behind_the_eye);
    test(image_order_draws_with_the_left_handed_camera_of_the_deck);
    test(image_order_draws_the_three_spheres_of_the_deck);
    test(image_order_draws_what_cones_say_of_spheres_one_behind_the_other);
    list_more_of_cast_image_order();
    tests_of("cast_object_order");
    test(object_order_leaves_nothing_of_what_was_in_the_image);
    test(object_order_draws_a_sphere_straight_ahead_as_a_disc);
    test(object_order_has_left_and_right_and_up_and_down_where_they_are);
    test(object_order_fills_the_first_and_the_last_row_and_column);
    test(object_order_shows_the_nearer_sphere_in_any_order_of_the_scene);
    test(object_order_colours_equals_as_the_lower_index);
    test(object_order_looks_out_from_inside_a_sphere);
    test(object_order_shows_what_is_before_the_image_plane_and_nothing_behind_the_eye);
    test(object_order_draws_with_the_left_handed_camera_of_the_deck);
    test(object_order_draws_the_three_spheres_of_the_deck);
    test(object_order_draws_what_cones_say_of_spheres_one_behind_the_other);
}
