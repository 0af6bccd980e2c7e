// test_scenes.c - scenes for screens of all sizes, of many spheres, and random ones.
#include "tests/house/engines/scene_parts.h"

#include <stdio.h>
#include <stdlib.h>

enum { MOST_AT_RANDOM = 400 };

static void begin(Made *made, const char *name)
{
    now = made;
    frame_now = FRAME_USUAL;
    state = 1;
    snprintf(made->name, sizeof made->name, "%s", name);
}

void made_sized(Made *made, Resolution size)
{
    begin(made, "");
    snprintf(made->name, sizeof made->name, "%d x %d", size.width, size.height);
    look_from(front, 60, size.width, size.height);
    add(middle, 1);
    add(vec3_of(0, -1e5, 0), 1e5 - 1);
    for (int i = 0; i < 20; i++)
        add(within(2), uniform(0.05, 1));
}

void made_many(Made *made)
{
    begin(made, "many");
    look_from(front, 60, 29, 23);
    for (int i = 0; i < MOST; i++) {
        // Where threads may have their limits, spheres are in front of all others.
        int k = i / 1000;
        if (i % 1000 == 0)
            add(vec3_of(0.5 * (k % 4) - 1.2, 0.4 * (k / 4) - 0.6, 2.5), 0.1);
        else if (i % 1000 == 999)
            add(vec3_of(0.5 * (k % 4) - 0.95, 0.4 * (k / 4) - 0.6, 2.5), 0.1);
        else
            add(within(1), uniform(0.16, 0.3));
    }
}

void made_wide(Made *made)
{
    begin(made, "wide");
    look_from(front, 1, 1, 4096);
    made->camera.height = 0.5 * made->camera.distance;
    for (int i = 0; i < 4300; i++)
        add(within(1), uniform(2, 3));
}

void made_hidden(Made *made)
{
    begin(made, "hidden");
    look_from(front, 45, 160, 130);
    add(vec3_of(0.1, 0, 0), 1);
    add(vec3_of(-0.4, 0.3, 0.9), 0.6);
    while (made->scene.sphere_count < MOST)
        add(within(1.5), uniform(0.01, 0.05));
}

// ---- random ones ------------------------------------------------------------------------------

static void add_odd(vec3 at, double unit)
{
    const vec3 eye = now->camera.origin;
    const int count = now->scene.sphere_count;
    const Sphere earlier = now->scene.spheres[(int)uniform(0, count)]; // of none: not looked at
    double radius = unit * power_of_ten(-2, 0);
    vec3 aside = direction();
    switch (count == 0 ? 4 : (int)uniform(0, 10)) {
    case 0: // the same again; or nearly
        add(earlier.center, earlier.radius);
        break;
    case 1:
        add(earlier.center + 1e-9 * earlier.radius * aside,
            earlier.radius * (1 + power_of_ten(-16, -6)));
        break;
    case 2: // touches another
        add(earlier.center + (earlier.radius + radius) * aside, radius);
        break;
    case 3: // round the eye
        add(eye + uniform(0, 0.999) * radius * aside, radius);
        break;
    case 4: // near the eye
        add(eye + radius * aside, radius * uniform(0.5, 1));
        break;
    case 5: // touches the eye, or nearly
        add(eye + radius * aside,
            radius * (1 + (once_in(2) ? 0 : power_of_ten(-15, -2)) * (once_in(2) ? 1 : -1)));
        break;
    case 6: // tiny
        add(at, unit * power_of_ten(-9, -3));
        break;
    case 7: // huge
        radius = unit * power_of_ten(1, 9);
        add(at + radius * aside, radius);
        break;
    case 8: // met by a ray where another is
        add_meeting(radius, power_of_ten(0, 4), unit * power_of_ten(-1, 1));
        break;
    default: // touches a ray
        add_tangent(radius, unit * power_of_ten(-1, 1));
    }
}

void made_at_random(Made *made, unsigned number)
{
    begin(made, "");
    snprintf(made->name, sizeof made->name, "random scene %u", number);
    state = number * 7919ULL + 1;
    for (int i = 0; i < 8; i++)
        uniform(0, 1);
    frame_now = (Frame)uniform(0, FRAMES);
    const double unit = once_in(4) ? power_of_ten(-9, 9) : 1;
    const vec3 there = once_in(4) ? unit * within(power_of_ten(0, 6)) : middle;
    int width = (int)uniform(1, 90), height = (int)uniform(1, 70);
    if (once_in(8))
        *(once_in(2) ? &width : &height) = 1;
    double angle = once_in(8) ? power_of_ten(-2, 1) : uniform(10, 175);
    look(there + unit * within(3), there + unit * within(1), above, angle, width, height);
    const int count = (int)pow(MOST_AT_RANDOM, uniform(0, 1));
    const double size = power_of_ten(-2, 0), odd = once_in(2) ? 1e9 : once_in(2) ? 20 : 2;
    for (int i = 0; i < count; i++) {
        vec3 at = there + unit * within(2);
        if (once_in(odd))
            add_odd(at, unit);
        else
            add(at, unit * size * uniform(0.1, 1));
    }
}

// ---- very many --------------------------------------------------------------------------------

bool made_uniform(Made *made, int count, double larger)
{
    begin(made, "");
    snprintf(made->name, sizeof made->name, "%d spheres, %g times as large", count, larger);
    look(vec3_of(1.5, 1.2, 3), middle, vec3_of(0, 1, 0), 72.734, 1920, 1080);
    Sphere *many = malloc((size_t)count * sizeof *many);
    if (many == NULL)
        return false;
    Surface *surfaces = made->scene.surfaces;
    for (int i = 0; i < MOST; i++)
        surfaces[i].color = color_number(i);
    const double spacing = 2 / cbrt(count);
    for (int i = 0; i < count; i++) {
        vec3 center = within(1);
        many[i] = (Sphere){center, larger * spacing * uniform(0.2, 0.6), i % MOST};
    }
    made->scene.spheres = many;
    made->scene.sphere_count = count;
    made->scene.surface_count = MOST;
    return true;
}

void made_uniform_free(Made *made)
{
    free(made->scene.spheres);
}
