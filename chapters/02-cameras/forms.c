// forms.c - finds the other forms from the frame; the opposite direction is exercise 02.
#include "chapters/02-cameras/forms.h"

#include "exercises/01-corners.h"

// In a right-handed world, right x up points back at the viewer.
Handedness handedness_of(Camera c)
{
    return vec3_dot(vec3_cross(c.right, c.up), c.forward) > 0 ? LEFT_HANDED : RIGHT_HANDED;
}

Forms forms_of(Camera c)
{
    Corners vectors = {image_plane_vector(c, 0, 1), image_plane_vector(c, 1, 1),
                       image_plane_vector(c, 0, 0), image_plane_vector(c, 1, 0)};
    Corners points = {c.origin + vectors.upper_left, c.origin + vectors.upper_right,
                      c.origin + vectors.lower_left, c.origin + vectors.lower_right};
    return (Forms){.look_at = {c.origin, c.origin + image_plane_vector(c, 0.5, 0.5), c.up, c.width,
                               c.width / c.height},
                   .points = points,
                   .vectors = vectors,
                   .across = vectors.lower_right - vectors.lower_left,
                   .upward = vectors.upper_left - vectors.lower_left};
}
