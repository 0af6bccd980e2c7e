// ask_spheres.c - questions of exercise 05: rays and spheres, equations and their roots.
#include "tests/proof/generated/question.h"

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

static double step(const Question *q)
{
    return 2e-6 * q->sphere.radius / vec3_length(q->ray.direction);
}

static void ask_sphere(AnyFunction *answer, Question *q, Answer *said)
{
    say_roots(said, ((Roots(*)(Ray, Sphere))answer)(q->ray, q->sphere), step(q));
}

static void ask_hit(AnyFunction *answer, Question *q, Answer *said)
{
    say(said, ((double (*)(Ray, Sphere))answer)(q->ray, q->sphere), step(q));
}

const Subject sphere_subjects[] = {
    {"to_object_coordinates", 1000, draw_ray, ask_object_ray, NULL},
    {"object_quadratic", 2000, draw_object_ray, ask_object_quadratic, NULL},
    {"world_quadratic", 2000, draw_meeting, ask_world_quadratic, NULL},
    {"quadratic_roots", 4000, draw_quadratic, ask_roots, NULL},
    {"sphere_roots", 4000, draw_ray, ask_sphere, NULL},
    {"hit_sphere", 4000, draw_ray, ask_hit, NULL},
    {0},
};
