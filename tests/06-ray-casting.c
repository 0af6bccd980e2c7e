// 06-ray-casting.c - tests of exercise 06. Expected: the deck's three spheres worked by hand, and
// pictures decided by angles: a sphere is a cone as seen from the eye.
#include "exercises/06-ray-casting.h"

#include "exercises/04-pixel-ray.h"
#include "tests/judge/test.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const double tolerance = 1e-9;

// ---- scenes and pictures ------------------------------------------------------------------------

// The colours, and the letters that stand for them in pictures. No sphere has surface 0, and the
// sphere of a number seldom has the surface of that number.
enum { UNUSED, RED, GREEN, BLUE, WHITE, COLORS };
static const char letters[] = "?rgbw";
static Surface surfaces[COLORS] = {
    [UNUSED] = {.color = {0.2, 0.9, 0.4}}, [RED] = {.color = {1, 0, 0}},
    [GREEN] = {.color = {0, 1, 0}},        [BLUE] = {.color = {0, 0, 1}},
    [WHITE] = {.color = {1, 1, 1}},
};

static Sphere sphere_at(double x, double y, double z, double radius, int color)
{
    return (Sphere){vec3_of(x, y, z), radius, color};
}

static Scene scene_of(int count, Sphere *spheres)
{
    double grey = 127 / 255.0;
    return (Scene){.background = vec3_of(grey, grey, grey),
                   .spheres = spheres,
                   .sphere_count = count,
                   .surfaces = surfaces,
                   .surface_count = COLORS};
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
        given(label, "center %s, radius %s, colour %s", vec3_text(s->center).s,
              number_text(s->radius).s, vec3_text(scene_surface(scene, i)->color).s);
    }
    if (scene->sphere_count > MOST_SHOWN)
        given("and more", "%d in all", scene->sphere_count);
}

// Looks along -z, as in NFF; right-handed. The plane is 1 away, and a pixel 1 wide: on it the
// centres of 5 x 3 pixels are -2 .. 2 by -1 .. 1.
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

// Both orders take the same tests.
typedef void Cast(const Scene *scene, Camera camera, Image *image);

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

