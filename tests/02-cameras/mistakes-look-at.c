// mistakes-look-at.c - wrong answers to the look-at: the numbers of the camera.
#include "tests/02-cameras/mistakes.h"

static CameraFault forward_to_the_eye(LookAt view, Handedness world, Camera *camera)
{
    Camera c = seen(view, world);
    c.forward = -c.forward;
    c.right = -c.right; // it follows from the cross product
    return give(view_reason(view), c, camera);
}

static CameraFault only_forward_turned_round(LookAt view, Handedness world, Camera *camera)
{
    Camera c = seen(view, world);
    c.forward = -c.forward;
    return give(view_reason(view), c, camera);
}

static CameraFault hands_mixed_up(LookAt view, Handedness world, Camera *camera)
{
    return camera_from_look_at(view, world == RIGHT_HANDED ? LEFT_HANDED : RIGHT_HANDED, camera);
}

static CameraFault turned_by_180_degrees(LookAt view, Handedness world, Camera *camera)
{
    Camera c = seen(view, world);
    c.right = -c.right;
    c.up = -c.up; // it follows from the cross product
    return give(view_reason(view), c, camera);
}

static CameraFault always_right_handed(LookAt view, Handedness world, Camera *camera)
{
    (void)world;
    return camera_from_look_at(view, RIGHT_HANDED, camera);
}

static CameraFault always_left_handed(LookAt view, Handedness world, Camera *camera)
{
    (void)world;
    return camera_from_look_at(view, LEFT_HANDED, camera);
}

static CameraFault upside_down(LookAt view, Handedness world, Camera *camera)
{
    Camera c = seen(view, world);
    c.up = -c.up;
    return give(view_reason(view), c, camera);
}

static CameraFault up_of_the_right_hand(LookAt view, Handedness world, Camera *camera)
{
    Camera c = seen(view, world);
    c.up = vec3_cross(c.right, c.forward);
    return give(view_reason(view), c, camera);
}

static CameraFault up_as_given(LookAt view, Handedness world, Camera *camera)
{
    Camera c = seen(view, world);
    c.up = view.up;
    return give(view_reason(view), c, camera);
}

static CameraFault up_stored_as_given(LookAt view, Handedness world, Camera *camera)
{
    Camera c = seen(view, world);
    c.up = view.up;
    return store(view_reason(view), c, camera);
}

static CameraFault up_only_made_unit(LookAt view, Handedness world, Camera *camera)
{
    Camera c = seen(view, world);
    c.up = vec3_unit(view.up);
    return give(view_reason(view), c, camera);
}

// As the cross product leaves it.
static Camera right_as_it_comes(LookAt view, Handedness world)
{
    Camera c = seen(view, world);
    c.right *= vec3_length(vec3_cross(c.forward, view.up));
    return c;
}

static CameraFault right_not_unit(LookAt view, Handedness world, Camera *camera)
{
    return give(view_reason(view), right_as_it_comes(view, world), camera);
}

static CameraFault right_stored_not_unit(LookAt view, Handedness world, Camera *camera)
{
    return store(view_reason(view), right_as_it_comes(view, world), camera);
}

static CameraFault forward_not_unit(LookAt view, Handedness world, Camera *camera)
{
    Camera c = seen(view, world);
    c.forward = view.at - view.eye;
    return give(view_reason(view), c, camera);
}

static CameraFault aspect_upside_down(LookAt view, Handedness world, Camera *camera)
{
    Camera c = seen(view, world);
    c.height = view.width * view.aspect;
    return give(view_reason(view), c, camera);
}

static CameraFault aspect_ignored(LookAt view, Handedness world, Camera *camera)
{
    Camera c = seen(view, world);
    c.height = view.width;
    return give(view_reason(view), c, camera);
}

static CameraFault width_taken_for_height(LookAt view, Handedness world, Camera *camera)
{
    view.width *= view.aspect;
    return give(view_reason(view), seen(view, world), camera);
}

static CameraFault distance_of_1(LookAt view, Handedness world, Camera *camera)
{
    Camera c = seen(view, world);
    c.distance = 1;
    return give(view_reason(view), c, camera);
}

static CameraFault distance_squared(LookAt view, Handedness world, Camera *camera)
{
    Camera c = seen(view, world);
    c.distance *= c.distance;
    return give(view_reason(view), c, camera);
}

static CameraFault at_taken_for_a_direction(LookAt view, Handedness world, Camera *camera)
{
    view.at += view.eye;
    return camera_from_look_at(view, world, camera);
}

