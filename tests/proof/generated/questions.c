// questions.c - random questions of every exercise, and answers as plain numbers.
#include "tests/proof/generated/generated.h"

#include "tests/judge/numbers.h"

#include <stdlib.h>

static uint64_t state;

void draw_begin(uint64_t seed)
{
    state = seed * 2 + 1;
}

// A multiplicative congruential generator of 2^64 (L'Ecuyer, 'Tables of Linear Congruential
// Generators', 1999), its upper bits.
static double next(void)
{
    state *= 3935559000370003845u;
    uint64_t mixed = state ^ (state >> 32);
    return (double)(mixed * 0xd1342543de82ef95u >> 11) / 9007199254740992.0;
}

static double draw(double low, double high)
{
    return low + (high - low) * next();
}

static int draw_below(int limit)
{
    return (int)(next() * limit);
}

static bool draw_one_in(int n)
{
    return draw_below(n) == 0;
}

static double draw_scale(double low, double high)
{
    return exp(draw(log(low), log(high)));
}

static double draw_any_size(void)
{
    return draw_one_in(3) ? draw_scale(1e-6, 1e6) : 1;
}

static vec3 draw_vec3(double size)
{
    double x = draw(-size, size), y = draw(-size, size);
    return vec3_of(x, y, draw(-size, size));
}

static vec3 draw_unit(void)
{
    static const double ways[] = {1, -1};
    if (draw_one_in(10)) {
        vec3 v = {0};
        v[draw_below(3)] = ways[draw_below(2)];
        return v;
    }
    for (;;) {
        vec3 v = draw_vec3(1);
        if (vec3_length(v) > 0.1 && vec3_length(v) < 1)
            return vec3_unit(v);
    }
}

static vec3 draw_color(void)
{
    double red = draw(0, 1), green = draw(0, 1);
    vec3 color = vec3_of(red, green, draw(0, 1));
    if (draw_one_in(8))
        color = vec3_of(0, 0, 0);
    if (draw_one_in(8))
        color = vec3_of(1, 1, 1);
    if (draw_one_in(8))
        color[draw_below(3)] = 0;
    return color;
}

static Camera draw_camera(double size)
{
    vec3 forward = draw_unit(), other = draw_unit();
    while (fabs(vec3_dot(forward, other)) > 0.9)
        other = draw_unit();
    vec3 right = vec3_unit(vec3_cross(forward, other));
    vec3 up = draw_one_in(2) ? vec3_cross(right, forward) : vec3_cross(forward, right);
    Camera camera = {.origin = draw_one_in(8) ? vec3_of(0, 0, 0) : draw_vec3(5 * size),
                     .right = right,
                     .up = up,
                     .forward = forward};
    camera.distance = size * draw(0.3, 5);
    camera.width = size * draw(0.3, 5);
    camera.height = draw_one_in(6) ? camera.width : size * draw(0.3, 5);
    if (draw_one_in(8))
        camera.distance = size;
    return camera;
}

static Sphere draw_sphere(double size, vec3 near)
{
    return (Sphere){.center = near + draw_vec3(size), .radius = size * draw_scale(0.05, 1)};
}

static void nudge_number(double *x)
{
    *x *= 1 + draw(-1e-11, 1e-11);
}

static void nudge_vec3(vec3 *v)
{
    double size = vec3_length(*v);
    if (isfinite(size))
        *v += draw_vec3(1e-11 * size);
}

void point_into(Question *q)
{
    q->scene.spheres = q->spheres + 1;
    q->scene.surfaces = q->surfaces;
    q->scene.lights = q->lights + 1;
}

// Both of two equal spheres.
static void nudge_scene(Question *q)
{
    bool twins = q->spheres[1].radius == q->spheres[2].radius;
    for (int i = 0; i < MOST_SPHERES; i++) {
        nudge_vec3(&q->spheres[i].center);
        nudge_number(&q->spheres[i].radius);
    }
    if (twins) {
        q->spheres[2].center = q->spheres[1].center;
        q->spheres[2].radius = q->spheres[1].radius;
    }
    for (int i = 0; i < MOST_LIGHTS; i++)
        nudge_vec3(&q->lights[i].position);
}

void nudge(Question *q)
{
    vec3 *const vectors[] = {
        &q->camera.origin,
        &q->eye,
        &q->corners.upper_left,
        &q->corners.upper_right,
        &q->corners.lower_left,
        &q->corners.lower_right,
        &q->lower_left,
        &q->across,
        &q->up,
        &q->view.eye,
        &q->view.at,
        &q->view.up,
        &q->ray.origin,
        &q->ray.direction,
        &q->sphere.center,
        &q->from,
        &q->to_light,
        &q->to_eye,
        &q->direction,
        &q->normal,
        &q->light.position,
    };
    double *const numbers[] = {&q->camera.distance,
                               &q->camera.width,
                               &q->camera.height,
                               &q->sphere.radius,
                               &q->radius,
                               &q->quadratic.a,
                               &q->quadratic.b,
                               &q->quadratic.c,
                               &q->point.x,
                               &q->point.y,
                               &q->s,
                               &q->t,
                               &q->hit.t};
    for (size_t i = 0; i < sizeof vectors / sizeof vectors[0]; i++)
        nudge_vec3(vectors[i]);
    for (size_t i = 0; i < sizeof numbers / sizeof numbers[0]; i++)
        nudge_number(numbers[i]);
    nudge_scene(q);
}

