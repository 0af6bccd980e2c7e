// 07-shading-scene.h - the laws of the functions of exercise 07 that need a scene.
#ifndef TESTS_LAWS_07_SHADING_SCENE_H
#define TESTS_LAWS_07_SHADING_SCENE_H

#include "exercises/07-shading.h"

#include "tests/laws/laws.h"

void law_off_surface(vec3 yours, Sphere sphere, vec3 point, vec3 normal);
void law_visibility(double yours, const Scene *scene, vec3 from, Light light);
void law_shade(Color yours, const Scene *scene, Ray ray, Hit hit);
void law_trace_ray(Color yours, const Scene *scene, Ray ray, int depth);

#endif
