// mistakes-nearest-limits.c - wrong answers to nearest_hit: limits that no scene has.
#include "tests/06-ray-casting/mistakes-limits.h"

// Right except for a limit that no scene has, and the rows of the table for these.
#define FROM(name, t_of) LOOP(name, nothing, t_of, nearer)
FROM(from_1e_4, hit_beyond_1e_4)
FROM(from_1e_5, hit_beyond_1e_5)
FROM(from_1e_6, hit_beyond_1e_6)
FROM(from_1e_9, hit_beyond_1e_9)
FROM(up_to_100, hit_before_100)
FROM(up_to_1000, hit_before_1000)
FROM(up_to_10000, hit_before_10000)
FROM(up_to_1e5, hit_before_1e5)
FROM(up_to_1e6, hit_before_1e6)
FROM(up_to_1e9, hit_before_1e9)
FROM(up_to_1e10, hit_before_1e10)
FROM(up_to_1e12, hit_before_1e12)
LOOP(by_a_thousandth, nothing, hit_sphere, nearer_by_a_thousandth)
LOOP(by_a_hundred_thousandth, nothing, hit_sphere, nearer_by_a_hundred_thousandth)
LOOP(by_a_millionth, nothing, hit_sphere, nearer_by_a_millionth)
LOOP(by_a_billionth, nothing, hit_sphere, nearer_by_a_billionth)

static Hit compared_as_floats(Ray ray, const Scene *scene)
{
    return best_of(nothing, hit_sphere, nearer_as_floats, ray, scene);
}

#define OF_THE_FIRST(number)                                                                       \
    static Hit of_the_first_##number(Ray ray, const Scene *scene)                                  \
    {                                                                                              \
        Scene some = at_most(number, scene);                                                       \
        return nearest_hit(ray, &some);                                                            \
    }
OF_THE_FIRST(10)
OF_THE_FIRST(16)
OF_THE_FIRST(32)
OF_THE_FIRST(64)
OF_THE_FIRST(100)
OF_THE_FIRST(128)
OF_THE_FIRST(256)

#define FROM_ROW(id, answer, least)                                                                \
    MISTAKE(id, nearest_hit, answer, "hits with t up to " least " dropped",                        \
            "t counts in lengths of the direction, and scenes are of any size: every hit with "    \
            "t > 0 is in front of the eye.",                                                       \
            "right in scenes of one size, holes in others")
#define UP_TO_ROW(id, answer, most)                                                                \
    MISTAKE(id, nearest_hit, answer, "only hits with t below " most,                               \
            "a scene may be of any size: every t > 0 is a hit.",                                   \
            "no visible difference, until a sphere is farther away than that")
#define BY_ROW(id, answer, epsilon)                                                                \
    MISTAKE(id, nearest_hit, answer, "only hits that are nearer by " epsilon,                      \
            "scenes are of any size, and t counts in lengths of the direction: nearer is nearer, " \
            "by however little.",                                                                  \
            "right in scenes of one size, wrong colours in smaller ones")
#define FIRST_ROW(number)                                                                          \
    MISTAKE("H-room" #number, nearest_hit, of_the_first_##number, "the first " #number " spheres", \
            "the number of spheres in the scene is sphere_count.",                                 \
            "no visible difference, until a scene has more spheres")

const Mistake nearest_limit_mistakes[] = {
    FROM_ROW("H-1e-4", from_1e_4, "1e-4"),
    FROM_ROW("H-1e-5", from_1e_5, "1e-5"),
    FROM_ROW("H-1e-6", from_1e_6, "1e-6"),
    FROM_ROW("H-1e-9", from_1e_9, "1e-9"),
    UP_TO_ROW("H-up-100", up_to_100, "100"),
    UP_TO_ROW("H-up-1000", up_to_1000, "1000"),
    UP_TO_ROW("H-up-10000", up_to_10000, "10000"),
    UP_TO_ROW("H-up-1e5", up_to_1e5, "1e5"),
    UP_TO_ROW("H-up-1e6", up_to_1e6, "1e6"),
    UP_TO_ROW("H-up-1e9", up_to_1e9, "1e9"),
    UP_TO_ROW("H-up-1e10", up_to_1e10, "1e10"),
    UP_TO_ROW("H-up-1e12", up_to_1e12, "1e12"),
    BY_ROW("H-by-1e-3", by_a_thousandth, "0.001"),
    BY_ROW("H-by-1e-5", by_a_hundred_thousandth, "1e-5"),
    BY_ROW("H-by-1e-6", by_a_millionth, "1e-6"),
    BY_ROW("H-by-1e-9", by_a_billionth, "1e-9"),
    MISTAKE("H-by-float", nearest_hit, compared_as_floats, "t compared as floats",
            "a float has 7 digits, a double 16, and spheres may be close together.",
            "speckles where surfaces nearly touch"),
    FIRST_ROW(10),
    FIRST_ROW(16),
    FIRST_ROW(32),
    FIRST_ROW(64),
    FIRST_ROW(100),
    FIRST_ROW(128),
    FIRST_ROW(256),
    {0},
};