const Mistake look_at_mistakes[] = {
    MISTAKE(
        "L1", camera_from_look_at, forward_to_the_eye, "d f = eye - at",
        "this leads from the point looked at back to the eye. You look in the opposite direction.",
        "nothing, or the scene behind you"),
    MISTAKE("L1-only", camera_from_look_at, only_forward_turned_round, "f = -f at the end",
            "r and u are right, but f leads away from the point looked at. (In OpenGL the z axis "
            "is -f; here f points ahead.)",
            "the scene behind you, mirrored"),
    MISTAKE("L2", camera_from_look_at, hands_mixed_up, "both cross products in the other order",
            "this is the camera of a world of the other handedness: its right is your left.",
            "mirrored: left and right swapped"),
    MISTAKE("L2-turned", camera_from_look_at, turned_by_180_degrees,
            "the cross product for r in the other order",
            "r then points to the left; and u, made from r, points down.", "turned by 180 degrees"),
    MISTAKE("L2-right", camera_from_look_at, always_right_handed, "r = f x up in either world",
            "this is right in a right-handed world. In a left-handed one, r must point to the "
            "other side.",
            "mirrored in a left-handed world, as the deck's is"),
    MISTAKE("L2-left", camera_from_look_at, always_left_handed, "r = up x f in either world",
            "this is right in a left-handed world. In a right-handed one, r must point to the "
            "other side.",
            "mirrored in a right-handed world"),
    MISTAKE("L2-down", camera_from_look_at, upside_down,
            "the cross product for u in the other order", "u then points away from the given up.",
            "upside down"),
    MISTAKE("L2-up", camera_from_look_at, up_of_the_right_hand, "u = r x f in either world",
            "r was reversed for the left-handed world, and this reverses u as well.",
            "upside down in a left-handed world"),
    MISTAKE("L3", camera_from_look_at, up_as_given, "u = up, unchanged",
            "up may have any length, and may lean towards the view. The frame's own up has length "
            "1 and is perpendicular to f.",
            "no picture, unless up fits by luck: the camera is refused"),
    MISTAKE("L3-stored", camera_from_look_at, up_stored_as_given, "u = up, unchanged and unchecked",
            "up may have any length, and may lean towards the view. The frame's own up has length "
            "1 and is perpendicular to f.",
            "stretched or squashed in height, and skewed if the camera looks up or down"),
    MISTAKE("L3-unit", camera_from_look_at, up_only_made_unit, "u = up / |up|",
            "if the camera looks up or down, the given up leans towards the view: it is not "
            "perpendicular to f.",
            "no picture if the camera looks up or down: the camera is refused"),
    MISTAKE("L4", camera_from_look_at, right_not_unit, "r = the cross product, not normalised",
            "the length of a cross product is the area between its vectors, and that shrinks if up "
            "leans.",
            "no picture, unless up fits by luck: it is refused as not unit"),
    MISTAKE("L4-stored", camera_from_look_at, right_stored_not_unit,
            "r = the cross product, neither normalised nor checked",
            "the length of a cross product is the area between its vectors, and that shrinks if up "
            "leans.",
            "stretched sideways if up leans, squashed if it is long"),
    MISTAKE("L4-forward", camera_from_look_at, forward_not_unit, "f = at - eye",
            "this is d f. The frame gives only directions, so f has length 1.",
            "no picture, unless d is 1: it is refused as not unit"),
    MISTAKE("L10", camera_from_look_at, aspect_upside_down, "h = w aspect",
            "a picture of aspect 2 is wider than high, but this makes it higher than wide.",
            "circles become ellipses"),
    MISTAKE("L11", camera_from_look_at, aspect_ignored, "h = w",
            "a picture is as high as it is wide only if its aspect is 1.",
            "circles become ellipses"),
    MISTAKE("L11-width", camera_from_look_at, width_taken_for_height, "w = width aspect, h = width",
            "the aspect is right, but the given width is the width, not the height.",
            "everything at the wrong size"),
    MISTAKE(
        "L-1", camera_from_look_at, distance_of_1, "d = 1",
        "the image plane passes through the point looked at, so d is the distance to that point.",
        "too much: everything small, right only if d is 1"),
    MISTAKE("L-squared", camera_from_look_at, distance_squared, "d = (at - eye) . (at - eye)",
            "this is the square of the length.", "too little: everything d times as big"),
    MISTAKE("L-direction", camera_from_look_at, at_taken_for_a_direction, "d f = at",
            "at is a point, counted from the origin; the view starts at the eye.",
            "another part of the scene, unless the eye is at the origin"),
    {0},
};
