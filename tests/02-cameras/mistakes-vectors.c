// mistakes-vectors.c - wrong answers to eye and four vectors: the numbers of the camera.
#include "tests/02-cameras/mistakes.h"

static CameraFault right_to_left(vec3 eye, Corners v, Camera *camera)
{
    Camera c = frame(eye, v);
    c.right = -c.right;
    return give(reason(eye, v), c, camera);
}

static CameraFault downward(vec3 eye, Corners v, Camera *camera)
{
    Camera c = frame(eye, v);
    c.up = -c.up;
    return give(reason(eye, v), c, camera);
}

static CameraFault behind_the_eye(vec3 eye, Corners v, Camera *camera)
{
    Camera c = frame(eye, v);
    c.forward = -c.forward;
    return give(reason(eye, v), c, camera);
}

static CameraFault right_and_up_swapped(vec3 eye, Corners v, Camera *camera)
{
    Camera c = frame(eye, v), swapped = c;
    swapped.right = c.up;
    swapped.up = c.right;
    swapped.width = c.height;
    swapped.height = c.width;
    return give(reason(eye, v), swapped, camera);
}

static CameraFault width_and_height_swapped(vec3 eye, Corners v, Camera *camera)
{
    Camera c = frame(eye, v), swapped = c;
    swapped.width = c.height;
    swapped.height = c.width;
    return give(reason(eye, v), swapped, camera);
}

static CameraFault always_right_handed(vec3 eye, Corners v, Camera *camera)
{
    Camera c = frame(eye, v);
    c.right = vec3_cross(c.forward, c.up);
    return give(reason(eye, v), c, camera);
}

static CameraFault always_left_handed(vec3 eye, Corners v, Camera *camera)
{
    Camera c = frame(eye, v);
    c.right = vec3_cross(c.up, c.forward);
    return give(reason(eye, v), c, camera);
}

static CameraFault not_unit(vec3 eye, Corners v, Camera *camera)
{
    Camera c = frame(eye, v);
    c.forward *= c.distance;
    return give(reason(eye, v), c, camera);
}

static CameraFault edges_stored_not_unit(vec3 eye, Corners v, Camera *camera)
{
    Camera c = frame(eye, v);
    c.right *= c.width;
    c.up *= c.height;
    return store(reason(eye, v), c, camera);
}

static CameraFault forward_stored_not_unit(vec3 eye, Corners v, Camera *camera)
{
    Camera c = frame(eye, v);
    c.forward *= c.distance;
    return store(reason(eye, v), c, camera);
}

static CameraFault half_of_width_and_height(vec3 eye, Corners v, Camera *camera)
{
    Camera c = frame(eye, v);
    c.width /= 2;
    c.height /= 2;
    return give(reason(eye, v), c, camera);
}

static CameraFault differences_of_x_and_y(vec3 eye, Corners v, Camera *camera)
{
    Camera c = frame(eye, v);
    c.width = v.upper_right[0] - v.upper_left[0];
    c.height = v.upper_left[1] - v.lower_left[1];
    return give(reason(eye, v), c, camera);
}

static CameraFault sum_of_four(vec3 eye, Corners v, Camera *camera)
{
    Camera c = frame(eye, v);
    c.distance *= 4;
    return give(reason(eye, v), c, camera);
}

static CameraFault distance_to_a_corner(vec3 eye, Corners v, Camera *camera)
{
    Camera c = frame(eye, v);
    c.distance = vec3_length(v.upper_left);
    return give(reason(eye, v), c, camera);
}

static CameraFault forward_to_a_corner(vec3 eye, Corners v, Camera *camera)
{
    Camera c = frame(eye, v);
    c.forward = vec3_unit(v.upper_left);
    return give(reason(eye, v), c, camera);
}

static CameraFault distance_of_1(vec3 eye, Corners v, Camera *camera)
{
    Camera c = frame(eye, v);
    c.distance = 1;
    return give(reason(eye, v), c, camera);
}

static CameraFault plane_moved_to_distance_1(vec3 eye, Corners v, Camera *camera)
{
    Camera c = frame(eye, v);
    c.width /= c.distance;
    c.height /= c.distance;
    c.distance = 1;
    return give(reason(eye, v), c, camera);
}

static CameraFault eye_at_zero(vec3 eye, Corners v, Camera *camera)
{
    Camera c = frame(eye, v);
    c.origin = vec3_of(0, 0, 0);
    return give(reason(eye, v), c, camera);
}

