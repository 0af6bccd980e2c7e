// waiting_marks.c - marks for functions that only wait for others: rings, placeholders, inverses, blanks.
// cases.py reads it: each section is one submission, and states the result that it must get.

// ---- circle-of-chapters: chapter 05 in a ring: roots from the sphere, the sphere from roots.
// stem: 05-quadratic
// expect: graded | crashed | timed out
// earns: nothing
#include "exercises/05-quadratic.h"

static int depth;

Quadratic object_quadratic(Ray ray, double radius)
{
    depth++;
    Quadratic q = depth < 4 ? world_quadratic(ray, (Sphere){.radius = radius}) : (Quadratic){0};
    depth--;
    return q;
}

Quadratic world_quadratic(Ray ray, Sphere sphere)
{
    depth++;
    Ray moved = {ray.origin - sphere.center, ray.direction};
    Quadratic q = depth < 4 ? object_quadratic(moved, sphere.radius) : (Quadratic){0};
    depth--;
    return q;
}

// ---- circle-of-three: the same with three; any two of them are right, once the third is.
// stem: 01-corners
// expect: graded
// earns: nothing
#include "exercises/01-corners.h"

static int depth;

vec3 upper_left(Camera c)
{
    vec3 v = depth++ < 3 ? image_plane_vector(c, 0, 1) : c.up;
    depth--;
    return v;
}

vec3 upper_right(Camera c)
{
    vec3 v = depth++ < 3 ? upper_left(c) + c.width * c.right : c.up;
    depth--;
    return v;
}

vec3 image_plane_vector(Camera c, double s, double t)
{
    vec3 v = depth++ < 3 ? upper_right(c) + (s - 1) * c.width * c.right + (t - 1) * c.height * c.up
                         : c.up;
    depth--;
    return v;
}

// ---- circle-of-two: each corner is made from the other; each is right, once the other is.
// stem: 01-corners
// expect: crashed | timed out
// earns: nothing
#include "exercises/01-corners.h"

vec3 upper_left(Camera c)
{
    return upper_right(c) - c.width * c.right;
}

vec3 upper_right(Camera c)
{
    return upper_left(c) + c.width * c.right;
}

// ---- circle-that-ends: the same, without a crash: the second time round it gives up.
// stem: 01-corners
// expect: graded
// earns: nothing
#include "exercises/01-corners.h"

static int depth;

vec3 upper_left(Camera c)
{
    vec3 v = depth++ < 2 ? upper_right(c) - c.width * c.right : c.up;
    depth--;
    return v;
}

vec3 upper_right(Camera c)
{
    vec3 v = depth++ < 2 ? upper_left(c) + c.width * c.right : c.up;
    depth--;
    return v;
}

// ---- wait-all-of-the-sphere: a chain of answers at whose end nothing stands.
// stem: 05-quadratic
// expect: graded
// earns: nothing
#include "exercises/05-quadratic.h"

Quadratic world_quadratic(Ray ray, Sphere sphere)
{
    return object_quadratic(to_object_coordinates(ray, sphere), sphere.radius);
}

Roots sphere_roots(Ray ray, Sphere sphere)
{
    return quadratic_roots(world_quadratic(ray, sphere));
}

double hit_sphere(Ray ray, Sphere sphere)
{
    Roots roots = sphere_roots(ray, sphere);
    for (int i = 0; i < roots.count; i++)
        if (roots.t[i] > 0)
            return roots.t[i];
    return NO_HIT;
}

// ---- wait-by-pointer: a blank is called through a pointer in a table, so that no call of it is to be
// seen.
// stem: 01-corners
// expect: graded
// earns: nothing
#include "exercises/01-corners.h"

static vec3 (*const others[])(Camera, double, double) = {image_plane_vector};

static vec3 ask(Camera c, double s, double t)
{
    return others[0](c, s, t);
}

vec3 upper_left(Camera c)
{
    return ask(c, 0, 1);
}

vec3 upper_right(Camera c)
{
    return ask(c, 1, 1);
}

