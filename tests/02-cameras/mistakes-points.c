// mistakes-points.c - wrong answers to eye and four points.
#include "tests/02-cameras/mistakes.h"

static CameraFault points_taken_for_vectors(vec3 eye, Corners points, Camera *camera)
{
    return camera_from_vectors(eye, points, camera);
}

static CameraFault eye_added(vec3 eye, Corners points, Camera *camera)
{
    return camera_from_vectors(eye, moved(points, eye), camera);
}

static CameraFault from_points_to_the_eye(vec3 eye, Corners p, Camera *camera)
{
    Corners v = {eye - p.upper_left, eye - p.upper_right, eye - p.lower_left, eye - p.lower_right};
    return camera_from_vectors(eye, v, camera);
}

static CameraFault eye_forgotten(vec3 eye, Corners points, Camera *camera)
{
    return camera_from_vectors(vec3_of(0, 0, 0), moved(points, -eye), camera);
}

static CameraFault taken_in_a_circle(vec3 eye, Corners p, Camera *camera)
{
    Corners v = moved((Corners){p.upper_left, p.upper_right, p.lower_right, p.lower_left}, -eye);
    return camera_from_vectors(eye, v, camera);
}

static CameraFault lower_ones_first(vec3 eye, Corners p, Camera *camera)
{
    Corners v = moved((Corners){p.lower_left, p.lower_right, p.upper_left, p.upper_right}, -eye);
    return camera_from_vectors(eye, v, camera);
}

static CameraFault right_ones_first(vec3 eye, Corners p, Camera *camera)
{
    Corners v = moved((Corners){p.upper_right, p.upper_left, p.lower_right, p.lower_left}, -eye);
    return camera_from_vectors(eye, v, camera);
}

static CameraFault nothing_refused(vec3 eye, Corners points, Camera *camera)
{
    return store(CAMERA_OK, frame(eye, moved(points, -eye)), camera);
}

static CameraFault left_to_camera_check(vec3 eye, Corners points, Camera *camera)
{
    return give(CAMERA_OK, frame(eye, moved(points, -eye)), camera);
}

static CameraFault stored_before_it_is_checked(vec3 eye, Corners points, Camera *camera)
{
    Corners v = moved(points, -eye);
    *camera = frame(eye, v);
    return reason(eye, v);
}

static CameraFault reason_dropped(vec3 eye, Corners points, Camera *camera)
{
    camera_from_vectors(eye, moved(points, -eye), camera);
    return CAMERA_OK;
}

const Mistake point_mistakes[] = {
    MISTAKE("F-vectors", camera_from_points, points_taken_for_vectors, "the points as vectors",
            "points are counted from the origin, and vectors from the eye.",
            "no picture, unless the eye is at the origin: the camera is refused"),
    MISTAKE("F-plus", camera_from_points, eye_added, "point + p",
            "point + p goes from the eye back to the origin, and then on to the point.",
            "no picture, unless the eye is at the origin: the camera is refused"),
    MISTAKE("F-from", camera_from_points, from_points_to_the_eye, "p - point",
            "these vectors lead from the plane back to the eye, so the whole frame is reversed.",
            "the scene behind the eye, upside down"),
    MISTAKE("F-eye", camera_from_points, eye_forgotten, "p = (0, 0, 0)",
            "the camera is where the eye is, and the vectors alone do not say where that is.",
            "the scene seen from another place"),
    MISTAKE("F-circle", camera_from_points, taken_in_a_circle, "the corners taken in a circle",
            "they come row by row, in reading order: after the upper right comes the lower left.",
            "no picture: every camera is refused"),
    MISTAKE("F-lower", camera_from_points, lower_ones_first, "the lower corners first",
            "they come in reading order: the upper row first. Your up points down.", "upside down"),
    MISTAKE("F-right", camera_from_points, right_ones_first, "the right corners first",
            "they come in reading order: in each row, left before right. Your right points left.",
            "mirrored: left and right swapped"),
    MISTAKE("F-ok", camera_from_points, nothing_refused, "CAMERA_OK, always",
            "any four points have a mean and edges, but they are not always the corners of a "
            "rectangle straight ahead.",
            "a skewed picture of four points that no camera has"),
    MISTAKE("F-check", camera_from_points, left_to_camera_check, "only the checks of camera_check",
            "it sees only your frame, never the four corners: it cannot know that the fourth is "
            "wrong, nor that the shape or its place is wrong.",
            "some refused, but for another reason; some accepted"),
    MISTAKE("F-store", camera_from_points, stored_before_it_is_checked, "stored, then checked",
            "if the camera is refused, *camera must stay as it was, but this overwrites it.",
            "the previous camera is lost"),
    MISTAKE("F-dropped", camera_from_points, reason_dropped, "the reason is not returned",
            "camera_from_vectors refused the camera, but you return CAMERA_OK.",
            "the picture of whatever camera was there before"),
    {0},
};
