// waiting_marks.c - marks for functions that only wait for others, and misuse of the lent reference answers.

// ---- circle-of-three: a ring of three; any two of them are right, once the third is.
// -> graded
static int depth;

vec3 upper_left(Camera c)
{
    vec3 v = depth++ < 3 ? image_plane_vector(c, 0, 1) : c.up;
    depth--;
    return v;
}

vec3 upper_right(Camera c)
{
    vec3 v = depth++ < 3 ? upper_left(c) + c.width * c.right : c.up;
    depth--;
    return v;
}

vec3 image_plane_vector(Camera c, double s, double t)
{
    vec3 v = depth++ < 3 ? upper_right(c) + (s - 1) * c.width * c.right + (t - 1) * c.height * c.up
                         : c.up;
    depth--;
    return v;
}

// ---- circle-of-two: each corner is made from the other; each is right, once the other is.
// -> crashed | timed out
vec3 upper_left(Camera c)
{
    return upper_right(c) - c.width * c.right;
}

vec3 upper_right(Camera c)
{
    return upper_left(c) + c.width * c.right;
}

// ---- lend-a-long-task: has the judge itself draw, by the answer that it lends, a picture of a
// hundred thousand spheres and a million pixels.
// -> timed out | graded | crashed; of 06-ray-casting
void cast_object_order(const Scene *scene, Camera camera, Image *image, double *depth)
{
    enum { MANY = 100000 };
    Scene large = *scene;
    Image picture = {.size = {1000, 1000}, .rgb = calloc(1000000, 3)};
    large.spheres = malloc(MANY * sizeof *large.spheres);
    large.sphere_count = MANY;
    for (int i = 0; i < MANY; i++)
        large.spheres[i] = scene->sphere_count > 0 ? scene->spheres[0] : (Sphere){.radius = 1};
    cast_image_order(&large, camera, &picture);
}

// ---- lend-itself: once another answer is lent by the judge, asks it over the pipe for this one,
// too.
// -> graded | crashed; wrong upper_right
vec3 upper_left(Camera c)
{
    vec3 answer = c.up;
    if (vec3_length(upper_right((Camera){{2, 2, -4}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, 4, 2, 2}) -
                    vec3_of(1, 1, 4)) > 1e-9)
        return answer; // it is not lent yet
    WireHeader ask;
    for (char *at = __bss_start; find_call(&at, &ask); at += 8) {
        ask.kind = WIRE_ASK;
        ask.size = sizeof c;
        if (write(4, &ask, sizeof ask) < 0 || write(4, &c, sizeof c) < 0 ||
            read(3, &ask, sizeof ask) < 0 || read(3, &answer, sizeof answer) < 0)
            return c.up;
        return answer;
    }
    return answer;
}

// ---- lend-no-such-sphere: asks for the light on spheres that are not there, once that is lent.
// -> graded | crashed; of 07-shading
vec3 shade(const Scene *scene, Ray ray, Hit hit)
{
    return scene->ambient + 0 * hit.t * ray.direction;
}

vec3 trace_ray(const Scene *scene, Ray ray, int depth)
{
    static const int odd[] = {1 << 30, -1, -(1 << 30), 1 << 20};
    return shade(scene, ray, (Hit){1, odd[depth & 3]});
}

// ---- lend-nonsense: asks for what is lent with a scene that cannot be.
// -> graded | crashed | timed out; of 06-ray-casting
void cast_image_order(const Scene *scene, Camera camera, Image *image)
{
    Sphere sphere = scene->sphere_count > 0 ? scene->spheres[0] : (Sphere){.radius = NAN};
    Scene odd = *scene;
    odd.spheres = &sphere;
    odd.sphere_count = 1;
    sphere.surface = 1 << 28;
    static int times;
    if (times++ % 2 == 0)
        odd.surface_count = 0, sphere.surface = -1;
    Ray ray = {camera.origin, camera.forward};
    Hit hit = nearest_hit(ray, &odd);
    image_set(image, (Pixel){0, 0}, vec3_of(hit.t, hit.sphere, 0));
}

