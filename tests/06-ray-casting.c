// 06-ray-casting.c - tests of exercise 06. Expected values: the deck's three spheres worked out by
// hand, and pictures decided by angles: seen from the eye, a sphere is a cone.
#include "exercises/06-ray-casting.h"
#include "exercises/04-pixel-ray.h"

#include "tests/judge/test.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define TOLERANCE 1e-9

// The colors, and the letters that represent them in pictures. No component is 0 or 1, no two of a
// color are equal, and one of red is so small that 255 times it is not yet white. No sphere has
// surface 0, and a sphere seldom has the surface of its own number; but there is a surface 0,
// black, for answers that confuse the two numbers.
enum { UNUSED, RED, GREEN, BLUE, WHITE, COLORS, SURFACES = 24 };

static Sphere sphere_at(double x, double y, double z, double radius, int color)
{
    return (Sphere){vec3_of(x, y, z), radius, color};
}

// Both orders have the same tests; image order needs no depth.
typedef void Cast(const Scene *scene, Camera camera, Image *image);

// A test for each order: image_order_SENTENCE and object_order_SENTENCE.
#define TEST_BOTH_ORDERS(sentence)                                                                 \
    static void sentence(Cast *cast);                                                              \
    TEST(cast_image_order, image_order_##sentence)                                                 \
    {                                                                                              \
        sentence(image_order);                                                                     \
    }                                                                                              \
    TEST(cast_object_order, object_order_##sentence)                                               \
    {                                                                                              \
        sentence(object_order);                                                                    \
    }                                                                                              \
    static void sentence(Cast *cast)

enum { SHELLS = 8, MOST_PIXELS = 16 * 9 };

// ---- scenes and images --------------------------------------------------------------------------

static const char letters[] = "?rgbw";
static Surface surfaces[SURFACES] = {
    [UNUSED] = {{0.3, 0.95, 0.4}, 0.45, 0.55, 7, 0, 1},
    [RED] = {{0.85, 0.15, 0.002}, 0.6, 0.3, 5, 0, 1},
    [GREEN] = {{0.2, 0.75, 0.45}, 0.7, 0.2, 3, 0, 1},
    [BLUE] = {{0.25, 0.4, 0.95}, 0.8, 0.1, 9, 0, 1},
    [WHITE] = {{0.95, 0.85, 0.65}, 0.5, 0.4, 4, 0, 1},
};

static char letter_of(int color)
{
    return letters[color];
}

// On a greyish blue. The spheres still belong to the caller.
static Scene scene_of(int count, Sphere *spheres)
{
    return (Scene){.background = vec3_of(0.35, 0.45, 0.55),
                   .ambient = vec3_of(0.12, 0.31, 0.23),
                   .spheres = spheres,
                   .sphere_count = count,
                   .surfaces = surfaces,
                   .surface_count = SURFACES};
}

static void given_scene(const Scene *scene)
{
    enum { MOST_SHOWN = 10 };
    if (scene->sphere_count == 0)
        given("spheres", "none");
    for (int i = 0; i < scene->sphere_count && i < MOST_SHOWN; i++) {
        const Sphere *s = &scene->spheres[i];
        char label[16];
        snprintf(label, sizeof label, "sphere %d", i % 100);
        given(label, "center %s, radius %s, color %s", vec3_text(s->center).s,
              number_text(s->radius).s, vec3_text(scene_surface(scene, i)->color).s);
    }
    if (scene->sphere_count > MOST_SHOWN)
        given("and more", "%d in all", scene->sphere_count);
}

// Looks along -z, as in NFF; right-handed. The plane is 1 away, and a pixel 1 wide: on it the
// centers of 5 x 3 pixels are -2 .. 2 by -1 .. 1.
static Camera camera_with_pixels_of_1(Resolution size)
{
    return (Camera){.origin = vec3_of(0, 0, 0),
                    .right = vec3_of(1, 0, 0),
                    .up = vec3_of(0, 1, 0),
                    .forward = vec3_of(0, 0, -1),
                    .distance = 1,
                    .width = size.width,
                    .height = size.height};
}

// The deck's three; as NFF, z is towards the eye.
static Scene scene_of_the_deck(void)
{
    static Sphere spheres[] = {{{2, 2, 1}, 3, RED}, {{2, -2, 0}, 3, GREEN}, {{-2, 0, -1}, 3, BLUE}};
    return scene_of(3, spheres);
}

static Image image_of(Resolution size)
{
    Image image;
    Message message;
    if (!image_create(&image, size, &message))
        ck_abort_msg("%s", message.text);
    return image;
}

static size_t pixel_count(const Image *image)
{
    return (size_t)image->size.width * (size_t)image->size.height;
}

static void given_size(Resolution size)
{
    given("image", "%d x %d pixels", size.width, size.height);
}

// ---- pictures -----------------------------------------------------------------------------------

static void image_order(const Scene *scene, Camera camera, Image *image)
{
    cast_image_order(scene, camera, image);
}

static void object_order(const Scene *scene, Camera camera, Image *image)
{
    double *depth = malloc(pixel_count(image) * sizeof *depth);
    for (size_t i = 0; i < pixel_count(image); i++)
        depth[i] = NO_HIT;
    cast_object_order(scene, camera, image, depth);
    free(depth);
}

// An image in a color that no scene has, so that an omitted pixel is visible.
static Image odd_image(Resolution size)
{
    Image image = image_of(size);
    memset(image.rgb, 0x5a, 3 * pixel_count(&image));
    return image;
}

static Color color_of_letter(const Scene *scene, char letter)
{
    const char *place = strchr(letters, letter);
    return letter == '.' || place == NULL ? scene->background
                                          : scene->surfaces[place - letters].color;
}

// Expected is a picture in letters, row by row from the top; '.' is the background.
static void expect_picture(Cast *cast, const Scene *scene, Camera camera, Resolution size,
                           const char *expected)
{
    Image picture = image_of(size), image = odd_image(size);
    for (int i = 0; expected[i] != '\0'; i++)
        image_set(&picture, (Pixel){i % size.width, i / size.width},
                  color_of_letter(scene, expected[i]));
    given_scene(scene);
    given_camera(camera);
    given_size(size);
    cast(scene, camera, &image);
    expect_same_image(&image, &picture);
    image_free(&picture);
    image_free(&image);
}

static void expect_drawn(Cast *cast, Scene scene, Resolution size, const char *expected)
{
    expect_picture(cast, &scene, camera_with_pixels_of_1(size), size, expected);
}

static bool is_near(double depth, double t)
{
    return depth == t || (t < NO_HIT && fabs(depth - t) <= TOLERANCE * t);
}

// The values that object order must leave in depth, for all pixels, row by row.
// One call, and one of its pixels is reported: the first that is not as expected.
static void expect_depths(const Scene *scene, Camera camera, Resolution size,
                          const double *expected)
{
    double depth[MOST_PIXELS];
    int pixels = size.width * size.height, i = 0;
    for (int k = 0; k < pixels; k++)
        depth[k] = NAN;
    given_scene(scene);
    given_camera(camera);
    given_size(size);
    Image image = odd_image(size);
    cast_object_order(scene, camera, &image, depth);
    image_free(&image);
    while (i < pixels - 1 && is_near(depth[i], expected[i]))
        i++;
    for (int k = 0; k < pixels; k++)
        expects((Expectation){1, &depth[k], &expected[k],
                              expected[k] == NO_HIT ? 0 : TOLERANCE * expected[k], 0, false, 0, 0});
    given("looking at", "the depth of column %d, row %d", i % size.width, i / size.width);
    expect_number(depth[i], expected[i], expected[i] == NO_HIT ? 0 : TOLERANCE * expected[i]);
}

static void expect_depths_of(Scene scene, Resolution size, const double *expected)
{
    expect_depths(&scene, camera_with_pixels_of_1(size), size, expected);
}

// ---- the outline of a sphere seen from the eye, without a quadratic: a cone ---------------------

static double cosine_between(vec3 v, vec3 w)
{
    return vec3_dot(v, w) / (vec3_length(v) * vec3_length(w));
}

// 1 if the direction from the eye meets the sphere, 0 if it does not, -1 if it passes too close to
// the silhouette to be sure. Seen from the eye a sphere of radius r, D away, is a cone whose half
// angle has the sine r / D.
static int sees(vec3 eye, vec3 direction, Sphere sphere)
{
    vec3 center = sphere.center - eye;
    double sine = sphere.radius / vec3_length(center);
    double inside = cosine_between(direction, center) - sqrt(1 - sine * sine);
    return fabs(inside) < TOLERANCE ? -1 : inside > 0;
}

// The distance of the sphere in that direction, by the law of cosines in the triangle of the eye,
// the hit and the center.
static double distance_seen(vec3 eye, vec3 direction, Sphere sphere)
{
    vec3 center = sphere.center - eye;
    double away = vec3_length(center), cosine = cosine_between(direction, center);
    double aside = away * sqrt(fmax(0, 1 - cosine * cosine));
    return away * cosine - sqrt(sphere.radius * sphere.radius - aside * aside);
}

static void shuffle(int count, Sphere *spheres)
{
    for (int i = count - 1; i > 0; i--) {
        int other = (int)random_number(0, i + 1);
        Sphere kept = spheres[i];
        spheres[i] = spheres[other];
        spheres[other] = kept;
    }
}

// Spheres one behind the other as seen from the eye, in whatever direction and in any order: the
// nth is wholly between 3 n - 1 and 3 n + 1 away from it.
static void random_shells(Camera camera, Sphere *spheres)
{
    for (int i = 0; i < SHELLS; i++) {
        double across = random_number(-0.6, 0.6), upward = random_number(-0.6, 0.6);
        vec3 aside = across * camera.width * camera.right + upward * camera.height * camera.up;
        vec3 direction = vec3_unit(camera.distance * camera.forward + aside);
        spheres[i] = (Sphere){.center = camera.origin + 3 * (i + 1) * direction,
                              .radius = random_number(0.2, 1),
                              .surface = RED + i % (COLORS - RED)};
    }
    shuffle(SHELLS, spheres);
}

// The visible one whose center is nearest; -1 if there is none, -2 if it is doubtful.
static int shell_seen(vec3 eye, vec3 direction, int count, const Sphere *spheres)
{
    int nearest = -1;
    double best = INFINITY;
    for (int i = 0; i < count; i++) {
        int seen = sees(eye, direction, spheres[i]);
        if (seen < 0)
            return -2;
        double away = vec3_length(spheres[i].center - eye);
        if (seen == 1 && away < best) {
            best = away;
            nearest = i;
        }
    }
    return nearest;
}

// The same from a random camera, and the first is exactly in the direction of this pixel, so that
// some sphere is visible.
static Camera shells_behind(Resolution size, Pixel pixel, Sphere *spheres)
{
    Camera camera = random_camera();
    random_shells(camera, spheres);
    vec3 direction = vec3_unit(pixel_ray(camera, size, pixel).direction);
    for (int i = 0; i < SHELLS; i++)
        if (vec3_length(spheres[i].center - camera.origin) < 4)
            spheres[i].center = camera.origin + 3 * direction;
    return camera;
}

// The sphere that each pixel shows, or -1, by cones; false if one is doubtful.
static bool sees_shells(Camera camera, Resolution size, const Sphere *spheres, int *seen)
{
    for (int i = 0; i < size.width * size.height; i++) {
        Pixel pixel = {i % size.width, i / size.width};
        vec3 direction = pixel_ray(camera, size, pixel).direction;
        seen[i] = shell_seen(camera.origin, direction, SHELLS, spheres);
        if (seen[i] == -2)
            return false;
    }
    return true;
}

// The t of the ray at which that one is hit.
static double t_seen(Ray ray, const Sphere *spheres, int seen)
{
    return seen < 0 ? NO_HIT
                    : distance_seen(ray.origin, ray.direction, spheres[seen]) /
                          vec3_length(ray.direction);
}

// As cones say; if a pixel is doubtful, nothing is expected, and the result is false.
static bool expect_picture_of_shells(Cast *cast, Scene scene, Camera camera, Resolution size)
{
    int seen[MOST_PIXELS];
    char picture[MOST_PIXELS + 1] = "";
    if (!sees_shells(camera, size, scene.spheres, seen))
        return false;
    for (int i = 0; i < size.width * size.height; i++)
        picture[i] = seen[i] < 0 ? '.' : letter_of(scene.spheres[seen[i]].surface);
    expect_picture(cast, &scene, camera, size, picture);
    return true;
}

static void expect_depths_of_shells(Camera camera, Resolution size, Sphere *spheres)
{
    int seen[MOST_PIXELS];
    double expected[MOST_PIXELS];
    Scene scene = scene_of(SHELLS, spheres);
    if (!sees_shells(camera, size, spheres, seen))
        return;
    for (int i = 0; i < size.width * size.height; i++) {
        Ray ray = pixel_ray(camera, size, (Pixel){i % size.width, i / size.width});
        expected[i] = t_seen(ray, spheres, seen[i]);
    }
    expect_depths(&scene, camera, size, expected);
}

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

TEST(nearest_hit, the_nearest_of_three_is_hit_in_any_order_of_the_scene)
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

TEST(nearest_hit, of_equal_hits_the_lower_index_counts)
{
    Sphere spheres[] = {sphere_at(0, 0, -9, 1, RED), sphere_at(0, 0, -5, 1, GREEN),
                        sphere_at(0, 0, -5, 1, BLUE), sphere_at(0, 0, -5, 1, WHITE)};
    Scene scene = scene_of(4, spheres);
    expect_nearest(along_minus_z(0, 0, 0), &scene, 4, 1);
}

TEST(nearest_hit, what_is_behind_the_eye_is_not_hit)
{
    Sphere spheres[] = {sphere_at(0, 0, 3, 1, RED), sphere_at(0, 0, -5, 1, GREEN)};
    Scene both = scene_of(2, spheres), behind = scene_of(1, spheres);
    expect_nearest(along_minus_z(0, 0, 0), &both, 4, 1);
    expect_nearest(along_minus_z(0, 0, 0), &behind, NO_HIT, -1);
}

TEST(nearest_hit, in_an_empty_scene_nothing_is_hit)
{
    Scene scene = scene_of(0, NULL);
    expect_nearest(along_minus_z(0, 0, 0), &scene, NO_HIT, -1);
}

TEST(nearest_hit, the_first_and_the_last_sphere_can_be_hit)
{
    Sphere spheres[] = {sphere_at(-3, 0, -5, 1, RED), sphere_at(0, 0, -5, 1, RED),
                        sphere_at(3, 0, -5, 1, RED)};
    Scene scene = scene_of(3, spheres);
    expect_nearest(along_minus_z(-3, 0, 0), &scene, 4, 0);
    expect_nearest(along_minus_z(3, 0, 0), &scene, 4, 2);
}

// The center of the large one is farther away, its surface is nearer: 10 - 8 against 5 - 1.
TEST(nearest_hit, the_nearest_surface_counts_and_not_the_nearest_center)
{
    Sphere spheres[] = {sphere_at(0, 0, -5, 1, RED), sphere_at(0, 0, -10, 8, GREEN)};
    Scene scene = scene_of(2, spheres);
    expect_nearest(along_minus_z(0, 0, 0), &scene, 2, 1);
}

TEST(nearest_hit, t_counts_in_lengths_of_the_direction)
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

// The ray leaves green, which is around the eye, at t = 7; red is inside it.
TEST(nearest_hit, from_inside_a_sphere_its_far_side_is_hit_unless_another_sphere_is_nearer)
{
    Sphere spheres[] = {sphere_at(0, 0, 0, 7, GREEN), sphere_at(0, 3, -4, 1, RED)};
    Scene scene = scene_of(2, spheres);
    Ray ray = {vec3_of(0, 0, 0), vec3_of(0, -0.6, -0.8)};
    expect_nearest(ray, &scene, 7, 0);
    ray.direction = vec3_of(0, 0.6, -0.8);
    expect_nearest(ray, &scene, 4, 1);
}

// ---- both orders: what the picture shows -------------------------------------------------------

TEST_BOTH_ORDERS(paints_over_the_old_contents_of_the_image)
{
    Scene scene = scene_of(0, NULL);
    // Neither 1 nor almost 0 is changed by a mistake in the colors.
    scene.background = vec3_of(1, 0.4, 0.002);
    Resolution sizes[] = {{5, 3}, {1, 1}, {1, 2}, {6, 2}};
    const char *pictures[] = {"...............", ".", "..", "............"};
    for (int i = 0; i < 4; i++)
        expect_drawn(cast, scene, sizes[i], pictures[i]);
}

// From the eye the sphere, 10 away, is a cone; on the plane, 1 away, a disc whose radius squared is
// r^2 / (100 - r^2). So 3 for r^2 = 75: pixels with x^2 + y^2 < 3.
TEST_BOTH_ORDERS(draws_a_sphere_straight_ahead_as_a_disc)
{
    Sphere spheres[] = {sphere_at(0, 0, -10, 8.660254037844386, RED)};
    expect_drawn(cast, scene_of(1, spheres), (Resolution){7, 5},
                 "......."
                 "..rrr.."
                 "..rrr.."
                 "..rrr.."
                 ".......");
}

// One sphere in the direction of each colored pixel, and none is near another. Green is farther
// away than those before it in the list.
TEST_BOTH_ORDERS(shows_left_and_right_and_up_and_down_where_they_are)
{
    Sphere spheres[] = {sphere_at(-20, 10, -10, 2, RED), sphere_at(0, 10, -10, 2, RED),
                        sphere_at(-10, -10, -10, 2, BLUE), sphere_at(20, 0, -10, 2, GREEN)};
    expect_drawn(cast, scene_of(4, spheres), (Resolution){5, 3},
                 "r.r.."
                 "....g"
                 ".b...");
}

// All straight ahead: on the plane the radius squared of the farther one's disc is 225 / 175, of
// the nearer one's 1 / 15.
TEST_BOTH_ORDERS(shows_the_nearer_sphere_in_any_order_of_the_scene)
{
    Sphere near = sphere_at(0, 0, -4, 1, RED), far = sphere_at(0, 0, -20, 15, GREEN);
    Sphere near_first[] = {near, far}, far_first[] = {far, near};
    for (int i = 0; i < 2; i++)
        expect_drawn(cast, scene_of(2, i == 0 ? near_first : far_first), (Resolution){5, 3},
                     "..g.."
                     ".grg."
                     "..g..");
}

TEST_BOTH_ORDERS(gives_equal_hits_the_color_of_the_lower_index)
{
    Sphere spheres[] = {sphere_at(0, 0, -10, 8, BLUE), sphere_at(0, 0, -10, 8, RED)};
    expect_drawn(cast, scene_of(2, spheres), (Resolution){3, 3},
                 ".b."
                 "bbb"
                 ".b.");
}

// From the center of a sphere every pixel is blue, unless another sphere is inside it.
TEST_BOTH_ORDERS(looks_out_from_inside_a_sphere)
{
    Sphere spheres[] = {sphere_at(0, 0, 0, 50, BLUE), sphere_at(10, 0, -10, 2, RED)};
    Scene scene = scene_of(2, spheres);
    Resolution size = {4, 1};
    Camera camera = camera_with_pixels_of_1(size);
    camera.width = 8; // pixels 2 wide: centers at -3, -1, 1, 3
    expect_picture(cast, &scene, camera, size, "bbrb");
}

// The plane is 8 away; red is in front of it, blue beyond it, green behind the eye.
TEST_BOTH_ORDERS(shows_spheres_in_front_of_the_image_plane_and_none_behind_the_eye)
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

// The deck's camera: eye (2, 2, -4), plane x 1 to 3, y 1 to 3 at z = 0. Four pixels each way: the
// center of the upper left one is (1.25, 2.75, 0), and red is there; green is in the lower row.
TEST_BOTH_ORDERS(draws_with_the_left_handed_camera_of_the_deck)
{
    Sphere spheres[] = {sphere_at(1.25, 2.75, 0, 0.1, RED), sphere_at(2.25, 1.25, 0, 0.1, GREEN)};
    Scene scene = scene_of(2, spheres);
    expect_picture(cast, &scene, camera_of_the_deck(), (Resolution){4, 4},
                   "r..."
                   "...."
                   "...."
                   "..g.");
}

// Seen from z = 400 the rays are nearly along -z. Five pixels each way, 2 wide at z = 0: their
// centers are -4, -2 .. 4. By hand, as above: on each of them red is in front of green, and green
// in front of blue.
TEST_BOTH_ORDERS(draws_the_three_spheres_of_the_deck)
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

TEST_BOTH_ORDERS(draws_spheres_one_behind_the_other_as_cones_say)
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
        checked += expect_picture_of_shells(cast, scene, camera, size);
    }
}

