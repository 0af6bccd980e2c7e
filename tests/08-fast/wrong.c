// wrong.c - wrong answers to exercise 08.
#include "exercises/03-screen.h"
#include "exercises/08-fast.h"

#include "tests/judge/known.h"

#include <math.h>

// ---- the right way, with places to go wrong -----------------------------------------------------

// Places on a plane at distance 1: to the right, and up.
typedef struct {
    double left, right, low, high;
} Outline;

typedef struct {
    double right, up, ahead, r;
} View;

static View view_of(Camera camera, Sphere sphere)
{
    vec3 c = sphere.center - camera.origin;
    return (View){vec3_dot(c, camera.right), vec3_dot(c, camera.up), vec3_dot(c, camera.forward),
                  sphere.radius};
}

// One end of the outline along an axis: side is -1 or 1, and g is z^2 - r^2.
static double tangent(double z, double x, double r, double g, double side)
{
    return (z * x + side * r * sqrt(fmax(x * x + g, 0))) / g;
}

static Outline outline_of(View v)
{
    double z = v.ahead, r = v.r, g = z * z - r * r;
    return (Outline){tangent(z, v.right, r, g, -1), tangent(z, v.right, r, g, 1),
                     tangent(z, v.up, r, g, -1), tangent(z, v.up, r, g, 1)};
}

static const ScreenRectangle nothing = {0, 0, 0, 0};

static ScreenRectangle whole(Resolution screen)
{
    return (ScreenRectangle){0, screen.width, 0, screen.height};
}

// On the screen, not cut off.
static ScreenRectangle on_screen(Camera c, Resolution screen, Outline o)
{
    double x = screen.width * c.distance / c.width, y = screen.height * c.distance / c.height;
    return (ScreenRectangle){screen.width / 2.0 + x * o.left, screen.width / 2.0 + x * o.right,
                             screen.height / 2.0 - y * o.high, screen.height / 2.0 - y * o.low};
}

static double limited(double x, double most)
{
    return x < 0 ? 0 : x > most ? most : x;
}

static ScreenRectangle cut_off(ScreenRectangle s, Resolution screen)
{
    if (s.right <= 0 || s.left >= screen.width || s.bottom <= 0 || s.top >= screen.height)
        return nothing;
    return (ScreenRectangle){limited(s.left, screen.width), limited(s.right, screen.width),
                             limited(s.top, screen.height), limited(s.bottom, screen.height)};
}

static ScreenRectangle not_cut_off(Camera c, Resolution screen, View v, Outline o)
{
    if (v.ahead <= -v.r)
        return nothing;
    return v.ahead <= v.r ? whole(screen) : on_screen(c, screen, o);
}

static ScreenRectangle moved(ScreenRectangle s, double x, double y)
{
    return (ScreenRectangle){s.left + x, s.right + x, s.top + y, s.bottom + y};
}

// All of it with another view.
static ScreenRectangle with_view(Camera c, Resolution screen, View v)
{
    return cut_off(not_cut_off(c, screen, v, outline_of(v)), screen);
}

static ScreenRectangle right_of(Camera c, Resolution screen, Sphere sphere)
{
    return with_view(c, screen, view_of(c, sphere));
}

// ---- the tangents -------------------------------------------------------------------------------

// One end of the outline along an axis, where the sphere is z ahead, x aside and away from the eye;
// m is the right one.
#define TANGENT(id, formula, why, picture, ...)                                                    \
    WRONG(sphere_rectangle, id, formula, why, picture)                                             \
    {                                                                                              \
        View v = view_of(camera, sphere);                                                          \
        double z = v.ahead, r = v.r, g = z * z - r * r, ends[4];                                   \
        double away = sqrt(v.right * v.right + v.up * v.up + z * z);                               \
        (void)away;                                                                                \
        for (int i = 0; i < 4; i++) {                                                              \
            double x = i < 2 ? v.right : v.up, side = i % 2 == 0 ? -1 : 1;                         \
            double m = tangent(z, x, r, g, side);                                                  \
            (void)m;                                                                               \
            ends[i] = __VA_ARGS__;                                                                 \
        }                                                                                          \
        Outline o = {ends[0], ends[1], ends[2], ends[3]};                                          \
        return cut_off(not_cut_off(camera, screen, v, o), screen);                                 \
    }

TANGENT("R-flat", "x/z - r/z, x/z + r/z",
        "the tangents touch the sphere nearer to the eye than its center is, so the outline is "
        "larger than a disc at the center.",
        "spheres whose edges are cut off, most of all near the eye", x / z + side * r / z)
