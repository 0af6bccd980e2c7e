#include "exercises/01-corners.h"

#include "common/answers.h"

vec3 upper_left(Camera c)
{
    vec3 v;
    v.x = c.distance * c.forward.x - c.width / 2 * c.right.x + c.height / 2 * c.up.x;
    v.y = c.distance * c.forward.y - c.width / 2 * c.right.y + c.height / 2 * c.up.y;
    v.z = c.distance * c.forward.z - c.width / 2 * c.right.z + c.height / 2 * c.up.z;
    return v;
}

vec3 upper_right(Camera c)
{
    return upper_left(c) + c.width * c.right;
}
