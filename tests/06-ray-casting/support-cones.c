// support-cones.c - the outline of a sphere seen from the eye, without a quadratic: a cone.
#include "tests/06-ray-casting/support.h"

#include "exercises/04-pixel-ray.h"

static double cosine_between(vec3 v, vec3 w)
{
    return vec3_dot(v, w) / (vec3_length(v) * vec3_length(w));
}

// 1 if the direction from the eye meets the sphere, 0 if it does not, -1 if it passes too close to
// the silhouette to be sure. Seen from the eye a sphere of radius r, D away, is a cone whose half
// angle has the sine r / D.
static int sees(vec3 eye, vec3 direction, Sphere sphere)
{
    vec3 center = sphere.center - eye;
    double sine = sphere.radius / vec3_length(center);
    double inside = cosine_between(direction, center) - sqrt(1 - sine * sine);
    return fabs(inside) < TOLERANCE ? -1 : inside > 0;
}

// The distance of the sphere in that direction, by the law of cosines in the triangle of the eye,
// the hit and the centre.
static double distance_seen(vec3 eye, vec3 direction, Sphere sphere)
{
    vec3 center = sphere.center - eye;
    double away = vec3_length(center), cosine = cosine_between(direction, center);
    double aside = away * sqrt(fmax(0, 1 - cosine * cosine));
    return away * cosine - sqrt(sphere.radius * sphere.radius - aside * aside);
}

static void shuffle(int count, Sphere *spheres)
{
    for (int i = count - 1; i > 0; i--) {
        int other = (int)random_number(0, i + 1);
        Sphere kept = spheres[i];
        spheres[i] = spheres[other];
        spheres[other] = kept;
    }
}

void random_shells(Camera camera, Sphere *spheres)
{
    for (int i = 0; i < SHELLS; i++) {
        double across = random_number(-0.6, 0.6), upward = random_number(-0.6, 0.6);
        vec3 aside = across * camera.width * camera.right + upward * camera.height * camera.up;
        vec3 direction = vec3_unit(camera.distance * camera.forward + aside);
        spheres[i] = (Sphere){.center = camera.origin + 3 * (i + 1) * direction,
                              .radius = random_number(0.2, 1),
                              .surface = RED + i % (COLORS - RED)};
    }
    shuffle(SHELLS, spheres);
}

int shell_seen(vec3 eye, vec3 direction, int count, const Sphere *spheres)
{
    int nearest = -1;
    double best = INFINITY;
    for (int i = 0; i < count; i++) {
        int seen = sees(eye, direction, spheres[i]);
        if (seen < 0)
            return -2;
        double away = vec3_length(spheres[i].center - eye);
        if (seen == 1 && away < best) {
            best = away;
            nearest = i;
        }
    }
    return nearest;
}

Camera shells_behind(Resolution size, Pixel pixel, Sphere *spheres)
{
    Camera camera = random_camera();
    random_shells(camera, spheres);
    vec3 direction = vec3_unit(pixel_ray(camera, size, pixel).direction);
    for (int i = 0; i < SHELLS; i++)
        if (vec3_length(spheres[i].center - camera.origin) < 4)
            spheres[i].center = camera.origin + 3 * direction;
    return camera;
}

// The sphere that each pixel shows, or -1, by cones; false if one is doubtful.
static bool sees_shells(Camera camera, Resolution size, const Sphere *spheres, int *seen)
{
    for (int i = 0; i < size.width * size.height; i++) {
        Pixel pixel = {i % size.width, i / size.width};
        vec3 direction = pixel_ray(camera, size, pixel).direction;
        seen[i] = shell_seen(camera.origin, direction, SHELLS, spheres);
        if (seen[i] == -2)
            return false;
    }
    return true;
}

double t_seen(Ray ray, const Sphere *spheres, int seen)
{
    return seen < 0 ? NO_HIT
                    : distance_seen(ray.origin, ray.direction, spheres[seen]) /
                          vec3_length(ray.direction);
}

void expect_picture_of_shells(Cast *cast, Camera camera, Resolution size, Sphere *spheres)
{
    int seen[MOST_PIXELS];
    char picture[MOST_PIXELS + 1] = "";
    Scene scene = scene_of(SHELLS, spheres);
    if (!sees_shells(camera, size, spheres, seen))
        return;
    for (int i = 0; i < size.width * size.height; i++)
        picture[i] = seen[i] < 0 ? '.' : letter_of(spheres[seen[i]].surface);
    expect_picture(cast, &scene, camera, size, picture);
}

void expect_depths_of_shells(Camera camera, Resolution size, Sphere *spheres)
{
    int seen[MOST_PIXELS];
    double expected[MOST_PIXELS];
    Scene scene = scene_of(SHELLS, spheres);
    if (!sees_shells(camera, size, spheres, seen))
        return;
    for (int i = 0; i < size.width * size.height; i++) {
        Ray ray = pixel_ray(camera, size, (Pixel){i % size.width, i / size.width});
        expected[i] = t_seen(ray, spheres, seen[i]);
    }
    expect_depths(&scene, camera, size, expected);
}
