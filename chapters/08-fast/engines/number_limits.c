// number_limits.c - whether the numbers of a scene are beyond the limits of the fast engines.
#include "chapters/08-fast/engines/number_limits.h"

bool extreme_camera(Camera camera)
{
    return extreme_place(camera.origin) || extreme_length(camera.distance) ||
           extreme_length(camera.width) || extreme_length(camera.height);
}

bool extreme_scene(const Work *work)
{
    bool extreme = extreme_camera(work->camera);
    for (int i = 0; i < work->scene->sphere_count && !extreme; i++)
        extreme = extreme_sphere(work->camera.origin, &work->scene->spheres[i]);
    return extreme;
}

bool extreme_light(const Work *work)
{
    const Scene *scene = work->scene;
    if (extreme_scene(work))
        return true;
    double smallest = INFINITY, farthest = 0;
    for (int i = 0; i < scene->sphere_count; i++) {
        const Sphere *sphere = &scene->spheres[i];
        smallest = fmin(smallest, sphere->radius);
        farthest =
            fmax(farthest, vec3_length(sphere->center - work->camera.origin) + sphere->radius);
    }
    for (int i = 0; i < scene->light_count; i++) {
        const Light *light = &scene->lights[i];
        if (extreme_place(light->position) ||
            (light->kind == LIGHT_DISTANT && extreme_length(vec3_length(light->position))))
            return true;
    }
    return farthest > EXTREME_RADII * smallest;
}
