// digits.c - where the slide's formulas lose their digits.
//
// The triangles have sides 3, 4, 5, so the right answers are short numbers, known without
// computing.
#include "chapters/05-quadratic/digits.h"

#include "common/answers.h"
#include "common/story.h"
#include "common/text.h"
#include "exercises/05-quadratic.h"

#include <stdio.h>

// Exact in binary, and its square has many digits that can be lost.
static const double fraction = 27.0 / 128;

static const char *near_root(Roots roots, Text *text)
{
    *text = number_text_to(roots.t[0], 15);
    return answers_missing() > 0 ? "not answered yet" : roots.count == 0 ? "missed" : text->s;
}

void digits_lost_in_the_world(void)
{
    story_heading("Moved away from the world's origin together: c is 75 everywhere");
    printf("  %-12s %-24s %s\n", "moved by", "c in object coordinates", "c in world coordinates");
    for (int power = 0; power <= 10; power += 2) {
        double far = pow(10, power);
        double x = far + fraction;
        Ray ray = {vec3_of(x - 10, x, 0), vec3_of(1, 0, 0)};
        Sphere sphere = {.center = vec3_of(x, x, 0), .radius = 5};
        Quadratic object = object_quadratic(to_object_coordinates(ray, sphere), sphere.radius);
        Quadratic world = world_quadratic(ray, sphere);
        printf("  %-12s %-24s %s\n", number_text(far).s, number_text_to(object.c, 12).s,
               number_text_to(world.c, 12).s);
    }
}

// The ray goes along (2, 3, 6), of length 7. At right angles to it is (6, 2, -3), also of length 7.
// The ray passes the centre of a sphere of radius 35 at a distance of 21, so it enters the sphere
// 28 before the closest point: 4 lengths of the direction.
void digits_lost_far_away(void)
{
    const vec3 along = vec3_of(2, 3, 6), across = vec3_of(6, 2, -3);
    story_heading("A sphere that is moved away from the eye: the near root");
    printf("  %-12s %-17s %-18s %s\n", "distance / r", "exactly", "from a, b, c", "sphere_roots");
    for (int power = 1; power <= 9; power += 2) {
        double far = pow(10, power), t = 5 * far + fraction;
        Ray ray = {vec3_of(0, 0, 0), along};
        Sphere sphere = {.center = t * along + 3 * across, .radius = 35};
        Quadratic q = object_quadratic(to_object_coordinates(ray, sphere), sphere.radius);
        Text slide, reference;
        printf("  %-12s %-17s %-18s %s\n", number_text(far).s, number_text_to(t - 4, 16).s,
               near_root(quadratic_roots(q), &slide),
               near_root(sphere_roots(ray, sphere), &reference));
    }
}
