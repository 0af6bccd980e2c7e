#include "exercises/01-corners.h"

vec3 upper_left(Camera c)
{
    return c.distance * c.forward + (c.height * c.up - c.width * c.right) / 2;
}

vec3 upper_right(Camera c)
{
    return c.distance * c.forward + (c.height * c.up + c.width * c.right) / 2;
}