TANGENT("R-box", "(x -+ r) / (z -+ r)",
        "this is the rectangle of a cube around the sphere. The sphere does not reach its corners.",
        "the right picture, but too many pixels are tested",
        side < 0 ? fmin((x - r) / (z - r), (x - r) / (z + r))
                 : fmax((x + r) / (z - r), (x + r) / (z + r)))
TANGENT("R-near", "(x -+ r) / (z - r)",
        "only one point of the sphere is as near as z - r, and it is not on the outline.",
        "large spheres are tested too often, and spheres at the side are cut off",
        (x + side * r) / (z - r))
TANGENT("R-middle", "x/z -+ r sqrt(x^2 + g) / g",
        "the middle between the two tangents is x z / g. The center of the sphere is at x / z.",
        "spheres at the side are cut off on their outer side",
        x / z + side * r * sqrt(x * x + g) / g)
TANGENT("R-root", "r sqrt(x^2 + z^2)",
        "under the root is x^2 + z^2 - r^2, the square of the length of the tangent.",
        "the right picture, but too many pixels are tested", (z * x + side * r * hypot(x, z)) / g)
TANGENT("R-plus", "g = z^2 + r^2", "g is z^2 - r^2.", "spheres whose edges are cut off",
        tangent(z, x, r, (z * z + r * r), side))
TANGENT("R-z2", "/ z^2 instead of / g",
        "the quadratic begins with g m^2, so its roots are divided by g = z^2 - r^2.",
        "spheres whose edges are cut off", (m * g / (z * z)))
TANGENT("R-divide", "x z -+ r sqrt(x^2 + g)",
        "the roots of the quadratic are divided by its first coefficient, g.",
        "nearly every sphere covers the whole screen", (m * g))
TANGENT("R-half", "/ (2 g)",
        "the 2 of 2 x z m and the 2 of the formula cancel. Divided by 2 g, everything is halved.",
        "only a part of each sphere, towards the middle of the picture", m / 2)
TANGENT("R-sign", "-x z -+ r sqrt(x^2 + g)",
        "the linear coefficient is -2 x z, and the formula for the roots negates it, so x z is "
        "positive.",
        "only spheres in the middle, because the rectangles are on the opposite side",
        -tangent(z, x, r, g, -side))
TANGENT("R-diameter", "2 r instead of r",
        "the radius is the distance from the center to the surface.",
        "the right picture, but four times as many pixels are tested",
        z > 2 * r ? tangent(z, x, 2 * r, (z * z - 4 * r * r), side) : side * INFINITY)
TANGENT("R-square", "g = z^2 - r", "the radius is squared: r^2.",
        "right if the radius is 1; if not, cut off or too large",
        tangent(z, x, r, (z * z - r), side))
// Angles in space, where each axis has an angle of its own.
TANGENT("R-space", "asin(r / |C|)",
        "in this direction only x and z count. |C| includes how far up the sphere is.",
        "spheres near the corners are cut off", tan(atan2(x, z) + side * asin(r / away)))
TANGENT("R-atan", "atan(r / sqrt(x^2 + z^2))",
        "eye, center and the point that the tangent touches are a triangle with the right angle at "
        "that point, so the ratio of r and the distance is a sine.",
        "spheres whose edges are cut off", tan(atan2(x, z) + side * atan(r / hypot(x, z))))
TANGENT("R-angles", "atan(m) instead of m",
        "places on the plane are proportional to the tangent of the angle, not to the angle.",
        "spheres near the edges of the picture are cut off", atan(m))

WRONG(sphere_rectangle, "R-world", "x, y, z of the world",
      "to the side, up and ahead are measured along the camera's right, up and forward.",
      "right until the camera turns")
{
    vec3 to = sphere.center - camera.origin;
    return with_view(camera, screen, (View){to[0], to[1], to[2], sphere.radius});
}

// The rectangle of another view.
#define WITH_VIEW(id, formula, why, picture, ...)                                                  \
    WRONG(sphere_rectangle, id, formula, why, picture)                                             \
    {                                                                                              \
        __VA_ARGS__;                                                                               \
        return with_view(camera, screen, view_of(camera, sphere));                                 \
    }

WITH_VIEW("R-eye", "C instead of C - p",
          "the eye is not at the origin of the world. Seen from the eye, the center is at C - p.",
          "rectangles beside their spheres, so parts of the spheres are missing",
          camera.origin = vec3_of(0, 0, 0))
WITH_VIEW("R-back", "p - C instead of C - p",
          "the vector from the eye to the center is C - p. This one has the opposite direction.",
          "nothing, because each sphere in front is now behind the eye",
          sphere.center = 2 * camera.origin - sphere.center)