// ---- object order: its depth, and that image order agrees --------------------------------------

// Red is around the eye, and green behind it. Then the center of the large one is farther away, but
// its surface is nearer: 10 - 8 against 5 - 1.
TEST(cast_object_order, the_depth_is_that_of_the_nearest_surface_in_front_of_the_eye)
{
    Sphere around[] = {sphere_at(0, 0, 3, 1, GREEN), sphere_at(0, 0, 0, 7, RED)};
    Sphere large[] = {sphere_at(0, 0, -5, 1, RED), sphere_at(0, 0, -10, 8, GREEN)};
    expect_depths_of(scene_of(2, around), (Resolution){1, 1}, (double[]){7});
    expect_depths_of(scene_of(2, large), (Resolution){1, 1}, (double[]){2});
}

// On the plane, 4 away, the centers of the pixels are -3, 0, 3 each way: directions beside the
// middle are 5 long. Red is 10 - 1 away, green 20 - 5, blue 15 - 2.5.
TEST(cast_object_order, the_depth_goes_row_by_row_and_counts_in_lengths_of_the_direction)
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

TEST(cast_object_order, the_depth_of_spheres_one_behind_the_other_is_that_of_the_nearest)
{
    for (int i = 0; i < 6; i++) {
        Sphere spheres[SHELLS];
        Resolution size = {5, 3};
        Camera camera = shells_behind(size, random_pixel(size), spheres);
        expect_depths_of_shells(camera, size, spheres);
    }
}

