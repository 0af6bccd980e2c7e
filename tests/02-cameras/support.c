// support.c - cameras for the tests of exercise 02, and what every answer must do with them.
#include "tests/02-cameras/support.h"

Camera oblique_camera(void)
{
    return (Camera){.origin = vec3_of(3, -5, 7),
                    .right = vec3_of(2, -2, 1) / 3,
                    .up = vec3_of(2, 1, -2) / 3,
                    .forward = vec3_of(1, 2, 2) / 3,
                    .distance = 6,
                    .width = 9,
                    .height = 3};
}

Camera mirrored(Camera c)
{
    c.right = -c.right;
    return c;
}

Camera untouched(void)
{
    return (Camera){.origin = vec3_of(11, 12, 13),
                    .right = vec3_of(14, 15, 16),
                    .up = vec3_of(17, 18, 19),
                    .forward = vec3_of(20, 21, 22),
                    .distance = 23,
                    .width = 24,
                    .height = 25};
}

void expect_found(CameraFault fault, Camera found, Camera expected)
{
    expect_found_of_size(fault, found, expected, 1);
}

void expect_found_of_size(CameraFault fault, Camera found, Camera expected, double size)
{
    if (fault != CAMERA_OK)
        expect_fault(fault, CAMERA_OK);
    expect_camera_of_size(found, expected, TOLERANCE, size);
}

Camera camera_number(int i)
{
    return i < 5 ? camera_of_the_deck() : random_camera();
}

Camera camera_of_any_size(int i, int count, double *size)
{
    Camera c = random_camera();
    *size = pow(random_scale(i, count), 1.5);
    c.origin *= *size;
    c.distance *= *size;
    c.width *= *size;
    c.height *= *size;
    return c;
}

Normalized random_place(void)
{
    double s = floor(random_number(0, 21)) / 20;
    return (Normalized){s, floor(random_number(0, 21)) / 20};
}

void expect_same_ray_through(Normalized place, CameraFault fault, Camera yours, Camera same)
{
    if (fault != CAMERA_OK)
        expect_fault(fault, CAMERA_OK);
    given("seen", "the ray through (s, t) = %s", pair_text(place.s, place.t).s);
    Ray ray = {yours.origin, image_plane_vector(yours, place.s, place.t)};
    Ray expected = {same.origin, vec3_unit(image_plane_vector(same, place.s, place.t))};
    expect_same_ray(ray, expected, 1e-12);
}

CameraFault first_of(int reasons)
{
    int fault = CAMERA_OK;
    while ((reasons >> fault & 1) == 0)
        fault++;
    return (CameraFault)fault;
}

void expect_refused(CameraFault fault, Camera after, int reasons, int also)
{
    bool is_reason =
        fault > CAMERA_OK && fault < CAMERA_FAULTS && ((reasons | also) >> fault & 1) == 1;
    if (!is_reason)
        expect_fault(fault, first_of(reasons));
    given("refused", "and *camera stays as it was");
    expect_camera(after, untouched(), 0);
}

double not_finite(int i)
{
    static const double values[] = {NAN, INFINITY, -INFINITY};
    return values[i % 3];
}
