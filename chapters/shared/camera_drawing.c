// camera_drawing.c - the camera as a figure shows it, by the vectors of exercise 01.
#include "chapters/shared/camera_drawing.h"

#include "exercises/01-corners.h"

static void place(Plot *plot, Camera c, double s, double t)
{
    plot_row_point(plot, c.origin + image_plane_vector(c, s, t));
}

void plane_rows(Plot *plot, Camera c)
{
    static const double corners[5][2] = {{0, 1}, {1, 1}, {1, 0}, {0, 0}, {0, 1}};
    for (int i = 0; i < 5; i++) {
        place(plot, c, corners[i][0], corners[i][1]);
        plot_fit(plot, c.origin + image_plane_vector(c, corners[i][0], corners[i][1]), 0);
    }
}

void plane_outline(Plot *plot, const char *name, Camera c)
{
    plot_block(plot, name, "x y z of the corners, from the upper left on");
    plane_rows(plot, c);
}

static void pixels(Plot *plot, Camera c, int columns, int rows)
{
    plot_block(plot, "grid", "x y z of the two ends of a line between pixels");
    for (int i = 1; i < columns; i++) {
        place(plot, c, (double)i / columns, 0);
        place(plot, c, (double)i / columns, 1);
        plot_gap(plot);
    }
    for (int i = 1; i < rows; i++) {
        place(plot, c, 0, (double)i / rows);
        place(plot, c, 1, (double)i / rows);
        plot_gap(plot);
    }
    if (columns == 1 && rows == 1) // gnuplot complains about an empty block
        plot_row(plot, NAN, NAN, NAN);
}

void plane_data(Plot *plot, Camera camera, int columns, int rows)
{
    plot_direction(plot, "right", camera.right);
    plot_direction(plot, "up", camera.up);
    plot_direction(plot, "forward", camera.forward);
    plot_number(plot, "d", camera.distance);
    plot_number(plot, "w", camera.width);
    plot_number(plot, "h", camera.height);
    plot_point(plot, "eye", camera.origin);
    plot_fit(plot, camera.origin, 0);
    plane_outline(plot, "plane", camera);
    pixels(plot, camera, columns, rows);
}

void camera_handles(Plot *plot, Camera c)
{
    enum { LONGEST = 1000 };
    const double least = 0.01;
    plot_handle_point(plot, "the eye", "eye", c.origin, c.forward, c.up);
    plot_handle(plot, (Handle){.words = "the corner of the image plane: its width and height",
                               .place = c.origin + image_plane_vector(c, 1, 1),
                               .option = {"width", "height"},
                               .count = 2,
                               .value = vec3_of(c.width, c.height, 0),
                               .along = {c.right / 2, c.up / 2},
                               .least = {least, least},
                               .most = {LONGEST, LONGEST}});
    plot_handle_length(plot, "the middle of the image plane: its distance", "distance", c.distance,
                       c.origin + image_plane_vector(c, 0.5, 0.5), c.forward);
}
