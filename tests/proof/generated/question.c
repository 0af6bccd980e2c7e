// question.c - random numbers for questions, and answers as plain numbers.
#include "tests/proof/generated/question.h"

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

double draw(double low, double high)
{
    return low + (high - low) * next();
}

int draw_below(int limit)
{
    return (int)(next() * limit);
}

bool draw_one_in(int n)
{
    return draw_below(n) == 0;
}

double draw_scale(double low, double high)
{
    return exp(draw(log(low), log(high)));
}

double draw_any_size(void)
{
    return draw_one_in(3) ? draw_scale(1e-6, 1e6) : 1;
}

vec3 draw_vec3(double size)
{
    double x = draw(-size, size), y = draw(-size, size);
    return vec3_of(x, y, draw(-size, size));
}

vec3 draw_unit(void)
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

vec3 draw_color(void)
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

Camera draw_camera(double size)
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

Sphere draw_sphere(double size, vec3 near)
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

void say(Answer *said, double number, double tolerance)
{
    if (said->count == MOST_NUMBERS)
        return;
    said->number[said->count] = number;
    said->tolerance[said->count++] = tolerance;
}

void say_vec3(Answer *said, vec3 v, double tolerance)
{
    for (int i = 0; i < 3; i++)
        say(said, v[i], tolerance);
}

void say_camera(Answer *said, Camera camera, const Question *question)
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
