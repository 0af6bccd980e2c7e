// shading_scenes.c - scenes that are awkward to light.
#include "tests/house/engines/test_scenes.h"

#include "chapters/shared/scene_camera.h"
#include "exercises/04-pixel-ray.h"
#include "exercises/06-ray-casting.h"
#include "exercises/07-shading.h"

#include <stddef.h>

// MOST spheres of random scenes; there is room for more.
enum { MOST = 120, ROOM = 1200, LIGHTS = 3 };

static Sphere spheres[ROOM];
static Surface surfaces[ROOM];
static Light lights[LIGHTS];
Scene lit_scene = {.spheres = spheres, .surfaces = surfaces, .lights = lights};
int lit_depth;

// Every sphere has a colour of its own, so that one taken for another shows; two of three mirror.
static void add(vec3 center, double radius)
{
    int i = lit_scene.sphere_count;
    if (i == ROOM)
        return;
    Color color = vec3_of((i % 7 + 1) / 7.0, (i / 7 % 7 + 1) / 7.0, (i / 49 % 9 + 1) / 9.0);
    surfaces[i] = (Surface){.color = color, .diffuse = 0.5, .specular = i % 3 / 3.0, .shine = 7};
    spheres[i] = (Sphere){center, radius, i};
    lit_scene.sphere_count = lit_scene.surface_count = i + 1;
}

static void light_up(vec3 position, LightKind kind)
{
    int i = lit_scene.light_count++;
    lights[i] = (Light){position, vec3_of(0.7 - 0.2 * i, 0.5, 0.3 + 0.2 * i), kind};
}

static void look_from(vec3 from, vec3 at, double angle)
{
    lit_scene.sphere_count = lit_scene.surface_count = lit_scene.light_count = 0;
    lit_scene.view = (Viewpoint){from, at, vec3_of(0, 1, 0), angle, {31, 23}};
    lit_scene.background = vec3_of(0.1, 0.2, 0.3);
    lit_scene.ambient = vec3_of(0.1, 0.1, 0.1);
    lit_depth = 5;
}

static void heap(vec3 at, double size, int count, double radius)
{
    for (int i = 0; i < count; i++)
        add(at + within(size), radius * uniform(0.3, 1));
}

static const vec3 front = {0, 0, 5}, middle = {0, 0, 0}, above = {3, 9, 6};

static void nothing(void)
{
    look_from(front, middle, 60);
    light_up(above, LIGHT_POINT);
}
static void no_light(void)
{
    look_from(front, middle, 60);
    heap(middle, 1.5, 30, 0.5);
}
static void inside(void)
{
    look_from(front, middle, 90);
    light_up(above, LIGHT_POINT);
    light_up(vec3_of(1, 1, 3), LIGHT_POINT);
    add(middle, 30);
    add(front, 1);
    add(front, 2);
    heap(middle, 4, 30, 1);
}
static void tangent(void)
{
    look_from(front, middle, 70);
    light_up(vec3_of(0, 1, 0), LIGHT_DISTANT);
    light_up(vec3_of(0, 4, 0), LIGHT_POINT);
    for (int i = 0; i < 64; i++) {
        int column = i % 4, row = i / 4 % 4, layer = i / 16;
        add(vec3_of(column - 1.5, row - 1.5, -layer), 0.5);
    }
}
static void coincident(void)
{
    look_from(front, middle, 60);
    light_up(above, LIGHT_POINT);
    light_up(vec3_of(-2, 1, 1), LIGHT_DISTANT);
    // The lower of two indices counts, whichever of the two the hierarchy meets first.
    vec3 there[12];
    for (int i = 0; i < 72; i++) {
        if (i < 12)
            there[i] = within(1.5);
        add(there[i % 12], 0.7);
    }
}
static void facing_mirrors(void)
{
    look_from(vec3_of(0, 0.3, 1), vec3_of(0, 0, -3), 80);
    light_up(vec3_of(0.3, 1.5, 0), LIGHT_POINT);
    for (int i = 0; i < 6; i++)
        add(vec3_of(0, 0, i % 2 == 0 ? -1003 : 1003), 1000);
    heap(middle, 2, 20, 0.4);
}
static void light_in_a_sphere(void)
{
    look_from(front, middle, 60);
    light_up(vec3_of(0.5, 0.5, 0), LIGHT_POINT);
    light_up(above, LIGHT_POINT);
    add(vec3_of(0.5, 0.5, 0), 0.4);
    add(above, 30);
    heap(middle, 2, 30, 0.6);
}
// Spheres smaller than the steps between the numbers of their places, so a point on one is its
// centre, and has no normal.
static void smaller_than_rounding(void)
{
    vec3 there = vec3_of(1e5, -2e5, 1e5);
    look_from(there + 1e-9 * front, there, 1);
    light_up(there + 1e-6 * above, LIGHT_POINT);
    light_up(above, LIGHT_DISTANT);
    for (int i = 0; i < 60; i++)
        add(there + within(5e-11), 3e-12);
}

