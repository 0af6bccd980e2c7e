// ask_lights.c - questions of exercise 07: normals, terms of light, colours.
#include "tests/proof/generated/question.h"

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

// The halfway vector exists wherever the eye is.
static void draw_halfway(Question *q)
{
    draw_surface(q);
    if (draw_one_in(4))
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

// Rounding decides on which side light along the surface arrives. If shine is 0, the power of a
// negative cosine, which counts as 0, is 1.
static bool is_right_of_highlight(const Question *q, const Answer *yours, const Answer *right)
{
    bool grazes = fabs(vec3_dot(q->normal, q->to_light)) <= 1e-9 * vec3_length(q->to_light);
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
    say_vec3(said, start - q->from, 0x1p-40 * size_of(q));
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

const Subject light_subjects[] = {
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