#define IN_BOTH_ORDERS(sentence)                                                                   \
    START_TEST(image_order_##sentence)                                                             \
    {                                                                                              \
        sentence(image_order);                                                                     \
    }                                                                                              \
    END_TEST                                                                                       \
    START_TEST(object_order_##sentence)                                                            \
    {                                                                                              \
        sentence(object_order);                                                                    \
    }                                                                                              \
    END_TEST

// An image in a colour that no scene has, so that a pixel that was left out is seen.
static Image odd_image(Resolution size)
{
    Image image = image_of(size);
    memset(image.rgb, 0x5a, 3 * pixel_count(&image));
    return image;
}

static const Surface *surface_of_letter(char letter)
{
    const char *place = strchr(letters, letter);
    return letter == '.' || place == NULL ? NULL : &surfaces[place - letters];
}

// Expected is a picture in letters, row by row from the top; '.' is the background.
static void expect_picture(Cast *cast, const Scene *scene, Camera camera, Resolution size,
                           const char *expected)
{
    Image picture = image_of(size), image = odd_image(size);
    for (int i = 0; expected[i] != '\0'; i++) {
        const Surface *surface = surface_of_letter(expected[i]);
        image_set(&picture, (Pixel){i % size.width, i / size.width},
                  surface == NULL ? scene->background : surface->color);
    }
    given_scene(scene);
    given_camera(camera);
    given_size(size);
    cast(scene, camera, &image);
    expect_same_image(&image, &picture);
    image_free(&picture);
    image_free(&image);
}

// ---- what cones say -----------------------------------------------------------------------------

static double cosine_between(vec3 v, vec3 w)
{
    return vec3_dot(v, w) / (vec3_length(v) * vec3_length(w));
}

// 1 where the direction from the eye meets the sphere, 0 where it does not, -1 where it passes too
// close to the silhouette to be sure. From the eye a sphere of radius r, D away, is a cone whose
// half angle has the sine r / D.
static int sees(vec3 eye, vec3 direction, Sphere sphere)
{
    vec3 center = sphere.center - eye;
    double sine = sphere.radius / vec3_length(center);
    double inside = cosine_between(direction, center) - sqrt(1 - sine * sine);
    return fabs(inside) < tolerance ? -1 : inside > 0;
}

// How far the sphere is in that direction, by the law of cosines in the triangle of the eye, the
// hit and the centre.
static double distance_seen(vec3 eye, vec3 direction, Sphere sphere)
{
    vec3 center = sphere.center - eye;
    double away = vec3_length(center), cosine = cosine_between(direction, center);
    double aside = away * sqrt(1 - cosine * cosine);
    return away * cosine - sqrt(sphere.radius * sphere.radius - aside * aside);
}

enum { SHELLS = 8 };

// Spheres one behind the other as seen from the eye, in whatever direction: number i is wholly
// between 3 (i + 1) - 1 and 3 (i + 1) + 1 away from it.
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

// The one whose centre is nearest of those seen; -1 where there is none, -2 where it is doubtful.
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

// ---- nearest_hit --------------------------------------------------------------------------------

static void expect_nearest(Ray ray, const Scene *scene, double t, int sphere)
{
    given_scene(scene);
    given_ray(ray);
    given("looking at", "t");
    expect_number(nearest_hit(ray, scene).t, t, tolerance);
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

START_TEST(of_equals_the_lower_index_is_hit)
{
    Sphere spheres[] = {sphere_at(0, 0, -9, 1, RED), sphere_at(0, 0, -5, 1, GREEN),
                        sphere_at(0, 0, -5, 1, BLUE), sphere_at(0, 0, -6, 2, WHITE)};
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

START_TEST(where_nothing_is_hit_there_is_no_hit_and_no_sphere)
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

// The centre of the large one is farther, its surface is nearer: 10 - 8 against 5 - 1.
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
}
END_TEST

// Green, round the eye, is left at t = 7; red stands inside it.
START_TEST(from_inside_a_sphere_its_far_side_is_hit_and_what_stands_before_it)
{
    Sphere spheres[] = {sphere_at(0, 0, 0, 7, GREEN), sphere_at(0, 3, -4, 1, RED)};
    Scene scene = scene_of(2, spheres);
    Ray ray = {vec3_of(0, 0, 0), vec3_of(0, -0.6, -0.8)};
    expect_nearest(ray, &scene, 7, 0);
    ray.direction = vec3_of(0, 0.6, -0.8);
    expect_nearest(ray, &scene, 4, 1);
}
END_TEST

// The deck's scene; as NFF, z is towards the eye.
static const Sphere spheres_of_the_deck[] = {
    {{2, 2, 1}, 3, RED}, {{2, -2, 0}, 3, GREEN}, {{-2, 0, -1}, 3, BLUE}};

// By hand, with rays along -z from z = 20: over (x, y) a sphere round (cx, cy, cz) reaches up to
// cz + sqrt(9 - (x - cx)^2 - (y - cy)^2).
START_TEST(where_the_decks_spheres_overlap_red_is_before_green_and_green_before_blue)
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
    Sphere spheres[3];
    memcpy(spheres, spheres_of_the_deck, sizeof spheres);
    Scene scene = scene_of(3, spheres);
    for (int i = 0; i < 4; i++)
        expect_nearest(along_minus_z(places[i].x, places[i].y, 20), &scene, 20 - places[i].z,
                       places[i].sphere);
}
END_TEST

START_TEST(of_spheres_one_behind_the_other_the_nearest_is_hit)
{
    int checked = 0;
    for (int i = 0; i < 40; i++) {
        Sphere spheres[SHELLS];
        Camera camera = random_camera();
        random_shells(camera, spheres);
        shuffle(SHELLS, spheres);
        Scene scene = scene_of(SHELLS, spheres);
        Pixel pixel = {(int)random_number(0, 16), (int)random_number(0, 9)};
        Ray ray = pixel_ray(camera, (Resolution){16, 9}, pixel);
        int seen = shell_seen(ray.origin, ray.direction, SHELLS, spheres);
        if (seen == -2)
            continue;
        double t = seen < 0 ? NO_HIT
                            : distance_seen(ray.origin, ray.direction, spheres[seen]) /
                                  vec3_length(ray.direction);
        expect_nearest(ray, &scene, t, seen);
        checked += seen >= 0;
    }
    ck_assert_int_ge(checked, 10);
}
END_TEST

// ---- pictures, in both orders -------------------------------------------------------------------

static void leaves_nothing_of_what_was_in_the_image(Cast *cast)
{
    Scene scene = scene_of(0, NULL);
    scene.background = vec3_of(0.2, 0.4, 0.6);
    Resolution sizes[] = {{5, 3}, {1, 1}, {2, 6}};
    const char *pictures[] = {"...............", ".", "............"};
    for (int i = 0; i < 3; i++)
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

// One sphere straight behind each coloured pixel, and none is near another.
static void has_left_and_right_and_up_and_down_where_they_are(Cast *cast)
{
    Sphere spheres[] = {sphere_at(-20, 10, -10, 2, RED), sphere_at(0, 10, -10, 2, RED),
                        sphere_at(20, 0, -10, 2, GREEN), sphere_at(-10, -10, -10, 2, BLUE)};
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
    Sphere spheres[3];
    memcpy(spheres, spheres_of_the_deck, sizeof spheres);
    Scene scene = scene_of(3, spheres);
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
    for (int i = 0; i < 12; i++) {
        Sphere spheres[SHELLS];
        Camera camera = random_camera();
        random_shells(camera, spheres);
        shuffle(SHELLS, spheres);
        Scene scene = scene_of(SHELLS, spheres);
        char picture[16 * 9 + 1] = "";
        bool doubtful = false;
        for (int k = 0; k < 16 * 9; k++) {
            vec3 direction = pixel_ray(camera, size, (Pixel){k % 16, k / 16}).direction;
            int seen = shell_seen(camera.origin, direction, SHELLS, spheres);
            doubtful = doubtful || seen == -2;
            picture[k] = seen < 0 ? '.' : letters[spheres[seen].surface];
        }
        if (doubtful)
            continue;
        expect_picture(cast, &scene, camera, size, picture);
        checked++;
    }
    ck_assert_int_ge(checked, 6);
}
IN_BOTH_ORDERS(draws_what_cones_say_of_spheres_one_behind_the_other)

// ---- the depth of object order ------------------------------------------------------------------

START_TEST(what_is_in_the_depth_before_does_not_matter)
{
    Sphere spheres[] = {sphere_at(10, 0, -10, 2, GREEN), sphere_at(0, 0, -10, 2, RED),
                        sphere_at(0, 0, -20, 2, BLUE)};
    Scene scene = scene_of(3, spheres);
    Resolution size = {3, 1};
    Image expected = image_of(size), image = odd_image(size);
    image_set(&expected, (Pixel){0, 0}, scene.background);
    image_set(&expected, (Pixel){1, 0}, surfaces[RED].color);
    image_set(&expected, (Pixel){2, 0}, surfaces[GREEN].color);
    const double junk[] = {NAN, 0, -1, 1e-300, -INFINITY, 9};
    for (int i = 0; i < 6; i++) {
        double depth[] = {junk[i], junk[i], junk[i]};
        given_scene(&scene);
        given_size(size);
        given("depth", "%g everywhere before", junk[i]);
        cast_object_order(&scene, camera_with_pixels_of_1(size), &image, depth);
        expect_same_image(&image, &expected);
    }
    image_free(&expected);
    image_free(&image);
}
END_TEST

// After casting, what is in the depth of one pixel.
static void expect_depth(const Scene *scene, Camera camera, Resolution size, Pixel pixel, double t)
{
    double depth[15];
    for (int i = 0; i < size.width * size.height; i++)
        depth[i] = NAN;
    given_scene(scene);
    given_camera(camera);
    given_size(size);
    given("looking at", "the depth of column %d, row %d", pixel.column, pixel.row);
    Image image = odd_image(size);
    cast_object_order(scene, camera, &image, depth);
    image_free(&image);
    expect_number(depth[pixel.row * size.width + pixel.column], t, tolerance);
}

// 10 - 2, where the pixel's direction is 1 long; the plane is 1 away.
START_TEST(the_depth_straight_ahead_is_the_t_of_the_nearest_hit)
{
    Sphere spheres[] = {sphere_at(0, 0, -30, 2, BLUE), sphere_at(0, 0, -10, 2, RED),
                        sphere_at(0, 0, -20, 2, GREEN)};
    Scene scene = scene_of(3, spheres);
    Resolution size = {5, 3};
    Camera camera = camera_with_pixels_of_1(size);
    expect_depth(&scene, camera, size, (Pixel){2, 1}, 8);
    expect_depth(&scene, camera, size, (Pixel){0, 0}, NO_HIT);
    expect_depth(&scene, camera, size, (Pixel){4, 2}, NO_HIT);
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
    for (int i = 0; i < 9; i++)
        expect_depth(&scene, camera, size, (Pixel){i % 3, i / 3}, expected[i]);
}
END_TEST

START_TEST(where_there_is_nothing_every_depth_is_no_hit)
{
    Scene scene = scene_of(0, NULL);
    Resolution size = {2, 2};
    for (int i = 0; i < 4; i++)
        expect_depth(&scene, camera_with_pixels_of_1(size), size, (Pixel){i % 2, i / 2}, NO_HIT);
}
END_TEST

// Spheres that overlap and pass through each other, some twice, in two colours: ties.
START_TEST(both_orders_give_the_same_bytes)
{
    Resolution size = {24, 17};
    for (int i = 0; i < 6; i++) {
        enum { COUNT = 24 };
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
        given("compared", "with what image order gives");
        image_order(&scene, camera, &by_pixel);
        object_order(&scene, camera, &by_sphere);
        expect_same_image(&by_sphere, &by_pixel);
        image_free(&by_pixel);
        image_free(&by_sphere);
    }
}
END_TEST

void list_tests(void)
{
    tests_of("nearest_hit");
    test(the_nearest_of_three_is_hit_in_any_order_of_the_scene);
    test(of_equals_the_lower_index_is_hit);
    test(what_is_behind_the_eye_is_not_hit);
    test(where_nothing_is_hit_there_is_no_hit_and_no_sphere);
    test(in_an_empty_scene_nothing_is_hit);
    test(the_first_and_the_last_sphere_can_be_hit);
    test(the_nearest_surface_counts_and_not_the_nearest_centre);
    test(t_counts_in_lengths_of_the_direction);
    test(from_inside_a_sphere_its_far_side_is_hit_and_what_stands_before_it);
    test(where_the_decks_spheres_overlap_red_is_before_green_and_green_before_blue);
    test(of_spheres_one_behind_the_other_the_nearest_is_hit);
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
    test(what_is_in_the_depth_before_does_not_matter);
    test(the_depth_straight_ahead_is_the_t_of_the_nearest_hit);
    test(the_depth_goes_row_by_row_and_counts_in_lengths_of_the_direction);
    test(where_there_is_nothing_every_depth_is_no_hit);
    test(both_orders_give_the_same_bytes);
}