static void say(Answer *said, double number, double tolerance)
{
    if (said->count == MOST_NUMBERS)
        return;
    said->number[said->count] = number;
    said->tolerance[said->count++] = tolerance;
}

static void say_vec3(Answer *said, vec3 v, double tolerance)
{
    for (int i = 0; i < 3; i++)
        say(said, v[i], tolerance);
}

static void say_camera(Answer *said, Camera camera, const Question *question)
{
    double size = question->size;
    say_vec3(said, camera.origin, 3e-9 * (size + vec3_length(question->eye)));
    say_vec3(said, camera.right, 3e-9);
    say_vec3(said, camera.up, 3e-9);
    say_vec3(said, camera.forward, 3e-9);
    say(said, camera.distance, 3e-9 * size);
    say(said, camera.width, 3e-9 * size);
    say(said, camera.height, 3e-9 * size);
}

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

// ---- 02-cameras: which descriptions are valid cameras ------------------------------------------

// The contents of *camera before the call.
static const Camera before = {.origin = {1, 2, 3},
                              .right = {4, 5, 6},
                              .up = {7, 8, 9},
                              .forward = {10, 11, 12},
                              .distance = 13,
                              .width = 14,
                              .height = 15};

static void spoil(vec3 *v)
{
    static const double values[] = {NAN, INFINITY, -INFINITY};
    (*v)[draw_below(3)] = values[draw_below(3)];
}

// One thing wrong, and nothing else: straight ahead, but sheared, leaning or with one corner moved;
// or a rectangle that is only moved sideways, only moved up, or only turned. By any amount, in
// either direction.
static void spoil_alone(Question *q, const Camera *c)
{
    Corners *v = &q->corners;
    double off = q->size * draw_scale(1e-4, 2) * (draw_one_in(2) ? 1 : -1);
    vec3 way = draw_unit();
    switch (draw_below(6)) {
    case 0:
        v->upper_left += off * c->right, v->upper_right += off * c->right;
        v->lower_left -= off * c->right, v->lower_right -= off * c->right;
        break;
    case 1:
        v->upper_left -= off * c->up, v->lower_left -= off * c->up;
        v->upper_right += off * c->up, v->lower_right += off * c->up;
        break;
    case 2:
        v->upper_left -= off * way, v->upper_right -= off * way;
        v->lower_left -= off * way, v->lower_right += 3 * off * way;
        break;
    case 3:
    case 4:
        way = draw_one_in(2) ? c->right : c->up;
        v->upper_left += off * way, v->upper_right += off * way;
        v->lower_left += off * way, v->lower_right += off * way;
        break;
    default:
        v->upper_left += off * c->forward, v->lower_right -= off * c->forward;
        if (draw_one_in(2))
            v->upper_right += off * c->forward, v->lower_left -= off * c->forward;
        else
            v->lower_left += off * c->forward, v->upper_right -= off * c->forward;
    }
}

// A rectangle, or one that has been pushed out of shape.
static void draw_four_corners(Question *q)
{
    q->size = draw_any_size() * (draw_one_in(6) ? draw_scale(1e-3, 1e3) : 1);
    q->exact = true;
    Camera c = draw_camera(q->size);
    bool far = draw_one_in(12);
    c.distance *= far ? 1000 : 1;
    vec3 middle = c.distance * c.forward, right = c.width / 2 * c.right, up = c.height / 2 * c.up;
    q->eye = c.origin;
    if (draw_one_in(3)) {
        vec3 sideways = q->size * draw_scale(1e-4, 2) * draw_unit();
        switch (draw_below(6)) {
        case 0:
            middle += sideways;
            break;
        case 1:
            right += sideways;
            break;
        case 2:
            up += sideways;
            break;
        case 3:
            middle = vec3_of(0, 0, 0);
            break;
        case 4:
            right = vec3_of(0, 0, 0);
            break;
        default:
            up = vec3_of(0, 0, 0);
        }
    }
    q->corners = (Corners){middle - right + up, middle + right + up, middle - right - up,
                           middle + right - up};
    vec3 *const corners[] = {&q->corners.upper_left, &q->corners.upper_right,
                             &q->corners.lower_left, &q->corners.lower_right};
    if (draw_one_in(3))
        spoil_alone(q, &c);
    else if (draw_one_in(8))
        *corners[draw_below(4)] += q->size * draw_scale(1e-6, far ? 2e-6 : 2) * draw_unit();
    if (draw_one_in(20))
        spoil(corners[draw_below(4)]);
    if (draw_one_in(30))
        spoil(&q->eye);
    q->lower_left = q->eye + q->corners.lower_left;
    q->across = q->corners.lower_right - q->corners.lower_left;
    q->up = q->corners.upper_left - q->corners.lower_left;
}

static void draw_points(Question *q)
{
    draw_four_corners(q);
    q->corners.upper_left += q->eye;
    q->corners.upper_right += q->eye;
    q->corners.lower_left += q->eye;
    q->corners.lower_right += q->eye;
}

static void say_found(Answer *said, CameraFault fault, Camera camera, const Question *q)
{
    say(said, fault, 0);
    say_camera(said, camera, q);
}

static void ask_four_corners(AnyFunction *answer, Question *q, Answer *said)
{
    Camera camera = before;
    CameraFault fault =
        ((CameraFault(*)(vec3, Corners, Camera *))answer)(q->eye, q->corners, &camera);
    say_found(said, fault, camera, q);
}

