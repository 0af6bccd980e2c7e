// mistakes-scene.c - wrong answers to off_surface. In formulas c, r is the sphere, p the point, n
// the normal, s the size, e a step of 2^-30.
#include "tests/07-shading/mistakes-scene.h"

static const double step = 0x1p-30;

static double largest(vec3 v)
{
    return fmax(fabs(v[0]), fmax(fabs(v[1]), fabs(v[2])));
}

static double size_of(Sphere sphere)
{
    return sphere.radius + largest(sphere.center);
}

// ---- to the wrong side --------------------------------------------------------------------------

static vec3 not_at_all(Sphere sphere, vec3 point, vec3 normal)
{
    (void)sphere, (void)normal;
    return point;
}

static vec3 to_the_other_side(Sphere sphere, vec3 point, vec3 normal)
{
    return point - step * size_of(sphere) * normal;
}

static vec3 always_outward(Sphere sphere, vec3 point, vec3 normal)
{
    (void)normal;
    return point + step * size_of(sphere) * vec3_unit(point - sphere.center);
}

static vec3 always_inward(Sphere sphere, vec3 point, vec3 normal)
{
    (void)normal;
    return point - step * size_of(sphere) * vec3_unit(point - sphere.center);
}

static vec3 in_every_coordinate(Sphere sphere, vec3 point, vec3 normal)
{
    (void)normal;
    return point + step * size_of(sphere);
}

static vec3 from_the_centre(Sphere sphere, vec3 point, vec3 normal)
{
    (void)point;
    return sphere.center + (sphere.radius + step * size_of(sphere)) * normal;
}

static vec3 only_the_step(Sphere sphere, vec3 point, vec3 normal)
{
    (void)point;
    return step * size_of(sphere) * normal;
}

// ---- by the wrong amount ------------------------------------------------------------------------

static vec3 by_the_radius(Sphere sphere, vec3 point, vec3 normal)
{
    return point + step * sphere.radius * normal;
}

static vec3 by_the_centre(Sphere sphere, vec3 point, vec3 normal)
{
    return point + step * largest(sphere.center) * normal;
}

static vec3 by_the_point(Sphere sphere, vec3 point, vec3 normal)
{
    (void)sphere;
    return point + step * largest(point) * normal;
}

static vec3 by_the_first_coordinate(Sphere sphere, vec3 point, vec3 normal)
{
    return point + step * (sphere.radius + fabs(sphere.center[0])) * normal;
}

static vec3 by_signed_coordinates(Sphere sphere, vec3 point, vec3 normal)
{
    vec3 c = sphere.center;
    return point + step * (sphere.radius + fmax(c[0], fmax(c[1], c[2]))) * normal;
}

static vec3 by_the_sum_with_signs(Sphere sphere, vec3 point, vec3 normal)
{
    vec3 c = sphere.center;
    return point + step * (sphere.radius + c[0] + c[1] + c[2]) * normal;
}

static vec3 by_the_square_of_the_size(Sphere sphere, vec3 point, vec3 normal)
{
    return point + step * size_of(sphere) * size_of(sphere) * normal;
}

#define RELATIVE(name, epsilon)                                                                    \
    static vec3 name(Sphere sphere, vec3 point, vec3 normal)                                       \
    {                                                                                              \
        return point + (epsilon)*size_of(sphere) * normal;                                         \
    }

RELATIVE(a_thousandth_of_the_size, 1e-3)
RELATIVE(a_hundred_thousandth_of_the_size, 1e-5)
RELATIVE(a_millionth_of_the_size, 1e-6)
RELATIVE(a_float_epsilon_of_the_size, 0x1p-23)

