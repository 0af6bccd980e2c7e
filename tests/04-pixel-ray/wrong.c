// wrong.c - wrong answers to exercise 04.
#include "exercises/01-corners.h"
#include "exercises/03-screen.h"
#include "exercises/04-pixel-ray.h"

#include "tests/judge/known.h"

// ---- wrong rays of a pixel: the mistake is on the screen, between pixel and point ---------------

// The right way on, from a point of the screen.
static vec3 towards(Camera camera, Resolution screen, ScreenPoint point)
{
    Normalized place = screen_to_normalized(point, screen);
    return image_plane_vector(camera, place.s, place.t);
}

// A ray through another point of the screen.
#define THROUGH(id, formula, why, picture, ...)                                                    \
    WRONG(pixel_ray, id, formula, why, picture)                                                    \
    {                                                                                              \
        __VA_ARGS__;                                                                               \
        return (Ray){camera.origin, towards(camera, screen, point)};                               \
    }

THROUGH("P1", "through (column, row)",
        "this is the pixel's corner, which it shares with three other pixels. The ray must go "
        "through the pixel's centre.",
        "half a pixel off", ScreenPoint point = {pixel.column, pixel.row})
THROUGH(
    "P2", "through (column + 1, row + 1)",
    "half a pixel is added twice, which leads to the opposite corner. One of your functions adds "
    "it already.",
    "half a pixel off the other way", ScreenPoint point = {pixel.column + 1, pixel.row + 1})
THROUGH("P-back", "through (column - 1/2, row - 1/2)",
        "a pixel extends right and down from its corner. This is the centre of another pixel.",
        "a whole pixel off, to the left and upward",
        ScreenPoint point = {pixel.column - 0.5, pixel.row - 0.5})
THROUGH("P-up", "through (column + 1/2, row - 1/2)",
        "rows are counted downward. This is the centre of the pixel above.", "a pixel too high",
        ScreenPoint point = {pixel.column + 0.5, pixel.row - 0.5})
THROUGH("P-column", "through (column + 1/2, row)",
        "this is the middle of the pixel's upper edge. A row also has a height: add half of it.",
        "half a pixel off, upward", ScreenPoint point = {pixel.column + 0.5, pixel.row})
THROUGH("P-row", "through (column, row + 1/2)",
        "this is the middle of the pixel's left side. A column also has a width: add half of it.",
        "half a pixel off, to the left", ScreenPoint point = {pixel.column, pixel.row + 0.5})
THROUGH("P-last", "through (column, row + 1)",
        "t = (H - 1 - row)/H gives this: the pixel's lower left corner and not its centre.",
        "half a pixel off, to the left and downward",
        ScreenPoint point = {pixel.column, pixel.row + 1})
THROUGH("P4", "row across, column down",
        "columns are counted across and rows down. Here they are swapped.",
        "mirrored in the diagonal: rows become columns",
        ScreenPoint point = {pixel.row + 0.5, pixel.column + 0.5})

WRONG(pixel_ray, "P-sizes", "x/H and y/W",
      "the screen is W wide and H high; x runs across and y down.",
      "right on a square screen; if not square, squashed and cut off")
{
    Resolution swapped = {screen.height, screen.width};
    return (Ray){camera.origin, towards(camera, swapped, pixel_center(pixel))};
}

WRONG(pixel_ray, "P-width", "x/W and y/W",
      "W is used for both. From the top of the screen to the bottom it is H pixels.",
      "right on a square screen; if not square, out of shape and shifted")
{
    Resolution square = {screen.width, screen.width};
    return (Ray){camera.origin, towards(camera, square, pixel_center(pixel))};
}

WRONG(pixel_ray, "P-height", "x/H and y/H",
      "H is used for both. From the left of the screen to the right it is W pixels.",
      "right on a square screen; if not square, out of shape and shifted")
{
    Resolution square = {screen.height, screen.height};
    return (Ray){camera.origin, towards(camera, square, pixel_center(pixel))};
}

// Through another place on the plane.
#define AT_PLACE(id, formula, why, picture, ...)                                                   \
    WRONG(pixel_ray, id, formula, why, picture)                                                    \
    {                                                                                              \
        __VA_ARGS__;                                                                               \
        return (Ray){camera.origin, image_plane_vector(camera, s, t)};                             \
    }

AT_PLACE(
    "P-less", "column/(W - 1) and row/(H - 1)",
    "this puts the outermost centres onto the edges of the plane. They lie half a pixel inside.",
    "everything slightly too small; on a single pixel, nothing",
    double s = (double)pixel.column / (screen.width - 1);
    double t = 1 - (double)pixel.row / (screen.height - 1))