static void ask_lower_left(AnyFunction *answer, Question *q, Answer *said)
{
    Camera camera = before;
    CameraFault fault = ((CameraFault(*)(vec3, vec3, vec3, vec3, Camera *))answer)(
        q->eye, q->lower_left, q->across, q->up, &camera);
    say_found(said, fault, camera, q);
}

static void draw_look_at(Question *q)
{
    q->size = draw_any_size();
    q->exact = true;
    q->view.eye = q->eye = draw_vec3(5 * q->size);
    q->view.at = q->eye + q->size * draw(0.3, 5) * draw_unit();
    q->view.up = draw_any_size() * draw(0.3, 5) * draw_unit();
    if (draw_one_in(8))
        q->view.up *= draw_scale(1e-12, 1);
    vec3 view = q->view.at - q->eye;
    if (draw_one_in(10))
        q->view.at = q->eye;
    if (draw_one_in(10))
        q->view.up = draw(-3, 3) * view;
    if (draw_one_in(20))
        q->view.up = vec3_of(0, 0, 0);
    q->view.width = q->size * (draw_one_in(10) ? draw(-3, 0) : draw(0.3, 5));
    q->view.aspect = draw_one_in(10) ? draw(-3, 0) : draw_one_in(5) ? 1 : draw(0.3, 3);
    if (draw_one_in(25))
        q->view.width = 0;
    if (draw_one_in(25))
        q->view.aspect = draw_one_in(2) ? 0 : NAN;
    if (draw_one_in(25))
        spoil(draw_one_in(3) ? &q->view.eye : draw_one_in(2) ? &q->view.at : &q->view.up);
    q->world = draw_one_in(2) ? LEFT_HANDED : RIGHT_HANDED;
}

static void ask_look_at(AnyFunction *answer, Question *q, Answer *said)
{
    Camera camera = before;
    CameraFault fault =
        ((CameraFault(*)(LookAt, Handedness, Camera *))answer)(q->view, q->world, &camera);
    say_found(said, fault, camera, q);
}

// ---- which reasons hold -------------------------------------------------------------------------

static bool is_finite(vec3 v)
{
    return isfinite(v[0]) && isfinite(v[1]) && isfinite(v[2]);
}

static bool is_none(vec3 edge)
{
    return vec3_length(edge) == 0;
}

static int reason(bool holds, CameraFault fault)
{
    return holds ? 1 << fault : 0;
}

// By the places of the corners, relative to their distances. Only if the camera was refused. A line
// is not a rectangle either, and an eye in the plane is not opposite its middle.
static int reasons_of(vec3 upper_left, vec3 upper_right, vec3 lower_left, vec3 lower_right)
{
    vec3 middle = (upper_left + upper_right + lower_left + lower_right) / 4;
    vec3 upper = upper_right - upper_left, lower = lower_right - lower_left;
    vec3 left = upper_left - lower_left, right = upper_right - lower_right;
    double wide = fmax(vec3_length(upper), vec3_length(lower));
    double high = fmax(vec3_length(left), vec3_length(right));
    double far = vec3_length(middle), tiny = 1e-7 * (wide + high + far);
    bool parallelogram = vec3_length(upper - lower) <= 1e-8 * (wide + high);
    bool right_angles = fabs(vec3_dot(upper, left)) <= 1e-7 * wide * high;
    bool on_axis = fabs(vec3_dot(upper, middle)) <= 1e-7 * wide * far &&
                   fabs(vec3_dot(left, middle)) <= 1e-7 * high * far;
    bool no_width = vec3_length(upper) <= tiny || vec3_length(lower) <= tiny;
    bool no_height = vec3_length(left) <= tiny || vec3_length(right) <= tiny;
    bool in_plane = !no_width && !no_height &&
                    fabs(vec3_dot(vec3_cross(upper, left), middle)) <= 1e-7 * wide * high * far;
    // The middle of a rectangle is that of either diagonal.
    bool in_middle = vec3_length(upper_left + lower_right) <= tiny ||
                     vec3_length(upper_right + lower_left) <= tiny;
    return reason(far <= tiny || in_plane || in_middle, CAMERA_NO_DISTANCE) |
           reason(no_width, CAMERA_NO_WIDTH) | reason(no_height, CAMERA_NO_HEIGHT) |
           reason(!parallelogram || !right_angles || no_width || no_height, CAMERA_NO_RECTANGLE) |
           reason(!on_axis || far <= tiny || in_plane, CAMERA_OFF_AXIS);
}

static bool may_refuse(int reasons, const Answer *yours, const Answer *right)
{
    if (yours->count != right->count || right->number[0] == CAMERA_OK)
        return false;
    bool kept = true;
    for (int i = 1; i < yours->count; i++)
        kept = kept && yours->number[i] == right->number[i];
    double fault = yours->number[0];
    bool known = fault > 0 && fault < CAMERA_FAULTS;
    return kept && known && (reasons >> (int)fault & 1) == 1;
}

static bool is_right_of_vectors(const Question *q, const Answer *yours, const Answer *right)
{
    const Corners *c = &q->corners;
    bool finite = is_finite(q->eye) && is_finite(c->upper_left) && is_finite(c->upper_right) &&
                  is_finite(c->lower_left) && is_finite(c->lower_right);
    int reasons =
        finite ? reasons_of(c->upper_left, c->upper_right, c->lower_left, c->lower_right) : 0;
    // Infinite corners or NaN do not make a rectangle either; and other edges may have no length.
    if (!finite)
        reasons = reason(true, CAMERA_NOT_FINITE) | reason(true, CAMERA_NO_RECTANGLE) |
                  reason(true, CAMERA_OFF_AXIS) |
                  reason(is_none(c->upper_left - c->upper_right), CAMERA_NO_WIDTH) |
                  reason(is_none(c->lower_left - c->lower_right), CAMERA_NO_WIDTH) |
                  reason(is_none(c->upper_left - c->lower_left), CAMERA_NO_HEIGHT) |
                  reason(is_none(c->upper_right - c->lower_right), CAMERA_NO_HEIGHT);
    return may_refuse(reasons, yours, right);
}

