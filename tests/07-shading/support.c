// support.c - the arguments for the tests of exercise 07, and how they are described.
#include "tests/07-shading/support.h"

void given_color(const char *name, Color color)
{
    given_vec3(name, color);
}

void given_highlight(double ks, double shine, Color light, vec3 normal, vec3 to_light, vec3 to_eye)
{
    given_number("ks", ks);
    given_number("shine", shine);
    given_color("light", light);
    given_vec3("normal", normal);
    given_vec3("to light", to_light);
    given_vec3("to eye", to_eye);
}

void given_light(Light light)
{
    given("light", "%s %s, colour %s", light.kind == LIGHT_POINT ? "point, at" : "distant, towards",
          vec3_text_to(light.position, 10).s, vec3_text_to(light.color, 10).s);
}

double largest(vec3 v)
{
    return fmax(fabs(v[0]), fmax(fabs(v[1]), fabs(v[2])));
}

Color random_color(double low, double high)
{
    return random_vec3(low, high);
}

vec3 random_across(vec3 unit)
{
    for (;;) {
        vec3 across = vec3_cross(unit, random_unit());
        if (vec3_length(across) > 0.1)
            return vec3_unit(across);
    }
}

vec3 turned(vec3 from, double degrees, vec3 towards)
{
    return cos(degrees * PI / 180) * from + sin(degrees * PI / 180) * towards;
}