// ---- wait-center-by-conversions: a pixel's centre from there and back again, both placeholders.
// stem: 03-screen
// expect: graded
// earns: nothing
#include "exercises/03-screen.h"

Normalized screen_to_normalized(ScreenPoint point, Resolution screen)
{
    return (Normalized){point.x, screen.height - point.y};
}

ScreenPoint normalized_to_screen(Normalized place, Resolution screen)
{
    return (ScreenPoint){place.s, place.t + screen.width};
}

ScreenPoint pixel_center(Pixel pixel)
{
    Resolution screen = {2, 2};
    ScreenPoint half = normalized_to_screen((Normalized){0.25, 0.75}, screen);
    return (ScreenPoint){pixel.column + half.x, pixel.row + half.y};
}

// ---- wait-equation-by-the-other: an equation by the other one, which is later and blank.
// stem: 05-quadratic
// expect: graded
// earns: nothing
#include "exercises/05-quadratic.h"

Quadratic object_quadratic(Ray object_ray, double radius)
{
    return world_quadratic(object_ray, (Sphere){.radius = radius});
}

// ---- wait-for-a-crash: the first answer crashes, the second is made of it.
// stem: 01-corners
// expect: crashed
// earns: nothing
#include "exercises/01-corners.h"

vec3 upper_left(Camera c)
{
    return *(volatile vec3 *)0 + c.up;
}

vec3 upper_right(Camera c)
{
    return upper_left(c) + c.width * c.right;
}

// ---- wait-for-a-loop: the first answer never ends, the second is made of it.
// stem: 01-corners
// expect: timed out
// earns: nothing
#include "exercises/01-corners.h"

vec3 upper_left(Camera c)
{
    for (volatile int i = 0;; i ^= 1)
        ;
    return c.up;
}

vec3 upper_right(Camera c)
{
    return upper_left(c) + c.width * c.right;
}

// ---- wait-for-a-part: the first answer is right for the deck's camera alone, the second is made of
// it.
// stem: 01-corners
// expect: graded
// earns: nothing
#include "exercises/01-corners.h"

vec3 upper_left(Camera c)
{
    return c.distance == 4 && c.width == 2 ? vec3_of(-1, 1, 4) : c.forward;
}

vec3 upper_right(Camera c)
{
    return upper_left(c) + c.width * c.right;
}

// ---- wait-for-a-placeholder: the first answer is any vector, and the others are made of it.
// stem: 01-corners
// expect: graded
// earns: nothing
#include "exercises/01-corners.h"

vec3 upper_left(Camera c)
{
    return c.up;
}

vec3 upper_right(Camera c)
{
    c.right = -c.right;
    return upper_left(c);
}

vec3 across_30_up_10(Camera c)
{
    return 0.7 * upper_left(c) + 0.3 * upper_right(c) - 0.9 * c.height * c.up;
}

vec3 image_plane_vector(Camera c, double s, double t)
{
    return (1 - s) * upper_left(c) + s * upper_right(c) - (1 - t) * c.height * c.up;
}

// ---- wait-for-blanks: every answer is made of one that is blank.
// stem: 01-corners
// expect: graded
// earns: nothing
#include "exercises/01-corners.h"

vec3 upper_left(Camera c)
{
    return image_plane_vector(c, 0, 1);
}

vec3 upper_right(Camera c)
{
    return image_plane_vector(c, 1, 1);
}

vec3 across_30_up_10(Camera c)
{
    return image_plane_vector(c, 0.3, 0.1);
}

// ---- wait-for-each-other: two placeholders that call each other, so that whichever is lent makes the
// other right.
// stem: 01-corners
// expect: graded
// earns: nothing
#include "exercises/01-corners.h"

static int depth;

vec3 upper_left(Camera c)
{
    depth++;
    vec3 v = depth < 3 ? upper_right(c) - c.width * c.right : c.up;
    depth--;
    return v;
}

