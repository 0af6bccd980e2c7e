// light_steps_lanes.c - the steps of paths by the formulas of the solutions, many at a time.
//
// Each loop has the operations of a function of solutions/, in the same order. This file is
// compiled without fused multiplications (Makefile), as the solutions are.
#include "chapters/08-fast/engines/light_steps.h"

#include <math.h>

// The last vector of an array is always computed as a whole, so that no loop has a remainder.
enum { VECTOR = 8 };

static inline int padded(int count)
{
    return (count + VECTOR - 1) / VECTOR * VECTOR;
}

static inline double dot(double x, double y, double z, double u, double v, double w)
{
    return x * u + y * v + z * w;
}

// Of two numbers; only the first may be NaN.
static inline double at_least(double x, double least)
{
    return x > least ? x : least;
}

static void rays(const Picture *picture, const int *columns, const int *rows, Paths *paths)
{
    const Camera *c = &picture->camera;
    double wide = picture->samples.width, high = picture->samples.height;
    double x = c->origin[0], y = c->origin[1], z = c->origin[2];
    double fx = c->distance * c->forward[0], fy = c->distance * c->forward[1];
    double fz = c->distance * c->forward[2];
    double rx = c->right[0], ry = c->right[1], rz = c->right[2];
    double ux = c->up[0], uy = c->up[1], uz = c->up[2];
    double width = c->width, height = c->height;
    int count = padded(paths->count);
#pragma omp simd
    for (int i = 0; i < count; i++) {
        double s = (columns[i] + 0.5) / wide, t = 1 - (rows[i] + 0.5) / high;
        double right = (s - 0.5) * width, up = (t - 0.5) * height;
        paths->origin.x[i] = x;
        paths->origin.y[i] = y;
        paths->origin.z[i] = z;
        paths->direction.x[i] = fx + right * rx + up * ux;
        paths->direction.y[i] = fy + right * ry + up * uy;
        paths->direction.z[i] = fz + right * rz + up * uz;
    }
}

// The margin is many times the rounding error of the numbers that are subtracted.
static void may_hit(const Paths *paths, const double *spheres, int sphere_count, int *may)
{
    const double margin = 1e-12;
    int count = padded(paths->count);
    for (int i = 0; i < count; i++)
        may[i] = 0;
    for (int sphere = 0; sphere < sphere_count; sphere++, spheres += 4) {
        double cx = spheres[0], cy = spheres[1], cz = spheres[2], r = spheres[3];
        int bit = 1 << sphere;
#pragma omp simd
        for (int i = 0; i < count; i++) {
            double x = paths->direction.x[i], y = paths->direction.y[i], z = paths->direction.z[i];
            double px = cx - paths->origin.x[i], py = cy - paths->origin.y[i];
            double pz = cz - paths->origin.z[i];
            double a = dot(x, y, z, x, y, z), pp = dot(px, py, pz, px, py, pz);
            double ahead = dot(px, py, pz, x, y, z), outside = pp - r * r - margin * (pp + r * r);
            bool misses = (outside > 0) & ((ahead < 0) | (ahead * ahead < a * outside));
            may[i] |= misses ? 0 : bit;
        }
    }
}

