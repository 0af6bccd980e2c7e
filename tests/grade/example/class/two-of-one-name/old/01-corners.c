#include "exercises/01-corners.h"

vec3 upper_left(Camera c)
{
    return c.distance * c.forward + c.height * c.up - c.width * c.right;
}
