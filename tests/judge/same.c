// same.c - do two answers agree?
#include "tests/judge/same.h"

#include <stdlib.h>
#include <string.h>

bool same_double(double a, double b)
{
    if (isnan(a) || isnan(b))
        return isnan(a) && isnan(b);
    return a == b || fabs(a - b) <= 1e-9 * (1 + fmin(fabs(a), fabs(b)));
}

bool same_vec3(vec3 a, vec3 b)
{
    return same_double(a[0], b[0]) && same_double(a[1], b[1]) && same_double(a[2], b[2]);
}

bool same_Camera(Camera a, Camera b)
{
    return same_vec3(a.origin, b.origin) && same_vec3(a.right, b.right) && same_vec3(a.up, b.up) &&
           same_vec3(a.forward, b.forward) && same_double(a.distance, b.distance) &&
           same_double(a.width, b.width) && same_double(a.height, b.height);
}

bool same_CameraFault(CameraFault a, CameraFault b)
{
    return a == b;
}

bool same_Normalized(Normalized a, Normalized b)
{
    return same_double(a.s, b.s) && same_double(a.t, b.t);
}

bool same_ScreenPoint(ScreenPoint a, ScreenPoint b)
{
    return same_double(a.x, b.x) && same_double(a.y, b.y);
}

bool same_Ray(Ray a, Ray b)
{
    return same_vec3(a.origin, b.origin) && same_vec3(a.direction, b.direction);
}

bool same_Quadratic(Quadratic a, Quadratic b)
{
    return same_double(a.a, b.a) && same_double(a.b, b.b) && same_double(a.c, b.c);
}

bool same_Roots(Roots a, Roots b)
{
    if (a.count != b.count)
        return false;
    for (int i = 0; i < a.count && i < 2; i++)
        if (!same_double(a.t[i], b.t[i]))
            return false;
    return true;
}

bool same_Hit(Hit a, Hit b)
{
    return a.sphere == b.sphere && same_double(a.t, b.t);
}

static size_t pixels_of(const Image *image)
{
    return (size_t)image->size.width * (size_t)image->size.height;
}

bool same_Image(const Image *a, const Image *b)
{
    return memcmp(a->rgb, b->rgb, 3 * pixels_of(a)) == 0;
}

bool same_doubles(const double *a, const double *b, const Image *image)
{
    for (size_t i = 0; i < pixels_of(image); i++)
        if (!same_double(a[i], b[i]))
            return false;
    return true;
}

static void *copy(const void *bytes, size_t size)
{
    void *other = malloc(size);
    if (other == NULL)
        abort();
    return memcpy(other, bytes, size);
}

Image image_copy(const Image *image)
{
    return (Image){.size = image->size, .rgb = copy(image->rgb, 3 * pixels_of(image))};
}

double *doubles_copy(const double *doubles, const Image *image)
{
    return copy(doubles, sizeof *doubles * pixels_of(image));
}
