// light_steps_lanes.c - the steps of paths by the formulas of the solutions, many at a time.
//
// Each loop has the operations of a function of solutions/, in the same order. This file is
// compiled without fused multiplications (Makefile), as the solutions are.
#include "chapters/08-fast/engines/light.h"

// The last vector of an array is always computed as a whole, so that no loop has a remainder.
static inline int padded(int count)
{
    enum { VECTOR = 8 };
    return (count + VECTOR - 1) / VECTOR * VECTOR;
}

// Of two numbers; only the first may be NaN.
static inline double at_least(double x, double least)
{
    return x > least ? x : least;
}

static void rays(const LightWorld *world, const int *columns, const int *rows, Paths *paths)
{
    const Camera *c = &world->camera;
    const double wide = world->samples.width, high = world->samples.height;
    const double width = c->width, height = c->height;
    const Vector from = {c->origin[0], c->origin[1], c->origin[2]};
    const Vector r = {c->right[0], c->right[1], c->right[2]}, u = {c->up[0], c->up[1], c->up[2]};
    const Vector f = times(c->distance, (Vector){c->forward[0], c->forward[1], c->forward[2]});
    const int count = padded(paths->count);
#pragma omp simd
    for (int i = 0; i < count; i++) {
        double s = (columns[i] + 0.5) / wide, t = 1 - (rows[i] + 0.5) / high;
        double right = (s - 0.5) * width, up = (t - 0.5) * height;
        put(&paths->origin, i, from);
        put(&paths->direction, i, plus(plus(f, times(right, r)), times(up, u)));
    }
}

// solutions/05-quadratic.c: roots_near_origin, and hit_sphere.
static bool hits(Paths *paths)
{
    const double least = 0x1p-400, most = 0x1p400;
    int extreme = 0, count = paths->count;
#pragma omp simd reduction(| : extreme)
    for (int i = 0; i < count; i++) {
        Vector v = get(&paths->direction, i);
        Vector p = minus(get(&paths->origin, i), get(&paths->center, i));
        double r = paths->radius[i], rr = r * r, a = dot(v, v), pp = dot(p, p);
        extreme |= !((a > least) & (a < most) & (pp + rr > least) & (pp + rr < most));
        double half_b = dot(p, v), back = half_b / a;
        Vector q = minus(p, times(back, v));
        double ll = dot(q, q), root = sqrt(ll);
        double l = root < r ? root : r, distance = sqrt(pp);
        double c = (distance - r) * (distance + r);
        double sum = -(half_b + copysign(sqrt(a * (r - l) * (r + l)), half_b));
        double t = sum / a, u = c / sum;
        double first = t <= u ? t : u, second = t <= u ? u : t;
        double hit = first > 0 ? first : second > 0 ? second : INFINITY;
        paths->t[i] = ((ll <= rr) & (sum != 0)) ? hit : INFINITY;
    }
    return extreme == 0;
}

// solutions/07-shading.c: normal_at, offset_from_surface, mirror_direction.
static void leave(Paths *paths)
{
    const int count = padded(paths->count);
#pragma omp simd
    for (int i = 0; i < count; i++) {
        Vector v = get(&paths->direction, i), c = get(&paths->center, i);
        Vector point = plus(get(&paths->origin, i), times(paths->t[i], v));
        Vector n = unit(minus(point, c));
        bool turn = dot(n, v) > 0;
        n = (Vector){turn ? -n.x : n.x, turn ? -n.y : n.y, turn ? -n.z : n.z};
        double size = paths->radius[i] + at_least(fabs(c.x), at_least(fabs(c.y), fabs(c.z)));
        put(&paths->point, i, point);
        put(&paths->normal, i, n);
        put(&paths->start, i, plus(point, times(0x1p-30 * size, n)));
        put(&paths->mirrored, i, minus(v, times(2 * dot(v, n), n)));
    }
}

static void to_light(const Paths *paths, const Light *light, Vectors *directions)
{
    const Vector at = {light->position[0], light->position[1], light->position[2]};
    const bool distant = light->kind == LIGHT_DISTANT;
    const int count = padded(paths->count);
#pragma omp simd
    for (int i = 0; i < count; i++) {
        Vector way = minus(at, get(&paths->start, i));
        put(directions, i,
            (Vector){distant ? at.x : way.x, distant ? at.y : way.y, distant ? at.z : way.z});
    }
}

