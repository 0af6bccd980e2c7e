// mistakes-no-look-at.c - wrong answers to the look-at: which arguments are refused, and with which
// reason.
#include "tests/02-cameras/mistakes.h"

static CameraFault nothing_refused(LookAt view, Handedness world, Camera *camera)
{
    return store(CAMERA_OK, seen(view, world), camera);
}

static CameraFault left_to_camera_check(LookAt view, Handedness world, Camera *camera)
{
    return give(CAMERA_OK, seen(view, world), camera);
}

static CameraFault up_along_view_not_noticed(LookAt view, Handedness world, Camera *camera)
{
    return store(view_reason_but(CAMERA_UP_ALONG_VIEW, view), seen(view, world), camera);
}

static CameraFault up_along_view_called_nan(LookAt view, Handedness world, Camera *camera)
{
    return give(view_reason_but(CAMERA_UP_ALONG_VIEW, view), seen(view, world), camera);
}

static CameraFault up_of_zero_not_noticed(LookAt view, Handedness world, Camera *camera)
{
    CameraFault fault = view_reason(view);
    return store(vec3_length(view.up) == 0 ? CAMERA_OK : fault, seen(view, world), camera);
}

static CameraFault up_against_view_not_noticed(LookAt view, Handedness world, Camera *camera)
{
    Camera c = seen(view, world);
    CameraFault fault = view_reason(view);
    if (fault == CAMERA_UP_ALONG_VIEW && vec3_dot(view.up, c.forward) < 0)
        fault = CAMERA_OK;
    return store(fault, c, camera);
}

static CameraFault up_compared_exactly(LookAt view, Handedness world, Camera *camera)
{
    Camera c = seen(view, world);
    CameraFault fault = view_reason_but(CAMERA_UP_ALONG_VIEW, view);
    if (fault == CAMERA_OK && vec3_length(vec3_cross(c.forward, view.up)) == 0)
        fault = CAMERA_UP_ALONG_VIEW;
    return give(fault, c, camera);
}

static CameraFault only_up_compared_exactly(LookAt view, Handedness world, Camera *camera)
{
    Camera c = seen(view, world);
    bool along = vec3_length(vec3_cross(c.forward, view.up)) == 0;
    return give(along ? CAMERA_UP_ALONG_VIEW : CAMERA_OK, c, camera);
}

static CameraFault short_up_refused(LookAt view, Handedness world, Camera *camera)
{
    Camera c = seen(view, world);
    CameraFault fault = view_reason(view);
    if (fault == CAMERA_OK && vec3_length(vec3_cross(c.forward, view.up)) <= CAMERA_TOLERANCE)
        fault = CAMERA_UP_ALONG_VIEW;
    return give(fault, c, camera);
}

static CameraFault leaning_up_refused(LookAt view, Handedness world, Camera *camera)
{
    Camera c = seen(view, world);
    CameraFault fault = view_reason(view);
    if (fault == CAMERA_OK && fabs(vec3_dot(vec3_unit(view.up), c.forward)) > 0.99)
        fault = CAMERA_UP_ALONG_VIEW;
    return give(fault, c, camera);
}

static CameraFault no_direction_not_noticed(LookAt view, Handedness world, Camera *camera)
{
    CameraFault fault = view_reason(view);
    return store(fault == CAMERA_NO_DIRECTION ? CAMERA_OK : fault, seen(view, world), camera);
}

static CameraFault no_direction_called_up(LookAt view, Handedness world, Camera *camera)
{
    return give(view_reason_but(CAMERA_NO_DIRECTION, view), seen(view, world), camera);
}

static CameraFault width_not_checked(LookAt view, Handedness world, Camera *camera)
{
    return store(view_reason_but(CAMERA_NO_WIDTH, view), seen(view, world), camera);
}

static CameraFault aspect_not_checked(LookAt view, Handedness world, Camera *camera)
{
    return store(view_reason_but(CAMERA_NO_HEIGHT, view), seen(view, world), camera);
}

static CameraFault numbers_not_looked_at(LookAt view, Handedness world, Camera *camera)
{
    return store(view_reason_but(CAMERA_NOT_FINITE, view), seen(view, world), camera);
}

static CameraFault only_vectors_looked_at(LookAt view, Handedness world, Camera *camera)
{
    CameraFault fault = view_reason(view);
    if (!isfinite(view.width) || !isfinite(view.aspect))
        fault = CAMERA_OK;
    return store(fault, seen(view, world), camera);
}

