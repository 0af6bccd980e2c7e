// 07-shading.h - exercise 07: light, and what a surface makes of it.
//
// Slide 'Still something missing ...': the same three spheres, flat and shaded. Phong,
// 'Illumination for Computer Generated Pictures', 1975; Blinn, 'Models of Light Reflection for
// Computer Synthesized Pictures', 1977; Whitted, 'An Improved Illumination Model for Shaded
// Display', 1980. Colours and lights are numbers from 0 on, not clamped before clamp_color; kd and
// ks are 0 to 1. Normals are unit; other vectors have any length but 0, unless a line says unit.
// Radii are positive.
// Tolerance: 1e-9 of the numbers that go in; of a colour, of the light that goes in. Only what a
// curved mirror shows depends a little on how far its rays start off the surface. Worlds and lights
// are of any size: no number is too small or too large, and there may be any number of things.
#ifndef EXERCISES_07_SHADING_H
#define EXERCISES_07_SHADING_H

#include "common/ray.h"
#include "common/scene.h"
#include "common/sphere.h"

// The normal of a sphere at a point of it: unit, at right angles to the surface, outward.
vec3 surface_normal(Sphere sphere, vec3 point);

// The ray from a place towards a light (scene.h). Of a point light, t = 1 is the light itself; of
// a distant one the direction is the light's own, as long as it is, the same from everywhere.
Ray ray_to_light(vec3 from, Light light);

// What is there without any light: kd times the surface's colour, times the ambient light,
// colour by colour.
Color ambient_term(Color surface, double kd, Color ambient);

// Lambert: kd times the colour, times the light, times the cosine of the angle between the normal
// and the way to the light; nothing where the light is behind the surface.
Color diffuse_term(Color surface, double kd, Color light, vec3 normal, vec3 to_light);

// The direction in which a mirror sends a ray on, whichever side it comes from. As long as the one
// that comes in.
vec3 mirror_direction(vec3 direction, vec3 normal);

// Phong's highlight, in the colour of the light: ks times the light, times the cosine between the
// mirrored light and the way to the eye, to the power of shine. Nothing where that cosine is
// negative, or the light is behind the surface. The eye is in front of it, and shine is not 0 where
// the cosine is negative: pow(0, 0) is 1.
Color phong_term(double ks, double shine, Color light, vec3 normal, vec3 to_light, vec3 to_eye);

// Blinn's variant: the cosine between the normal and the vector half-way between light and eye,
// which may be anywhere.
Color halfway_term(double ks, double shine, Color light, vec3 normal, vec3 to_light, vec3 to_eye);

// A point of a sphere, moved off its surface to the side to which normal points, so that a ray from
// there does not meet the surface that it starts from: at least 2^-32 and at most 2^-28 times the
// size of the numbers, which is the radius plus the largest coordinate of the centre (its absolute
// value). No fixed epsilon: scenes are of any size.
vec3 off_surface(Sphere sphere, vec3 point, vec3 normal);

// How much of a light arrives at a place: 1, or 0 where any sphere is in between. Of a point light,
// what lies behind it is not in between. A surface that meets the light to a millionth of its
// radius may be either.
double visibility(const Scene *scene, vec3 from, Light light);

// The light that a surface sends back along the ray that hit it: ambient, and of each light that
// arrives diffuse and Phong's specular. Seen from inside, the normal is turned to the eye's side.
// The surface and the ambient light are the scene's. No mirrors. How the way to a light begins off
// the surface is free, as long as it does not meet the surface there.
Color shade(const Scene *scene, Ray ray, Hit hit);

// The colour that a ray sees: the background; or what shade says and, where depth > 0 and the
// surface's specular is not 0, specular times what the mirrored ray sees with depth - 1.
Color trace_ray(const Scene *scene, Ray ray, int depth);

// Each number at least 0 and at most 1.
Color clamp_color(Color color);

// For a display of this gamma, which is positive: each number to the power of 1 / gamma. Numbers
// are 0 to 1.
Color gamma_encode(Color color, double gamma);

#endif
