// 07-shading.c - tests of exercise 07. Expected values: terms worked out by hand with cosines that
// are short numbers, and vectors that were constructed from the angles that they must have.
#include "exercises/07-shading.h"
#include "exercises/06-ray-casting.h"

#include "tests/judge/test.h"

#include <stdio.h>

#define TOLERANCE 1e-9       // of the arguments
#define COLOR_TOLERANCE 1e-9 // of the light

static Sphere sphere_at(double x, double y, double z, double radius)
{
    return (Sphere){.center = vec3_of(x, y, z), .radius = radius};
}

// ---- worlds -------------------------------------------------------------------------------------

enum { MOST_SPHERES = 300, MOST_LIGHTS = 40 };

// A scene, and the arrays it points to. Sphere i has surface i + 1, so that an answer that confuses
// the two numbers is noticed; no sphere has surface 0, which is unlike all others.
typedef struct {
    Scene scene;
    Sphere spheres[MOST_SPHERES];
    Surface surfaces[MOST_SPHERES + 1];
    Light lights[MOST_LIGHTS];
} World;

// ---- the arguments for the tests of exercise 07, and how they are described ---------------------

static void given_color(const char *name, Color color)
{
    given_vec3(name, color);
}

static void given_highlight(double ks, double shine, Color light, vec3 normal, vec3 to_light,
                            vec3 to_eye)
{
    given_number("ks", ks);
    given_number("shine", shine);
    given_color("light", light);
    given_vec3("normal", normal);
    given_vec3("to light", to_light);
    given_vec3("to eye", to_eye);
}

static void given_light(Light light)
{
    given("light", "%s %s, colour %s", light.kind == LIGHT_POINT ? "point, at" : "distant, towards",
          vec3_text_to(light.position, 10).s, vec3_text_to(light.color, 10).s);
}

// The largest of its three numbers, without their signs.
static double largest(vec3 v)
{
    return fmax(fabs(v[0]), fmax(fabs(v[1]), fabs(v[2])));
}

static Color random_color(double low, double high)
{
    return random_vec3(low, high);
}

// At right angles to a unit vector, and unit.
static vec3 random_across(vec3 unit)
{
    for (;;) {
        vec3 across = vec3_cross(unit, random_unit());
        if (vec3_length(across) > 0.1)
            return vec3_unit(across);
    }
}

// In the plane of two unit vectors at right angles, at an angle from the first towards the second.
static vec3 turned(vec3 from, double degrees, vec3 towards)
{
    return cos(degrees * PI / 180) * from + sin(degrees * PI / 180) * towards;
}

// ---- what is in a world -------------------------------------------------------------------------

static Light distant_light(double x, double y, double z)
{
    return (Light){
        .position = vec3_of(x, y, z), .color = vec3_of(0.9, 0.8, 0.7), .kind = LIGHT_DISTANT};
}

// Only a background and an ambient light, neither black, white nor grey.
static void empty_world(World *world)
{
    *world = (World){.surfaces[0] = {{0.35, 0.95, 0.05}, 0.45, 0.55, 7, 0, 1}};
    world->scene = (Scene){.background = vec3_of(0.25, 0.45, 0.65),
                           .ambient = vec3_of(0.3, 0.2, 0.1),
                           .spheres = world->spheres,
                           .surfaces = world->surfaces,
                           .surface_count = 1,
                           .lights = world->lights};
    // The light after the last one is too bright, for answers that count one too many.
    for (int i = 0; i < MOST_LIGHTS; i++)
        world->lights[i] = distant_light(0.3, 0.5, 0.2);
}

// Returns its index.
static int put_sphere(World *world, vec3 center, double radius, Surface surface)
{
    int i = world->scene.sphere_count++;
    world->spheres[i] = (Sphere){.center = center, .radius = radius, .surface = i + 1};
    world->surfaces[i + 1] = surface;
    world->scene.surface_count = i + 2;
    return i;
}

static void put_light(World *world, LightKind kind, vec3 position, Color color)
{
    world->lights[world->scene.light_count++] =
        (Light){.position = position, .color = color, .kind = kind};
}

// The colours of a surface: kd, ks, shine.
static Surface surface_of(Color color, double diffuse, double specular, double shine)
{
    return (Surface){.color = color, .diffuse = diffuse, .specular = specular, .shine = shine};
}

static Surface dull(void)
{
    return surface_of(vec3_of(0.8, 0.6, 0.4), 0.5, 0, 1);
}

static Light point_light(double x, double y, double z)
{
    return (Light){
        .position = vec3_of(x, y, z), .color = vec3_of(0.9, 0.8, 0.7), .kind = LIGHT_POINT};
}

static Color random_scene_color(void)
{
    return random_vec3(0.1, 0.9);
}

static Surface random_surface(void)
{
    Color color = random_scene_color();
    double diffuse = random_number(0.2, 0.9), specular = random_number(0.1, 0.8);
    return surface_of(color, diffuse, specular, random_number(1, 20));
}

// From 1 / most to most, small as often as large.
static double random_size(double most)
{
    return pow(most, random_number(-1, 1));
}

// Spheres that may overlap, lights of both kinds, all within a cube of about 16 sizes.
static void random_world(World *world, int spheres, int lights, double size)
{
    empty_world(world);
    world->scene.background = random_scene_color();
    world->scene.ambient = random_scene_color();
    for (int i = 0; i < spheres; i++) {
        vec3 center = random_vec3(-4, 4) * size;
        double radius = random_number(0.5, 2) * size;
        put_sphere(world, center, radius, random_surface());
    }
    for (int i = 0; i < lights; i++) {
        LightKind kind = random_number(0, 1) < 0.4 ? LIGHT_DISTANT : LIGHT_POINT;
        vec3 position = random_vec3(-8, 8) * size;
        put_light(world, kind, position, random_scene_color());
    }
}

// Towards one of the spheres, from anywhere, even from inside spheres.
static Ray random_view(const World *world, double size)
{
    int i = (int)random_number(0, world->scene.sphere_count);
    const Sphere *sphere = &world->spheres[i];
    vec3 at = sphere->center + 0.8 * sphere->radius * random_unit();
    vec3 from = random_vec3(-6, 6) * size;
    return (Ray){from, random_number(0.1, 3) * (at - from)};
}

// ---- mirrors ------------------------------------------------------------------------------------

static Surface mirror(Color color, double specular)
{
    return surface_of(color, 0.5, specular, 3);
}

static Color ambient_of(const World *world, int sphere)
{
    const Surface *surface = scene_surface(&world->scene, sphere);
    return surface->diffuse * surface->color * world->scene.ambient;
}

// A sphere as seen from the light, straight ahead.
static Color lit_from_the_eye(const World *world, int sphere, Color light)
{
    const Surface *surface = scene_surface(&world->scene, sphere);
    return ambient_of(world, sphere) + surface->diffuse * surface->color * light +
           surface->specular * light;
}

// Two mirrors that face each other: the first, the second in it, the first in that ...
static Color to_and_fro(Color first, double ks, Color second, double other_ks, int depth)
{
    Color sum = vec3_of(0, 0, 0);
    double share = 1;
    for (int i = 0; i <= depth; i++) {
        sum += share * (i % 2 == 0 ? first : second);
        share *= i % 2 == 0 ? ks : other_ks;
    }
    return sum;
}

// ---- descriptions ------------------------------------------------------------------------------

enum { MOST_SHOWN = 10 };

static void given_light_called(const char *label, const Light *light)
{
    given(label, "%s %s, colour %s",
          light->kind == LIGHT_DISTANT ? "distant, towards" : "point, at",
          vec3_text_to(light->position, 10).s, vec3_text(light->color).s);
}

static void given_scene_light(const Light *light)
{
    given_light_called("light", light);
}

static void given_lights(const Scene *scene)
{
    if (scene->light_count == 0)
        given("lights", "none");
    for (int i = 0; i < scene->light_count && i < MOST_SHOWN; i++) {
        char label[16];
        snprintf(label, sizeof label, "light %d", i % 100);
        given_light_called(label, &scene->lights[i]);
    }
    if (scene->light_count > MOST_SHOWN)
        given("and more", "%d lights in all", scene->light_count);
}

static void given_sphere_number(const Scene *scene, int i, bool with_surface)
{
    const Sphere *sphere = &scene->spheres[i];
    const Surface *s = scene_surface(scene, i);
    char label[24], looks[240] = "";
    snprintf(label, sizeof label, "sphere %d", i % 100);
    if (with_surface)
        snprintf(looks, sizeof looks, ", colour %.60s, kd %.20s, ks %.20s, shine %.20s",
                 vec3_text(s->color).s, number_text(s->diffuse).s, number_text(s->specular).s,
                 number_text(s->shine).s);
    given(label, "center %s, radius %s%s", vec3_text_to(sphere->center, 10).s,
          number_text_to(sphere->radius, 10).s, looks);
}

static void given_spheres(const Scene *scene, bool with_surfaces)
{
    if (scene->sphere_count == 0)
        given("spheres", "none");
    for (int i = 0; i < scene->sphere_count && i < MOST_SHOWN; i++)
        given_sphere_number(scene, i, with_surfaces);
    if (scene->sphere_count > MOST_SHOWN)
        given("and more", "%d in all", scene->sphere_count);
}

static void given_world(const World *world)
{
    given_spheres(&world->scene, true);
    given("ambient", "%s", vec3_text(world->scene.ambient).s);
    given("background", "%s", vec3_text(world->scene.background).s);
    given_lights(&world->scene);
}

static void expect_visible(const World *world, vec3 from, Light light, double expected)
{
    given_spheres(&world->scene, false);
    given_vec3("from", from);
    given_scene_light(&light);
    expect_number(visibility(&world->scene, from, light), expected, 0);
}

// The tolerance of a colour is a part of the light in the scene.
static double brightest(const Scene *scene)
{
    double most = fmax(largest(scene->ambient), largest(scene->background));
    for (int i = 0; i < scene->light_count; i++)
        most = fmax(most, largest(scene->lights[i].color));
    return most;
}

static void expect_shade(const World *world, Ray ray, Hit hit, Color expected)
{
    given_world(world);
    given_ray(ray);
    given("hit", "t = %s, sphere %d", number_text_to(hit.t, 17).s, hit.sphere);
    expect_vec3(shade(&world->scene, ray, hit), expected,
                COLOR_TOLERANCE * brightest(&world->scene));
}

static void expect_trace(const World *world, Ray ray, int depth, Color expected)
{
    given_world(world);
    given_ray(ray);
    given("depth", "%d", depth);
    expect_vec3(trace_ray(&world->scene, ray, depth), expected,
                COLOR_TOLERANCE * brightest(&world->scene));
}

// Light and mirrors in long double, by geometry and without an offset.  A ray that leaves a sphere
// outwards never meets it again; one that leaves it inwards meets it at the end of a chord. So no
// ray must be moved off the surface that it starts from.

// Anything nearer to an edge than this, in radii or in lengths of the ray, is left undecided.
#define DOUBT 2e-3L

typedef long double Exact;

typedef struct {
    Exact x, y, z;
} Vector;

typedef struct {
    Vector from, along;
    int own;     // the sphere on whose surface it starts; -1: none
    bool inside; // of that sphere
} Way;

typedef struct {
    const Scene *scene;
    bool doubtful;
} Look;

static Vector exact(vec3 v)
{
    return (Vector){v[0], v[1], v[2]};
}

static Vector plus(Vector v, Exact t, Vector w)
{
    return (Vector){v.x + t * w.x, v.y + t * w.y, v.z + t * w.z};
}

static Exact dot(Vector v, Vector w)
{
    return v.x * w.x + v.y * w.y + v.z * w.z;
}

static Vector unit(Vector v)
{
    return plus((Vector){0, 0, 0}, 1 / sqrtl(dot(v, v)), v);
}

// The first t > 0 at which the ray meets sphere i, from the foot of the perpendicular; -1 if none.
static Exact first_meeting(Look *look, Way way, int i)
{
    const Sphere *sphere = &look->scene->spheres[i];
    Exact a = dot(way.along, way.along), r = sphere->radius;
    Vector from_center = plus(way.from, -1, exact(sphere->center));
    Exact foot = -dot(from_center, way.along) / a;
    if (i == way.own) { // half the chord is as long as the way to the foot
        look->doubtful = look->doubtful || fabsl(foot * sqrtl(a)) < DOUBT * r;
        return !way.inside ? (foot > 0 ? 0 : -1) : foot > 0 ? 2 * foot : 0;
    }
    Vector closest = plus(from_center, foot, way.along);
    Exact aside = sqrtl(dot(closest, closest));
    look->doubtful = look->doubtful || fabsl(aside - r) < DOUBT * r;
    if (aside >= r)
        return -1;
    Exact half = sqrtl((r - aside) * (r + aside) / a), near = foot - half, far = foot + half;
    Exact least = DOUBT * r / sqrtl(a);
    look->doubtful = look->doubtful || fabsl(near) < least || fabsl(far) < least;
    return near > 0 ? near : far > 0 ? far : -1;
}

static bool arrives(Look *look, Way way, const Light *light)
{
    way.along = light->kind == LIGHT_DISTANT ? exact(light->position)
                                             : plus(exact(light->position), -1, way.from);
    bool free = true;
    for (int i = 0; i < look->scene->sphere_count; i++) {
        Exact t = first_meeting(look, way, i);
        if (light->kind == LIGHT_POINT)
            look->doubtful = look->doubtful || fabsl(t - 1) < DOUBT;
        free = free && (t < 0 || (light->kind == LIGHT_POINT && t > 1));
    }
    return free;
}

static int nearest(Look *look, Way way, Exact *t)
{
    int found = -1;
    *t = -1;
    for (int i = 0; i < look->scene->sphere_count; i++) {
        Exact here = first_meeting(look, way, i);
        if (here < 0)
            continue;
        look->doubtful = look->doubtful || (found >= 0 && fabsl(here - *t) < DOUBT * *t);
        if (found < 0 || here < *t) {
            found = i;
            *t = here;
        }
    }
    return found;
}

// The end of a ray, seen from its start.
typedef struct {
    Way back;      // from there, towards where it came from
    Vector normal; // on that side
    const Surface *surface;
} Place;

static Place place_at(const Look *look, Way way, Exact t, int i)
{
    Vector point = plus(way.from, t, way.along);
    Vector normal = unit(plus(point, -1, exact(look->scene->spheres[i].center)));
    bool inside = dot(normal, way.along) > 0;
    Vector back = plus((Vector){0, 0, 0}, -1, way.along);
    return (Place){.back = {point, back, i, inside},
                   .normal = plus((Vector){0, 0, 0}, inside ? -1 : 1, normal),
                   .surface = scene_surface(look->scene, i)};
}

// The cosine between the mirrored light and the eye is 2 (n.l)(n.e) - l.e.
static void add_light(Look *look, const Place *place, const Light *light, Exact sum[3])
{
    const Surface *surface = place->surface;
    Vector l = light->kind == LIGHT_DISTANT
                   ? unit(exact(light->position))
                   : unit(plus(exact(light->position), -1, place->back.from));
    Vector e = unit(place->back.along);
    Exact cosine = dot(place->normal, l);
    if (!arrives(look, place->back, light) || cosine <= 0)
        return;
    Exact mirrored = 2 * cosine * dot(place->normal, e) - dot(l, e);
    Exact highlight = mirrored > 0 ? surface->specular * powl(mirrored, surface->shine) : 0;
    for (int i = 0; i < 3; i++)
        sum[i] += (surface->diffuse * cosine * surface->color[i] + highlight) * light->color[i];
}

static void add_shade(Look *look, const Place *place, Exact sum[3])
{
    for (int i = 0; i < 3; i++)
        sum[i] +=
            (Exact)place->surface->diffuse * place->surface->color[i] * look->scene->ambient[i];
    for (int i = 0; i < look->scene->light_count; i++)
        add_light(look, place, &look->scene->lights[i], sum);
}

