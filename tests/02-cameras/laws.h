// laws.h - the laws of exercise 02.
#ifndef TESTS_02_CAMERAS_LAWS_H
#define TESTS_02_CAMERAS_LAWS_H

#include "exercises/02-cameras.h"

void law_camera_from_vectors(CameraFault yours, vec3 eye, Corners vectors, Camera *camera);
void law_camera_from_points(CameraFault yours, vec3 eye, Corners points, Camera *camera);
void law_camera_from_corner(CameraFault yours, vec3 eye, vec3 lower_left, vec3 across, vec3 up,
                            Camera *camera);
void law_camera_from_look_at(CameraFault yours, LookAt view, Handedness world, Camera *camera);
void law_width_from_angle(double yours, double degrees, double distance);

#endif
