// export.c - the scene for POV-Ray and pbrt-v4, with the same camera.
//
// Both have left-handed worlds. Nothing has to be mirrored: the camera is not written as a look-at,
// but as its own three directions, and those give the same picture in a world of either handedness.
#include "chapters/07-shading/export.h"

#include "common/whole_file.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

// The shortest text that reads back as the same number.
static Text number(double x)
{
    int digits = TEXT_DIGITS;
    Text text = number_text_to(x, digits);
    while (digits < 17 && strtod(text.s, NULL) != x)
        text = number_text_to(x, ++digits);
    return text;
}

// ---- POV-Ray 3.7 ------------------------------------------------------------------------------

static void pov_vector(FILE *out, const char *before, vec3 v, const char *after)
{
    fprintf(out, "%s<%s, %s, %s>%s", before, number(v[0]).s, number(v[1]).s, number(v[2]).s, after);
}

static void pov_surface(FILE *out, const Export *what, const Surface *surface)
{
    pov_vector(out, "  pigment { color rgb ", surface->color, " }\n");
    if (what->flat) {
        fprintf(out, "  finish { ambient 1 diffuse 0 }\n");
        return;
    }
    pov_vector(out, "  finish { ambient rgb ", surface->diffuse * what->scene->ambient, "");
    fprintf(out, " diffuse %s phong %s phong_size %s", number(surface->diffuse).s,
            number(surface->specular).s, number(surface->shine).s);
    if (surface->specular > 0 && what->depth > 0)
        fprintf(out, " reflection { %s }", number(surface->specular).s);
    fprintf(out, " }\n");
}

// A distant light is a parallel light, far outside the scene.
static void pov_light(FILE *out, const Scene *scene, Light light)
{
    double far = 1;
    for (int i = 0; i < scene->sphere_count; i++)
        far = fmax(far, vec3_length(scene->spheres[i].center) + scene->spheres[i].radius);
    bool distant = light.kind == LIGHT_DISTANT;
    pov_vector(out, "light_source { ",
               distant ? 1000 * far * vec3_unit(light.position) : light.position, "");
    pov_vector(out, " color rgb ", light.color, "");
    fprintf(out, distant ? " parallel point_at <0, 0, 0> }\n" : " }\n");
}

static void write_pov(FILE *out, const Export *what)
{
    const Scene *scene = what->scene;
    Camera c = what->camera;
    fprintf(out,
            "// %s for POV-Ray 3.7, %s. Draw it with this file's name in place of FILE:\n"
            "//   povray +IFILE +W%d +H%d -A\n"
            "#version 3.7;\n"
            "global_settings { assumed_gamma srgb adc_bailout 0 max_trace_level %d }\n",
            what->name.s, what->flat ? "flat" : "shaded", what->size.width, what->size.height,
            what->depth > 0 ? what->depth + 1 : 1);
    pov_vector(out, "background { color rgb ", scene->background, " }\n");
    pov_vector(out, "camera {\n  location ", c.origin, "\n");
    pov_vector(out, "  direction ", c.distance * c.forward, "\n");
    pov_vector(out, "  right ", c.width * c.right, "\n");
    pov_vector(out, "  up ", c.height * c.up, "\n}\n");
    for (int i = 0; i < scene->light_count && !what->flat; i++)
        pov_light(out, scene, scene->lights[i]);
    for (int i = 0; i < scene->surface_count; i++) {
        fprintf(out, "#declare Surface%d = texture {\n", i);
        pov_surface(out, what, &scene->surfaces[i]);
        fprintf(out, "}\n");
    }
    for (int i = 0; i < scene->sphere_count; i++) {
        pov_vector(out, "sphere { ", scene->spheres[i].center, ", ");
        fprintf(out, "%s texture { Surface%d } }\n", number(scene->spheres[i].radius).s,
                scene->spheres[i].surface);
    }
}

// ---- pbrt-v4 ----------------------------------------------------------------------------------

static void pbrt_rgb(FILE *out, const char *name, Color color)
{
    fprintf(out, " \"rgb %s\" [ %s %s %s ]", name, number(color[0]).s, number(color[1]).s,
            number(color[2]).s);
}

// From the world to the camera, which looks along z; column by column.
static void pbrt_camera(FILE *out, Camera c)
{
    const vec3 rows[3] = {c.right, c.up, c.forward};
    fprintf(out, "Transform [");
    for (int column = 0; column < 3; column++)
        fprintf(out, "\n  %s %s %s 0", number(rows[0][column]).s, number(rows[1][column]).s,
                number(rows[2][column]).s);
    fprintf(out, "\n  %s %s %s 1 ]\n", number(-vec3_dot(rows[0], c.origin)).s,
            number(-vec3_dot(rows[1], c.origin)).s, number(-vec3_dot(rows[2], c.origin)).s);
    // At 90 degrees the screen window is measured on the plane at distance 1.
    double x = c.width / c.distance / 2, y = c.height / c.distance / 2;
    fprintf(out,
            "Camera \"perspective\" \"float fov\" [ 90 ] \"float screenwindow\" [ %s %s %s %s ]\n",
            number(-x).s, number(x).s, number(-y).s, number(y).s);
}

