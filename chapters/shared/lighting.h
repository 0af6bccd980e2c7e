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

// Where no option says otherwise.
extern const Lighting lighting_untold;

#define LIGHTING_OPTIONS(told)                                                                       \
    {"depth", 0, "N", option_count, &(told).style.depth, "follow a ray over up to N mirrors (5)"},   \
        {"samples", 0, "N", option_count, &(told).style.samples, "N x N rays a pixel, 1 to 64 (1)"}, \
        {"ambient", 0, "A", option_ambient, &(told).ambient, "ambient light, 0 or more (0.1)"},      \
        {"sun", 0, "X,Y,Z", option_sun, &(told).sun, "only one light, a distant one, from there"},   \
    {                                                                                                \
        "gamma", 0, "G", option_number, &(told).style.gamma, "gamma of the display (1: no change)"   \
    }

OptionReader option_count;   // int, 0 to 64
OptionReader option_ambient; // double, not negative
OptionReader option_sun;     // vec3, not 0: that is no direction

// Whether any of these options changes the picture.
bool lighting_is_told(const Lighting *lighting);

// Ends the program as wrong usage does where a number cannot be.
void lighting_check(const Lighting *lighting, const char *program);

// The ambient light and the lights of a scene become what was told. False where memory is short.
bool lighting_apply(const Lighting *lighting, Scene *scene);

#endif
