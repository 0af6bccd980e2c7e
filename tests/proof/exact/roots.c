// roots.c - the reference against exact arithmetic: a million random rays and spheres.
//
// Doubles are whole numbers times a power of two, so GMP computes the discriminant without any
// error. The claim: the reference never disagrees on whether the line meets the sphere, nor on
// whether the ray hits it, except if |l - r| <= k eps |o - c|. l is the distance of the line
// from the centre c, r the radius, o the ray's origin. Both roots are compared too.
#include "exercises/05-quadratic.h"

#include "tests/proof/exact/exact.h"

#include <float.h>
#include <stdio.h>
#include <unistd.h>

// Rounding moves l by at most 2.1 eps |o - c| to first order: 1/2 by o - c, 1/2 by what is taken
// from it to reach the foot of the perpendicular, 3/2 by the rest; and by 3.6 where l is next to 0.
static const double doubtful_k = 4;

// A root moves by d r / h where the centre moves by d; h is half the chord. So this is how far, in
// eps (|o - c| + r), the sphere would have to move to excuse the error of a root: the roundings of
// a, b and the two roots.
static const double most_error = 8;

enum { RAYS = 1000000 };

typedef struct {
    long rays, doubtful, disagreed, failed;
    double widest; // |l - r| / (eps |o - c|), of those that disagreed
    double error;  // of a root, in eps (|o - c| + r) r / h, outside the doubtful band
    double digits; // the same error relative to the root itself
} Found;

static bool roots_are_good(Case c, Roots roots, double hit, double half_chord, Found *found)
{
    exact_roots();
    double away = vec3_length(c.ray.origin - c.sphere.center), r = c.sphere.radius;
    double speed = vec3_length(c.ray.direction);
    double unit_of_error = DBL_EPSILON * (away + r) * r / half_chord / speed;
    double worst = 0;
    for (int i = 0; i < 2; i++) {
        double error = exact_root_error(roots.t[i], i);
        worst = fmax(worst, error / unit_of_error);
        found->digits = fmax(found->digits, error / fabs(exact_root(i)));
    }
    if (exact_hits())
        worst = fmax(worst, exact_root_error(hit, exact_root(0) > 0 ? 0 : 1) / unit_of_error);
    found->error = fmax(found->error, worst);
    return worst <= most_error;
}

static void show(const char *what, Case c)
{
    printf("not ok: %s: origin (%a, %a, %a), direction (%a, %a, %a), center (%a, %a, %a), "
           "radius %a\n",
           what, c.ray.origin[0], c.ray.origin[1], c.ray.origin[2], c.ray.direction[0],
           c.ray.direction[1], c.ray.direction[2], c.sphere.center[0], c.sphere.center[1],
           c.sphere.center[2], c.sphere.radius);
}

static void compare(Case c, Found *found)
{
    enum { MOST_SHOWN = 5 };
    exact_set(c);
    Roots roots = sphere_roots(c.ray, c.sphere);
    double hit = hit_sphere(c.ray, c.sphere);

    double r = c.sphere.radius, chord = exact_r_squared_less_l_squared();
    double l = sqrt(fmax(0, r * r - chord));
    double away = vec3_length(c.ray.origin - c.sphere.center);
    double off = fabs(chord) / (l + r) / (DBL_EPSILON * away); // |l - r| in eps |o - c|
    bool doubtful = off <= doubtful_k;
    bool agree = roots.count == (exact_meets() ? 2 : 0) && (hit < NO_HIT) == exact_hits();
    bool good = agree || doubtful;
    const char *what = "hit or miss";
    if (exact_meets() && !doubtful && agree) {
        good = roots_are_good(c, roots, hit, sqrt(chord), found);
        what = "the roots";
    }

    found->rays++;
    found->doubtful += doubtful;
    if (!agree) {
        found->disagreed++;
        found->widest = fmax(found->widest, off);
    }
    if (!good && found->failed++ < MOST_SHOWN)
        show(what, c);
}

static void print_found(const char *name, const Found *f)
{
    printf("%-15s %8ld %9ld %10ld %8.2f %12.2f %12.1e\n", name, f->rays, f->doubtful, f->disagreed,
           f->widest, f->error, f->digits);
}

int main(void)
{
    bool talks = isatty(STDERR_FILENO) == 1;
    Found all = {0};
    int failed_families = 0;
    exact_begin();
    printf("Doubtful where |l - r| <= %g eps |o - c|; roots within %g eps (|o - c| + r) r / h.\n\n",
           doubtful_k, most_error);
    printf("%-15s %8s %9s %10s %8s %12s %12s\n", "rays", "number", "doubtful", "disagreed",
           "widest", "root error", "relative");
    for (int family = 0; family < FAMILIES; family++) {
        Found found = {0};
        for (int i = 0; i < RAYS / FAMILIES; i++) {
            compare(families[family](), &found);
            if (talks && i % 4096 == 0)
                fprintf(stderr, "\r%d%% ", (int)((all.rays + i) * 100 / RAYS));
        }
        if (talks)
            fprintf(stderr, "\r     \r");
        print_found(family_names[family], &found);
        all.rays += found.rays;
        all.doubtful += found.doubtful;
        all.disagreed += found.disagreed;
        failed_families += found.failed > 0;
        all.widest = fmax(all.widest, found.widest);
        all.error = fmax(all.error, found.error);
        all.digits = fmax(all.digits, found.digits);
    }
    print_found("all", &all);
    printf("exact: %d passed, %d failed\n", FAMILIES - failed_families, failed_families);
    return failed_families == 0 ? 0 : 1;
}