// A loop: the share of the next colour that comes through all the mirrors so far.
static void add_trace(Look *look, Way way, int depth, Exact sum[3])
{
    Exact share = 1;
    for (;; depth--) {
        Exact t, here[3] = {0};
        int sphere = nearest(look, way, &t);
        for (int i = 0; sphere < 0 && i < 3; i++)
            sum[i] += share * look->scene->background[i];
        if (sphere < 0)
            return;
        Place place = place_at(look, way, t, sphere);
        add_shade(look, &place, here);
        for (int i = 0; i < 3; i++)
            sum[i] += share * here[i];
        share *= place.surface->specular;
        if (depth == 0 || place.surface->specular == 0)
            return;
        way = place.back;
        way.along = plus(plus((Vector){0, 0, 0}, -1, place.back.along),
                         2 * dot(place.back.along, place.normal), place.normal);
    }
}

// ---- as the answers compute it -----------------------------------------------------------------

static Way way_of(Ray ray)
{
    return (Way){exact(ray.origin), exact(ray.direction), -1, false};
}

static Color color_of(const Exact sum[3])
{
    return vec3_of((double)sum[0], (double)sum[1], (double)sum[2]);
}

// In long double, and without an offset: on which side of its own sphere a ray starts is known
// there. False if something is so close to an edge that rounding may decide.
static bool exact_visibility(const World *world, vec3 from, Light light, double *visibility)
{
    Look look = {&world->scene, false};
    *visibility = arrives(&look, way_of((Ray){from, from}), &light);
    return !look.doubtful;
}

// The first hit of the ray.
static bool exact_hit(const World *world, Ray ray, Hit *hit)
{
    Look look = {&world->scene, false};
    Exact t;
    int sphere = nearest(&look, way_of(ray), &t);
    *hit = sphere < 0 ? (Hit){NO_HIT, -1} : (Hit){(double)t, sphere};
    return !look.doubtful;
}

static bool exact_shade(const World *world, Ray ray, Color *color)
{
    Look look = {&world->scene, false};
    Exact t, sum[3] = {0};
    int sphere = nearest(&look, way_of(ray), &t);
    if (sphere < 0)
        return false;
    Place place = place_at(&look, way_of(ray), t, sphere);
    add_shade(&look, &place, sum);
    *color = color_of(sum);
    return !look.doubtful;
}

static bool exact_trace(const World *world, Ray ray, int depth, Color *color)
{
    Look look = {&world->scene, false};
    Exact sum[3] = {0};
    add_trace(&look, way_of(ray), depth, sum);
    *color = color_of(sum);
    return !look.doubtful;
}

// ---- surface_normal -----------------------------------------------------------------------------

static void expect_normal(Sphere sphere, vec3 point, vec3 normal)
{
    given_sphere(sphere);
    given_vec3("point", point);
    expect_vec3(surface_normal(sphere, point), normal, TOLERANCE);
}

TEST(surface_normal, at_the_top_of_a_sphere_the_normal_points_up)
{
    expect_normal(sphere_at(0, 0, 0, 1), vec3_of(0, 1, 0), vec3_of(0, 1, 0));
    expect_normal(sphere_at(1, 2, -3, 1), vec3_of(1, 3, -3), vec3_of(0, 1, 0));
    expect_normal(sphere_at(1, 2, -3, 4), vec3_of(1, 6, -3), vec3_of(0, 1, 0));
}

TEST(surface_normal, on_opposite_sides_the_normals_are_opposite)
{
    expect_normal(sphere_at(5, 0, -7, 2), vec3_of(7, 0, -7), vec3_of(1, 0, 0));
    expect_normal(sphere_at(5, 0, -7, 2), vec3_of(3, 0, -7), vec3_of(-1, 0, 0));
}

// (2, 3, 6) is 7 long.
TEST(surface_normal, a_normal_is_unit_however_large_the_sphere_is)
{
    vec3 normal = vec3_of(2, 3, 6) / 7;
    expect_normal(sphere_at(4, -1, 2, 7), vec3_of(6, 2, 8), normal);
    expect_normal(sphere_at(4, -1, 2, 700), vec3_of(204, 299, 602), normal);
    expect_normal(sphere_at(4, -1, 2, 0.07), vec3_of(4.02, -0.97, 2.06), normal);
}

TEST(surface_normal, a_chosen_normal_is_found_again)
{
    for (int i = 0; i < 20; i++) {
        Sphere sphere = random_sphere(9, 0.1, 5);
        vec3 normal = random_unit();
        expect_normal(sphere, sphere.center + sphere.radius * normal, normal);
    }
}

// ---- ray_to_light -------------------------------------------------------------------------------

static void expect_ray_to_light(vec3 from, Light light, vec3 direction)
{
    double tolerance = TOLERANCE * fmax(largest(from), largest(light.position));
    given_vec3("from", from);
    given_light(light);
    given("looking at", "the origin");
    Ray ray = ray_to_light(from, light);
    expect_vec3(ray.origin, from, tolerance);
    given_vec3("from", from);
    given_light(light);
    given("looking at", "the direction");
    expect_vec3(ray.direction, direction, tolerance);
}

static Light light_of(LightKind kind, vec3 position)
{
    return (Light){position, {0.9, 0.7, 0.8}, kind};
}

TEST(ray_to_light, a_point_light_is_at_t_1)
{
    Light light = light_of(LIGHT_POINT, vec3_of(4, 6, 3));
    expect_ray_to_light(vec3_of(1, 2, 3), light, vec3_of(3, 4, 0));
    expect_ray_to_light(vec3_of(0, 0, 0), light, vec3_of(4, 6, 3));
    expect_ray_to_light(vec3_of(5, 6, -4), light, vec3_of(-1, 0, 7));
}

TEST(ray_to_light, a_distant_light_has_one_direction_from_everywhere)
{
    Light light = light_of(LIGHT_DISTANT, vec3_of(1, 3, -2));
    expect_ray_to_light(vec3_of(1, 2, 3), light, vec3_of(1, 3, -2));
    expect_ray_to_light(vec3_of(-50, 4, 70), light, vec3_of(1, 3, -2));
    expect_ray_to_light(vec3_of(0, 0, 0), light, vec3_of(1, 3, -2));
}

TEST(ray_to_light, the_ray_reaches_a_light_at_a_chosen_place)
{
    for (int i = 0; i < 20; i++) {
        vec3 from = random_vec3(-9, 9), way = random_unit();
        way *= random_number(0.5, 9);
        expect_ray_to_light(from, light_of(LIGHT_POINT, from + way), way);
        expect_ray_to_light(from, light_of(LIGHT_DISTANT, way), way);
    }
}

// ---- mirror_direction ---------------------------------------------------------------------------

static void expect_mirrored(vec3 direction, vec3 normal, vec3 mirrored)
{
    given_vec3("direction", direction);
    given_vec3("normal", normal);
    expect_vec3(mirror_direction(direction, normal), mirrored, TOLERANCE * vec3_length(direction));
}

static const vec3 straight_up = {0, 1, 0};

TEST(mirror_direction, a_ray_along_the_normal_comes_straight_back)
{
    expect_mirrored(vec3_of(0, -1, 0), straight_up, vec3_of(0, 1, 0));
    expect_mirrored(vec3_of(-2, -3, -6), vec3_of(2, 3, 6) / 7, vec3_of(2, 3, 6));
}

TEST(mirror_direction, a_ray_that_comes_down_at_an_angle_goes_on_and_up)
{
    expect_mirrored(vec3_of(1, -1, 0), straight_up, vec3_of(1, 1, 0));
    expect_mirrored(vec3_of(3, -4, 12), straight_up, vec3_of(3, 4, 12));
    expect_mirrored(vec3_of(3, -4, 12), vec3_of(-1, 0, 0), vec3_of(-3, -4, 12));
}

TEST(mirror_direction, a_ray_along_the_mirror_goes_on_unchanged)
{
    expect_mirrored(vec3_of(2, 0, 1), straight_up, vec3_of(2, 0, 1));
}

// By hand: (3, 3, -3) goes 3 along (2, 2, 1) / 3, so twice that, (4, 4, 2), is subtracted.
TEST(mirror_direction, a_mirror_at_an_angle)
{
    expect_mirrored(vec3_of(3, 3, -3), vec3_of(-2, -2, -1) / 3, vec3_of(-1, -1, -5));
    expect_mirrored(vec3_of(1, 1, 5), vec3_of(-2, -2, -1) / 3, vec3_of(-3, -3, 3));
}

TEST(mirror_direction, a_mirror_has_two_sides)
{
    expect_mirrored(vec3_of(1, 1, 0), straight_up, vec3_of(1, -1, 0));
    expect_mirrored(vec3_of(3, 3, -3), vec3_of(2, 2, 1) / 3, vec3_of(-1, -1, -5));
}

TEST(mirror_direction, the_part_along_the_normal_is_reversed_and_the_part_across_it_stays)
{
    for (int i = 0; i < 20; i++) {
        vec3 normal = random_unit(), across = random_across(normal);
        vec3 along = random_number(-5, 5) * normal;
        across *= random_number(0.5, 5);
        expect_mirrored(along + across, normal, across - along);
    }
}

// ---- ambient_term -------------------------------------------------------------------------------

static void expect_ambient(Color surface, double kd, Color ambient, Color color)
{
    given_color("surface", surface);
    given_number("kd", kd);
    given_color("ambient", ambient);
    expect_vec3(ambient_term(surface, kd, ambient), color, TOLERANCE * largest(ambient));
}

TEST(ambient_term, in_white_ambient_light_kd_of_the_surface_is_seen)
{
    Color surface = vec3_of(0.8, 0.4, 0.2);
    expect_ambient(surface, 1, vec3_of(1, 1, 1), vec3_of(0.8, 0.4, 0.2));
    expect_ambient(surface, 0.5, vec3_of(1, 1, 1), vec3_of(0.4, 0.2, 0.1));
    expect_ambient(surface, 0.5, vec3_of(0.1, 0.1, 0.1), vec3_of(0.04, 0.02, 0.01));
}

// By hand: 0.5 * 0.8 * 0.1, 0.5 * 0.5 * 0.2, 0.5 * 0.2 * 0.6.
TEST(ambient_term, ambient_light_is_multiplied_colour_by_colour)
{
    expect_ambient(vec3_of(0.8, 0.5, 0.2), 0.5, vec3_of(0.1, 0.2, 0.6), vec3_of(0.04, 0.05, 0.06));
    expect_ambient(vec3_of(1, 0, 0), 0.5, vec3_of(0, 1, 1), vec3_of(0, 0, 0));
}

TEST(ambient_term, without_ambient_light_the_term_is_black)
{
    expect_ambient(vec3_of(0.8, 0.5, 0.2), 0.5, vec3_of(0, 0, 0), vec3_of(0, 0, 0));
}

TEST(ambient_term, strong_ambient_light_may_be_brighter_than_white)
{
    expect_ambient(vec3_of(0.9, 0.5, 0.1), 1, vec3_of(4, 3, 2), vec3_of(3.6, 1.5, 0.2));
}

// The result is chosen, and the ambient light made to fit.
TEST(ambient_term, a_chosen_ambient_term_is_found_again)
{
    for (int i = 0; i < 20; i++) {
        Color surface = random_color(0.3, 1), color = random_color(0, 1);
        double kd = random_number(0.2, 1);
        Color ambient =
            vec3_of(color[0] / surface[0], color[1] / surface[1], color[2] / surface[2]);
        expect_ambient(surface, kd, ambient / kd, color);
    }
}

// ---- diffuse_term -------------------------------------------------------------------------------

static void expect_diffuse(Color surface, double kd, Color light, vec3 normal, vec3 to_light,
                           Color color)
{
    given_color("surface", surface);
    given_number("kd", kd);
    given_color("light", light);
    given_vec3("normal", normal);
    given_vec3("to light", to_light);
    expect_vec3(diffuse_term(surface, kd, light, normal, to_light), color,
                TOLERANCE * largest(light));
}

// A surface that reflects all of a white light: the result is the share that arrives.
static void expect_diffuse_share(vec3 to_light, double share)
{
    expect_diffuse(vec3_of(1, 1, 1), 1, vec3_of(1, 1, 1), straight_up, to_light,
                   share * vec3_of(1, 1, 1));
}

TEST(diffuse_term, light_from_straight_above_is_scattered_in_full)
{
    expect_diffuse_share(vec3_of(0, 1, 0), 1);
    expect_diffuse_share(vec3_of(0, 7, 0), 1);
}

// 3, 4, 5: the cosine is 4 / 5 if the light is high, and 3 / 5 if it is low.
TEST(diffuse_term, the_lower_the_light_the_less_is_scattered)
{
    expect_diffuse_share(vec3_of(0.6, 0.8, 0), 0.8);
    expect_diffuse_share(vec3_of(0, 0.6, -0.8), 0.6);
    expect_diffuse_share(vec3_of(-0.96, 0.28, 0), 0.28);
    expect_diffuse_share(vec3_of(1, 0, 0), 0);
}

TEST(diffuse_term, a_light_twice_as_far_in_the_same_direction_scatters_as_much)
{
    double length[] = {5, 10, 500, 0.05};
    for (int i = 0; i < 4; i++)
        expect_diffuse_share(length[i] * vec3_of(0.6, 0.8, 0), 0.8);
}

TEST(diffuse_term, a_light_behind_the_surface_scatters_nothing)
{
    expect_diffuse_share(vec3_of(0, -1, 0), 0);
    expect_diffuse_share(vec3_of(6, -8, 0), 0);
    expect_diffuse(vec3_of(0.8, 0.5, 0.2), 0.5, vec3_of(1, 0.4, 0.5), vec3_of(-2, -1, 2) / 3,
                   vec3_of(3, 4, 1), vec3_of(0, 0, 0));
}

// By hand: (-1, 2, 2) / 3 and (3, 0, 4) / 5 have the cosine (-3 + 8) / 15 = 1 / 3; then 0.6 / 3 is
// 0.2, times 0.8 * 0.5, 0.5 * 1, 0.2 * 2.
TEST(diffuse_term, light_is_multiplied_colour_by_colour)
{
    expect_diffuse(vec3_of(0.8, 0.5, 0.2), 0.6, vec3_of(0.5, 1, 2), vec3_of(-1, 2, 2) / 3,
                   vec3_of(3, 0, 4), vec3_of(0.08, 0.1, 0.08));
    expect_diffuse(vec3_of(1, 0, 0), 0.6, vec3_of(0, 1, 1), straight_up, vec3_of(1, 5, 1),
                   vec3_of(0, 0, 0));
}

TEST(diffuse_term, a_bright_light_may_be_scattered_brighter_than_white)
{
    expect_diffuse(vec3_of(0.9, 0.5, 0.1), 1, vec3_of(8, 8, 8), straight_up, vec3_of(0, 3, 4),
                   vec3_of(4.32, 2.4, 0.48));
}

TEST(diffuse_term, at_a_chosen_angle_its_cosine_is_scattered)
{
    for (int i = 0; i < 30; i++) {
        Color surface = random_color(0.2, 1), light = random_color(0.2, 2);
        double kd = random_number(0.2, 1), degrees = random_number(0, 180);
        vec3 normal = random_unit(), to_light = turned(normal, degrees, random_across(normal));
        double share = degrees < 90 ? kd * cos(degrees * PI / 180) : 0;
        expect_diffuse(surface, kd, light, normal, random_number(0.1, 10) * to_light,
                       vec3_of(share * surface[0] * light[0], share * surface[1] * light[1],
                               share * surface[2] * light[2]));
    }
}

// ---- phong_term: Phong's highlight -------------------------------------------------------------

static void expect_phong(double ks, double shine, Color light, vec3 normal, vec3 to_light,
                         vec3 to_eye, Color color)
{
    given_highlight(ks, shine, light, normal, to_light, to_eye);
    expect_vec3(phong_term(ks, shine, light, normal, to_light, to_eye), color,
                TOLERANCE * largest(light));
}

