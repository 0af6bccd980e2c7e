// ask_screen.c - questions of exercises 01, 03, 04 and 08, and the width from an angle of 02.
#include "tests/proof/generated/question.h"

// ---- 01-corners ---------------------------------------------------------------------------------

static void draw_corners(Question *q)
{
    static const double places[] = {0, 0.5, 1, 0.25};
    q->size = draw_any_size();
    q->camera = draw_camera(q->size);
    q->s = draw_one_in(5) ? places[draw_below(4)] : draw(-1, 2);
    q->t = draw_one_in(5) ? places[draw_below(4)] : draw(-1, 2);
}

static double plane_tolerance(const Question *q)
{
    return 3e-9 * (q->camera.distance + q->camera.width + q->camera.height);
}

static void ask_corner(AnyFunction *answer, Question *q, Answer *said)
{
    say_vec3(said, ((vec3(*)(Camera))answer)(q->camera), plane_tolerance(q));
}

static void ask_place(AnyFunction *answer, Question *q, Answer *said)
{
    say_vec3(said, ((vec3(*)(Camera, double, double))answer)(q->camera, q->s, q->t),
             plane_tolerance(q));
}

static void ask_unit_distance(AnyFunction *answer, Question *q, Answer *said)
{
    Camera c = ((Camera(*)(Camera))answer)(q->camera);
    q->eye = q->camera.origin;
    say_vec3(said, c.origin, 3e-9 * vec3_length(q->eye));
    say_vec3(said, c.right, 3e-9);
    say_vec3(said, c.up, 3e-9);
    say_vec3(said, c.forward, 3e-9);
    say(said, c.distance, 3e-9);
    say(said, c.width, 3e-9 * q->camera.width / q->camera.distance);
    say(said, c.height, 3e-9 * q->camera.height / q->camera.distance);
}

// ---- width from an angle ------------------------------------------------------------------------

static void draw_angle(Question *q)
{
    static const double angles[] = {90, 60, 45, 1, 120};
    q->degrees = draw_one_in(6) ? angles[draw_below(5)] : draw(0.1, 179);
    q->distance = draw_any_size() * draw(0.3, 5);
}

static void ask_width(AnyFunction *answer, Question *q, Answer *said)
{
    double width = ((double (*)(double, double))answer)(q->degrees, q->distance);
    say(said, width, 3e-9 * q->distance * (1 + tan(q->degrees * PI / 360)));
}

// ---- 03-screen ----------------------------------------------------------------------------------

static void draw_screen(Question *q)
{
    q->screen = (Resolution){1 + draw_below(12), 1 + draw_below(12)};
    if (draw_one_in(3))
        q->screen = (Resolution){(int)draw_scale(1, 20000), (int)draw_scale(1, 20000)};
    if (draw_one_in(8))
        q->screen.height = q->screen.width;
    if (draw_one_in(8))
        *(draw_one_in(2) ? &q->screen.width : &q->screen.height) = 1;
    q->pixel = (Pixel){draw_below(q->screen.width), draw_below(q->screen.height)};
    double beyond = draw_one_in(3) ? 1 : 0;
    q->place = (Normalized){draw(-beyond, 1 + beyond), draw(-beyond, 1 + beyond)};
    q->point.x = draw(-beyond, 1 + beyond) * q->screen.width;
    q->point.y = draw(-beyond, 1 + beyond) * q->screen.height;
    if (draw_one_in(4))
        q->point = (ScreenPoint){draw_below(q->screen.width + 1), draw_below(q->screen.height + 1)};
}

static void ask_normalized(AnyFunction *answer, Question *q, Answer *said)
{
    Normalized place = ((Normalized(*)(ScreenPoint, Resolution))answer)(q->point, q->screen);
    say(said, place.s, 3e-12);
    say(said, place.t, 3e-12);
}

static void ask_point(AnyFunction *answer, Question *q, Answer *said)
{
    ScreenPoint point = ((ScreenPoint(*)(Normalized, Resolution))answer)(q->place, q->screen);
    say(said, point.x, 3e-9);
    say(said, point.y, 3e-9);
}

