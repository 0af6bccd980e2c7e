// support.c - scenes and images for the tests of exercise 06, and how they are described.
#include "tests/06-ray-casting/support.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

// ---- scenes and images --------------------------------------------------------------------------

static const char letters[] = "?rgbw";
Surface surfaces[SURFACES] = {
    [UNUSED] = {{0.3, 0.95, 0.4}, 0.45, 0.55, 7, 0, 1},
    [RED] = {{0.85, 0.15, 0.002}, 0.6, 0.3, 5, 0, 1},
    [GREEN] = {{0.2, 0.75, 0.45}, 0.7, 0.2, 3, 0, 1},
    [BLUE] = {{0.25, 0.4, 0.95}, 0.8, 0.1, 9, 0, 1},
    [WHITE] = {{0.95, 0.85, 0.65}, 0.5, 0.4, 4, 0, 1},
};

char letter_of(int color)
{
    return letters[color];
}

Scene scene_of(int count, Sphere *spheres)
{
    return (Scene){.background = vec3_of(0.35, 0.45, 0.55),
                   .ambient = vec3_of(0.12, 0.31, 0.23),
                   .spheres = spheres,
                   .sphere_count = count,
                   .surfaces = surfaces,
                   .surface_count = SURFACES};
}

void given_scene(const Scene *scene)
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

Camera camera_with_pixels_of_1(Resolution size)
{
    return (Camera){.origin = vec3_of(0, 0, 0),
                    .right = vec3_of(1, 0, 0),
                    .up = vec3_of(0, 1, 0),
                    .forward = vec3_of(0, 0, -1),
                    .distance = 1,
                    .width = size.width,
                    .height = size.height};
}

Scene scene_of_the_deck(void)
{
    static Sphere spheres[] = {{{2, 2, 1}, 3, RED}, {{2, -2, 0}, 3, GREEN}, {{-2, 0, -1}, 3, BLUE}};
    return scene_of(3, spheres);
}

Image image_of(Resolution size)
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

void given_size(Resolution size)
{
    given("image", "%d x %d pixels", size.width, size.height);
}

// ---- pictures -----------------------------------------------------------------------------------

void image_order(const Scene *scene, Camera camera, Image *image)
{
    cast_image_order(scene, camera, image);
}

void object_order(const Scene *scene, Camera camera, Image *image)
{
    double *depth = malloc(pixel_count(image) * sizeof *depth);
    for (size_t i = 0; i < pixel_count(image); i++)
        depth[i] = NO_HIT;
    cast_object_order(scene, camera, image, depth);
    free(depth);
}

Image odd_image(Resolution size)
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

void expect_picture(Cast *cast, const Scene *scene, Camera camera, Resolution size,
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

static bool is_near(double depth, double t)
{
    return depth == t || (t < NO_HIT && fabs(depth - t) <= TOLERANCE * t);
}

// One call, and one of its pixels is reported: the first that is not as expected.
void expect_depths(const Scene *scene, Camera camera, Resolution size, const double *expected)
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
    given("looking at", "the depth of column %d, row %d", i % size.width, i / size.width);
    expect_number(depth[i], expected[i], expected[i] == NO_HIT ? 0 : TOLERANCE * expected[i]);
}
