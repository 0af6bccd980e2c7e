// room.h - a room to look around in, for the optional tasks that come before any sphere.
//
// It is 8 wide (x), 3.6 high (y) and 12 long (z), with the floor at y = 0 and its middle at x = z =
// 0. Up is y. As in the deck's drawings, someone who looks along z has x to the right.
#ifndef CHAPTERS_SHARED_ROOM_H
#define CHAPTERS_SHARED_ROOM_H

#include "common/camera.h"
#include "common/image.h"
#include "common/ray.h"
#include "common/screen.h"

// A camera near one end of the room that looks along z, to the other end. Its image plane has the
// shape of the screen.
Camera room_camera(Resolution screen);

// The colour that a ray sees if it starts inside the room.
Color room_color(Ray ray);

#endif
