// right.c - right answers to exercise 01, written in other ways.
#include "exercises/01-corners.h"

#include "tests/judge/known.h"

static vec3 between(vec3 from, vec3 to, double share)
{
    return (1 - share) * from + share * to;
}

static double along(Camera c, int axis, double x, double y, double z)
{
    return fma(z, c.forward[axis], fma(y, c.up[axis], x * c.right[axis]));
}

RIGHT(upper_left, "step by step, up before right")
{
    vec3 way = c.forward * c.distance;
    way += c.up * c.height * 0.5;
    way -= c.right * c.width * 0.5;
    return way;
}

RIGHT_LINE(upper_left, "the place s = 0, t = 1", return image_plane_vector(c, 0, 1))
RIGHT_LINE(upper_right, "upper_left plus the width", return upper_left(c) + c.width * c.right)

RIGHT(upper_right, "the lower left corner mirrored in the middle")
{
    vec3 lower_left = c.distance * c.forward - c.width / 2 * c.right - c.height / 2 * c.up;
    return 2 * c.distance * c.forward - lower_left;
}

RIGHT(upper_right, "a matrix whose columns are the frame")
{
    double matrix[3][3], way[3] = {c.width / 2, c.height / 2, c.distance};
    vec3 v = {0, 0, 0, 0};
    for (int row = 0; row < 3; row++) {
        matrix[row][0] = c.right[row];
        matrix[row][1] = c.up[row];
        matrix[row][2] = c.forward[row];
        for (int column = 0; column < 3; column++)
            v[row] += matrix[row][column] * way[column];
    }
    return v;
}

RIGHT(across_30_up_10, "from the lower left corner, in percent")
{
    vec3 lower_left = upper_left(c) - c.height * c.up;
    return lower_left + 30 * c.width / 100 * c.right + 10 * c.height / 100 * c.up;
}

RIGHT(across_30_up_10, "a weighted mean of the four corners")
{
    vec3 left = upper_left(c), right = upper_right(c), down = -c.height * c.up;
    vec3 corners[] = {left, right, left + down, right + down};
    double shares[] = {0.7 * 0.1, 0.3 * 0.1, 0.7 * 0.9, 0.3 * 0.9};
    vec3 sum = {0, 0, 0, 0};
    for (int i = 0; i < 4; i++)
        sum += shares[i] * corners[i];
    return sum;
}

RIGHT(across_30_up_10, "in whole percent, divided last")
{
    int across = 30 - 50, up = 10 - 50;
    return c.distance * c.forward + across * c.width * c.right / 100 + up * c.height * c.up / 100;
}

RIGHT(image_plane_vector, "between the four corners, with a helper")
{
    vec3 left = upper_left(c), right = upper_right(c), down = -c.height * c.up;
    return between(between(left + down, right + down, s), between(left, right, s), t);
}

RIGHT_LINE(image_plane_vector, "multiplied out",
           return c.distance * c.forward + s * c.width * c.right - c.width / 2 * c.right +
                  t * c.height * c.up - c.height / 2 * c.up)

RIGHT(image_plane_vector, "the point of the world minus the eye")
{
    vec3 point = c.origin + c.distance * c.forward;
    point += (2 * s - 1) * c.width / 2 * c.right;
    point += (2 * t - 1) * c.height / 2 * c.up;
    return point - c.origin;
}

RIGHT(image_plane_vector, "with fma, axis by axis")
{
    double x = fma(s, c.width, -c.width / 2), y = fma(t, c.height, -c.height / 2);
    return vec3_of(along(c, 0, x, y, c.distance), along(c, 1, x, y, c.distance),
                   along(c, 2, x, y, c.distance));
}

RIGHT(image_plane_vector, "in long double")
{
    vec3 v = {0, 0, 0, 0};
    for (int i = 0; i < 3; i++)
        v[i] = (double)((long double)c.distance * c.forward[i] +
                        ((long double)s - 0.5L) * c.width * c.right[i] +
                        ((long double)t - 0.5L) * c.height * c.up[i]);
    return v;
}

RIGHT(image_plane_vector, "at distance 1, then d times as far")
{
    double w = c.width / c.distance, h = c.height / c.distance;
    return c.distance * (c.forward + (s - 0.5) * w * c.right + (t - 0.5) * h * c.up);
}

RIGHT(with_unit_distance, "a new camera, times 1 / d")
{
    double factor = 1 / c.distance;
    return (Camera){.origin = c.origin,
                    .right = c.right,
                    .up = c.up,
                    .forward = c.forward,
                    .distance = 1,
                    .width = factor * c.width,
                    .height = factor * c.height};
}

RIGHT(with_unit_distance, "the width by its ratio to the height")
{
    Camera same = c;
    same.height = c.height / c.distance;
    same.width = c.width / c.height * same.height;
    same.distance /= c.distance;
    return same;
}

RIGHT(with_unit_distance, "with atan2 and tan of the angles")
{
    double half_across = atan2(c.width / 2, c.distance), half_up = atan2(c.height / 2, c.distance);
    c.width = 2 * tan(half_across);
    c.height = 2 * tan(half_up);
    c.distance = 1;
    return c;
}
