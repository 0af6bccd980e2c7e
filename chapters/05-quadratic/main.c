// main.c - chapter 05: where a ray meets a sphere.
//
// Prints the slide's derivation line by line in numbers, a, b, c, the roots and the hit; the same
// in world coordinates; and examples of lost digits.
#include "chapters/05-quadratic/figures/figures.h"
#include "chapters/shared/example.h"
#include "common/answers.h"
#include "common/options.h"
#include "common/picture.h"
#include "common/story.h"
#include "common/text.h"
#include "exercises/04-pixel-ray.h"
#include "exercises/05-quadratic.h"

#include <stdio.h>

// ---- where the slide's formulas lose their digits -----------------------------------------------

// The triangles have sides 3, 4, 5, so the right answers are short numbers, known without
// computing.

// Exact in binary, and its square has many digits that can be lost.
static const double fraction = 27.0 / 128;

static const char *near_root(Roots roots, Text *text)
{
    *text = number_text_to(roots.t[0], 15);
    return answers_missing() > 0 ? "not answered yet" : roots.count == 0 ? "missed" : text->s;
}

// Moves a ray and a sphere away from the world's origin together, and prints c in both coordinates.
static void digits_lost_in_the_world(void)
{
    story_heading("Moved away from the world's origin together: c is 75 everywhere");
    printf("  %-12s %-24s %s\n", "moved by", "c in object coordinates", "c in world coordinates");
    for (int power = 0; power <= 10; power += 2) {
        double far = pow(10, power);
        double x = far + fraction;
        Ray ray = {vec3_of(x - 10, x, 0), vec3_of(1, 0, 0)};
        Sphere sphere = {.center = vec3_of(x, x, 0), .radius = 5};
        Quadratic object = object_quadratic(to_object_coordinates(ray, sphere), sphere.radius);
        Quadratic world = world_quadratic(ray, sphere);
        printf("  %-12s %-24s %s\n", number_text(far).s, number_text_to(object.c, 12).s,
               number_text_to(world.c, 12).s);
    }
}

// Moves a sphere away from the eye, and prints the near root from a, b, c and from sphere_roots.
//
// The ray goes along (2, 3, 6), of length 7. At right angles to it is (6, 2, -3), also of length 7.
// The ray passes the center of a sphere of radius 35 at a distance of 21, so it enters the sphere
// 28 before the closest point: 4 lengths of the direction.
static void digits_lost_far_away(void)
{
    const vec3 along = vec3_of(2, 3, 6), across = vec3_of(6, 2, -3);
    story_heading("A sphere that is moved away from the eye: the near root");
    printf("  %-12s %-17s %-18s %s\n", "distance / r", "exactly", "from a, b, c", "sphere_roots");
    for (int power = 1; power <= 9; power += 2) {
        double far = pow(10, power), t = 5 * far + fraction;
        Ray ray = {vec3_of(0, 0, 0), along};
        Sphere sphere = {.center = t * along + 3 * across, .radius = 35};
        Quadratic q = object_quadratic(to_object_coordinates(ray, sphere), sphere.radius);
        Text slide, reference;
        printf("  %-12s %-17s %-18s %s\n", number_text(far).s, number_text_to(t - 4, 16).s,
               near_root(quadratic_roots(q), &slide),
               near_root(sphere_roots(ray, sphere), &reference));
    }
}

// ---- the story ----------------------------------------------------------------------------------

enum { COLUMNS = 4 };

// The lines of the slide 'Solving quadratic', computed separately, for a ray in object coordinates.
static double length_squared(Ray ray, double t)
{
    double length = vec3_length(ray.origin + t * ray.direction);
    return length * length;
}

static double dot_with_itself(Ray ray, double t)
{
    return vec3_dot(ray.origin + t * ray.direction, ray.origin + t * ray.direction);
}

static double sum_of_products(Ray ray, double t)
{
    double sum = 0;
    for (int i = 0; i < 3; i++)
        sum += (ray.origin[i] + t * ray.direction[i]) * (ray.origin[i] + t * ray.direction[i]);
    return sum;
}

// Each axis alone is a ray with a quadratic like any other. Radius 0 leaves only the terms of p and
// v.
static double sum_multiplied_out(Ray ray, double t)
{
    double sum = 0;
    for (int i = 0; i < 3; i++) {
        vec3 axis = vec3_of(i == 0, i == 1, i == 2);
        Ray along = {ray.origin * axis, ray.direction * axis};
        sum += quadratic_value(object_quadratic(along, 0), t);
    }
    return sum;
}

static double three_sums(Ray ray, double t)
{
    return quadratic_value(object_quadratic(ray, 0), t);
}

static void row(const char *label, const double numbers[COLUMNS])
{
    printf("  %-40s", label);
    for (int i = 0; i < COLUMNS; i++)
        printf(" %8s", number_text(numbers[i]).s);
    printf("\n");
}

static void derivation(Ray ray, double radius, const double t[COLUMNS])
{
    static const struct {
        const char *text;
        double (*value)(Ray ray, double t);
    } lines[] = {{"|p + tv|^2", length_squared},
                 {"= (p + tv).(p + tv)", dot_with_itself},
                 {"= sum (p_i + tv_i)(p_i + tv_i)", sum_of_products},
                 {"= sum (p_i^2 + 2 p_i v_i t + v_i^2 t^2)", sum_multiplied_out},
                 {"= sum p_i^2 + 2 sum p_i v_i t + ...", three_sums}};
    double numbers[COLUMNS];
    story_heading("The derivation, in numbers");
    row("at t =", t);
    for (int line = 0; line < 5; line++) {
        for (int i = 0; i < COLUMNS; i++)
            numbers[i] = lines[line].value(ray, t[i]);
        row(lines[line].text, numbers);
    }
    Quadratic q = object_quadratic(ray, radius);
    for (int i = 0; i < COLUMNS; i++)
        numbers[i] = quadratic_value(q, t[i]) + radius * radius;
    row("= a t^2 + b t + c + r^2", numbers);
    printf("  On the sphere it is r^2 = %s.\n", number_text(radius * radius).s);
}