WRONG(pixel_ray, "P-less-half", "x/(W - 1) and y/(H - 1)",
      "four pixels have five edges, and from the first edge to the last it is four pixels, not "
      "three.",
      "everything slightly too small; on a single pixel, nothing")
{
    ScreenPoint point = pixel_center(pixel);
    return (Ray){camera.origin, image_plane_vector(camera, point.x / (screen.width - 1),
                                                   1 - point.y / (screen.height - 1))};
}

WRONG(pixel_ray, "P-pixels", "x and y for s and t",
      "these are pixels; the camera needs shares of the screen, counted from the lower left.",
      "one flat colour: after the first pixel the rays leave the view")
{
    ScreenPoint point = pixel_center(pixel);
    return (Ray){camera.origin, image_plane_vector(camera, point.x, point.y)};
}

WRONG_LINE(
    pixel_ray, "P-raw", "s = column, t = row",
    "these count pixels; the camera needs shares of the screen, counted from the lower left.",
    "one flat colour: after the first pixel the rays leave the view",
    return (Ray){camera.origin, image_plane_vector(camera, pixel.column, pixel.row)})

AT_PLACE("P-whole", "column/W and row/H in integers",
         "in C, 300 / 640 is an integer division: its result is 0, so every ray goes to the same "
         "corner.",
         "one flat colour", int s = pixel.column / screen.width, t = 1 - pixel.row / screen.height)
AT_PLACE("P-whole-down", "s = column/W, t = row/H in integers",
         "in C, 300 / 640 is an integer division: its result is 0, so every ray goes to the same "
         "corner. And rows are counted downward, t upward.",
         "one flat colour", int s = pixel.column / screen.width, t = pixel.row / screen.height)
AT_PLACE(
    "P-whole-turned", "s = column/W, t = (H - row)/H in integers",
    "in C, 300 / 640 is an integer division: its result is 0, so all rays except those of row 0 "
    "go to the same corner.",
    "one flat colour, another in the first row", int s = pixel.column / screen.width,
    t = (screen.height - pixel.row) / screen.height)

WRONG(pixel_ray, "P-down", "t = y/H",
      "rows are counted downward and t upward. This is the share of the way down.", "upside down")
{
    ScreenPoint point = pixel_center(pixel);
    return (Ray){camera.origin,
                 image_plane_vector(camera, point.x / screen.width, point.y / screen.height)};
}

AT_PLACE("P-down-corner", "s = column/W, t = row/H",
         "rows are counted downward and t upward; and this is the pixel's corner, not its centre.",
         "upside down, and half a pixel off", double s = (double)pixel.column / screen.width;
         double t = (double)pixel.row / screen.height)

// Wrong answers to exercise 04: the mistake is in the camera, between (s, t) and the ray.

// The right way as far as s and t.
static Normalized place_of(Resolution screen, Pixel pixel)
{
    return screen_to_normalized(pixel_center(pixel), screen);
}

// The right way to the image plane.
static vec3 to_the_middle(Camera camera, Resolution screen, Pixel pixel)
{
    Normalized place = place_of(screen, pixel);
    return image_plane_vector(camera, place.s, place.t);
}

WRONG_LINE(pixel_ray, "P7", "origin (0, 0, 0)",
           "every ray starts at the camera's eye and not at the origin of the world.",
           "moving the camera does nothing",
           return (Ray){vec3_of(0, 0, 0), to_the_middle(camera, screen, pixel)})

WRONG(pixel_ray, "P-plane", "origin p + v",
      "the ray starts at the eye, not on the plane. Objects nearer than the plane are in front of "
      "the eye as well.",
      "near objects vanish")
{
    vec3 direction = to_the_middle(camera, screen, pixel);
    return (Ray){camera.origin + direction, direction};
}

WRONG_LINE(pixel_ray, "P-parallel", "origin p + v, direction f",
           "all rays are parallel. They must spread out from the eye.",
           "objects look equally large at any distance",
           return (Ray){camera.origin + to_the_middle(camera, screen, pixel), camera.forward})
WRONG_LINE(pixel_ray, "P-order", "origin v, direction p",
           "the ray starts at the eye, and v is its direction. Here they are swapped.",
           "nothing recognisable",
           return (Ray){to_the_middle(camera, screen, pixel), camera.origin})
WRONG_LINE(
    pixel_ray, "P8", "direction p + v",
    "this is the point on the plane. The direction is the vector from the eye to it, without p.",
    "right if the eye is at the origin; if not, the view is off to one side",
    return (Ray){camera.origin, camera.origin + to_the_middle(camera, screen, pixel)})
WRONG_LINE(pixel_ray, "P8-minus", "direction v - p",
           "v starts at the eye already, so do not subtract the eye again.",
           "right if the eye is at the origin; if not, the view is off to one side",
           return (Ray){camera.origin, to_the_middle(camera, screen, pixel) - camera.origin})