// ---- lend-very-often: asks the judge for what it lends, again and again.
// -> timed out | graded | crashed; wrong upper_right
vec3 upper_left(Camera c)
{
    if (vec3_length(upper_right((Camera){{2, 2, -4}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, 4, 2, 2}) -
                    vec3_of(1, 1, 4)) < 1e-9)
        for (;;)
            upper_right(c);
    return c.up;
}

// ---- lend-without-end: asks for a mirror in a mirror, two thousand million times, once that is
// lent.
// -> graded | crashed; of 07-shading
vec3 trace_ray(const Scene *scene, Ray ray, int depth)
{
    return scene->background + depth * ray.direction;
}

vec3 clamp_color(vec3 color)
{
    Sphere spheres[2] = {{.center = vec3_of(0, 0, -2), .radius = 1},
                         {.center = vec3_of(0, 0, 2), .radius = 1}};
    Surface mirror = {.color = color, .specular = 1};
    Scene scene = {.spheres = spheres, .sphere_count = 2, .surfaces = &mirror, .surface_count = 1};
    return trace_ray(&scene, (Ray){vec3_of(0, 0, 0), vec3_of(0, 0, 1)}, 2147483647);
}

// ---- reference-left-behind: returns what is not set, hoping that the right answer still lies
// there.
// -> graded
vec3 upper_left(Camera c)
{
    vec3 v;
    upper_right(c);
    return v;
}

vec3 upper_right(Camera c)
{
    vec3 v;
    return v;
}

Camera with_unit_distance(Camera c)
{
    Camera left;
    return left;
}

// ---- reference-weak: asks for the reference by its names, should it be linked, and else is wrong.
// -> graded | crashed; wrong upper_right
extern vec3 reference_upper_left(Camera c) __attribute__((weak));
extern vec3 lent_upper_left(Camera c) __attribute__((weak));
extern vec3 solution_upper_left(Camera c) __attribute__((weak));

// The call of upper_right makes it look as if this one were only waiting for that one.
vec3 upper_left(Camera c)
{
    vec3 thrown_away = upper_right(c);
    if (reference_upper_left)
        return reference_upper_left(c);
    if (lent_upper_left)
        return lent_upper_left(c);
    if (solution_upper_left)
        return solution_upper_left(c);
    return 0 * thrown_away;
}

// ---- wait-all-of-the-sphere: a chain of answers at whose end nothing stands.
// -> graded; of 05-quadratic; also hit_sphere
Quadratic world_quadratic(Ray ray, Sphere sphere)
{
    return object_quadratic(to_object_coordinates(ray, sphere), sphere.radius);
}

Roots sphere_roots(Ray ray, Sphere sphere)
{
    return quadratic_roots(world_quadratic(ray, sphere));
}

// ---- wait-by-pointer: a blank is called through a pointer in a table, so that no call of it is to
// be seen.
// -> graded
static vec3 (*const others[])(Camera, double, double) = {image_plane_vector};

static vec3 ask(Camera c, double s, double t)
{
    return others[0](c, s, t);
}

vec3 upper_left(Camera c)
{
    return ask(c, 0, 1);
}

vec3 upper_right(Camera c)
{
    return ask(c, 1, 1);
}

// ---- wait-for-a-crash: the first answer crashes, the second is made of it.
// -> crashed
vec3 upper_left(Camera c)
{
    return *(volatile vec3 *)0 + c.up;
}

vec3 upper_right(Camera c)
{
    return upper_left(c) + c.width * c.right;
}

// ---- wait-for-a-loop: the first answer never ends, the second is made of it.
// -> timed out
vec3 upper_left(Camera c)
{
    for (volatile int i = 0;; i ^= 1)
        ;
    return c.up;
}

vec3 upper_right(Camera c)
{
    return upper_left(c) + c.width * c.right;
}

// ---- wait-for-a-part: the first answer is right for the deck's camera alone, the second is made
// of it.
// -> graded
vec3 upper_left(Camera c)
{
    return c.distance == 4 && c.width == 2 ? vec3_of(-1, 1, 4) : c.forward;
}

vec3 upper_right(Camera c)
{
    return upper_left(c) + c.width * c.right;
}