// All of a white light, over a horizontal surface.
static void expect_phong_share(double shine, vec3 to_light, vec3 to_eye, double share)
{
    expect_phong(1, shine, vec3_of(1, 1, 1), straight_up, to_light, to_eye,
                 share * vec3_of(1, 1, 1));
}

TEST(phong_term, an_eye_in_the_mirrored_direction_sees_ks_of_the_light)
{
    Color light = vec3_of(0.9, 0.7, 0.8);
    for (int shine = 1; shine < 100; shine *= 3) {
        expect_phong(0.5, shine, light, straight_up, vec3_of(0, 1, 0), vec3_of(0, 1, 0), light / 2);
        expect_phong(0.5, shine, light, straight_up, vec3_of(4, 3, 0), vec3_of(-4, 3, 0),
                     light / 2);
        expect_phong(0.5, shine, light, vec3_of(1, 0, 0), vec3_of(1, 2, 2), vec3_of(1, -2, -2),
                     light / 2);
    }
}

// From straight above the light is mirrored straight up; the cosine of (3, 4) with that is 4 / 5.
TEST(phong_term, the_cosine_with_the_mirrored_light_is_raised_to_the_power_of_shine)
{
    expect_phong_share(1, vec3_of(0, 1, 0), vec3_of(0.6, 0.8, 0), 0.8);
    expect_phong_share(2, vec3_of(0, 1, 0), vec3_of(0.6, 0.8, 0), 0.64);
    expect_phong_share(3, vec3_of(0, 1, 0), vec3_of(0, 0.8, -0.6), 0.512);
    expect_phong_share(4, vec3_of(0, 1, 0), vec3_of(0.8, 0.6, 0), 0.1296);
}

// (4, 3, 0) is mirrored to (-4, 3, 0); its cosine with (0, 3, 4) is 9 / 25.
TEST(phong_term, shine_need_not_be_a_whole_number)
{
    expect_phong_share(0.5, vec3_of(0.8, 0.6, 0), vec3_of(0, 0.6, 0.8), 0.6);
    expect_phong_share(1.5, vec3_of(0.8, 0.6, 0), vec3_of(0, 0.6, 0.8), 0.216);
    expect_phong_share(2.5, vec3_of(0.8, 0.6, 0), vec3_of(0, 0.6, 0.8), 0.07776);
}

TEST(phong_term, how_far_light_and_eye_are_does_not_matter)
{
    double length[] = {5, 10, 500, 0.05};
    for (int i = 0; i < 4; i++) {
        expect_phong_share(1.5, length[i] * vec3_of(0.8, 0.6, 0), vec3_of(0, 0.6, 0.8), 0.216);
        expect_phong_share(1.5, vec3_of(0.8, 0.6, 0), length[i] * vec3_of(0, 0.6, 0.8), 0.216);
    }
}

TEST(phong_term, a_highlight_has_the_colour_of_the_light)
{
    expect_phong(0.5, 2, vec3_of(1, 0.5, 0), straight_up, vec3_of(0, 1, 0), vec3_of(3, 4, 0),
                 vec3_of(0.32, 0.16, 0));
    expect_phong(0.25, 1, vec3_of(8, 12, 0.2), straight_up, vec3_of(0, 1, 0), vec3_of(4, 3, 0),
                 vec3_of(1.2, 1.8, 0.03));
}

// Above the surface, but more than 90 degrees from the mirrored light, (-4, 3, 0): there the cosine
// is negative, its square is not.
TEST(phong_term, far_from_the_mirrored_light_there_is_no_highlight)
{
    for (int shine = 1; shine <= 4; shine++) {
        expect_phong_share(shine, vec3_of(4, 3, 0), vec3_of(4, 3, 0), 0);
        expect_phong_share(shine, vec3_of(4, 3, 0), vec3_of(12, 3, 4), 0);
    }
    expect_phong_share(2.5, vec3_of(4, 3, 0), vec3_of(12, 3, 4), 0);
}

// If it were mirrored nevertheless, (4, -3, 0) would go to (-4, -3, 0); the cosine of (-4, 1, 0)
// with that is positive.
TEST(phong_term, a_light_behind_the_surface_makes_no_highlight)
{
    expect_phong_share(2, vec3_of(4, -3, 0), vec3_of(-4, -3, 0), 0);
    expect_phong_share(2, vec3_of(4, -3, 0), vec3_of(-4, 1, 0), 0);
    expect_phong_share(7, vec3_of(4, -3, 0), vec3_of(-12, 3, 4), 0);
    expect_phong_share(2, vec3_of(0, -1, 0), vec3_of(0, 1, 0), 0);
    for (double length = 1; length > 1e-6; length /= 10)
        expect_phong_share(2, length * vec3_of(0.8, -0.6, 0), vec3_of(-4, 1, 0), 0);
}

// The light and its mirrored direction are equally far from the normal, on opposite sides, and the
// eye is at a chosen angle from the latter, above the surface.
TEST(phong_term, at_a_chosen_angle_from_the_mirrored_light)
{
    for (int i = 0; i < 40; i++) {
        vec3 normal = random_unit(), across = random_across(normal);
        double low = random_number(5, 85), off = random_number(0, 150);
        vec3 to_light = turned(normal, low, across), mirrored = turned(normal, -low, across);
        vec3 to_eye = turned(mirrored, off, random_across(mirrored));
        double ks = random_number(0.1, 1), shine = random_number(0.5, 9);
        Color light = random_color(0.2, 2);
        double share = off < 90 ? ks * pow(cos(off * PI / 180), shine) : 0;
        to_light *= random_number(0.1, 10);
        if (vec3_dot(normal, to_eye) > 0.01)
            expect_phong(ks, shine, light, normal, to_light, random_number(0.1, 10) * to_eye,
                         share * light);
    }
}

// ---- halfway_term: the highlight by the half-way vector, Blinn's -------------------------------

static void expect_halfway(double ks, double shine, Color light, vec3 normal, vec3 to_light,
                           vec3 to_eye, Color color)
{
    given_highlight(ks, shine, light, normal, to_light, to_eye);
    expect_vec3(halfway_term(ks, shine, light, normal, to_light, to_eye), color,
                TOLERANCE * largest(light));
}

// All of a white light, over a horizontal surface.
static void expect_halfway_share(double shine, vec3 to_light, vec3 to_eye, double share)
{
    expect_halfway(1, shine, vec3_of(1, 1, 1), straight_up, to_light, to_eye,
                   share * vec3_of(1, 1, 1));
}

TEST(halfway_term, if_the_normal_is_half_way_ks_of_the_light_is_seen)
{
    Color light = vec3_of(0.9, 0.7, 0.8);
    for (int shine = 1; shine < 100; shine *= 3) {
        expect_halfway(0.5, shine, light, straight_up, vec3_of(0, 1, 0), vec3_of(0, 1, 0),
                       light / 2);
        expect_halfway(0.5, shine, light, straight_up, vec3_of(4, 3, 0), vec3_of(-4, 3, 0),
                       light / 2);
        expect_halfway(0.5, shine, light, vec3_of(1, 0, 0), vec3_of(1, 2, 2), vec3_of(1, -2, -2),
                       light / 2);
    }
}

// Half-way between (0, 1, 0) and (24, 7, 0) / 25 is (3, 4, 0) / 5: twice (3, 4, 0) / 5 times the
// cosine 4 / 5 is their sum. Its cosine with the normal is 4 / 5.
TEST(halfway_term, the_cosine_with_the_normal_is_raised_to_the_power_of_shine)
{
    vec3 eye = vec3_of(0.96, 0.28, 0), eye_aside = vec3_of(0, 0.28, -0.96);
    expect_halfway_share(1, vec3_of(0, 1, 0), eye, 0.8);
    expect_halfway_share(2, vec3_of(0, 1, 0), eye, 0.64);
    expect_halfway_share(3, vec3_of(0, 1, 0), eye_aside, 0.512);
    expect_halfway_share(4, eye, vec3_of(0, 1, 0), 0.4096);
}

// Half-way between a direction and itself is that direction; the cosine of (12, 9, 20) / 25 with
// the normal is 9 / 25.
TEST(halfway_term, shine_need_not_be_a_whole_number_here_either)
{
    vec3 there = vec3_of(0.48, 0.36, 0.8);
    expect_halfway_share(0.5, there, there, 0.6);
    expect_halfway_share(1.5, there, there, 0.216);
    expect_halfway_share(2.5, there, there, 0.07776);
}

TEST(halfway_term, only_the_directions_of_light_and_eye_matter)
{
    double length[] = {5, 10, 500, 0.05};
    for (int i = 0; i < 4; i++) {
        expect_halfway_share(2, length[i] * vec3_of(0, 1, 0), vec3_of(0.96, 0.28, 0), 0.64);
        expect_halfway_share(2, vec3_of(0, 1, 0), length[i] * vec3_of(0.96, 0.28, 0), 0.64);
    }
}

TEST(halfway_term, this_highlight_also_has_the_colour_of_the_light)
{
    expect_halfway(0.5, 2, vec3_of(1, 0.5, 0), straight_up, vec3_of(0, 1, 0), vec3_of(24, 7, 0),
                   vec3_of(0.32, 0.16, 0));
    expect_halfway(0.25, 1, vec3_of(8, 12, 0.2), straight_up, vec3_of(0, 1, 0), vec3_of(24, 7, 0),
                   vec3_of(1.6, 2.4, 0.04));
}

// Half-way between (4, 3, 0) / 5 and the eye is below the surface: there the cosine is negative,
// its square is not.
TEST(halfway_term, if_half_way_is_below_the_surface_there_is_no_highlight)
{
    for (int shine = 1; shine <= 4; shine++) {
        expect_halfway_share(shine, vec3_of(4, 3, 0), vec3_of(0, -1, 0), 0);
        expect_halfway_share(shine, vec3_of(4, 3, 0), vec3_of(1, -4, 1), 0);
    }
    expect_halfway_share(2.5, vec3_of(4, 3, 0), vec3_of(1, -4, 1), 0);
}

TEST(halfway_term, a_light_behind_the_surface_has_no_highlight_here_either)
{
    expect_halfway_share(2, vec3_of(4, -3, 0), vec3_of(-4, -3, 0), 0);
    expect_halfway_share(2, vec3_of(4, -3, 0), vec3_of(0, 1, 0), 0);
    expect_halfway_share(7, vec3_of(12, -3, 4), vec3_of(-3, 5, 1), 0);
}

// The half-way vector is at a chosen angle from the normal; light and eye are equally far from it,
// on opposite sides.
TEST(halfway_term, half_way_at_a_chosen_angle)
{
    for (int i = 0; i < 40; i++) {
        vec3 normal = random_unit();
        double off = random_number(0, 80), apart = random_number(5, 75);
        vec3 halfway = turned(normal, off, random_across(normal));
        vec3 across = random_across(halfway);
        vec3 to_light = turned(halfway, apart, across), to_eye = turned(halfway, -apart, across);
        double ks = random_number(0.1, 1), shine = random_number(0.5, 9);
        Color light = random_color(0.2, 2);
        double cosine = vec3_dot(normal, to_light);
        double share = cosine > 0 ? ks * pow(cos(off * PI / 180), shine) : 0;
        to_light *= random_number(0.1, 10);
        if (fabs(cosine) > 0.01 && vec3_dot(normal, to_eye) > 0.01)
            expect_halfway(ks, shine, light, normal, to_light, random_number(0.1, 10) * to_eye,
                           share * light);
    }
}

// ---- clamp_color --------------------------------------------------------------------------------

static void expect_clamped(Color color, Color clamped)
{
    given_color("colour", color);
    expect_vec3(clamp_color(color), clamped, TOLERANCE);
}

TEST(clamp_color, a_number_between_0_and_1_stays)
{
    expect_clamped(vec3_of(0.25, 0.5, 0.125), vec3_of(0.25, 0.5, 0.125));
    expect_clamped(vec3_of(0, 1, 0.999), vec3_of(0, 1, 0.999));
}

TEST(clamp_color, a_number_above_1_becomes_1_and_the_others_stay)
{
    expect_clamped(vec3_of(0.5, 300, 0.25), vec3_of(0.5, 1, 0.25));
    expect_clamped(vec3_of(1.5, 0.5, 0.25), vec3_of(1, 0.5, 0.25));
    expect_clamped(vec3_of(0.5, 0.25, 2), vec3_of(0.5, 0.25, 1));
    expect_clamped(vec3_of(1.1, 2.2, 3.3), vec3_of(1, 1, 1));
}

TEST(clamp_color, a_number_below_0_becomes_0_and_the_others_stay)
{
    expect_clamped(vec3_of(-0.5, -300, 0.25), vec3_of(0, 0, 0.25));
    expect_clamped(vec3_of(-0.25, 0.5, 0.75), vec3_of(0, 0.5, 0.75));
    expect_clamped(vec3_of(0.5, 0.25, -2), vec3_of(0.5, 0.25, 0));
    expect_clamped(vec3_of(-1.1, -2.2, -3.3), vec3_of(0, 0, 0));
}

TEST(clamp_color, each_number_is_clamped_by_itself)
{
    for (int i = 0; i < 20; i++) {
        double below = random_number(-3, 0), inside = random_number(0, 1);
        double above = random_number(1, 4);
        expect_clamped(vec3_of(below, inside, above), vec3_of(0, inside, 1));
        expect_clamped(vec3_of(above, below, inside), vec3_of(1, 0, inside));
        expect_clamped(vec3_of(inside, above, below), vec3_of(inside, 1, 0));
    }
}

// ---- gamma_encode -------------------------------------------------------------------------------

static void expect_encoded(Color color, double gamma, Color encoded)
{
    given_color("colour", color);
    given_number("gamma", gamma);
    expect_vec3(gamma_encode(color, gamma), encoded, TOLERANCE);
}

TEST(gamma_encode, with_a_gamma_of_1_nothing_changes)
{
    expect_encoded(vec3_of(0.25, 0.5, 0.75), 1, vec3_of(0.25, 0.5, 0.75));
}

// The display squares its input, so a quarter of the light needs half; and so on.
TEST(gamma_encode, a_gamma_of_2_needs_the_square_root_and_3_the_cube_root)
{
    expect_encoded(vec3_of(0.25, 0.01, 0.81), 2, vec3_of(0.5, 0.1, 0.9));
    expect_encoded(vec3_of(0.125, 0.001, 0.512), 3, vec3_of(0.5, 0.1, 0.8));
    expect_encoded(vec3_of(0.5, 0.1, 0.9), 0.5, vec3_of(0.25, 0.01, 0.81));
}

TEST(gamma_encode, black_stays_black_and_white_stays_white)
{
    double gamma[] = {0.5, 1, 1.8, 2.2, 3};
    for (int i = 0; i < 5; i++) {
        expect_encoded(vec3_of(0, 0, 0), gamma[i], vec3_of(0, 0, 0));
        expect_encoded(vec3_of(1, 1, 1), gamma[i], vec3_of(1, 1, 1));
    }
}

// From another program: 2.2nd roots.
TEST(gamma_encode, a_gamma_of_2_2_as_of_most_displays)
{
    expect_encoded(vec3_of(0.2, 0.5, 0.8), 2.2,
                   vec3_of(0.4811565050522864, 0.7297400528407231, 0.9035454309190944));
}

TEST(gamma_encode, the_display_shows_the_colour_that_was_meant)
{
    for (int i = 0; i < 20; i++) {
        Color encoded = random_color(0.1, 1);
        double gamma = random_number(0.5, 4);
        Color meant =
            vec3_of(pow(encoded[0], gamma), pow(encoded[1], gamma), pow(encoded[2], gamma));
        expect_encoded(meant, gamma, encoded);
    }
}

// ---- light of any strength, from any distance and angle ----------------------------------------

// No light is too weak, too low, too far or too bright to count. Ladders: an answer with a limit
// fails at the first rung after it, and that rung names the limit.