vec3 upper_right(Camera c)
{
    depth++;
    vec3 v = depth < 3 ? upper_left(c) + c.width * c.right : c.forward;
    depth--;
    return v;
}

vec3 across_30_up_10(Camera c)
{
    return upper_left(c) + 0.3 * c.width * c.right - 0.9 * c.height * c.up;
}

// ---- wait-for-the-inverse: a conversion by its inverse, which is blank.
// stem: 03-screen
// expect: graded
// earns: nothing
#include "exercises/03-screen.h"

Normalized screen_to_normalized(ScreenPoint point, Resolution screen)
{
    ScreenPoint zero = normalized_to_screen((Normalized){0, 0}, screen);
    ScreenPoint one = normalized_to_screen((Normalized){1, 1}, screen);
    return (Normalized){(point.x - zero.x) / (one.x - zero.x),
                        (point.y - zero.y) / (one.y - zero.y)};
}

// ---- wait-for-the-inverse-of-nothing: a conversion by its inverse, which is earlier and a
// placeholder.
// stem: 03-screen
// expect: graded
// earns: nothing
#include "exercises/03-screen.h"

Normalized screen_to_normalized(ScreenPoint point, Resolution screen)
{
    return (Normalized){point.x + screen.width, point.y * screen.height};
}

ScreenPoint normalized_to_screen(Normalized place, Resolution screen)
{
    Normalized zero = screen_to_normalized((ScreenPoint){0, 0}, screen);
    Normalized one = screen_to_normalized((ScreenPoint){1, 1}, screen);
    return (ScreenPoint){(place.s - zero.s) / (one.s - zero.s),
                         (place.t - zero.t) / (one.t - zero.t)};
}

// ---- wait-image-by-object: one order by the other, which is later and blank.
// stem: 06-ray-casting
// expect: graded
// earns: nothing
#include "exercises/06-ray-casting.h"

void cast_image_order(const Scene *scene, Camera camera, Image *image)
{
    static double depth[1 << 20];
    cast_object_order(scene, camera, image, depth);
}

// ---- wait-nearest-by-a-picture: the nearest hit from a picture of one pixel, by a question that is
// later and blank.
// stem: 06-ray-casting
// expect: graded
// earns: nothing
#include "exercises/06-ray-casting.h"

Hit nearest_hit(Ray ray, const Scene *scene)
{
    vec3 forward = vec3_unit(ray.direction);
    vec3 side = vec3_unit(
        vec3_cross(forward, fabs(forward[0]) < 0.7 ? vec3_of(1, 0, 0) : vec3_of(0, 1, 0)));
    Camera camera = {.origin = ray.origin,
                     .right = side,
                     .up = vec3_cross(side, forward),
                     .forward = forward,
                     .distance = vec3_length(ray.direction),
                     .width = 1,
                     .height = 1};
    uint8_t rgb[3];
    double depth = NO_HIT;
    Image image = {{1, 1}, rgb};
    cast_object_order(scene, camera, &image, &depth);
    Hit hit = {depth, -1};
    for (int i = 0; i < scene->sphere_count && depth < NO_HIT; i++) {
        Scene one = *scene;
        double again = NO_HIT;
        one.spheres = &scene->spheres[i];
        one.sphere_count = 1;
        cast_object_order(&one, camera, &image, &again);
        if (again == depth && hit.sphere < 0)
            hit.sphere = i;
    }
    return hit;
}

// ---- wait-nearest-by-a-placeholder: the same, and the later question is no longer blank.
// stem: 06-ray-casting
// expect: graded
// earns: nothing
#include "exercises/06-ray-casting.h"

