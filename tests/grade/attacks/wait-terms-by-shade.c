// wait-terms-by-shade: the terms of light by the sum of all of them, which is later and blank.
// stem: 07-shading
// expect: graded
// earns: nothing
#include "exercises/07-shading.h"

static vec3 light_on(Surface surface, vec3 ambient, vec3 light, vec3 normal, vec3 to_light,
                     vec3 to_eye)
{
    Sphere sphere = {.center = -normal, .radius = 1};
    Light lamp = {.position = to_light, .color = light, .kind = LIGHT_DISTANT};
    Scene scene = {.ambient = ambient,
                   .spheres = &sphere,
                   .sphere_count = 1,
                   .surfaces = &surface,
                   .surface_count = 1,
                   .lights = &lamp,
                   .light_count = 1};
    return shade(&scene, (Ray){to_eye, -to_eye}, (Hit){1, 0});
}

vec3 ambient_term(vec3 surface, double kd, vec3 ambient)
{
    Surface all = {.color = surface, .diffuse = kd};
    return light_on(all, ambient, vec3_of(0, 0, 0), vec3_of(0, 0, 1), vec3_of(0, 0, 1),
                    vec3_of(0, 0, 1));
}

vec3 diffuse_term(vec3 surface, double kd, vec3 light, vec3 normal, vec3 to_light)
{
    Surface all = {.color = surface, .diffuse = kd};
    return light_on(all, vec3_of(0, 0, 0), light, normal, to_light, normal);
}

vec3 phong_term(double ks, double shine, vec3 light, vec3 normal, vec3 to_light, vec3 to_eye)
{
    Surface all = {.specular = ks, .shine = shine};
    return light_on(all, vec3_of(0, 0, 0), light, normal, to_light, to_eye);
}