// 0.3, 0.03 ... 3e-8: the smallest that the tolerance of a colour still distinguishes from 0.
enum { SMALL = 8 };

static double small(int i)
{
    return 3 * pow(10, -1 - i);
}

// Sizes of worlds and strengths of light: 1, 0.001 ... 1e-12, then 1000 ... 1e12.
enum { SIZES = 9 };

static double size_number(int i)
{
    return pow(10, i < 5 ? -3 * i : 3 * (i - 4)) * random_number(0.5, 2);
}

static const vec3 white = {1, 1, 1};

// ---- directions of light ------------------------------------------------------------------------

TEST(surface_normal, a_normal_is_unit_in_worlds_of_any_size)
{
    for (int i = 0; i < SIZES; i++) {
        double size = size_number(i);
        vec3 center = 3 * size * random_unit(), normal = random_unit();
        expect_normal((Sphere){.center = center, .radius = size}, center + size * normal, normal);
    }
}

TEST(ray_to_light, the_way_to_a_light_has_the_right_length_in_worlds_of_any_size)
{
    for (int i = 0; i < SIZES; i++) {
        double size = size_number(i);
        vec3 from = size * random_vec3(-9, 9), way = size * random_number(0.5, 9) * random_unit();
        Light light = {from + way, {0.9, 0.7, 0.8}, LIGHT_POINT};
        expect_ray_to_light(from, light, way);
        light = (Light){way, {0.9, 0.7, 0.8}, LIGHT_DISTANT};
        expect_ray_to_light(from, light, way);
    }
}

TEST(mirror_direction, directions_of_any_length_are_mirrored)
{
    for (int i = 0; i < SIZES; i++) {
        vec3 normal = random_unit(), across = size_number(i) * random_across(normal);
        vec3 along = random_number(0.5, 2) * vec3_length(across) * normal;
        expect_mirrored(across - along, normal, across + along);
    }
}

TEST(mirror_direction, a_ray_that_grazes_a_mirror_is_also_mirrored)
{
    for (int i = 0; i < SMALL; i++) {
        expect_mirrored(vec3_of(1, -small(i), 0), straight_up, vec3_of(1, small(i), 0));
        expect_mirrored(vec3_of(0, small(i), -1), straight_up, vec3_of(0, -small(i), -1));
    }
}

// ---- strength -----------------------------------------------------------------------------------

static const Color light_color = {0.9, 0.5, 0.7}, surface_color = {0.8, 0.3, 0.6};

TEST(ambient_term, ambient_light_may_be_of_any_strength)
{
    for (int i = 0; i < SIZES; i++) {
        double strength = size_number(i);
        expect_ambient(surface_color, 0.5, strength * light_color,
                       strength * vec3_of(0.36, 0.075, 0.21));
    }
}

TEST(diffuse_term, a_light_may_be_of_any_strength)
{
    for (int i = 0; i < SIZES; i++) {
        double strength = size_number(i);
        expect_diffuse(surface_color, 0.5, strength * light_color, straight_up,
                       vec3_of(0.6, 0.8, 0), strength * vec3_of(0.288, 0.06, 0.168));
    }
}

TEST(phong_term, a_highlight_is_as_strong_as_its_light)
{
    for (int i = 0; i < SIZES; i++) {
        Color light = size_number(i) * light_color;
        expect_phong(0.5, 2, light, straight_up, vec3_of(0, 1, 0), vec3_of(0.6, 0.8, 0),
                     0.32 * light);
    }
}

TEST(halfway_term, this_highlight_is_also_as_strong_as_its_light)
{
    for (int i = 0; i < SIZES; i++) {
        Color light = size_number(i) * light_color;
        expect_halfway(0.5, 2, light, straight_up, vec3_of(0, 1, 0), vec3_of(0.96, 0.28, 0),
                       0.32 * light);
    }
}

TEST(ambient_term, a_dark_surface_reflects_little_of_the_ambient_light)
{
    for (int i = 0; i < SMALL; i++) {
        expect_ambient(small(i) * surface_color, 1, white, small(i) * surface_color);
        expect_ambient(surface_color, small(i), white, small(i) * surface_color);
    }
}

TEST(diffuse_term, a_dark_surface_scatters_little)
{
    for (int i = 0; i < SMALL; i++) {
        expect_diffuse(small(i) * surface_color, 1, white, straight_up, straight_up,
                       small(i) * surface_color);
        expect_diffuse(surface_color, small(i), white, straight_up, straight_up,
                       small(i) * surface_color);
    }
}

TEST(phong_term, a_surface_that_hardly_shines_has_a_weak_highlight)
{
    for (int i = 0; i < SMALL; i++)
        expect_phong(small(i), 2, white, straight_up, straight_up, straight_up, small(i) * white);
}

TEST(halfway_term, a_surface_that_hardly_shines_also_has_a_weak_highlight_here)
{
    for (int i = 0; i < SMALL; i++)
        expect_halfway(small(i), 2, white, straight_up, straight_up, straight_up, small(i) * white);
}

// ---- distances ----------------------------------------------------------------------------------

TEST(diffuse_term, a_light_may_be_at_any_distance)
{
    for (int i = 0; i < SIZES; i++)
        expect_diffuse(surface_color, 0.5, light_color, straight_up,
                       size_number(i) * vec3_of(0.6, 0.8, 0), vec3_of(0.288, 0.06, 0.168));
}

TEST(phong_term, light_and_eye_may_be_at_any_distance)
{
    for (int i = 0; i < 2 * SIZES; i++) {
        double to_light = i < SIZES ? size_number(i) : 1;
        double to_eye = i < SIZES ? 1 : size_number(i - SIZES);
        expect_phong(0.5, 2, light_color, straight_up, to_light * straight_up,
                     to_eye * vec3_of(0.6, 0.8, 0), 0.32 * light_color);
    }
}

TEST(halfway_term, light_and_eye_may_be_at_any_distance_here_as_well)
{
    for (int i = 0; i < 2 * SIZES; i++) {
        double to_light = i < SIZES ? size_number(i) : 1;
        double to_eye = i < SIZES ? 1 : size_number(i - SIZES);
        expect_halfway(0.5, 2, light_color, straight_up, to_light * straight_up,
                       to_eye * vec3_of(0.96, 0.28, 0), 0.32 * light_color);
    }
}

// ---- angles -------------------------------------------------------------------------------------

TEST(diffuse_term, a_light_is_scattered_even_if_it_is_very_low)
{
    for (int i = 0; i < SMALL; i++) {
        double cosine = small(i) / hypot(1, small(i));
        expect_diffuse(white, 1, white, straight_up, vec3_of(1, small(i), 0), cosine * white);
    }
}

TEST(diffuse_term, a_light_almost_straight_above_is_scattered_almost_fully)
{
    for (int i = 0; i < SMALL; i++) {
        double cosine = 1 - small(i), aside = sqrt((1 - cosine) * (1 + cosine));
        expect_diffuse(white, 1, white, straight_up, vec3_of(0, cosine, aside), cosine * white);
    }
}

// The light is a little above the surface; mirrored, (-1, e, 0). The eye is at 45 degrees.
TEST(phong_term, a_light_has_its_highlight_even_if_it_is_very_low)
{
    for (int i = 0; i < SMALL; i++) {
        double cosine = cos(PI / 4 - atan(small(i)));
        expect_phong(1, 2, white, straight_up, vec3_of(1, small(i), 0), vec3_of(-1, 1, 0),
                     cosine * cosine * white);
    }
}

// The half-way vector between it and the eye is at half the angle between them from the eye.
TEST(halfway_term, a_light_has_its_highlight_here_even_if_it_is_very_low)
{
    for (int i = 0; i < SMALL; i++) {
        double cosine = cos((PI / 4 - atan(small(i))) / 2);
        expect_halfway(1, 2, white, straight_up, vec3_of(1, small(i), 0), vec3_of(-1, 1, 0),
                       cosine * cosine * white);
    }
}

TEST(phong_term, a_cosine_has_its_power_even_if_it_is_very_small)
{
    for (int i = 0; i < SMALL; i++) {
        double cosine = small(i) / hypot(1, small(i));
        expect_phong(1, 1, white, straight_up, straight_up, vec3_of(1, small(i), 0),
                     cosine * white);
        expect_phong(1, 0.5, white, straight_up, straight_up, vec3_of(0, small(i), 1),
                     sqrt(cosine) * white);
    }
}

// Light and eye in the same direction: that is also the half-way vector.
TEST(halfway_term, a_cosine_has_its_power_here_even_if_it_is_very_small)
{
    for (int i = 0; i < SMALL; i++) {
        double cosine = small(i) / hypot(1, small(i));
        vec3 there = vec3_of(1, small(i), 0);
        expect_halfway(1, 1, white, straight_up, there, there, cosine * white);
        expect_halfway(1, 0.5, white, straight_up, there, 2 * there, sqrt(cosine) * white);
    }
}

// ---- shine --------------------------------------------------------------------------------------

// From the dullest to the most polished: the angle at which half of ks of the light is seen.
static const double all_shines[] = {0.25, 0.75, 1,   3,   10,  11,  20,   33,
                                    64,   100,  101, 128, 129, 300, 1001, 1e4};
enum { SHINES = sizeof all_shines / sizeof *all_shines };

static vec3 half_seen(double shine)
{
    double cosine = pow(0.5, 1 / shine);
    return vec3_of(sqrt((1 - cosine) * (1 + cosine)), cosine, 0);
}

TEST(phong_term, shine_may_be_of_any_size)
{
    for (int i = 0; i < SHINES; i++)
        expect_phong(1, all_shines[i], white, straight_up, straight_up, half_seen(all_shines[i]),
                     0.5 * white);
    expect_phong(0.5, 0, light_color, straight_up, straight_up, vec3_of(0.6, 0.8, 0),
                 0.5 * light_color);
}

TEST(halfway_term, shine_may_be_of_any_size_here_as_well)
{
    for (int i = 0; i < SHINES; i++) {
        vec3 there = half_seen(all_shines[i]);
        expect_halfway(1, all_shines[i], white, straight_up, there, 3 * there, 0.5 * white);
    }
    expect_halfway(0.5, 0, light_color, straight_up, straight_up, vec3_of(0.96, 0.28, 0),
                   0.5 * light_color);
}

// cos 60 degrees is 1 / 2, whose powers are exact.
TEST(phong_term, a_high_power_leaves_little)
{
    const vec3 there = {0, 0.5, 0.86602540378443864676};
    for (int shine = 1; shine <= 24; shine++)
        expect_phong(1, shine, white, straight_up, straight_up, there, ldexp(1, -shine) * white);
}

// The share that is seen at a small angle from the middle: with a high power that is not all of it.
static double near_the_middle(double angle)
{
    return pow(cos(angle), 50);
}

TEST(phong_term, close_to_its_middle_a_highlight_is_already_weaker)
{
    for (double angle = 0.03; angle > 1e-5; angle /= 10)
        expect_phong(1, 50, white, straight_up, straight_up, vec3_of(sin(angle), cos(angle), 0),
                     near_the_middle(angle) * white);
}

TEST(halfway_term, close_to_its_middle_this_highlight_is_also_weaker)
{
    for (double angle = 0.03; angle > 1e-5; angle /= 10) {
        vec3 there = vec3_of(sin(angle), cos(angle), 0);
        expect_halfway(1, 50, white, straight_up, there, there, near_the_middle(angle) * white);
    }
}

TEST(halfway_term, a_high_power_also_leaves_little_here)
{
    const vec3 there = {0, 0.5, 0.86602540378443864676};
    for (int shine = 1; shine <= 24; shine++)
        expect_halfway(1, shine, white, straight_up, there, there, ldexp(1, -shine) * white);
}

// ---- for a display ------------------------------------------------------------------------------

TEST(clamp_color, a_number_that_just_fits_stays_and_one_that_just_does_not_is_clamped)
{
    for (int i = 0; i < SMALL; i++) {
        double e = small(i);
        expect_clamped(vec3_of(e, 0.5, 1 - e), vec3_of(e, 0.5, 1 - e));
        expect_clamped(vec3_of(1 - e, e, 0.5), vec3_of(1 - e, e, 0.5));
        expect_clamped(vec3_of(-e, 0.5, 1 + e), vec3_of(0, 0.5, 1));
        expect_clamped(vec3_of(0.5, 1 + e, -e), vec3_of(0.5, 1, 0));
    }
}

TEST(clamp_color, a_number_above_1_becomes_1_however_bright_it_is)
{
    for (int i = 0; i < 13; i++) {
        double bright = 3 * pow(10, i);
        expect_clamped(vec3_of(bright, 0.25, 0.75), vec3_of(1, 0.25, 0.75));
        expect_clamped(vec3_of(0.75, -bright, bright), vec3_of(0.75, 0, 1));
        expect_clamped(vec3_of(bright, bright, 2 * bright), vec3_of(1, 1, 1));
    }
}

// From another program, as above: 0.4 to the power of 1 / gamma.
TEST(gamma_encode, any_gamma_is_used_unchanged)
{
    for (int i = 0; i < 12; i++) {
        const double gammas[] = {1.001, 0.95, 1.05, 2.05, 2.15, 2.3, 2.5, 3.5, 7, 25, 0.3, 0.06};
        Color encoded = vec3_of(0.5, 0.8, 0.65);
        double gamma = gammas[i];
        expect_encoded(vec3_of(pow(0.5, gamma), pow(0.8, gamma), pow(0.65, gamma)), gamma, encoded);
    }
}

TEST(gamma_encode, a_colour_is_encoded_however_dark_it_is)
{
    for (int i = 0; i < SMALL; i++) {
        double e = small(i);
        expect_encoded(vec3_of(e, 0.5, 1), 1, vec3_of(e, 0.5, 1));
        expect_encoded(vec3_of(0.25, e * e, 1), 2, vec3_of(0.5, e, 1));
        expect_encoded(vec3_of(1, 0.125, e * e * e), 3, vec3_of(1, 0.5, e));
    }
}

#define EYE_ABOVE ((Ray){vec3_of(0, 4, 0), vec3_of(0, -2, 0)})
#define HIT_AT_2 ((Hit){2, 0})

// ---- off_surface: how far, and to which side ---------------------------------------------------

// From a point of the sphere, straight to the side of the normal, by the step that the contract
// allows: any number from 2^-32 to 2^-28 of the size.
static void expect_off(Sphere sphere, vec3 point, vec3 normal, double size)
{
    const double rounding = 0x1p-46 * size;
    given_sphere(sphere);
    given_vec3("point", point);
    given_vec3("normal", normal);
    given("size", "%s", number_text_to(size, 10).s);
    vec3 moved = off_surface(sphere, point, normal) - point;
    double along = vec3_dot(moved, normal), aside = vec3_length(moved - along * normal);
    char expected[200];
    snprintf(expected, sizeof expected,
             "moved by %.24s to %.24s along the normal, and not to the side",
             number_text_to(0x1p-32 * size, 3).s, number_text_to(0x1p-28 * size, 3).s);
    expect_law(along >= 0x1p-32 * size - rounding && along <= 0x1p-28 * size + rounding &&
                   aside <= rounding,
               expected, "moved by %.40s along the normal, by %.40s to the side",
               number_text_to(along, 3).s, number_text_to(aside, 3).s);
}

static Sphere sphere_round(vec3 center, double radius)
{
    return (Sphere){.center = center, .radius = radius};
}

// So that the sphere touches the origin of the world, where the smallest step is visible.
static Sphere sphere_at_origin(vec3 outward, double radius)
{
    return sphere_round(-radius * outward, radius);
}

TEST(off_surface, outside_the_point_moves_away_from_the_centre)
{
    vec3 up = vec3_of(0, 1, 0), back = vec3_of(0, 0, -1), aslant = vec3_of(0.6, 0, 0.8);
    expect_off(sphere_at_origin(up, 1000), vec3_of(0, 0, 0), up, 2000);
    expect_off(sphere_at_origin(back, 50000), vec3_of(0, 0, 0), back, 1e5);
    expect_off(sphere_at_origin(aslant, 1000), vec3_of(0, 0, 0), aslant, 1800);
}