TEST(cast_object_order, in_an_empty_scene_every_depth_is_no_hit)
{
    const double expected[] = {NO_HIT, NO_HIT, NO_HIT, NO_HIT};
    expect_depths_of(scene_of(0, NULL), (Resolution){2, 2}, expected);
}

// Spheres that overlap and intersect each other, some twice, in two colors: ties.
TEST(cast_object_order, both_orders_give_the_same_bytes)
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

TEST(nearest_hit, in_a_world_of_any_size_along_a_direction_of_any_length_the_nearest_is_hit)
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

// Two of the same radius straight ahead, one of them so much nearer that no right answer can take
// the other: ten times the allowed error of a hit. The nearer one is the first, the last or
// between.
TEST(nearest_hit, of_spheres_close_together_the_nearer_is_hit)
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

TEST(nearest_hit, no_t_is_too_small)
{
    for (int i = 0; i < RUNGS; i++) {
        Scene scene = two_at(down(i));
        expect_nearest(straight_ahead, &scene, down(i), 1);
    }
}

TEST(nearest_hit, no_t_is_too_large)
{
    for (int i = 0; i < RUNGS; i++) {
        Scene scene = two_at(up(i));
        expect_nearest(straight_ahead, &scene, up(i), 1);
        scene = two_at(up(i) / 2); // 1.5e9, which an int can still hold
        expect_nearest(straight_ahead, &scene, up(i) / 2, 1);
    }
}