WRONG_LINE(pixel_ray, "P-behind", "direction -v",
           "this is the vector back, from the plane to the eye and beyond.",
           "blank, or the scene behind the camera, upside down",
           return (Ray){camera.origin, -to_the_middle(camera, screen, pixel)})

// The right ray of another camera, screen or pixel.
#define OF_CAMERA(id, formula, why, picture, ...)                                                  \
    WRONG(pixel_ray, id, formula, why, picture)                                                    \
    {                                                                                              \
        __VA_ARGS__;                                                                               \
        return (Ray){camera.origin, to_the_middle(camera, screen, pixel)};                         \
    }

OF_CAMERA("P-back-f", "v with -f",
          "f points ahead, to the plane. This looks backwards from the eye.",
          "blank, or the scene behind the camera, mirrored", camera.forward = -camera.forward)

// From the right place on the plane.
#define FROM_PLACE(id, formula, why, picture, ...)                                                 \
    WRONG(pixel_ray, id, formula, why, picture)                                                    \
    {                                                                                              \
        Normalized place = place_of(screen, pixel);                                                \
        __VA_ARGS__;                                                                               \
    }

FROM_PLACE("P-mirror", "1 - s instead of s",
           "s and the columns both grow to the right, from the same edge.",
           "mirrored: left and right swapped",
           return (Ray){camera.origin, image_plane_vector(camera, 1 - place.s, place.t)})
FROM_PLACE("P-upside", "1 - s instead of s, 1 - t instead of t",
           "x and s both go to the right, and t goes up. Here both have the wrong direction.",
           "turned by 180 degrees",
           return (Ray){camera.origin, image_plane_vector(camera, 1 - place.s, 1 - place.t)})
FROM_PLACE("P-swap", "s and t swapped", "s goes across and t goes up. Here they are swapped.",
           "mirrored in the other diagonal: rows become columns",
           return (Ray){camera.origin, image_plane_vector(camera, place.t, place.s)})
FROM_PLACE("P-wide", "2 s - 1, 2 t - 1 instead of s, t",
           "the whole plane is 0..1. From -1 to 1 is two planes wide.",
           "shifted, and everything at half its size",
           return (Ray){camera.origin,
                        image_plane_vector(camera, 2 * place.s - 1, 2 * place.t - 1)})
FROM_PLACE("P-corner", "d f + s w r + t h u",
           "this starts from the middle of the plane. s and t start at its lower left corner.",
           "the middle of the view in the lower left corner",
           return (Ray){camera.origin, image_plane_vector(camera, place.s + 0.5, place.t + 0.5)})
FROM_PLACE("P-over", "upper left + s w r + t h u",
           "from the upper left corner the pixel is down, but t goes up.",
           "shifted upward by a whole picture",
           return (Ray){camera.origin, image_plane_vector(camera, place.s, place.t + 1)})

OF_CAMERA("P-distance", "f instead of d f",
          "f has length 1, and the plane is not at distance 1: the step ahead is d f.",
          "right if d = 1; if not, a narrower or wider view", camera.distance = 1)

WRONG_LINE(pixel_ray, "P-flat", "v without d f",
           "the step d f is missing. The ray goes only sideways and never reaches the plane.",
           "blank: the rays go off sideways",
           return (Ray){.origin = camera.origin,
                        .direction = to_the_middle(camera, screen, pixel) -
                                     camera.distance * camera.forward})

OF_CAMERA("P-unit", "w = h = 1", "the length of a share depends on the size of the plane.",
          "right if w = h = 1; if not, a narrower or wider view", camera.width = camera.height = 1)
OF_CAMERA("P-narrow", "w/2 instead of w, h/2 instead of h",
          "halved twice. The rays of the outermost pixels go only half way to the edges.",
          "everything at twice its size", camera.width /= 2;
          camera.height /= 2)
OF_CAMERA("P-double", "2 w instead of w, 2 h instead of h",
          "the rays of the outermost pixels go twice as far to the side as the edges are.",
          "everything at half its size", camera.width *= 2;
          camera.height *= 2)
OF_CAMERA("P-aspect", "w = h W/H",
          "the camera gives the width of its plane, whatever the shape of the screen.",
          "right if both have the same shape; if not, another width",
          camera.width = camera.height * screen.width / screen.height)
OF_CAMERA("P-aspect-h", "h = w H/W",
          "the camera gives the height of its plane, whatever the shape of the screen.",
          "right if both have the same shape; if not, another height",
          camera.height = camera.width * screen.height / screen.width)