// The ray that leaves the surface seen by a pixel; NaN if the pixel's ray meets nothing.
static Ray leaves_at(Pixel pixel)
{
    Camera camera;
    scene_camera(&lit_scene.view, lit_scene.view.resolution, &camera);
    Ray ray = pixel_ray(camera, lit_scene.view.resolution, pixel);
    Hit hit = nearest_hit(ray, &lit_scene);
    if (hit.sphere < 0)
        return (Ray){vec3_of(NAN, NAN, NAN), ray.direction};
    vec3 point = ray.origin + hit.t * ray.direction;
    vec3 normal = surface_normal(spheres[hit.sphere], point);
    return (Ray){offset_from_surface(spheres[hit.sphere], point, normal),
                 mirror_direction(ray.direction, normal)};
}

static void light_on_a_surface(void)
{
    look_from(front, middle, 60);
    add(middle, 1);
    add(vec3_of(2, 0, 0), 1);
    add(vec3_of(0, 2.25, 0), 0.25);
    light_up(vec3_of(1, 0, 0), LIGHT_POINT);
    light_up(vec3_of(0, 2, 0), LIGHT_POINT);
    // A light at the very place from which it is looked for.
    light_up(leaves_at((Pixel){15, 11}).origin, LIGHT_POINT);
}
static void far_from_the_origin(void)
{
    vec3 there = vec3_of(1e7, -3e7, 2e7);
    look_from(there + front, there, 60);
    light_up(there + above, LIGHT_POINT);
    light_up(middle, LIGHT_POINT);
    light_up(above, LIGHT_DISTANT);
    heap(there, 2, 50, 0.6);
}
static void on_huge_ground(void)
{
    look_from(vec3_of(0, 1, 5), middle, 70);
    light_up(above, LIGHT_DISTANT);
    light_up(vec3_of(-1, 2, 1), LIGHT_POINT);
    light_up(vec3_of(1e9, 1e9, 1e9), LIGHT_POINT);
    add(vec3_of(0, -1e9, 0), 1e9 - 1);
    add(vec3_of(0, -1e6, 0), 1e6 - 1);
    heap(middle, 2, 40, 0.5);
    add(vec3_of(0, 1e12, 0), 1e11);
}

// A sphere that a ray touches: so nearly that rounding decides whether it is hit.
static void graze(Ray ray, double distance, double radius)
{
    vec3 along = vec3_unit(ray.direction),
         aside = uniform(0, 1) < 0.5 ? vec3_of(1, 0, 0) : vec3_of(0, 1, 0);
    aside = vec3_unit(aside - vec3_dot(aside, along) * along) * (uniform(0, 1) < 0.5 ? 1 : -1);
    double beside = radius + uniform(-4e-16, 4e-16) * distance;
    if (vec3_is_finite(ray.origin))
        add(ray.origin + distance * along + beside * aside, radius);
}
static Pixel some_pixel(void)
{
    return (Pixel){(int)uniform(0, 31), (int)uniform(0, 23)};
}
static void grazing_the_view(void)
{
    double far = pow(10, uniform(0, 7));
    look_from(vec3_of(0, 0, far), middle, 4 / far);
    light_up(vec3_of(1, 2, 3), LIGHT_DISTANT);
    Camera camera;
    scene_camera(&lit_scene.view, lit_scene.view.resolution, &camera);
    for (int i = 0; i < MOST; i++)
        graze(pixel_ray(camera, lit_scene.view.resolution, some_pixel()), far * uniform(0.5, 1),
              pow(10, uniform(-6, -1)));
}
static void grazing_the_light(void)
{
    look_from(front, middle, 20);
    light_up(vec3_of(1e-8, -2e-8, 1), LIGHT_DISTANT);
    light_up(vec3_of(-0.1, 0.2, 1e7), LIGHT_POINT);
    lit_depth = 1;
    add(vec3_of(0, 0, -50), 50);
    add(vec3_of(0, 0, -50), 50.01);
    while (lit_scene.sphere_count < MOST) {
        Ray away = leaves_at(some_pixel());
        double distance = pow(10, uniform(1, 7)), radius = pow(10, uniform(-6, -1));
        int way = (int)uniform(0, 3);
        graze(way == 2 ? away : ray_to_light(away.origin, lights[way]), distance, radius);
    }
}

