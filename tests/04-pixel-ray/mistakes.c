// mistakes.c - wrong answers to exercise 04: the mistake is in the camera, between (s, t) and the
// ray.
#include "exercises/04-pixel-ray.h"

#include "exercises/01-corners.h"
#include "exercises/03-screen.h"
#include "tests/judge/mistake.h"

extern const Mistake pixel_mistakes[], pixel_axis_mistakes[];

// The right way as far as s and t.
static Normalized place_of(Resolution screen, Pixel pixel)
{
    return screen_to_normalized(pixel_center(pixel), screen);
}

// The right way to the image plane.
static vec3 towards(Camera camera, Resolution screen, Pixel pixel)
{
    Normalized place = place_of(screen, pixel);
    return image_plane_vector(camera, place.s, place.t);
}

static Ray from_the_worlds_origin(Camera camera, Resolution screen, Pixel pixel)
{
    return (Ray){vec3_of(0, 0, 0), towards(camera, screen, pixel)};
}

static Ray from_the_plane(Camera camera, Resolution screen, Pixel pixel)
{
    vec3 direction = towards(camera, screen, pixel);
    return (Ray){camera.origin + direction, direction};
}

static Ray parallel_rays(Camera camera, Resolution screen, Pixel pixel)
{
    return (Ray){camera.origin + towards(camera, screen, pixel), camera.forward};
}

static Ray point_and_vector_swapped(Camera camera, Resolution screen, Pixel pixel)
{
    return (Ray){towards(camera, screen, pixel), camera.origin};
}

static Ray towards_the_point(Camera camera, Resolution screen, Pixel pixel)
{
    return (Ray){camera.origin, camera.origin + towards(camera, screen, pixel)};
}

static Ray eye_taken_off_a_vector(Camera camera, Resolution screen, Pixel pixel)
{
    return (Ray){camera.origin, towards(camera, screen, pixel) - camera.origin};
}

static Ray towards_the_eye(Camera camera, Resolution screen, Pixel pixel)
{
    return (Ray){camera.origin, -towards(camera, screen, pixel)};
}

static Ray forward_backwards(Camera camera, Resolution screen, Pixel pixel)
{
    camera.forward = -camera.forward;
    return (Ray){camera.origin, towards(camera, screen, pixel)};
}

static Ray mirrored(Camera camera, Resolution screen, Pixel pixel)
{
    Normalized place = place_of(screen, pixel);
    return (Ray){camera.origin, image_plane_vector(camera, 1 - place.s, place.t)};
}

static Ray turned_over_twice(Camera camera, Resolution screen, Pixel pixel)
{
    Normalized place = place_of(screen, pixel);
    return (Ray){camera.origin, image_plane_vector(camera, 1 - place.s, 1 - place.t)};
}

static Ray s_and_t_swapped(Camera camera, Resolution screen, Pixel pixel)
{
    Normalized place = place_of(screen, pixel);
    return (Ray){camera.origin, image_plane_vector(camera, place.t, place.s)};
}

static Ray from_minus_1_to_1(Camera camera, Resolution screen, Pixel pixel)
{
    Normalized place = place_of(screen, pixel);
    return (Ray){camera.origin, image_plane_vector(camera, 2 * place.s - 1, 2 * place.t - 1)};
}

static Ray counted_from_the_corner(Camera camera, Resolution screen, Pixel pixel)
{
    Normalized place = place_of(screen, pixel);
    return (Ray){camera.origin, image_plane_vector(camera, place.s + 0.5, place.t + 0.5)};
}

static Ray up_from_the_top(Camera camera, Resolution screen, Pixel pixel)
{
    Normalized place = place_of(screen, pixel);
    return (Ray){camera.origin, image_plane_vector(camera, place.s, place.t + 1)};
}

static Ray distance_taken_as_1(Camera camera, Resolution screen, Pixel pixel)
{
    camera.distance = 1;
    return (Ray){camera.origin, towards(camera, screen, pixel)};
}

static Ray nothing_ahead(Camera camera, Resolution screen, Pixel pixel)
{
    return (Ray){camera.origin, towards(camera, screen, pixel) - camera.distance * camera.forward};
}

static Ray plane_of_size_1(Camera camera, Resolution screen, Pixel pixel)
{
    camera.width = camera.height = 1;
    return (Ray){camera.origin, towards(camera, screen, pixel)};
}

static Ray half_a_plane(Camera camera, Resolution screen, Pixel pixel)
{
    camera.width /= 2;
    camera.height /= 2;
    return (Ray){camera.origin, towards(camera, screen, pixel)};
}

static Ray two_planes(Camera camera, Resolution screen, Pixel pixel)
{
    camera.width *= 2;
    camera.height *= 2;
    return (Ray){camera.origin, towards(camera, screen, pixel)};
}

static Ray width_of_the_screens_shape(Camera camera, Resolution screen, Pixel pixel)
{
    camera.width = camera.height * screen.width / screen.height;
    return (Ray){camera.origin, towards(camera, screen, pixel)};
}

static Ray height_of_the_screens_shape(Camera camera, Resolution screen, Pixel pixel)
{
    camera.height = camera.width * screen.height / screen.width;
    return (Ray){camera.origin, towards(camera, screen, pixel)};
}

static Ray always_right_handed(Camera camera, Resolution screen, Pixel pixel)
{
    camera.right = vec3_cross(camera.forward, camera.up);
    return (Ray){camera.origin, towards(camera, screen, pixel)};
}

static Ray always_left_handed(Camera camera, Resolution screen, Pixel pixel)
{
    camera.right = vec3_cross(camera.up, camera.forward);
    return (Ray){camera.origin, towards(camera, screen, pixel)};
}