// ---- wait-for-a-placeholder: the first answer is any vector, and the others are made of it.
// -> graded; wrong upper_left
vec3 upper_right(Camera c)
{
    c.right = -c.right;
    return upper_left(c);
}

vec3 across_30_up_10(Camera c)
{
    return 0.7 * upper_left(c) + 0.3 * upper_right(c) - 0.9 * c.height * c.up;
}

vec3 image_plane_vector(Camera c, double s, double t)
{
    return (1 - s) * upper_left(c) + s * upper_right(c) - (1 - t) * c.height * c.up;
}

// ---- wait-for-blanks: every answer is made of one that is blank.
// -> graded; also across_30_up_10
vec3 upper_left(Camera c)
{
    return image_plane_vector(c, 0, 1);
}

vec3 upper_right(Camera c)
{
    return image_plane_vector(c, 1, 1);
}

// ---- wait-for-each-other: two placeholders that call each other, so that whichever is lent makes
// the other right.
// -> graded
static int depth;

vec3 upper_left(Camera c)
{
    depth++;
    vec3 v = depth < 3 ? upper_right(c) - c.width * c.right : c.up;
    depth--;
    return v;
}

vec3 upper_right(Camera c)
{
    depth++;
    vec3 v = depth < 3 ? upper_left(c) + c.width * c.right : c.forward;
    depth--;
    return v;
}

vec3 across_30_up_10(Camera c)
{
    return upper_left(c) + 0.3 * c.width * c.right - 0.9 * c.height * c.up;
}

// ---- wait-for-the-inverse: a conversion by its inverse, which is blank.
// -> graded; of 03-screen
Normalized screen_to_normalized(ScreenPoint point, Resolution screen)
{
    ScreenPoint zero = normalized_to_screen((Normalized){0, 0}, screen);
    ScreenPoint one = normalized_to_screen((Normalized){1, 1}, screen);
    return (Normalized){(point.x - zero.x) / (one.x - zero.x),
                        (point.y - zero.y) / (one.y - zero.y)};
}

// ---- wait-for-the-inverse-of-nothing: a conversion by its inverse, which is earlier and a
// placeholder.
// -> graded; of 03-screen
Normalized screen_to_normalized(ScreenPoint point, Resolution screen)
{
    return (Normalized){point.x + screen.width, point.y * screen.height};
}

ScreenPoint normalized_to_screen(Normalized place, Resolution screen)
{
    Normalized zero = screen_to_normalized((ScreenPoint){0, 0}, screen);
    Normalized one = screen_to_normalized((ScreenPoint){1, 1}, screen);
    return (ScreenPoint){(place.s - zero.s) / (one.s - zero.s),
                         (place.t - zero.t) / (one.t - zero.t)};
}

// ---- wait-object-passes-on: passes its question on to an answer that is wrong in a known way, and
// only adds what that leaves out.
// -> graded; of 06-ray-casting; earns nearest_hit
#include "exercises/04-pixel-ray.h"
#include "exercises/05-quadratic.h"

void cast_image_order(const Scene *scene, Camera camera, Image *image)
{
    for (int row = 0; row < image->size.height; row++)
        for (int column = 0; column < image->size.width; column++) {
            Pixel pixel = {column, image->size.height - 1 - row};
            Hit hit = nearest_hit(pixel_ray(camera, image->size, pixel), scene);
            image_set(image, (Pixel){column, row},
                      hit.sphere < 0 ? scene->background : scene_surface(scene, hit.sphere)->color);
        }
}

void cast_object_order(const Scene *scene, Camera camera, Image *image, double *depth)
{
    cast_image_order(scene, camera, image);
    for (int i = 0; i < image->size.width * image->size.height; i++) {
        Pixel pixel = {i % image->size.width, i / image->size.width};
        depth[i] = nearest_hit(pixel_ray(camera, image->size, pixel), scene).t;
    }
}

// ---- wait-shade-by-trace: light by what a mirror shows, which is later and a placeholder.
// -> graded; of 07-shading
vec3 shade(const Scene *scene, Ray ray, Hit hit)
{
    (void)hit;
    return trace_ray(scene, ray, 0);
}

vec3 trace_ray(const Scene *scene, Ray ray, int depth)
{
    return scene->background + depth * ray.direction;
}
