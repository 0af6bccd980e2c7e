// light_in_a_plane.c - three figures of chapter 07 that are flat: the eye, the light and the point
// are in the plane of the paper.
//
// Vectors and cosines are those that the answers give. An angle that an answer has as a cosine is
// drawn as large as that cosine says.
#include "chapters/07-shading/figures/figures.h"

#include "common/camera.h"
#include "exercises/06-ray-casting.h"
#include "exercises/07-shading.h"

#include <math.h>
#include <stdio.h>

static const Color white = {1, 1, 1};

static Light lamp_at(vec3 place)
{
    return (Light){place, white, LIGHT_POINT};
}

static double angle_of(vec3 v)
{
    return atan2(v[1], v[0]);
}

static vec3 toward(double angle)
{
    return vec3_of(cos(angle), sin(angle), 0);
}

// The angle whose cosine an answer gives.
static double angle_with(double cosine)
{
    return acos(fmin(fmax(cosine, -1), 1));
}

// From the direction 'from' to the direction 'to', the shorter way: -pi to pi.
static double turn(double from, double to)
{
    return remainder(to - from, 2 * PI);
}

// A part of a circle, with a label at its middle.
static void arc(Plot *plot, const char *name, vec3 center, double radius, double from, double by,
                Label label)
{
    enum { PIECES = 24 };
    plot_block(plot, name, "x y z along the arc");
    for (int i = 0; i <= PIECES; i++)
        plot_row_point(plot, center + radius * toward(from + by * i / PIECES));
    plot_block_end(plot);
    label.place = center + radius * toward(from + by / 2);
    if (fabs(by) > 0.05)
        plot_name(plot, label);
}

static void arrow(Plot *plot, const char *name, vec3 from, vec3 vector, Label label)
{
    plot_vector(plot, name, from, vector);
    plot_fit(plot, from + vector, 0);
    label.block = name;
    label.part = 1;
    plot_name(plot, label);
}

static void circle(Plot *plot, const char *name, Sphere sphere)
{
    enum { CORNERS = 120 };
    plot_block(plot, name, "x y z round the sphere");
    for (int i = 0; i <= CORNERS; i++)
        plot_row_point(plot, sphere.center + sphere.radius * toward(2 * PI * i / CORNERS));
    plot_block_end(plot);
}

static void handle(Plot *plot, const char *words, const char *option, vec3 place)
{
    plot_handle(plot, (Handle){.words = words,
                               .place = place,
                               .option = {option},
                               .count = 3,
                               .value = place,
                               .along = {vec3_of(1, 0, 0), vec3_of(0, 1, 0)}});
}

// ---- surface-vectors ---------------------------------------------------------------------------

// The sphere, and half of the part of it that is shown, as an angle: the point is on top.
static const Sphere ball = {.center = {0, -2, 0}, .radius = 2};
static const double part_shown = 0.6;

// Between light and eye, as far from the normal as the cosine says.
static double halfway_angle(double normal, double light, double eye, double cosine)
{
    double middle = light + turn(light, eye) / 2, away = angle_with(cosine);
    return fabs(turn(normal + away, middle)) < fabs(turn(normal - away, middle)) ? normal + away
                                                                                 : normal - away;
}