static void ask_center(AnyFunction *answer, Question *q, Answer *said)
{
    ScreenPoint point = ((ScreenPoint(*)(Pixel))answer)(q->pixel);
    say(said, point.x, 3e-9);
    say(said, point.y, 3e-9);
}

// ---- 04-pixel-ray -------------------------------------------------------------------------------

static void draw_pixel(Question *q)
{
    draw_screen(q);
    q->size = draw_any_size();
    q->camera = draw_camera(q->size);
}

// The length is free.
static void ask_ray(AnyFunction *answer, Question *q, Answer *said)
{
    Ray ray = ((Ray(*)(Camera, Resolution, Pixel))answer)(q->camera, q->screen, q->pixel);
    say_vec3(said, ray.origin, 3e-9 * q->size);
    say_vec3(said, vec3_unit(ray.direction), 1e-8);
}

// ---- 08-fast ------------------------------------------------------------------------------------

// Its rectangle ends within a pixel or two of an edge of the screen, inside or outside.
static void draw_at_edge(Question *q, double r)
{
    Camera c = q->camera;
    bool across = draw_one_in(2);
    double half = (across ? c.width : c.height) / 2 / c.distance;
    double pixels = across ? q->screen.width : q->screen.height, around = draw(0.05, 0.4);
    double middle = atan(half * (draw(-3, 3) / pixels - 1)) - around, away = r / sin(around);
    if (cos(middle) < 1.05 * sin(around))
        return;
    double aside = away * sin(middle) * (draw_one_in(2) ? 1 : -1);
    q->sphere.center =
        c.origin + away * cos(middle) * c.forward + aside * (across ? c.right : c.up);
}

// In front of the camera, most of them on the screen; around the eye, beside it and behind it.
static void draw_rectangle(Question *q)
{
    q->size = draw_any_size();
    q->camera = draw_camera(q->size);
    q->screen = (Resolution){1 + draw_below(1000), 1 + draw_below(1000)};
    double r = q->size * draw_scale(0.05, 2), ahead = r * draw_scale(1.1, 40);
    if (draw_one_in(4))
        ahead = r * draw(-3, 0.9);
    double reach = fmax(ahead, r) / q->camera.distance * (draw_one_in(4) ? 1.5 : 0.5);
    vec3 aside = reach * draw(-1, 1) * q->camera.width * q->camera.right +
                 reach * draw(-1, 1) * q->camera.height * q->camera.up;
    q->sphere = (Sphere){q->camera.origin + ahead * q->camera.forward + aside, r, 0};
    if (draw_one_in(4))
        draw_at_edge(q, r);
}

static void ask_rectangle(AnyFunction *answer, Question *q, Answer *said)
{
    ScreenRectangle box =
        ((ScreenRectangle(*)(Camera, Resolution, Sphere))answer)(q->camera, q->screen, q->sphere);
    say(said, box.left, 3e-6);
    say(said, box.right, 3e-6);
    say(said, box.top, 3e-6);
    say(said, box.bottom, 3e-6);
}

const Subject screen_subjects[] = {
    {"upper_left", 600, draw_corners, ask_corner, NULL},
    {"upper_right", 600, draw_corners, ask_corner, NULL},
    {"across_30_up_10", 600, draw_corners, ask_corner, NULL},
    {"image_plane_vector", 2000, draw_corners, ask_place, NULL},
    {"with_unit_distance", 1000, draw_corners, ask_unit_distance, NULL},
    {"width_from_angle", 1000, draw_angle, ask_width, NULL},
    {"screen_to_normalized", 2000, draw_screen, ask_normalized, NULL},
    {"normalized_to_screen", 2000, draw_screen, ask_point, NULL},
    {"pixel_center", 1000, draw_screen, ask_center, NULL},
    {"pixel_ray", 2000, draw_pixel, ask_ray, NULL},
    {"sphere_rectangle", 2000, draw_rectangle, ask_rectangle, NULL},
    {0},
};