TEST(nearest_hit, the_nearer_sphere_is_hit_however_small_the_difference)
{
    for (int i = 0; i < RUNGS; i++) {
        double t;
        Scene scene = two_apart(down(i), &t);
        expect_nearest(straight_ahead, &scene, t, 1);
    }
}

TEST(nearest_hit, in_any_direction_the_nearest_is_hit)
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

TEST(nearest_hit, the_last_of_many_spheres_is_hit)
{
    for (int i = 0; i <= 2 * ROOMS; i++) {
        int count = i < 2 * ROOMS ? rooms[i / 2] + i % 2 : MOST_SPHERES;
        many_spheres(count, many);
        Scene scene = scene_of(count, many);
        expect_nearest(straight_ahead, &scene, 4, count - 1);
    }
}

// ---- both orders --------------------------------------------------------------------------------

TEST_BOTH_ORDERS(draws_worlds_of_any_size)
{
    Resolution size = {4, 3};
    for (int i = 0; i < SCALES; i++) {
        Sphere spheres[SHELLS];
        Camera camera = shells_behind(size, random_pixel(size), spheres);
        scale_world(scale_number(i), &camera, SHELLS, spheres);
        expect_picture_of_shells(cast, scene_of(SHELLS, spheres), camera, size);
    }
}

