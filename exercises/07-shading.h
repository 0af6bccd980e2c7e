// 07-shading.h - exercise 07: light, and the color that a surface sends back.
//
// Slide 'Still something missing ...': the same three spheres, flat and shaded. Phong,
// 'Illumination for Computer Generated Pictures', 1975; Blinn, 'Models of Light Reflection for
// Computer Synthesized Pictures', 1977; Whitted, 'An Improved Illumination Model for Shaded
// Display', 1980. Colors and lights are numbers from 0 upwards; only clamp_color clamps them. kd
// and ks are 0 to 1. Normals are unit vectors; other vectors have any length except 0, unless a
// line says unit. Radii are positive.
// Tolerance: 1e-9 of the numbers that go in; for a color, of the light that goes in. Only the
// image in a curved mirror depends a little on how far its rays start off the surface. Worlds and
// lights have any size: no number is too small or too large. There may be any number of spheres and
// lights.
#ifndef EXERCISES_07_SHADING_H
#define EXERCISES_07_SHADING_H

#include "common/ray.h"
#include "common/scene.h"
#include "common/sphere.h"

// The normal of a sphere at a point of it: a unit vector, at right angles to the surface, outward.
vec3 surface_normal(Sphere sphere, vec3 point);

// The ray from a point towards a light (scene.h). For a point light, the light itself is at t = 1.
// For a distant light, the direction is the light's own, with its own length, and the same from
// everywhere.
Ray ray_to_light(vec3 from, Light light);

// The color without any light source: kd times the color of the surface, times the ambient light,
// separately for red, green and blue.
Color ambient_term(Color surface, double kd, Color ambient);

// Lambert: kd times the color, times the light, times the cosine of the angle between the normal
// and the direction to the light; black if the light is behind the surface.
Color diffuse_term(Color surface, double kd, Color light, vec3 normal, vec3 to_light);

// The direction in which a ray continues from a mirror, whichever side it comes from. It has the
// length of the direction that comes in.
vec3 mirror_direction(vec3 direction, vec3 normal);

// Phong's highlight, in the color of the light: ks times the light, times the cosine of the angle
// between the mirrored light and the direction to the eye, to the power of shine. Black if that
// cosine is negative, or if the light is behind the surface. You may assume that the eye is in
// front of the surface. No highlight is tested with shine 0 and a cosine that is not positive
// (pow(0, 0) is 1).
Color phong_term(double ks, double shine, Color light, vec3 normal, vec3 to_light, vec3 to_eye);

// Blinn's variant: the cosine is that of the angle between the normal and the halfway vector,
// which is in the middle between the directions to light and eye. Here the eye may be anywhere; if
// it is behind the surface, black is right as well.
Color halfway_term(double ks, double shine, Color light, vec3 normal, vec3 to_light, vec3 to_eye);

// The shadow bias: a point of a sphere, moved off its surface to the side to which normal points,
// so that a ray from there does not meet the surface where it starts. The distance is at least
// 2^-32 and at most 2^-28 times the size of the numbers. That size is the radius plus the largest
// absolute value of a coordinate of the center. Do not use a fixed epsilon: scenes have any size.
vec3 offset_from_surface(Sphere sphere, vec3 point, vec3 normal);

// How much of a light arrives at a point: 1, or 0 if any sphere is in between. A sphere beyond a
// point light is not in between. If a light touches a surface (to 1e-6 of its radius), 0 and 1
// are both right.
double visibility(const Scene *scene, vec3 from, Light light);

// The light that a surface sends back along the ray that hit it: the ambient term, and for each
// light that arrives the diffuse term and Phong's specular term. If the ray comes from inside, the
// normal is turned to the side of the eye. The surface and the ambient light are those of the
// scene. No mirrors. The ray to a light may start anywhere off the surface, as long as it does not
// meet the surface there.
Color shade(const Scene *scene, Ray ray, Hit hit);

// The color that a ray sees. If it hits nothing, this is the background. If it hits a sphere, this
// is the color that shade returns; and if depth > 0 and the specular of the surface is not 0,
// specular times the color that the mirrored ray sees, with depth - 1, is added.
Color trace_ray(const Scene *scene, Ray ray, int depth);

// Each number at least 0 and at most 1.
Color clamp_color(Color color);

// The color for a display of this gamma, which is positive: each number to the power of 1 / gamma.
// Numbers are 0 to 1.
Color gamma_encode(Color color, double gamma);

#endif