static bool is_right_of_points(const Question *q, const Answer *yours, const Answer *right)
{
    Question vectors = *q;
    vectors.corners.upper_left -= q->eye;
    vectors.corners.upper_right -= q->eye;
    vectors.corners.lower_left -= q->eye;
    vectors.corners.lower_right -= q->eye;
    return is_right_of_vectors(&vectors, yours, right);
}

static bool is_right_of_corner(const Question *q, const Answer *yours, const Answer *right)
{
    Question vectors = *q;
    vec3 corner = q->lower_left - q->eye;
    vectors.corners =
        (Corners){corner + q->up, corner + q->across + q->up, corner, corner + q->across};
    int none =
        reason(is_none(q->across), CAMERA_NO_WIDTH) | reason(is_none(q->up), CAMERA_NO_HEIGHT);
    return is_right_of_vectors(&vectors, yours, right) || may_refuse(none, yours, right);
}

static bool is_right_of_look_at(const Question *q, const Answer *yours, const Answer *right)
{
    const LookAt *v = &q->view;
    bool finite = is_finite(v->eye) && is_finite(v->at) && is_finite(v->up) && isfinite(v->width) &&
                  isfinite(v->aspect);
    vec3 ahead = v->at - v->eye;
    double across = vec3_length(vec3_cross(ahead, v->up));
    bool along = !(across > 1e-7 * vec3_length(ahead) * vec3_length(v->up)) &&
                 (vec3_length(ahead) > 0 || vec3_length(v->up) == 0);
    int reasons = reason(!finite || v->aspect == 0, CAMERA_NOT_FINITE) |
                  reason(!(vec3_length(ahead) > 0), CAMERA_NO_DIRECTION) |
                  reason(!(vec3_length(ahead) > 0), CAMERA_NO_DISTANCE) |
                  reason(along, CAMERA_UP_ALONG_VIEW) | reason(!(v->width > 0), CAMERA_NO_WIDTH) |
                  reason(!(v->aspect > 0) || !(v->width > 0), CAMERA_NO_HEIGHT);
    return may_refuse(reasons, yours, right);
}

// ---- 05-quadratic: rays and spheres, equations and their roots ---------------------------------

// A ray that passes a sphere's centre at a distance, and begins before, in or behind it.
static void draw_meeting(Question *q)
{
    double size = q->size = draw_any_size(), r = size * draw_scale(0.05, 5);
    vec3 way = draw_unit(), aside = draw_unit();
    while (vec3_length(vec3_cross(way, aside)) < 0.1)
        aside = draw_unit();
    aside = vec3_unit(vec3_cross(way, aside));
    double beside = r * (draw_one_in(3) ? draw(1.01, 4) : draw_one_in(6) ? 0 : draw(0, 0.99));
    double along = r * (draw_one_in(3) ? draw(-0.9, 0.9) : draw_scale(1, 300));
    if (draw_one_in(4))
        along = -along;
    if (draw_one_in(30)) // from the centre itself
        beside = along = 0;
    vec3 center = draw_one_in(6) ? vec3_of(0, 0, 0) : draw_vec3(5 * size);
    double speed = draw_one_in(4) ? 1 : draw_scale(0.01, 100);
    if (draw_one_in(4))
        speed *= draw_scale(1e-5, 1e5);
    q->ray = (Ray){center + beside * aside - along * way, speed * way};
    q->sphere = (Sphere){.center = center, .radius = r};
    q->radius = r;
}

// A line that touches the sphere: all numbers are whole, and products and roots exact.
static void draw_touching(Question *q)
{
    int axis = draw_below(3), other = (axis + 1 + draw_below(2)) % 3;
    double speed = exp2(draw_below(5) - 2);
    *q = (Question){.size = 1, .edge = true};
    q->radius = 1 + draw_below(6);
    q->sphere = (Sphere){.radius = q->radius};
    for (int i = 0; i < 3; i++)
        q->sphere.center[i] = draw_below(11) - 5;
    q->ray.origin = q->sphere.center;
    q->ray.origin[other] += q->radius;
    q->ray.origin[axis] += 4 * (draw_below(9) - 4);
    q->ray.direction[axis] = draw_one_in(2) ? speed : -speed;
    if (draw_one_in(3)) { // or begins on the surface, straight in or out
        q->ray.origin = q->sphere.center;
        q->ray.origin[axis] += draw_one_in(2) ? q->radius : -q->radius;
    }
}

static void draw_ray(Question *q)
{
    if (draw_one_in(12))
        draw_touching(q);
    else
        draw_meeting(q);
}

static void draw_object_ray(Question *q)
{
    draw_meeting(q);
    q->ray.origin -= q->sphere.center;
}