// From the right view.
#define OF_VIEW(id, formula, why, picture, ...)                                                    \
    WRONG(sphere_rectangle, id, formula, why, picture)                                             \
    {                                                                                              \
        View v = view_of(camera, sphere);                                                          \
        __VA_ARGS__;                                                                               \
    }

OF_VIEW("R-plane", "z - d instead of z",
        "ahead is measured from the eye, not from the image plane.",
        "spheres near the plane cover the whole screen, and others are tested too often",
        v.ahead -= camera.distance;
        return with_view(camera, screen, v))

// From the right outline, before it is cut off.
#define OF_UNCUT(id, formula, why, picture, ...)                                                   \
    WRONG(sphere_rectangle, id, formula, why, picture)                                             \
    {                                                                                              \
        View v = view_of(camera, sphere);                                                          \
        if (v.ahead <= v.r)                                                                        \
            return right_of(camera, screen, sphere);                                               \
        ScreenRectangle s = on_screen(camera, screen, outline_of(v));                              \
        __VA_ARGS__;                                                                               \
        return cut_off(s, screen);                                                                 \
    }

OF_UNCUT("R-far", "|C| instead of z",
         "the distance ahead is measured along forward. |C| is the distance to the center.",
         "spheres at the side are cut off",
         v.ahead = sqrt(v.right * v.right + v.up * v.up + v.ahead * v.ahead);
         s = on_screen(camera, screen, outline_of(v)))
OF_UNCUT("R-corner", "x instead of W/2 + x",
         "the origin of the screen is its upper left corner, and m = 0 is its middle.",
         "the upper left quarter of what there should be",
         s = moved(s, -screen.width / 2.0, -screen.height / 2.0))
OF_UNCUT("R-pixel", "x - 0.5, y - 0.5",
         "screen points are continuous: the first pixel reaches from 0 to 1.",
         "the last column and row of a sphere are missing here and there", s = moved(s, -0.5, -0.5))

WITH_VIEW("R-distance", "m instead of d m",
          "m is the distance to the side for each 1 ahead, and the image plane is d ahead.",
          "right if d = 1; if not, each sphere is cut off", camera.distance = 1)
WITH_VIEW("R-narrow", "w/2 instead of w, h/2 instead of h",
          "the whole width of the plane is the whole width of the screen.",
          "rectangles of twice the size, moved away from the middle", camera.width /= 2;
          camera.height /= 2)
WITH_VIEW("R-width", "w instead of h", "up is measured in heights of the plane, not in widths.",
          "right for a square plane; for others, spheres are cut off at the top or at the bottom",
          camera.height = camera.width)
WITH_VIEW("R-aspect", "h = w H/W",
          "the camera gives the height of its plane. Pixels need not be square.",
          "right if they are square; if not, cut off or too large",
          camera.height = camera.width * screen.height / screen.width)
WITH_VIEW("R-upside", "H/2 + y instead of H/2 - y",
          "y of the screen counts down, and up counts up.",
          "only spheres at half the height, because the rectangles are upside down",
          camera.up = -camera.up)
WITH_VIEW("R-mirror", "W/2 - x instead of W/2 + x",
          "x of the screen and right of the camera both grow to the right.",
          "only spheres in the middle, because left and right are swapped",
          camera.right = -camera.right)

// From the right rectangle.
#define OF_RECTANGLE(id, formula, why, picture, ...)                                               \
    WRONG(sphere_rectangle, id, formula, why, picture)                                             \
    {                                                                                              \
        ScreenRectangle s = right_of(camera, screen, sphere);                                      \
        __VA_ARGS__;                                                                               \
    }

OF_RECTANGLE("R-order", "top > bottom",
             "the higher tangent is the top, and the top has the smaller y.",
             "nothing: the loop over the rows ends before it begins",
             return (ScreenRectangle){s.left, s.right, s.bottom, s.top})
OF_RECTANGLE("R-below", "H - y", "y starts at the top of the screen.",
             "nothing: the loop over the rows ends before it begins",
             return (ScreenRectangle){s.left, s.right, screen.height - s.top,
                                      screen.height - s.bottom})
OF_RECTANGLE("R-normal", "s, t instead of x, y",
             "these are fractions of the screen, from 0 to 1. Screen points are in pixels.",
             "one pixel in the upper left corner",
             return (ScreenRectangle){s.left / screen.width, s.right / screen.width,
                                      s.top / screen.height, s.bottom / screen.height})

