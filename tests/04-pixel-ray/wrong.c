// wrong.c - wrong answers to exercise 04.
#include "exercises/01-corners.h"
#include "exercises/03-screen.h"
#include "exercises/04-pixel-ray.h"

#include "tests/judge/known.h"

// The right s and t.
static Normalized place_of(Resolution screen, Pixel pixel)
{
    return screen_to_normalized(pixel_center(pixel), screen);
}

// The right vector from the eye to the image plane.
static vec3 vector_to(Camera camera, Resolution screen, Pixel pixel)
{
    Normalized place = place_of(screen, pixel);
    return image_plane_vector(camera, place.s, place.t);
}

static vec3 rounded_to_float(vec3 v)
{
    return vec3_of((float)v[0], (float)v[1], (float)v[2]);
}

// Through another place of the plane; in the letters of the lesson, with (x, y) the pixel's center.
#define PLACE(id, formula, why, picture, across, upward)                                           \
    WRONG(pixel_ray, id, formula, why, picture)                                                    \
    {                                                                                              \
        LETTER(int, column) = pixel.column;                                                        \
        LETTER(int, row) = pixel.row;                                                              \
        LETTER(int, W) = screen.width;                                                             \
        LETTER(int, H) = screen.height;                                                            \
        LETTER(double, x) = pixel_center(pixel).x;                                                 \
        LETTER(double, y) = pixel_center(pixel).y;                                                 \
        LETTER(double, s) = place_of(screen, pixel).s;                                             \
        LETTER(double, t) = place_of(screen, pixel).t;                                             \
        return (Ray){camera.origin, image_plane_vector(camera, across, upward)};                   \
    }
// Through another point of the screen.
#define POINT(id, formula, why, picture, right, down)                                              \
    PLACE(id, formula, why, picture, (double)(right) / W, 1 - (double)(down) / H)
// Of the eye p and the vector v to the image plane.
#define RAY(id, formula, why, picture, from, direction)                                            \
    WRONG(pixel_ray, id, formula, why, picture)                                                    \
    {                                                                                              \
        LETTER(vec3, p) = camera.origin;                                                           \
        LETTER(vec3, v) = vector_to(camera, screen, pixel);                                        \
        return (Ray){from, direction};                                                             \
    }
// The right ray of another camera.
#define OF_CAMERA(id, formula, why, picture, ...)                                                  \
    WRONG(pixel_ray, id, formula, why, picture)                                                    \
    {                                                                                              \
        __VA_ARGS__;                                                                               \
        return (Ray){camera.origin, vector_to(camera, screen, pixel)};                             \
    }

// ---- the mistake is on the screen, between pixel and point --------------------------------------

POINT("P1", "through (column, row)",
      "this is the pixel's corner, which it shares with three other pixels. The ray must go "
      "through the pixel's center.",
      "half a pixel off", column, row)
POINT("P2", "through (column + 1, row + 1)",
      "half a pixel is added twice, which leads to the opposite corner. One of your functions adds "
      "it already.",
      "half a pixel off the other way", column + 1, row + 1)
POINT("P-back", "through (column - 1/2, row - 1/2)",
      "a pixel extends right and down from its corner. This is the center of another pixel.",
      "a whole pixel off, to the left and upward", column - 0.5, row - 0.5)
POINT("P-up", "through (column + 1/2, row - 1/2)",
      "rows are counted downward. This is the center of the pixel above.", "a pixel too high", x,
      row - 0.5)
POINT("P-column", "through (column + 1/2, row)",
      "this is the middle of the pixel's upper edge. A row also has a height: add half of it.",
      "half a pixel off, upward", x, row)
POINT("P-row", "through (column, row + 1/2)",
      "this is the middle of the pixel's left side. A column also has a width: add half of it.",
      "half a pixel off, to the left", column, y)
POINT("P-last", "through (column, row + 1)",
      "t = (H - 1 - row)/H gives this: the pixel's lower left corner and not its center.",
      "half a pixel off, to the left and downward", column, row + 1)
POINT("P4", "row across, column down",
      "columns are counted across and rows down. Here they are swapped.",
      "mirrored in the diagonal: rows become columns", y, x)
PLACE("P-sizes", "x/H and y/W", "the screen is W wide and H high; x runs across and y down.",
      "right on a square screen; if not square, squashed and cut off", x / H, 1 - y / W)
PLACE("P-width", "x/W and y/W",
      "W is used for both. From the top of the screen to the bottom it is H pixels.",
      "right on a square screen; if not square, out of shape and shifted", x / W, 1 - y / W)