const Mistake offset_mistakes[] = {
    MISTAKE("O-none", off_surface, not_at_all, "p",
            "rounding leaves p on either side of its surface. From the wrong side a ray hits the "
            "surface that it starts from.",
            "black speckles on all lit surfaces"),
    MISTAKE("O-other", off_surface, to_the_other_side, "p - e s n",
            "the point must go to the side of the normal; on the other side it is below its own "
            "surface.",
            "everything in its own shadow"),
    MISTAKE("O-outward", off_surface, always_outward, "p + e s (p - c) / |p - c|",
            "this is always outward. Seen from inside, the given normal points inward, and the "
            "point must go there.",
            "right outside; hollow spheres dark inside"),
    MISTAKE("O-inward", off_surface, always_inward, "p - e s (p - c) / |p - c|",
            "this is always inward. The normal gives the side; mostly it is outward.",
            "everything in its own shadow, except hollow spheres"),
    MISTAKE("O-plus", off_surface, in_every_coordinate, "p + e s",
            "adding a number to a vector adds it to each coordinate. Multiply the normal by it, "
            "and add that.",
            "speckles on half of every sphere"),
    MISTAKE("O-centre", off_surface, from_the_centre, "c + (r + e s) n",
            "if the normal points inward, this is a point on the opposite side of the sphere.",
            "right outside; hollow spheres dark inside"),
    MISTAKE("O-step", off_surface, only_the_step, "e s n",
            "this is only the step: start at p and add it.",
            "shadows and mirrors as if everything were at the origin of the world"),
    MISTAKE("O-radius", off_surface, by_the_radius, "p + e r n",
            "far from the origin of the world numbers are coarse, even on a small sphere: include "
            "the coordinates of the centre.",
            "speckles on small spheres that are far away from the origin"),
    MISTAKE("O-coordinate", off_surface, by_the_centre, "p + e max(|cx|, |cy|, |cz|) n",
            "near the origin of the world that is almost 0. Include the radius.",
            "speckles on spheres around the origin"),
    MISTAKE("O-point", off_surface, by_the_point, "p + e max(|px|, |py|, |pz|) n",
            "near the origin of the world that is almost 0, but p was computed from large numbers: "
            "radius and centre.",
            "speckles where a large sphere passes near the origin"),
    MISTAKE("O-x", off_surface, by_the_first_coordinate, "p + e (r + |cx|) n",
            "the largest of the three coordinates counts, x, y or z.",
            "speckles on spheres that are far up or far ahead"),
    MISTAKE("O-sign", off_surface, by_signed_coordinates, "p + e (r + max(cx, cy, cz)) n",
            "-1000 is as large and as coarse as 1000: use absolute values.",
            "speckles on spheres with negative coordinates"),
    MISTAKE("O-sum", off_surface, by_the_sum_with_signs, "p + e (r + cx + cy + cz) n",
            "negative coordinates cancel the others. The largest absolute value counts.",
            "speckles here and there, depending on where a sphere is"),
    MISTAKE("O-square", off_surface, by_the_square_of_the_size, "p + e s^2 n",
            "in a scene of twice the size, the step must be twice as long, not four times.",
            "speckles in small scenes; in large ones shadows that start too late"),
    MISTAKE("O-1e-3s", off_surface, a_thousandth_of_the_size, "p + 1e-3 s n",
            "this step is so long that it jumps over objects close to the surface.",
            "light under objects on a surface"),
    MISTAKE("O-1e-5s", off_surface, a_hundred_thousandth_of_the_size, "p + 1e-5 s n",
            "doubles have 16 digits: a smaller step is enough, and objects close to the surface "
            "still cast their shadows.",
            "light under small objects on a surface"),
    MISTAKE("O-1e-6s", off_surface, a_millionth_of_the_size, "p + 1e-6 s n",
            "doubles have 16 digits: 1e-9 is enough, and objects close to the surface still cast "
            "their shadows.",
            "hardly anything; an edge of light under very small objects"),
    MISTAKE("O-float", off_surface, a_float_epsilon_of_the_size, "p + 2^-23 s n",
            "this is the precision of a float. A double is much finer.",
            "hardly anything; an edge of light under very small objects"),
    {0},
};

// ---- fixed steps --------------------------------------------------------------------------------

#define FIXED(name, epsilon)                                                                       \
    static vec3 name(Sphere sphere, vec3 point, vec3 normal)                                       \
    {                                                                                              \
        (void)sphere;                                                                              \
        return point + (epsilon)*normal;                                                           \
    }

FIXED(fixed_1, 1)
FIXED(fixed_1e_1, 1e-1)
FIXED(fixed_1e_2, 1e-2)
FIXED(fixed_1e_3, 1e-3)
FIXED(fixed_1e_4, 1e-4)
FIXED(fixed_1e_5, 1e-5)
FIXED(fixed_1e_6, 1e-6)
FIXED(fixed_1e_7, 1e-7)
FIXED(fixed_1e_8, 1e-8)
FIXED(fixed_1e_9, 1e-9)

// The row of the table for such a step.
#define FIXED_ROW(digits, answer)                                                                  \
    MISTAKE("O-" digits, off_surface, answer, "p + " digits " n",                                  \
            digits " is huge in a scene of the size of an atom and nothing in one of the size of " \
                   "a galaxy. Let it grow with the numbers.",                                      \
            "right in scenes of one size, speckles or lost shadows in others")

const Mistake fixed_offset_mistakes[] = {
    MISTAKE("O-1", off_surface, fixed_1, "p + n",
            "the normal has length 1, and that may be more than the whole sphere: only a tiny part "
            "of it is needed.",
            "shadows and mirrors that belong to some other place"),
    FIXED_ROW("0.1", fixed_1e_1),
    FIXED_ROW("0.01", fixed_1e_2),
    FIXED_ROW("0.001", fixed_1e_3),
    FIXED_ROW("1e-4", fixed_1e_4),
    FIXED_ROW("1e-5", fixed_1e_5),
    FIXED_ROW("1e-6", fixed_1e_6),
    FIXED_ROW("1e-7", fixed_1e_7),
    FIXED_ROW("1e-8", fixed_1e_8),
    FIXED_ROW("1e-9", fixed_1e_9),
    {0},
};
