// scene_camera.h - from an NFF viewpoint to a camera, through the answers of exercise 02.
#ifndef CHAPTERS_SHARED_SCENE_CAMERA_H
#define CHAPTERS_SHARED_SCENE_CAMERA_H

#include "common/camera.h"
#include "common/scene.h"

// The camera that sees what the viewpoint says, on a screen of this size (pixels are square, so
// the size gives the aspect). CAMERA_OK, or the reason why there is none.
CameraFault scene_camera(const Viewpoint *view, Resolution screen, Camera *camera);

#endif