TEST(off_surface, inside_the_point_moves_towards_the_centre)
{
    vec3 up = vec3_of(0, 1, 0), aslant = vec3_of(0.6, -0.8, 0);
    expect_off(sphere_at_origin(-up, 1000), vec3_of(0, 0, 0), up, 2000);
    expect_off(sphere_at_origin(-aslant, 5000), vec3_of(0, 0, 0), aslant, 9000);
}

TEST(off_surface, scenes_may_be_of_any_size)
{
    vec3 up = vec3_of(0, 1, 0);
    for (int i = -9; i <= 9; i++) {
        double radius = pow(10, i);
        expect_off(sphere_at_origin(up, radius), vec3_of(0, 0, 0), up, 2 * radius);
        expect_off(sphere_at_origin(-up, radius), vec3_of(0, 0, 0), up, 2 * radius);
    }
}

// The farther from the origin of the world, the coarser the numbers are.
TEST(off_surface, a_small_sphere_far_away_needs_as_large_a_step_as_a_large_one)
{
    vec3 up = vec3_of(0, 1, 0);
    for (int i = 0; i < 3; i++) {
        vec3 center = vec3_of(0, -1, 0);
        center[i] += 1e6;
        vec3 point = center + up;
        expect_off(sphere_round(center, 1), point, up, (i == 1 ? 1e6 - 1 : 1e6) + 1);
    }
    // Fractions count as well.
    for (int i = 0; i < 3; i++) {
        vec3 center = vec3_of(0, 0, 0);
        center[i] = 0.9;
        expect_off(sphere_round(center, 0x1p-10), center + 0x1p-10 * up, up, 0.9 + 0x1p-10);
    }
    expect_off(sphere_round(vec3_of(0, 0, 0), 0.9), 0.9 * up, up, 0.9);
}

TEST(off_surface, negative_coordinates_are_as_large_as_positive_ones)
{
    vec3 up = vec3_of(0, 1, 0);
    for (int i = 0; i < 3; i++) {
        vec3 center = vec3_of(0, -1, 0);
        center[i] -= 1e6;
        expect_off(sphere_round(center, 1), center + up, up, (i == 1 ? 1e6 + 1 : 1e6) + 1);
    }
}

TEST(off_surface, around_the_origin_of_the_world_the_radius_counts)
{
    vec3 up = vec3_of(0, 1, 0);
    expect_off(sphere_round(-2.5e5 * up, 1e6), 7.5e5 * up, up, 1.25e6);
    expect_off(sphere_round(vec3_of(0, 0, 0), 1e6), vec3_of(0, 0, 1e6), vec3_of(0, 0, 1), 1e6);
    expect_off(sphere_round(vec3_of(0, 0, 0), 7e5), vec3_of(2e5, 3e5, 6e5), vec3_of(2, 3, 6) / 7,
               7e5);
}

TEST(off_surface, anywhere_it_is_a_step_along_the_normal)
{
    for (int i = 0; i < 30; i++) {
        double scale = random_size(1e8);
        Sphere sphere = random_sphere(3 * scale, 0.1 * scale, 3 * scale);
        vec3 outward = random_unit(), c = sphere.center;
        if (i % 3 == 0)
            sphere.center = c = -sphere.radius * outward;
        double size = sphere.radius + fmax(fabs(c[0]), fmax(fabs(c[1]), fabs(c[2])));
        vec3 point = c + sphere.radius * outward;
        expect_off(sphere, point, i % 2 == 0 ? outward : -outward, size);
    }
}

// ---- visibility: spheres between a point and a light ------------------------------------------

// By hand, mostly on an axis.

// One or more spheres on the z axis, given by centre and radius; seen from the origin.
static World on_the_axis;

static const World *spheres_on_the_axis(int count, const double centers[], const double radii[])
{
    empty_world(&on_the_axis);
    for (int i = 0; i < count; i++)
        put_sphere(&on_the_axis, vec3_of(0, 0, centers[i]), radii[i], dull());
    return &on_the_axis;
}

static const World *sphere_on_the_axis(double center, double radius)
{
    return spheres_on_the_axis(1, &center, &radius);
}

static const vec3 origin = {0, 0, 0};

TEST(visibility, in_an_empty_scene_light_arrives)
{
    const World *nothing = spheres_on_the_axis(0, NULL, NULL);
    expect_visible(nothing, origin, point_light(1, 2, 3), 1);
    expect_visible(nothing, origin, distant_light(1, 2, 3), 1);
}

TEST(visibility, a_sphere_in_between_hides_a_light)
{
    expect_visible(sphere_on_the_axis(5, 1), origin, point_light(0, 0, 10), 0);
    expect_visible(sphere_on_the_axis(5, 1), origin, distant_light(0, 0, 10), 0);
    expect_visible(sphere_on_the_axis(-5, 1), vec3_of(0, 0.5, -9), point_light(0, 0.5, 0), 0);
}

TEST(visibility, a_sphere_beside_the_way_hides_nothing)
{
    expect_visible(sphere_on_the_axis(5, 1), vec3_of(1.5, 0, 0), point_light(1.5, 0, 10), 1);
    expect_visible(sphere_on_the_axis(5, 1), vec3_of(1.5, 0, 0), distant_light(0, 0, 10), 1);
    // The direction counts, not where its tip is.
    expect_visible(sphere_on_the_axis(5, 1), vec3_of(0, 4, 0), distant_light(0, 0, 5), 1);
}

// Seen from (0, 6, 0) the light is beyond the sphere; the vector to its coordinates has another
// direction.
TEST(visibility, the_way_to_a_point_light_starts_at_the_point)
{
    expect_visible(sphere_on_the_axis(4, 1), vec3_of(0, 6, 0), point_light(0, -6, 8), 0);
    expect_visible(sphere_on_the_axis(4, 1), vec3_of(0, 6, 0), point_light(0, 0, 8), 1);
}

// By chance these are 1 in lengths of the vector to the light; that of (0, 0, 4) is 4 long.
TEST(visibility, a_sphere_behind_a_point_light_hides_nothing)
{
    expect_visible(sphere_on_the_axis(6, 1), origin, point_light(0, 0, 4), 1);
    expect_visible(sphere_on_the_axis(0.5, 0.1), origin, point_light(0, 0, 0.25), 1);
    expect_visible(sphere_on_the_axis(5.5, 1), origin, point_light(0, 0, 4), 1);
}

TEST(visibility, a_sphere_far_from_the_point_but_in_front_of_the_light_hides_it)
{
    expect_visible(sphere_on_the_axis(9e5, 1e4), origin, point_light(0, 0, 1e6), 0);
    expect_visible(sphere_on_the_axis(9e-5, 1e-6), origin, point_light(0, 0, 1e-4), 0);
}

TEST(visibility, a_sphere_behind_the_point_hides_nothing)
{
    expect_visible(sphere_on_the_axis(-5, 1), origin, point_light(0, 0, 4), 1);
    expect_visible(sphere_on_the_axis(-5, 1), origin, distant_light(0, 0, 4), 1);
    expect_visible(sphere_on_the_axis(-1.5, 1), origin, point_light(0, 0, 4), 1);
}

TEST(visibility, a_distant_light_is_beyond_everything)
{
    expect_visible(sphere_on_the_axis(5, 1), origin, distant_light(0, 0, 1), 0);
    expect_visible(sphere_on_the_axis(1e6, 10), origin, distant_light(0, 0, 0.01), 0);
}

TEST(visibility, how_long_the_direction_of_a_distant_light_is_does_not_matter)
{
    const double lengths[] = {1e-6, 0.1, 1, 30, 1e6};
    for (int i = 0; i < 5; i++) {
        expect_visible(sphere_on_the_axis(5, 1), origin, distant_light(0, 0, lengths[i]), 0);
        expect_visible(sphere_on_the_axis(-5, 1), origin, distant_light(0, 0, lengths[i]), 1);
    }
}

static void expect_hidden_by_one_of_four(int which)
{
    World world;
    empty_world(&world);
    for (int i = 0; i < 4; i++)
        put_sphere(&world, i == which ? vec3_of(0, 0, 5) : vec3_of(3 + i, 0, 5), 1, dull());
    expect_visible(&world, origin, point_light(0, 0, 10), 0);
    expect_visible(&world, origin, distant_light(0, 0, 10), 0);
    expect_visible(&world, vec3_of(0, 5, 0), point_light(0, 5, 10), 1);
}

TEST(visibility, the_first_of_many_spheres_is_enough)
{
    expect_hidden_by_one_of_four(0);
}

TEST(visibility, the_last_of_many_spheres_is_enough)
{
    expect_hidden_by_one_of_four(3);
}

TEST(visibility, one_among_many_spheres_is_enough)
{
    expect_hidden_by_one_of_four(1);
    expect_hidden_by_one_of_four(2);
}

TEST(visibility, two_spheres_hide_a_light_no_more_than_one)
{
    const World *world =
        spheres_on_the_axis(3, (const double[]){3, 5, 8}, (const double[]){1, 0.5, 1});
    expect_visible(world, origin, point_light(0, 0, 10), 0);
    expect_visible(world, origin, distant_light(0, 0, 10), 0);
}

// The nearest of all does not hide it: it is behind the light, beside the way or behind the point.
TEST(visibility, of_spheres_only_those_in_between_count)
{
    const World *world =
        spheres_on_the_axis(3, (const double[]){-2, 5, 14}, (const double[]){1, 1, 1});
    expect_visible(world, origin, point_light(0, 0, 10), 0);
    expect_visible(world, origin, point_light(0, 0, 3), 1);
    expect_visible(world, vec3_of(0, 0, 8), point_light(0, 0, 12), 1);
}

TEST(visibility, from_inside_a_sphere_only_lights_inside_it_are_seen)
{
    expect_visible(sphere_on_the_axis(0, 5), vec3_of(0, 0, 1), point_light(0, 0, 10), 0);
    expect_visible(sphere_on_the_axis(0, 5), vec3_of(0, 0, 1), point_light(0, 0, 4), 1);
    expect_visible(sphere_on_the_axis(0, 5), vec3_of(0, 0, 1), point_light(3, 0, -3), 1);
    expect_visible(sphere_on_the_axis(0, 5), vec3_of(0, 0, 1), distant_light(0, 0, 0.1), 0);
}

TEST(visibility, a_light_inside_a_sphere_is_not_seen_from_outside)
{
    expect_visible(sphere_on_the_axis(9, 2), origin, point_light(0, 0, 9), 0);
    expect_visible(sphere_on_the_axis(9, 2), origin, point_light(0, 1, 8), 0);
}

TEST(visibility, a_sphere_close_to_the_point_also_hides_a_light)
{
    const double gaps[] = {3e-2, 3e-3, 3e-4, 3e-5, 3e-6, 3e-7, 3e-8};
    for (int i = 0; i < 7; i++) {
        const World *world = sphere_on_the_axis(1 + gaps[i], 1);
        expect_visible(world, origin, point_light(0, 0, 100), 0);
        expect_visible(world, origin, distant_light(0, 0, 1), 0);
        expect_visible(world, origin, distant_light(0, 0, 100), 0);
    }
}

TEST(visibility, a_sphere_close_to_a_light_also_hides_it)
{
    const double gaps[] = {1e-2, 1e-4, 1e-6};
    for (int i = 0; i < 3; i++) {
        double radius = gaps[i] / 4;
        expect_visible(sphere_on_the_axis(1 - gaps[i], radius), origin, point_light(0, 0, 1), 0);
        expect_visible(sphere_on_the_axis(1 + gaps[i], radius), origin, point_light(0, 0, 1), 1);
    }
}

TEST(visibility, glass_hides_a_light_like_anything_else)
{
    World world;
    Surface glass = surface_of(vec3_of(0.9, 0.9, 0.9), 0.1, 0.3, 9);
    glass.transmittance = 0.8;
    empty_world(&world);
    put_sphere(&world, vec3_of(0, 0, 5), 1, glass);
    given("known", "the sphere lets 0.8 of the light through");
    expect_visible(&world, origin, point_light(0, 0, 10), 0);
}

// ---- shade: the terms of each light, by hand ---------------------------------------------------

// A sphere of radius 1 whose highest point is the origin of the world, seen from straight above:
// there the normal is up, and so is the direction to the eye. Ambient is 0.5 * (0.8, 0.6, 0.4)
// times the ambient light.
static const Color ambient = {0.5 * 0.8 * 0.3, 0.5 * 0.6 * 0.2, 0.5 * 0.4 * 0.1};

static World world;

static void world_seen_from_above(double specular, double shine)
{
    empty_world(&world);
    put_sphere(&world, vec3_of(0, -1, 0), 1, surface_of(dull().color, 0.5, specular, shine));
}

// The light at 60 degrees, 10 away: the cosine is 1/2, on both sides of the normal.
static const vec3 at_60_degrees = {8.6602540378443864676, 5, 0};
static const Color yellow = {0.9, 0.7, 0.1}, blue = {0.1, 0.2, 0.8}, red = {0.7, 0.2, 0.3};

static Color diffuse(double cosine, Color light)
{
    return 0.5 * cosine * vec3_of(0.8, 0.6, 0.4) * light;
}

TEST(shade, without_lights_only_ambient_light_is_left)
{
    world_seen_from_above(0.4, 3);
    expect_shade(&world, EYE_ABOVE, HIT_AT_2, ambient);
    world.scene.ambient = vec3_of(1, 0.5, 0);
    expect_shade(&world, EYE_ABOVE, HIT_AT_2, vec3_of(0.4, 0.15, 0));
}

TEST(shade, a_light_straight_above_has_its_full_effect)
{
    for (int kind = LIGHT_POINT; kind <= LIGHT_DISTANT; kind++) {
        world_seen_from_above(0.4, 3);
        put_light(&world, (LightKind)kind, vec3_of(0, 9, 0), yellow);
        expect_shade(&world, EYE_ABOVE, HIT_AT_2, ambient + diffuse(1, yellow) + 0.4 * yellow);
    }
}

TEST(shade, a_dull_surface_has_no_highlight)
{
    world_seen_from_above(0, 3);
    put_light(&world, LIGHT_POINT, vec3_of(0, 9, 0), yellow);
    expect_shade(&world, EYE_ABOVE, HIT_AT_2, ambient + diffuse(1, yellow));
}

// 1/2 for diffuse, (1/2)^3 for the highlight, which has the colour of the light.
TEST(shade, a_light_at_an_angle_has_less_of_both_terms)
{
    for (int kind = LIGHT_POINT; kind <= LIGHT_DISTANT; kind++) {
        world_seen_from_above(0.4, 3);
        put_light(&world, (LightKind)kind, at_60_degrees, yellow);
        expect_shade(&world, EYE_ABOVE, HIT_AT_2,
                     ambient + diffuse(0.5, yellow) + 0.4 / 8 * yellow);
    }
}

// Light and eye at 60 degrees to the normal each, on opposite sides: the mirrored light meets it.
TEST(shade, the_highlight_is_where_the_mirrored_light_meets_the_eye)
{
    world_seen_from_above(0.4, 3);
    put_light(&world, LIGHT_POINT, at_60_degrees, yellow);
    vec3 eye = vec3_of(-at_60_degrees[0], at_60_degrees[1], 0);
    expect_shade(&world, (Ray){eye, -eye / 2}, HIT_AT_2,
                 ambient + diffuse(0.5, yellow) + 0.4 * yellow);
}

TEST(shade, if_the_mirrored_light_goes_away_from_the_eye_there_is_no_highlight)
{
    world_seen_from_above(0.4, 3);
    put_light(&world, LIGHT_POINT, at_60_degrees, yellow);
    vec3 eye = at_60_degrees / 2;
    expect_shade(&world, (Ray){eye, -eye / 2}, HIT_AT_2, ambient + diffuse(0.5, yellow));
}

