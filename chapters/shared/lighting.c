// lighting.c - the options of a shaded picture: reads them, and changes the scene.
#include "chapters/shared/lighting.h"

#include <stdlib.h>

const Lighting lighting_untold = {.style = {.samples = 1, .depth = 5, .gamma = 1}, .ambient = -1};

bool option_count(const char *text, void *into)
{
    return option_whole(text, 0, 64, into);
}

bool option_ambient(const char *text, void *into)
{
    return option_number(text, into) && *(double *)into >= 0;
}

bool option_sun(const char *text, void *into)
{
    return option_vec3(text, into) && vec3_length(*(vec3 *)into) > 0;
}

static bool has_sun(const Lighting *lighting)
{
    return vec3_length(lighting->sun) > 0;
}

bool lighting_is_told(const Lighting *lighting)
{
    Style style = lighting->style, untold = lighting_untold.style;
    return style.samples != untold.samples || style.depth != untold.depth ||
           style.gamma != untold.gamma || lighting->ambient >= 0 || has_sun(lighting);
}

void lighting_check(const Lighting *lighting, const char *program)
{
    if (lighting->style.samples < 1)
        options_wrong(program, "--samples: expected 1 to 64");
    if (!(lighting->style.gamma > 0))
        options_wrong(program, "--gamma: expected a number greater than 0");
}

bool lighting_apply(const Lighting *lighting, Scene *scene)
{
    if (lighting->ambient >= 0)
        scene->ambient = vec3_of(lighting->ambient, lighting->ambient, lighting->ambient);
    if (!has_sun(lighting))
        return true;
    Light *only = realloc(scene->lights, sizeof *only);
    if (only == NULL)
        return false;
    *only = (Light){lighting->sun, vec3_of(1, 1, 1), LIGHT_DISTANT};
    scene->lights = only;
    scene->light_count = 1;
    return true;
}
