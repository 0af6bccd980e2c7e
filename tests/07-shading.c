// 07-shading.c - tests of exercise 07. Expected values: terms worked out by hand with cosines that
// are short numbers, and vectors that were constructed from the angles that they must have.
#include "exercises/07-shading.h"
#include "exercises/06-ray-casting.h"

#include "tests/judge/test.h"

#include <stdio.h>
#include <string.h>

#define TOLERANCE 1e-9 // of the arguments, and of the light

static Sphere sphere_at(vec3 center, double radius)
{
    return (Sphere){.center = center, .radius = radius};
}

// The largest of its three numbers, without their signs.
static double largest(vec3 v)
{
    return fmax(fabs(v[0]), fmax(fabs(v[1]), fabs(v[2])));
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

// ---- the world of a test ------------------------------------------------------------------------

enum { MOST_SPHERES = 300, MOST_LIGHTS = 40 };

// A scene, and the arrays it points to. Sphere i has surface i + 1, so that an answer that confuses
// the two numbers is noticed; no sphere has surface 0, which is unlike all others.
static struct {
    Scene scene;
    Sphere spheres[MOST_SPHERES];
    Surface surfaces[MOST_SPHERES + 1];
    Light lights[MOST_LIGHTS];
} world;

static const vec3 origin = {0, 0, 0}, straight_up = {0, 1, 0}, onward = {0, 0, 1};
static const Color black = {0, 0, 0}, white = {1, 1, 1}, yellow = {0.9, 0.7, 0.1},
                   blue = {0.1, 0.2, 0.8}, red = {0.7, 0.2, 0.3}, green = {0.2, 0.9, 0.3},
                   pink = {0.9, 0.4, 0.6};

static Light light_of(LightKind kind, vec3 position, Color color)
{
    return (Light){.position = position, .color = color, .kind = kind};
}

static Light point_light(double x, double y, double z)
{
    return light_of(LIGHT_POINT, vec3_of(x, y, z), vec3_of(0.9, 0.8, 0.7));
}

static Light distant_light(double x, double y, double z)
{
    return light_of(LIGHT_DISTANT, vec3_of(x, y, z), vec3_of(0.9, 0.8, 0.7));
}

// Only a background and an ambient light, neither black, white nor grey.
static void empty_world(void)
{
    memset(&world, 0, sizeof world);
    world.surfaces[0] = (Surface){{0.35, 0.95, 0.05}, 0.45, 0.55, 7, 0, 1};
    world.scene = (Scene){.background = vec3_of(0.25, 0.45, 0.65),
                          .ambient = vec3_of(0.3, 0.2, 0.1),
                          .spheres = world.spheres,
                          .surfaces = world.surfaces,
                          .surface_count = 1,
                          .lights = world.lights};
    // The light after the last one is too bright, for answers that count one too many.
    for (int i = 0; i < MOST_LIGHTS; i++)
        world.lights[i] = distant_light(0.3, 0.5, 0.2);
}

static void put_sphere(vec3 center, double radius, Surface surface)
{
    int i = world.scene.sphere_count++;
    world.spheres[i] = (Sphere){.center = center, .radius = radius, .surface = i + 1};
    world.surfaces[i + 1] = surface;
    world.scene.surface_count = i + 2;
}

static void put_light(LightKind kind, vec3 position, Color color)
{
    world.lights[world.scene.light_count++] = light_of(kind, position, color);
}

// The colors of a surface: kd, ks, shine.
static Surface surface_of(Color color, double diffuse, double specular, double shine)
{
    return (Surface){.color = color, .diffuse = diffuse, .specular = specular, .shine = shine};
}

static Surface shiny(double kd, double ks, double shine)
{
    return surface_of(vec3_of(0.8, 0.6, 0.4), kd, ks, shine);
}

static Surface dull(void)
{
    return shiny(0.5, 0, 1);
}

static Surface mirror(Color color, double specular)
{
    return surface_of(color, 0.5, specular, 3);
}

static Color random_color(void)
{
    return random_vec3(0.1, 0.9);
}

static Surface random_surface(void)
{
    Color color = random_color();
    double diffuse = random_number(0.2, 0.9), specular = random_number(0.1, 0.8);
    return surface_of(color, diffuse, specular, random_number(1, 20));
}

// From 1 / most to most, small as often as large.
static double random_size(double most)
{
    return pow(most, random_number(-1, 1));
}

// Spheres that may overlap, lights of both kinds, all within a cube of about 16 sizes.
static void random_world(int spheres, int lights, double size)
{
    empty_world();
    world.scene.background = random_color();
    world.scene.ambient = random_color();
    for (int i = 0; i < spheres; i++) {
        vec3 center = random_vec3(-4, 4) * size;
        double radius = random_number(0.5, 2) * size;
        put_sphere(center, radius, random_surface());
    }
    for (int i = 0; i < lights; i++) {
        LightKind kind = random_number(0, 1) < 0.4 ? LIGHT_DISTANT : LIGHT_POINT;
        vec3 position = random_vec3(-8, 8) * size;
        put_light(kind, position, random_color());
    }
}

// Towards one of the spheres, from anywhere, even from inside spheres.
static Ray random_view(double size)
{
    int i = (int)random_number(0, world.scene.sphere_count);
    const Sphere *sphere = &world.spheres[i];
    vec3 at = sphere->center + 0.8 * sphere->radius * random_unit();
    vec3 from = random_vec3(-6, 6) * size;
    return (Ray){from, random_number(0.1, 3) * (at - from)};
}

static Color ambient_of(int sphere)
{
    const Surface *surface = scene_surface(&world.scene, sphere);
    return surface->diffuse * surface->color * world.scene.ambient;
}

// A sphere as seen from the light, straight ahead.
static Color lit_from_the_eye(int sphere, Color light)
{
    const Surface *surface = scene_surface(&world.scene, sphere);
    return ambient_of(sphere) + surface->diffuse * surface->color * light +
           surface->specular * light;
}

// Two mirrors that face each other and have a light at the eye: the one, the other in it, the one
// in that ... The same mirror twice is the inside of a hollow one.
static Color to_and_fro(int one, int other, Color light, int depth)
{
    Color sum = black;
    double share = 1;
    for (int i = 0; i <= depth; i++) {
        int here = i % 2 == 0 ? one : other;
        sum += share * lit_from_the_eye(here, light);
        share *= scene_surface(&world.scene, here)->specular;
    }
    return sum;
}

// ---- how it is described ------------------------------------------------------------------------

enum { MOST_SHOWN = 10 };

static void given_light(const char *label, Light light)
{
    given(label, "%s %s, color %s", light.kind == LIGHT_DISTANT ? "distant, towards" : "point, at",
          vec3_text_to(light.position, 10).s, vec3_text(light.color).s);
}

static void given_lights(void)
{
    int count = world.scene.light_count;
    if (count == 0)
        given("lights", "none");
    for (int i = 0; i < count && i < MOST_SHOWN; i++) {
        char label[16];
        snprintf(label, sizeof label, "light %d", i % 100);
        given_light(label, world.lights[i]);
    }
    if (count > MOST_SHOWN)
        given("and more", "%d lights in all", count);
}

static void given_spheres(bool with_surfaces)
{
    int count = world.scene.sphere_count;
    if (count == 0)
        given("spheres", "none");
    for (int i = 0; i < count && i < MOST_SHOWN; i++) {
        const Sphere *sphere = &world.spheres[i];
        const Surface *s = scene_surface(&world.scene, i);
        char label[24], looks[240] = "";
        snprintf(label, sizeof label, "sphere %d", i % 100);
        if (with_surfaces)
            snprintf(looks, sizeof looks, ", color %.60s, kd %.20s, ks %.20s, shine %.20s",
                     vec3_text(s->color).s, number_text(s->diffuse).s, number_text(s->specular).s,
                     number_text(s->shine).s);
        given(label, "center %s, radius %s%s", vec3_text_to(sphere->center, 10).s,
              number_text_to(sphere->radius, 10).s, looks);
    }
    if (count > MOST_SHOWN)
        given("and more", "%d in all", count);
}

static void given_world(void)
{
    given_spheres(true);
    given("ambient", "%s", vec3_text(world.scene.ambient).s);
    given("background", "%s", vec3_text(world.scene.background).s);
    given_lights();
}

static void expect_visible(vec3 from, Light light, double expected)
{
    given_spheres(false);
    given_vec3("from", from);
    given_light("light", light);
    expect_number(visibility(&world.scene, from, light), expected, 0);
}

// The tolerance of a color is a part of the light in the scene.
static double color_tolerance(void)
{
    double most = fmax(largest(world.scene.ambient), largest(world.scene.background));
    for (int i = 0; i < world.scene.light_count; i++)
        most = fmax(most, largest(world.lights[i].color));
    return TOLERANCE * most;
}

static void expect_shade(Ray ray, Hit hit, Color expected)
{
    given_world();
    given_ray(ray);
    given("hit", "t = %s, sphere %d", number_text_to(hit.t, 17).s, hit.sphere);
    expect_vec3(shade(&world.scene, ray, hit), expected, color_tolerance());
}

static void expect_trace(Ray ray, int depth, Color expected)
{
    given_world();
    given_ray(ray);
    given("depth", "%d", depth);
    expect_vec3(trace_ray(&world.scene, ray, depth), expected, color_tolerance());
}

// ---- the same by geometry -----------------------------------------------------------------------

// Light and mirrors without an offset. A ray that leaves a sphere outwards never meets it again;
// one that leaves it inwards meets it at the end of a chord. So no ray must be moved off the
// surface that it starts from.
typedef struct {
    vec3 from, along;
    int own;     // the sphere on whose surface it starts; -1: none
    bool inside; // of that sphere
} Way;

// Whether anything was nearer to an edge than this, in radii or in lengths of the ray: there
// rounding may decide.
static const double doubt = 2e-3;
static bool doubtful;

static void doubt_if(bool close)
{
    doubtful = doubtful || close;
}

// The first t > 0 at which the ray meets sphere i, from the foot of the perpendicular; -1 if none.
static double first_meeting(Way way, int i)
{
    double r = world.spheres[i].radius, length = vec3_length(way.along);
    vec3 along = way.along / length, from_center = way.from - world.spheres[i].center;
    double foot = -vec3_dot(from_center, along);
    if (i == way.own) { // half the chord is as long as the way to the foot
        doubt_if(fabs(foot) < doubt * r);
        return !way.inside ? (foot > 0 ? 0 : -1) : foot > 0 ? 2 * foot / length : 0;
    }
    double aside = vec3_length(from_center + foot * along);
    doubt_if(fabs(aside - r) < doubt * r);
    if (aside >= r)
        return -1;
    double half = sqrt((r - aside) * (r + aside)), near = foot - half, far = foot + half;
    doubt_if(fabs(near) < doubt * r || fabs(far) < doubt * r);
    return near > 0 ? near / length : far > 0 ? far / length : -1;
}

static bool arrives(Way way, Light light)
{
    bool point = light.kind == LIGHT_POINT, free = true;
    way.along = point ? light.position - way.from : light.position;
    for (int i = 0; i < world.scene.sphere_count; i++) {
        double t = first_meeting(way, i);
        doubt_if(point && fabs(t - 1) < doubt);
        free = free && (t < 0 || (point && t > 1));
    }
    return free;
}

static Hit nearest(Way way)
{
    Hit found = {NO_HIT, -1};
    for (int i = 0; i < world.scene.sphere_count; i++) {
        double t = first_meeting(way, i);
        if (t < 0)
            continue;
        doubt_if(found.sphere >= 0 && fabs(t - found.t) < doubt * found.t);
        if (t < found.t)
            found = (Hit){t, i};
    }
    return found;
}

// What a light adds; the way leads back to the eye. The cosine between the mirrored light and the
// eye is 2 (n.l)(n.e) - l.e.
static Color light_at(Way back, vec3 normal, Light light)
{
    const Surface *surface = scene_surface(&world.scene, back.own);
    bool distant = light.kind == LIGHT_DISTANT;
    vec3 l = vec3_unit(distant ? light.position : light.position - back.from);
    vec3 e = vec3_unit(back.along);
    double cosine = vec3_dot(normal, l);
    if (!arrives(back, light) || cosine <= 0)
        return black;
    double mirrored = 2 * cosine * vec3_dot(normal, e) - vec3_dot(l, e);
    double highlight = mirrored > 0 ? surface->specular * pow(mirrored, surface->shine) : 0;
    return (surface->diffuse * cosine * surface->color + highlight) * light.color;
}

// The color that a ray sees; false if something is in doubt. A loop: share is that of the next
// color that comes through all the mirrors so far.
static bool trace_by_geometry(Ray ray, int depth, Color *color)
{
    Way way = {ray.origin, ray.direction, -1, false};
    *color = black;
    doubtful = false;
    for (double share = 1; depth >= 0 && share > 0; depth--) {
        Hit hit = nearest(way);
        *color += share * (hit.sphere < 0 ? world.scene.background : ambient_of(hit.sphere));
        if (hit.sphere < 0)
            break;
        vec3 point = way.from + hit.t * way.along;
        vec3 normal = vec3_unit(point - world.spheres[hit.sphere].center);
        bool inside = vec3_dot(normal, way.along) > 0;
        normal = inside ? -normal : normal;
        way = (Way){point, -way.along, hit.sphere, inside};
        for (int i = 0; i < world.scene.light_count; i++)
            *color += share * light_at(way, normal, world.lights[i]);
        way.along = 2 * vec3_dot(way.along, normal) * normal - way.along;
        share *= scene_surface(&world.scene, hit.sphere)->specular;
    }
    return !doubtful;
}

// The first hit of the ray, if there is one, and its shade.
static bool shade_by_geometry(Ray ray, Hit *hit, Color *color)
{
    *hit = nearest((Way){ray.origin, ray.direction, -1, false});
    return trace_by_geometry(ray, 0, color) && hit->sphere >= 0;
}

static bool visibility_by_geometry(vec3 from, Light light, double *visibility)
{
    doubtful = false;
    *visibility = arrives((Way){from, from, -1, false}, light);
    return !doubtful;
}

// ---- ladders ------------------------------------------------------------------------------------

// No light is too weak, too low, too far or too bright to count, and no scene too small or too
// large. An answer with a limit fails at the first rung after it, and that rung names the limit.

// 0.3, 0.03 ... 3e-8 is the smallest that the tolerance of a color still distinguishes from 0; in
// a sum of several terms it is 3e-7.
enum { SMALL = 8, SMALL_IN_SCENES = 7, RUNGS = 12 };

static double small(int i)
{
    return 3 * pow(10, -1 - i);
}

static double large(int i)
{
    return 3 * pow(10, 1 + i);
}

// Sizes of worlds and strengths of light: 1, 0.001 ... 1e-12, then 1000 ... 1e12.
enum { SIZES = 9 };

static double size_number(int i)
{
    return pow(10, i < 5 ? -3 * i : 3 * (i - 4)) * random_number(0.5, 2);
}

// Lengths of a vector of which only the direction counts.
static const double lengths[] = {5, 10, 500, 0.05, 1e-3, 1e6, 1e-6, 1e9, 1e-9, 1e12, 1e-12};
enum { LENGTHS = sizeof lengths / sizeof *lengths };

// ---- surface_normal -----------------------------------------------------------------------------

static void expect_normal(Sphere sphere, vec3 point, vec3 normal)
{
    given_sphere(sphere);
    given_vec3("point", point);
    expect_vec3(surface_normal(sphere, point), normal, TOLERANCE);
}

TEST(surface_normal, at_the_top_of_a_sphere_the_normal_points_up)
{
    expect_normal(sphere_at(vec3_of(0, 0, 0), 1), vec3_of(0, 1, 0), vec3_of(0, 1, 0));
    expect_normal(sphere_at(vec3_of(1, 2, -3), 1), vec3_of(1, 3, -3), vec3_of(0, 1, 0));
    expect_normal(sphere_at(vec3_of(1, 2, -3), 4), vec3_of(1, 6, -3), vec3_of(0, 1, 0));
}

TEST(surface_normal, on_opposite_sides_the_normals_are_opposite)
{
    expect_normal(sphere_at(vec3_of(5, 0, -7), 2), vec3_of(7, 0, -7), vec3_of(1, 0, 0));
    expect_normal(sphere_at(vec3_of(5, 0, -7), 2), vec3_of(3, 0, -7), vec3_of(-1, 0, 0));
}

// (2, 3, 6) is 7 long.
TEST(surface_normal, a_normal_is_unit_however_large_the_sphere_is)
{
    vec3 normal = vec3_of(2, 3, 6) / 7;
    expect_normal(sphere_at(vec3_of(4, -1, 2), 7), vec3_of(6, 2, 8), normal);
    expect_normal(sphere_at(vec3_of(4, -1, 2), 700), vec3_of(204, 299, 602), normal);
    expect_normal(sphere_at(vec3_of(4, -1, 2), 0.07), vec3_of(4.02, -0.97, 2.06), normal);
}

TEST(surface_normal, a_normal_is_unit_in_worlds_of_any_size)
{
    for (int i = 0; i < SIZES; i++) {
        double size = size_number(i);
        vec3 center = 3 * size * random_unit(), normal = random_unit();
        expect_normal(sphere_at(center, size), center + size * normal, normal);
    }
}

// ---- ray_to_light -------------------------------------------------------------------------------

static void expect_ray_to_light(vec3 from, Light light, vec3 direction)
{
    double tolerance = TOLERANCE * fmax(largest(from), largest(light.position));
    given_vec3("from", from);
    given_light("light", light);
    given("looking at", "the origin");
    Ray ray = ray_to_light(from, light);
    expect_vec3(ray.origin, from, tolerance);
    given_vec3("from", from);
    given_light("light", light);
    given("looking at", "the direction");
    expect_vec3(ray.direction, direction, tolerance);
}

static const Color light_color = {0.9, 0.5, 0.7}, surface_color = {0.8, 0.3, 0.6};

TEST(ray_to_light, a_point_light_is_at_t_1)
{
    Light light = light_of(LIGHT_POINT, vec3_of(4, 6, 3), vec3_of(0.9, 0.7, 0.8));
    expect_ray_to_light(vec3_of(1, 2, 3), light, vec3_of(3, 4, 0));
    expect_ray_to_light(vec3_of(0, 0, 0), light, vec3_of(4, 6, 3));
    expect_ray_to_light(vec3_of(5, 6, -4), light, vec3_of(-1, 0, 7));
}

TEST(ray_to_light, a_distant_light_has_one_direction_from_everywhere)
{
    Light light = light_of(LIGHT_DISTANT, vec3_of(1, 3, -2), vec3_of(0.9, 0.7, 0.8));
    expect_ray_to_light(vec3_of(1, 2, 3), light, vec3_of(1, 3, -2));
    expect_ray_to_light(vec3_of(-50, 4, 70), light, vec3_of(1, 3, -2));
    expect_ray_to_light(vec3_of(0, 0, 0), light, vec3_of(1, 3, -2));
}

TEST(ray_to_light, the_way_to_a_light_has_the_right_length_in_worlds_of_any_size)
{
    for (int i = 0; i < SIZES; i++) {
        double size = size_number(i);
        vec3 from = size * random_vec3(-9, 9), way = size * random_number(0.5, 9) * random_unit();
        expect_ray_to_light(from, light_of(LIGHT_POINT, from + way, white), way);
        expect_ray_to_light(from, light_of(LIGHT_DISTANT, way, white), way);
    }
}

// ---- mirror_direction ---------------------------------------------------------------------------

static void expect_mirrored(vec3 direction, vec3 normal, vec3 mirrored)
{
    given_vec3("direction", direction);
    given_vec3("normal", normal);
    expect_vec3(mirror_direction(direction, normal), mirrored, TOLERANCE * vec3_length(direction));
}

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

// By hand: (3, 3, -3) goes 3 along (2, 2, 1) / 3, so twice that, (4, 4, 2), is subtracted.
TEST(mirror_direction, a_mirror_has_two_sides)
{
    expect_mirrored(vec3_of(1, 1, 0), straight_up, vec3_of(1, -1, 0));
    expect_mirrored(vec3_of(3, 3, -3), vec3_of(2, 2, 1) / 3, vec3_of(-1, -1, -5));
}

TEST(mirror_direction, the_part_along_the_normal_is_reversed_and_the_part_across_it_stays)
{
    for (int i = 0; i < 2 * SIZES; i++) {
        double size = size_number(i % SIZES);
        vec3 normal = random_unit(), across = random_across(normal);
        vec3 along = size * random_number(-5, 5) * normal;
        across *= size * random_number(0.5, 5);
        expect_mirrored(along + across, normal, across - along);
    }
}

TEST(mirror_direction, a_ray_that_grazes_a_mirror_is_also_mirrored)
{
    for (int i = 0; i < SMALL; i++) {
        expect_mirrored(vec3_of(1, -small(i), 0), straight_up, vec3_of(1, small(i), 0));
        expect_mirrored(vec3_of(0, small(i), -1), straight_up, vec3_of(0, -small(i), -1));
    }
}

// ---- ambient_term -------------------------------------------------------------------------------

static void expect_ambient(Color surface, double kd, Color ambient, Color color)
{
    given_vec3("surface", surface);
    given_number("kd", kd);
    given_vec3("ambient", ambient);
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
TEST(ambient_term, ambient_light_is_multiplied_color_by_color)
{
    expect_ambient(vec3_of(0.8, 0.5, 0.2), 0.5, vec3_of(0.1, 0.2, 0.6), vec3_of(0.04, 0.05, 0.06));
    expect_ambient(vec3_of(1, 0, 0), 0.5, vec3_of(0, 1, 1), vec3_of(0, 0, 0));
}

TEST_LINE(ambient_term, strong_ambient_light_may_be_brighter_than_white,
          expect_ambient(vec3_of(0.9, 0.5, 0.1), 1, vec3_of(4, 3, 2), vec3_of(3.6, 1.5, 0.2)))

// The result is chosen, and the ambient light made to fit.
TEST(ambient_term, a_chosen_term_is_found_again_in_ambient_light_of_any_strength)
{
    for (int i = 0; i < 2 * SIZES; i++) {
        double strength = size_number(i % SIZES);
        Color surface = random_vec3(0.3, 1), color = strength * random_vec3(0, 1);
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
    given_vec3("surface", surface);
    given_number("kd", kd);
    given_vec3("light", light);
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

TEST(diffuse_term, a_light_may_be_at_any_distance)
{
    for (int i = 0; i < LENGTHS; i++)
        expect_diffuse_share(lengths[i] * vec3_of(0.6, 0.8, 0), 0.8);
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
TEST(diffuse_term, light_is_multiplied_color_by_color)
{
    expect_diffuse(vec3_of(0.8, 0.5, 0.2), 0.6, vec3_of(0.5, 1, 2), vec3_of(-1, 2, 2) / 3,
                   vec3_of(3, 0, 4), vec3_of(0.08, 0.1, 0.08));
    expect_diffuse(vec3_of(1, 0, 0), 0.6, vec3_of(0, 1, 1), straight_up, vec3_of(1, 5, 1),
                   vec3_of(0, 0, 0));
}

TEST_LINE(diffuse_term, a_bright_light_may_be_scattered_brighter_than_white,
          expect_diffuse(vec3_of(0.9, 0.5, 0.1), 1, vec3_of(8, 8, 8), straight_up, vec3_of(0, 3, 4),
                         vec3_of(4.32, 2.4, 0.48)))

TEST(diffuse_term, at_a_chosen_angle_its_cosine_is_scattered)
{
    for (int i = 0; i < 30; i++) {
        Color surface = random_vec3(0.2, 1), light = random_vec3(0.2, 2);
        double kd = random_number(0.2, 1), degrees = random_number(0, 180);
        vec3 normal = random_unit(), to_light = turned(normal, degrees, random_across(normal));
        double share = degrees < 90 ? kd * cos(degrees * PI / 180) : 0;
        expect_diffuse(surface, kd, light, normal, random_number(0.1, 10) * to_light,
                       vec3_of(share * surface[0] * light[0], share * surface[1] * light[1],
                               share * surface[2] * light[2]));
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

TEST(diffuse_term, a_light_is_scattered_even_if_it_is_very_low)
{
    for (int i = 0; i < SMALL; i++) {
        double cosine = small(i) / hypot(1, small(i));
        expect_diffuse_share(vec3_of(1, small(i), 0), cosine);
    }
}

// ---- phong_term, halfway_term: highlights -------------------------------------------------------

typedef Color Highlight(double ks, double shine, Color light, vec3 normal, vec3 to_light,
                        vec3 to_eye);

static void expect_highlight(Highlight *term, double ks, double shine, Color light, vec3 normal,
                             vec3 to_light, vec3 to_eye, Color color)
{
    given_number("ks", ks);
    given_number("shine", shine);
    given_vec3("light", light);
    given_vec3("normal", normal);
    given_vec3("to light", to_light);
    given_vec3("to eye", to_eye);
    expect_vec3(term(ks, shine, light, normal, to_light, to_eye), color,
                TOLERANCE * largest(light));
}

// All of a white light, over a horizontal surface.
static void expect_share(Highlight *term, double shine, vec3 to_light, vec3 to_eye, double share)
{
    expect_highlight(term, 1, shine, white, straight_up, to_light, to_eye, share * white);
}

// The same if the eye is there, and the light where the cosine that counts is that of the eye and
// the normal: straight above the surface for Phong; halfway between a direction and itself is that
// direction.
static void expect_share_at(Highlight *term, double shine, vec3 there, double share)
{
    expect_share(term, shine, term == phong_term ? straight_up : there, there, share);
}

#define expect_phong(...) expect_highlight(phong_term, __VA_ARGS__)
#define expect_phong_share(...) expect_share(phong_term, __VA_ARGS__)
#define expect_halfway(...) expect_highlight(halfway_term, __VA_ARGS__)
#define expect_halfway_share(...) expect_share(halfway_term, __VA_ARGS__)

// A test of each. The cosine that counts is 4 / 5 if the light is straight above and the eye aside.
#define TEST_BOTH(name_of_phong, name_of_halfway)                                                  \
    static void test_##name_of_phong(Highlight *term, vec3 aside);                                 \
    TEST(phong_term, name_of_phong)                                                                \
    {                                                                                              \
        test_##name_of_phong(phong_term, vec3_of(0.6, 0.8, 0));                                    \
    }                                                                                              \
    TEST(halfway_term, name_of_halfway)                                                            \
    {                                                                                              \
        test_##name_of_phong(halfway_term, vec3_of(0.96, 0.28, 0));                                \
    }                                                                                              \
    static void test_##name_of_phong(Highlight *term, __attribute__((unused)) vec3 aside)

TEST_BOTH(an_eye_in_the_mirrored_direction_sees_ks_of_the_light,
          if_the_normal_is_half_way_ks_of_the_light_is_seen)
{
    const Color light = vec3_of(0.9, 0.7, 0.8);
    const vec3 normal[] = {straight_up, straight_up, vec3_of(1, 0, 0)};
    const vec3 to_light[] = {vec3_of(0, 1, 0), vec3_of(4, 3, 0), vec3_of(1, 2, 2)};
    const vec3 to_eye[] = {vec3_of(0, 1, 0), vec3_of(-4, 3, 0), vec3_of(1, -2, -2)};
    for (int shine = 1; shine < 100; shine *= 3)
        for (int i = 0; i < 3; i++)
            expect_highlight(term, 0.5, shine, light, normal[i], to_light[i], to_eye[i], light / 2);
}

// ---- Phong's ------------------------------------------------------------------------------------

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
    for (int i = 0; i < LENGTHS; i++) {
        expect_phong_share(1.5, lengths[i] * vec3_of(0.8, 0.6, 0), vec3_of(0, 0.6, 0.8), 0.216);
        expect_phong_share(1.5, vec3_of(0.8, 0.6, 0), lengths[i] * vec3_of(0, 0.6, 0.8), 0.216);
    }
}

TEST(phong_term, a_highlight_has_the_color_of_the_light)
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
        Color light = random_vec3(0.2, 2);
        double share = off < 90 ? ks * pow(cos(off * PI / 180), shine) : 0;
        to_light *= random_number(0.1, 10);
        if (vec3_dot(normal, to_eye) > 0.01)
            expect_phong(ks, shine, light, normal, to_light, random_number(0.1, 10) * to_eye,
                         share * light);
    }
}

// ---- Blinn's, by the halfway vector ------------------------------------------------------------

// Halfway between (0, 1, 0) and (24, 7, 0) / 25 is (3, 4, 0) / 5: twice (3, 4, 0) / 5 times the
// cosine 4 / 5 is their sum. Its cosine with the normal is 4 / 5.
TEST(halfway_term, the_cosine_with_the_normal_is_raised_to_the_power_of_shine)
{
    vec3 eye = vec3_of(0.96, 0.28, 0), eye_aside = vec3_of(0, 0.28, -0.96);
    expect_halfway_share(1, vec3_of(0, 1, 0), eye, 0.8);
    expect_halfway_share(2, vec3_of(0, 1, 0), eye, 0.64);
    expect_halfway_share(3, vec3_of(0, 1, 0), eye_aside, 0.512);
    expect_halfway_share(4, eye, vec3_of(0, 1, 0), 0.4096);
}

// Halfway between a direction and itself is that direction; the cosine of (12, 9, 20) / 25 with
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
    for (int i = 0; i < LENGTHS; i++) {
        expect_halfway_share(2, lengths[i] * vec3_of(0, 1, 0), vec3_of(0.96, 0.28, 0), 0.64);
        expect_halfway_share(2, vec3_of(0, 1, 0), lengths[i] * vec3_of(0.96, 0.28, 0), 0.64);
    }
}

TEST(halfway_term, this_highlight_also_has_the_color_of_the_light)
{
    expect_halfway(0.5, 2, vec3_of(1, 0.5, 0), straight_up, vec3_of(0, 1, 0), vec3_of(24, 7, 0),
                   vec3_of(0.32, 0.16, 0));
    expect_halfway(0.25, 1, vec3_of(8, 12, 0.2), straight_up, vec3_of(0, 1, 0), vec3_of(24, 7, 0),
                   vec3_of(1.6, 2.4, 0.04));
}

// Halfway between (4, 3, 0) / 5 and the eye is below the surface: there the cosine is negative,
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

// The halfway vector is at a chosen angle from the normal; light and eye are equally far from it,
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
        Color light = random_vec3(0.2, 2);
        double cosine = vec3_dot(normal, to_light);
        double share = cosine > 0 ? ks * pow(cos(off * PI / 180), shine) : 0;
        to_light *= random_number(0.1, 10);
        if (fabs(cosine) > 0.01 && vec3_dot(normal, to_eye) > 0.01)
            expect_halfway(ks, shine, light, normal, to_light, random_number(0.1, 10) * to_eye,
                           share * light);
    }
}

// ---- both, of any angle and shine ---------------------------------------------------------------

// The light is a little above the surface; mirrored, (-1, e, 0). The eye is at 45 degrees.
TEST(phong_term, a_light_has_its_highlight_even_if_it_is_very_low)
{
    for (int i = 0; i < SMALL; i++) {
        double cosine = cos(PI / 4 - atan(small(i)));
        expect_phong_share(2, vec3_of(1, small(i), 0), vec3_of(-1, 1, 0), cosine * cosine);
    }
}

// The halfway vector between it and the eye is at half the angle between them from the eye.
TEST(halfway_term, a_light_has_its_highlight_here_even_if_it_is_very_low)
{
    for (int i = 0; i < SMALL; i++) {
        double cosine = cos((PI / 4 - atan(small(i))) / 2);
        expect_halfway_share(2, vec3_of(1, small(i), 0), vec3_of(-1, 1, 0), cosine * cosine);
    }
}

TEST_BOTH(a_cosine_has_its_power_even_if_it_is_very_small,
          a_cosine_has_its_power_here_even_if_it_is_very_small)
{
    for (int i = 0; i < SMALL; i++) {
        double cosine = small(i) / hypot(1, small(i));
        expect_share_at(term, 1, vec3_of(1, small(i), 0), cosine);
        expect_share_at(term, 0.5, vec3_of(0, small(i), 1), sqrt(cosine));
    }
}

// From the dullest to the most polished: the angle at which half of ks of the light is seen.
TEST_BOTH(shine_may_be_of_any_size, shine_may_be_of_any_size_here_as_well)
{
    const double shines[] = {0.25, 0.75, 1,   3,   10,  11,  20,   33,
                             64,   100,  101, 128, 129, 300, 1001, 1e4};
    for (int i = 0; i < 16; i++) {
        double cosine = pow(0.5, 1 / shines[i]), sine = sqrt((1 - cosine) * (1 + cosine));
        expect_share_at(term, shines[i], vec3_of(sine, cosine, 0), 0.5);
    }
    expect_highlight(term, 0.5, 0, light_color, straight_up, straight_up, aside, 0.5 * light_color);
}

TEST_BOTH(close_to_its_middle_a_highlight_is_already_weaker,
          close_to_its_middle_this_highlight_is_also_weaker)
{
    for (double angle = 0.03; angle > 1e-5; angle /= 10)
        expect_share_at(term, 50, vec3_of(sin(angle), cos(angle), 0), pow(cos(angle), 50));
}

// ---- clamp_color --------------------------------------------------------------------------------

static void expect_clamped(Color color, Color clamped)
{
    given_vec3("color", color);
    expect_vec3(clamp_color(color), clamped, TOLERANCE);
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

// ---- gamma_encode -------------------------------------------------------------------------------

static void expect_encoded(Color color, double gamma, Color encoded)
{
    given_vec3("color", color);
    given_number("gamma", gamma);
    expect_vec3(gamma_encode(color, gamma), encoded, TOLERANCE);
}

TEST_LINE(gamma_encode, with_a_gamma_of_1_nothing_changes,
          expect_encoded(vec3_of(0.25, 0.5, 0.75), 1, vec3_of(0.25, 0.5, 0.75)))

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

TEST(gamma_encode, the_display_shows_the_color_that_was_meant)
{
    for (int i = 0; i < 20; i++) {
        Color encoded = random_vec3(0.1, 1);
        double gamma = random_number(0.5, 4);
        Color meant =
            vec3_of(pow(encoded[0], gamma), pow(encoded[1], gamma), pow(encoded[2], gamma));
        expect_encoded(meant, gamma, encoded);
    }
}

TEST(gamma_encode, any_gamma_is_used_unchanged)
{
    for (int i = 0; i < 12; i++) {
        const double gammas[] = {1.001, 0.95, 1.05, 2.05, 2.15, 2.3, 2.5, 3.5, 7, 25, 0.3, 0.06};
        Color encoded = vec3_of(0.5, 0.8, 0.65);
        double gamma = gammas[i];
        expect_encoded(vec3_of(pow(0.5, gamma), pow(0.8, gamma), pow(0.65, gamma)), gamma, encoded);
    }
}

TEST(gamma_encode, a_color_is_encoded_however_dark_it_is)
{
    for (int i = 0; i < SMALL; i++) {
        double e = small(i);
        expect_encoded(vec3_of(e, 0.5, 1), 1, vec3_of(e, 0.5, 1));
        expect_encoded(vec3_of(0.25, e * e, 1), 2, vec3_of(0.5, e, 1));
        expect_encoded(vec3_of(1, 0.125, e * e * e), 3, vec3_of(1, 0.5, e));
    }
}

// ---- offset_from_surface: how far, and to which side
// ---------------------------------------------------

// From a point of the sphere, straight to the side of the normal, by the step that the contract
// allows: any number from 2^-32 to 2^-28 of the size.
static void expect_off(Sphere sphere, vec3 point, vec3 normal, double size)
{
    const double rounding = 0x1p-46 * size;
    given_sphere(sphere);
    given_vec3("point", point);
    given_vec3("normal", normal);
    given("size", "%s", number_text_to(size, 10).s);
    vec3 moved = offset_from_surface(sphere, point, normal) - point;
    double along = vec3_dot(moved, normal), aside = vec3_length(moved - along * normal);
    char expected[200];
    snprintf(expected, sizeof expected,
             "moved by %.24s to %.24s along the normal, and not to the side",
             number_text_to(0x1p-32 * size, 3).s, number_text_to(0x1p-28 * size, 3).s);
    expects((Expectation){.tolerance = rounding, .least = 0x1p-32 * size, .most = 0x1p-28 * size});
    expect_law(along >= 0x1p-32 * size - rounding && along <= 0x1p-28 * size + rounding &&
                   aside <= rounding,
               expected, "moved by %.40s along the normal, by %.40s to the side",
               number_text_to(along, 3).s, number_text_to(aside, 3).s);
}

// So that the sphere touches the origin of the world, where the smallest step is visible.
static Sphere sphere_at_origin(vec3 outward, double radius)
{
    return sphere_at(-radius * outward, radius);
}

TEST(offset_from_surface, outside_the_point_moves_away_from_the_center)
{
    vec3 up = vec3_of(0, 1, 0), back = vec3_of(0, 0, -1), aslant = vec3_of(0.6, 0, 0.8);
    expect_off(sphere_at_origin(up, 1000), vec3_of(0, 0, 0), up, 2000);
    expect_off(sphere_at_origin(back, 50000), vec3_of(0, 0, 0), back, 1e5);
    expect_off(sphere_at_origin(aslant, 1000), vec3_of(0, 0, 0), aslant, 1800);
}

TEST(offset_from_surface, inside_the_point_moves_towards_the_center)
{
    vec3 up = vec3_of(0, 1, 0), aslant = vec3_of(0.6, -0.8, 0);
    expect_off(sphere_at_origin(-up, 1000), vec3_of(0, 0, 0), up, 2000);
    expect_off(sphere_at_origin(-aslant, 5000), vec3_of(0, 0, 0), aslant, 9000);
}

TEST(offset_from_surface, scenes_may_be_of_any_size)
{
    vec3 up = vec3_of(0, 1, 0);
    for (int i = -9; i <= 9; i++) {
        double radius = pow(10, i);
        expect_off(sphere_at_origin(up, radius), vec3_of(0, 0, 0), up, 2 * radius);
        expect_off(sphere_at_origin(-up, radius), vec3_of(0, 0, 0), up, 2 * radius);
    }
}

// The farther from the origin of the world, the coarser the numbers are.
TEST(offset_from_surface, a_small_sphere_far_away_needs_as_large_a_step_as_a_large_one)
{
    vec3 up = vec3_of(0, 1, 0);
    for (int i = 0; i < 3; i++) {
        vec3 center = vec3_of(0, -1, 0);
        center[i] += 1e6;
        vec3 point = center + up;
        expect_off(sphere_at(center, 1), point, up, (i == 1 ? 1e6 - 1 : 1e6) + 1);
    }
    // Fractions count as well.
    for (int i = 0; i < 3; i++) {
        vec3 center = vec3_of(0, 0, 0);
        center[i] = 0.9;
        expect_off(sphere_at(center, 0x1p-10), center + 0x1p-10 * up, up, 0.9 + 0x1p-10);
    }
    expect_off(sphere_at(vec3_of(0, 0, 0), 0.9), 0.9 * up, up, 0.9);
}

TEST(offset_from_surface, negative_coordinates_are_as_large_as_positive_ones)
{
    vec3 up = vec3_of(0, 1, 0);
    for (int i = 0; i < 3; i++) {
        vec3 center = vec3_of(0, -1, 0);
        center[i] -= 1e6;
        expect_off(sphere_at(center, 1), center + up, up, (i == 1 ? 1e6 + 1 : 1e6) + 1);
    }
}

TEST(offset_from_surface, anywhere_it_is_a_step_along_the_normal)
{
    for (int i = 0; i < 30; i++) {
        double scale = random_size(1e8);
        Sphere sphere = random_sphere(3 * scale, 0.1 * scale, 3 * scale);
        vec3 outward = random_unit(), c = sphere.center;
        if (i % 3 == 0)
            sphere.center = c = -sphere.radius * outward;
        double size = sphere.radius + largest(c);
        vec3 point = c + sphere.radius * outward;
        expect_off(sphere, point, i % 2 == 0 ? outward : -outward, size);
    }
}

// ---- visibility: spheres between a point and a light --------------------------------------------

// On the z axis; mostly seen from the origin.
static void put_on_the_axis(double center, double radius)
{
    put_sphere(vec3_of(0, 0, center), radius, dull());
}

// The light passes a sphere on the axis, or not.
static void expect_past(double center, double radius, vec3 from, Light light, double expected)
{
    empty_world();
    put_on_the_axis(center, radius);
    expect_visible(from, light, expected);
}

TEST(visibility, in_an_empty_scene_light_arrives)
{
    empty_world();
    expect_visible(origin, point_light(1, 2, 3), 1);
    expect_visible(origin, distant_light(1, 2, 3), 1);
}

TEST(visibility, a_sphere_in_between_hides_a_light)
{
    expect_past(5, 1, origin, point_light(0, 0, 10), 0);
    expect_past(5, 1, origin, distant_light(0, 0, 10), 0);
    expect_past(-5, 1, vec3_of(0, 0.5, -9), point_light(0, 0.5, 0), 0);
}

TEST(visibility, a_sphere_beside_the_way_hides_nothing)
{
    expect_past(5, 1, vec3_of(1.5, 0, 0), point_light(1.5, 0, 10), 1);
    expect_past(5, 1, vec3_of(1.5, 0, 0), distant_light(0, 0, 10), 1);
    // The direction counts, not where its tip is.
    expect_past(5, 1, vec3_of(0, 4, 0), distant_light(0, 0, 5), 1);
}

// By chance these are 1 in lengths of the vector to the light; that of (0, 0, 4) is 4 long.
TEST(visibility, a_sphere_behind_a_point_light_hides_nothing)
{
    expect_past(6, 1, origin, point_light(0, 0, 4), 1);
    expect_past(0.5, 0.1, origin, point_light(0, 0, 0.25), 1);
    expect_past(5.5, 1, origin, point_light(0, 0, 4), 1);
}

TEST(visibility, a_sphere_behind_the_point_hides_nothing)
{
    expect_past(-5, 1, origin, point_light(0, 0, 4), 1);
    expect_past(-5, 1, origin, distant_light(0, 0, 4), 1);
    expect_past(-1.5, 1, origin, point_light(0, 0, 4), 1);
}

static void expect_hidden_by_one_of_four(int which)
{
    empty_world();
    for (int i = 0; i < 4; i++)
        put_sphere(i == which ? vec3_of(0, 0, 5) : vec3_of(3 + i, 0, 5), 1, dull());
    expect_visible(origin, point_light(0, 0, 10), 0);
    expect_visible(origin, distant_light(0, 0, 10), 0);
    expect_visible(vec3_of(0, 5, 0), point_light(0, 5, 10), 1);
}

TEST_LINE(visibility, the_first_of_many_spheres_is_enough, expect_hidden_by_one_of_four(0))

TEST_LINE(visibility, the_last_of_many_spheres_is_enough, expect_hidden_by_one_of_four(3))

TEST(visibility, two_spheres_hide_a_light_no_more_than_one)
{
    empty_world();
    put_on_the_axis(3, 1);
    put_on_the_axis(5, 0.5);
    put_on_the_axis(8, 1);
    expect_visible(origin, point_light(0, 0, 10), 0);
    expect_visible(origin, distant_light(0, 0, 10), 0);
}

TEST(visibility, from_inside_a_sphere_only_lights_inside_it_are_seen)
{
    expect_past(0, 5, vec3_of(0, 0, 1), point_light(0, 0, 10), 0);
    expect_past(0, 5, vec3_of(0, 0, 1), point_light(0, 0, 4), 1);
    expect_past(0, 5, vec3_of(0, 0, 1), point_light(3, 0, -3), 1);
    expect_past(0, 5, vec3_of(0, 0, 1), distant_light(0, 0, 0.1), 0);
}

TEST(visibility, a_light_inside_a_sphere_is_not_seen_from_outside)
{
    expect_past(9, 2, origin, point_light(0, 0, 9), 0);
    expect_past(9, 2, origin, point_light(0, 1, 8), 0);
}

TEST(visibility, glass_hides_a_light_like_anything_else)
{
    Surface glass = surface_of(vec3_of(0.9, 0.9, 0.9), 0.1, 0.3, 9);
    glass.transmittance = 0.8;
    empty_world();
    put_sphere(vec3_of(0, 0, 5), 1, glass);
    given("known", "the sphere lets 0.8 of the light through");
    expect_visible(origin, point_light(0, 0, 10), 0);
}

TEST(visibility, any_spheres_hide_any_light_as_geometry_says)
{
    double visible;
    for (int i = 0, seen = 0, hidden = 0; i < 40 || seen < 8 || hidden < 8;) {
        double size = random_size(1e6);
        random_world(5, 1, size);
        vec3 from = random_vec3(-6, 6) * size;
        if (!visibility_by_geometry(from, world.lights[0], &visible))
            continue;
        expect_visible(from, world.lights[0], visible);
        i++;
        *(visible > 0 ? &seen : &hidden) += 1;
    }
}

// Seen from the origin: a light of one kind and a sphere whose near side is at t, a tenth of that
// large.
static void expect_beyond(double t, LightKind kind, double away, double expected)
{
    expect_past(1.1 * t, 0.1 * t, origin, light_of(kind, away * onward, white), expected);
}

TEST(visibility, a_sphere_hides_a_light_however_near_it_is)
{
    for (int i = 0; i < RUNGS; i++) {
        expect_beyond(small(i), LIGHT_POINT, 1, 0);
        expect_beyond(small(i), LIGHT_DISTANT, 1, 0);
    }
}

TEST(visibility, a_sphere_hides_a_light_beyond_it_however_far_it_is)
{
    for (int i = 0; i < RUNGS; i++) {
        expect_beyond(large(i), LIGHT_DISTANT, 1, 0);
        expect_beyond(large(i), LIGHT_POINT, 2 * large(i), 0);
        expect_beyond(large(i), LIGHT_POINT, 0.9 * large(i), 1);
    }
}

TEST(visibility, a_sphere_in_between_hides_a_light_at_any_distance)
{
    for (int i = 0; i < RUNGS; i++) {
        expect_beyond(1, LIGHT_DISTANT, small(i), 0);
        expect_beyond(1, LIGHT_DISTANT, large(i), 0);
        expect_beyond(1, LIGHT_POINT, large(i), 0);
    }
}

// By a part of the radius that is ten times the allowed error of a hit: the surface is that close
// in front of the light, or beyond it. The farther the light, the smaller that is compared with the
// way to it.
TEST(visibility, a_sphere_just_in_front_of_a_light_hides_it_and_one_just_behind_does_not)
{
    for (int i = 0; i < 6; i++) {
        double away = i < 3 ? 10 : 900, gap = pow(10, -3 - i % 3);
        Light light = light_of(LIGHT_POINT, away * onward, white);
        expect_past(away + 1 - gap, 1, origin, light, 0);
        expect_past(away + 1 + gap, 1, origin, light, 1);
    }
}

static const int rooms[] = {8, 10, 16, 20, 32, 50, 64, 100, 128, 256};
enum { ROOMS = sizeof rooms / sizeof *rooms };

// First as many as an answer with a fixed size has room for, and then one more.
TEST(visibility, the_last_of_any_number_of_spheres_hides_a_light)
{
    for (int i = 0; i <= 2 * ROOMS; i++) {
        int count = i < 2 * ROOMS ? rooms[i / 2] + i % 2 : MOST_SPHERES;
        empty_world();
        for (int k = 1; k < count; k++)
            put_sphere(vec3_of(2 + k, 3, 9), 1, dull());
        put_on_the_axis(5, 1);
        expect_visible(origin, light_of(LIGHT_POINT, 10 * onward, white), 0);
    }
}

// ---- shade: the terms of each light -------------------------------------------------------------

// A sphere whose highest point is the origin of the world, where the normal is up.
static void put_below(double radius, double kd, double ks, double shine)
{
    empty_world();
    put_sphere(vec3_of(0, -radius, 0), radius, shiny(kd, ks, shine));
}

// The same with radius 1 in one light; most tests look at it from straight above.
static void lit_by(LightKind kind, vec3 position, Color color)
{
    put_below(1, 0.5, 0.4, 3);
    put_light(kind, position, color);
}

// The light at 60 degrees, 10 away: the cosine is 1/2, on both sides of the normal.
static const vec3 at_60_degrees = {8.6602540378443864676, 5, 0};
static const vec3 across_from_it = {-8.6602540378443864676, 5, 0};
static const vec3 nine_above = {0, 9, 0};

static Color diffuse(double cosine, Color light)
{
    return 0.5 * cosine * vec3_of(0.8, 0.6, 0.4) * light;
}

// What a light adds for an eye straight above: the highlight has the third power of the cosine, and
// the color of the light.
static Color both(double cosine, Color light)
{
    return diffuse(cosine, light) + 0.4 * cosine * cosine * cosine * light;
}

// From 4 above, where the direction to the eye is up as well.
static void expect_above(Color lights)
{
    expect_shade((Ray){vec3_of(0, 4, 0), vec3_of(0, -2, 0)}, (Hit){2, 0}, ambient_of(0) + lights);
}

TEST(shade, without_lights_only_ambient_light_is_left)
{
    put_below(1, 0.5, 0.4, 3);
    expect_above(black);
    world.scene.ambient = vec3_of(1, 0.5, 0);
    expect_above(black);
}

TEST(shade, a_light_straight_above_has_its_full_effect)
{
    for (int kind = LIGHT_POINT; kind <= LIGHT_DISTANT; kind++) {
        lit_by((LightKind)kind, nine_above, yellow);
        expect_above(both(1, yellow));
    }
}

TEST(shade, a_light_at_an_angle_has_less_of_both_terms)
{
    for (int kind = LIGHT_POINT; kind <= LIGHT_DISTANT; kind++) {
        lit_by((LightKind)kind, at_60_degrees, yellow);
        expect_above(both(0.5, yellow));
    }
}

// Light and eye at 60 degrees to the normal each: on opposite sides the mirrored light meets the
// eye, on the same side it goes away from it.
TEST(shade, the_highlight_is_where_the_mirrored_light_meets_the_eye)
{
    lit_by(LIGHT_POINT, at_60_degrees, yellow);
    expect_shade((Ray){across_from_it, -across_from_it / 2}, (Hit){2, 0},
                 ambient_of(0) + diffuse(0.5, yellow) + 0.4 * yellow);
    expect_shade((Ray){at_60_degrees / 2, -at_60_degrees / 4}, (Hit){2, 0},
                 ambient_of(0) + diffuse(0.5, yellow));
}

TEST(shade, lights_add_up)
{
    lit_by(LIGHT_POINT, at_60_degrees, yellow);
    put_light(LIGHT_DISTANT, vec3_of(0, 2, 0), blue);
    put_light(LIGHT_POINT, vec3_of(0, 3, 0), red);
    expect_above(both(0.5, yellow) + both(1, blue) + both(1, red));
}

TEST(shade, in_the_shadow_the_ambient_light_is_left)
{
    for (int kind = LIGHT_POINT; kind <= LIGHT_DISTANT; kind++) {
        lit_by((LightKind)kind, at_60_degrees, yellow);
        put_sphere(at_60_degrees / 2, 1, dull());
        expect_above(black);
        put_sphere(0.6 * at_60_degrees, 1, dull());
        expect_above(black);
    }
}

TEST(shade, a_light_that_is_hidden_takes_nothing_from_the_others)
{
    const Color colors[] = {yellow, blue, red};
    for (int hidden = 0; hidden < 3; hidden++) {
        put_below(1, 0.5, 0.4, 3);
        for (int i = 0; i < 3; i++)
            put_light(LIGHT_POINT, i == hidden ? across_from_it : at_60_degrees, colors[i]);
        put_sphere(across_from_it / 2, 1, dull());
        expect_above(both(0.5, yellow + blue + red - colors[hidden]));
    }
}

// The other sphere is hit 1 to the left of the first; its own surface is plainer.
TEST(shade, the_surface_is_that_of_the_sphere_that_was_hit)
{
    lit_by(LIGHT_DISTANT, straight_up, yellow);
    put_sphere(vec3_of(-5, -2, 0), 2, surface_of(vec3_of(0.3, 0.9, 0.5), 0.25, 0.75, 1));
    expect_shade((Ray){vec3_of(-5, 4, 0), vec3_of(0, -2, 0)}, (Hit){2, 1},
                 0.25 * vec3_of(0.3, 0.9, 0.5) * (world.scene.ambient + yellow) + 0.75 * yellow);
}

// Eye and light in a hollow sphere around the origin, opposite the point: its surface faces them.
TEST(shade, inside_a_sphere_the_normal_points_to_the_eye)
{
    empty_world();
    put_sphere(origin, 6, shiny(0.5, 0.4, 3));
    put_light(LIGHT_POINT, vec3_of(0, -2, 0), yellow);
    put_light(LIGHT_POINT, nine_above, blue);
    put_light(LIGHT_DISTANT, -straight_up, red);
    put_light(LIGHT_DISTANT, straight_up, red);
    expect_shade((Ray){vec3_of(0, 2, 0), vec3_of(0, 2, 0)}, (Hit){2, 0},
                 ambient_of(0) + both(1, yellow));
    expect_shade((Ray){vec3_of(0, 5, 0), vec3_of(0, 0.5, 0)}, (Hit){2, 0},
                 ambient_of(0) + both(1, yellow));
}

// A hit is right only to within rounding. So these are in front of the surface or behind it by
// 5e-11 of the radius, less than the smallest step of offset_from_surface.
TEST(shade, a_hit_that_rounding_put_just_inside_the_sphere_is_lit)
{
    for (int i = -6; i <= 8; i += 2) {
        double size = pow(10, i);
        for (int side = -1; side <= 1; side++) {
            put_below(size, 0.5, 0.4, 3);
            put_light(LIGHT_POINT, size * at_60_degrees, yellow);
            Color expected = ambient_of(0) + both(0.5, yellow);
            Ray ray = {vec3_of(0, 4 * size, 0), vec3_of(0, -size, 0)};
            expect_shade(ray, (Hit){4 + side * 5e-11, 0}, expected);
            ray.origin = vec3_of(0, 0.001 * size, 0); // the eye is close, and t counts from there
            expect_shade(ray, (Hit){0.001 + side * 5e-11, 0}, expected);
        }
    }
}

// The crumb is this many radii above it, and half as large: in the way of the light from above,
// beside the way of the other, whose mirror image meets the eye.
TEST(shade, a_tiny_sphere_close_to_the_surface_casts_its_shadow)
{
    for (int i = 0; i < 30; i++) {
        double size = pow(10, 8 - i % 15), above = i < 15 ? 1e-5 : 1e-7;
        put_below(size, 0.5, 0.4, 3);
        put_sphere(vec3_of(0, above * size, 0), above / 2 * size, dull());
        put_light(LIGHT_DISTANT, straight_up, yellow);
        put_light(LIGHT_DISTANT, at_60_degrees, blue);
        vec3 eye = 0.5 * size * across_from_it;
        expect_shade((Ray){eye, -eye}, (Hit){1, 0},
                     ambient_of(0) + diffuse(0.5, blue) + 0.4 * blue);
    }
}

TEST(shade, any_lights_on_any_spheres_give_what_geometry_says)
{
    for (int i = 0; i < 40;) {
        double size = random_size(1e6);
        Color expected;
        Hit hit;
        random_world(4, 3, size);
        Ray ray = random_view(size);
        if (!shade_by_geometry(ray, &hit, &expected))
            continue;
        expect_shade(ray, hit, expected);
        i++;
    }
}

// As many as an answer with a fixed size has room for, and one more. Straight above, where the
// light has its full effect.
TEST(shade, the_last_of_any_number_of_lights_counts)
{
    static const int most[] = {2, 3, 4, 5, 8, 10, 16, 20, 32};
    for (int i = 0; i < 18; i++) {
        int count = most[i / 2] + i % 2;
        Color sum = black;
        put_below(1, 0.5, 0.4, 3);
        for (int k = 0; k < count; k++) {
            Color color = (k == count - 1 ? 0.5 : 0.01) * vec3_of(0.9, 0.7, 0.5);
            sum += color;
            put_light(k % 2 == 0 ? LIGHT_POINT : LIGHT_DISTANT, vec3_of(0, 9 + k, 0), color);
        }
        expect_above(both(1, sum));
    }
}

TEST(shade, light_of_any_strength_is_scattered_and_mirrored)
{
    for (int i = 0; i < 2 * RUNGS; i++) {
        double strength = i < RUNGS ? small(i) : large(i - RUNGS);
        Color color = strength * vec3_of(0.9, 0.7, 0.5);
        lit_by(LIGHT_POINT, nine_above, color);
        world.scene.ambient *= strength;
        world.scene.background *= strength;
        expect_above(both(1, color));
    }
}

// ---- trace_ray: mirrors, and how deep to look into them -----------------------------------------

// Mirrors on an axis, which send rays to and fro; a mirrored direction with sides 3, 4, 5 and 7,
// 24, 25. The color in a mirror must not depend on how far a right answer goes off its surface: so
// random mirrors face each other on an axis, or their colors are ambient only.

// On the axis z, on both sides of the origin.
static void facing_mirrors(double ks, double other_ks)
{
    empty_world();
    put_sphere(vec3_of(0, 0, -5), 1, mirror(green, ks));
    put_sphere(vec3_of(0, 0, 8), 2, mirror(pink, other_ks));
}

static const Ray ahead = {{0, 0, 0}, {0, 0, -2}}, behind = {{0, 0, 0}, {0, 0, 3}},
                 upward = {{0, 0, 0}, {0, 1, 0}};

TEST(trace_ray, if_nothing_is_hit_the_background_is_seen)
{
    for (int depth = 0; depth < 3; depth++) {
        facing_mirrors(0.5, 0.25);
        put_light(LIGHT_POINT, nine_above, white);
        expect_trace(upward, depth, world.scene.background);
        empty_world();
        expect_trace(upward, depth, world.scene.background);
    }
}

TEST(trace_ray, at_depth_0_a_mirror_shows_only_itself)
{
    facing_mirrors(0.5, 0.25);
    expect_trace(ahead, 0, ambient_of(0));
    expect_trace(behind, 0, ambient_of(1));
    put_light(LIGHT_POINT, origin, pink);
    expect_trace(ahead, 0, lit_from_the_eye(0, pink));
}

TEST(trace_ray, a_surface_without_specular_is_not_a_mirror)
{
    facing_mirrors(0, 0.25);
    for (int depth = 0; depth < 4; depth++)
        expect_trace(ahead, depth, ambient_of(0));
    expect_trace(behind, 3, ambient_of(1) + 0.25 * ambient_of(0));
    put_light(LIGHT_POINT, origin, pink);
    expect_trace(ahead, 3, lit_from_the_eye(0, pink));
}

TEST(trace_ray, a_mirror_also_shows_the_background)
{
    empty_world();
    put_sphere(vec3_of(0, 0, -5), 1, mirror(green, 0.5));
    for (int depth = 1; depth < 4; depth++)
        expect_trace(ahead, depth, ambient_of(0) + 0.5 * world.scene.background);
}

TEST(trace_ray, one_mirror_shows_the_other)
{
    facing_mirrors(0.5, 0.25);
    expect_trace(ahead, 1, ambient_of(0) + 0.5 * ambient_of(1));
    expect_trace(behind, 1, ambient_of(1) + 0.25 * ambient_of(0));
}

TEST(trace_ray, mirrors_that_face_each_other_are_seen_as_often_as_depth_says)
{
    facing_mirrors(0.5, 0.25);
    for (int depth = 0; depth <= 6; depth++) {
        expect_trace(ahead, depth, to_and_fro(0, 1, black, depth));
        expect_trace(behind, depth, to_and_fro(1, 0, black, depth));
    }
}

// The sum is not clamped on the way.
TEST(trace_ray, bright_light_is_not_clamped_in_mirrors_either)
{
    facing_mirrors(0.5, 0.25);
    put_light(LIGHT_POINT, origin, 8 * pink);
    for (int depth = 1; depth <= 3; depth++)
        expect_trace(ahead, depth, to_and_fro(0, 1, 8 * pink, depth));
}

// Hit at (3, 0, 4), where the normal is (3, 0, 4) / 5: a ray along -z leaves along (24, 0, 7).
// Other spheres are straight on, along the normal, in the opposite direction, and back at the
// start; and a lamp is inside the ball, where no ray should see it.
TEST(trace_ray, the_angle_out_is_the_angle_in)
{
    const vec3 hit = {3, 0, 4}, mirrored = {0.96, 0, 0.28};
    empty_world();
    put_sphere(vec3_of(0, 0, 0), 5, mirror(green, 0.5));
    put_sphere(hit + 10 * mirrored, 1, surface_of(pink, 0.7, 0, 1));
    put_sphere(hit - 10 * mirrored, 1, surface_of(green, 0.9, 0, 1));
    put_sphere(hit + 3 * hit, 1, surface_of(green, 0.8, 0, 1));
    put_sphere(vec3_of(3, 0, -20), 1, surface_of(green, 0.6, 0, 1));
    put_sphere(vec3_of(3, 0, 20), 1, surface_of(green, 0.4, 0, 1));
    put_light(LIGHT_POINT, vec3_of(1, 2, 0), white);
    expect_trace((Ray){vec3_of(3, 0, 10), vec3_of(0, 0, -2)}, 1,
                 ambient_of(0) + 0.5 * ambient_of(1));
    expect_trace((Ray){vec3_of(3, 0, 10), vec3_of(0, 0, -2)}, 5,
                 ambient_of(0) + 0.5 * ambient_of(1));
}

TEST(trace_ray, inside_a_hollow_mirror_a_ray_stays_inside)
{
    empty_world();
    put_sphere(origin, 6, mirror(green, 0.5));
    put_sphere(vec3_of(0, 0, 20), 6, mirror(pink, 0.5));
    put_light(LIGHT_POINT, origin, pink);
    for (int i = 0; i < 10; i++)
        expect_trace((Ray){onward, (i < 5 ? 2 : 0.03) * onward}, i % 5,
                     to_and_fro(0, 0, pink, i % 5));
}

// A gap of 1e-5 of the radius between two spheres, along whose axis the eye looks from inside the
// gap.
TEST(trace_ray, mirrors_may_be_close_together_in_scenes_of_any_size)
{
    for (int i = 8; i >= -6; i -= 2) {
        double size = pow(10, i);
        empty_world();
        put_sphere(vec3_of(0, 0, -1.000005 * size), size, mirror(yellow, 0.5));
        put_sphere(vec3_of(0, 0, 1.000005 * size), size, mirror(blue, 0.25));
        expect_trace((Ray){origin, -size * onward}, 4, to_and_fro(0, 1, black, 4));
    }
}

// A single ball mirrors everything except itself, even if the eye is close to it and the origin of
// the world is far away.
TEST(trace_ray, a_ball_does_not_see_itself)
{
    for (int i = 0; i < 40; i++) {
        double size = random_size(1e6), away = pow(10, i % 2 == 0 ? 5 : random_number(0, 5));
        empty_world();
        world.scene.background = random_color();
        vec3 center = size * away * random_unit();
        double ks = random_number(0.2, 0.9);
        put_sphere(center, size, mirror(random_color(), ks));
        double distance = 1 + (i % 2 == 0 ? 1e-6 : random_number(0.1, 9));
        vec3 from = center + distance * size * random_unit();
        vec3 at = center + 0.6 * size * random_unit();
        expect_trace((Ray){from, at - from}, 1 + i % 3,
                     ambient_of(0) + ks * world.scene.background);
    }
}

TEST(trace_ray, on_any_axis_and_in_any_light_mirrors_face_each_other)
{
    for (int i = 0; i < 20; i++) {
        double size = random_size(1e6);
        vec3 eye = size * random_vec3(-5, 5), axis = random_unit();
        Color light = random_color();
        random_world(0, 0, size);
        for (int side = -1; side <= 1; side += 2) {
            double radius = random_number(0.5, 3), away = radius + random_number(1, 4);
            double ks = random_number(0.2, 0.9);
            put_sphere(eye - side * size * away * axis, size * radius, mirror(random_color(), ks));
        }
        put_light(LIGHT_POINT, eye, light);
        expect_trace((Ray){eye, size * random_number(0.1, 9) * axis}, i % 4,
                     to_and_fro(0, 1, light, i % 4));
    }
}

TEST(trace_ray, any_mirrors_show_what_geometry_says)
{
    for (int i = 0; i < 40;) {
        double size = random_size(1e6);
        Color expected;
        random_world(6, 0, size);
        Ray ray = random_view(size);
        if (!trace_by_geometry(ray, i % 3, &expected))
            continue;
        expect_trace(ray, i % 3, expected);
        i++;
    }
}

// Two mirrors on the axis, 4 in front of the eye and 6 behind it.
static void facing(double ks, double other_ks)
{
    empty_world();
    put_sphere(vec3_of(0, 0, 5), 1, mirror(green, ks));
    put_sphere(vec3_of(0, 0, -8), 2, mirror(pink, other_ks));
}

TEST(trace_ray, mirrors_are_followed_as_deep_as_depth_says)
{
    static const int depths[] = {2, 3, 4, 5, 6, 8, 10, 15, 16, 20, 30, 32, 50, 64, 99, 100, 128};
    for (int i = 0; i < 34; i++) {
        int depth = depths[i / 2] + i % 2;
        facing(1, 1);
        expect_trace((Ray){origin, 2 * onward}, depth, to_and_fro(0, 1, black, depth));
    }
}

TEST(trace_ray, a_mirror_counts_however_weak_it_is)
{
    for (int i = 0; i < SMALL_IN_SCENES; i++) {
        empty_world();
        world.scene.background = white;
        put_sphere(vec3_of(0, 0, 5), 1, mirror(green, small(i)));
        expect_trace((Ray){origin, 2 * onward}, 3, ambient_of(0) + small(i) * white);
    }
}

// In each other they show less and less: 0.04, 0.0016 ... 3e-7 of the light.
TEST(trace_ray, light_through_many_mirrors_counts_however_little_it_is)
{
    for (int depth = 0; depth <= 5; depth++) {
        facing(0.04, 0.04);
        world.scene.ambient = 3 * white;
        expect_trace((Ray){origin, 2 * onward}, depth, to_and_fro(0, 1, black, depth));
    }
}

// ---- probes -------------------------------------------------------------------------------------

// Calls that distinguish the mistakes of exercise 07: colors and lights that are neither grey nor
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
        Light light = {.position = random_vec3(-5, 5), .color = random_vec3(0.1, 1.5)};
        light.kind = i % 2 == 0 ? LIGHT_POINT : LIGHT_DISTANT;
        ray_to_light(random_vec3(-5, 5), light);
    }
}

