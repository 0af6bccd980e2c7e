// support.h - what the tests and the probes of exercise 06 share.
#ifndef TESTS_06_RAY_CASTING_SUPPORT_H
#define TESTS_06_RAY_CASTING_SUPPORT_H

#include "exercises/06-ray-casting.h"

#include "tests/judge/test.h"

#define TOLERANCE 1e-9

// The colours, and the letters that represent them in pictures. No component is 0 or 1, no two of a
// colour are equal, and one of red is so small that 255 times it is not yet white. No sphere has
// surface 0, and a sphere seldom has the surface of its own number; but there is a surface 0,
// black, for answers that confuse the two numbers.
enum { UNUSED, RED, GREEN, BLUE, WHITE, COLORS, SURFACES = 24 };
extern Surface surfaces[SURFACES];
char letter_of(int color);

static inline Sphere sphere_at(double x, double y, double z, double radius, int color)
{
    return (Sphere){vec3_of(x, y, z), radius, color};
}

// On a greyish blue. The spheres still belong to the caller.
Scene scene_of(int count, Sphere *spheres);
// The deck's three; as NFF, z is towards the eye.
Scene scene_of_the_deck(void);

// Looks along -z, as in NFF; right-handed. The plane is 1 away, and a pixel 1 wide: on it the
// centres of 5 x 3 pixels are -2 .. 2 by -1 .. 1.
Camera camera_with_pixels_of_1(Resolution size);

void given_scene(const Scene *scene);
void given_size(Resolution size);

// An image in a colour that no scene has, so that an omitted pixel is visible.
Image odd_image(Resolution size);
Image image_of(Resolution size);

// Both orders have the same tests; image order needs no depth.
typedef void Cast(const Scene *scene, Camera camera, Image *image);
void image_order(const Scene *scene, Camera camera, Image *image);
void object_order(const Scene *scene, Camera camera, Image *image);

// A test for each order: image_order_SENTENCE and object_order_SENTENCE.
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

// Expected is a picture in letters, row by row from the top; '.' is the background.
void expect_picture(Cast *cast, const Scene *scene, Camera camera, Resolution size,
                    const char *expected);

// The values that object order must leave in depth, for all pixels, row by row.
void expect_depths(const Scene *scene, Camera camera, Resolution size, const double *expected);

enum { SHELLS = 8, MOST_PIXELS = 48 };

// Spheres one behind the other as seen from the eye, in whatever direction and in any order: the
// nth is wholly between 3 n - 1 and 3 n + 1 away from it.
void random_shells(Camera camera, Sphere *spheres);
// The same from a random camera, and the first is exactly in the direction of this pixel, so that
// some sphere is visible.
Camera shells_behind(Resolution size, Pixel pixel, Sphere *spheres);
// The visible one whose centre is nearest; -1 if there is none, -2 if it is doubtful.
int shell_seen(vec3 eye, vec3 direction, int count, const Sphere *spheres);
// The t of the ray at which that one is hit.
double t_seen(Ray ray, const Sphere *spheres, int seen);
// As cones say; if a pixel is doubtful, nothing is expected.
void expect_picture_of_shells(Cast *cast, Camera camera, Resolution size, Sphere *spheres);
void expect_depths_of_shells(Camera camera, Resolution size, Sphere *spheres);

#endif
