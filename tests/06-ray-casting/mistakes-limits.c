// mistakes-limits.c - wrong answers to both orders: limits that no scene and no image has.
#include "tests/06-ray-casting/mistakes-limits.h"
#include "exercises/01-corners.h"

#define IN_BOTH_ORDERS(slip, ...)                                                                  \
    IMAGE_ORDER(image_##slip, __VA_ARGS__)                                                         \
    OBJECT_ORDER(object_##slip, __VA_ARGS__)

IN_BOTH_ORDERS(from_1e_3, .t_of = hit_beyond_a_thousandth)
IN_BOTH_ORDERS(from_1e_4, .t_of = hit_beyond_1e_4)
IN_BOTH_ORDERS(from_1e_5, .t_of = hit_beyond_1e_5)
IN_BOTH_ORDERS(from_1e_6, .t_of = hit_beyond_1e_6)
IN_BOTH_ORDERS(from_1e_9, .t_of = hit_beyond_1e_9)
IN_BOTH_ORDERS(up_to_1000, .t_of = hit_before_1000)
IN_BOTH_ORDERS(up_to_1e6, .t_of = hit_before_1e6)
IN_BOTH_ORDERS(up_to_1e9, .t_of = hit_before_1e9)
IN_BOTH_ORDERS(up_to_1e12, .t_of = hit_before_1e12)
IN_BOTH_ORDERS(by_1e_3, .replaces = nearer_by_a_thousandth)
IN_BOTH_ORDERS(by_1e_6, .replaces = nearer_by_a_millionth)
IN_BOTH_ORDERS(by_1e_9, .replaces = nearer_by_a_billionth)
IN_BOTH_ORDERS(by_floats, .replaces = nearer_as_floats)

#define OF_THE_FIRST(number)                                                                       \
    static void image_of_##number(const Scene *scene, Camera camera, Image *image)                 \
    {                                                                                              \
        Scene some = at_most(number, scene);                                                       \
        cast_image_order(&some, camera, image);                                                    \
    }                                                                                              \
    static void object_of_##number(const Scene *scene, Camera camera, Image *image, double *depth) \
    {                                                                                              \
        Scene some = at_most(number, scene);                                                       \
        cast_object_order(&some, camera, image, depth);                                            \
    }
OF_THE_FIRST(10)
OF_THE_FIRST(16)
OF_THE_FIRST(32)
OF_THE_FIRST(64)
OF_THE_FIRST(100)
OF_THE_FIRST(128)
OF_THE_FIRST(256)

// ---- other pictures -----------------------------------------------------------------------------

// Rays of their own, through the places of the pixels on the plane.
static void cast_places(bool less_1, const Scene *scene, Camera camera, Image *image, double *depth)
{
    Resolution size = image->size;
    for (int i = 0; i < size.width * size.height; i++) {
        Pixel pixel = pixel_number(i, size);
        double s = (pixel.column + (less_1 ? 0 : 0.5)) / (less_1 ? size.width - 1 : size.width);
        double t = 1 - (pixel.row + (less_1 ? 0 : 0.5)) / (less_1 ? size.height - 1 : size.height);
        Hit hit = nearest_hit((Ray){camera.origin, image_plane_vector(camera, s, t)}, scene);
        image_set(image, pixel, flat_color(scene, hit.sphere));
        if (depth != NULL)
            depth[i] = hit.t;
    }
}

static void image_through_width_less_1(const Scene *scene, Camera camera, Image *image)
{
    cast_places(true, scene, camera, image, NULL);
}

static void object_through_width_less_1(const Scene *scene, Camera camera, Image *image,
                                        double *depth)
{
    cast_places(true, scene, camera, image, depth);
}

// The camera's height computed from the picture's shape, or its width.
static Camera shaped(bool width, Camera camera, Resolution size)
{
    if (width)
        camera.width = camera.height * size.width / size.height;
    else
        camera.height = camera.width * size.height / size.width;
    return camera;
}

#define SHAPED(name, width)                                                                        \
    static void image_##name(const Scene *scene, Camera camera, Image *image)                      \
    {                                                                                              \
        cast_image_order(scene, shaped(width, camera, image->size), image);                        \
    }                                                                                              \
    static void object_##name(const Scene *scene, Camera camera, Image *image, double *depth)      \
    {                                                                                              \
        cast_object_order(scene, shaped(width, camera, image->size), image, depth);                \
    }
SHAPED(height_by_shape, false)
SHAPED(width_by_shape, true)

static void image_plane_at_1(const Scene *scene, Camera camera, Image *image)
{
    camera.distance = 1;
    cast_image_order(scene, camera, image);
}

static void object_plane_at_1(const Scene *scene, Camera camera, Image *image, double *depth)
{
    camera.distance = 1;
    cast_object_order(scene, camera, image, depth);
}

// The colour of a hit is kept for the next pixels of the row and below.
static void colour_kept(const Scene *scene, Camera camera, Image *image)
{
    int sphere = -1;
    for (int i = 0; i < image->size.width * image->size.height; i++) {
        Pixel pixel = pixel_number(i, image->size);
        Hit hit = nearest_hit(pixel_ray(camera, image->size, pixel), scene);
        sphere = hit.sphere >= 0 ? hit.sphere : sphere;
        image_set(image, pixel, flat_color(scene, sphere));
    }
}

static void last_pixel_left_out(const Scene *scene, Camera camera, Image *image)
{
    Resolution size = image->size;
    Pixel last = {size.width - 1, size.height - 1};
    uint8_t *bytes = image_bytes(image, last), kept[3] = {bytes[0], bytes[1], bytes[2]};
    cast_image_order(scene, camera, image);
    for (int i = 0; i < 3; i++)
        bytes[i] = kept[i];
}

// ---- depths -------------------------------------------------------------------------------------

// A pixel that has a depth already keeps it, whatever is painted there.
static void first_depth_kept(const Scene *scene, Camera camera, Image *image, double *depth)
{
    cast_nothing(&(Slips){0}, scene, image, depth);
    for (int sphere = 0; sphere < scene->sphere_count; sphere++)
        for (int i = 0; i < image->size.width * image->size.height; i++) {
            Pixel pixel = pixel_number(i, image->size);
            double t = hit_sphere(pixel_ray(camera, image->size, pixel), scene->spheres[sphere]);
            if (!(t < depth[i]))
                continue;
            image_set(image, pixel, flat_color(scene, sphere));
            depth[i] = depth[i] == NO_HIT ? t : depth[i];
        }
}

static void starting_at(double t, const Scene *scene, Camera camera, Image *image, double *depth)
{
    cast_with((Slips){.depth_starts_elsewhere = true, .depth_start = t}, scene, camera, image,
              depth);
}

#define STARTS(name, t)                                                                            \
    static void depth_starts_at_##name(const Scene *scene, Camera camera, Image *image,            \
                                       double *depth)                                              \
    {                                                                                              \
        starting_at(t, scene, camera, image, depth);                                               \
    }
STARTS(100, 100)
STARTS(1e6, 1e6)
STARTS(1e9, 1e9)
STARTS(1e30, 1e30)
STARTS(the_largest, 1.7976931348623157e308)

#define BOTH(id, slip, formula, why, picture)                                                      \
    MISTAKE("I-" id, cast_image_order, image_##slip, formula, why, picture),                       \
        MISTAKE("O-" id, cast_object_order, object_##slip, formula, why, picture)
#define FROM(least, slip)                                                                          \
    BOTH("t-" least, slip, "hits with t up to " least " dropped",                                  \
         "t counts in lengths of the direction, and scenes are of any size: every hit with "       \
         "t > 0 is in front of the eye.",                                                          \
         "right in scenes of one size, holes in others")
#define UP_TO(most, slip)                                                                          \
    BOTH("up-" most, slip, "only hits with t below " most,                                         \
         "a scene may be of any size: every t > 0 is a hit.",                                      \
         "no visible difference, until a sphere is farther away than that")
#define BY(epsilon, slip)                                                                          \
    BOTH("by-" epsilon, slip, "only hits that are nearer by " epsilon,                             \
         "scenes are of any size, and t counts in lengths of the direction: nearer is nearer, "    \
         "by however little.",                                                                     \
         "right in scenes of one size, wrong colours in smaller ones")
#define ROOM(number)                                                                               \
    BOTH("room" #number, of_##number, "the first " #number " spheres",                             \
         "the number of spheres in the scene is sphere_count.",                                    \
         "no visible difference, until a scene has more spheres")
#define STARTS_ROW(t, answer)                                                                      \
    MISTAKE("Z-" t, cast_object_order, answer, "depths that start at " t,                          \
            "a scene may be of any size. If nothing is hit the depth is NO_HIT.",                  \
            "no visible difference, until a sphere is farther away than that")

const Mistake picture_limit_mistakes[] = {
    FROM("0.001", from_1e_3),
    FROM("1e-4", from_1e_4),
    FROM("1e-5", from_1e_5),
    FROM("1e-6", from_1e_6),
    FROM("1e-9", from_1e_9),
    UP_TO("1000", up_to_1000),
    UP_TO("1e6", up_to_1e6),
    UP_TO("1e9", up_to_1e9),
    UP_TO("1e12", up_to_1e12),
    BY("0.001", by_1e_3),
    BY("1e-6", by_1e_6),
    BY("1e-9", by_1e_9),
    BOTH("by-float", by_floats, "t compared as floats",
         "a float has 7 digits, a double 16, and spheres may be close together.",
         "speckles where surfaces nearly touch"),
    ROOM(10),
    ROOM(16),
    ROOM(32),
    ROOM(64),
    ROOM(100),
    ROOM(128),
    ROOM(256),
    BOTH("N3", through_width_less_1, "divided by width - 1 and height - 1",
         "w pixels are w steps wide, and the ray goes through the centre of its pixel: use "
         "pixel_ray.",
         "slightly too large; nothing in an image of one row or one column"),
    BOTH("height-shape", height_by_shape, "the height of the image plane from the image's shape",
         "the camera gives the height of its plane. pixel_ray uses it unchanged.",
         "stretched if pixels are not square"),
    BOTH("width-shape", width_by_shape, "the width of the image plane from the image's shape",
         "the camera gives the width of its plane. pixel_ray uses it unchanged.",
         "stretched if pixels are not square"),
    BOTH("plane1", plane_at_1, "an image plane 1 away",
         "the camera gives the distance of its plane. pixel_ray uses it unchanged.",
         "spheres too small or too large, unless the distance is 1"),
    MISTAKE("I-kept", cast_image_order, colour_kept, "the colour of the last hit if nothing is hit",
            "if nothing is hit, the pixel has the background's colour: set it for each pixel.",
            "spheres smeared to the right and down"),
    MISTAKE("I-pixel", cast_image_order, last_pixel_left_out, "the last pixel not painted",
            "the w * h pixels have the numbers 0 to w * h - 1, and the last one must be painted.",
            "a dot in the lower right corner"),
    MISTAKE("Z-first-t", cast_object_order, first_depth_kept, "the depth of the first hit kept",
            "when a nearer sphere is painted, store its t as well.",
            "far spheres in front of near ones, in the order of the scene"),
    STARTS_ROW("100", depth_starts_at_100),
    STARTS_ROW("1e6", depth_starts_at_1e6),
    STARTS_ROW("1e9", depth_starts_at_1e9),
    STARTS_ROW("1e30", depth_starts_at_1e30),
    MISTAKE("Z-max", cast_object_order, depth_starts_at_the_largest, "DBL_MAX if nothing is hit",
            "a ray that misses everything never ends: its t is NO_HIT, which is infinite.",
            "the same picture; but a caller who tests t < NO_HIT sees a hit"),
    {0},
};