// solutions/05-quadratic.c: roots_near_origin, and hit_sphere.
static bool hits(Paths *paths)
{
    const double least = 0x1p-400, most = 0x1p400;
    int extreme = 0, count = paths->count;
#pragma omp simd reduction(| : extreme)
    for (int i = 0; i < count; i++) {
        double x = paths->direction.x[i], y = paths->direction.y[i], z = paths->direction.z[i];
        double px = paths->origin.x[i] - paths->center.x[i];
        double py = paths->origin.y[i] - paths->center.y[i];
        double pz = paths->origin.z[i] - paths->center.z[i];
        double r = paths->radius[i], rr = r * r;
        double a = dot(x, y, z, x, y, z), pp = dot(px, py, pz, px, py, pz);
        extreme |= !((a > least) & (a < most) & (pp + rr > least) & (pp + rr < most));
        double half_b = dot(px, py, pz, x, y, z), back = half_b / a;
        double qx = px - back * x, qy = py - back * y, qz = pz - back * z;
        double ll = dot(qx, qy, qz, qx, qy, qz), root = sqrt(ll);
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

// solutions/07-shading.c: normal_at, off_surface.
static void leave(Paths *paths)
{
    int count = padded(paths->count);
#pragma omp simd
    for (int i = 0; i < count; i++) {
        double dx = paths->direction.x[i], dy = paths->direction.y[i];
        double dz = paths->direction.z[i], t = paths->t[i];
        double x = paths->origin.x[i] + t * dx, y = paths->origin.y[i] + t * dy;
        double z = paths->origin.z[i] + t * dz;
        double cx = paths->center.x[i], cy = paths->center.y[i], cz = paths->center.z[i];
        double nx = x - cx, ny = y - cy, nz = z - cz;
        double length = sqrt(dot(nx, ny, nz, nx, ny, nz));
        nx /= length;
        ny /= length;
        nz /= length;
        bool turn = dot(nx, ny, nz, dx, dy, dz) > 0;
        nx = turn ? -nx : nx;
        ny = turn ? -ny : ny;
        nz = turn ? -nz : nz;
        double size = paths->radius[i] + at_least(fabs(cx), at_least(fabs(cy), fabs(cz)));
        double off = 0x1p-30 * size;
        paths->point.x[i] = x;
        paths->point.y[i] = y;
        paths->point.z[i] = z;
        paths->normal.x[i] = nx;
        paths->normal.y[i] = ny;
        paths->normal.z[i] = nz;
        paths->start.x[i] = x + off * nx;
        paths->start.y[i] = y + off * ny;
        paths->start.z[i] = z + off * nz;
    }
}

static void to_light(const Paths *paths, const Light *light, Vectors *directions)
{
    double x = light->position[0], y = light->position[1], z = light->position[2];
    int count = padded(paths->count);
    if (light->kind == LIGHT_DISTANT) {
        for (int i = 0; i < count; i++) {
            directions->x[i] = x;
            directions->y[i] = y;
            directions->z[i] = z;
        }
        return;
    }
#pragma omp simd
    for (int i = 0; i < count; i++) {
        directions->x[i] = x - paths->start.x[i];
        directions->y[i] = y - paths->start.y[i];
        directions->z[i] = z - paths->start.z[i];
    }
}

// The numbers of the surfaces that shade needs, and the directions back to the eye.
typedef struct {
    Vectors color, eye;
    alignas(64) double diffuse[PATHS], specular[PATHS], shine[PATHS];
    // Of one light: the diffuse part, and the highlight's cosine and then its power; -1 for none.
    double reflected[PATHS], highlight[PATHS];
} Shading;

static inline void set_material(Shading *shading, Vectors *colors, int i, Material material)
{
    shading->color.x[i] = material.color[0];
    shading->color.y[i] = material.color[1];
    shading->color.z[i] = material.color[2];
    shading->diffuse[i] = material.diffuse;
    shading->specular[i] = material.specular;
    shading->shine[i] = material.shine;
    colors->x[i] = material.ambient[0];
    colors->y[i] = material.ambient[1];
    colors->z[i] = material.ambient[2];
}

// Often all paths of a vector have the same surface.
static void shading_of(const Picture *picture, const Paths *paths, Shading *shading,
                       Vectors *colors)
{
    for (int first = 0; first < paths->count; first += VECTOR) {
        const int *surface = &paths->surface[first];
        int some = paths->count - first < VECTOR ? paths->count - first : VECTOR, others = 0;
        for (int i = 1; i < some; i++)
            others |= surface[i] ^ surface[0];
        const Material material = picture->materials[surface[0]];
        if (others == 0) {
#pragma omp simd
            for (int i = 0; i < VECTOR; i++)
                set_material(shading, colors, first + i, material);
            continue;
        }
        for (int i = 0; i < some; i++)
            set_material(shading, colors, first + i, picture->materials[surface[i]]);
    }
    int count = padded(paths->count);
#pragma omp simd
    for (int i = 0; i < count; i++) {
        double x = -paths->direction.x[i], y = -paths->direction.y[i], z = -paths->direction.z[i];
        double length = sqrt(dot(x, y, z, x, y, z));
        shading->eye.x[i] = x / length;
        shading->eye.y[i] = y / length;
        shading->eye.z[i] = z / length;
    }
}

// The cosines of diffuse_term and of phong_term, for one vector of paths.
static inline void cosines(const Paths *paths, int first, const Light *light, const double *lit,
                           Shading *shading)
{
    double from = light->kind == LIGHT_DISTANT ? 0 : 1;
    double at_x = light->position[0], at_y = light->position[1], at_z = light->position[2];
#pragma omp simd
    for (int i = first; i < first + VECTOR; i++) {
        double nx = paths->normal.x[i], ny = paths->normal.y[i], nz = paths->normal.z[i];
        double x = from != 0 ? at_x - paths->point.x[i] : at_x;
        double y = from != 0 ? at_y - paths->point.y[i] : at_y;
        double z = from != 0 ? at_z - paths->point.z[i] : at_z;
        double length = sqrt(dot(x, y, z, x, y, z));
        double cosine = dot(nx, ny, nz, x / length, y / length, z / length);
        shading->reflected[i] = shading->diffuse[i] * at_least(cosine, 0);
        double twice = 2 * dot(-x, -y, -z, nx, ny, nz);
        double mx = -x - twice * nx, my = -y - twice * ny, mz = -z - twice * nz;
        double size = sqrt(dot(mx, my, mz, mx, my, mz));
        double shine = dot(mx / size, my / size, mz / size, shading->eye.x[i], shading->eye.y[i],
                           shading->eye.z[i]);
        bool shines = (lit[i] != 0) & (dot(nx, ny, nz, x, y, z) > 0) & (shine > 0);
        shading->highlight[i] = shines ? shine : -1;
    }
}

static inline void add_light(int first, const Light *light, const double *lit,
                             const Shading *shading, Vectors *colors)
{
    double red = light->color[0], green = light->color[1], blue = light->color[2];
#pragma omp simd
    for (int i = first; i < first + VECTOR; i++) {
        double part = shading->reflected[i], power = shading->highlight[i];
        double bright = shading->specular[i] * power;
        double r = colors->x[i], g = colors->y[i], b = colors->z[i];
        double lit_r = r + part * shading->color.x[i] * red + (power < 0 ? 0 : bright * red);
        double lit_g = g + part * shading->color.y[i] * green + (power < 0 ? 0 : bright * green);
        double lit_b = b + part * shading->color.z[i] * blue + (power < 0 ? 0 : bright * blue);
        colors->x[i] = lit[i] != 0 ? lit_r : r;
        colors->y[i] = lit[i] != 0 ? lit_g : g;
        colors->z[i] = lit[i] != 0 ? lit_b : b;
    }
}

// Where the vectors begin in which the light arrives at any path.
static int lit_vectors(const double *lit, int count, int *firsts)
{
    int lit_count = 0;
    for (int first = 0; first < count; first += VECTOR) {
        int any = 0;
        for (int i = first; i < first + VECTOR; i++)
            any |= lit[i] != 0;
        firsts[lit_count] = first;
        lit_count += any;
    }
    return lit_count;
}

// solutions/07-shading.c: shade. There are no vectors for pow, so only the paths that need it call
// it.
static void shade(const Picture *picture, const Paths *paths, const double *lit, Vectors *colors)
{
    Shading shading;
    int firsts[PATHS / VECTOR];
    shading_of(picture, paths, &shading, colors);
    for (int k = 0; k < picture->scene->light_count; k++, lit += PATHS) {
        const Light *light = &picture->scene->lights[k];
        int vectors = lit_vectors(lit, paths->count, firsts);
        for (int i = 0; i < vectors; i++)
            cosines(paths, firsts[i], light, lit, &shading);
        for (int i = 0; i < vectors * VECTOR; i++) {
            int path = firsts[i / VECTOR] + i % VECTOR;
            if (shading.highlight[path] > 0 && path < paths->count)
                shading.highlight[path] = pow(shading.highlight[path], shading.shine[path]);
        }
        for (int i = 0; i < vectors; i++)
            add_light(firsts[i], light, lit, &shading, colors);
    }
}

static void mirror(const Paths *paths, Vectors *directions)
{
    int count = padded(paths->count);
#pragma omp simd
    for (int i = 0; i < count; i++) {
        double x = paths->direction.x[i], y = paths->direction.y[i], z = paths->direction.z[i];
        double nx = paths->normal.x[i], ny = paths->normal.y[i], nz = paths->normal.z[i];
        double twice = 2 * dot(x, y, z, nx, ny, nz);
        directions->x[i] = x - twice * nx;
        directions->y[i] = y - twice * ny;
        directions->z[i] = z - twice * nz;
    }
}

static void add_mirrors(const Vectors *mirrored, const double *parts, int count, Vectors *colors)
{
    int all = padded(count);
#pragma omp simd
    for (int i = 0; i < all; i++) {
        double x = colors->x[i], y = colors->y[i], z = colors->z[i], part = parts[i];
        colors->x[i] = part > 0 ? x + part * mirrored->x[i] : x;
        colors->y[i] = part > 0 ? y + part * mirrored->y[i] : y;
        colors->z[i] = part > 0 ? z + part * mirrored->z[i] : z;
    }
}

static inline void mean(const double *color, int samples, int pixels, double *means)
{
    int count = padded(pixels);
    for (int k = 0; k < count; k++)
        means[k] = 0;
    for (int i = 0; i < samples; i++, color += PATHS) {
#pragma omp simd
        for (int k = 0; k < count; k++) {
            double c = at_least(color[k], 0);
            means[k] += c < 1 ? c : 1;
        }
    }
    if (samples == 1)
        return;
#pragma omp simd
    for (int k = 0; k < count; k++)
        means[k] /= samples;
}

static void means(double *const colors[3], int samples, int pixels, Vectors *means)
{
    mean(colors[0], samples, pixels, means->x);
    mean(colors[1], samples, pixels, means->y);
    mean(colors[2], samples, pixels, means->z);
}

// round(255 c), halves up. c - floor(c) is exact. Two loops, because a compiler makes no vectors of
// one that treats 0 and 1 as special cases.
static inline void bytes_of(const double *colors, int count, int *bytes)
{
    double clamped[PATHS];
#pragma omp simd
    for (int i = 0; i < count; i++) {
        double c = at_least(colors[i], 0);
        clamped[i] = c < 1 ? c : 1;
    }
#pragma omp simd
    for (int i = 0; i < count; i++) {
        double x = 255 * clamped[i];
        int whole = (int)x;
        bytes[i] = whole + (x - whole >= 0.5);
    }
}

static void bytes(const Vectors *colors, int count, uint8_t *rgb)
{
    int red[PATHS], green[PATHS], blue[PATHS];
    bytes_of(colors->x, padded(count), red);
    bytes_of(colors->y, padded(count), green);
    bytes_of(colors->z, padded(count), blue);
    for (int i = 0; i < count; i++) {
        rgb[3 * i] = (uint8_t)red[i];
        rgb[3 * i + 1] = (uint8_t)green[i];
        rgb[3 * i + 2] = (uint8_t)blue[i];
    }
}

const LightSteps LANES(light_steps) = {rays,  may_hit, hits,        leave, to_light,
                                       shade, mirror,  add_mirrors, means, bytes};