void surface_vectors(Plot *plot, const Plane *plane)
{
    vec3 point = ball.center + ball.radius * toward(PI / 2);
    vec3 n = surface_normal(ball, point), to_eye = plane->eye - point;
    vec3 to_light = ray_to_light(point, lamp_at(plane->light)).direction;
    vec3 m = vec3_unit(mirror_direction(-to_light, n));
    double diffuse = diffuse_term(white, 1, white, n, to_light)[0];
    double phong = phong_term(1, 1, white, n, to_light, to_eye)[0];
    double halfway = halfway_term(1, 1, white, n, to_light, to_eye)[0];
    double normal = angle_of(n), light = angle_of(to_light), eye = angle_of(to_eye);
    double h = halfway_angle(normal, light, eye, halfway);

    plot_look_flat(plot);
    plot_number(plot, "diffuse", diffuse);
    plot_number(plot, "phong", phong);
    plot_number(plot, "halfway", halfway);
    plot_point(plot, "point", point);
    arc(plot, "surface", ball.center, ball.radius, PI / 2 + part_shown, -2 * part_shown,
        (Label){.text = "surface", .color = "grey"});
    plot_fit(plot, ball.center + ball.radius * toward(PI / 2 + part_shown), 0);
    plot_fit(plot, ball.center + ball.radius * toward(PI / 2 - part_shown), 0);
    arrow(plot, "n", point, n, (Label){.text = "$n$", .color = "green"});
    arrow(plot, "l", point, vec3_unit(to_light), (Label){"$l$", "orange", .step = 2});
    arrow(plot, "m", point, m, (Label){"$m$", "orange", .step = 3});
    arrow(plot, "e", point, vec3_unit(to_eye), (Label){"$e$", "blue", .step = 3});
    arrow(plot, "h", point, toward(h), (Label){"$h$", "pink", .step = 4});
    arc(plot, "theta", point, 0.34, normal, turn(normal, light), (Label){"θ", "orange", .step = 2});
    arc(plot, "alpha", point, 0.5, angle_of(m), turn(angle_of(m), eye),
        (Label){"α", "blue", .step = 3});
    arc(plot, "beta", point, 0.68, normal, turn(normal, h), (Label){"β", "pink", .step = 4});
    static const Label words[] = {{"diffuse: cos θ = {diffuse!}", "orange", .step = 2},
                                  {"Phong: cos α = {phong!}", "blue", .step = 3},
                                  {"halfway: cos β = {halfway!}", "pink", .step = 4}};
    plot_say(plot, 0, 1, words, sizeof words / sizeof *words);
    handle(plot, "the light", "light", plane->light);
    handle(plot, "the eye", "eye", plane->eye);
}

// ---- beam-and-lobe -----------------------------------------------------------------------------

// Panel 1: a beam that is 'beam' wide. On the surface it is as wide as the cosine says.
static void beam_panel(Plot *plot, vec3 n, vec3 l)
{
    const double beam = 0.6, length = 1.5;
    double cosine = diffuse_term(white, 1, white, n, l)[0];
    bool arrives = cosine > 0.15;
    double spread = arrives ? beam / cosine : NAN;
    vec3 left = vec3_of(-spread / 2, 0, 0), right = vec3_of(spread / 2, 0, 0);
    vec3 across = vec3_of(l[1], -l[0], 0);
    // From where the narrow side of the beam is measured: above the surface on both edges.
    vec3 from = (l[0] < 0 ? right - beam * across : left) + 0.7 * length * l;
    plot_panel(plot, 1);
    plot_room(plot, (Room){0.03, 0.47, 0.16, 0.84}, (Room){0.03, 0.47, 0.16, 0.84});
    plot_number(plot, "cosine", cosine);
    plot_number(plot, "beam", beam);
    plot_number(plot, "spread", spread);
    plot_number(plot, "arrives", arrives);
    plot_vector(plot, "ground", vec3_of(-1.5, 0, 0), vec3_of(3, 0, 0));
    plot_fit(plot, vec3_of(-1.5, 0, 0), 0);
    plot_fit(plot, vec3_of(1.5, 1.5, 0), 0);
    plot_block(plot, "beam_edges", "x y z of an edge's end, x y z to the surface");
    plot_row_vector(plot, left + length * l, -length * l);
    plot_row_vector(plot, right + length * l, -length * l);
    plot_block_end(plot);
    if (arrives) {
        plot_fit(plot, left + length * l, 0);
        plot_fit(plot, right + length * l, 0);
    }
    plot_vector(plot, "across", from, beam * across);
    plot_vector(plot, "on_surface", left, right - left);
    plot_vector(plot, "normal", vec3_of(0, 0, 0), n);
    plot_vector(plot, "middle", vec3_of(0, 0, 0), arrives ? length * l : vec3_of(NAN, NAN, NAN));
    arc(plot, "theta", vec3_of(0, 0, 0), 0.75, angle_of(n), turn(angle_of(n), angle_of(l)),
        (Label){.text = arrives ? "θ" : "", .color = "orange"});
    const Label labels[] = {
        {"$n$", "green", .block = "normal", .part = 1},
        {"{beam}", "ink", .block = "across", .part = ANYWHERE},
        {"{spread!}", "orange", .step = 2, .block = "on_surface", .part = ANYWHERE}};
    plot_names(plot, labels, arrives ? 3 : 1);
    const Label words = {arrives ? "{beam} / {spread} = cos θ = {cosine!}" : "no light arrives",
                         "ink", .step = 2};
    plot_pin(plot, 0.25, 0.07, &words, 1);
}