// In a path tracer, light weakens with distance. The intensity is pi times the squared distance
// from the light to the point straight ahead of the camera on the image plane. So at that point a
// point light is as bright as it is here.
static void pbrt_light(FILE *out, const Export *what, Light light)
{
    Camera c = what->camera;
    vec3 ahead = c.origin + c.distance * c.forward;
    bool distant = light.kind == LIGHT_DISTANT;
    vec3 way = light.position - ahead;
    double scale = PI * (distant ? 1 : vec3_dot(way, way));
    fprintf(out, "LightSource \"%s\"", distant ? "distant" : "point");
    pbrt_rgb(out, distant ? "L" : "I", light.color);
    fprintf(out, " \"float scale\" [ %s ] \"point3 from\" [ %s %s %s ]", number(scale).s,
            number(light.position[0]).s, number(light.position[1]).s, number(light.position[2]).s);
    fprintf(out, distant ? " \"point3 to\" [ 0 0 0 ]\n" : "\n");
}

static void pbrt_surface(FILE *out, const Export *what, const Surface *surface)
{
    if (what->flat) {
        fprintf(out, "Material \"diffuse\" \"rgb reflectance\" [ 0 0 0 ]\n");
        return;
    }
    // The roughness that gives a highlight of the same width as Phong's.
    double roughness = sqrt(2 / (surface->shine + 2));
    fprintf(out, "Material \"%s\"", surface->specular > 0 ? "coateddiffuse" : "diffuse");
    pbrt_rgb(out, "reflectance", surface->diffuse * surface->color);
    if (surface->specular > 0)
        fprintf(out, " \"float roughness\" [ %s ]", number(roughness).s);
    fprintf(out, "\n");
}

static void pbrt_sphere(FILE *out, const Export *what, Sphere sphere)
{
    const Surface *surface = &what->scene->surfaces[sphere.surface];
    fprintf(out, "AttributeBegin\n");
    pbrt_surface(out, what, surface);
    if (what->flat) {
        fprintf(out, "AreaLightSource \"diffuse\"");
        pbrt_rgb(out, "L", surface->color);
        fprintf(out, "\n");
    }
    fprintf(out, "Translate %s %s %s\nShape \"sphere\" \"float radius\" [ %s ]\nAttributeEnd\n",
            number(sphere.center[0]).s, number(sphere.center[1]).s, number(sphere.center[2]).s,
            number(sphere.radius).s);
}

static void write_pbrt(FILE *out, const Export *what)
{
    const Scene *scene = what->scene;
    fprintf(out, "# %s for pbrt-v4, %s.\n", what->name.s, what->flat ? "flat" : "shaded");
    if (!what->flat)
        fprintf(out, "# A path tracer has no ambient light and no Phong: the background lights the "
                     "scene, and\n"
                     "# highlights are those of a coat of like roughness. A likeness, not the same "
                     "picture.\n");
    pbrt_camera(out, what->camera);
    fprintf(
        out,
        "Film \"rgb\" \"string filename\" \"picture.png\" \"integer xresolution\" [ %d ] \"integer "
        "yresolution\" [ %d ]\n"
        "PixelFilter \"box\"\n"
        "Sampler \"independent\" \"integer pixelsamples\" [ %d ]\n"
        "Integrator \"path\" \"integer maxdepth\" [ %d ]\n"
        "WorldBegin\n",
        what->size.width, what->size.height, what->flat ? 1 : 64, what->flat ? 0 : what->depth + 1);
    fprintf(out, "LightSource \"infinite\"");
    pbrt_rgb(out, "L", scene->background);
    fprintf(out, "\n");
    for (int i = 0; i < scene->light_count && !what->flat; i++)
        pbrt_light(out, what, scene->lights[i]);
    for (int i = 0; i < scene->sphere_count; i++)
        pbrt_sphere(out, what, scene->spheres[i]);
}

static bool write_scene(FILE *out, const void *given, const char *path, Message *message)
{
    const Export *what = given;
    if (what->format == EXPORT_POV)
        write_pov(out, what);
    else
        write_pbrt(out, what);
    if (fflush(out) == 0 && !ferror(out))
        return true;
    return message_set(message, "%s: cannot be written: %s", path, strerror(errno));
}

bool export_scene(const Export *what, const char *path, Message *message)
{
    return file_write_whole(path, write_scene, what, message);
}
