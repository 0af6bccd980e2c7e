// 07-shading-terms.c - laws of the functions of exercise 07 that need no scene: none yet.
#include "tests/laws/07-shading-terms.h"

void law_surface_normal(vec3 yours, Sphere sphere, vec3 point)
{
    (void)yours, (void)sphere, (void)point;
}

void law_ray_to_light(Ray yours, vec3 from, Light light)
{
    (void)yours, (void)from, (void)light;
}

void law_ambient_term(Color yours, Color surface, double kd, Color ambient)
{
    (void)yours, (void)surface, (void)kd, (void)ambient;
}

void law_diffuse_term(Color yours, Color surface, double kd, Color light, vec3 normal,
                      vec3 to_light)
{
    (void)yours, (void)surface, (void)kd, (void)light, (void)normal, (void)to_light;
}

void law_mirror_direction(vec3 yours, vec3 direction, vec3 normal)
{
    (void)yours, (void)direction, (void)normal;
}

void law_phong_term(Color yours, double ks, double shine, Color light, vec3 normal, vec3 to_light,
                    vec3 to_eye)
{
    (void)yours, (void)ks, (void)shine, (void)light, (void)normal, (void)to_light, (void)to_eye;
}

void law_halfway_term(Color yours, double ks, double shine, Color light, vec3 normal, vec3 to_light,
                      vec3 to_eye)
{
    (void)yours, (void)ks, (void)shine, (void)light, (void)normal, (void)to_light, (void)to_eye;
}

void law_clamp_color(Color yours, Color color)
{
    (void)yours, (void)color;
}

void law_gamma_encode(Color yours, Color color, double gamma)
{
    (void)yours, (void)color, (void)gamma;
}
