// 06-ray-casting-scale.c - tests of all three in worlds of any size: nothing is too near, too far,
// too close together or one too many.
#include "tests/06-ray-casting.h"

#include "exercises/04-pixel-ray.h"

// The world that many times as large, the image plane that many times as far and as wide: t counts
// in lengths of the way to the plane, so it grows with the first and shrinks with the second.
typedef struct {
    double world, plane;
} Scale;

enum { SCALES = 9 };

static Scale scale_number(int i)
{
    // First those in which t and the way to a hit are of different sizes.
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
// the other: ten times what a hit may be off. The nearer one is the first, the last or between.
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

// Ladders: whoever has a limit fails at the rung behind it, and is known by that.

// One sphere straight ahead and another behind it.
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
    }
}
END_TEST

START_TEST(no_sphere_is_nearer_by_too_little)
{
    for (int i = 0; i < RUNGS; i++) {
        double t;
        Scene scene = two_apart(down(i), &t);
        expect_nearest(straight_ahead, &scene, t, 1);
    }
}
END_TEST

START_TEST(whichever_way_the_ray_goes_the_nearest_is_hit)
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

// Beside the ray, but for the last.
static void many_spheres(int count, Sphere *spheres)
{
    for (int i = 0; i < count; i++)
        spheres[i] = i == count - 1 ? sphere_at(0, 0, -5, 1, GREEN)
                                    : sphere_at(3 + i, 2, -9, 1, RED + i % 3);
}

// No number of spheres is the most that a scene may have. Who has room for so many only is known by
// that number: the last that it has room for is hit, the next one is not.
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

static void draws_however_small_t_is(Cast *cast)
{
    for (int i = 0; i < RUNGS; i++)
        expect_green(cast, two_at(down(i)));
}
IN_BOTH_ORDERS(draws_however_small_t_is)

static void draws_however_large_t_is(Cast *cast)
{
    for (int i = 0; i < RUNGS; i++)
        expect_green(cast, two_at(up(i)));
}
IN_BOTH_ORDERS(draws_however_large_t_is)

static void draws_what_is_nearer_by_however_little(Cast *cast)
{
    double t;
    for (int i = 0; i < RUNGS; i++)
        expect_green(cast, two_apart(down(i), &t));
}
IN_BOTH_ORDERS(draws_what_is_nearer_by_however_little)

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

void list_more_of_nearest_hit(void)
{
    test(in_a_world_of_any_size_along_a_direction_of_any_length_the_nearest_is_hit);
    test(of_spheres_close_together_the_nearer_is_hit);
    test(no_t_is_too_small);
    test(no_t_is_too_large);
    test(no_sphere_is_nearer_by_too_little);
    test(whichever_way_the_ray_goes_the_nearest_is_hit);
    test(the_last_of_many_spheres_is_hit);
}

void list_more_of_cast_image_order(void)
{
    test(image_order_draws_worlds_of_any_size);
    test(image_order_draws_pictures_of_any_shape);
    test(image_order_draws_the_last_of_many_spheres);
    test(image_order_draws_the_nearer_of_two_close_together);
    test(image_order_draws_however_small_t_is);
    test(image_order_draws_however_large_t_is);
    test(image_order_draws_what_is_nearer_by_however_little);
}

void list_more_of_cast_object_order(void)
{
    test(object_order_draws_worlds_of_any_size);
    test(object_order_draws_pictures_of_any_shape);
    test(object_order_draws_the_last_of_many_spheres);
    test(object_order_draws_the_nearer_of_two_close_together);
    test(object_order_draws_however_small_t_is);
    test(object_order_draws_however_large_t_is);
    test(object_order_draws_what_is_nearer_by_however_little);
    test(the_depth_in_worlds_of_any_size_is_that_of_the_nearest);
    test(the_depth_in_pictures_of_any_shape_goes_row_by_row);
}
