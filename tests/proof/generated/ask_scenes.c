// ask_scenes.c - questions of exercise 06, and of 07 if a whole scene is an argument.
#include "tests/proof/generated/question.h"

#include "tests/judge/wire.h"

#include <stdlib.h>

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

const Subject scene_subjects[] = {
    {"nearest_hit", 3000, draw_scene_ray, ask_nearest, NULL},
    {"cast_image_order", 300, draw_picture, ask_image_order, NULL},
    {"cast_object_order", 300, draw_picture, ask_object_order, NULL},
    {"visibility", 3000, draw_shadow, ask_visibility, NULL},
    {"shade", 2000, draw_hit, ask_shade, NULL},
    {"trace_ray", 1500, draw_depth, ask_trace, NULL},
    {0},
};