TEST(shade, lights_add_up)
{
    world_seen_from_above(0.4, 3);
    put_light(&world, LIGHT_POINT, at_60_degrees, yellow);
    put_light(&world, LIGHT_DISTANT, vec3_of(0, 2, 0), blue);
    put_light(&world, LIGHT_POINT, vec3_of(0, 3, 0), red);
    expect_shade(&world, EYE_ABOVE, HIT_AT_2,
                 ambient + diffuse(0.5, yellow) + 0.4 / 8 * yellow + diffuse(1, blue) + 0.4 * blue +
                     diffuse(1, red) + 0.4 * red);
}

TEST(shade, in_the_shadow_the_ambient_light_is_left)
{
    for (int kind = LIGHT_POINT; kind <= LIGHT_DISTANT; kind++) {
        world_seen_from_above(0.4, 3);
        put_light(&world, (LightKind)kind, at_60_degrees, yellow);
        put_sphere(&world, at_60_degrees / 2, 1, dull());
        expect_shade(&world, EYE_ABOVE, HIT_AT_2, ambient);
        put_sphere(&world, 0.6 * at_60_degrees, 1, dull());
        expect_shade(&world, EYE_ABOVE, HIT_AT_2, ambient);
    }
}

TEST(shade, a_light_that_is_hidden_takes_nothing_from_the_others)
{
    for (int hidden = 0; hidden < 3; hidden++) {
        world_seen_from_above(0.4, 3);
        for (int i = 0; i < 3; i++)
            put_light(&world, LIGHT_POINT,
                      i == hidden ? vec3_of(-at_60_degrees[0], at_60_degrees[1], 0) : at_60_degrees,
                      i == 0   ? yellow
                      : i == 1 ? blue
                               : red);
        put_sphere(&world, vec3_of(-at_60_degrees[0], at_60_degrees[1], 0) / 2, 1, dull());
        Color all = yellow + blue + red;
        Color others = all - world.lights[hidden].color;
        expect_shade(&world, EYE_ABOVE, HIT_AT_2,
                     ambient + diffuse(0.5, others) + 0.4 / 8 * others);
    }
}

TEST(shade, a_sphere_behind_a_light_or_beside_it_makes_no_shadow)
{
    world_seen_from_above(0.4, 3);
    put_light(&world, LIGHT_POINT, at_60_degrees, yellow);
    put_sphere(&world, 1.5 * at_60_degrees, 1, dull());
    put_sphere(&world, vec3_of(-3, 3, 0), 1, dull());
    expect_shade(&world, EYE_ABOVE, HIT_AT_2, ambient + diffuse(0.5, yellow) + 0.4 / 8 * yellow);
}

TEST(shade, a_surface_that_is_turned_away_from_the_light_is_in_its_own_shadow)
{
    world_seen_from_above(0.4, 3);
    put_light(&world, LIGHT_POINT, vec3_of(0, -9, 0), yellow);
    put_light(&world, LIGHT_DISTANT, vec3_of(3, -1, 0), blue);
    expect_shade(&world, EYE_ABOVE, HIT_AT_2, ambient);
}

TEST(shade, bright_light_is_not_clamped)
{
    world_seen_from_above(0.4, 3);
    put_light(&world, LIGHT_POINT, vec3_of(0, 9, 0), 10 * yellow);
    expect_shade(&world, EYE_ABOVE, HIT_AT_2,
                 ambient + diffuse(1, 10 * yellow) + 0.4 * 10 * yellow);
}

// The other sphere is hit 1 to the left of the first; its own surface is plainer.
TEST(shade, the_surface_is_that_of_the_sphere_that_was_hit)
{
    world_seen_from_above(0.4, 3);
    put_sphere(&world, vec3_of(-5, -2, 0), 2, surface_of(vec3_of(0.3, 0.9, 0.5), 0.25, 0.75, 1));
    put_light(&world, LIGHT_DISTANT, vec3_of(0, 1, 0), yellow);
    expect_shade(&world, (Ray){vec3_of(-5, 4, 0), vec3_of(0, -2, 0)}, (Hit){2, 1},
                 0.25 * vec3_of(0.3, 0.9, 0.5) * (world.scene.ambient + yellow) + 0.75 * yellow);
}

TEST(shade, how_long_the_direction_of_the_ray_is_does_not_change_the_shade)
{
    const double lengths[] = {0.01, 1, 8, 4000};
    world_seen_from_above(0.4, 3);
    put_light(&world, LIGHT_POINT, at_60_degrees, yellow);
    for (int i = 0; i < 4; i++)
        expect_shade(&world, (Ray){vec3_of(0, 4, 0), vec3_of(0, -lengths[i], 0)},
                     (Hit){4 / lengths[i], 0}, ambient + diffuse(0.5, yellow) + 0.4 / 8 * yellow);
}

// Eye and light in a hollow sphere around the origin, opposite the point: its surface faces them.
TEST(shade, inside_a_sphere_the_normal_points_to_the_eye)
{
    empty_world(&world);
    put_sphere(&world, vec3_of(0, 0, 0), 6, surface_of(dull().color, 0.5, 0.4, 3));
    put_light(&world, LIGHT_POINT, vec3_of(0, -2, 0), yellow);
    put_light(&world, LIGHT_POINT, vec3_of(0, 9, 0), blue);
    put_light(&world, LIGHT_DISTANT, vec3_of(0, -1, 0), red);
    put_light(&world, LIGHT_DISTANT, vec3_of(0, 1, 0), red);
    expect_shade(&world, (Ray){vec3_of(0, 2, 0), vec3_of(0, 2, 0)}, HIT_AT_2,
                 ambient + diffuse(1, yellow) + 0.4 * yellow);
    expect_shade(&world, (Ray){vec3_of(0, 5, 0), vec3_of(0, 0.5, 0)}, HIT_AT_2,
                 ambient + diffuse(1, yellow) + 0.4 * yellow);
}

// A start that is off the surface by a part of such a coordinate would be inside.
TEST(shade, a_sphere_whose_coordinates_are_all_negative_is_lit)
{
    empty_world(&world);
    put_sphere(&world, vec3_of(-5, -9, -5), 2, surface_of(dull().color, 0.5, 0.4, 3));
    put_light(&world, LIGHT_DISTANT, vec3_of(0, 1, 0), yellow);
    expect_shade(&world, (Ray){vec3_of(-5, -3, -5), vec3_of(0, -2, 0)}, HIT_AT_2,
                 ambient + diffuse(1, yellow) + 0.4 * yellow);
}

// ---- trace_ray: mirrors, and how deep to look into them ----------------------------------------

// Mirrors on an axis, which send rays to and fro; a mirrored direction with sides 3, 4, 5 and 7,
// 24, 25.

static const Color green = {0.2, 0.9, 0.3}, pink = {0.9, 0.4, 0.6};

// On the axis z, on both sides of the origin.
static void facing_mirrors(double ks, double other_ks)
{
    empty_world(&world);
    put_sphere(&world, vec3_of(0, 0, -5), 1, mirror(green, ks));
    put_sphere(&world, vec3_of(0, 0, 8), 2, mirror(pink, other_ks));
}

static const Ray ahead = {{0, 0, 0}, {0, 0, -2}}, behind = {{0, 0, 0}, {0, 0, 3}},
                 upward = {{0, 0, 0}, {0, 1, 0}};

TEST(trace_ray, if_nothing_is_hit_the_background_is_seen)
{
    for (int depth = 0; depth < 3; depth++) {
        facing_mirrors(0.5, 0.25);
        put_light(&world, LIGHT_POINT, vec3_of(0, 9, 0), white);
        expect_trace(&world, upward, depth, world.scene.background);
        empty_world(&world);
        expect_trace(&world, upward, depth, world.scene.background);
    }
}

TEST(trace_ray, at_depth_0_a_mirror_shows_only_itself)
{
    facing_mirrors(0.5, 0.25);
    expect_trace(&world, ahead, 0, ambient_of(&world, 0));
    expect_trace(&world, behind, 0, ambient_of(&world, 1));
    put_light(&world, LIGHT_POINT, vec3_of(0, 0, 0), pink);
    expect_trace(&world, ahead, 0, lit_from_the_eye(&world, 0, pink));
}

TEST(trace_ray, a_surface_without_specular_is_not_a_mirror)
{
    facing_mirrors(0, 0.25);
    for (int depth = 0; depth < 4; depth++)
        expect_trace(&world, ahead, depth, ambient_of(&world, 0));
    expect_trace(&world, behind, 3, ambient_of(&world, 1) + 0.25 * ambient_of(&world, 0));
    put_light(&world, LIGHT_POINT, vec3_of(0, 0, 0), pink);
    expect_trace(&world, ahead, 3, lit_from_the_eye(&world, 0, pink));
}

TEST(trace_ray, a_mirror_also_shows_the_background)
{
    empty_world(&world);
    put_sphere(&world, vec3_of(0, 0, -5), 1, mirror(green, 0.5));
    for (int depth = 1; depth < 4; depth++)
        expect_trace(&world, ahead, depth, ambient_of(&world, 0) + 0.5 * world.scene.background);
}

TEST(trace_ray, one_mirror_shows_the_other)
{
    facing_mirrors(0.5, 0.25);
    expect_trace(&world, ahead, 1, ambient_of(&world, 0) + 0.5 * ambient_of(&world, 1));
    expect_trace(&world, behind, 1, ambient_of(&world, 1) + 0.25 * ambient_of(&world, 0));
}

TEST(trace_ray, mirrors_that_face_each_other_are_seen_as_often_as_depth_says)
{
    facing_mirrors(0.5, 0.25);
    for (int depth = 0; depth <= 6; depth++) {
        expect_trace(&world, ahead, depth,
                     to_and_fro(ambient_of(&world, 0), 0.5, ambient_of(&world, 1), 0.25, depth));
        expect_trace(&world, behind, depth,
                     to_and_fro(ambient_of(&world, 1), 0.25, ambient_of(&world, 0), 0.5, depth));
    }
}

TEST(trace_ray, a_perfect_mirror_loses_no_light)
{
    facing_mirrors(1, 1);
    expect_trace(&world, ahead, 20, 11 * ambient_of(&world, 0) + 10 * ambient_of(&world, 1));
}

TEST(trace_ray, objects_in_a_mirror_are_lit_as_usual)
{
    facing_mirrors(0.5, 0.25);
    put_light(&world, LIGHT_POINT, vec3_of(0, 0, 0), pink);
    for (int depth = 1; depth <= 3; depth++)
        expect_trace(&world, ahead, depth,
                     to_and_fro(lit_from_the_eye(&world, 0, pink), 0.5,
                                lit_from_the_eye(&world, 1, pink), 0.25, depth));
}

// Bright light from the centre; the sum is not clamped on the way.
TEST(trace_ray, bright_light_is_not_clamped_in_mirrors_either)
{
    facing_mirrors(0.5, 0.25);
    put_light(&world, LIGHT_POINT, vec3_of(0, 0, 0), 8 * white);
    expect_trace(&world, ahead, 2,
                 to_and_fro(lit_from_the_eye(&world, 0, 8 * white), 0.5,
                            lit_from_the_eye(&world, 1, 8 * white), 0.25, 2));
}

// Hit at (3, 0, 4), where the normal is (3, 0, 4) / 5: a ray along -z leaves along (24, 0, 7).
// Other spheres are straight on, along the normal, in the opposite direction, and back at the
// start; and a lamp is inside the ball, where no ray should see it.
TEST(trace_ray, the_angle_out_is_the_angle_in)
{
    const vec3 hit = {3, 0, 4}, mirrored = {0.96, 0, 0.28};
    empty_world(&world);
    put_sphere(&world, vec3_of(0, 0, 0), 5, mirror(green, 0.5));
    put_sphere(&world, hit + 10 * mirrored, 1, surface_of(pink, 0.7, 0, 1));
    put_sphere(&world, hit - 10 * mirrored, 1, surface_of(green, 0.9, 0, 1));
    put_sphere(&world, hit + 3 * hit, 1, surface_of(green, 0.8, 0, 1));
    put_sphere(&world, vec3_of(3, 0, -20), 1, surface_of(green, 0.6, 0, 1));
    put_sphere(&world, vec3_of(3, 0, 20), 1, surface_of(green, 0.4, 0, 1));
    put_light(&world, LIGHT_POINT, vec3_of(1, 2, 0), white);
    expect_trace(&world, (Ray){vec3_of(3, 0, 10), vec3_of(0, 0, -2)}, 1,
                 ambient_of(&world, 0) + 0.5 * ambient_of(&world, 1));
    expect_trace(&world, (Ray){vec3_of(3, 0, 10), vec3_of(0, 0, -2)}, 5,
                 ambient_of(&world, 0) + 0.5 * ambient_of(&world, 1));
}

TEST(trace_ray, how_long_the_direction_of_the_ray_is_does_not_matter)
{
    const double lengths[] = {0.01, 1, 7, 5000};
    facing_mirrors(0.5, 0.25);
    put_light(&world, LIGHT_POINT, vec3_of(0, 0, 0), pink);
    for (int i = 0; i < 4; i++)
        expect_trace(&world, (Ray){vec3_of(0, 0, 0), vec3_of(0, 0, -lengths[i])}, 2,
                     to_and_fro(lit_from_the_eye(&world, 0, pink), 0.5,
                                lit_from_the_eye(&world, 1, pink), 0.25, 2));
}

TEST(trace_ray, inside_a_hollow_mirror_a_ray_stays_inside)
{
    empty_world(&world);
    put_sphere(&world, vec3_of(0, 0, 0), 6, mirror(green, 0.5));
    put_sphere(&world, vec3_of(0, 0, 20), 6, mirror(pink, 0.5));
    put_light(&world, LIGHT_POINT, vec3_of(0, 0, 0), pink);
    for (int i = 0; i < 10; i++)
        expect_trace(&world, (Ray){vec3_of(0, 0, 1), vec3_of(0, 0, i < 5 ? 2 : 0.03)}, i % 5,
                     to_and_fro(lit_from_the_eye(&world, 0, pink), 0.5,
                                lit_from_the_eye(&world, 0, pink), 0.5, i % 5));
}

// ---- scenes of any size, and random ones -------------------------------------------------------

// The colour in a mirror must not depend on how far a right answer goes off its surface: random
// mirrors face each other on an axis, or their colours are ambient only.

// ---- visibility ---------------------------------------------------------------------------------

// The shadow of a sphere in the light of a point is a cone: its half angle has the sine radius /
// distance. Points behind the sphere, a little inside that cone and a little outside.
TEST(visibility, in_an_eclipse_the_shadow_is_a_cone)
{
    for (int i = 0; i < 20; i++) {
        empty_world(&world);
        double scale = random_size(1e6), moon = random_number(0.2, 2), away = random_number(3, 9);
        vec3 sun = random_vec3(-5, 5), axis = random_unit();
        vec3 aside = vec3_unit(vec3_cross(axis, random_unit()));
        double sine = moon / away, tangent = sine / sqrt(1 - sine * sine);
        double beyond = away + random_number(2.1, 9);
        put_sphere(&world, (sun + away * axis) * scale, moon * scale, dull());
        Light light = {.position = sun * scale, .color = {1, 1, 1}, .kind = LIGHT_POINT};
        for (int k = 0; k < 2; k++) {
            double within = k == 0 ? random_number(0, 0.99) : random_number(1.01, 1.3);
            vec3 place = sun + beyond * axis + within * beyond * tangent * aside;
            expect_visible(&world, place * scale, light, k);
        }
    }
}

TEST(visibility, any_spheres_hide_any_light_as_geometry_says)
{
    double visible;
    for (int i = 0, seen = 0, hidden = 0; i < 40 || seen < 8 || hidden < 8;) {
        double size = random_size(1e6);
        random_world(&world, 5, 1, size);
        vec3 from = random_vec3(-6, 6) * size;
        if (!exact_visibility(&world, from, world.lights[0], &visible))
            continue;
        expect_visible(&world, from, world.lights[0], visible);
        i++;
        *(visible > 0 ? &seen : &hidden) += 1;
    }
}