static const Resolution shapes[] = {{1, 9}, {9, 1},  {1, 1},  {3, 8}, {2, 5},
                                    {5, 2}, {40, 1}, {1, 40}, {17, 2}};
enum { SHAPES = sizeof shapes / sizeof *shapes };

TEST_BOTH_ORDERS(draws_pictures_of_any_shape)
{
    for (int i = 0; i < SHAPES; i++) {
        Sphere spheres[SHELLS];
        Camera camera = shells_behind(shapes[i], random_pixel(shapes[i]), spheres);
        expect_picture_of_shells(cast, scene_of(SHELLS, spheres), camera, shapes[i]);
    }
}

TEST_BOTH_ORDERS(draws_the_last_of_many_spheres)
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

// As above for nearest_hit; in most pictures the farther one is the first.
TEST_BOTH_ORDERS(draws_the_nearer_of_two_close_together)
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

// A picture of one pixel, straight ahead.
static void expect_green(Cast *cast, Scene scene)
{
    expect_drawn(cast, scene, (Resolution){1, 1}, "g");
}

TEST_BOTH_ORDERS(draws_spheres_however_small_t_is)
{
    for (int i = 0; i < RUNGS; i++)
        expect_green(cast, two_at(down(i)));
}

TEST_BOTH_ORDERS(draws_spheres_however_large_t_is)
{
    for (int i = 0; i < RUNGS; i++)
        expect_green(cast, two_at(up(i)));
}

