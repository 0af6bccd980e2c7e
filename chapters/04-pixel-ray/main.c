// main.c - chapter 04: the ray of a pixel.
//
// Follows one pixel from its column and row to its ray. Its picture shows the direction of each
// pixel's ray as a color: red along x, green along y, blue along z.
#include "chapters/04-pixel-ray/figures/figures.h"
#include "chapters/shared/example.h"
#include "common/options.h"
#include "common/picture.h"
#include "common/story.h"
#include "common/text.h"
#include "exercises/03-screen.h"
#include "exercises/04-pixel-ray.h"

#include <stdio.h>

static void follow(Aim view)
{
    ScreenPoint point = pixel_center(view.pixel);
    Normalized place = screen_to_normalized(point, view.screen);
    Ray ray = pixel_ray(view.camera, view.screen, view.pixel);
    story_heading("From the pixel to its ray, on %d x %d pixels", view.screen.width,
                  view.screen.height);
    story_line("pixel (column, row)", "(%d, %d)", view.pixel.column, view.pixel.row);
    story_line("its center (x, y)", "%s", pair_text(point.x, point.y).s);
    story_line("normalized (s, t)", "%s", pair_text(place.s, place.t).s);
    story_line("vector from the eye", "%s", vec3_text(ray_to_plane(ray, view.camera).direction).s);
    story_line("ray: origin", "%s", vec3_text(ray.origin).s);
    story_line("ray: direction", "%s", vec3_text(ray.direction).s);
}

static void points_on(Ray ray)
{
    story_heading("Points on that ray");
    const double t[] = {0, 0.5, 1, 2};
    const char *const where[] = {"the eye", "half way", "on the image plane", "beyond"};
    for (int i = 0; i < 4; i++) {
        printf("  t = %-5s %-19s%s\n", number_text(t[i]).s, where[i],
               vec3_text(ray.origin + t[i] * ray.direction).s);
    }
}

static Color color_of_direction(Pixel pixel, void *given)
{
    const Aim *view = given;
    vec3 direction = vec3_unit(pixel_ray(view->camera, view->screen, pixel).direction);
    return (direction + vec3_of(1, 1, 1)) / 2;
}

int main(int argc, char **argv)
{
    Aim view = {example_camera(), {0, 0}, {-1, -1}};
    FigureCommand figure = {0};
    const char *picture = NULL;
    const Option options[] = {
        {"pixel", 'p', "COLUMN,ROW", option_pixel, &view.pixel,
         "the pixel (the lecture's; of another size the middle one)"},
        {"size", 's', "WIDTHxHEIGHT", option_size, &view.screen,
         "size of the screen (the lecture's)"},
        CAMERA_OPTIONS(view.camera),
        {"picture", 0, "FILE.png", option_string, &picture, "draw the directions as colors"},
        FIGURE_OPTIONS(figure),
        {0}};
    Usage usage = {"[OPTION]...", "From a pixel to its ray, step by step. Without options: the\n"
                                  "lecture's pixel, screen and camera."};
    if (options_read(argc, argv, options, usage) != argc)
        options_wrong(argv[0], "expected options only");
    story_needs_camera(argv[0], view.camera);
    const Resolution screen = example_screen();
    if (view.screen.width == 0)
        view.screen = picture == NULL ? screen : example_small_screen();
    bool same = view.screen.width == screen.width && view.screen.height == screen.height;
    if (view.pixel.column < 0)
        view.pixel =
            same ? example_pixel() : (Pixel){view.screen.width / 2, view.screen.height / 2};
    if (view.pixel.column >= view.screen.width || view.pixel.row >= view.screen.height)
        options_wrong(argv[0], "--pixel: (%d, %d) is not on a screen of %d x %d", view.pixel.column,
                      view.pixel.row, view.screen.width, view.screen.height);
    if (figure.name != NULL)
        return plot_figure(argv[0], "chapters/04-pixel-ray", pixel_ray_figures, figure, &view);
    if (picture != NULL)
        return picture_write(picture, view.screen, color_of_direction, &view);

    printf("04-pixel-ray: the ray of a pixel\n");
    story_heading("The camera");
    story_camera(view.camera);
    follow(view);
    points_on(pixel_ray(view.camera, view.screen, view.pixel));
    return story_end();
}