Hit nearest_hit(Ray ray, const Scene *scene)
{
    vec3 forward = vec3_unit(ray.direction);
    vec3 side = vec3_unit(
        vec3_cross(forward, fabs(forward[0]) < 0.7 ? vec3_of(1, 0, 0) : vec3_of(0, 1, 0)));
    Camera camera = {.origin = ray.origin,
                     .right = side,
                     .up = vec3_cross(side, forward),
                     .forward = forward,
                     .distance = vec3_length(ray.direction),
                     .width = 1,
                     .height = 1};
    uint8_t rgb[3];
    double depth = NO_HIT;
    Image image = {{1, 1}, rgb};
    cast_object_order(scene, camera, &image, &depth);
    Hit hit = {depth, -1};
    for (int i = 0; i < scene->sphere_count && depth < NO_HIT; i++) {
        Scene one = *scene;
        double again = NO_HIT;
        one.spheres = &scene->spheres[i];
        one.sphere_count = 1;
        cast_object_order(&one, camera, &image, &again);
        if (again == depth && hit.sphere < 0)
            hit.sphere = i;
    }
    return hit;
}

void cast_object_order(const Scene *scene, Camera camera, Image *image, double *depth)
{
    depth[0] = scene->sphere_count + camera.distance;
    image_set(image, (Pixel){0, 0}, scene->background);
}

// ---- wait-normal-by-step: a normal from where a ray starts that leaves the surface, which is later
// and blank.
// stem: 07-shading
// expect: graded
// earns: nothing
#include "exercises/07-shading.h"

vec3 surface_normal(Sphere sphere, vec3 point)
{
    vec3 step = off_surface(sphere, point, vec3_of(0, 0, 1)) - point;
    return vec3_unit(point - sphere.center + 0 * step);
}

// ---- wait-object-passes-on: passes its question on to an answer that is wrong in a known way, and
// only adds what that leaves out.
// stem: 06-ray-casting
// expect: graded
// earns: nearest_hit
#include "exercises/06-ray-casting.h"

#include "exercises/04-pixel-ray.h"
#include "exercises/05-quadratic.h"

Hit nearest_hit(Ray ray, const Scene *scene)
{
    Hit nearest = {NO_HIT, -1};
    for (int i = 0; i < scene->sphere_count; i++) {
        double t = hit_sphere(ray, scene->spheres[i]);
        if (t < nearest.t)
            nearest = (Hit){t, i};
    }
    return nearest;
}

void cast_image_order(const Scene *scene, Camera camera, Image *image)
{
    for (int row = 0; row < image->size.height; row++)
        for (int column = 0; column < image->size.width; column++) {
            Pixel pixel = {column, image->size.height - 1 - row};
            Hit hit = nearest_hit(pixel_ray(camera, image->size, pixel), scene);
            image_set(image, (Pixel){column, row},
                      hit.sphere < 0 ? scene->background : scene_surface(scene, hit.sphere)->color);
        }
}

void cast_object_order(const Scene *scene, Camera camera, Image *image, double *depth)
{
    cast_image_order(scene, camera, image);
    for (int i = 0; i < image->size.width * image->size.height; i++) {
        Pixel pixel = {i % image->size.width, i / image->size.width};
        depth[i] = nearest_hit(pixel_ray(camera, image->size, pixel), scene).t;
    }
}

// ---- wait-points-by-vectors: all forms by the first one, which is a placeholder.
// stem: 02-cameras
// expect: graded
// earns: nothing
#include "exercises/02-cameras.h"

CameraFault camera_from_vectors(vec3 eye, Corners vectors, Camera *camera)
{
    camera->origin = eye;
    camera->up = vectors.upper_left;
    return CAMERA_OK;
}

CameraFault camera_from_points(vec3 eye, Corners points, Camera *camera)
{
    points.upper_left -= eye;
    points.upper_right -= eye;
    points.lower_left -= eye;
    points.lower_right -= eye;
    return camera_from_vectors(eye, points, camera);
}

CameraFault camera_from_corner(vec3 eye, vec3 lower_left, vec3 across, vec3 up, Camera *camera)
{
    Corners c = {lower_left + up, lower_left + across + up, lower_left, lower_left + across};
    return camera_from_points(eye, c, camera);
}

// ---- wait-roots-by-a-sphere: roots of an equation by a sphere that has it, with the two questions
// after it blank.
// stem: 05-quadratic
// expect: graded
// earns: nothing
#include "exercises/05-quadratic.h"