// ---- depth --------------------------------------------------------------------------------------

TEST(cast_object_order, the_depth_in_worlds_of_any_size_is_that_of_the_nearest)
{
    Resolution size = {3, 2};
    for (int i = 0; i < SCALES; i++) {
        Sphere spheres[SHELLS];
        Camera camera = shells_behind(size, random_pixel(size), spheres);
        scale_world(scale_number(i), &camera, SHELLS, spheres);
        expect_depths_of_shells(camera, size, spheres);
    }
}

// ---- probes -------------------------------------------------------------------------------------

// Calls that distinguish the mistakes of exercise 06: spheres in front of and behind each other,
// behind the eye and around it, in any order; pictures of either shape, by any camera.

enum { SPHERES = 6 };

// Along a ray, ahead of and behind its origin and around it, a little to the side, and in any
// order.
static void random_row(Sphere *spheres, Ray ray)
{
    vec3 along = vec3_unit(ray.direction);
    for (int i = 0; i < SPHERES; i++) {
        double radius = random_number(0.4, 2.5);
        vec3 aside = random_number(0.3, 2.2) * radius * random_unit();
        spheres[i] = (Sphere){.center = ray.origin + random_number(-4, 9) * along + aside,
                              .radius = radius,
                              .surface = RED + (i + 1) % 4};
    }
}