OF_RECTANGLE("R-whole", "floor, ceil", "the rectangle is exact. Rounding to pixels comes after it.",
             "the right picture",
             return (ScreenRectangle){floor(s.left), ceil(s.right), floor(s.top), ceil(s.bottom)})
OF_RECTANGLE("R-floor", "(int)", "the rectangle is exact, so its parts are not whole numbers.",
             "the last column and row of each sphere are missing",
             return (ScreenRectangle){floor(s.left), floor(s.right), floor(s.top), floor(s.bottom)})

// From the right rectangle, not cut off.
#define OF_WHOLE_RECTANGLE(id, formula, why, picture, ...)                                         \
    WRONG(sphere_rectangle, id, formula, why, picture)                                             \
    {                                                                                              \
        View v = view_of(camera, sphere);                                                          \
        ScreenRectangle s = not_cut_off(camera, screen, v, outline_of(v));                         \
        double w = screen.width, h = screen.height;                                                \
        (void)w, (void)h;                                                                          \
        return __VA_ARGS__;                                                                        \
    }

OF_WHOLE_RECTANGLE(
    "R-cut", "not cut off",
    "outside of the screen there are no pixels, so the rectangle ends at the screen's edges.",
    "the program ends when it colors a pixel outside of the image", s)
OF_WHOLE_RECTANGLE("R-strip", "limits alone",
                   "a sphere beside the screen keeps an empty strip at its edge. Test first "
                   "whether the two overlap.",
                   "the right picture",
                   (ScreenRectangle){limited(s.left, w), limited(s.right, w), limited(s.top, h),
                                     limited(s.bottom, h)})
OF_WHOLE_RECTANGLE("R-leave", "nothing beyond an edge",
                   "a sphere that is partly outside of the screen is partly seen.",
                   "spheres at the edges of the picture are missing",
                   s.left >= 0 && s.right <= w && s.top >= 0 && s.bottom <= h ? s : nothing)

OF_RECTANGLE("R-last", "W - 1, H - 1",
             "the screen goes from 0 to W. W - 1 is where its last pixel begins.",
             "the last column and the last row are missing",
             return (ScreenRectangle){
                 fmin(s.left, screen.width - 1), fmin(s.right, screen.width - 1),
                 fmin(s.top, screen.height - 1), fmin(s.bottom, screen.height - 1)})

OF_VIEW("R-behind", "no case for z <= -r",
        "the lines go on behind the eye, and the formula does not know that. Test z first.",
        "the right picture, but spheres behind the eye are tested as well",
        ScreenRectangle s = on_screen(camera, screen, outline_of(v));
        return fabs(v.ahead) <= v.r ? whole(screen) : cut_off(s, screen))
OF_VIEW("R-behind-all", "the whole screen for z <= -r",
        "a sphere that is completely behind the eye is not visible.",
        "the right picture, but spheres behind the eye are tested as well",
        return v.ahead <= v.r ? whole(screen) : right_of(camera, screen, sphere))
OF_VIEW("R-center", "nothing for z <= 0",
        "a sphere whose center is behind the eye may reach in front of it. Compare z with -r.",
        "no sphere around the eye as soon as its center is behind the eye",
        return v.ahead <= 0 ? nothing : right_of(camera, screen, sphere))
OF_VIEW("R-inside", "nothing for z <= r", "from inside a sphere every ray hits it.",
        "no sphere around the eye or beside it",
        return v.ahead <= v.r ? nothing : right_of(camera, screen, sphere))
OF_VIEW("R-beside", "nothing beside the eye",
        "a sphere beside the eye that reaches ahead can be seen.", "no sphere beside the eye",
        bool outside = vec3_length(sphere.center - camera.origin) > v.r;
        return outside && v.ahead <= v.r ? nothing : right_of(camera, screen, sphere))
OF_VIEW("R-hither", "nothing nearer than z = d",
        "rays start at the eye, and the image plane does not stop them.",
        "no sphere between the eye and the plane",
        return v.ahead + v.r <= camera.distance ? nothing : right_of(camera, screen, sphere))
WRONG_LINE(sphere_rectangle, "R-all", "0, W, 0, H",
           "this tests every pixel for every sphere. A sphere covers less.",
           "the right picture, as slow as before", return whole(screen))

// ---- without a name ----------------------------------------------------------------------------

UNNAMED(sphere_rectangle, NOBODY, "a third of the radius")
{
    sphere.radius /= 3;
    return sphere_rectangle(camera, screen, sphere);
}

UNNAMED_LINE(sphere_rectangle, NOBODY, "a corner of the screen",
             return (ScreenRectangle){0, screen.width / 7.0, 0, screen.height / 7.0})
