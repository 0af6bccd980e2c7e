// 06-ray-casting.c - tests of exercise 06. Expected values: the deck's three spheres worked out by
// hand, and pictures decided by angles: seen from the eye, a sphere is a cone.
#include "tests/06-ray-casting/support.h"

#include "exercises/04-pixel-ray.h"

// ---- nearest_hit -------------------------------------------------------------------------------

// A t of 1e9 has as many digits as one of 1: the tolerance is a part of t.
static void expect_nearest(Ray ray, const Scene *scene, double t, int sphere)
{
    given_scene(scene);
    given_ray(ray);
    given("looking at", "t");
    expect_number(nearest_hit(ray, scene).t, t, t == NO_HIT ? 0 : TOLERANCE * t);
    given_scene(scene);
    given_ray(ray);
    given("looking at", "the index of the sphere");
    expect_int(nearest_hit(ray, scene).sphere, sphere);
}

static Ray along_minus_z(double x, double y, double z)
{
    return (Ray){vec3_of(x, y, z), vec3_of(0, 0, -1)};
}

START_TEST(the_nearest_of_three_is_hit_in_any_order_of_the_scene)
{
    int orders[6][3] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
    for (int i = 0; i < 6; i++) {
        Sphere spheres[3];
        for (int place = 0; place < 3; place++)
            spheres[place] = sphere_at(0, 0, -4 - 3 * orders[i][place], 1, RED + place);
        Scene scene = scene_of(3, spheres);
        int first = orders[i][0] == 0 ? 0 : orders[i][1] == 0 ? 1 : 2;
        expect_nearest(along_minus_z(0, 0, 0), &scene, 3, first);
    }
}
END_TEST

START_TEST(of_equal_hits_the_lower_index_counts)
{
    Sphere spheres[] = {sphere_at(0, 0, -9, 1, RED), sphere_at(0, 0, -5, 1, GREEN),
                        sphere_at(0, 0, -5, 1, BLUE), sphere_at(0, 0, -5, 1, WHITE)};
    Scene scene = scene_of(4, spheres);
    expect_nearest(along_minus_z(0, 0, 0), &scene, 4, 1);
}
END_TEST

START_TEST(what_is_behind_the_eye_is_not_hit)
{
    Sphere spheres[] = {sphere_at(0, 0, 3, 1, RED), sphere_at(0, 0, -5, 1, GREEN)};
    Scene both = scene_of(2, spheres), behind = scene_of(1, spheres);
    expect_nearest(along_minus_z(0, 0, 0), &both, 4, 1);
    expect_nearest(along_minus_z(0, 0, 0), &behind, NO_HIT, -1);
}
END_TEST

START_TEST(if_nothing_is_hit_t_is_no_hit_and_the_sphere_is_none)
{
    Sphere spheres[] = {sphere_at(5, 0, -5, 1, RED), sphere_at(-5, 0, -5, 1, GREEN)};
    Scene scene = scene_of(2, spheres);
    expect_nearest(along_minus_z(0, 0, 0), &scene, NO_HIT, -1);
}
END_TEST

START_TEST(in_an_empty_scene_nothing_is_hit)
{
    Scene scene = scene_of(0, NULL);
    expect_nearest(along_minus_z(0, 0, 0), &scene, NO_HIT, -1);
}
END_TEST

START_TEST(the_first_and_the_last_sphere_can_be_hit)
{
    Sphere spheres[] = {sphere_at(-3, 0, -5, 1, RED), sphere_at(0, 0, -5, 1, RED),
                        sphere_at(3, 0, -5, 1, RED)};
    Scene scene = scene_of(3, spheres);
    expect_nearest(along_minus_z(-3, 0, 0), &scene, 4, 0);
    expect_nearest(along_minus_z(3, 0, 0), &scene, 4, 2);
}
END_TEST

