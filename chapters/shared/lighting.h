// lighting.h - the options of a shaded picture, for the programs that draw one.
#ifndef CHAPTERS_SHARED_LIGHTING_H
#define CHAPTERS_SHARED_LIGHTING_H

#include "chapters/shared/render.h"
#include "common/options.h"

typedef struct {
    Style style;
    double ambient; // less than 0: the scene's
    vec3 sun;       // 0: the scene's lights
} Lighting;

// The values without any option.
extern const Lighting lighting_untold;

#define LIGHTING_OPTIONS(told)                                                                     \
    {"depth", 0, "N", option_count, &(told).style.depth, "follow a ray over up to N mirrors (5)"}, \
        {"samples", 0, "N", option_count, &(told).style.samples, "N x N rays a pixel, to 64 (1)"}, \
        {"ambient", 0, "A", option_ambient, &(told).ambient, "ambient light, 0 or more (0.1)"},    \
        {"sun", 0, "X,Y,Z", option_sun, &(told).sun, "one distant light from there, no others"},   \
    {                                                                                              \
        "gamma", 0, "G", option_number, &(told).style.gamma, "of the display (1: no change)"       \
    }

OptionReader option_count;   // int, 0 to 64
OptionReader option_ambient; // double, not negative
OptionReader option_sun;     // vec3, not 0, which has no direction

// Whether any of these options changes the picture.
bool lighting_is_told(const Lighting *lighting);

// Ends the program, like wrong usage, if a number is not possible.
void lighting_check(const Lighting *lighting, const char *program);

// Changes the ambient light and the lights of a scene. False if there is not enough memory.
bool lighting_apply(const Lighting *lighting, Scene *scene);

#endif
