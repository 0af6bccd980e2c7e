// mistakes-unchecked.c - the most common slips again, of authors who have not written the refusals
// yet: they leave the checking to camera_check, or return the camera unchecked.
#include "tests/02-cameras/mistakes.h"

// From slip(arguments), the camera as it is found.
#define VECTORS_UNCHECKED(slip)                                                                    \
    static CameraFault slip##_checked(vec3 eye, Corners v, Camera *camera)                         \
    {                                                                                              \
        return give(CAMERA_OK, slip(eye, v), camera);                                              \
    }                                                                                              \
    static CameraFault slip##_stored(vec3 eye, Corners v, Camera *camera)                          \
    {                                                                                              \
        return store(CAMERA_OK, slip(eye, v), camera);                                             \
    }
#define VIEW_CHECKED(slip)                                                                         \
    static CameraFault slip##_checked(LookAt view, Handedness world, Camera *camera)               \
    {                                                                                              \
        return give(CAMERA_OK, slip(view, world), camera);                                         \
    }
#define VIEW_STORED(slip)                                                                          \
    static CameraFault slip##_stored(LookAt view, Handedness world, Camera *camera)                \
    {                                                                                              \
        return store(CAMERA_OK, slip(view, world), camera);                                        \
    }

// ---- eye and four vectors -----------------------------------------------------------------------

static Camera sum_of_four(vec3 eye, Corners v)
{
    Camera c = frame(eye, v);
    c.distance *= 4;
    return c;
}

static Camera edges_not_unit(vec3 eye, Corners v)
{
    Camera c = frame(eye, v);
    c.right *= c.width;
    c.up *= c.height;
    return c;
}

VECTORS_UNCHECKED(sum_of_four)
VECTORS_UNCHECKED(edges_not_unit)

const Mistake vector_unchecked_mistakes[] = {
    MISTAKE("V-sum-check", camera_from_vectors, sum_of_four_checked,
            "d f = upper left + upper right + lower left + lower right",
            "each of the four goes as far ahead as the plane is, so their sum goes four times as "
            "far.",
            "everything four times as big"),
    MISTAKE("V-sum-store", camera_from_vectors, sum_of_four_stored,
            "d f = upper left + upper right + lower left + lower right",
            "each of the four goes as far ahead as the plane is, so their sum goes four times as "
            "far.",
            "everything four times as big"),
    MISTAKE("V-edges-check", camera_from_vectors, edges_not_unit_checked,
            "r = upper right - upper left, u = upper left - lower left",
            "the frame gives only directions, so each of its vectors has length 1. w and h hold "
            "the lengths.",
            "no picture: every camera is refused as not unit"),
    MISTAKE("V-edges-store", camera_from_vectors, edges_not_unit_stored,
            "r = upper right - upper left, u = upper left - lower left",
            "these are as long as the picture is wide and high, so w and h would count twice.",
            "too much: right only if w and h are 1"),
    {0},
};

// ---- look-at ------------------------------------------------------------------------------------

static Camera forward_to_the_eye(LookAt view, Handedness world)
{
    Camera c = seen(view, world);
    c.forward = -c.forward;
    c.right = -c.right; // it follows from the cross product
    return c;
}

static Camera hands_mixed_up(LookAt view, Handedness world)
{
    return seen(view, world == RIGHT_HANDED ? LEFT_HANDED : RIGHT_HANDED);
}

static Camera always_right_handed(LookAt view, Handedness world)
{
    (void)world;
    return seen(view, RIGHT_HANDED);
}

static Camera always_left_handed(LookAt view, Handedness world)
{
    (void)world;
    return seen(view, LEFT_HANDED);
}

static Camera up_as_given(LookAt view, Handedness world)
{
    Camera c = seen(view, world);
    c.up = view.up;
    return c;
}

static Camera aspect_upside_down(LookAt view, Handedness world)
{
    Camera c = seen(view, world);
    c.height = view.width * view.aspect;
    return c;
}

// As the cross product leaves it, and up as well.
static Camera cross_not_unit(LookAt view, Handedness world)
{
    Camera c = seen(view, world);
    double length = vec3_length(vec3_cross(c.forward, view.up));
    c.right *= length;
    c.up *= length;
    return c;
}