// The centre of the large one is farther away, its surface is nearer: 10 - 8 against 5 - 1.
START_TEST(the_nearest_surface_counts_and_not_the_nearest_centre)
{
    Sphere spheres[] = {sphere_at(0, 0, -5, 1, RED), sphere_at(0, 0, -10, 8, GREEN)};
    Scene scene = scene_of(2, spheres);
    expect_nearest(along_minus_z(0, 0, 0), &scene, 2, 1);
}
END_TEST

START_TEST(t_counts_in_lengths_of_the_direction)
{
    Sphere spheres[] = {sphere_at(0, 0, -9, 1, RED), sphere_at(0, 0, -5, 1, GREEN)};
    Scene scene = scene_of(2, spheres);
    Ray ray = {vec3_of(0, 0, 0), vec3_of(0, 0, -8)};
    expect_nearest(ray, &scene, 0.5, 1);
    ray.direction = vec3_of(0, 0, -0.5);
    expect_nearest(ray, &scene, 8, 1);
    ray.direction = vec3_of(0, 0, -80);
    expect_nearest(ray, &scene, 0.05, 1);
    ray.direction = vec3_of(0, 0, -8000);
    expect_nearest(ray, &scene, 0.0005, 1);
}
END_TEST

// The ray leaves green, which is around the eye, at t = 7; red is inside it.
START_TEST(from_inside_a_sphere_its_far_side_is_hit_unless_another_sphere_is_nearer)
{
    Sphere spheres[] = {sphere_at(0, 0, 0, 7, GREEN), sphere_at(0, 3, -4, 1, RED)};
    Scene scene = scene_of(2, spheres);
    Ray ray = {vec3_of(0, 0, 0), vec3_of(0, -0.6, -0.8)};
    expect_nearest(ray, &scene, 7, 0);
    ray.direction = vec3_of(0, 0.6, -0.8);
    expect_nearest(ray, &scene, 4, 1);
}
END_TEST

// By hand, with rays along -z from z = 20: over (x, y) a sphere around (cx, cy, cz) reaches up to
// cz + sqrt(9 - (x - cx)^2 - (y - cy)^2).
START_TEST(if_spheres_of_the_deck_overlap_red_comes_first_then_green_then_blue)
{
    static const struct {
        double x, y, z;
        int sphere;
    } places[] = {
        {2, 0, 3.2360679774997897, 0}, // red 1 + sqrt 5, green sqrt 5
        {0, 1, 3, 0},                  // red 1 + 2, blue -1 + 2
        {0, -1, 2, 1},                 // green 2, blue -1 + 2
        {0, 0, 2, 0},                  // red 1 + 1, green 1, blue -1 + sqrt 5
    };
    Scene scene = scene_of_the_deck();
    for (int i = 0; i < 4; i++)
        expect_nearest(along_minus_z(places[i].x, places[i].y, 20), &scene, 20 - places[i].z,
                       places[i].sphere);
}
END_TEST

START_TEST(of_spheres_one_behind_the_other_the_nearest_is_hit)
{
    int hits = 0;
    for (int i = 0; i < 40 || hits < 10; i++) {
        Sphere spheres[SHELLS];
        Camera camera = random_camera();
        random_shells(camera, spheres);
        Scene scene = scene_of(SHELLS, spheres);
        Resolution size = {16, 9};
        Ray ray = pixel_ray(camera, size, random_pixel(size));
        int seen = shell_seen(ray.origin, ray.direction, SHELLS, spheres);
        if (seen == -2)
            continue;
        expect_nearest(ray, &scene, t_seen(ray, spheres, seen), seen);
        hits += seen >= 0;
    }
}
END_TEST

// ---- both orders: what the picture shows -------------------------------------------------------

static void paints_over_the_old_contents_of_the_image(Cast *cast)
{
    Scene scene = scene_of(0, NULL);
    // Neither 1 nor almost 0 is changed by a mistake in the colours.
    scene.background = vec3_of(1, 0.4, 0.002);
    Resolution sizes[] = {{5, 3}, {1, 1}, {1, 2}, {6, 2}};
    const char *pictures[] = {"...............", ".", "..", "............"};
    for (int i = 0; i < 4; i++)
        expect_picture(cast, &scene, camera_with_pixels_of_1(sizes[i]), sizes[i], pictures[i]);
}
IN_BOTH_ORDERS(paints_over_the_old_contents_of_the_image)

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

