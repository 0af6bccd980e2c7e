// honest-counting: right, by a table that it fills itself, and a loop.
// stem: 01-corners
// expect: graded
// earns: everything
#include "exercises/01-corners.h"
#include <stdio.h>
#include <stdlib.h>

static const double signs[][2] = {{-0.5, 0.5}, {0.5, 0.5}};

static vec3 sum(Camera c, const double weights[3])
{
    vec3 *parts = malloc(3 * sizeof *parts), total = {0};
    parts[0] = c.forward, parts[1] = c.right, parts[2] = c.up;
    for (int i = 0; i < 3; i++)
        total += weights[i] * parts[i];
    free(parts);
    return total;
}

vec3 upper_left(Camera c)
{
    printf("upper_left, d %g\n", c.distance);
    return sum(c, (double[]){c.distance, signs[0][0] * c.width, signs[0][1] * c.height});
}

vec3 upper_right(Camera c)
{
    fprintf(stderr, "upper_right, d %g\n", c.distance);
    return sum(c, (double[]){c.distance, signs[1][0] * c.width, signs[1][1] * c.height});
}

vec3 across_30_up_10(Camera c)
{
    return image_plane_vector(c, 0.3, 0.1);
}

vec3 image_plane_vector(Camera c, double s, double t)
{
    return sum(c, (double[]){c.distance, (s - 0.5) * c.width, (t - 0.5) * c.height});
}

Camera with_unit_distance(Camera c)
{
    Camera *other = calloc(1, sizeof *other);
    *other = c;
    other->width /= c.distance;
    other->height /= c.distance;
    other->distance = 1;
    Camera answer = *other;
    free(other);
    return answer;
}