static Camera product_for_cross(LookAt view, Handedness world)
{
    Camera c = seen(view, world);
    c.right = vec3_unit(c.forward * view.up);
    c.up = c.right * c.forward;
    return c;
}

VIEW_CHECKED(forward_to_the_eye)
VIEW_CHECKED(hands_mixed_up)
VIEW_CHECKED(always_right_handed)
VIEW_CHECKED(always_left_handed)
VIEW_CHECKED(up_as_given)
VIEW_CHECKED(aspect_upside_down)
VIEW_STORED(aspect_upside_down)
VIEW_CHECKED(cross_not_unit)
VIEW_STORED(cross_not_unit)
VIEW_CHECKED(product_for_cross)
VIEW_STORED(product_for_cross)

static CameraFault cross_not_unit_refused(LookAt view, Handedness world, Camera *camera)
{
    return store(view_reason(view), cross_not_unit(view, world), camera);
}

static CameraFault product_for_cross_refused(LookAt view, Handedness world, Camera *camera)
{
    CameraFault fault = view_reason_but(CAMERA_UP_ALONG_VIEW, view);
    double length = vec3_length(vec3_unit(view.at - view.eye) * view.up);
    if (fault == CAMERA_OK && length <= CAMERA_TOLERANCE * vec3_length(view.up))
        fault = CAMERA_UP_ALONG_VIEW;
    return give(fault, product_for_cross(view, world), camera);
}

#define NOT_UNIT(id, answer, picture)                                                              \
    MISTAKE(id, camera_from_look_at, answer,                                                       \
            "r = the cross product, not normalised, and u from it",                                \
            "the length of a cross product is the area between its vectors, and that shrinks if "  \
            "up leans.",                                                                           \
            picture)
#define PRODUCT(id, answer)                                                                        \
    MISTAKE(id, camera_from_look_at, answer, "r = f * up, normalised",                             \
            "v * w multiplies component by component, and the result is perpendicular to "         \
            "neither. The cross product is vec3_cross.",                                           \
            "no picture, or one skewed beyond recognition")

const Mistake look_at_unchecked_mistakes[] = {
    MISTAKE(
        "L1-check", camera_from_look_at, forward_to_the_eye_checked, "d f = eye - at",
        "this leads from the point looked at back to the eye. You look in the opposite direction.",
        "nothing, or the scene behind you"),
    MISTAKE("L2-check", camera_from_look_at, hands_mixed_up_checked,
            "both cross products in the other order",
            "this is the camera of a world of the other handedness: its right is your left.",
            "mirrored: left and right swapped"),
    MISTAKE("L2-right-check", camera_from_look_at, always_right_handed_checked,
            "r = f x up in either world",
            "this is right in a right-handed world. In a left-handed one, r must point to the "
            "other side.",
            "mirrored in a left-handed world, as the deck's is"),
    MISTAKE("L2-left-check", camera_from_look_at, always_left_handed_checked,
            "r = up x f in either world",
            "this is right in a left-handed world. In a right-handed one, r must point to the "
            "other side.",
            "mirrored in a right-handed world"),
    MISTAKE("L3-check", camera_from_look_at, up_as_given_checked, "u = up, unchanged",
            "up may have any length, and may lean towards the view. The frame's own up has length "
            "1 and is perpendicular to f.",
            "no picture, unless up fits by luck: the camera is refused"),
    MISTAKE("L10-check", camera_from_look_at, aspect_upside_down_checked, "h = w aspect",
            "a picture of aspect 2 is wider than high, but this makes it higher than wide.",
            "circles become ellipses"),
    MISTAKE("L10-store", camera_from_look_at, aspect_upside_down_stored, "h = w aspect",
            "a picture of aspect 2 is wider than high, but this makes it higher than wide.",
            "circles become ellipses"),
    NOT_UNIT("L4-check", cross_not_unit_checked,
             "no picture, unless up fits by luck: it is refused as not unit"),
    NOT_UNIT("L4-store", cross_not_unit_stored, "stretched or squashed if up leans or is long"),
    NOT_UNIT("L4-both", cross_not_unit_refused, "stretched or squashed if up leans or is long"),
    PRODUCT("L-product", product_for_cross_refused),
    PRODUCT("L-product-check", product_for_cross_checked),
    PRODUCT("L-product-store", product_for_cross_stored),
    {0},
};