PLACE("P-height", "x/H and y/H",
      "H is used for both. From the left of the screen to the right it is W pixels.",
      "right on a square screen; if not square, out of shape and shifted", x / H, 1 - y / H)
PLACE("P-larger", "the larger of W and H for both",
      "x is a fraction of W and y a fraction of H, whichever is larger.",
      "right on a square screen; if not square, out of shape and shifted", x / fmax(W, H),
      1 - y / fmax(W, H))
PLACE("P-smaller", "the smaller of W and H for both",
      "x is a fraction of W and y a fraction of H, whichever is larger.",
      "right on a square screen; if not square, out of shape and shifted", x / fmin(W, H),
      1 - y / fmin(W, H))
PLACE("P-less", "column/(W - 1) and row/(H - 1)",
      "this puts the outermost centers onto the edges of the plane. They lie half a pixel inside.",
      "everything slightly too small; on a single pixel, nothing", column / (W - 1.0),
      1 - row / (H - 1.0))
PLACE("P-less-x", "column/(W - 1)",
      "this puts the outermost centers onto the left and right edges of the plane. They lie half a "
      "pixel inside.",
      "everything slightly too narrow; in a single column, nothing", column / (W - 1.0), t)
PLACE("P-less-y", "row/(H - 1)",
      "this puts the outermost centers onto the top and bottom edges of the plane. They lie half a "
      "pixel inside.",
      "everything slightly too low; in a single row, nothing", s, 1 - row / (H - 1.0))
PLACE("P-less-half", "x/(W - 1) and y/(H - 1)",
      "four pixels have five edges, and from the first edge to the last it is four pixels, not "
      "three.",
      "everything slightly too small; on a single pixel, nothing", x / (W - 1), 1 - y / (H - 1))
PLACE("P-pixels", "x and y for s and t",
      "these are pixels; the camera needs fractions of the screen, counted from the lower left.",
      "one flat color: after the first pixel the rays leave the view", x, y)
PLACE("P-raw", "s = column, t = row",
      "these count pixels; the camera needs fractions of the screen, counted from the lower left.",
      "one flat color: after the first pixel the rays leave the view", column, row)
PLACE("P-whole", "column/W and row/H in integers",
      "in C, 300 / 640 is an integer division: its result is 0, so every ray goes to the same "
      "corner.",
      "one flat color", column / W, 1 - row / H)
PLACE("P-whole-x", "column/W in integers",
      "in C, 300 / 640 is an integer division: its result is 0, so the rays of all columns go to "
      "the left edge.",
      "stripes from left to right: all columns are alike", column / W, t)
PLACE("P-whole-y", "row/H in integers",
      "in C, 400 / 480 is an integer division: its result is 0, so the rays of all rows go to the "
      "top edge.",
      "stripes from top to bottom: all rows are alike", s, 1 - row / H)
PLACE("P-whole-down", "s = column/W, t = row/H in integers",
      "in C, 300 / 640 is an integer division: its result is 0, so every ray goes to the same "
      "corner. And rows are counted downward, t upward.",
      "one flat color", column / W, row / H)
PLACE("P-whole-turned", "s = column/W, t = (H - row)/H in integers",
      "in C, 300 / 640 is an integer division: its result is 0, so all rays except those of row 0 "
      "go to the same corner.",
      "one flat color, another in the first row", column / W, (H - row) / H)
PLACE("P-down", "t = y/H",
      "rows are counted downward and t upward. This is the fraction of the way down.",
      "upside down", x / W, y / H)
PLACE("P-down-corner", "s = column/W, t = row/H",
      "rows are counted downward and t upward; and this is the pixel's corner, not its center.",
      "upside down, and half a pixel off", (double)column / W, (double)row / H)
PLACE("P-thin", "straight ahead if W or H is 1",
      "a single column still has as many rows as the screen is high, and each has its own place. "
      "No screen needs a special case.",
      "no visible difference, except in pictures of one column or row", W == 1 || H == 1 ? 0.5 : s,
      W == 1 || H == 1 ? 0.5 : t)

// ---- the mistake is in the camera, between (s, t) and the ray -----------------------------------

RAY("P7", "origin (0, 0, 0)",
    "every ray starts at the camera's eye and not at the origin of the world.",
    "moving the camera does nothing", vec3_of(0, 0, 0), v)
RAY("P-plane", "origin p + v",
    "the ray starts at the eye, not on the plane. Objects nearer than the plane are in front of "
    "the eye as well.",
    "near objects vanish", p + v, v)