// One sphere in the direction of each coloured pixel, and none is near another. Green is farther
// away than those before it in the list.
static void shows_left_and_right_and_up_and_down_where_they_are(Cast *cast)
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
IN_BOTH_ORDERS(shows_left_and_right_and_up_and_down_where_they_are)

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

// All straight ahead: on the plane the radius squared of the farther one's disc is 225 / 175, of
// the nearer one's 1 / 15.
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

static void gives_equal_hits_the_colour_of_the_lower_index(Cast *cast)
{
    Sphere spheres[] = {sphere_at(0, 0, -10, 8, BLUE), sphere_at(0, 0, -10, 8, RED)};
    Scene scene = scene_of(2, spheres);
    Resolution size = {3, 3};
    expect_picture(cast, &scene, camera_with_pixels_of_1(size), size,
                   ".b."
                   "bbb"
                   ".b.");
}
IN_BOTH_ORDERS(gives_equal_hits_the_colour_of_the_lower_index)

// From the centre of a sphere every pixel is blue, unless another sphere is inside it.
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

// The plane is 8 away; red is in front of it, blue beyond it, green behind the eye.
static void shows_spheres_in_front_of_the_image_plane_and_none_behind_the_eye(Cast *cast)
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
IN_BOTH_ORDERS(shows_spheres_in_front_of_the_image_plane_and_none_behind_the_eye)

// The deck's camera: eye (2, 2, -4), plane x 1 to 3, y 1 to 3 at z = 0. Four pixels each way: the
// centre of the upper left one is (1.25, 2.75, 0), and red is there; green is in the lower row.
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
// centres are -4, -2 .. 4. By hand, as above: on each of them red is in front of green, and green
// in front of blue.
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

static void draws_spheres_one_behind_the_other_as_cones_say(Cast *cast)
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
IN_BOTH_ORDERS(draws_spheres_one_behind_the_other_as_cones_say)

// ---- object order: its depth, and that image order agrees --------------------------------------

START_TEST(the_old_values_in_depth_do_not_matter)
{
    // The white one is seen by the pixel that would come after the last one.
    Sphere spheres[] = {sphere_at(10, 0, -10, 2, GREEN), sphere_at(0, 0, -10, 2, RED),
                        sphere_at(0, 0, -20, 2, BLUE), sphere_at(-10, -10, -10, 2, WHITE)};
    Scene scene = scene_of(4, spheres);
    Resolution size = {3, 1};
    Image expected = image_of(size), image = odd_image(size);
    image_set(&expected, (Pixel){0, 0}, scene.background);
    image_set(&expected, (Pixel){1, 0}, surfaces[RED].color);
    image_set(&expected, (Pixel){2, 0}, surfaces[GREEN].color);
    const double junk[] = {NAN, 0, -1, 1e-300, -INFINITY, 9};
    for (int i = 0; i < 6; i++) {
        double depth[] = {junk[i], junk[i], junk[i], 1e9};
        given_scene(&scene);
        given_size(size);
        given("depth", "%g everywhere before", junk[i]);
        cast_object_order(&scene, camera_with_pixels_of_1(size), &image, depth);
        expect_same_image(&image, &expected);
        given("looking at", "the number after the last depth");
        expect_number(depth[3], 1e9, 0);
    }
    image_free(&expected);
    image_free(&image);
}
END_TEST