// Made from roots, so that both signs, zeros and lines are frequent.
static void draw_quadratic(Question *q)
{
    double size = draw_any_size(), t = size * draw(-5, 5), u = size * draw(-5, 5);
    double a = draw_any_size() * (draw_one_in(2) ? draw(0.1, 5) : draw(-5, -0.1));
    if (draw_one_in(8))
        t = 0;
    if (draw_one_in(8))
        u = -t;
    q->quadratic = (Quadratic){a, -a * (t + u), a * t * u};
    if (draw_one_in(4)) // none
        q->quadratic.c = a * (t * t + size * size * draw(0.01, 9)), q->quadratic.b = -2 * a * t;
    if (draw_one_in(10)) // twice the same, in whole numbers
        q->quadratic = (Quadratic){1 + draw_below(3), 0, 0}, t = draw_below(9) - 4,
        q->quadratic.b = -2 * q->quadratic.a * t, q->quadratic.c = q->quadratic.a * t * t;
    if (draw_one_in(8))
        q->quadratic.a = 0;
    if (draw_one_in(16))
        q->quadratic.a = q->quadratic.b = 0;
    if (draw_one_in(40))
        q->quadratic.c = 0;
    Quadratic e = q->quadratic;
    double d = e.b * e.b - 4 * e.a * e.c;
    q->edge = e.a != 0 && d == 0 && e.b != 0;
    q->size = e.a != 0   ? fmax(fabs(e.b / e.a), sqrt(fabs(e.c / e.a)))
              : e.b != 0 ? fabs(e.c / e.b)
                         : 1;
}

static void ask_object_ray(AnyFunction *answer, Question *q, Answer *said)
{
    Ray ray = ((Ray(*)(Ray, Sphere))answer)(q->ray, q->sphere);
    double size = vec3_length(q->ray.origin) + vec3_length(q->sphere.center);
    say_vec3(said, ray.origin, 3e-9 * size);
    say_vec3(said, ray.direction, 3e-9 * vec3_length(q->ray.direction));
}

static void say_quadratic(Answer *said, Quadratic e, double v, double p, double r)
{
    double lost = 1e-14 * (v * v + p * p + r * r); // by differences of c at t = 1, 0 and -1
    say(said, e.a, 3e-9 * v * v + lost);
    say(said, e.b, 3e-9 * v * p + lost);
    say(said, e.c, 3e-9 * (p * p + r * r));
}

static void ask_object_quadratic(AnyFunction *answer, Question *q, Answer *said)
{
    Quadratic e = ((Quadratic(*)(Ray, double))answer)(q->ray, q->radius);
    say_quadratic(said, e, vec3_length(q->ray.direction), vec3_length(q->ray.origin), q->radius);
}

static void ask_world_quadratic(AnyFunction *answer, Question *q, Answer *said)
{
    Quadratic e = ((Quadratic(*)(Ray, Sphere))answer)(q->ray, q->sphere);
    say_quadratic(said, e, vec3_length(q->ray.direction),
                  vec3_length(q->ray.origin) + vec3_length(q->sphere.center), q->sphere.radius);
}

static void say_roots(Answer *said, Roots roots, double tolerance)
{
    say(said, roots.count, 0);
    for (int i = 0; i < 2; i++)
        say(said, i < roots.count ? roots.t[i] : 0, tolerance);
}

static void ask_roots(AnyFunction *answer, Question *q, Answer *said)
{
    say_roots(said, ((Roots(*)(Quadratic))answer)(q->quadratic), 1e-8 * q->size);
}

static double root_step(const Question *q)
{
    return 2e-6 * q->sphere.radius / vec3_length(q->ray.direction);
}

static void ask_sphere(AnyFunction *answer, Question *q, Answer *said)
{
    say_roots(said, ((Roots(*)(Ray, Sphere))answer)(q->ray, q->sphere), root_step(q));
}

static void ask_hit(AnyFunction *answer, Question *q, Answer *said)
{
    say(said, ((double (*)(Ray, Sphere))answer)(q->ray, q->sphere), root_step(q));
}

// ---- 06-ray-casting, and 07 if a whole scene is an argument ------------------------------------

// There is another sphere before the first and after the last, as in the answering process: an
// answer that counts too far finds it.
static void draw_scene(Question *q, vec3 near)
{
    double size = q->size;
    q->scene = (Scene){.background = draw_color(),
                       .ambient = draw_one_in(3) ? draw_color() : vec3_of(0.1, 0.1, 0.1)};
    q->scene.sphere_count = draw_one_in(12) ? 0 : 1 + draw_below(MOST_SPHERES - 2);
    q->scene.light_count = draw_one_in(8) ? 0 : 1 + draw_below(MOST_LIGHTS - 2);
    q->scene.surface_count = MOST_SPHERES;
    for (int i = 0; i < MOST_SPHERES; i++) {
        q->spheres[i] = draw_sphere(1.5 * size, near);
        q->spheres[i].surface = draw_below(MOST_SPHERES);
        q->surfaces[i] = (Surface){.color = draw_color(),
                                   .diffuse = draw(0, 1),
                                   .specular = draw_one_in(4) ? 0 : draw(0, 1),
                                   .shine = draw_scale(1, 50)};
    }
    for (int i = 0; i < MOST_LIGHTS; i++)
        q->lights[i] = (Light){.position = near + draw_vec3(4 * size),
                               .color = draw(0.2, 1) * draw_color(),
                               .kind = draw_one_in(3) ? LIGHT_DISTANT : LIGHT_POINT};
    q->spheres[0] = q->spheres[1 + q->scene.sphere_count] = GUARD_SPHERE;
    q->lights[1 + q->scene.light_count] = GUARD_LIGHT;
    point_into(q);
}