static Light lights[] = {{.position = {3, 4, 5}, .color = {0.5, 0.6, 0.7}},
                         {.position = {-3, 5, 1}, .color = {0.7, 0.4, 0.3}},
                         {.position = {1, 2, -4}, .color = {0.2, 0.8, 0.5}},
                         {.position = {-2, 3, 2}, .color = {0.6, 0.1, 0.9}}};

static Scene any_scene(Sphere *spheres, int count)
{
    Scene scene = scene_of(count, spheres);
    scene.background = random_vec3(0.1, 0.9);
    scene.ambient = random_vec3(0.1, 0.9);
    scene.lights = lights; // for answers that count them instead of spheres
    scene.light_count = (count + 3) % 5;
    return scene;
}

static void in_a_world_of(double size, Ray *ray, int count, Sphere *spheres)
{
    ray->origin *= size;
    for (int i = 0; i < count; i++) {
        spheres[i].center *= size;
        spheres[i].radius *= size;
    }
}

PROBE(nearest_hit, nearest_hits_of_any_ray)
{
    for (int i = 0; i < 64; i++) {
        Sphere spheres[SPHERES];
        Ray ray = random_ray(3, 2);
        random_row(spheres, ray);
        Scene scene = any_scene(spheres, i % 8 == 7 ? 0 : 1 + i % SPHERES);
        if (i % 8 == 3) // one that is close
            ray.origin =
                spheres[0].center - (1 + pow(10, random_number(-7, -1)) / spheres[0].radius) *
                                        spheres[0].radius * vec3_unit(ray.direction);
        if (i % 16 == 4) // two that are equal
            spheres[1].center = spheres[0].center, spheres[1].radius = spheres[0].radius;
        if (i % 8 == 5) // any size
            in_a_world_of(pow(10, random_number(-6, 6)), &ray, SPHERES, spheres);
        nearest_hit(ray, &scene);
    }
}

static void ask_for_pictures(Cast *cast)
{
    for (int i = 0; i < 10; i++) {
        Sphere spheres[SPHERES];
        Camera camera = random_camera();
        camera.distance = random_number(0.5, 1.5);
        random_row(spheres, (Ray){camera.origin + 2 * camera.forward, camera.forward});
        if (i % 4 == 1) // around the eye
            spheres[i % 3].center = camera.origin + 0.3 * spheres[i % 3].radius * random_unit();
        if (i % 4 == 2) // two that are equal
            spheres[1].center = spheres[0].center, spheres[1].radius = spheres[0].radius;
        Scene scene = any_scene(spheres, SPHERES);
        if (i % 5 == 3) // brighter than everything in it
            scene.background = vec3_of(1, 1, 0.4);
        Resolution size = i % 2 == 0 ? (Resolution){11, 7} : (Resolution){6, 9};
        Image image = odd_image(size);
        cast(&scene, camera, &image);
        image_free(&image);
    }
}

PROBE_LINE(cast_image_order, pictures_of_any_scene_in_image_order, ask_for_pictures(image_order))

PROBE_LINE(cast_object_order, pictures_of_any_scene_in_object_order, ask_for_pictures(object_order))