// 10 - 2, where the pixel's direction is 1 long; the plane is 1 away.
START_TEST(the_depth_straight_ahead_is_the_t_of_the_nearest_hit)
{
    Sphere spheres[] = {sphere_at(0, 0, -30, 2, BLUE), sphere_at(0, 0, -10, 2, RED),
                        sphere_at(0, 0, -20, 2, GREEN)};
    double expected[15];
    for (int i = 0; i < 15; i++)
        expected[i] = i == 7 ? 8 : NO_HIT;
    Scene scene = scene_of(3, spheres);
    Resolution size = {5, 3};
    expect_depths(&scene, camera_with_pixels_of_1(size), size, expected);
}
END_TEST

// On the plane, 4 away, the centres of the pixels are -3, 0, 3 each way: directions beside the
// middle are 5 long. Red is 10 - 1 away, green 20 - 5, blue 15 - 2.5.
START_TEST(the_depth_goes_row_by_row_and_counts_in_lengths_of_the_direction)
{
    Sphere spheres[] = {sphere_at(-6, 0, -8, 1, RED), sphere_at(0, 12, -16, 5, GREEN),
                        sphere_at(9, 0, -12, 2.5, BLUE)};
    const double expected[] = {NO_HIT, 3, NO_HIT, 1.8, NO_HIT, 2.5, NO_HIT, NO_HIT, NO_HIT};
    Scene scene = scene_of(3, spheres);
    Resolution size = {3, 3};
    Camera camera = camera_with_pixels_of_1(size);
    camera.distance = 4;
    camera.width = camera.height = 9;
    expect_depths(&scene, camera, size, expected);
}
END_TEST

START_TEST(the_depth_of_spheres_one_behind_the_other_is_that_of_the_nearest)
{
    for (int i = 0; i < 6; i++) {
        Sphere spheres[SHELLS];
        Resolution size = {5, 3};
        Camera camera = shells_behind(size, random_pixel(size), spheres);
        expect_depths_of_shells(camera, size, spheres);
    }
}
END_TEST

START_TEST(in_an_empty_scene_every_depth_is_no_hit)
{
    Scene scene = scene_of(0, NULL);
    Resolution size = {2, 2};
    const double expected[] = {NO_HIT, NO_HIT, NO_HIT, NO_HIT};
    expect_depths(&scene, camera_with_pixels_of_1(size), size, expected);
}
END_TEST

// Spheres that overlap and intersect each other, some twice, in two colours: ties.
START_TEST(both_orders_give_the_same_bytes)
{
    Resolution size = {24, 17};
    for (int i = 0; i < 6; i++) {
        enum { COUNT = SURFACES };
        Camera camera = random_camera();
        Sphere spheres[COUNT];
        for (int k = 0; k < COUNT; k++) {
            vec3 place = camera.origin + random_number(-2, 12) * camera.forward;
            spheres[k] = (Sphere){.center = place + random_vec3(-3, 3),
                                  .radius = random_number(0.1, 1),
                                  .surface = RED + k % 4};
            if (k % 5 == 4) {
                spheres[k].center = spheres[k - 1].center;
                spheres[k].radius = spheres[k - 1].radius;
            }
        }
        Scene scene = scene_of(COUNT, spheres);
        Image by_pixel = odd_image(size), by_sphere = odd_image(size);
        given_scene(&scene);
        given_camera(camera);
        given_size(size);
        given("compared", "with the picture in image order");
        image_order(&scene, camera, &by_pixel);
        object_order(&scene, camera, &by_sphere);
        expect_same_image(&by_sphere, &by_pixel);
        image_free(&by_pixel);
        image_free(&by_sphere);
    }
}
END_TEST

// ---- worlds of any size ------------------------------------------------------------------------

// No sphere is too near, too far or too close to another, and no number of spheres is too large.

// The world multiplied by one factor, the image plane's distance and width by another: t counts in
// lengths of the vector to the plane, so it grows with the first and shrinks with the second.
typedef struct {
    double world, plane;
} Scale;

enum { SCALES = 9 };

