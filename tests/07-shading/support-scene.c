// support-scene.c - the worlds of the tests of exercise 07, and how they are described.
#include "tests/07-shading/support-scene.h"

#include "tests/07-shading/support.h"

#include <stdio.h>

// ---- worlds -------------------------------------------------------------------------------------

void empty_world(World *world)
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

int put_sphere(World *world, vec3 center, double radius, Surface surface)
{
    int i = world->scene.sphere_count++;
    world->spheres[i] = (Sphere){.center = center, .radius = radius, .surface = i + 1};
    world->surfaces[i + 1] = surface;
    world->scene.surface_count = i + 2;
    return i;
}

void put_light(World *world, LightKind kind, vec3 position, Color color)
{
    world->lights[world->scene.light_count++] =
        (Light){.position = position, .color = color, .kind = kind};
}

Surface surface_of(Color color, double diffuse, double specular, double shine)
{
    return (Surface){.color = color, .diffuse = diffuse, .specular = specular, .shine = shine};
}

Surface dull(void)
{
    return surface_of(vec3_of(0.8, 0.6, 0.4), 0.5, 0, 1);
}

Light point_light(double x, double y, double z)
{
    return (Light){
        .position = vec3_of(x, y, z), .color = vec3_of(0.9, 0.8, 0.7), .kind = LIGHT_POINT};
}

Light distant_light(double x, double y, double z)
{
    return (Light){
        .position = vec3_of(x, y, z), .color = vec3_of(0.9, 0.8, 0.7), .kind = LIGHT_DISTANT};
}

Color random_scene_color(void)
{
    return random_vec3(0.1, 0.9);
}

Surface random_surface(void)
{
    Color color = random_scene_color();
    double diffuse = random_number(0.2, 0.9), specular = random_number(0.1, 0.8);
    return surface_of(color, diffuse, specular, random_number(1, 20));
}

double random_size(double most)
{
    return pow(most, random_number(-1, 1));
}

void random_world(World *world, int spheres, int lights, double size)
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

Ray random_view(const World *world, double size)
{
    int i = (int)random_number(0, world->scene.sphere_count);
    const Sphere *sphere = &world->spheres[i];
    vec3 at = sphere->center + 0.8 * sphere->radius * random_unit();
    vec3 from = random_vec3(-6, 6) * size;
    return (Ray){from, random_number(0.1, 3) * (at - from)};
}

// ---- mirrors ------------------------------------------------------------------------------------

Surface mirror(Color color, double specular)
{
    return surface_of(color, 0.5, specular, 3);
}

Color ambient_of(const World *world, int sphere)
{
    const Surface *surface = scene_surface(&world->scene, sphere);
    return surface->diffuse * surface->color * world->scene.ambient;
}

Color lit_from_the_eye(const World *world, int sphere, Color light)
{
    const Surface *surface = scene_surface(&world->scene, sphere);
    return ambient_of(world, sphere) + surface->diffuse * surface->color * light +
           surface->specular * light;
}

Color to_and_fro(Color first, double ks, Color second, double other_ks, int depth)
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

void given_scene_light(const Light *light)
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

void given_world(const World *world)
{
    given_spheres(&world->scene, true);
    given("ambient", "%s", vec3_text(world->scene.ambient).s);
    given("background", "%s", vec3_text(world->scene.background).s);
    given_lights(&world->scene);
}

void expect_visible(const World *world, vec3 from, Light light, double expected)
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

void expect_shade(const World *world, Ray ray, Hit hit, Color expected)
{
    given_world(world);
    given_ray(ray);
    given("hit", "t = %s, sphere %d", number_text_to(hit.t, 17).s, hit.sphere);
    expect_vec3(shade(&world->scene, ray, hit), expected,
                COLOR_TOLERANCE * brightest(&world->scene));
}

void expect_trace(const World *world, Ray ray, int depth, Color expected)
{
    given_world(world);
    given_ray(ray);
    given("depth", "%d", depth);
    expect_vec3(trace_ray(&world->scene, ray, depth), expected,
                COLOR_TOLERANCE * brightest(&world->scene));
}
