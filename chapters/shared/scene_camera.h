// scene_camera.h - from an NFF viewpoint to a camera, through the answers of exercise 02.
#ifndef CHAPTERS_SHARED_SCENE_CAMERA_H
#define CHAPTERS_SHARED_SCENE_CAMERA_H

#include "common/camera.h"
#include "common/scene.h"

// The camera of a viewpoint, for a screen of this size (pixels are square, so the size gives the
// aspect ratio). CAMERA_OK, or the reason why there is no camera.
CameraFault scene_camera(const Viewpoint *view, Resolution screen, Camera *camera);

// The same viewpoint with its eye moved on a circle around the line through 'at' along 'up', by
// degrees: anticlockwise, if 'up' points to whoever looks.
Viewpoint view_turned(Viewpoint view, double degrees);

#endif
