// needed_answers.c - the answers that a picture needs.
#include "chapters/shared/needed_answers.h"

#include "chapters/shared/example.h"
#include "common/answers.h"
#include "exercises/01-corners.h"
#include "exercises/02-cameras.h"
#include "exercises/03-screen.h"
#include "exercises/04-pixel-ray.h"
#include "exercises/05-quadratic.h"
#include "exercises/06-ray-casting.h"

static void call_the_rest(Ray ray, Sphere ball)
{
    const Resolution one = {1, 1};
    screen_to_normalized(pixel_center((Pixel){0, 0}), one);
    image_plane_vector(example_camera(), 0.5, 0.5);
    quadratic_roots(object_quadratic(to_object_coordinates(ray, ball), ball.radius));
    hit_sphere(ray, ball);
}

bool picture_needs_are_met(Order order)
{
    Camera camera = example_camera();
    Surface white = {.color = vec3_of(1, 1, 1)};
    Sphere ball = {.center = vec3_of(2, 2, 0), .radius = 1};
    Scene scene = {.spheres = &ball, .sphere_count = 1, .surfaces = &white, .surface_count = 1};
    LookAt view = {camera.origin, ball.center, camera.up, width_from_angle(90, 4), 1};
    camera_from_look_at(view, LEFT_HANDED, &camera);

    unsigned char rgb[3] = {0};
    double depth[1];
    Image image = {.size = {1, 1}, .rgb = rgb};
    Ray ray = pixel_ray(camera, image.size, (Pixel){0, 0});
    nearest_hit(ray, &scene);
    if (order == IMAGE_ORDER)
        cast_image_order(&scene, camera, &image);
    else
        cast_object_order(&scene, camera, &image, depth);
    if (answers_missing() > 0)
        call_the_rest(ray, ball);
    return answers_report() == 0;
}
