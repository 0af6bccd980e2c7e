// difficult_scenes.c - scenes that are made to be difficult.
#include "tests/house/engines/scene_parts.h"

#include "exercises/04-pixel-ray.h"

#include <stdio.h>

static void nothing(void)
{
    look_from(front, 60, 40, 30);
}
static void around_the_eye(void)
{
    look_from(front, 60, 40, 30);
    add(front, 1);
    add(middle, 1);
    add(front, 30);
    add(front + vec3_of(0.1, 0.2, -0.1), 0.5);
}
static void touching_the_eye(void)
{
    look_from(front, 90, 40, 30);
    add(vec3_of(0, 0, 4), 1);
    add(vec3_of(1, 0, 5), 1);
    add(vec3_of(0, -2, 5), 2);
    add(vec3_of(0, 0, 6), 1);
    add(middle, 1);
}
static void nearly_touching_the_eye(void)
{
    look_from(front, 90, 40, 30);
    for (int i = -14; i <= -3; i++) {
        vec3 there = front + direction();
        add(there, 1 + pow(10, i));
        add(there, 1 - pow(10, i));
    }
    add(middle, 1);
}
static void beside_and_behind(void)
{
    look_from(front, 120, 40, 30);
    add(vec3_of(3, 0, 5), 2.5);
    add(vec3_of(-3, 0, 5.5), 2.9);
    add(vec3_of(0, 0, 9), 3.9);
    add(vec3_of(0, 4, 4), 3);
}
static void behind(void)
{
    look_from(front, 170, 40, 30);
    for (int i = 0; i < 50; i++)
        add(front + within(3) + vec3_of(0, 0, 4), uniform(0.1, 2));
}
static void tangent_to_rays(void)
{
    // Which also puts them beyond each edge and corner of the screen.
    look_from(front, 60, 37, 31);
    for (int i = 0; i < 60; i++)
        add_tangent(power_of_ten(-2, 1), uniform(1, 9));
}
static void coincident(void)
{
    look_from(front, 60, 40, 30);
    for (int i = 0; i < 8; i++)
        add(middle, 1);
    for (int i = 0; i < 8; i++)
        add(vec3_of(1, 1, 0), 0.5 + 1e-9 * i);
    for (int i = 0; i < 8; i++)
        add(vec3_of(-1, -1, 1e-12 * i), 0.5);
}
static void the_same_far_and_near(void)
{
    // Of the same outline, one behind the other: nearer ones come later.
    look_from(front, 60, 40, 30);
    for (int i = 20; i > 0; i--)
        add(front + vec3_of(0.1 * i, 0.05 * i, -i), 0.3 * i);
}
static void close_behind_one_another(void)
{
    // Many fronts within the precision of a float.
    look_from(front, 40, 40, 30);
    for (int i = 0; i < 60; i++)
        add(vec3_of(0, 0, 1e-7 * uniform(-3, 3)) + 0.01 * within(1), 1);
    for (int i = 0; i < 60; i++)
        add(front + vec3_of(0, 0, -1e3 - uniform(0, 1e-4)), 300);
}
static void hardly_before_a_wall(void)
{
    look(front, middle, vec3_of(0, 1, 0), 4, 40, 30);
    add(vec3_of(0, 0, -1e3), 1e3);
    for (int i = 0; i < 60; i++)
        add(vec3_of(uniform(-0.16, 0.16), uniform(-0.12, 0.12), -0.019), 0.02);
}
static void outlines_through_pixel_centres(void)
{
    look(vec3_of(0, 0, 8), middle, vec3_of(0, 1, 0), 90, 32, 32);
    for (int i = 0; i < 16; i++)
        add(vec3_of((i + 0.5) / 2, 0, 0), 0.25);
    add(vec3_of(-2, -2, 0), 2);
    add(vec3_of(-2, 2, 1), 1);
}
static void of_one_pixel_where_tiles_meet(void)
{
    static const int places[] = {0, 3, 4, 7, 15, 16, 31, 32, 39};
    enum { PLACES = sizeof places / sizeof places[0] };
    look_from(front, 60, 40, 40);
    for (int i = 0; i < PLACES * PLACES; i++) {
        Pixel pixel = {places[i % PLACES], places[i / PLACES]};
        Ray ray = pixel_ray(now->camera, now->size, pixel);
        add(ray.origin + uniform(1, 2) * ray.direction, 0.01);
    }
}
static void meeting_on_rays(void)
{
    look_from(front, 60, 64, 48);
    for (int i = 0; i < 60; i++)
        add_meeting(0.05, uniform(1, 4), uniform(4, 6));
}
static void meeting_far_away(void)
{
    look_from(1e3 * front, 0.046, 64, 48);
    for (int i = 0; i < 60; i++)
        add_meeting(0.05, uniform(1, 4), 5e3 + uniform(-1, 1));
}
static void touching_at_their_outlines(void)
{
    // All touch one ray in one place, and go different ways from there.
    look_from(front, 40, 40, 30);
    Ray ray = pixel_ray(now->camera, now->size, (Pixel){20, 15});
    vec3 place = ray.origin + 0.8 * ray.direction;
    vec3 ahead = vec3_unit(ray.direction), aside = vec3_unit(vec3_cross(ahead, above));
    for (int i = 0; i < 30; i++)
        add(place + 0.1 * (i + 1) * aside + 1e-7 * direction(), 0.1 * (i + 1));
}
static void tangent_to_one_another(void)
{
    look(vec3_of(0, 0, 8), middle, vec3_of(0, 1, 0), 60, 45, 45);
    for (int i = -3; i <= 3; i++)
        for (int k = -3; k <= 3; k++)
            add(vec3_of(i, k, (i + k) % 2), i % 2 == 0 ? 0.5 : 0.75);
}
static void tiny(void)
{
    look_from(front, 60, 40, 30);
    for (int i = 0; i < 300; i++)
        add(within(2), power_of_ten(-8, -1));
    add(vec3_of(0, 0, 4.999), 1e-6);
}
static void huge(void)
{
    look_from(front, 60, 40, 30);
    add(vec3_of(0, 0, -1e6), 9e5);
    add(vec3_of(0, -1e9, 0), 1e9 - 2);
    add(vec3_of(0, -1e9, 0), 1e9 - 2.00001);
    add(vec3_of(-1e9, 0, 0), 1e9 - 1);
    add(vec3_of(0, 1e6, 0), 1e6 - 3);
    add(vec3_of(0, 0, -1e12), 1e10);
    for (int i = 0; i < 20; i++)
        add(vec3_of(uniform(-2, 2), -2 + uniform(0, 0.1), uniform(-2, 2)), 0.1);
}
static void of_another_size(void)
{
    look_from(1e-6 * front, 60, 40, 30);
    for (int i = 0; i < 50; i++)
        add(within(2e-6), 3e-7);
}
static void of_no_ordinary_size(void)
{
    look_from(1e16 * front, 60, 40, 30);
    for (int i = 0; i < 20; i++)
        add(within(2e16), 3e15);
    add(1e16 * front, 1e-14);
}
static void far_from_the_origin(void)
{
    vec3 there = vec3_of(1e7, -3e7, 2e7);
    look(there + front, there, above, 60, 40, 30);
    for (int i = 0; i < 50; i++)
        add(there + within(2), 0.4);
}
static void through_a_telescope(void)
{
    look_from(1e6 * front, 1e-5, 40, 30);
    for (int i = 0; i < 100; i++)
        add(vec3_of(uniform(-0.5, 0.5), uniform(-0.4, 0.4), uniform(-1e3, 1e3)), 0.1);
}
static void nearly_all_around(void)
{
    look_from(front, 179.9, 40, 30);
    for (int i = 0; i < 100; i++)
        add(front + uniform(1, 5) * direction(), 0.3);
}
static void in_one_another(void)
{
    look_from(front, 60, 61, 47);
    for (int i = 0; i < 40; i++)
        add(within(1), 1);
}

