#include "exercises/01-corners.h"

vec3 image_plane_vector(Camera c, double s, double t)
{
    vec3 middle = c.distance * c.forward;
    double x = s * c.width - c.width / 2;
    double y = t * c.height - c.height / 2;
    return middle + x * c.right + y * c.up;
}

vec3 upper_left(Camera c) { return image_plane_vector(c, 0, 1); }
vec3 upper_right(Camera c) { return image_plane_vector(c, 1, 1); }
vec3 across_30_up_10(Camera c) { return image_plane_vector(c, .3, .1); }

/* halving all three does not change the picture, so halve until d is 1 */
Camera with_unit_distance(Camera c)
{
    while (c.distance != 1) {
        c.distance /= 2;
        c.width /= 2;
        c.height /= 2;
    }
    return c;
}