static CameraFault stored_before_it_is_checked(LookAt view, Handedness world, Camera *camera)
{
    *camera = seen(view, world);
    return view_reason(view);
}

const Mistake look_at_refusal_mistakes[] = {
    MISTAKE("L-ok", camera_from_look_at, nothing_refused, "CAMERA_OK, always",
            "the arguments may have no direction of view, an unusable up, or a width below 0.",
            "a black picture: every number is NaN"),
    MISTAKE("L-check", camera_from_look_at, left_to_camera_check, "only the checks of camera_check",
            "it sees your frame after a division by 0 has made NaN of it, and can no longer find "
            "the reason.",
            "refused, but for another reason"),
    MISTAKE("L12", camera_from_look_at, up_along_view_not_noticed,
            "up along the view is not noticed",
            "the cross product is then 0 and has no direction, and normalising it gives NaN.",
            "a black picture: right and up are NaN"),
    MISTAKE("L12-nan", camera_from_look_at, up_along_view_called_nan,
            "up along the view reported as not finite, or not noticed",
            "the arguments were finite. The cross product is 0, or close to 0 after rounding: look "
            "at its length before you divide.",
            "refused, but for another reason; or rolled at random"),
    MISTAKE("L12-zero", camera_from_look_at, up_of_zero_not_noticed,
            "up = (0, 0, 0) is not noticed",
            "it points nowhere, so the camera could be rolled by any angle.",
            "a black picture: right and up are NaN"),
    MISTAKE("L12-against", camera_from_look_at, up_against_view_not_noticed,
            "up against the view is not noticed",
            "straight back is along the view as well: no part of up is perpendicular to the view.",
            "a black picture: right and up are NaN"),
    MISTAKE("L12-exact", camera_from_look_at, up_compared_exactly, "|f x up| == 0",
            "rounding leaves about 1e-17 instead of 0, and that points in a random direction.",
            "rolled at random around the view"),
    MISTAKE("L12-exact-only", camera_from_look_at, only_up_compared_exactly,
            "|f x up| == 0, and no other check",
            "rounding leaves about 1e-17 instead of 0, and that points in a random direction. And "
            "if at is the eye, f is NaN.",
            "rolled at random around the view, or black"),
    MISTAKE("L12-short", camera_from_look_at, short_up_refused,
            "|f x up| <= 1e-9, however short up is",
            "up may have any length. It is along the view if the cross product is short compared "
            "with up itself.",
            "no picture if up is short: the camera is refused"),
    MISTAKE("L12-lean", camera_from_look_at, leaning_up_refused, "f . up > 0.99 is refused",
            "an up that leans far still says which way is up, unless it is along the view to "
            "within 1e-9.",
            "no picture if the camera looks steeply up or down"),
    MISTAKE("L-eye", camera_from_look_at, no_direction_not_noticed, "at = eye is not noticed",
            "the eye then looks nowhere, and normalising (0, 0, 0) gives NaN.",
            "a black picture: every number is NaN"),
    MISTAKE("L-eye-up", camera_from_look_at, no_direction_called_up,
            "at = eye reported as an up along the view",
            "without a direction of view every cross product is 0, but up is not the reason.",
            "refused, but for another reason"),
    MISTAKE("L-w", camera_from_look_at, width_not_checked, "width <= 0 is not noticed",
            "a plane of width 0 shows nothing, and one of width -2 is reversed.",
            "nothing, or turned by 180 degrees"),
    MISTAKE("L-h", camera_from_look_at, aspect_not_checked, "aspect <= 0 is not noticed",
            "the height is then infinite, or negative and runs down.", "upside down, or nothing"),
    MISTAKE("L-nan", camera_from_look_at, numbers_not_looked_at, "NaN and infinity are accepted",
            "every comparison with NaN is false, so a test for 'too small' does not catch it.",
            "a black picture: a number of the camera is NaN"),
    MISTAKE("L-nan-size", camera_from_look_at, only_vectors_looked_at,
            "NaN in width and aspect is accepted",
            "NaN <= 0 is false, so a test for 'not positive' does not catch it.",
            "a black picture: w and h are NaN"),
    MISTAKE("L-store", camera_from_look_at, stored_before_it_is_checked, "stored, then checked",
            "if the camera is refused, *camera must stay as it was, but this overwrites it.",
            "the previous camera is lost"),
    {0},
};