// ---- shade --------------------------------------------------------------------------------------

// A hit is right only to within rounding. So these are in front of the surface or behind it by
// 5e-11 of the radius, less than the smallest step of off_surface.
TEST(shade, a_hit_that_rounding_put_just_inside_the_sphere_is_lit)
{
    for (int i = -6; i <= 8; i += 2) {
        double size = pow(10, i);
        for (int side = -1; side <= 1; side++) {
            empty_world(&world);
            put_sphere(&world, vec3_of(0, -size, 0), size, surface_of(dull().color, 0.5, 0.4, 3));
            put_light(&world, LIGHT_POINT, size * at_60_degrees, yellow);
            Ray ray = {vec3_of(0, 4 * size, 0), vec3_of(0, -size, 0)};
            expect_shade(&world, ray, (Hit){4 + side * 5e-11, 0},
                         ambient_of(&world, 0) + diffuse(0.5, yellow) + 0.4 / 8 * yellow);
            ray.origin = vec3_of(0, 0.001 * size, 0); // the eye is close, and t counts from there
            expect_shade(&world, ray, (Hit){0.001 + side * 5e-11, 0},
                         ambient_of(&world, 0) + diffuse(0.5, yellow) + 0.4 / 8 * yellow);
        }
    }
}

// The crumb is this many radii above it, and half as large: in the way of the light from above,
// beside the way of the other, whose mirror image meets the eye.
TEST(shade, a_tiny_sphere_close_to_the_surface_casts_its_shadow)
{
    for (int i = 0; i < 30; i++) {
        double size = pow(10, 8 - i % 15), above = i < 15 ? 1e-5 : 1e-7;
        empty_world(&world);
        put_sphere(&world, vec3_of(0, -size, 0), size, surface_of(dull().color, 0.5, 0.4, 3));
        put_sphere(&world, vec3_of(0, above * size, 0), above / 2 * size, dull());
        put_light(&world, LIGHT_DISTANT, vec3_of(0, 1, 0), yellow);
        put_light(&world, LIGHT_DISTANT, at_60_degrees, blue);
        vec3 eye = 0.5 * size * vec3_of(-at_60_degrees[0], at_60_degrees[1], 0);
        Ray ray = {eye, -eye};
        expect_shade(&world, ray, (Hit){1, 0},
                     ambient_of(&world, 0) + diffuse(0.5, blue) + 0.4 * blue);
    }
}

TEST(shade, any_lights_on_any_spheres_give_what_geometry_says)
{
    for (int i = 0; i < 40;) {
        double size = random_size(1e6);
        Color expected;
        Hit hit;
        random_world(&world, 4, 3, size);
        Ray ray = random_view(&world, size);
        if (!exact_hit(&world, ray, &hit) || !exact_shade(&world, ray, &expected))
            continue;
        expect_shade(&world, ray, hit, expected);
        i++;
    }
}

// ---- trace_ray ----------------------------------------------------------------------------------

// A gap of 1e-5 of the radius between two spheres, along whose axis the eye looks from inside the
// gap.
TEST(trace_ray, mirrors_may_be_close_together_in_scenes_of_any_size)
{
    for (int i = 8; i >= -6; i -= 2) {
        double size = pow(10, i);
        empty_world(&world);
        put_sphere(&world, vec3_of(0, 0, -1.000005 * size), size, mirror(yellow, 0.5));
        put_sphere(&world, vec3_of(0, 0, 1.000005 * size), size, mirror(blue, 0.25));
        expect_trace(&world, (Ray){vec3_of(0, 0, 0), vec3_of(0, 0, -size)}, 4,
                     to_and_fro(ambient_of(&world, 0), 0.5, ambient_of(&world, 1), 0.25, 4));
    }
}

// A single ball mirrors everything except itself, even if the eye is close to it and the origin of
// the world is far away.
TEST(trace_ray, a_ball_does_not_see_itself)
{
    for (int i = 0; i < 40; i++) {
        double size = random_size(1e6), away = pow(10, i % 2 == 0 ? 5 : random_number(0, 5));
        empty_world(&world);
        world.scene.background = random_scene_color();
        vec3 center = size * away * random_unit();
        double ks = random_number(0.2, 0.9);
        put_sphere(&world, center, size, mirror(random_scene_color(), ks));
        double distance = 1 + (i % 2 == 0 ? 1e-6 : random_number(0.1, 9));
        vec3 from = center + distance * size * random_unit();
        vec3 at = center + 0.6 * size * random_unit();
        expect_trace(&world, (Ray){from, at - from}, 1 + i % 3,
                     ambient_of(&world, 0) + ks * world.scene.background);
    }
}

TEST(trace_ray, on_any_axis_and_in_any_light_mirrors_face_each_other)
{
    for (int i = 0; i < 20; i++) {
        double size = random_size(1e6), ks = random_number(0.2, 0.9);
        double other_ks = random_number(0.2, 0.9);
        vec3 eye = size * random_vec3(-5, 5), axis = random_unit();
        double radius = random_number(0.5, 3), other_radius = random_number(0.5, 3);
        double away = radius + random_number(1, 4), other_away = other_radius + random_number(1, 4);
        Color light = random_scene_color();
        empty_world(&world);
        world.scene.ambient = random_scene_color();
        world.scene.background = random_scene_color();
        put_sphere(&world, eye + size * away * axis, size * radius,
                   mirror(random_scene_color(), ks));
        put_sphere(&world, eye - size * other_away * axis, size * other_radius,
                   mirror(random_scene_color(), other_ks));
        put_light(&world, LIGHT_POINT, eye, light);
        int depth = i % 4;
        Ray ray = {eye, size * random_number(0.1, 9) * axis};
        expect_trace(&world, ray, depth,
                     to_and_fro(lit_from_the_eye(&world, 0, light), ks,
                                lit_from_the_eye(&world, 1, light), other_ks, depth));
    }
}

TEST(trace_ray, any_mirrors_show_what_geometry_says)
{
    for (int i = 0; i < 40;) {
        double size = random_size(1e6);
        Color expected;
        random_world(&world, 6, 0, size);
        Ray ray = random_view(&world, size);
        int depth = i % 3;
        if (!exact_trace(&world, ray, depth, &expected))
            continue;
        expect_trace(&world, ray, depth, expected);
        i++;
    }
}

// ---- no limit is right: how many, how near, how far, how deep or how weak ---------------------

// Ladders: an answer with a limit fails at the first rung after it, and that rung names the limit.
// Any number of things is allowed: first as many as an answer with a fixed size has room for, and
// then one more.

static const vec3 onward = {0, 0, 1};

enum { RUNGS = 12 };

// 0.3, 0.03 ... 3e-12 and 30, 300 ... 3e12.
static double down(int i)
{
    return 3 * pow(10, -1 - i);
}

static double how_far_up(int i)
{
    return 3 * pow(10, 1 + i);
}

static Light light_at(LightKind kind, vec3 position)
{
    return (Light){.position = position, .color = white, .kind = kind};
}

// ---- visibility ---------------------------------------------------------------------------------

// One sphere whose near side is at this distance, a tenth of that large.
static void one_sphere(double t)
{
    empty_world(&world);
    put_sphere(&world, 1.1 * t * onward, 0.1 * t, dull());
}

TEST(visibility, a_sphere_hides_a_light_however_near_it_is)
{
    for (int i = 0; i < RUNGS; i++) {
        one_sphere(down(i));
        expect_visible(&world, origin, light_at(LIGHT_POINT, onward), 0);
        expect_visible(&world, origin, light_at(LIGHT_DISTANT, onward), 0);
    }
}

TEST(visibility, a_sphere_hides_a_light_beyond_it_however_far_it_is)
{
    for (int i = 0; i < RUNGS; i++) {
        one_sphere(how_far_up(i));
        expect_visible(&world, origin, light_at(LIGHT_DISTANT, onward), 0);
        expect_visible(&world, origin, light_at(LIGHT_POINT, 2 * how_far_up(i) * onward), 0);
        expect_visible(&world, origin, light_at(LIGHT_POINT, 0.9 * how_far_up(i) * onward), 1);
    }
}

TEST(visibility, a_sphere_in_between_hides_a_light_at_any_distance)
{
    for (int i = 0; i < RUNGS; i++) {
        one_sphere(1);
        expect_visible(&world, origin, light_at(LIGHT_DISTANT, down(i) * onward), 0);
        expect_visible(&world, origin, light_at(LIGHT_DISTANT, how_far_up(i) * onward), 0);
        expect_visible(&world, origin, light_at(LIGHT_POINT, how_far_up(i) * onward), 0);
    }
}

// By a part of the radius that is ten times the allowed error of a hit: the surface is that close
// in front of the light, or beyond it. The farther the light, the smaller that is compared with the
// way to it.
TEST(visibility, a_sphere_just_in_front_of_a_light_hides_it_and_one_just_behind_does_not)
{
    for (int i = 0; i < 6; i++) {
        double away = i < 3 ? 10 : 900, gap = pow(10, -3 - i % 3);
        empty_world(&world);
        put_sphere(&world, (away + 1 - gap) * onward, 1, dull());
        expect_visible(&world, origin, light_at(LIGHT_POINT, away * onward), 0);
        empty_world(&world);
        put_sphere(&world, (away + 1 + gap) * onward, 1, dull());
        expect_visible(&world, origin, light_at(LIGHT_POINT, away * onward), 1);
    }
}

static const int rooms[] = {8, 10, 16, 20, 32, 50, 64, 100, 128, 256};
enum { ROOMS = sizeof rooms / sizeof *rooms };

TEST(visibility, the_last_of_any_number_of_spheres_hides_a_light)
{
    for (int i = 0; i <= 2 * ROOMS; i++) {
        int count = i < 2 * ROOMS ? rooms[i / 2] + i % 2 : MOST_SPHERES;
        empty_world(&world);
        for (int k = 1; k < count; k++)
            put_sphere(&world, vec3_of(2 + k, 3, 9), 1, dull());
        put_sphere(&world, 5 * onward, 1, dull());
        expect_visible(&world, origin, light_at(LIGHT_POINT, 10 * onward), 0);
    }
}

// ---- shade --------------------------------------------------------------------------------------

static Surface shiny(double kd, double ks, double shine)
{
    return surface_of(vec3_of(0.8, 0.6, 0.4), kd, ks, shine);
}

// The highest point of a sphere of radius 1 is the origin of the world.
static void surface_seen_from_above(Surface surface)
{
    empty_world(&world);
    put_sphere(&world, vec3_of(0, -1, 0), 1, surface);
}

static Color ambient_seen(void)
{
    return ambient_of(&world, 0);
}

// Straight above, where the light has its full effect: the colour of each light is its number.
TEST(shade, the_last_of_any_number_of_lights_counts)
{
    static const int most[] = {2, 3, 4, 5, 8, 10, 16, 20, 32};
    for (int i = 0; i < 18; i++) {
        int count = most[i / 2] + i % 2;
        Color sum = vec3_of(0, 0, 0);
        surface_seen_from_above(shiny(0.5, 0.4, 3));
        for (int k = 0; k < count; k++) {
            Color color = (k == count - 1 ? 0.5 : 0.01) * vec3_of(0.9, 0.7, 0.5);
            sum += color;
            put_light(&world, k % 2 == 0 ? LIGHT_POINT : LIGHT_DISTANT, vec3_of(0, 9 + k, 0),
                      color);
        }
        expect_shade(&world, EYE_ABOVE, HIT_AT_2,
                     ambient_seen() + 0.5 * vec3_of(0.8, 0.6, 0.4) * sum + 0.4 * sum);
    }
}

TEST(shade, light_of_any_strength_is_scattered_and_mirrored)
{
    for (int i = 0; i < 2 * RUNGS; i++) {
        double strength = i < RUNGS ? down(i) : how_far_up(i - RUNGS);
        Color color = strength * vec3_of(0.9, 0.7, 0.5);
        surface_seen_from_above(shiny(0.5, 0.4, 3));
        world.scene.ambient *= strength;
        world.scene.background *= strength;
        put_light(&world, LIGHT_POINT, vec3_of(0, 9, 0), color);
        expect_shade(&world, EYE_ABOVE, HIT_AT_2,
                     ambient_seen() + 0.5 * vec3_of(0.8, 0.6, 0.4) * color + 0.4 * color);
    }
}

// 0.3, 0.03 ... 3e-7, above the horizon of a white light.
enum { SMALL_SCENES = 7 };

TEST(shade, a_light_is_scattered_however_low_it_is)
{
    for (int i = 0; i < SMALL_SCENES; i++) {
        double cosine = down(i) / hypot(1, down(i));
        surface_seen_from_above(shiny(0.5, 0, 3));
        put_light(&world, LIGHT_DISTANT, vec3_of(1, down(i), 0), white);
        expect_shade(&world, EYE_ABOVE, HIT_AT_2,
                     ambient_seen() + 0.5 * cosine * vec3_of(0.8, 0.6, 0.4));
    }
}

TEST(shade, a_surface_counts_however_little_it_reflects)
{
    for (int i = 0; i < SMALL_SCENES; i++) {
        surface_seen_from_above(shiny(0.5, down(i), 3));
        put_light(&world, LIGHT_DISTANT, vec3_of(0, 1, 0), white);
        expect_shade(&world, EYE_ABOVE, HIT_AT_2,
                     ambient_seen() + 0.5 * vec3_of(0.8, 0.6, 0.4) + down(i) * white);
        surface_seen_from_above(shiny(down(i), 0.4, 3));
        put_light(&world, LIGHT_DISTANT, vec3_of(0, 1, 0), white);
        expect_shade(&world, EYE_ABOVE, HIT_AT_2,
                     ambient_seen() + down(i) * vec3_of(0.8, 0.6, 0.4) + 0.4 * white);
    }
}

// From straight above the highlight is all of ks, whatever its power; at 60 degrees 2^-shine of it.
TEST(shade, a_surface_has_its_own_shine)
{
    const double shines[] = {0, 0.5, 1, 2, 10, 20};
    for (int i = 0; i < 6; i++) {
        surface_seen_from_above(shiny(0.5, 0.4, shines[i]));
        put_light(&world, LIGHT_DISTANT, vec3_of(0.86602540378443864676, 0.5, 0), white);
        expect_shade(&world, EYE_ABOVE, HIT_AT_2,
                     ambient_seen() + 0.25 * vec3_of(0.8, 0.6, 0.4) +
                         0.4 * pow(2, -shines[i]) * white);
    }
}

TEST(shade, at_any_t_a_surface_is_lit)
{
    for (int i = 0; i < 2 * RUNGS; i++) {
        double t = i < RUNGS ? down(i) : how_far_up(i - RUNGS);
        surface_seen_from_above(shiny(0.5, 0.4, 3));
        put_light(&world, LIGHT_POINT, vec3_of(0, 9, 0), white);
        expect_shade(&world, (Ray){vec3_of(0, 4, 0), vec3_of(0, -4 / t, 0)}, (Hit){t, 0},
                     ambient_seen() + 0.5 * vec3_of(0.8, 0.6, 0.4) + 0.4 * white);
    }
}

// ---- trace_ray ----------------------------------------------------------------------------------

// Two mirrors on the axis, 4 in front of the eye and 6 behind it.
static void facing(double ks, double other_ks)
{
    empty_world(&world);
    put_sphere(&world, vec3_of(0, 0, 5), 1, mirror(vec3_of(0.2, 0.9, 0.3), ks));
    put_sphere(&world, vec3_of(0, 0, -8), 2, mirror(vec3_of(0.9, 0.4, 0.6), other_ks));
}