PROBE(ambient_term, ambient_of_any_surface)
{
    for (int i = 0; i < MANY; i++) {
        Color surface = random_vec3(0.1, 0.9);
        double kd = random_number(0.1, 0.9);
        ambient_term(surface, kd, random_vec3(0.1, i % 4 == 3 ? 9 : 0.9));
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
        Color surface = random_vec3(0.1, 0.9);
        double kd = random_number(0.1, 0.9);
        Color light = random_vec3(0.1, i % 4 == 2 ? 20 : 1.5);
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

// An eye behind the surface: for Phong the contract leaves the result free; halfway it must see
// nothing if the normal and the halfway vector are more than 90 degrees apart.
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
        Color light = random_vec3(0.1, i % 4 == 0 ? 30 : 1.5);
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
        term(ks, shine, random_vec3(0.1, 1.5), normal, random_number(0.3, 4) * to_light,
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

PROBE(offset_from_surface, steps_off_any_surface)
{
    for (int i = 0; i < 2 * MANY; i++) {
        Sphere sphere = random_sphere(2, 0.2, 4);
        // Far away along one axis: the step is visible in the others.
        if (i % 4 != 3)
            sphere.center[i % 3] = (i % 2 == 0 ? 1 : -1) * random_number(300, 3000);
        vec3 normal = random_unit();
        offset_from_surface(sphere, sphere.center + sphere.radius * normal,
                            i % 2 == 0 ? normal : -normal);
    }
}

// From 1e-7 to 1, small as often as large, so that every threshold is between two of them.
static double any_small(void)
{
    return pow(10, random_number(-7, 0));
}

// A sphere that the ray from one point to another enters after some part of the way; 0 to 1 is
// between the two.
static void put_on_the_way(vec3 from, vec3 to, double part)
{
    vec3 way = to - from, normal = random_unit();
    if (vec3_dot(normal, way) > 0)
        normal = -normal;
    double radius = random_number(0.2, 1.5);
    put_sphere(from + part * way - radius * normal, radius, random_surface());
}

PROBE(visibility, what_arrives_anywhere)
{
    for (int i = 0; i < 8 * MANY; i++) {
        random_world(i % 3, 1 + i % 5, 1);
        Light light = world.lights[0];
        vec3 from = random_vec3(-7, 7);
        vec3 to = light.kind == LIGHT_POINT ? light.position : from + light.position;
        double part = i % 9 == 6   ? random_number(1.2, 2)
                      : i % 8 < 3  ? random_number(0.1, 0.9)
                      : i % 8 == 3 ? any_small()
                      : i % 8 == 4 ? 1 - any_small()
                      : i % 8 == 5 ? random_number(1.01, 3)
                      : i % 8 == 6 ? -random_number(0.05, 1)
                                   : -0.01;
        put_on_the_way(from, to, part);
        if (i % 9 == 6) // the first beyond the light, the last in front of it
            put_on_the_way(from, to, random_number(0.2, 0.8));
        if (i % 5 == 0)
            put_on_the_way(from, to, random_number(-1, 2));
        for (int k = 0; k < world.scene.surface_count; k++)
            world.surfaces[k].transmittance = random_number(0.1, 0.9);
        visibility(&world.scene, from, light);
    }
}

// Most spheres are visible, and some of their lights are hidden from them; some eyes are inside.
static Ray any_view(int i)
{
    random_world(2 + i % 6, i % 4, 1);
    Ray ray = random_view(1);
    if (i % 5 == 4)
        ray.origin = world.spheres[0].center + 0.6 * world.spheres[0].radius * random_unit();
    if (i % 10 == 9)
        ray.direction = random_number(0.2, 0.9) * vec3_unit(ray.direction);
    if (i % 6 == 3) { // two that are equal
        world.spheres[1].center = world.spheres[0].center;
        world.spheres[1].radius = world.spheres[0].radius;
    }
    if (i % 20 == 7) // and lights that do not count
        world.scene.light_count = 0;
    Hit hit = nearest_hit(ray, &world.scene);
    vec3 point = ray.origin + hit.t * ray.direction;
    if (hit.sphere >= 0 && world.scene.light_count > 0 && i % 3 == 0 &&
        world.lights[0].kind == LIGHT_POINT)
        put_on_the_way(point, world.lights[0].position, random_number(0.2, 0.8));
    if (i % 7 == 6)
        for (int k = 0; k < world.scene.light_count; k++)
            world.lights[k].color *= 9;
    if (i % 9 == 8)
        for (int k = 1; k < world.scene.surface_count; k++)
            world.surfaces[k].specular = 0;
    return ray;
}

// In a world of another size.
static Ray scaled(Ray ray, double size)
{
    for (int i = 0; i < world.scene.sphere_count; i++) {
        world.spheres[i].center *= size;
        world.spheres[i].radius *= size;
    }
    for (int i = 0; i < world.scene.light_count; i++)
        world.lights[i].position *= size;
    return (Ray){size * ray.origin, size * ray.direction};
}

PROBE(shade, light_of_any_surface)
{
    for (int i = 0; i < 7 * MANY; i++) {
        Ray ray = any_view(i);
        if (i >= 5 * MANY)
            ray = scaled(ray, pow(10, random_number(-5, 4)));
        Hit hit = nearest_hit(ray, &world.scene);
        if (hit.sphere >= 0)
            shade(&world.scene, ray, hit);
    }
}

PROBE(trace_ray, what_any_ray_sees)
{
    for (int i = 0; i < 8 * MANY; i++) {
        Ray ray = any_view(i);
        if (i >= 6 * MANY)
            ray = scaled(ray, pow(10, random_number(-5, 4)));
        else if (i % 8 == 7)
            ray = random_ray(6, 2);
        trace_ray(&world.scene, ray, i % 4 == 0 ? 0 : 1 + i % 3);
    }
}

// So deep that one level more is visible: mirrors that face each other.
PROBE(trace_ray, what_is_seen_in_many_mirrors)
{
    for (int depth = 0; depth < 9; depth++) {
        random_world(0, 2, 1);
        vec3 axis = random_unit();
        for (int side = -1; side <= 1; side += 2)
            put_sphere(side * 3 * axis, 2, mirror(random_vec3(0.2, 0.9), 0.95));
        trace_ray(&world.scene, (Ray){vec3_of(0, 0, 0), axis}, depth);
    }
}

PROBE(clamp_color, clamped_colors)
{
    for (int i = 0; i < 3 * MANY; i++) {
        Color color = random_vec3(-0.7, 1.7);
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
        Color color = random_vec3(0.02, 0.98);
        if (i % 4 == 3)
            color[i / 4 % 3] = random_number(0, 0.003);
        gamma_encode(color, random_number(0.4, 4));
    }
}