static Ray axes_of_the_world(Camera camera, Resolution screen, Pixel pixel)
{
    camera.right = vec3_of(1, 0, 0);
    camera.up = vec3_of(0, 1, 0);
    camera.forward = vec3_of(0, 0, 1);
    return (Ray){camera.origin, towards(camera, screen, pixel)};
}

static const Mistake camera_mistakes[] = {
    MISTAKE("P7", pixel_ray, from_the_worlds_origin, "origin (0, 0, 0)",
            "every ray starts at the camera's eye and not at the origin of the world.",
            "moving the camera does nothing"),
    MISTAKE("P-plane", pixel_ray, from_the_plane, "origin p + v",
            "the ray starts at the eye, not on the plane. Objects nearer than the plane are in "
            "front of the eye as well.",
            "near objects vanish"),
    MISTAKE("P-parallel", pixel_ray, parallel_rays, "origin p + v, direction f",
            "all rays are parallel. They must spread out from the eye.",
            "objects look equally large at any distance"),
    MISTAKE("P-order", pixel_ray, point_and_vector_swapped, "origin v, direction p",
            "the ray starts at the eye, and v is its direction. Here they are swapped.",
            "nothing recognisable"),
    MISTAKE("P8", pixel_ray, towards_the_point, "direction p + v",
            "this is the point on the plane. The direction is the vector from the eye to it, "
            "without p.",
            "right if the eye is at the origin; if not, the view is off to one side"),
    MISTAKE("P8-minus", pixel_ray, eye_taken_off_a_vector, "direction v - p",
            "v starts at the eye already, so do not subtract the eye again.",
            "right if the eye is at the origin; if not, the view is off to one side"),
    MISTAKE("P-behind", pixel_ray, towards_the_eye, "direction -v",
            "this is the vector back, from the plane to the eye and beyond.",
            "blank, or the scene behind the camera, upside down"),
    MISTAKE("P-back-f", pixel_ray, forward_backwards, "v with -f",
            "f points ahead, to the plane. This looks backwards from the eye.",
            "blank, or the scene behind the camera, mirrored"),
    MISTAKE("P-mirror", pixel_ray, mirrored, "1 - s instead of s",
            "s and the columns both grow to the right, from the same edge.",
            "mirrored: left and right swapped"),
    MISTAKE("P-upside", pixel_ray, turned_over_twice, "1 - s instead of s, 1 - t instead of t",
            "x and s both go to the right, and t goes up. Here both have the wrong direction.",
            "turned by 180 degrees"),
    MISTAKE("P-swap", pixel_ray, s_and_t_swapped, "s and t swapped",
            "s goes across and t goes up. Here they are swapped.",
            "mirrored in the other diagonal: rows become columns"),
    MISTAKE("P-wide", pixel_ray, from_minus_1_to_1, "2 s - 1, 2 t - 1 instead of s, t",
            "the whole plane is 0..1. From -1 to 1 is two planes wide.",
            "shifted, and everything at half its size"),
    MISTAKE("P-corner", pixel_ray, counted_from_the_corner, "d f + s w r + t h u",
            "this starts from the middle of the plane. s and t start at its lower left corner.",
            "the middle of the view in the lower left corner"),
    MISTAKE("P-over", pixel_ray, up_from_the_top, "upper left + s w r + t h u",
            "from the upper left corner the pixel is down, but t goes up.",
            "shifted upward by a whole picture"),
    MISTAKE("P-distance", pixel_ray, distance_taken_as_1, "f instead of d f",
            "f has length 1, and the plane is not at distance 1: the step ahead is d f.",
            "right if d = 1; if not, a narrower or wider view"),
    MISTAKE("P-flat", pixel_ray, nothing_ahead, "v without d f",
            "the step d f is missing. The ray goes only sideways and never reaches the plane.",
            "blank: the rays go off sideways"),
    MISTAKE("P-unit", pixel_ray, plane_of_size_1, "w = h = 1",
            "the length of a share depends on the size of the plane.",
            "right if w = h = 1; if not, a narrower or wider view"),
    MISTAKE("P-narrow", pixel_ray, half_a_plane, "w/2 instead of w, h/2 instead of h",
            "halved twice. The rays of the outermost pixels go only half way to the edges.",
            "everything at twice its size"),
    MISTAKE("P-double", pixel_ray, two_planes, "2 w instead of w, 2 h instead of h",
            "the rays of the outermost pixels go twice as far to the side as the edges are.",
            "everything at half its size"),
    MISTAKE("P-aspect", pixel_ray, width_of_the_screens_shape, "w = h W/H",
            "the camera gives the width of its plane, whatever the shape of the screen.",
            "right if both have the same shape; if not, another width"),
    MISTAKE("P-aspect-h", pixel_ray, height_of_the_screens_shape, "h = w H/W",
            "the camera gives the height of its plane, whatever the shape of the screen.",
            "right if both have the same shape; if not, another height"),
    MISTAKE("P-hand", pixel_ray, always_right_handed, "r = f x u",
            "use the camera's own r: the world may have either handedness.",
            "right in a right-handed world; mirrored in a left-handed one"),
    MISTAKE("P-hand-left", pixel_ray, always_left_handed, "r = u x f",
            "use the camera's own r: the world may have either handedness.",
            "right in a left-handed world, as the deck's; mirrored in a right-handed one"),
    MISTAKE("P-axes", pixel_ray, axes_of_the_world, "x, y, z instead of r, u, f",
            "these are the axes of the world. The camera has its own axes.",
            "right for the deck's camera; turning the camera changes nothing"),
    {0},
};

static const Mistake *const mistakes[] = {pixel_mistakes, camera_mistakes, pixel_axis_mistakes,
                                          NULL};
OF_STEM(mistakes)
