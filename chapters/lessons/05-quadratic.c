// 05-quadratic.c - the numbers of lesson 05.
#include "exercises/05-quadratic.h"

#include "chapters/lessons/fill.h"
#include "chapters/shared/digits.h"
#include "chapters/shared/example.h"
#include "common/shown.h"

#include <math.h>
#include <string.h>

// The result if a is taken for 1, as if every direction had length 1.
static void fill_mistake(Ray ray, Sphere sphere, Quadratic q)
{
    double a = q.a;
    q.a = 1;
    Roots roots = quadratic_roots(q);
    if (fabs(a - 1) < 1e-6)
        fill_text("with_1", "for $a$, that makes no difference here: test with another ray.");
    else if (roots.count == 0)
        fill_text("with_1", "instead of %s, $D$ is %s, and the ray seems to miss.",
                  number_shown(a).s, number_shown(q.b * q.b - 4 * q.c).s);
    else {
        double t = roots.t[0];
        double away = vec3_length(ray.origin + t * ray.direction - sphere.center);
        int digits = SHOWN_DIGITS; // and more, if the point is almost on the sphere
        while (digits < 15 && strcmp(number_shown_to(away, digits).s,
                                     number_shown_to(sphere.radius, digits).s) == 0)
            digits++;
        fill_text(
            "with_1",
            "instead of %s, you get $t = %s$. That point is %s from the center: %s the sphere.",
            number_shown(a).s, number_shown(t).s, number_shown_to(away, digits).s,
            away < sphere.radius ? "inside" : "outside");
    }
}

// In the example there are two. In a page, a ray that is dragged may have one, or none.
static void fill_roots(Roots roots)
{
    const char *const names[] = {"t0", "t1", "before", "beyond"};
    for (int i = 0; i < 4; i++) {
        double t = roots.t[i % 2 < roots.count ? i % 2 : 0];
        if (roots.count == 0)
            fill_text(names[i], "none");
        else
            fill_number_to(names[i], i < 2 ? t : i == 2 ? floor(t) : ceil(t), root_digits(roots));
    }
}

static void fill_ray(Ray ray, Sphere sphere)
{
    fill_vector("p", ray.origin);
    fill_vector("v", ray.direction);
    fill_vector("center", sphere.center);
    fill_number("r", sphere.radius);
    fill_number("length", vec3_length(ray.direction));
}

void fill_numbers(void)
{
    Ray ray = example_ray();
    Sphere sphere = example_sphere();
    Quadratic q = object_quadratic(to_object_coordinates(ray, sphere), sphere.radius);
    Roots roots = quadratic_roots(q);
    fill_ray(ray, sphere);
    fill_number_to("a", q.a, coefficient_digits(q));
    fill_number_to("b", q.b, coefficient_digits(q));
    fill_number_to("c", q.c, coefficient_digits(q));
    fill_number("D", q.b * q.b - 4 * q.a * q.c);
    fill_roots(roots);
    fill_mistake(ray, sphere, q);
    fill_number("d", example_camera().distance);
    fill_number("tenth_d", 0.1 * example_camera().distance);
}