TEST(trace_ray, mirrors_are_followed_as_deep_as_depth_says)
{
    static const int depths[] = {2, 3, 4, 5, 6, 8, 10, 15, 16, 20, 30, 32, 50, 64, 99, 100, 128};
    for (int i = 0; i < 34; i++) {
        int depth = depths[i / 2] + i % 2;
        facing(1, 1);
        expect_trace(&world, (Ray){origin, 2 * onward}, depth,
                     to_and_fro(ambient_of(&world, 0), 1, ambient_of(&world, 1), 1, depth));
    }
}

TEST(trace_ray, a_mirror_counts_however_weak_it_is)
{
    for (int i = 0; i < SMALL_SCENES; i++) {
        empty_world(&world);
        world.scene.background = white;
        put_sphere(&world, vec3_of(0, 0, 5), 1, mirror(vec3_of(0.2, 0.9, 0.3), down(i)));
        expect_trace(&world, (Ray){origin, 2 * onward}, 3, ambient_of(&world, 0) + down(i) * white);
    }
}

// In each other they show less and less: 0.04, 0.0016 ... 3e-7 of the light.
TEST(trace_ray, light_through_many_mirrors_counts_however_little_it_is)
{
    for (int depth = 0; depth <= 5; depth++) {
        facing(0.04, 0.04);
        world.scene.ambient = 3 * white;
        expect_trace(&world, (Ray){origin, 2 * onward}, depth,
                     to_and_fro(ambient_of(&world, 0), 0.04, ambient_of(&world, 1), 0.04, depth));
    }
}

TEST(trace_ray, at_any_t_there_is_a_mirror)
{
    for (int i = 0; i < 2 * RUNGS; i++) {
        facing(0.5, 0.25);
        expect_trace(&world, (Ray){origin, (i < RUNGS ? down(i) : how_far_up(i - RUNGS)) * onward},
                     2, to_and_fro(ambient_of(&world, 0), 0.5, ambient_of(&world, 1), 0.25, 2));
    }
}

TEST(trace_ray, the_last_of_any_number_of_spheres_is_mirrored)
{
    for (int i = 0; i <= 2 * ROOMS; i++) {
        int count = i < 2 * ROOMS ? rooms[i / 2] + i % 2 : MOST_SPHERES;
        facing(0.5, 0);
        world.scene.sphere_count = 1;
        for (int k = 2; k < count; k++)
            put_sphere(&world, vec3_of(2 + k, 3, 0), 1, dull());
        put_sphere(&world, vec3_of(0, 0, -8), 2, dull());
        expect_trace(&world, (Ray){origin, 2 * onward}, 1,
                     ambient_of(&world, 0) + 0.5 * ambient_of(&world, count - 1));
    }
}

// ---- probes -------------------------------------------------------------------------------------

// Calls that distinguish the mistakes of exercise 07: colours and lights that are neither grey nor
// full, lights and eyes on either side of the surface, worlds of several spheres and lights.

enum { MANY = 16 };

PROBE(surface_normal, normals_of_any_sphere)
{
    for (int i = 0; i < MANY; i++) {
        Sphere sphere = random_sphere(5, 0.2, 4);
        surface_normal(sphere, sphere.center + sphere.radius * random_unit());
    }
}

PROBE(ray_to_light, ways_to_any_light)
{
    for (int i = 0; i < MANY; i++) {
        Light light = {.position = random_vec3(-5, 5), .color = random_color(0.1, 1.5)};
        light.kind = i % 2 == 0 ? LIGHT_POINT : LIGHT_DISTANT;
        ray_to_light(random_vec3(-5, 5), light);
    }
}

PROBE(ambient_term, ambient_of_any_surface)
{
    for (int i = 0; i < MANY; i++) {
        Color surface = random_color(0.1, 0.9);
        double kd = random_number(0.1, 0.9);
        ambient_term(surface, kd, random_color(0.1, i % 4 == 3 ? 9 : 0.9));
    }
}

// From either side, of any length.
static vec3 any_way(vec3 normal, int i)
{
    vec3 way = random_unit();
    if ((vec3_dot(way, normal) < 0) != (i % 4 == 3))
        way = -way;
    return random_number(0.3, 4) * way;
}

PROBE(diffuse_term, diffuse_of_any_surface)
{
    for (int i = 0; i < MANY; i++) {
        Color surface = random_color(0.1, 0.9);
        double kd = random_number(0.1, 0.9);
        Color light = random_color(0.1, i % 4 == 2 ? 20 : 1.5);
        vec3 normal = random_unit();
        diffuse_term(surface, kd, light, normal, any_way(normal, i));
    }
}

PROBE(mirror_direction, mirrored_directions)
{
    for (int i = 0; i < MANY; i++) {
        vec3 normal = random_unit();
        mirror_direction(random_number(0.3, 4) * random_unit(), normal);
    }
}

typedef Color Highlight(double ks, double shine, Color light, vec3 normal, vec3 to_light,
                        vec3 to_eye);

// An eye behind the surface: for Phong the contract leaves the result free; half-way it must see
// nothing if the normal and the half-way vector are more than 90 degrees apart.
static bool may_be_behind(Highlight *term, vec3 normal, vec3 to_light, vec3 to_eye)
{
    return vec3_dot(normal, to_eye) > 0 ||
           (term == halfway_term && vec3_dot(normal, vec3_unit(to_light) + vec3_unit(to_eye)) < 0);
}

// Most eyes near the mirrored light, so that there is a highlight; some on its other side.
static void ask_for_highlights(Highlight *term)
{
    for (int i = 0; i < 3 * MANY; i++) {
        double ks = random_number(0.1, 0.9), shine = random_number(0.5, 9);
        Color light = random_color(0.1, i % 4 == 0 ? 30 : 1.5);
        if (i % 6 == 5)
            shine = 1 + i / 6 % 3;
        bool sharp = i % 6 == 1; // close to the middle of a small highlight
        if (sharp)
            shine = random_number(12, 60);
        vec3 normal = random_unit(), to_light = any_way(normal, i);
        vec3 mirrored = 2 * vec3_dot(normal, to_light) * normal - to_light;
        vec3 to_eye = mirrored + random_number(0, sharp        ? 0.1
                                                  : i % 4 == 2 ? 3
                                                               : 0.8) *
                                     vec3_length(mirrored) * random_unit();
        if (i % 6 == 5)
            to_eye = -to_eye;
        if (i % 8 == 3) // behind, as both are
            to_eye = -to_light + 0.4 * normal;
        if (!may_be_behind(term, normal, to_light, to_eye))
            to_eye -= 2 * vec3_dot(to_eye, normal) * normal;
        term(ks, shine, light, normal, to_light, random_number(0.3, 4) * to_eye);
    }
}

// Far from the mirrored light: eye and light on the same side, low over the surface.
static void ask_for_no_highlights(Highlight *term)
{
    for (int i = 0; i < MANY; i++) {
        double ks = random_number(0.1, 0.9), shine = random_number(0.5, 9);
        if (i % 4 == 3)
            shine = 1 + i / 4 % 3;
        vec3 normal = random_unit(), across = random_across(normal);
        vec3 to_light = across + random_number(0.1, 0.6) * normal;
        vec3 to_eye = across + random_number(0.1, 0.6) * normal +
                      random_number(0, 0.5) * random_across(normal);
        term(ks, shine, random_color(0.1, 1.5), normal, random_number(0.3, 4) * to_light,
             random_number(0.3, 4) * to_eye);
    }
}

PROBE(phong_term, highlights_of_phong)
{
    ask_for_highlights(phong_term);
    ask_for_no_highlights(phong_term);
}

PROBE(halfway_term, highlights_half_way)
{
    ask_for_highlights(halfway_term);
    ask_for_no_highlights(halfway_term);
}

PROBE(off_surface, steps_off_any_surface)
{
    for (int i = 0; i < 2 * MANY; i++) {
        Sphere sphere = random_sphere(2, 0.2, 4);
        // Far away along one axis: the step is visible in the others.
        if (i % 4 != 3)
            sphere.center[i % 3] = (i % 2 == 0 ? 1 : -1) * random_number(300, 3000);
        vec3 normal = random_unit();
        off_surface(sphere, sphere.center + sphere.radius * normal, i % 2 == 0 ? normal : -normal);
    }
}

// From 1e-7 to 1, small as often as large, so that every threshold is between two of them.
static double any_small(void)
{
    return pow(10, random_number(-7, 0));
}

// A sphere that the ray from one point to another enters after some part of the way; 0 to 1 is
// between the two.
static void put_on_the_way(World *room, vec3 from, vec3 to, double part)
{
    vec3 way = to - from, normal = random_unit();
    if (vec3_dot(normal, way) > 0)
        normal = -normal;
    double radius = random_number(0.2, 1.5);
    put_sphere(room, from + part * way - radius * normal, radius, random_surface());
}

PROBE(visibility, what_arrives_anywhere)
{
    for (int i = 0; i < 8 * MANY; i++) {
        World room;
        random_world(&room, i % 3, 1 + i % 5, 1);
        Light light = room.lights[0];
        vec3 from = random_vec3(-7, 7);
        vec3 to = light.kind == LIGHT_POINT ? light.position : from + light.position;
        double part = i % 9 == 6   ? random_number(1.2, 2)
                      : i % 8 < 3  ? random_number(0.1, 0.9)
                      : i % 8 == 3 ? any_small()
                      : i % 8 == 4 ? 1 - any_small()
                      : i % 8 == 5 ? random_number(1.01, 3)
                      : i % 8 == 6 ? -random_number(0.05, 1)
                                   : -0.01;
        put_on_the_way(&room, from, to, part);
        if (i % 9 == 6) // the first beyond the light, the last in front of it
            put_on_the_way(&room, from, to, random_number(0.2, 0.8));
        if (i % 5 == 0)
            put_on_the_way(&room, from, to, random_number(-1, 2));
        for (int k = 0; k < room.scene.surface_count; k++)
            room.surfaces[k].transmittance = random_number(0.1, 0.9);
        visibility(&room.scene, from, light);
    }
}

// Most spheres are visible, and some of their lights are hidden from them; some eyes are inside.
static Ray any_view(World *room, int i)
{
    random_world(room, 2 + i % 6, i % 4, 1);
    Ray ray = random_view(room, 1);
    if (i % 5 == 4)
        ray.origin = room->spheres[0].center + 0.6 * room->spheres[0].radius * random_unit();
    if (i % 10 == 9)
        ray.direction = random_number(0.2, 0.9) * vec3_unit(ray.direction);
    if (i % 6 == 3) { // two that are equal
        room->spheres[1].center = room->spheres[0].center;
        room->spheres[1].radius = room->spheres[0].radius;
    }
    if (i % 20 == 7) // and lights that do not count
        room->scene.light_count = 0;
    Hit hit = nearest_hit(ray, &room->scene);
    vec3 point = ray.origin + hit.t * ray.direction;
    if (hit.sphere >= 0 && room->scene.light_count > 0 && i % 3 == 0 &&
        room->lights[0].kind == LIGHT_POINT)
        put_on_the_way(room, point, room->lights[0].position, random_number(0.2, 0.8));
    if (i % 7 == 6)
        for (int k = 0; k < room->scene.light_count; k++)
            room->lights[k].color *= 9;
    if (i % 9 == 8)
        for (int k = 1; k < room->scene.surface_count; k++)
            room->surfaces[k].specular = 0;
    return ray;
}

PROBE(shade, light_of_any_surface)
{
    for (int i = 0; i < 5 * MANY; i++) {
        World room;
        Ray ray = any_view(&room, i);
        Hit hit = nearest_hit(ray, &room.scene);
        if (hit.sphere >= 0)
            shade(&room.scene, ray, hit);
    }
}

// Inside one, with a lamp between the place and the centre.
// In worlds of any size.
static void scale(World *room, Ray *ray, double size)
{
    for (int i = 0; i < room->scene.sphere_count; i++) {
        room->spheres[i].center *= size;
        room->spheres[i].radius *= size;
    }
    for (int i = 0; i < room->scene.light_count; i++)
        room->lights[i].position *= size;
    ray->origin *= size;
    ray->direction *= size;
}

PROBE(shade, light_in_any_size)
{
    for (int i = 0; i < 2 * MANY; i++) {
        World room;
        Ray ray = any_view(&room, i);
        scale(&room, &ray, pow(10, random_number(-5, 4)));
        Hit hit = nearest_hit(ray, &room.scene);
        if (hit.sphere >= 0)
            shade(&room.scene, ray, hit);
    }
}

PROBE(trace_ray, what_is_seen_in_any_size)
{
    for (int i = 0; i < 2 * MANY; i++) {
        World room;
        Ray ray = any_view(&room, i);
        scale(&room, &ray, pow(10, random_number(-5, 4)));
        trace_ray(&room.scene, ray, i % 3);
    }
}

PROBE(shade, light_of_near_lamps)
{
    for (int i = 0; i < MANY; i++) {
        World room;
        random_world(&room, 0, 0, 1);
        vec3 center = random_vec3(-5, 5), axis = random_unit();
        double radius = random_number(0.5, 3);
        put_sphere(&room, center, radius, random_surface());
        put_light(&room, LIGHT_POINT, center + random_number(0.3, 0.8) * radius * axis,
                  random_color(0.2, 1));
        Ray ray = {center + random_number(-0.5, 0.2) * radius * axis, axis + 0.1 * random_unit()};
        shade(&room.scene, ray, nearest_hit(ray, &room.scene));
    }
}

// From edge to edge: with eye and light opposite each other, close above the surface.
PROBE(shade, light_that_grazes)
{
    for (int i = 0; i < MANY; i++) {
        World room;
        random_world(&room, 0, 0, 1);
        vec3 center = random_vec3(-5, 5), normal = random_unit(), across = random_across(normal);
        double radius = random_number(0.5, 3);
        Surface surface = random_surface();
        surface.shine = random_number(1, 3);
        put_sphere(&room, center, radius, surface);
        vec3 to_light = -across + random_number(0.1, 0.4) * normal;
        put_light(&room, LIGHT_DISTANT, random_number(0.2, 0.7) * to_light, random_color(0.2, 1));
        vec3 to_eye = across + random_number(0.1, 0.4) * normal;
        Ray ray = {center + radius * normal + 3 * radius * to_eye, -to_eye};
        shade(&room.scene, ray, nearest_hit(ray, &room.scene));
    }
}

PROBE(trace_ray, what_any_ray_sees)
{
    for (int i = 0; i < 6 * MANY; i++) {
        World room;
        Ray ray = any_view(&room, i);
        trace_ray(&room.scene, i % 8 == 7 ? random_ray(6, 2) : ray, i % 4 == 0 ? 0 : 1 + i % 3);
    }
}

// So deep that one level more is visible: mirrors that face each other.
PROBE(trace_ray, what_is_seen_in_many_mirrors)
{
    for (int depth = 0; depth < 9; depth++) {
        World room;
        random_world(&room, 0, 2, 1);
        vec3 axis = random_unit();
        for (int side = -1; side <= 1; side += 2)
            put_sphere(&room, side * 3 * axis, 2, mirror(random_color(0.2, 0.9), 0.95));
        trace_ray(&room.scene, (Ray){vec3_of(0, 0, 0), axis}, depth);
    }
}

PROBE(clamp_color, clamped_colors)
{
    for (int i = 0; i < 3 * MANY; i++) {
        Color color = random_color(-0.7, 1.7);
        if (i % 3 == 2)
            color[i / 3 % 3] = i / 9 % 2;
        clamp_color(color);
    }
    // Below, inside and above, in each combination.
    for (int i = 0; i < 27; i++)
        clamp_color(vec3_of(i % 3 - random_number(0.2, 0.8), i / 3 % 3 - random_number(0.2, 0.8),
                            i / 9 - random_number(0.2, 0.8)));
}

PROBE(gamma_encode, encoded_colors)
{
    for (int i = 0; i < MANY; i++) {
        Color color = random_color(0.02, 0.98);
        if (i % 4 == 3)
            color[i / 4 % 3] = random_number(0, 0.003);
        gamma_encode(color, random_number(0.4, 4));
    }
}