// What the eye sees of the highlight from each side, as far from the point as it is bright.
static void lobe(Plot *plot, const char *name, vec3 n, vec3 l, double shine, const char *text,
                 const char *color)
{
    enum { SIDES = 180 };
    vec3 m = vec3_unit(mirror_direction(-l, n));
    int row = 0;
    plot_block(plot, name, "x y z, round the lobe");
    for (int i = 0; i <= SIDES; i++) {
        vec3 e = toward(PI * i / SIDES);
        plot_row_point(plot, phong_term(1, shine, white, n, l, e)[0] * e);
        row = vec3_dot(e, m) > vec3_dot(toward(PI * row / SIDES), m) ? i : row;
    }
    plot_block_end(plot);
    plot_name(plot, (Label){text, color, .step = 3, .block = name, .row = row});
}

static void lobe_panel(Plot *plot, vec3 n, vec3 l)
{
    plot_panel(plot, 2);
    plot_room(plot, (Room){0.53, 0.97, 0.16, 0.84}, (Room){0.53, 0.97, 0.16, 0.84});
    plot_vector(plot, "ground2", vec3_of(-1.2, 0, 0), vec3_of(2.4, 0, 0));
    plot_fit(plot, vec3_of(-1.2, 0, 0), 0);
    plot_fit(plot, vec3_of(1.2, 1.2, 0), 0);
    arrow(plot, "n2", vec3_of(0, 0, 0), n, (Label){"$n$", "green", .step = 3});
    arrow(plot, "l2", vec3_of(0, 0, 0), l, (Label){"$l$", "orange", .step = 3});
    lobe(plot, "wide_lobe", n, l, 8, "shine 8", "blue");
    lobe(plot, "narrow_lobe", n, l, 80, "shine 80", "pink");
    static const Label words = {"how bright, seen from there", "grey", .step = 3};
    plot_pin(plot, 0.75, 0.07, &words, 1);
    plot_panel(plot, 1);
}

void beam_and_lobe(Plot *plot, const Plane *plane)
{
    const vec3 n = vec3_of(0, 1, 0);
    vec3 l = vec3_unit(ray_to_light(vec3_of(0, 0, 0), lamp_at(plane->light)).direction);
    plot_look_flat(plot);
    beam_panel(plot, n, l);
    plot_handle(plot, (Handle){.words = "the light",
                               .place = 1.5 * l,
                               .option = {"light"},
                               .count = 3,
                               .value = 1.5 * l,
                               .along = {vec3_of(1, 0, 0), vec3_of(0, 1, 0)}});
    lobe_panel(plot, n, l);
}

// ---- shadow-and-mirror -------------------------------------------------------------------------

static Sphere balls[] = {{.center = {0, -0.4, 0}, .radius = 1.5},
                         {.center = {0.2, 2.6, 0}, .radius = 0.45},
                         {.center = {4.1, 2.7, 0}, .radius = 0.9}};
