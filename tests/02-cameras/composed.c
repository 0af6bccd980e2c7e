// composed.c - answers to exercise 02 that call other answers of it.
#include "tests/proof/composed.h"

#include "solutions/02-cameras.c"

SOLUTION(camera_from_points);
SOLUTION(camera_from_corner);

static const Composed composed[] = {
    COMPOSED(camera_from_points, own_camera_from_points),
    COMPOSED(camera_from_corner, own_camera_from_corner),
    {0},
};
OF_STEM(composed)

// Which mistake a mistake of the called function becomes in the caller.
static const SameMistake same_mistakes[] = {
    {"camera_from_points", "V-mirror", "F-right"},
    {"camera_from_points", "V-eye", "F-eye"},
    {"camera_from_points", "V-ok", "F-ok"},
    {"camera_from_points", "V-check", "F-check"},
    {"camera_from_points", "V-store", "F-store"},
    {"camera_from_points", "V-tiny", "F-tiny"},
    {"camera_from_corner", "V-left-handed", "K-hand"},
    {"camera_from_corner", "V-unit", "K-unit in part"},
    {"camera_from_corner", "V-ok", "K-ok"},
    {"camera_from_corner", "V-check", "K-check"},
    {"camera_from_corner", "V-any", "K-lean"},
    {"camera_from_corner", "V-lean", "K-lean"},
    {"camera_from_corner", "V-axis", "K-axis"},
    {"camera_from_corner", "V-exact-axis", "K-exact-axis"},
    {"camera_from_corner", "V-store", "K-store"},
    {"camera_from_corner", "V-tiny", "K-tiny"},
    {"camera_from_corner", "V-both", "K-square"},
    {0},
};
OF_STEM(same_mistakes)