RAY("P-parallel", "origin p + v, direction f",
    "all rays are parallel. They must spread out from the eye.",
    "objects look equally large at any distance", p + v, camera.forward)
RAY("P-order", "origin v, direction p",
    "the ray starts at the eye, and v is its direction. Here they are swapped.",
    "nothing recognisable", v, p)
RAY("P8", "direction p + v",
    "this is the point on the plane. The direction is the vector from the eye to it, without p.",
    "right if the eye is at the origin; if not, the view is off to one side", p, p + v)
RAY("P8-minus", "direction v - p", "v starts at the eye already, so do not subtract the eye again.",
    "right if the eye is at the origin; if not, the view is off to one side", p, v - p)
RAY("P-behind", "direction -v", "this is the vector back, from the plane to the eye and beyond.",
    "blank, or the scene behind the camera, upside down", p, -v)
RAY("P-flat", "v without d f",
    "the step d f is missing. The ray goes only sideways and never reaches the plane.",
    "blank: the rays go off sideways", p, v - camera.distance * camera.forward)
RAY("P-float", "in float", "a float has 7 digits, and the ray needs 9. Use double.",
    "no visible difference, or ragged edges", rounded_to_float(p), rounded_to_float(v))
PLACE("P-mirror", "1 - s instead of s",
      "s and the columns both grow to the right, from the same edge.",
      "mirrored: left and right swapped", 1 - s, t)
PLACE("P-upside", "1 - s instead of s, 1 - t instead of t",
      "x and s both go to the right, and t goes up. Here both have the wrong direction.",
      "turned by 180 degrees", 1 - s, 1 - t)
PLACE("P-swap", "s and t swapped", "s goes across and t goes up. Here they are swapped.",
      "mirrored in the other diagonal: rows become columns", t, s)
PLACE("P-wide", "2 s - 1, 2 t - 1 instead of s, t",
      "the whole plane is 0..1. From -1 to 1 is two planes wide.",
      "shifted, and everything at half its size", 2 * s - 1, 2 * t - 1)
PLACE("P-wide-x", "s from -1 to 1",
      "s goes from -1 to 1, and t from 0 to 1. Both must go from 0 to 1.",
      "everything at half its width, and shifted", 2 * s - 1, t)
PLACE("P-wide-y", "t from -1 to 1",
      "t goes from -1 to 1, and s from 0 to 1. Both must go from 0 to 1.",
      "everything at half its height, and shifted", s, 2 * t - 1)
PLACE("P-corner", "d f + s w r + t h u",
      "this starts from the middle of the plane. s and t start at its lower left corner.",
      "the middle of the view in the lower left corner", s + 0.5, t + 0.5)
PLACE("P-over", "upper left + s w r + t h u",
      "from the upper left corner the pixel is down, but t goes up.",
      "shifted upward by a whole picture", s, t + 1)
OF_CAMERA("P-back-f", "v with -f",
          "f points ahead, to the plane. This looks backwards from the eye.",
          "blank, or the scene behind the camera, mirrored", camera.forward = -camera.forward)
OF_CAMERA("P-distance", "f instead of d f",
          "f has length 1, and the plane is not at distance 1: the step ahead is d f.",
          "right if d = 1; if not, a narrower or wider view", camera.distance = 1)
OF_CAMERA("P-unit", "w = h = 1", "the length of a fraction depends on the size of the plane.",
          "right if w = h = 1; if not, a narrower or wider view", camera.width = camera.height = 1)
OF_CAMERA("P-narrow", "w/2 instead of w, h/2 instead of h",
          "halved twice. The rays of the outermost pixels go only half way to the edges.",
          "everything at twice its size", camera.width /= 2, camera.height /= 2)
OF_CAMERA("P-double", "2 w instead of w, 2 h instead of h",
          "the rays of the outermost pixels go twice as far to the side as the edges are.",
          "everything at half its size", camera.width *= 2, camera.height *= 2)
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
          camera.right = vec3_of(1, 0, 0), camera.up = vec3_of(0, 1, 0),
          camera.forward = vec3_of(0, 0, 1))

// ---- without a name ----------------------------------------------------------------------------

// The length of a direction is free: the mistake is the same.
UNNAMED(pixel_ray, "P7", "no eye, and a unit direction")
{
    Ray ray = pixel_ray(camera, screen, pixel);
    return (Ray){vec3_of(0, 0, 0), vec3_unit(ray.direction)};
}

UNNAMED_LINE(pixel_ray, NOBODY, "straight ahead", return (Ray){camera.origin, 3 * camera.forward})