static CameraFault taken_for_points(vec3 eye, Corners v, Camera *camera)
{
    return camera_from_points(eye, v, camera);
}

const Mistake vector_mistakes[] = {
    MISTAKE("V-mirror", camera_from_vectors, right_to_left, "w r = upper left - upper right",
            "this edge runs from right to left, but r points to the right.",
            "mirrored: left and right swapped"),
    MISTAKE("V-down", camera_from_vectors, downward, "h u = lower left - upper left",
            "this edge runs down, but u points up.", "upside down"),
    MISTAKE("V-behind", camera_from_vectors, behind_the_eye, "d f = -mean",
            "the vectors lead from the eye to the plane, and so does f.",
            "the scene behind the eye, or nothing"),
    MISTAKE("V-swap", camera_from_vectors, right_and_up_swapped,
            "w r = upper left - lower left, h u = upper right - upper left",
            "right runs along the upper edge, up along the left one.",
            "transposed: rows become columns"),
    MISTAKE("V-sizes", camera_from_vectors, width_and_height_swapped,
            "w = |upper left - lower left|, h = |upper right - upper left|",
            "this edge runs up the picture, so its length is the height of the picture.",
            "squashed: the picture's sides swapped"),
    MISTAKE("V-right-handed", camera_from_vectors, always_right_handed, "r = f x u",
            "this makes every frame right-handed. The rectangle itself says where right is, and it "
            "may have either handedness.",
            "every left-handed camera mirrored, including the deck's"),
    MISTAKE("V-left-handed", camera_from_vectors, always_left_handed, "r = u x f",
            "this makes every frame left-handed. The rectangle itself says where right is, and it "
            "may have either handedness.",
            "every right-handed camera mirrored"),
    MISTAKE("V-unit", camera_from_vectors, not_unit, "f = mean, r and u = edges",
            "the frame gives only directions, so each of its vectors has length 1. d, w and h hold "
            "the lengths.",
            "no picture: every camera is refused as not unit"),
    MISTAKE("V-edges", camera_from_vectors, edges_stored_not_unit,
            "r = upper right - upper left, u = upper left - lower left",
            "these are as long as the picture is wide and high, so w and h would count twice.",
            "too much: right only if w and h are 1"),
    MISTAKE("V-forward", camera_from_vectors, forward_stored_not_unit, "f = mean",
            "this already reaches the plane, so d would count twice.",
            "too little: everything d times as big"),
    MISTAKE("V-half", camera_from_vectors, half_of_width_and_height,
            "w = |upper right - upper left| / 2, h likewise",
            "w and h run from edge to edge. Half of them is what you need from the middle.",
            "half of the width and height: everything twice as big"),
    MISTAKE("V-x-y", camera_from_vectors, differences_of_x_and_y,
            "w = difference of x, h = difference of y",
            "an edge may have any direction in space: its length depends on x, y and z.",
            "right only if r is along x and u along y"),
    MISTAKE("V-sum", camera_from_vectors, sum_of_four,
            "d f = upper left + upper right + lower left + lower right",
            "each of the four goes as far ahead as the plane is, so their sum goes four times as "
            "far.",
            "everything four times as big"),
    MISTAKE("V-far", camera_from_vectors, distance_to_a_corner, "d = |upper left|",
            "a corner is farther away than the middle of the plane is.",
            "everything a little too big"),
    MISTAKE("V-corner", camera_from_vectors, forward_to_a_corner, "f along upper left",
            "straight ahead is the middle of the plane. The vector to a corner is not "
            "perpendicular to the edges.",
            "no picture: every camera is refused as not at right angles"),
    MISTAKE("V-1", camera_from_vectors, distance_of_1, "d = 1",
            "f has length 1, but the plane is where the vectors end.",
            "too much: everything small, right only if d is 1"),
    MISTAKE("V-1-all", camera_from_vectors, plane_moved_to_distance_1, "d = 1, w / d, h / d",
            "the rays are right, but this is not the plane whose corners were given.",
            "no difference: the same picture with another plane"),
    MISTAKE("V-eye", camera_from_vectors, eye_at_zero, "p = (0, 0, 0)",
            "the vectors start at the eye, and they do not say where it is.",
            "the scene seen from another place"),
    MISTAKE("V-points", camera_from_vectors, taken_for_points, "each vector - p",
            "these vectors start at the eye already. Only from points is the eye subtracted.",
            "no picture, unless the eye is at the origin: the camera is refused"),
    {0},
};