OF_CAMERA("P-hand", "r = f x u", "use the camera's own r: the world may have either handedness.",
          "right in a right-handed world; mirrored in a left-handed one",
          camera.right = vec3_cross(camera.forward, camera.up))
OF_CAMERA("P-hand-left", "r = u x f",
          "use the camera's own r: the world may have either handedness.",
          "right in a left-handed world, as the deck's; mirrored in a right-handed one",
          camera.right = vec3_cross(camera.up, camera.forward))
OF_CAMERA("P-axes", "x, y, z instead of r, u, f",
          "these are the axes of the world. The camera has its own axes.",
          "right for the deck's camera; turning the camera changes nothing",
          camera.right = vec3_of(1, 0, 0);
          camera.up = vec3_of(0, 1, 0); camera.forward = vec3_of(0, 0, 1))

// Wrong rays of a pixel: slips on one axis only, on screens of one shape only, and rays in fewer
// digits.

static Ray through(Camera camera, double s, double t)
{
    return (Ray){camera.origin, image_plane_vector(camera, s, t)};
}

WRONG(pixel_ray, "P-less-x", "column/(W - 1)",
      "this puts the outermost centres onto the left and right edges of the plane. They lie half a "
      "pixel inside.",
      "everything slightly too narrow; in a single column, nothing")
{
    double s = (double)pixel.column / (screen.width - 1);
    return through(camera, s, 1 - (pixel.row + 0.5) / screen.height);
}

WRONG(pixel_ray, "P-less-y", "row/(H - 1)",
      "this puts the outermost centres onto the top and bottom edges of the plane. They lie half a "
      "pixel inside.",
      "everything slightly too low; in a single row, nothing")
{
    double t = 1 - (double)pixel.row / (screen.height - 1);
    return through(camera, (pixel.column + 0.5) / screen.width, t);
}

WRONG(pixel_ray, "P-wide-x", "s from -1 to 1",
      "s goes from -1 to 1, and t from 0 to 1. Both must go from 0 to 1.",
      "everything at half its width, and shifted")
{
    Normalized place = screen_to_normalized(pixel_center(pixel), screen);
    return through(camera, 2 * place.s - 1, place.t);
}

WRONG(pixel_ray, "P-wide-y", "t from -1 to 1",
      "t goes from -1 to 1, and s from 0 to 1. Both must go from 0 to 1.",
      "everything at half its height, and shifted")
{
    Normalized place = screen_to_normalized(pixel_center(pixel), screen);
    return through(camera, place.s, 2 * place.t - 1);
}

WRONG(pixel_ray, "P-whole-x", "column/W in integers",
      "in C, 300 / 640 is an integer division: its result is 0, so the rays of all columns go to "
      "the left edge.",
      "stripes from left to right: all columns are alike")
{
    int s = pixel.column / screen.width;
    return through(camera, s, 1 - (pixel.row + 0.5) / screen.height);
}

WRONG(pixel_ray, "P-whole-y", "row/H in integers",
      "in C, 400 / 480 is an integer division: its result is 0, so the rays of all rows go to the "
      "top edge.",
      "stripes from top to bottom: all rows are alike")
{
    int t = 1 - pixel.row / screen.height;
    return through(camera, (pixel.column + 0.5) / screen.width, t);
}

WRONG(pixel_ray, "P-thin", "straight ahead if W or H is 1",
      "a single column still has as many rows as the screen is high, and each has its own place. "
      "No screen needs a special case.",
      "no visible difference, except in pictures of one column or row")
{
    bool thin = screen.width == 1 || screen.height == 1;
    return thin ? through(camera, 0.5, 0.5) : pixel_ray(camera, screen, pixel);
}

WRONG(pixel_ray, "P-larger", "the larger of W and H for both",
      "x is a share of W and y a share of H, whichever is larger.",
      "right on a square screen; if not square, out of shape and shifted")
{
    int side = screen.width > screen.height ? screen.width : screen.height;
    return pixel_ray(camera, (Resolution){side, side}, pixel);
}

WRONG(pixel_ray, "P-smaller", "the smaller of W and H for both",
      "x is a share of W and y a share of H, whichever is larger.",
      "right on a square screen; if not square, out of shape and shifted")
{
    int side = screen.width < screen.height ? screen.width : screen.height;
    return pixel_ray(camera, (Resolution){side, side}, pixel);
}

WRONG(pixel_ray, "P-float", "in float", "a float has 7 digits, and the ray needs 9. Use double.",
      "no visible difference, or ragged edges")
{
    Ray ray = pixel_ray(camera, screen, pixel);
    for (int i = 0; i < 3; i++) {
        ray.origin[i] = (float)ray.origin[i];
        ray.direction[i] = (float)ray.direction[i];
    }
    return ray;
}