static Scale scale_number(int i)
{
    // First those in which t and the distance of a hit have different sizes.
    static const Scale scales[SCALES] = {{1, 1e8}, {1, 1e-8},   {1e-8, 1e-8}, {1e8, 1e8}, {1e-8, 1},
                                         {1e8, 1}, {1e-8, 1e8}, {1e8, 1e-8},  {1e-3, 1e3}};
    double world = scales[i].world * random_number(0.5, 2);
    return (Scale){world, scales[i].plane * random_number(0.5, 2)};
}

static void scale_world(Scale scale, Camera *camera, int count, Sphere *spheres)
{
    camera->origin *= scale.world;
    camera->distance *= scale.plane;
    camera->width *= scale.plane;
    camera->height *= scale.plane;
    for (int i = 0; i < count; i++) {
        spheres[i].center *= scale.world;
        spheres[i].radius *= scale.world;
    }
}

// ---- nearest_hit --------------------------------------------------------------------------------

START_TEST(in_a_world_of_any_size_along_a_direction_of_any_length_the_nearest_is_hit)
{
    for (int i = 0; i < 2 * SCALES; i++) {
        Sphere spheres[SHELLS];
        Resolution size = {5, 4};
        Pixel pixel = random_pixel(size);
        Camera camera = shells_behind(size, pixel, spheres);
        scale_world(scale_number(i % SCALES), &camera, SHELLS, spheres);
        Scene scene = scene_of(SHELLS, spheres);
        Ray ray = pixel_ray(camera, size, pixel);
        int seen = shell_seen(ray.origin, ray.direction, SHELLS, spheres);
        if (seen != -2)
            expect_nearest(ray, &scene, t_seen(ray, spheres, seen), seen);
    }
}
END_TEST

// Two of the same radius straight ahead, one of them so much nearer that no right answer can take
// the other: ten times the allowed error of a hit. The nearer one is the first, the last or
// between.
START_TEST(of_spheres_close_together_the_nearer_is_hit)
{
    for (int i = 0; i < 54; i++) {
        double size = pow(10, 6 - i % 3 * 6), gap = pow(10, -3 - i / 3 % 3);
        double away = i / 9 % 2 == 0 ? 9 : 900;
        int nearer = i / 18;
        vec3 from = size * random_vec3(-5, 5), axis = random_unit();
        Sphere spheres[3];
        for (int k = 0; k < 3; k++) {
            double there = away + (k == nearer ? 0 : (1 + k) * gap);
            spheres[k] = (Sphere){from + size * there * axis, size, RED + k};
        }
        Scene scene = scene_of(3, spheres);
        Ray ray = {from, random_number(0.1, 9) * axis};
        expect_nearest(ray, &scene, size * (away - 1) / vec3_length(ray.direction), nearer);
    }
}
END_TEST

// Ladders: an answer with a limit fails at the first rung after it, and that rung names the limit.

// One sphere straight ahead and another farther away.
static Scene two_at(double t)
{
    static Sphere spheres[2];
    spheres[0] = sphere_at(0, 0, -2.1 * t, 0.1 * t, RED);
    spheres[1] = sphere_at(0, 0, -1.1 * t, 0.1 * t, GREEN);
    return scene_of(2, spheres);
}

// One that is a thousandth of a radius nearer than the other, 10 radii away; t is where.
static Scene two_apart(double gap, double *t)
{
    static Sphere spheres[2];
    double radius = 1000 * gap;
    *t = 9 * radius;
    spheres[0] = sphere_at(0, 0, -10 * radius - gap, radius, RED);
    spheres[1] = sphere_at(0, 0, -10 * radius, radius, GREEN);
    return scene_of(2, spheres);
}

// 0.3, 0.03 ... 3e-12 and 30, 300 ... 3e12.
enum { RUNGS = 12 };

static double down(int i)
{
    return 3 * pow(10, -1 - i);
}

static double up(int i)
{
    return 3 * pow(10, 1 + i);
}

static const Ray straight_ahead = {{0, 0, 0}, {0, 0, -1}};

