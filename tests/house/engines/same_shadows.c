// same_shadows.c - the grid of a light leaves out no sphere that hides the light.
//
// Usage: same_shadows [SCENES]: random scenes (60), some of them with the light among the spheres.
// From behind each sphere, rays to the light nearly touch it, so they go through the
// edges of the sphere's cells. Each answer must be that of chapter 07's visibility, which asks all
// spheres. The last line counts.
#include "chapters/08-fast/engines/light.h"
#include "exercises/07-shading.h"

#include <stdio.h>
#include <stdlib.h>

enum { MOST = 400, RAYS = 40 };

static Sphere spheres[MOST];
static unsigned long long state = 2016;
static int decided;

static double uniform(double low, double high)
{
    state = state * 6364136223846793005ULL + 1442695040888963407ULL;
    return low + (high - low) * (double)(state >> 11) * 0x1p-53;
}

static vec3 anywhere(double size)
{
    double x = uniform(-size, size), y = uniform(-size, size);
    return vec3_of(x, y, uniform(-size, size));
}

// Small spheres near each other, eight of them at the corners of their box; sometimes with a ground
// and a sky.
static Scene random_scene(int number)
{
    Scene scene = {.spheres = spheres, .sphere_count = (int)uniform(1, MOST - 2)};
    for (int i = 0; i < scene.sphere_count; i++)
        spheres[i] = (Sphere){anywhere(2), pow(10, uniform(-4, 0)), 0};
    for (int i = 0; i < 8 && i < scene.sphere_count; i++)
        spheres[i].center = vec3_of(i & 1 ? 2 : -2, i & 2 ? 2 : -2, i & 4 ? 2 : -2);
    if (number % 3 == 0) {
        spheres[scene.sphere_count++] = (Sphere){vec3_of(0, -1002, 0), 1000, 0};
        spheres[scene.sphere_count++] = (Sphere){vec3_of(0, 0, 0), 5000, 0};
    }
    return scene;
}

// A ray to the light that nearly touches a sphere; sometimes one that starts in it.
static Ray touching(Light to, const Sphere *sphere)
{
    vec3 light = to.position, axis = sphere->center - light,
         aside = vec3_unit(vec3_cross(axis, anywhere(1)));
    double distance = vec3_length(axis), sine = sphere->radius / distance;
    sine *= 1 + (uniform(0, 1) < 0.7 ? -1 : 1) * pow(10, uniform(-9, -2));
    vec3 away = sqrt(1 - sine * sine) / distance * axis + sine * aside;
    vec3 start = light + (distance + sphere->radius) * uniform(1.1, 2) * away;
    if (uniform(0, 1) < 0.1)
        start = sphere->center + 0.5 * sphere->radius * aside;
    return (Ray){start, light - start};
}

// The number of rays, out of those that nearly touch a sphere, for which the grid is wrong.
static int wrong(const LightWorld *world, Light light, const Sphere *sphere)
{
    static Vectors starts, ways, none;
    Rays rays = {&starts, &ways, &world->grids[0], true, RAYS, {0}, &none, none.x};
    int places[PATHS], different = 0;
    for (int i = 0; i < RAYS; i++) {
        Ray ray = touching(light, sphere);
        set_vector(&starts, i, ray.origin);
        set_vector(&ways, i, ray.direction);
        rays.left[i] = NO_PLACE;
    }
    LANES_BEST(nearest_of_many)(&world->wide, &rays, places);
    for (int i = 0; i < RAYS; i++) {
        bool arrives = visibility(world->scene, vector_of(&starts, i), light) > 0;
        different += places[i] != IN_DOUBT && arrives != (places[i] == NO_PLACE);
        decided += places[i] != IN_DOUBT;
    }
    return different;
}

int main(int argc, char **argv)
{
    int scenes = argc > 1 ? atoi(argv[1]) : 60, asked = 0, grids = 0, passed = 0, failed = 0;
    for (int number = 0; number < scenes; number++) {
        Scene scene = random_scene(number);
        Light light = {.position = number % 4 == 0 ? anywhere(2)
                                                   : 4 * vec3_unit(anywhere(1)) + anywhere(0.2) +
                                                         vec3_of(0, 5, 0)};
        scene.lights = &light;
        scene.light_count = 1;
        LightWorld world = {.scene = &scene};
        if (!light_world_build(&world))
            return 1;
        grids += world.grids[0].bins.items != NULL;
        int before = asked, wrongly = 0;
        for (int i = 0; i < scene.sphere_count; i++)
            // If the light is inside, no ray touches the sphere.
            if (vec3_length(spheres[i].center - light.position) >= 1.02 * spheres[i].radius) {
                asked += RAYS;
                wrongly += wrong(&world, light, &spheres[i]);
            }
        light_world_free(&world);
        if (wrongly > 0)
            printf("scene %d: %d of %d shadow rays are wrong\n", number, wrongly, asked - before);
        passed += wrongly == 0;
        failed += wrongly > 0;
    }
    printf("%d shadow rays were asked, %d decided, %d lights had grids\nshadows of scenes: %d "
           "passed, %d failed\n",
           asked, decided, grids, passed, failed);
    return failed > 0 || 2 * decided <= asked || 2 * grids <= scenes;
}