// Sometimes two spheres at the same place: the first one counts.
static void draw_twins(Question *q)
{
    int surface = q->spheres[2].surface;
    if (!draw_one_in(8) || q->scene.sphere_count <= 1)
        return;
    q->spheres[2] = q->spheres[1];
    q->spheres[2].surface = surface;
}

static void draw_scene_ray(Question *q)
{
    q->size = draw_any_size();
    draw_scene(q, draw_one_in(3) ? vec3_of(0, 0, 0) : draw_vec3(3 * q->size));
    int count = q->scene.sphere_count;
    vec3 target = q->spheres[count > 0 ? 1 + draw_below(count) : 0].center;
    vec3 from = draw_one_in(5) ? target + 0.02 * q->size * draw_unit()
                               : target + q->size * draw_scale(0.5, 50) * draw_unit();
    if (draw_one_in(4))
        target += draw_vec3(q->size);
    q->ray = (Ray){from, draw_scale(0.05, 20) / q->size * vec3_length(target - from) *
                             vec3_unit(target - from)};
    if (draw_one_in(3))
        q->ray.direction = draw_scale(1e-4, 1e4) * vec3_unit(target - from);
    if (draw_one_in(8))
        q->ray.direction = -q->ray.direction;
    draw_twins(q);
}

static double step(const Question *q, double speed)
{
    return 2e-6 * q->size * 0.05 / speed;
}

static void ask_nearest(AnyFunction *answer, Question *q, Answer *said)
{
    Hit hit = ((Hit(*)(Ray, const Scene *))answer)(q->ray, &q->scene);
    say(said, hit.t, step(q, vec3_length(q->ray.direction)));
    say(said, hit.sphere, 0);
}

// A view that has the scene before it: wide, high, square, one pixel wide or high.
static void draw_picture(Question *q)
{
    q->size = draw_any_size();
    q->camera = draw_camera(q->size);
    q->camera.distance = q->size * draw(0.5, 2);
    draw_scene(q, q->camera.origin + draw(0, 5) * q->size * q->camera.forward);
    draw_twins(q);
    q->screen = (Resolution){1 + draw_below(11), 1 + draw_below(11)};
    if (draw_one_in(4))
        q->screen.height = q->screen.width;
    if (draw_one_in(6))
        q->screen = (Resolution){1, 1 + draw_below(11)};
    if (draw_one_in(6))
        q->screen = (Resolution){1 + draw_below(11), 1};
}

// A frame around the image and the depths: it detects an answer that writes outside of them, which
// then does no harm.
static void ask_picture(AnyFunction *answer, Question *q, Answer *said, bool with_depth)
{
    enum { FRAME = 16 };
    static uint8_t rgb[3 * (MOST_PIXELS + 2 * FRAME)];
    static double depth[MOST_PIXELS + 2 * FRAME];
    for (size_t i = 0; i < sizeof rgb; i++)
        rgb[i] = (uint8_t)(17 * i);
    for (size_t i = 0; i < sizeof depth / sizeof depth[0]; i++)
        depth[i] = q->screen.width % 4 != 0 ? NO_HIT : i % 3 == 0 ? -1 : 0.5 * (double)(i % 7);
    Image image = {.size = q->screen, .rgb = rgb + 3 * FRAME};
    int pixels = q->screen.width * q->screen.height;
    if (with_depth)
        ((void (*)(const Scene *, Camera, Image *, double *))answer)(&q->scene, q->camera, &image,
                                                                     depth + FRAME);
    else
        ((void (*)(const Scene *, Camera, Image *))answer)(&q->scene, q->camera, &image);
    for (int i = -1; i <= pixels; i++)
        say(said, image.rgb[3 * i] + 256 * image.rgb[3 * i + 1] + 65536 * image.rgb[3 * i + 2], 0);
    for (int i = -1; i <= pixels && with_depth; i++)
        say(said, depth[FRAME + i], step(q, q->camera.distance));
}

static void ask_image_order(AnyFunction *answer, Question *q, Answer *said)
{
    ask_picture(answer, q, said, false);
}

static void ask_object_order(AnyFunction *answer, Question *q, Answer *said)
{
    ask_picture(answer, q, said, true);
}

// ---- 07-shading ---------------------------------------------------------------------------------

static void draw_shadow(Question *q)
{
    q->size = draw_any_size();
    draw_scene(q, vec3_of(0, 0, 0));
    q->light = q->lights[0];
    q->from = draw_vec3(3 * q->size);
    if (draw_one_in(4))
        q->light.position = q->spheres[draw_below(MOST_SPHERES)].center;
}

static void ask_visibility(AnyFunction *answer, Question *q, Answer *said)
{
    say(said, ((double (*)(const Scene *, vec3, Light))answer)(&q->scene, q->from, q->light), 3e-9);
}

static Hit where_it_hits(const Question *q)
{
    Hit nearest = {NO_HIT, -1};
    for (int i = 0; i < q->scene.sphere_count; i++) {
        vec3 p = q->ray.origin - q->spheres[i + 1].center, v = q->ray.direction;
        double a = vec3_dot(v, v), b = vec3_dot(p, v);
        double r = q->spheres[i + 1].radius, d = b * b - a * (vec3_dot(p, p) - r * r);
        double t = (-b - sqrt(d)) / a > 0 ? (-b - sqrt(d)) / a : (-b + sqrt(d)) / a;
        if (d > 0 && t > 0 && t < nearest.t)
            nearest = (Hit){t, i};
    }
    return nearest;
}

