// ask_cameras.c - questions of exercise 02: which descriptions are valid cameras.
#include "tests/proof/generated/question.h"

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
static void draw_rectangle(Question *q)
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
    draw_rectangle(q);
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

static void ask_rectangle(AnyFunction *answer, Question *q, Answer *said)
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

const Subject camera_subjects[] = {
    {"camera_from_vectors", 4000, draw_rectangle, ask_rectangle, is_right_of_vectors},
    {"camera_from_points", 4000, draw_points, ask_rectangle, is_right_of_points},
    {"camera_from_corner", 4000, draw_rectangle, ask_lower_left, is_right_of_corner},
    {"camera_from_look_at", 4000, draw_look_at, ask_look_at, is_right_of_look_at},
    {0},
};
