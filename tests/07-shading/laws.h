// laws.h - the laws of exercise 07.
#ifndef TESTS_07_SHADING_LAWS_H
#define TESTS_07_SHADING_LAWS_H

#include "exercises/07-shading.h"

#include "tests/judge/law.h"

void law_surface_normal(vec3 yours, Sphere sphere, vec3 point);
void law_ray_to_light(Ray yours, vec3 from, Light light);
void law_ambient_term(Color yours, Color surface, double kd, Color ambient);
void law_diffuse_term(Color yours, Color surface, double kd, Color light, vec3 normal,
                      vec3 to_light);
void law_mirror_direction(vec3 yours, vec3 direction, vec3 normal);
void law_phong_term(Color yours, double ks, double shine, Color light, vec3 normal, vec3 to_light,
                    vec3 to_eye);
void law_halfway_term(Color yours, double ks, double shine, Color light, vec3 normal, vec3 to_light,
                      vec3 to_eye);
void law_off_surface(vec3 yours, Sphere sphere, vec3 point, vec3 normal);
void law_visibility(double yours, const Scene *scene, vec3 from, Light light);
void law_shade(Color yours, const Scene *scene, Ray ray, Hit hit);
void law_trace_ray(Color yours, const Scene *scene, Ray ray, int depth);
void law_clamp_color(Color yours, Color color);
void law_gamma_encode(Color yours, Color color, double gamma);

#endif
