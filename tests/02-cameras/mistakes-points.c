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
            "no picture, unless the eye is at the origin: it is refused"),
    MISTAKE("F-plus", camera_from_points, eye_added, "point + p",
            "the way from the eye to a point is the way back from the eye to the origin, and then "
            "to the point.",
            "no picture, unless the eye is at the origin: it is refused"),
    MISTAKE("F-from", camera_from_points, from_points_to_the_eye, "p - point",
            "these vectors lead from the plane back to the eye, so all of the frame is turned "
            "round.",
            "what is behind the eye, upside down"),
    MISTAKE("F-eye", camera_from_points, eye_forgotten, "p = (0, 0, 0)",
            "the camera is where the eye is, and the vectors do not know that.",
            "the scene seen from another place"),
    MISTAKE("F-circle", camera_from_points, taken_in_a_circle, "the corners taken in a circle",
            "they come in rows, as one reads: after the upper right comes the lower left.",
            "no picture: every camera is refused"),
    MISTAKE("F-lower", camera_from_points, lower_ones_first, "the lower corners first",
            "they come as one reads: the upper row first. Your up points down.", "upside down"),
    MISTAKE("F-right", camera_from_points, right_ones_first, "the right corners first",
            "they come as one reads: the left one of a row first. Your right points left.",
            "mirrored: left and right swapped"),
    MISTAKE("F-ok", camera_from_points, nothing_refused, "CAMERA_OK, always",
            "any four points have a mean and edges, but not all of them are the corners of a "
            "rectangle straight ahead.",
            "a skewed picture of four points that are not a camera's"),
    MISTAKE("F-check", camera_from_points, left_to_camera_check, "only what camera_check refuses",
            "it sees your frame, and never the four corners: it cannot know that the fourth is "
            "astray, nor whether the rectangle or its place is wrong.",
            "some refused, but for another reason; some not"),
    MISTAKE("F-store", camera_from_points, stored_before_it_is_checked, "stored, then checked",
            "where it is refused, *camera must stay as it was, and is overwritten.",
            "the camera from before lost"),
    MISTAKE("F-dropped", camera_from_points, reason_dropped, "the reason not passed on",
            "camera_from_vectors refused it, and CAMERA_OK says that it did not.",
            "the picture of whatever camera was there before"),
    {0},
};