static void draw_hit(Question *q)
{
    do {
        draw_scene_ray(q);
        q->hit = where_it_hits(q);
    } while (q->hit.sphere < 0);
}

static double light_tolerance(const Question *q)
{
    return 3e-9 * (2 + q->scene.light_count);
}

static void ask_shade(AnyFunction *answer, Question *q, Answer *said)
{
    Color color = ((Color(*)(const Scene *, Ray, Hit))answer)(&q->scene, q->ray, q->hit);
    say_vec3(said, color, light_tolerance(q));
}

static void draw_depth(Question *q)
{
    draw_scene_ray(q);
    q->depth = draw_one_in(3) ? 0 : draw_below(4);
}

// The picture in curved mirrors depends a little on where their rays start.
static void ask_trace(AnyFunction *answer, Question *q, Answer *said)
{
    Color color = ((Color(*)(const Scene *, Ray, int))answer)(&q->scene, q->ray, q->depth);
    say_vec3(said, color, q->depth > 0 ? 1e-4 : light_tolerance(q));
}

// ---- 07-shading: normals, terms of light, colours ----------------------------------------------

// A surface, and light and eye on either side of it.
static void draw_surface(Question *q)
{
    q->size = draw_any_size();
    q->normal = draw_unit();
    q->to_light = draw_scale(0.01, 100) * draw_unit();
    q->to_eye = draw_scale(0.01, 100) * draw_unit();
    if (draw_one_in(2) && vec3_dot(q->to_light, q->normal) < 0)
        q->to_light = -q->to_light;
    if (draw_one_in(3)) // near the mirrored light
        q->to_eye = 2 * vec3_dot(q->to_light, q->normal) * q->normal - q->to_light +
                    draw_vec3(0.4 * vec3_length(q->to_light));
    if (vec3_dot(q->to_eye, q->normal) < 0)
        q->to_eye = -q->to_eye;
    q->direction = draw_any_size() * draw(0.2, 5) * draw_unit();
    if (draw_one_in(6))
        q->direction = draw(-3, 3) * q->normal;
    q->surface = draw_color();
    q->ambient = draw_one_in(3) ? 3 * draw_color() : draw_color();
    q->brightness = draw_one_in(3) ? 3 * draw_color() : draw_color();
    q->kd = draw_one_in(8) ? 1 : draw(0, 1);
    q->ks = draw_one_in(8) ? 1 : draw(0, 1);
    q->shine = draw_one_in(6) ? 1 + draw_below(10) : draw_one_in(12) ? 0 : draw_scale(0.3, 200);
}

// The halfway vector exists wherever the eye is. Of an eye behind the surface the contract leaves
// free whether it sees what is not black in any case.
static void draw_halfway(Question *q)
{
    draw_surface(q);
    bool is_black = vec3_dot(q->normal, vec3_unit(q->to_light) - vec3_unit(q->to_eye)) < 0;
    if (draw_one_in(4) && is_black)
        q->to_eye = -q->to_eye;
}

static void draw_point(Question *q)
{
    q->size = draw_any_size();
    q->sphere = draw_sphere(5 * q->size, draw_one_in(5) ? vec3_of(0, 0, 0) : draw_vec3(q->size));
    if (draw_one_in(12))
        q->sphere.center = vec3_of(0, 0, 0);
    else if (draw_one_in(4)) // far away along one axis
        q->sphere.center[draw_below(3)] += q->sphere.radius * draw(-300, 300);
    q->normal = draw_unit();
    q->from = q->sphere.center + q->sphere.radius * q->normal;
    if (draw_one_in(3)) // from inside
        q->normal = -q->normal;
    q->light = (Light){.position = draw_any_size() * draw_vec3(3 * q->size),
                       .color = draw_color(),
                       .kind = draw_one_in(2) ? LIGHT_DISTANT : LIGHT_POINT};
}

static double point_tolerance(const Question *q)
{
    return 1e-8 * (1 + vec3_length(q->sphere.center) / q->sphere.radius);
}

static void ask_normal(AnyFunction *answer, Question *q, Answer *said)
{
    say_vec3(said, ((vec3(*)(Sphere, vec3))answer)(q->sphere, q->from), point_tolerance(q));
}

static void ask_to_light(AnyFunction *answer, Question *q, Answer *said)
{
    Ray ray = ((Ray(*)(vec3, Light))answer)(q->from, q->light);
    double size = vec3_length(q->from) + vec3_length(q->light.position);
    say_vec3(said, ray.origin, 3e-9 * size);
    say_vec3(said, ray.direction, 3e-9 * size);
}

static void ask_ambient(AnyFunction *answer, Question *q, Answer *said)
{
    say_vec3(said, ((Color(*)(Color, double, Color))answer)(q->surface, q->kd, q->ambient), 1e-8);
}

static void ask_diffuse(AnyFunction *answer, Question *q, Answer *said)
{
    Color color = ((Color(*)(Color, double, Color, vec3, vec3))answer)(
        q->surface, q->kd, q->brightness, q->normal, q->to_light);
    say_vec3(said, color, 1e-8);
}

static void ask_mirror(AnyFunction *answer, Question *q, Answer *said)
{
    vec3 mirrored = ((vec3(*)(vec3, vec3))answer)(q->direction, q->normal);
    say_vec3(said, mirrored, 3e-9 * vec3_length(q->direction));
}

