// composed.c - answers to exercise 06 that call other answers of it.
#include "tests/proof/composed.h"

#include "exercises/06-ray-casting.h"

// If nearest_hit has found a sphere that does not exist, a student's answer may guard itself.
static const Surface *some_surface(const Scene *scene, int sphere)
{
    static const Surface black;
    return sphere < scene->sphere_count ? scene_surface(scene, sphere) : &black;
}

#define scene_surface some_surface
#include "solutions/06-ray-casting.c"

SOLUTION(cast_image_order);

static const Composed composed[] = {
    COMPOSED(cast_image_order, own_cast_image_order),
    {0},
};
OF_STEM(composed)

// Which mistake a mistake of the called function becomes in the caller.
static const SameMistake same_mistakes[] = {
    {"cast_image_order", "H1", "I-last"},
    {"cast_image_order", "H1-first", "I-first"},
    {"cast_image_order", "H3", "I-none"},
    {"cast_image_order", "H3-0", "I-none"},
    {"cast_image_order", "H3-1000", "I-up-1000"},
    {"cast_image_order", "H-more", "I-none"},
    {"cast_image_order", "H-far", "I-far"},
    {"cast_image_order", "H-tie", "I-tie"},
    {"cast_image_order", "R6-scene", "R6-image"},
    {"cast_image_order", "R7-scene", "R7-image"},
    {"cast_image_order", "R8-scene", "R8-image"},
    {"cast_image_order", "D1-scene", "D1-image"},
    {"cast_image_order", "R10-small", "I-t-0.001"},
    {"cast_image_order", "H-float", "I-by-float"},
    {"cast_image_order", "H-no-sphere", "I-none"},
    {"cast_image_order", "H-no-t", "I-last"},
    {"cast_image_order", "H-first-index", "I-first"},
    {"cast_image_order", "P7-scene", "P7"},
    {"cast_image_order", "H-none-count", "I-black"},
    {"cast_image_order", "H-count", "I-black"},
    {"cast_image_order", "H-1e-4", "I-t-1e-4"},
    {"cast_image_order", "H-1e-5", "I-t-1e-5"},
    {"cast_image_order", "H-1e-6", "I-t-1e-6"},
    {"cast_image_order", "H-1e-9", "I-t-1e-9"},
    {"cast_image_order", "H-up-1000", "I-up-1000"},
    {"cast_image_order", "H-up-1e6", "I-up-1e6"},
    {"cast_image_order", "H-up-1e9", "I-up-1e9"},
    {"cast_image_order", "H-up-1e12", "I-up-1e12"},
    {"cast_image_order", "H-by-1e-3", "I-by-0.001"},
    {"cast_image_order", "H-by-1e-6", "I-by-1e-6"},
    {"cast_image_order", "H-by-1e-9", "I-by-1e-9"},
    {"cast_image_order", "H-by-float", "I-by-float"},
    {"cast_image_order", "H-room10", "I-room10"},
    {"cast_image_order", "H-room16", "I-room16"},
    {"cast_image_order", "H-room32", "I-room32"},
    {"cast_image_order", "H-room64", "I-room64"},
    {"cast_image_order", "H-room100", "I-room100"},
    {"cast_image_order", "H-room128", "I-room128"},
    {"cast_image_order", "H-room256", "I-room256"},
    {0},
};
OF_STEM(same_mistakes)