// At the corners of the boxes rays enter nearly all of them, more than can wait in a list, and hit
// only what is behind them.
static void overlapping_boxes(void)
{
    look_from(vec3_of(0, 0, 7), middle, 50);
    lit_depth = 1;
    light_up(vec3_of(3, 4, 5), LIGHT_POINT);
    add(vec3_of(0, 0, -25), 20);
    for (int i = 1; i < ROOM; i++)
        add(within(0.4), 2);
}

const LitScene lit_awkward[] = {{"nothing", nothing, 1},
                                {"no light", no_light, 1},
                                {"inside", inside, 1},
                                {"tangent", tangent, 1},
                                {"coincident", coincident, 10},
                                {"mirrors that face each other", facing_mirrors, 1},
                                {"a light in a sphere", light_in_a_sphere, 1},
                                {"a light on a surface", light_on_a_surface, 1},
                                {"far from the origin", far_from_the_origin, 1},
                                {"smaller than rounding", smaller_than_rounding, 1},
                                {"on a huge ground", on_huge_ground, 1},
                                {"grazing the view", grazing_the_view, 10},
                                {"grazing the light", grazing_the_light, 10},
                                {"overlapping boxes", overlapping_boxes, 1},
                                {0}};

void lit_at_random(unsigned number)
{
    random_begin(number * 7919ULL + 1);
    look_from(within(3), within(1), uniform(20, 130));
    lit_scene.view.up = vec3_of(0.1, 1, 0.2);
    for (int i = (int)uniform(1, LIGHTS + 1); i > 0; i--)
        light_up(within(5), uniform(0, 1) < 0.5 ? LIGHT_POINT : LIGHT_DISTANT);
    heap(middle, 2, (int)pow(MOST, uniform(0, 1)), pow(10, uniform(-1.5, 0.3)));
    lit_depth = (int)uniform(0, 6);
}

// ---- numbers that are far apart --------------------------------------------------------------

static vec3 some_way(void)
{
    return vec3_unit(within(1));
}

static void add_within_limits(vec3 center, double radius, double specular)
{
    int i = lit_scene.sphere_count;
    add(center, fmin(fmax(radius, 1e-12), 1e14));
    surfaces[i].specular = specular;
}

// A light near a heap of this size, on one of its surfaces, in the eye, far away, or distant.
static void light_somewhere(vec3 heap, double size)
{
    const Sphere sphere = spheres[(int)uniform(0, lit_scene.sphere_count)];
    const double far = fmin(size * power_of_ten(0, 15), 1e15);
    switch ((int)uniform(0, 6)) {
    case 0:
        light_up(heap + 3 * size * some_way(), LIGHT_POINT);
        break;
    case 1:
        light_up(sphere.center + sphere.radius * (1 + power_of_ten(-16, -1)) * some_way(),
                 LIGHT_POINT);
        break;
    case 2:
        light_up(sphere.center + sphere.radius * some_way(), LIGHT_POINT);
        break;
    case 3:
        light_up(lit_scene.view.from, LIGHT_POINT);
        break;
    case 4:
        light_up(heap + far * some_way(), LIGHT_POINT);
        break;
    default:
        light_up(power_of_ten(-12, 12) * some_way(), LIGHT_DISTANT);
    }
}