// The numbers of the surfaces that shade needs, and the directions back to the eye.
typedef struct {
    Vectors color, eye;
    alignas(64) double diffuse[PATHS], specular[PATHS], shine[PATHS];
    // Of one light: the diffuse part, and the highlight's cosine and then its power; -1 for none.
    double reflected[PATHS], highlight[PATHS];
} Shading;

// The surfaces' numbers; the colors begin with the ambient term.
static void shading_of(const Scene *scene, const Paths *paths, Shading *shading, Vectors *colors)
{
    const double red = scene->ambient[0], green = scene->ambient[1], blue = scene->ambient[2];
    for (int i = 0; i < paths->count; i++) {
        const Surface *from = &scene->surfaces[paths->surface[i]];
        const Vector color = {from->color[0], from->color[1], from->color[2]};
        const double kd = shading->diffuse[i] = from->diffuse;
        shading->specular[i] = from->specular;
        shading->shine[i] = from->shine;
        put(&shading->color, i, color);
        put(colors, i, (Vector){kd * color.x * red, kd * color.y * green, kd * color.z * blue});
    }
    const int count = padded(paths->count);
#pragma omp simd
    for (int i = 0; i < count; i++)
        put(&shading->eye, i, unit(times(-1, get(&paths->direction, i))));
}

// The cosines of diffuse_term and of phong_term.
static void cosines(const Paths *paths, const Light *light, const double *lit, Shading *shading)
{
    const Vector at = {light->position[0], light->position[1], light->position[2]};
    const bool distant = light->kind == LIGHT_DISTANT;
    const int count = padded(paths->count);
#pragma omp simd
    for (int i = 0; i < count; i++) {
        Vector n = get(&paths->normal, i), way = minus(at, get(&paths->point, i));
        Vector v = {distant ? at.x : way.x, distant ? at.y : way.y, distant ? at.z : way.z};
        shading->reflected[i] = shading->diffuse[i] * at_least(dot(n, unit(v)), 0);
        Vector back = {-v.x, -v.y, -v.z};
        Vector mirrored = minus(back, times(2 * dot(back, n), n));
        double shine = dot(unit(mirrored), get(&shading->eye, i));
        bool shines = (lit[i] != 0) & (dot(n, v) > 0) & (shine > 0);
        shading->highlight[i] = shines ? shine : -1;
    }
}

static void add_light(const Light *light, const double *lit, int count, const Shading *shading,
                      Vectors *colors)
{
    const double red = light->color[0], green = light->color[1], blue = light->color[2];
    const int all = padded(count);
#pragma omp simd
    for (int i = 0; i < all; i++) {
        double part = shading->reflected[i], power = shading->highlight[i];
        double bright = shading->specular[i] * power;
        Vector old = get(colors, i), own = get(&shading->color, i);
        Vector sum = {old.x + part * own.x * red + (power < 0 ? 0 : bright * red),
                      old.y + part * own.y * green + (power < 0 ? 0 : bright * green),
                      old.z + part * own.z * blue + (power < 0 ? 0 : bright * blue)};
        bool arrives = lit[i] != 0;
        put(colors, i,
            (Vector){arrives ? sum.x : old.x, arrives ? sum.y : old.y, arrives ? sum.z : old.z});
    }
}

// solutions/07-shading.c: shade. There are no vectors for pow, so only the paths that need it call
// it.
static void shade(const Scene *scene, const Paths *paths, const double *lit, Vectors *colors)
{
    Shading shading;
    shading_of(scene, paths, &shading, colors);
    for (int k = 0; k < scene->light_count; k++, lit += PATHS) {
        cosines(paths, &scene->lights[k], lit, &shading);
        for (int i = 0; i < paths->count; i++)
            if (shading.highlight[i] > 0)
                shading.highlight[i] = pow(shading.highlight[i], shading.shine[i]);
        add_light(&scene->lights[k], lit, paths->count, &shading, colors);
    }
}

static void add_clamped(const Vectors *colors, const int *places, int count, Vectors *sums)
{
    for (int i = 0; i < count; i++) {
        double red = at_least(colors->x[i], 0), green = at_least(colors->y[i], 0);
        double blue = at_least(colors->z[i], 0);
        sums->x[places[i]] += red < 1 ? red : 1;
        sums->y[places[i]] += green < 1 ? green : 1;
        sums->z[places[i]] += blue < 1 ? blue : 1;
    }
}

const LightSteps LANES(light_steps) = {rays, hits, leave, to_light, shade, add_clamped};