static const struct {
    const char *name;
    void (*make)(void);
} difficult[] = {{"nothing", nothing},
                 {"around the eye", around_the_eye},
                 {"touching the eye", touching_the_eye},
                 {"nearly touching the eye", nearly_touching_the_eye},
                 {"beside and behind the eye", beside_and_behind},
                 {"behind the eye", behind},
                 {"tangent to rays", tangent_to_rays},
                 {"coincident", coincident},
                 {"the same, far and near", the_same_far_and_near},
                 {"close behind one another", close_behind_one_another},
                 {"hardly before a wall", hardly_before_a_wall},
                 {"outlines through pixel centres", outlines_through_pixel_centres},
                 {"of one pixel, where tiles meet", of_one_pixel_where_tiles_meet},
                 {"meeting on rays", meeting_on_rays},
                 {"meeting far away", meeting_far_away},
                 {"touching at their outlines", touching_at_their_outlines},
                 {"tangent to one another", tangent_to_one_another},
                 {"tiny", tiny},
                 {"huge", huge},
                 {"of another size", of_another_size},
                 {"of no ordinary size", of_no_ordinary_size},
                 {"far from the origin", far_from_the_origin},
                 {"through a telescope", through_a_telescope},
                 {"nearly all around", nearly_all_around},
                 {"in one another", in_one_another}};

bool made_difficult(Made *made, int number, Frame frame)
{
    static const char *const frames[FRAMES] = {"", ", mirrored", ", stretched", ", leaning"};
    if (number >= (int)(sizeof difficult / sizeof difficult[0]))
        return false;
    now = made;
    frame_now = frame;
    state = (unsigned long long)number + 1;
    difficult[number].make();
    snprintf(made->name, sizeof made->name, "%s%s", difficult[number].name, frames[frame]);
    return true;
}
