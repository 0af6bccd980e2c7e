// 07-shading.c - exercise 07: light, and the color that a surface sends back.
//
// Your answers go between BEGIN SOLUTION and END SOLUTION; helper functions may go anywhere.
// Questions and rules: exercises/07-shading.h. The lesson: chapters/07-shading/README.md.
// After each change:   make exercises EX=07
#include "exercises/07-shading.h"

#include "common/answers.h"
#include "exercises/05-quadratic.h"
#include "exercises/06-ray-casting.h"

vec3 surface_normal(Sphere sphere, vec3 point)
{
    // BEGIN SOLUTION
    return NOT_ANSWERED(vec3);
    // END SOLUTION
}

Ray ray_to_light(vec3 from, Light light)
{
    // BEGIN SOLUTION
    return NOT_ANSWERED(Ray);
    // END SOLUTION
}

Color ambient_term(Color surface, double kd, Color ambient)
{
    // BEGIN SOLUTION
    return NOT_ANSWERED(Color);
    // END SOLUTION
}

Color diffuse_term(Color surface, double kd, Color light, vec3 normal, vec3 to_light)
{
    // BEGIN SOLUTION
    return NOT_ANSWERED(Color);
    // END SOLUTION
}

vec3 mirror_direction(vec3 direction, vec3 normal)
{
    // BEGIN SOLUTION
    return NOT_ANSWERED(vec3);
    // END SOLUTION
}

Color phong_term(double ks, double shine, Color light, vec3 normal, vec3 to_light, vec3 to_eye)
{
    // BEGIN SOLUTION
    return NOT_ANSWERED(Color);
    // END SOLUTION
}

Color halfway_term(double ks, double shine, Color light, vec3 normal, vec3 to_light, vec3 to_eye)
{
    // BEGIN SOLUTION
    return NOT_ANSWERED(Color);
    // END SOLUTION
}

vec3 offset_from_surface(Sphere sphere, vec3 point, vec3 normal)
{
    // BEGIN SOLUTION
    return NOT_ANSWERED(vec3);
    // END SOLUTION
}

double visibility(const Scene *scene, vec3 from, Light light)
{
    // BEGIN SOLUTION
    return NOT_ANSWERED(double);
    // END SOLUTION
}

Color shade(const Scene *scene, Ray ray, Hit hit)
{
    // BEGIN SOLUTION
    return NOT_ANSWERED(Color);
    // END SOLUTION
}

Color trace_ray(const Scene *scene, Ray ray, int depth)
{
    // BEGIN SOLUTION
    return NOT_ANSWERED(Color);
    // END SOLUTION
}

Color clamp_color(Color color)
{
    // BEGIN SOLUTION
    return NOT_ANSWERED(Color);
    // END SOLUTION
}

Color gamma_encode(Color color, double gamma)
{
    // BEGIN SOLUTION
    return NOT_ANSWERED(Color);
    // END SOLUTION
}