static void ask_highlight(AnyFunction *answer, Question *q, Answer *said)
{
    Color color = ((Color(*)(double, double, Color, vec3, vec3, vec3))answer)(
        q->ks, q->shine, q->brightness, q->normal, q->to_light, q->to_eye);
    say_vec3(said, color, 3e-9);
}

// Rounding decides on which side light along the surface arrives, or an eye sees it. If shine is 0,
// the power of a negative cosine, which counts as 0, is 1.
static bool is_right_of_highlight(const Question *q, const Answer *yours, const Answer *right)
{
    bool grazes = fabs(vec3_dot(q->normal, q->to_light)) <= 1e-9 * vec3_length(q->to_light) ||
                  fabs(vec3_dot(q->normal, q->to_eye)) <= 1e-9 * vec3_length(q->to_eye);
    return (grazes || q->shine == 0) && yours->count == right->count;
}

static double size_of(const Question *q)
{
    vec3 c = q->sphere.center;
    return q->sphere.radius + fmax(fabs(c[0]), fmax(fabs(c[1]), fabs(c[2])));
}

static void ask_start(AnyFunction *answer, Question *q, Answer *said)
{
    vec3 start = ((vec3(*)(Sphere, vec3, vec3))answer)(q->sphere, q->from, q->normal);
    vec3 offset = start - q->from;
    double size = size_of(q), length = vec3_length(offset);
    if (length > 0.9999 * 0x1p-32 * size && length < 1.0001 * 0x1p-28 * size) // all are as good
        offset *= 0x1p-30 * size / length;
    say_vec3(said, offset, 0x1p-40 * size);
}

static bool is_right_start(const Question *q, const Answer *yours, const Answer *right)
{
    if (yours->count != right->count)
        return false;
    vec3 offset = vec3_of(yours->number[0], yours->number[1], yours->number[2]);
    double size = size_of(q), length = vec3_length(offset), off = vec3_dot(offset, q->normal);
    double slack = 1e-6 + 1e-15 * vec3_length(q->from) / (0x1p-32 * size);
    return length >= (1 - slack) * 0x1p-32 * size && length <= (1 + slack) * 0x1p-28 * size &&
           off > 0 && vec3_length(offset - off * q->normal) < 1e-3 * length;
}

static void draw_bright(Question *q)
{
    q->color = draw_one_in(2) ? vec3_of(draw(-1, 3), draw(-1, 3), draw(-1, 3)) : draw_color();
    if (draw_one_in(3))
        q->color[draw_below(3)] = draw(-2, 4);
    if (draw_one_in(4))
        q->color[draw_below(3)] = draw_scale(1e-6, 1e6);
    if (draw_one_in(6))
        q->color[draw_below(3)] = 1 + draw(-1, 1) * draw_scale(1e-8, 1e-3);
}

static void ask_clamp(AnyFunction *answer, Question *q, Answer *said)
{
    say_vec3(said, ((Color(*)(Color))answer)(q->color), 3e-9);
}

static void draw_display(Question *q)
{
    static const double usual[] = {1, 2.2, 3, 2};
    q->color = draw_color();
    q->gamma = draw_one_in(2) ? usual[draw_below(4)] : draw_scale(0.2, 6);
}

static void ask_gamma(AnyFunction *answer, Question *q, Answer *said)
{
    say_vec3(said, ((Color(*)(Color, double))answer)(q->color, q->gamma), 3e-9);
}

const Subject subjects[] = {
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
    {"camera_from_vectors", 4000, draw_four_corners, ask_four_corners, is_right_of_vectors},
    {"camera_from_points", 4000, draw_points, ask_four_corners, is_right_of_points},
    {"camera_from_corner", 4000, draw_four_corners, ask_lower_left, is_right_of_corner},
    {"camera_from_look_at", 4000, draw_look_at, ask_look_at, is_right_of_look_at},
    {"to_object_coordinates", 1000, draw_ray, ask_object_ray, NULL},
    {"object_quadratic", 2000, draw_object_ray, ask_object_quadratic, NULL},
    {"world_quadratic", 2000, draw_meeting, ask_world_quadratic, NULL},
    {"quadratic_roots", 4000, draw_quadratic, ask_roots, NULL},
    {"sphere_roots", 4000, draw_ray, ask_sphere, NULL},
    {"hit_sphere", 4000, draw_ray, ask_hit, NULL},
    {"nearest_hit", 3000, draw_scene_ray, ask_nearest, NULL},
    {"cast_image_order", 300, draw_picture, ask_image_order, NULL},
    {"cast_object_order", 300, draw_picture, ask_object_order, NULL},
    {"visibility", 3000, draw_shadow, ask_visibility, NULL},
    {"shade", 2000, draw_hit, ask_shade, NULL},
    {"trace_ray", 1500, draw_depth, ask_trace, NULL},
    {"surface_normal", 1000, draw_point, ask_normal, NULL},
    {"ray_to_light", 1000, draw_point, ask_to_light, NULL},
    {"ambient_term", 1000, draw_surface, ask_ambient, NULL},
    {"diffuse_term", 2000, draw_surface, ask_diffuse, NULL},
    {"mirror_direction", 1500, draw_surface, ask_mirror, NULL},
    {"phong_term", 3000, draw_surface, ask_highlight, is_right_of_highlight},
    {"halfway_term", 3000, draw_halfway, ask_highlight, is_right_of_highlight},
    {"off_surface", 1000, draw_point, ask_start, is_right_start},
    {"clamp_color", 2000, draw_bright, ask_clamp, NULL},
    {"gamma_encode", 2000, draw_display, ask_gamma, NULL},
    {0},
};