enum { BALLS = sizeof balls / sizeof *balls };
static const vec3 target = {0.2, 1, 0}; // of the eye's ray

static void ball_data(Plot *plot)
{
    static const char *const names[BALLS] = {"A", "B", "C"};
    for (int i = 0; i < BALLS; i++) {
        char block[20];
        snprintf(block, sizeof block, "ball%d", i);
        circle(plot, block, balls[i]);
        plot_circle(plot, balls[i].center, balls[i].radius);
        plot_fit(plot, balls[i].center, balls[i].radius);
        plot_name(plot, (Label){names[i], "ink", .place = balls[i].center});
    }
}

static double first_t(const Scene *scene, Ray ray)
{
    return nearest_hit(ray, scene).t;
}

// What the eye's ray sees: a point, the normal there, and where other rays start.
typedef struct {
    vec3 point, n, start;
} Seen;

static Seen seen_along(const Scene *scene, Ray ray)
{
    Hit hit = nearest_hit(ray, scene);
    Sphere sphere = balls[hit.sphere >= 0 && hit.sphere < BALLS ? hit.sphere : 0];
    vec3 point = ray.origin + (hit.t < NO_HIT ? hit.t : 1) * ray.direction;
    vec3 n = surface_normal(sphere, point);
    return (Seen){point, n, offset_from_surface(sphere, point, n)};
}

void shadow_and_mirror(Plot *plot, const Plane *plane)
{
    Surface surface = {.color = white};
    Surface surfaces[BALLS] = {surface, surface, surface};
    Light light = lamp_at(plane->light);
    Scene scene = {.spheres = balls,
                   .sphere_count = BALLS,
                   .surfaces = surfaces,
                   .surface_count = BALLS,
                   .lights = &light,
                   .light_count = 1};
    Ray seen = {plane->eye, target - plane->eye};
    Seen at = seen_along(&scene, seen);
    vec3 point = at.point, n = at.n, start = at.start;
    Ray back = ray_to_light(start, light);
    Ray mirrored = {start, mirror_direction(seen.direction, n)};
    double arrives = visibility(&scene, start, light);
    double far = 2.2 * 3 / vec3_length(mirrored.direction), t = first_t(&scene, mirrored);
    vec3 to_hit = fmin(t, far) * mirrored.direction;

    plot_look_flat(plot);
    ball_data(plot);
    plot_number(plot, "visibility", arrives);
    plot_number(plot, "mirrored_t", t);
    plot_point(plot, "eye", plane->eye);
    plot_point(plot, "lamp", plane->light);
    plot_point(plot, "point", point);
    plot_fit(plot, plane->eye, 0);
    plot_fit(plot, plane->light, 0);
    plot_fit(plot, start + to_hit, 0);
    plot_vector(plot, "seen", plane->eye, point - plane->eye);
    plot_vector(plot, "n", point, n);
    plot_vector(plot, "to_light", start, back.direction);
    plot_vector(plot, "lit", start, fmin(first_t(&scene, back), 1) * back.direction);
    plot_vector(plot, "mirrored", start, to_hit);
    const Label labels[] = {
        {"eye", "grey", .block = "eye"},
        {"light", "grey", .block = "lamp"},
        {"$n$", "green", .step = 1, .block = "n", .part = 1},
        {"shadow ray", "orange", .step = 2, .block = "to_light", .part = ANYWHERE},
        {"mirrored ray", "blue", .step = 3, .block = "mirrored", .part = ANYWHERE}};
    plot_names(plot, labels, sizeof labels / sizeof *labels);
    static const Label words[] = {{"visibility: {visibility!}", "orange", .step = 2}};
    plot_say(plot, 0, 0, words, 1);
    handle(plot, "the light", "light", plane->light);
    handle(plot, "the eye", "eye", plane->eye);
}