START_TEST(no_t_is_too_small)
{
    for (int i = 0; i < RUNGS; i++) {
        Scene scene = two_at(down(i));
        expect_nearest(straight_ahead, &scene, down(i), 1);
    }
}
END_TEST

START_TEST(no_t_is_too_large)
{
    for (int i = 0; i < RUNGS; i++) {
        Scene scene = two_at(up(i));
        expect_nearest(straight_ahead, &scene, up(i), 1);
        scene = two_at(up(i) / 2); // 1.5e9, which an int can still hold
        expect_nearest(straight_ahead, &scene, up(i) / 2, 1);
    }
}
END_TEST

START_TEST(the_nearer_sphere_is_hit_however_small_the_difference)
{
    for (int i = 0; i < RUNGS; i++) {
        double t;
        Scene scene = two_apart(down(i), &t);
        expect_nearest(straight_ahead, &scene, t, 1);
    }
}
END_TEST

START_TEST(in_any_direction_the_nearest_is_hit)
{
    for (int i = 0; i < 6; i++) {
        vec3 axis = vec3_of(0, 0, 0), from = vec3_of(3, -2, 4);
        axis[i / 2] = i % 2 == 0 ? 1 : -1;
        Sphere spheres[] = {{from + 9 * axis, 1, RED},
                            {from + 4 * axis, 1.5, GREEN},
                            {from + 20 * axis, 2, BLUE},
                            {from - 3 * axis, 1, WHITE}};
        Scene scene = scene_of(4, spheres);
        expect_nearest((Ray){from, axis}, &scene, 2.5, 1);
    }
}
END_TEST

// Beside the ray, except for the last.
static void many_spheres(int count, Sphere *spheres)
{
    for (int i = 0; i < count; i++)
        spheres[i] = i == count - 1 ? sphere_at(0, 0, -5, 1, GREEN)
                                    : sphere_at(3 + i, 2, -9, 1, RED + i % 3);
}

// A scene may have any number of spheres. An answer with room for a fixed number is recognised by
// that number: it hits the last sphere that fits, and misses the next one.
static const int rooms[] = {10, 16, 20, 32, 50, 64, 100, 128, 256};
enum { ROOMS = sizeof rooms / sizeof *rooms, MOST_SPHERES = 1001 };
static Sphere many[MOST_SPHERES];

START_TEST(the_last_of_many_spheres_is_hit)
{
    for (int i = 0; i <= 2 * ROOMS; i++) {
        int count = i < 2 * ROOMS ? rooms[i / 2] + i % 2 : MOST_SPHERES;
        many_spheres(count, many);
        Scene scene = scene_of(count, many);
        expect_nearest(straight_ahead, &scene, 4, count - 1);
    }
}
END_TEST

// ---- both orders --------------------------------------------------------------------------------

static void draws_worlds_of_any_size(Cast *cast)
{
    Resolution size = {4, 3};
    for (int i = 0; i < SCALES; i++) {
        Sphere spheres[SHELLS];
        Camera camera = shells_behind(size, random_pixel(size), spheres);
        scale_world(scale_number(i), &camera, SHELLS, spheres);
        expect_picture_of_shells(cast, camera, size, spheres);
    }
}
IN_BOTH_ORDERS(draws_worlds_of_any_size)

static const Resolution shapes[] = {{1, 9}, {9, 1},  {1, 1},  {3, 8}, {2, 5},
                                    {5, 2}, {40, 1}, {1, 40}, {17, 2}};
enum { SHAPES = sizeof shapes / sizeof *shapes };

static void draws_pictures_of_any_shape(Cast *cast)
{
    for (int i = 0; i < SHAPES; i++) {
        Sphere spheres[SHELLS];
        Camera camera = shells_behind(shapes[i], random_pixel(shapes[i]), spheres);
        expect_picture_of_shells(cast, camera, shapes[i], spheres);
    }
}
IN_BOTH_ORDERS(draws_pictures_of_any_shape)

