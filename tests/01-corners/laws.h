// laws.h - laws of exercise 01.
#ifndef TESTS_01_CORNERS_LAWS_H
#define TESTS_01_CORNERS_LAWS_H

#include "common/camera.h"

void law_upper_left(vec3 yours, Camera c);
void law_upper_right(vec3 yours, Camera c);
void law_across_30_up_10(vec3 yours, Camera c);
void law_image_plane_vector(vec3 yours, Camera c, double s, double t);
void law_with_unit_distance(Camera yours, Camera c);

#endif
