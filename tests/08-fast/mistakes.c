// mistakes.c - wrong answers to exercise 08.
#include "exercises/08-fast.h"

#include "exercises/03-screen.h"
#include "tests/judge/mistake.h"

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

static Outline outline_of(View v)
{
    double g = v.ahead * v.ahead - v.r * v.r;
    double x = v.r * sqrt(v.right * v.right + g), y = v.r * sqrt(v.up * v.up + g);
    return (Outline){(v.ahead * v.right - x) / g, (v.ahead * v.right + x) / g,
                     (v.ahead * v.up - y) / g, (v.ahead * v.up + y) / g};
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

// All of it except the outline, which the mistake computes.
static ScreenRectangle with_outline(Camera c, Resolution screen, Sphere sphere,
                                    Outline (*outline)(View))
{
    View v = view_of(c, sphere);
    if (v.ahead <= -v.r)
        return nothing;
    return v.ahead <= v.r ? whole(screen) : cut_off(on_screen(c, screen, outline(v)), screen);
}

// All of it with another view.
static ScreenRectangle with_view(Camera c, Resolution screen, View v)
{
    if (v.ahead <= -v.r)
        return nothing;
    return v.ahead <= v.r ? whole(screen) : cut_off(on_screen(c, screen, outline_of(v)), screen);
}

#define OUTLINE_MISTAKE(name, outline)                                                             \
    static ScreenRectangle name(Camera c, Resolution screen, Sphere sphere)                        \
    {                                                                                              \
        return with_outline(c, screen, sphere, outline);                                           \
    }

// ---- the tangents -------------------------------------------------------------------------------

static Outline outline_radius_over_ahead(View v)
{
    double x = v.right / v.ahead, y = v.up / v.ahead, r = v.r / v.ahead;
    return (Outline){x - r, x + r, y - r, y + r};
}
OUTLINE_MISTAKE(radius_over_ahead, outline_radius_over_ahead)

static Outline outline_box(View v)
{
    double near = v.ahead - v.r, far = v.ahead + v.r;
    double l = v.right - v.r, r = v.right + v.r, b = v.up - v.r, t = v.up + v.r;
    return (Outline){fmin(l / near, l / far), fmax(r / near, r / far), fmin(b / near, b / far),
                     fmax(t / near, t / far)};
}
OUTLINE_MISTAKE(box_around, outline_box)

static Outline outline_near_side(View v)
{
    double near = v.ahead - v.r;
    return (Outline){(v.right - v.r) / near, (v.right + v.r) / near, (v.up - v.r) / near,
                     (v.up + v.r) / near};
}
OUTLINE_MISTAKE(near_side, outline_near_side)

static Outline outline_symmetric(View v)
{
    double x = v.right / v.ahead, y = v.up / v.ahead, g = v.ahead * v.ahead - v.r * v.r;
    double half_x = v.r * sqrt(v.right * v.right + g) / g, half_y = v.r * sqrt(v.up * v.up + g) / g;
    return (Outline){x - half_x, x + half_x, y - half_y, y + half_y};
}
OUTLINE_MISTAKE(around_the_centre, outline_symmetric)

static Outline outline_without_r(View v)
{
    double g = v.ahead * v.ahead - v.r * v.r;
    double x = v.r * hypot(v.right, v.ahead), y = v.r * hypot(v.up, v.ahead);
    return (Outline){(v.ahead * v.right - x) / g, (v.ahead * v.right + x) / g,
                     (v.ahead * v.up - y) / g, (v.ahead * v.up + y) / g};
}
OUTLINE_MISTAKE(radius_left_out_of_the_root, outline_without_r)

static Outline outline_g_plus(View v)
{
    double g = v.ahead * v.ahead + v.r * v.r;
    double x = v.r * sqrt(v.right * v.right + g), y = v.r * sqrt(v.up * v.up + g);
    return (Outline){(v.ahead * v.right - x) / g, (v.ahead * v.right + x) / g,
                     (v.ahead * v.up - y) / g, (v.ahead * v.up + y) / g};
}
OUTLINE_MISTAKE(g_with_plus, outline_g_plus)

static Outline outline_over_ahead_squared(View v)
{
    Outline o = outline_of(v);
    double g = (v.ahead * v.ahead - v.r * v.r) / (v.ahead * v.ahead);
    return (Outline){o.left * g, o.right * g, o.low * g, o.high * g};
}
OUTLINE_MISTAKE(over_ahead_squared, outline_over_ahead_squared)

static Outline outline_not_divided(View v)
{
    Outline o = outline_of(v);
    double g = v.ahead * v.ahead - v.r * v.r;
    return (Outline){o.left * g, o.right * g, o.low * g, o.high * g};
}
OUTLINE_MISTAKE(not_divided, outline_not_divided)

static Outline outline_half(View v)
{
    Outline o = outline_of(v);
    return (Outline){o.left / 2, o.right / 2, o.low / 2, o.high / 2};
}
OUTLINE_MISTAKE(divided_by_2g, outline_half)

static Outline outline_sign_of_b(View v)
{
    Outline o = outline_of(v);
    return (Outline){-o.right, -o.left, -o.high, -o.low};
}
OUTLINE_MISTAKE(sign_of_b, outline_sign_of_b)

static Outline outline_diameter(View v)
{
    v.r *= 2;
    return v.ahead > v.r ? outline_of(v) : (Outline){-INFINITY, INFINITY, -INFINITY, INFINITY};
}
OUTLINE_MISTAKE(diameter, outline_diameter)

static Outline outline_r_not_squared(View v)
{
    double g = v.ahead * v.ahead - v.r;
    double x = v.r * sqrt(fmax(v.right * v.right + g, 0));
    double y = v.r * sqrt(fmax(v.up * v.up + g, 0));
    return (Outline){(v.ahead * v.right - x) / g, (v.ahead * v.right + x) / g,
                     (v.ahead * v.up - y) / g, (v.ahead * v.up + y) / g};
}
OUTLINE_MISTAKE(r_not_squared, outline_r_not_squared)

// Angles in space, where each axis has an angle of its own.
static Outline outline_space_angle(View v)
{
    double around = asin(v.r / sqrt(v.right * v.right + v.up * v.up + v.ahead * v.ahead));
    double x = atan2(v.right, v.ahead), y = atan2(v.up, v.ahead);
    return (Outline){tan(x - around), tan(x + around), tan(y - around), tan(y + around)};
}
OUTLINE_MISTAKE(angle_in_space, outline_space_angle)

static Outline outline_atan(View v)
{
    double across = atan(v.r / hypot(v.right, v.ahead)), up = atan(v.r / hypot(v.up, v.ahead));
    double x = atan2(v.right, v.ahead), y = atan2(v.up, v.ahead);
    return (Outline){tan(x - across), tan(x + across), tan(y - up), tan(y + up)};
}
OUTLINE_MISTAKE(arc_tangent_of_the_radius, outline_atan)

static Outline outline_angles(View v)
{
    Outline o = outline_of(v);
    return (Outline){atan(o.left), atan(o.right), atan(o.low), atan(o.high)};
}
OUTLINE_MISTAKE(angles_for_tangents, outline_angles)

static const Mistake tangent_mistakes[] = {
    MISTAKE("R-flat", sphere_rectangle, radius_over_ahead, "x/z - r/z, x/z + r/z",
            "the tangents touch the sphere nearer to the eye than its centre is, so the outline is "
            "larger than a disc at the centre.",
            "spheres whose edges are cut off, most of all near the eye"),
    MISTAKE(
        "R-box", sphere_rectangle, box_around, "(x -+ r) / (z -+ r)",
        "this is the rectangle of a cube around the sphere. The sphere does not reach its corners.",
        "the right picture, but too many pixels are tested"),
    MISTAKE("R-near", sphere_rectangle, near_side, "(x -+ r) / (z - r)",
            "only one point of the sphere is as near as z - r, and it is not on the outline.",
            "large spheres are tested too often, and spheres at the side are cut off"),
    MISTAKE("R-middle", sphere_rectangle, around_the_centre, "x/z -+ r sqrt(x^2 + g) / g",
            "the middle between the two tangents is x z / g. The centre of the sphere is at x / z.",
            "spheres at the side are cut off on their outer side"),
    MISTAKE("R-root", sphere_rectangle, radius_left_out_of_the_root, "r sqrt(x^2 + z^2)",
            "under the root is x^2 + z^2 - r^2, the square of the length of the tangent.",
            "the right picture, but too many pixels are tested"),
    MISTAKE("R-plus", sphere_rectangle, g_with_plus, "g = z^2 + r^2", "g is z^2 - r^2.",
            "spheres whose edges are cut off"),
    MISTAKE("R-z2", sphere_rectangle, over_ahead_squared, "/ z^2 instead of / g",
            "the quadratic begins with g m^2, so its roots are divided by g = z^2 - r^2.",
            "spheres whose edges are cut off"),
    MISTAKE("R-divide", sphere_rectangle, not_divided, "x z -+ r sqrt(x^2 + g)",
            "the roots of the quadratic are divided by its first coefficient, g.",
            "nearly every sphere covers the whole screen"),
    MISTAKE(
        "R-half", sphere_rectangle, divided_by_2g, "/ (2 g)",
        "the 2 of 2 x z m and the 2 of the formula cancel. Divided by 2 g, everything is halved.",
        "only a part of each sphere, towards the middle of the picture"),
    MISTAKE("R-sign", sphere_rectangle, sign_of_b, "-x z -+ r sqrt(x^2 + g)",
            "the linear coefficient is -2 x z, and the formula has -b, so x z is positive.",
            "only spheres in the middle, because the rectangles are on the opposite side"),
    MISTAKE("R-diameter", sphere_rectangle, diameter, "2 r instead of r",
            "the radius is the distance from the centre to the surface.",
            "the right picture, but four times as many pixels are tested"),
    MISTAKE("R-square", sphere_rectangle, r_not_squared, "g = z^2 - r",
            "the radius is squared: r^2.",
            "right if the radius is 1; if not, cut off or too large"),
    MISTAKE("R-space", sphere_rectangle, angle_in_space, "asin(r / |c|)",
            "in this direction only x and z count. |c| includes how far up the sphere is.",
            "spheres near the corners are cut off"),
    MISTAKE(
        "R-atan", sphere_rectangle, arc_tangent_of_the_radius, "atan(r / sqrt(x^2 + z^2))",
        "eye, centre and the point that the tangent touches are a triangle with the right angle at "
        "that point, so the ratio of r and the distance is a sine.",
        "spheres whose edges are cut off"),
    MISTAKE("R-angles", sphere_rectangle, angles_for_tangents, "atan(m) instead of m",
            "places on the plane are proportional to the tangent of the angle, not to the angle.",
            "spheres near the edges of the picture are cut off"),
    {0},
};

// ---- the camera and the screen ------------------------------------------------------------------

static ScreenRectangle axes_of_the_world(Camera c, Resolution screen, Sphere sphere)
{
    vec3 to = sphere.center - c.origin;
    return with_view(c, screen, (View){to[0], to[1], to[2], sphere.radius});
}

static ScreenRectangle eye_forgotten(Camera c, Resolution screen, Sphere sphere)
{
    c.origin = vec3_of(0, 0, 0);
    return with_view(c, screen, view_of(c, sphere));
}

static ScreenRectangle away_from_the_sphere(Camera c, Resolution screen, Sphere sphere)
{
    sphere.center = 2 * c.origin - sphere.center;
    return with_view(c, screen, view_of(c, sphere));
}

static ScreenRectangle distance_from_the_plane(Camera c, Resolution screen, Sphere sphere)
{
    View v = view_of(c, sphere);
    v.ahead -= c.distance;
    return with_view(c, screen, v);
}

static ScreenRectangle distance_for_ahead(Camera c, Resolution screen, Sphere sphere)
{
    View v = view_of(c, sphere);
    if (v.ahead <= -v.r)
        return nothing;
    if (v.ahead <= v.r)
        return whole(screen);
    v.ahead = sqrt(v.right * v.right + v.up * v.up + v.ahead * v.ahead);
    return cut_off(on_screen(c, screen, outline_of(v)), screen);
}

static ScreenRectangle distance_taken_as_1(Camera c, Resolution screen, Sphere sphere)
{
    c.distance = 1;
    return with_view(c, screen, view_of(c, sphere));
}

static ScreenRectangle half_a_plane(Camera c, Resolution screen, Sphere sphere)
{
    c.width /= 2;
    c.height /= 2;
    return with_view(c, screen, view_of(c, sphere));
}

static ScreenRectangle width_for_height(Camera c, Resolution screen, Sphere sphere)
{
    c.height = c.width;
    return with_view(c, screen, view_of(c, sphere));
}

static ScreenRectangle square_pixels(Camera c, Resolution screen, Sphere sphere)
{
    c.height = c.width * screen.height / screen.width;
    return with_view(c, screen, view_of(c, sphere));
}

static ScreenRectangle up_counted_down(Camera c, Resolution screen, Sphere sphere)
{
    c.up = -c.up;
    return with_view(c, screen, view_of(c, sphere));
}

static ScreenRectangle mirrored(Camera c, Resolution screen, Sphere sphere)
{
    c.right = -c.right;
    return with_view(c, screen, view_of(c, sphere));
}

static ScreenRectangle right_of(Camera c, Resolution screen, Sphere sphere)
{
    return with_view(c, screen, view_of(c, sphere));
}

static ScreenRectangle top_and_bottom_exchanged(Camera c, Resolution screen, Sphere sphere)
{
    ScreenRectangle s = right_of(c, screen, sphere);
    return (ScreenRectangle){s.left, s.right, s.bottom, s.top};
}

static ScreenRectangle from_the_bottom(Camera c, Resolution screen, Sphere sphere)
{
    ScreenRectangle s = right_of(c, screen, sphere);
    return (ScreenRectangle){s.left, s.right, screen.height - s.top, screen.height - s.bottom};
}

static ScreenRectangle normalized(Camera c, Resolution screen, Sphere sphere)
{
    ScreenRectangle s = right_of(c, screen, sphere);
    return (ScreenRectangle){s.left / screen.width, s.right / screen.width, s.top / screen.height,
                             s.bottom / screen.height};
}

static ScreenRectangle from_the_middle(Camera c, Resolution screen, Sphere sphere)
{
    View v = view_of(c, sphere);
    if (v.ahead <= -v.r)
        return nothing;
    if (v.ahead <= v.r)
        return whole(screen);
    ScreenRectangle s = on_screen(c, screen, outline_of(v));
    double x = screen.width / 2.0, y = screen.height / 2.0;
    return cut_off((ScreenRectangle){s.left - x, s.right - x, s.top - y, s.bottom - y}, screen);
}

static ScreenRectangle half_a_pixel(Camera c, Resolution screen, Sphere sphere)
{
    View v = view_of(c, sphere);
    if (v.ahead <= -v.r)
        return nothing;
    if (v.ahead <= v.r)
        return whole(screen);
    ScreenRectangle s = on_screen(c, screen, outline_of(v));
    return cut_off((ScreenRectangle){s.left - 0.5, s.right - 0.5, s.top - 0.5, s.bottom - 0.5},
                   screen);
}

static ScreenRectangle whole_pixels(Camera c, Resolution screen, Sphere sphere)
{
    ScreenRectangle s = right_of(c, screen, sphere);
    return (ScreenRectangle){floor(s.left), ceil(s.right), floor(s.top), ceil(s.bottom)};
}

static ScreenRectangle rounded_down(Camera c, Resolution screen, Sphere sphere)
{
    ScreenRectangle s = right_of(c, screen, sphere);
    return (ScreenRectangle){floor(s.left), floor(s.right), floor(s.top), floor(s.bottom)};
}

static const Mistake screen_mistakes[] = {
    MISTAKE("R-world", sphere_rectangle, axes_of_the_world, "x, y, z of the world",
            "to the side, up and ahead are measured along the camera's right, up and forward.",
            "right until the camera turns"),
    MISTAKE("R-eye", sphere_rectangle, eye_forgotten, "c instead of c - p",
            "the eye is not at the origin of the world. Seen from the eye, the centre is at c - p.",
            "rectangles beside their spheres, so parts of the spheres are missing"),
    MISTAKE("R-back", sphere_rectangle, away_from_the_sphere, "p - c instead of c - p",
            "the vector from the eye to the centre is c - p. This one has the opposite direction.",
            "nothing, because each sphere in front is now behind the eye"),
    MISTAKE("R-plane", sphere_rectangle, distance_from_the_plane, "z - d instead of z",
            "ahead is measured from the eye, not from the image plane.",
            "spheres near the plane cover the whole screen, and others are tested too often"),
    MISTAKE("R-far", sphere_rectangle, distance_for_ahead, "|c| instead of z",
            "the distance ahead is measured along forward. |c| is the distance to the centre.",
            "spheres at the side are cut off"),
    MISTAKE("R-distance", sphere_rectangle, distance_taken_as_1, "m instead of d m",
            "m is the distance to the side for each 1 ahead, and the image plane is d ahead.",
            "right if d = 1; if not, each sphere is cut off"),
    MISTAKE("R-narrow", sphere_rectangle, half_a_plane, "w/2 instead of w, h/2 instead of h",
            "the whole width of the plane is the whole width of the screen.",
            "rectangles of twice the size, moved away from the middle"),
    MISTAKE(
        "R-width", sphere_rectangle, width_for_height, "w instead of h",
        "up is measured in heights of the plane, not in widths.",
        "right for a square plane; for others, spheres are cut off at the top or at the bottom"),
    MISTAKE("R-aspect", sphere_rectangle, square_pixels, "h = w H/W",
            "the camera gives the height of its plane. Pixels need not be square.",
            "right if they are square; if not, cut off or too large"),
    MISTAKE("R-upside", sphere_rectangle, up_counted_down, "H/2 + y instead of H/2 - y",
            "y of the screen counts down, and up counts up.",
            "only spheres at half the height, because the rectangles are upside down"),
    MISTAKE("R-mirror", sphere_rectangle, mirrored, "W/2 - x instead of W/2 + x",
            "x of the screen and right of the camera both grow to the right.",
            "only spheres in the middle, because left and right are swapped"),
    MISTAKE("R-order", sphere_rectangle, top_and_bottom_exchanged, "top > bottom",
            "the higher tangent is the top, and the top has the smaller y.",
            "nothing: the loop over the rows ends before it begins"),
    MISTAKE("R-below", sphere_rectangle, from_the_bottom, "H - y",
            "y starts at the top of the screen.",
            "nothing: the loop over the rows ends before it begins"),
    MISTAKE("R-normal", sphere_rectangle, normalized, "s, t instead of x, y",
            "these are shares of the screen, from 0 to 1. Screen points are in pixels.",
            "one pixel in the upper left corner"),
    MISTAKE("R-corner", sphere_rectangle, from_the_middle, "x instead of W/2 + x",
            "the origin of the screen is its upper left corner, and m = 0 is its middle.",
            "the upper left quarter of what there should be"),
    MISTAKE("R-pixel", sphere_rectangle, half_a_pixel, "x - 0.5, y - 0.5",
            "screen points are continuous: the first pixel reaches from 0 to 1.",
            "the last column and row of a sphere are missing here and there"),
    MISTAKE("R-whole", sphere_rectangle, whole_pixels, "floor, ceil",
            "the rectangle is exact. Rounding to pixels comes after it.", "the right picture"),
    MISTAKE("R-floor", sphere_rectangle, rounded_down, "(int)",
            "the rectangle is exact, so its parts are not whole numbers.",
            "the last column and row of each sphere are missing"),
    {0},
};

// ---- the cases ----------------------------------------------------------------------------------

static ScreenRectangle not_cut_off(Camera c, Resolution screen, Sphere sphere)
{
    View v = view_of(c, sphere);
    if (v.ahead <= -v.r)
        return nothing;
    return v.ahead <= v.r ? whole(screen) : on_screen(c, screen, outline_of(v));
}

static ScreenRectangle strip_beside_the_screen(Camera c, Resolution screen, Sphere sphere)
{
    ScreenRectangle s = not_cut_off(c, screen, sphere);
    return (ScreenRectangle){limited(s.left, screen.width), limited(s.right, screen.width),
                             limited(s.top, screen.height), limited(s.bottom, screen.height)};
}

static ScreenRectangle last_pixel_for_the_edge(Camera c, Resolution screen, Sphere sphere)
{
    ScreenRectangle s = right_of(c, screen, sphere);
    return (ScreenRectangle){fmin(s.left, screen.width - 1), fmin(s.right, screen.width - 1),
                             fmin(s.top, screen.height - 1), fmin(s.bottom, screen.height - 1)};
}

static ScreenRectangle nothing_if_it_leaves(Camera c, Resolution screen, Sphere sphere)
{
    ScreenRectangle s = not_cut_off(c, screen, sphere);
    bool inside = s.left >= 0 && s.right <= screen.width && s.top >= 0 && s.bottom <= screen.height;
    return inside ? s : nothing;
}

static ScreenRectangle no_case_behind(Camera c, Resolution screen, Sphere sphere)
{
    View v = view_of(c, sphere);
    if (fabs(v.ahead) <= v.r)
        return whole(screen);
    return cut_off(on_screen(c, screen, outline_of(v)), screen);
}

static ScreenRectangle whole_screen_behind(Camera c, Resolution screen, Sphere sphere)
{
    View v = view_of(c, sphere);
    return v.ahead <= v.r ? whole(screen) : right_of(c, screen, sphere);
}

static ScreenRectangle by_the_centre(Camera c, Resolution screen, Sphere sphere)
{
    return view_of(c, sphere).ahead <= 0 ? nothing : right_of(c, screen, sphere);
}

static ScreenRectangle nothing_around_the_eye(Camera c, Resolution screen, Sphere sphere)
{
    View v = view_of(c, sphere);
    return v.ahead <= v.r ? nothing : right_of(c, screen, sphere);
}

static ScreenRectangle only_the_inside(Camera c, Resolution screen, Sphere sphere)
{
    vec3 to = sphere.center - c.origin;
    bool beside = vec3_length(to) > sphere.radius && vec3_dot(to, c.forward) <= sphere.radius;
    return beside ? nothing : right_of(c, screen, sphere);
}

static ScreenRectangle cut_at_the_plane(Camera c, Resolution screen, Sphere sphere)
{
    View v = view_of(c, sphere);
    return v.ahead + v.r <= c.distance ? nothing : right_of(c, screen, sphere);
}

static ScreenRectangle always_all(Camera c, Resolution screen, Sphere sphere)
{
    (void)c, (void)sphere;
    return whole(screen);
}

static const Mistake case_mistakes[] = {
    MISTAKE(
        "R-cut", sphere_rectangle, not_cut_off, "not cut off",
        "outside of the screen there are no pixels, so the rectangle ends at the screen's edges.",
        "the program ends when it colours a pixel outside of the image"),
    MISTAKE(
        "R-strip", sphere_rectangle, strip_beside_the_screen, "limits alone",
        "a sphere beside the screen keeps an empty strip at its edge. Test first whether the two "
        "overlap.",
        "the right picture"),
    MISTAKE("R-last", sphere_rectangle, last_pixel_for_the_edge, "W - 1, H - 1",
            "the screen goes from 0 to W. W - 1 is where its last pixel begins.",
            "the last column and the last row are missing"),
    MISTAKE("R-leave", sphere_rectangle, nothing_if_it_leaves, "nothing beyond an edge",
            "a sphere that is partly outside of the screen is partly seen.",
            "spheres at the edges of the picture are missing"),
    MISTAKE("R-behind", sphere_rectangle, no_case_behind, "no case for z <= -r",
            "the lines go on behind the eye, and the formula does not know that. Test z first.",
            "the right picture, but spheres behind the eye are tested as well"),
    MISTAKE("R-behind-all", sphere_rectangle, whole_screen_behind, "the whole screen for z <= -r",
            "a sphere that is completely behind the eye is not visible.",
            "the right picture, but spheres behind the eye are tested as well"),
    MISTAKE("R-centre", sphere_rectangle, by_the_centre, "nothing for z <= 0",
            "a sphere whose centre is behind the eye may reach in front of it. Compare z with -r.",
            "no sphere around the eye as soon as its centre is behind the eye"),
    MISTAKE("R-inside", sphere_rectangle, nothing_around_the_eye, "nothing for z <= r",
            "from inside a sphere every ray hits it.", "no sphere around the eye or beside it"),
    MISTAKE("R-beside", sphere_rectangle, only_the_inside, "nothing beside the eye",
            "a sphere beside the eye that reaches ahead can be seen.", "no sphere beside the eye"),
    MISTAKE("R-hither", sphere_rectangle, cut_at_the_plane, "nothing nearer than z = d",
            "rays start at the eye, and the image plane does not stop them.",
            "no sphere between the eye and the plane"),
    MISTAKE("R-all", sphere_rectangle, always_all, "0, W, 0, H",
            "this tests every pixel for every sphere. A sphere covers less.",
            "the right picture, as slow as before"),
    {0},
};

static const Mistake *const mistakes[] = {tangent_mistakes, screen_mistakes, case_mistakes, NULL};
OF_STEM(mistakes)