static void draws_the_last_of_many_spheres(Cast *cast)
{
    Resolution size = {2, 1};
    for (int i = 0; i <= 2 * ROOMS; i++) {
        int count = i < 2 * ROOMS ? rooms[i / 2] + i % 2 : 300;
        many_spheres(count, many);
        Scene scene = scene_of(count, many);
        Camera camera = camera_with_pixels_of_1(size);
        camera.width = 0.2;
        camera.height = 0.1;
        expect_picture(cast, &scene, camera, size, "gg");
    }
}
IN_BOTH_ORDERS(draws_the_last_of_many_spheres)

// As above for nearest_hit; in most pictures the farther one is the first.
static void draws_the_nearer_of_two_close_together(Cast *cast)
{
    Resolution size = {1, 1};
    for (int i = 0; i < 54; i++) {
        double scale = pow(10, 6 - i % 3 * 6), gap = pow(10, -3 - i / 3 % 3);
        double away = i / 9 % 2 == 0 ? 9 : 900;
        Sphere spheres[2] = {sphere_at(0, 0, -away * scale, scale, RED),
                             sphere_at(0, 0, -(away + gap) * scale, scale, GREEN)};
        Sphere other[2] = {spheres[1], spheres[0]};
        Scene scene = scene_of(2, i < 18 ? spheres : other);
        Camera camera = camera_with_pixels_of_1(size);
        camera.distance = random_number(0.1, 9);
        expect_picture(cast, &scene, camera, size, "r");
    }
}
IN_BOTH_ORDERS(draws_the_nearer_of_two_close_together)

// A picture of one pixel, straight ahead.
static void expect_green(Cast *cast, Scene scene)
{
    Resolution size = {1, 1};
    expect_picture(cast, &scene, camera_with_pixels_of_1(size), size, "g");
}

static void draws_spheres_however_small_t_is(Cast *cast)
{
    for (int i = 0; i < RUNGS; i++)
        expect_green(cast, two_at(down(i)));
}
IN_BOTH_ORDERS(draws_spheres_however_small_t_is)

static void draws_spheres_however_large_t_is(Cast *cast)
{
    for (int i = 0; i < RUNGS; i++)
        expect_green(cast, two_at(up(i)));
}
IN_BOTH_ORDERS(draws_spheres_however_large_t_is)

static void draws_the_nearer_sphere_however_small_the_difference(Cast *cast)
{
    double t;
    for (int i = 0; i < RUNGS; i++)
        expect_green(cast, two_apart(down(i), &t));
}
IN_BOTH_ORDERS(draws_the_nearer_sphere_however_small_the_difference)

// ---- depth --------------------------------------------------------------------------------------

START_TEST(the_depth_in_worlds_of_any_size_is_that_of_the_nearest)
{
    Resolution size = {3, 2};
    for (int i = 0; i < SCALES; i++) {
        Sphere spheres[SHELLS];
        Camera camera = shells_behind(size, random_pixel(size), spheres);
        scale_world(scale_number(i), &camera, SHELLS, spheres);
        expect_depths_of_shells(camera, size, spheres);
    }
}
END_TEST

START_TEST(the_depth_in_pictures_of_any_shape_goes_row_by_row)
{
    for (int i = 0; i < SHAPES; i++) {
        Sphere spheres[SHELLS];
        Camera camera = shells_behind(shapes[i], random_pixel(shapes[i]), spheres);
        expect_depths_of_shells(camera, shapes[i], spheres);
    }
}
END_TEST

