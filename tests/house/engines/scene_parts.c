// scene_parts.c - what scenes are made of: numbers, places, spheres and a camera.
#include "tests/house/engines/scene_parts.h"

#include "exercises/04-pixel-ray.h"

static Sphere spheres[MOST];
static Surface surfaces[MOST];
Made *now;
Frame frame_now;
const vec3 above = {0.1, 1, 0.2}, middle = {0, 0, 0}, front = {0, 0, 5};

unsigned long long state;

void made_begin(Made *made, unsigned long long seed)
{
    now = made;
    frame_now = FRAME_USUAL;
    state = seed;
    made->name[0] = '\0';
    for (int i = 0; i < 8; i++)
        uniform(0, 1);
}

double uniform(double low, double high)
{
    state = state * 6364136223846793005ULL + 1442695040888963407ULL;
    return low + (high - low) * (double)(state >> 11) * 0x1p-53;
}

double power_of_ten(double low, double high)
{
    return pow(10, uniform(low, high));
}

bool once_in(double times)
{
    return uniform(0, times) < 1;
}

vec3 within(double most)
{
    double x = uniform(-most, most), y = uniform(-most, most), z = uniform(-most, most);
    return vec3_of(x, y, z);
}

vec3 direction(void)
{
    return vec3_unit(within(1) + vec3_of(1e-9, 0, 0));
}

Color color_number(int i)
{
    unsigned bits = (unsigned)(i + 1) * 0x9e3779b1U;
    return vec3_of(bits >> 24 & 255, bits >> 16 & 255, bits >> 8 & 255) / 255;
}

void add(vec3 center, double radius)
{
    int i = now->scene.sphere_count;
    if (i == MOST)
        return;
    surfaces[i].color = color_number(i);
    spheres[i] = (Sphere){center, radius, i};
    now->scene.sphere_count = now->scene.surface_count = i + 1;
}

void look(vec3 from, vec3 at, vec3 roughly_up, double angle, int width, int height)
{
    vec3 forward = vec3_unit(at - from), right = vec3_unit(vec3_cross(forward, roughly_up));
    double distance = vec3_length(at - from), wide = 2 * distance * tan(angle * PI / 360);
    Camera camera = {from,     right, vec3_cross(right, forward), forward,
                     distance, wide,  wide * height / width};
    if (frame_now == FRAME_MIRRORED)
        camera.right = -right;
    if (frame_now == FRAME_STRETCHED) {
        camera.distance *= 0.01;
        camera.width *= 0.01;
        camera.height *= 0.027;
    }
    if (frame_now == FRAME_LEANING) {
        camera.right = (1 + 5e-10) * right + 5e-10 * forward;
        camera.up = (1 - 5e-10) * camera.up + 5e-10 * right;
    }
    now->camera = camera;
    now->size = (Resolution){width, height};
    now->scene = (Scene){.spheres = spheres, .surfaces = surfaces};
}

void look_from(vec3 from, double angle, int width, int height)
{
    look(from, middle, above, angle, width, height);
}

static Ray ray_of_a_pixel(void)
{
    int column = (int)uniform(0, now->size.width), row = (int)uniform(0, now->size.height);
    return pixel_ray(now->camera, now->size, (Pixel){column, row});
}

void add_tangent(double radius, double away)
{
    Ray ray = ray_of_a_pixel();
    // As often as not where its outline is farthest left or right, above or below.
    vec3 across = once_in(2) ? direction() : once_in(2) ? now->camera.up : now->camera.right;
    vec3 ahead = vec3_unit(ray.direction), aside = vec3_unit(vec3_cross(ahead, across));
    add(ray.origin + away * ahead + (once_in(2) ? radius : -radius) * aside, radius);
}

void add_meeting(double radius, double times, double away)
{
    Ray ray = ray_of_a_pixel();
    vec3 ahead = vec3_unit(ray.direction);
    for (int i = 0; i < 2; i++, radius *= times) {
        // From head on to hardly at all.
        vec3 aside = vec3_unit(vec3_cross(ahead, direction()));
        double angle = PI / 2 * (1 - power_of_ten(-4, 0));
        add(ray.origin + away * ahead + radius * (cos(angle) * ahead + sin(angle) * aside), radius);
    }
}