static void coefficients(Quadratic q)
{
    story_line("a", "%s", number_text_to(q.a, 10).s);
    story_line("b", "%s", number_text_to(q.b, 10).s);
    story_line("c", "%s", number_text_to(q.c, 10).s);
}

static void hits(Ray ray, Sphere sphere, Roots roots)
{
    story_line("roots", answers_missing() > 0 ? "not answered yet" : "%d", roots.count);
    for (int i = 0; i < roots.count; i++) {
        vec3 point = ray.origin + roots.t[i] * ray.direction;
        story_line("  t", "%-10s at %s, |p + tv - C| = %s", number_text(roots.t[i]).s,
                   vec3_text(point).s, number_text(vec3_length(point - sphere.center)).s);
    }
    double t = hit_sphere(ray, sphere);
    story_line("the hit, smallest t > 0", "%s", t < NO_HIT ? number_text(t).s : "none");
}

static void tell(Ray ray, Sphere sphere)
{
    printf("05-quadratic: where a ray meets a sphere\n");
    story_heading("The ray and the sphere");
    story_line("origin     p", "%s", vec3_text(ray.origin).s);
    story_line("direction  v", "%s", vec3_text(ray.direction).s);
    story_line("center     c", "%s", vec3_text(sphere.center).s);
    story_line("radius     r", "%s", number_text(sphere.radius).s);

    Ray object_ray = to_object_coordinates(ray, sphere);
    Quadratic q = object_quadratic(object_ray, sphere.radius);
    Roots roots = quadratic_roots(q);
    bool two = answers_missing() == 0 && roots.count == 2;
    const double t[COLUMNS] = {0, 1, two ? roots.t[0] : 2, two ? roots.t[1] : 3};

    story_heading("In object coordinates: p - c = %s", vec3_text(object_ray.origin).s);
    derivation(object_ray, sphere.radius, t);
    story_heading("a t^2 + b t + c = 0");
    coefficients(q);
    hits(ray, sphere, roots);
    story_heading("The same in world coordinates: |(p + tv) - c|^2 = r^2");
    Quadratic world = world_quadratic(ray, sphere);
    Roots same = quadratic_roots(world);
    coefficients(world);
    if (answers_missing() == 0 && same.count == 2)
        story_line("roots", "%s and %s", number_text(same.t[0]).s, number_text(same.t[1]).s);
    digits_lost_in_the_world();
    digits_lost_far_away();
}

// One sphere straight ahead of the lecture's camera, half as far again as the image plane: it
// almost fills the picture, unless that would bring it to the eye.
static Sphere ball_before(Camera c)
{
    return (Sphere){.center = c.origin + 1.5 * c.distance * c.forward,
                    .radius = fmin(0.7 * fmin(c.width, c.height), c.distance)};
}

// The nearer the hit, the brighter the pixel. For the deck's camera the depths are 1.48 to 1.15
// times the distance of the image plane.
static Color color_of_depth(Pixel pixel, void *given)
{
    const Resolution *screen = given;
    Camera camera = example_camera();
    Sphere ball = ball_before(camera);
    double t = hit_sphere(ray_to_plane(pixel_ray(camera, *screen, pixel), camera), ball);
    double thick = ball.radius / camera.distance, dark = 1.5 - 0.02 / 0.35 * thick;
    double shade = (dark - t) / (dark - (1.5 - thick));
    return t < NO_HIT ? vec3_of(shade, shade, shade) : vec3_of(0.12, 0.2, 0.35);
}

int main(int argc, char **argv)
{
    Meeting given = {example_ray(), example_sphere()};
    FigureCommand figure = {0};
    const char *picture = NULL;
    const Option options[] = {
        {"origin", 'o', "X,Y,Z", option_vec3, &given.ray.origin, "p, the origin of the ray"},
        {"direction", 'd', "X,Y,Z", option_vec3, &given.ray.direction,
         "v, its direction, of any length except 0"},
        {"center", 'c', "X,Y,Z", option_vec3, &given.sphere.center, "c, the center of the sphere"},
        {"radius", 'r', "R", option_number, &given.sphere.radius, "r, its radius, greater than 0"},
        {"picture", 0, "FILE.png", option_string, &picture, "draw a picture of a sphere instead"},
        FIGURE_OPTIONS(figure),
        {0}};
    Usage usage = {"[OPTION]...",
                   "A ray and a sphere: the quadratic, its roots and the hit. Without\n"
                   "options it uses the lecture's ray and sphere."};
    if (options_read(argc, argv, options, usage) != argc)
        options_wrong(argv[0], "expected options only");
    if (!(given.sphere.radius > 0))
        options_wrong(argv[0], "--radius: expected a number greater than 0");
    if (vec3_dot(given.ray.direction, given.ray.direction) == 0)
        options_wrong(argv[0], "--direction: expected a length other than 0");
    if (figure.name != NULL)
        return plot_figure(argv[0], "chapters/05-quadratic", quadratic_figures, figure, &given);
    if (picture != NULL) {
        Resolution screen = picture_shaped(example_camera().width, example_camera().height, 480);
        return picture_write(picture, screen, color_of_depth, &screen);
    }
    tell(given.ray, given.sphere);
    return story_end();
}