static void list_tests(void)
{
    tests_of("nearest_hit");
    test(the_nearest_of_three_is_hit_in_any_order_of_the_scene);
    test(of_equal_hits_the_lower_index_counts);
    test(what_is_behind_the_eye_is_not_hit);
    test(if_nothing_is_hit_t_is_no_hit_and_the_sphere_is_none);
    test(in_an_empty_scene_nothing_is_hit);
    test(the_first_and_the_last_sphere_can_be_hit);
    test(the_nearest_surface_counts_and_not_the_nearest_centre);
    test(t_counts_in_lengths_of_the_direction);
    test(from_inside_a_sphere_its_far_side_is_hit_unless_another_sphere_is_nearer);
    test(if_spheres_of_the_deck_overlap_red_comes_first_then_green_then_blue);
    test(of_spheres_one_behind_the_other_the_nearest_is_hit);
    test(in_a_world_of_any_size_along_a_direction_of_any_length_the_nearest_is_hit);
    test(of_spheres_close_together_the_nearer_is_hit);
    test(no_t_is_too_small);
    test(no_t_is_too_large);
    test(the_nearer_sphere_is_hit_however_small_the_difference);
    test(in_any_direction_the_nearest_is_hit);
    test(the_last_of_many_spheres_is_hit);
    tests_of("cast_image_order");
    test(image_order_paints_over_the_old_contents_of_the_image);
    test(image_order_draws_a_sphere_straight_ahead_as_a_disc);
    test(image_order_shows_left_and_right_and_up_and_down_where_they_are);
    test(image_order_fills_the_first_and_the_last_row_and_column);
    test(image_order_shows_the_nearer_sphere_in_any_order_of_the_scene);
    test(image_order_gives_equal_hits_the_colour_of_the_lower_index);
    test(image_order_looks_out_from_inside_a_sphere);
    test(image_order_shows_spheres_in_front_of_the_image_plane_and_none_behind_the_eye);
    test(image_order_draws_with_the_left_handed_camera_of_the_deck);
    test(image_order_draws_the_three_spheres_of_the_deck);
    test(image_order_draws_spheres_one_behind_the_other_as_cones_say);
    test(image_order_draws_worlds_of_any_size);
    test(image_order_draws_pictures_of_any_shape);
    test(image_order_draws_the_last_of_many_spheres);
    test(image_order_draws_the_nearer_of_two_close_together);
    test(image_order_draws_spheres_however_small_t_is);
    test(image_order_draws_spheres_however_large_t_is);
    test(image_order_draws_the_nearer_sphere_however_small_the_difference);
    tests_of("cast_object_order");
    test(object_order_paints_over_the_old_contents_of_the_image);
    test(object_order_draws_a_sphere_straight_ahead_as_a_disc);
    test(object_order_shows_left_and_right_and_up_and_down_where_they_are);
    test(object_order_fills_the_first_and_the_last_row_and_column);
    test(object_order_shows_the_nearer_sphere_in_any_order_of_the_scene);
    test(object_order_gives_equal_hits_the_colour_of_the_lower_index);
    test(object_order_looks_out_from_inside_a_sphere);
    test(object_order_shows_spheres_in_front_of_the_image_plane_and_none_behind_the_eye);
    test(object_order_draws_with_the_left_handed_camera_of_the_deck);
    test(object_order_draws_the_three_spheres_of_the_deck);
    test(object_order_draws_spheres_one_behind_the_other_as_cones_say);
    tests_of("cast_object_order");
    test(the_old_values_in_depth_do_not_matter);
    test(the_depth_straight_ahead_is_the_t_of_the_nearest_hit);
    test(the_depth_goes_row_by_row_and_counts_in_lengths_of_the_direction);
    test(the_depth_of_spheres_one_behind_the_other_is_that_of_the_nearest);
    test(in_an_empty_scene_every_depth_is_no_hit);
    test(both_orders_give_the_same_bytes);
    test(object_order_draws_worlds_of_any_size);
    test(object_order_draws_pictures_of_any_shape);
    test(object_order_draws_the_last_of_many_spheres);
    test(object_order_draws_the_nearer_of_two_close_together);
    test(object_order_draws_spheres_however_small_t_is);
    test(object_order_draws_spheres_however_large_t_is);
    test(object_order_draws_the_nearer_sphere_however_small_the_difference);
    test(the_depth_in_worlds_of_any_size_is_that_of_the_nearest);
    test(the_depth_in_pictures_of_any_shape_goes_row_by_row);
}

OF_STEM(list_tests)