Roots quadratic_roots(Quadratic q)
{
    vec3 v = vec3_of(sqrt(q.a), 0, 0), p = vec3_of(q.b / (2 * sqrt(q.a)), 0, 0);
    double r = sqrt(vec3_dot(p, p) - q.c);
    return sphere_roots((Ray){p, v}, (Sphere){.radius = r});
}

Ray to_object_coordinates(Ray ray, Sphere sphere)
{
    double t = hit_sphere(ray, sphere);
    ray.origin += 0 * t * ray.direction;
    return ray;
}

// ---- wait-shade-by-trace: light by what a mirror shows, which is later and a placeholder.
// stem: 07-shading
// expect: graded
// earns: nothing
#include "exercises/07-shading.h"

vec3 shade(const Scene *scene, Ray ray, Hit hit)
{
    (void)hit;
    return trace_ray(scene, ray, 0);
}

vec3 trace_ray(const Scene *scene, Ray ray, int depth)
{
    return scene->background + depth * ray.direction;
}

// ---- wait-terms-by-shade: the terms of light by the sum of all of them, which is later and blank.
// stem: 07-shading
// expect: graded
// earns: nothing
#include "exercises/07-shading.h"

static vec3 light_on(Surface surface, vec3 ambient, vec3 light, vec3 normal, vec3 to_light,
                     vec3 to_eye)
{
    Sphere sphere = {.center = -normal, .radius = 1};
    Light lamp = {.position = to_light, .color = light, .kind = LIGHT_DISTANT};
    Scene scene = {.ambient = ambient,
                   .spheres = &sphere,
                   .sphere_count = 1,
                   .surfaces = &surface,
                   .surface_count = 1,
                   .lights = &lamp,
                   .light_count = 1};
    return shade(&scene, (Ray){to_eye, -to_eye}, (Hit){1, 0});
}

vec3 ambient_term(vec3 surface, double kd, vec3 ambient)
{
    Surface all = {.color = surface, .diffuse = kd};
    return light_on(all, ambient, vec3_of(0, 0, 0), vec3_of(0, 0, 1), vec3_of(0, 0, 1),
                    vec3_of(0, 0, 1));
}

vec3 diffuse_term(vec3 surface, double kd, vec3 light, vec3 normal, vec3 to_light)
{
    Surface all = {.color = surface, .diffuse = kd};
    return light_on(all, vec3_of(0, 0, 0), light, normal, to_light, normal);
}

vec3 phong_term(double ks, double shine, vec3 light, vec3 normal, vec3 to_light, vec3 to_eye)
{
    Surface all = {.specular = ks, .shine = shine};
    return light_on(all, vec3_of(0, 0, 0), light, normal, to_light, to_eye);
}

// ---- wait-trace-by-shade: a mirror by light, which is a placeholder.
// stem: 07-shading
// expect: graded
// earns: nothing
#include "exercises/07-shading.h"

#include "exercises/06-ray-casting.h"

vec3 shade(const Scene *scene, Ray ray, Hit hit)
{
    return scene->ambient + hit.t * ray.direction;
}

vec3 trace_ray(const Scene *scene, Ray ray, int depth)
{
    Hit hit = nearest_hit(ray, scene);
    return hit.sphere < 0 || depth > 100 ? scene->background : shade(scene, ray, hit);
}

// ---- wait-vectors-by-points: the first of two forms by the second, which is a placeholder.
// stem: 02-cameras
// expect: graded
// earns: nothing
#include "exercises/02-cameras.h"

CameraFault camera_from_vectors(vec3 eye, Corners vectors, Camera *camera)
{
    vectors.upper_left += eye;
    vectors.upper_right += eye;
    vectors.lower_left += eye;
    vectors.lower_right += eye;
    return camera_from_points(eye, vectors, camera);
}

CameraFault camera_from_points(vec3 eye, Corners points, Camera *camera)
{
    camera->origin = points.upper_left;
    return CAMERA_OK;
}
