// scene_camera.c - from an NFF viewpoint to a camera.
#include "chapters/shared/scene_camera.h"

#include "exercises/02-cameras.h"

CameraFault scene_camera(const Viewpoint *view, Resolution screen, Camera *camera)
{
    LookAt look_at = {.eye = view->from,
                      .at = view->at,
                      .up = view->up,
                      .width = width_from_angle(view->angle, vec3_length(view->at - view->from)),
                      .aspect = (double)screen.width / screen.height};
    if (vec3_length(view->at - view->from) == 0)
        look_at.width = 1; // of no camera at all; exercise 02 says why
    return camera_from_look_at(look_at, RIGHT_HANDED, camera);
}

Viewpoint view_turned(Viewpoint view, double degrees)
{
    double angle = degrees * PI / 180;
    vec3 axis = vec3_unit(view.up), arm = view.from - view.at;
    vec3 along = vec3_dot(arm, axis) * axis, out = arm - along;
    view.from = view.at + along + cos(angle) * out + sin(angle) * vec3_cross(axis, out);
    return view;
}