// Spheres that rays of the eye, of mirrors or to a light touch, near the end of the ray if it has
// one, up to most of their radii from its start.
static void graze_some(double most)
{
    const int lights_count = lit_scene.light_count;
    Camera camera;
    Resolution screen = lit_scene.view.resolution;
    if (scene_camera(&lit_scene.view, screen, &camera) != CAMERA_OK)
        return;
    for (int i = (int)uniform(1, 30); i > 0; i--) {
        Pixel pixel = {(int)uniform(0, screen.width), (int)uniform(0, screen.height)};
        int way = (int)uniform(-1, lights_count + 1);
        Ray ray = way < 0 ? pixel_ray(camera, screen, pixel) : leaves_at(pixel);
        ray = way > 0 ? ray_to_light(ray.origin, lights[way - 1]) : ray;
        bool ends = way < 0 || (way > 0 && lights[way - 1].kind == LIGHT_POINT);
        double distance = ends ? vec3_length(ray.direction) * (1 - power_of_ten(-12, -0.1))
                               : spheres[0].radius * power_of_ten(-2, log10(most));
        graze(ray, distance, fmax(distance / power_of_ten(0, log10(most)), 1e-12));
    }
}

void lit_far_apart(unsigned number)
{
    random_begin(number * 7919ULL + 5);
    if (number % 20 == 1) { // four sizes at once; the light is in the eye
        look_from(middle, vec3_of(0, 0, -1), 60);
        light_up(middle, LIGHT_POINT);
        for (int i = 0; i < 4; i++) {
            double radius = power_of_ten(-0.7, 0) * (const double[]){1e-10, 1e2, 1e7, 1e14}[i];
            double away = uniform(10, 24) * radius;
            add(away * vec3_of(uniform(-0.4, 0.4), uniform(-0.3, 0.3), -1), radius);
        }
        return;
    }
    // A heap anywhere, seen from outside; or from among its spheres, and then often in mirrors.
    // Lengths are up to most times as large as the heap: so far that plain casts the scene, or not.
    const double most = once_in(6) ? 1e15 : once_in(2) ? power_of_ten(6, 9) : power_of_ten(0.5, 9);
    const double size = once_in(2) ? 1 : power_of_ten(-9, 11), least = uniform(-1, -0.1);
    const vec3 there =
        once_in(3) ? fmin(size * power_of_ten(0, log10(most)), 1e15) * some_way() : middle;
    const bool far = once_in(2), odd = once_in(2);
    const double nearest = once_in(2) ? 0.5 : log10(most) - 1;
    const double away = far ? fmin(size * power_of_ten(nearest, log10(most)), 1e15) : 3 * size;
    const vec3 eye = there + away * (once_in(3) ? vec3_of(0, 0, 1) : some_way());
    look_from(eye, there, far ? 2 * atan(1.5 * size / away) * 180 / PI : uniform(40, 130));
    lit_scene.view.up = vec3_of(0.1, 1, 0.2);
    lit_scene.view.resolution = (Resolution){40, 30};
    for (int i = (int)uniform(1, 40); i > 0; i--)
        add_within_limits(there + within(size), size * power_of_ten(least, 0), i % 3 / 3.0);
    for (int i = odd && once_in(2) ? (int)uniform(1, 5) : 0; i > 0; i--) { // around the heap
        double radius = size * fmin(power_of_ten(0.6, once_in(2) ? 4 : 14), most);
        add_within_limits(there + radius * uniform(0, 0.5) * some_way(), radius, 0.7);
    }
    for (int i = odd && once_in(2) ? (int)uniform(1, 5) : 0; i > 0; i--) { // touching others
        const Sphere sphere = spheres[(int)uniform(0, lit_scene.sphere_count)];
        double many = power_of_ten(0, fmin(14, log10(most)));
        double radius = once_in(2) ? sphere.radius / fmin(many, 1e10) : size * many;
        double gap = once_in(2) ? 0 : uniform(-1, 1) * power_of_ten(-16, -8) * sphere.radius;
        add_within_limits(sphere.center + (sphere.radius + radius + gap) * some_way(), radius, 0.4);
    }
    for (int i = (int)uniform(1, LIGHTS + 1); i > 0; i--)
        light_somewhere(there, size);
    lit_depth = (int)uniform(0, 6);
    if (odd && once_in(2))
        graze_some(fmin(most, 1e12));
}
