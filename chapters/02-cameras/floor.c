// floor.c - a tiled floor, seen by the same look-at in a right-handed and in a left-handed world.
//
// The x axis is red, the z axis blue, both from the origin in their positive direction. In one
// world red goes to the right, in the other to the left: the pictures are mirror images.
#include "chapters/02-cameras/floor.h"

#include "common/picture.h"
#include "exercises/01-corners.h"
#include "exercises/02-cameras.h"

#include <stddef.h>

enum { SIDE = 320 }; // pixels of each half

static Color color_of_floor(vec3 eye, vec3 v)
{
    if (v[1] >= 0)
        return vec3_of(0.75, 0.85, 0.95); // the sky
    vec3 point = eye - eye[1] / v[1] * v;
    if (fabs(point[2]) < 0.06 && point[0] > 0)
        return vec3_of(0.8, 0.1, 0.1);
    if (fabs(point[0]) < 0.06 && point[2] > 0)
        return vec3_of(0.1, 0.2, 0.8);
    bool light = fmod(floor(point[0]) + floor(point[2]), 2) == 0;
    return light ? vec3_of(0.9, 0.88, 0.8) : vec3_of(0.55, 0.55, 0.5);
}

// If the camera was refused or is not answered yet, the pixel is black.
static Color color_of_pixel(Pixel pixel, void *given)
{
    (void)given;
    const LookAt view = {vec3_of(3, 2.5, 6), vec3_of(0.5, 0, 0.5), vec3_of(0, 1, 0), 6, 1};
    Camera camera;
    Handedness hand = pixel.column < SIDE ? RIGHT_HANDED : LEFT_HANDED;
    if (camera_from_look_at(view, hand, &camera) != CAMERA_OK)
        return vec3_of(0, 0, 0);
    vec3 v = image_plane_vector(camera, pixel.column % SIDE / (SIDE - 1.0),
                                1 - pixel.row / (SIDE - 1.0));
    return color_of_floor(view.eye, v);
}

int floor_picture(const char *path)
{
    return picture_write(path, (Resolution){2 * SIDE, SIDE}, color_of_pixel, NULL);
}
