// light_in_a_plane.c - four figures of chapter 07 that are flat: the eye, the light and the point
// are in the plane of the paper.
//
// Vectors and cosines are those that the answers give. An angle that an answer has as a cosine is
// drawn as large as that cosine says.
#include "chapters/07-shading/figures/figures.h"

#include "common/camera.h"
#include "exercises/05-quadratic.h"
#include "exercises/06-ray-casting.h"
#include "exercises/07-shading.h"

#include <math.h>
#include <stdio.h>

static const Color white = {1, 1, 1};

static Light lamp_at(vec3 place)
{
    return (Light){place, white, LIGHT_POINT};
}

// The light and the eye that the command line gives, or the figure's own.
static Plane plane_or(const void *given, vec3 light, vec3 eye)
{
    Plane plane = ((const Given *)given)->plane;
    return (Plane){isnan(plane.light[0]) ? light : plane.light,
                   isnan(plane.eye[0]) ? eye : plane.eye};
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

// A part of a circle, or all of it.
static void part_of_circle(Plot *plot, const char *name, vec3 center, double radius, double from,
                           double by, int pieces)
{
    plot_block(plot, name, "x y z along the circle");
    for (int i = 0; i <= pieces; i++)
        plot_row_point(plot, center + radius * toward(from + by * i / pieces));
}

// The same with a label at its middle.
static void arc(Plot *plot, const char *name, vec3 center, double radius, double from, double by,
                Label label)
{
    part_of_circle(plot, name, center, radius, from, by, 24);
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

static void handle(Plot *plot, const char *words, const char *option, vec3 place)
{
    plot_handle_point(plot, words, option, place, vec3_of(1, 0, 0), vec3_of(0, 1, 0));
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

void surface_vectors(Plot *plot, void *given)
{
    Plane plane = plane_or(given, vec3_of(-2.4, 1.7, 0), vec3_of(1.5, 1.9, 0));
    vec3 point = ball.center + ball.radius * toward(PI / 2);
    vec3 n = surface_normal(ball, point), to_eye = plane.eye - point;
    vec3 to_light = ray_to_light(point, lamp_at(plane.light)).direction;
    vec3 m = vec3_unit(mirror_direction(-to_light, n));
    double diffuse = diffuse_term(white, 1, white, n, to_light)[0];
    double phong = phong_term(1, 1, white, n, to_light, to_eye)[0];
    double halfway = halfway_term(1, 1, white, n, to_light, to_eye)[0];
    double normal = angle_of(n), light = angle_of(to_light), eye = angle_of(to_eye);
    double h = halfway_angle(normal, light, eye, halfway);

    plot_look_flat(plot);
    // On the narrow canvas the three lines of words are above.
    plot_room(plot, (Room){0.03, 0.97, 0.04, 0.84}, (Room){0.03, 0.97, 0.04, 0.64});
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
    plot_say(plot, 0, 1, {"diffuse: cos θ = {diffuse!}", "orange", .step = 2},
             {"Phong: cos α = {phong!}", "blue", .step = 3},
             {"halfway: cos β = {halfway!}", "pink", .step = 4});
    handle(plot, "the light", "light", plane.light);
    handle(plot, "the eye", "eye", plane.eye);
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
    plot_names(
        plot, {"$n$", "green", .block = "normal", .part = 1},
        {arrives ? "{beam}" : "", "ink", .block = "across", .part = ANYWHERE},
        {arrives ? "{spread!}" : "", "orange", .step = 2, .block = "on_surface", .part = ANYWHERE});
    plot_pin(
        plot, 0.25, 0.07,
        {arrives ? "{beam} / {spread} = cos θ = {cosine!}" : "no light arrives", "ink", .step = 2});
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
    plot_pin(plot, 0.75, 0.07, {"how bright from there", "grey", .step = 3});
    plot_panel(plot, 1);
}

void beam_and_lobe(Plot *plot, void *given)
{
    Plane plane = plane_or(given, vec3_of(-1.5, 1.6, 0), vec3_of(0, 1, 0));
    const vec3 n = vec3_of(0, 1, 0);
    vec3 l = vec3_unit(ray_to_light(vec3_of(0, 0, 0), lamp_at(plane.light)).direction);
    plot_look_flat(plot);
    beam_panel(plot, n, l);
    handle(plot, "the light", "light", 1.5 * l);
    lobe_panel(plot, n, l);
}

// ---- self-hit ----------------------------------------------------------------------------------

// Why a ray must not start on the surface that it leaves. The numbers are those of a real ray, but
// a rounding error is too small to be seen. So it is drawn as a fifth of the radius, and so is the
// distance of the remedy. Two pictures show what follows, with real rounding errors.
static const double shown_error = 0.22; // of the radius
static const vec3 top = {0, 1, 0};      // of the sphere: there the eye's ray meets it
static const double low = 0.45;         // what is below is not shown

// The first of the rays for which a second ray, from the hit point to the light, immediately meets
// the sphere again, because rounding put the point inside. Each formula rounds in its own way and
// finds its own ray. They differ by so little that the figure is the same.
static Ray unlucky_ray(Sphere sphere, Light light, vec3 eye)
{
    Ray ray = {eye, top - eye};
    for (int i = 0; i < 10000; i++, ray.origin += vec3_of(1e-13, 1e-13, 0)) {
        double t = hit_sphere(ray, sphere);
        vec3 point = ray.origin + t * ray.direction;
        if (t < NO_HIT && hit_sphere(ray_to_light(point, light), sphere) < 1)
            return ray;
    }
    return ray;
}

// What is true of the ray, in numbers: none of it can be drawn.
static void true_numbers(Plot *plot, Sphere sphere, Light light, vec3 point)
{
    vec3 start = offset_from_surface(sphere, point, surface_normal(sphere, point));
    plot_undrawn(plot);
    plot_vector(plot, "offset", point, start - point);
    plot_number(plot, "self_t", hit_sphere(ray_to_light(point, light), sphere));
    plot_number(plot, "start_t", hit_sphere(ray_to_light(start, light), sphere));
    plot_number(plot, "inside_by", sphere.radius - vec3_length(point - sphere.center));
}

// The same in both panels: the sphere, the ray that the eye sees along, the light.
static void hit_panel(Plot *plot, int panel, Sphere sphere, Light light, Ray ray, vec3 point)
{
    static const Room rooms[] = {{0.012, 0.488, 0.33, 0.845}, {0.512, 0.988, 0.33, 0.845}};
    double from = asin(low / sphere.radius);
    Text lamp = text_of("light_%d", panel);
    plot_panel(plot, panel);
    plot_room(plot, rooms[panel - 1], rooms[panel - 1]);
    plot_fit(plot, vec3_of(-1.2, low, 0), 0);
    plot_fit(plot, vec3_of(1.2, 1.9, 0), 0);
    plot_fit(plot, ray.origin, 0);
    plot_fit(plot, light.position, 0);
    part_of_circle(plot, text_of("cap_%d", panel).s, sphere.center, sphere.radius, from,
                   PI - 2 * from, 72);
    plot_point(plot, lamp.s, light.position);
    plot_name(plot, (Label){"light", "ink", .block = lamp.s, .step = panel == 1 ? 1 : 4});
    plot_vector(plot, text_of("seen_%d", panel).s, ray.origin, point - ray.origin);
}

static void drawn_rays(Plot *plot, Sphere sphere, Light light, Ray ray, vec3 point)
{
    vec3 off = shown_error * sphere.radius * surface_normal(sphere, point);
    vec3 inside = point - off, outside = point + off;
    Ray back = ray_to_light(inside, light);
    vec3 to_itself = hit_sphere(back, sphere) * back.direction;

    hit_panel(plot, 1, sphere, light, ray, point);
    plot_vector(plot, "wanted", point, light.position - point);
    plot_point(plot, "point", point);
    plot_point(plot, "inside", inside);
    plot_vector(plot, "to_itself", inside, to_itself);
    plot_point(plot, "own_hit", inside + to_itself);
    plot_name(plot, (Label){"from the eye", "grey", .block = "seen_1", .part = 0.3});
    plot_name(plot, (Label){"computed hit", "ink", .block = "inside", .step = 2});
    plot_name(plot, (Label){"hits itself", "ink", .block = "own_hit", .step = 3});
    handle(plot, "the light", "light", light.position);
    handle(plot, "the eye", "eye", ray.origin);

    hit_panel(plot, 2, sphere, light, ray, point);
    plot_vector(plot, "normal", point, off);
    plot_point(plot, "outside", outside);
    // Its tip does not cover the light.
    plot_vector(plot, "to_light", outside, 0.93 * (light.position - outside));
    plot_name(plot, (Label){"$n$", "green", .block = "normal", .part = 0.5, .step = 4});
    plot_name(plot, (Label){"start", "blue", .block = "outside", .step = 4});
}

typedef vec3 Starter(Sphere sphere, vec3 point, vec3 normal);

static vec3 at_the_point(Sphere sphere, vec3 point, vec3 normal)
{
    (void)sphere;
    (void)normal;
    return point;
}

// Brighter the more the surface faces the eye, so that it looks round; and dark where a ray to the
// light that starts as told does not arrive.
static Color light_and_dark(const Scene *scene, Ray ray, Starter *start)
{
    Hit hit = nearest_hit(ray, scene);
    if (hit.sphere != 0)
        return scene->background;
    vec3 point = ray.origin + hit.t * ray.direction;
    vec3 normal = surface_normal(scene->spheres[0], point);
    double facing = fabs(vec3_dot(normal, vec3_unit(ray.direction)));
    vec3 from = start(scene->spheres[0], point, normal);
    double left = visibility(scene, from, scene->lights[0]) > 0 ? 1 : 0.2;
    return left * facing * scene_surface(scene, 0)->color;
}

// With samples x samples rays a pixel. The light is on the side where it is drawn, and before the
// sphere. The rays are the figure's own: a camera that is wrong is not what it shows.
static void picture_data(Plot *plot, const char *name, Starter *start, vec3 light, int samples,
                         double allowed)
{
    enum { SIDE = 150 };
    // Neither at the origin nor exactly before the eye, where rounding makes symmetrical patterns.
    const vec3 place = vec3_of(2, 2, 1);
    const double grey = 127 / 255.0;
    Sphere sphere = {.center = place, .radius = 1};
    Surface surface = {.color = white};
    Light lamp = lamp_at(place + 3 * light + vec3_of(0, 0, 6));
    Scene scene = {.spheres = &sphere,
                   .sphere_count = 1,
                   .surfaces = &surface,
                   .surface_count = 1,
                   .lights = &lamp,
                   .light_count = 1,
                   .background = vec3_of(grey, grey, grey)};
    const vec3 eye = place + vec3_of(0.011, 0.007, 6);
    const double across = 2.25; // of a square window, 6 before the eye
    Image image;
    Message message;
    const double fine = SIDE * samples;
    if (!image_create(&image, (Resolution){SIDE, SIDE}, &message))
        return;
    for (int i = 0; i < SIDE * SIDE; i++) {
        Color sum = vec3_of(0, 0, 0);
        for (int k = 0; k < samples * samples; k++) {
            double s = (i % SIDE * samples + k % samples + 0.5) / fine,
                   t = 1 - (i / SIDE * samples + k / samples + 0.5) / fine;
            Ray ray = {eye, vec3_of((s - 0.5) * across, (t - 0.5) * across, -6)};
            sum += light_and_dark(&scene, ray, start);
        }
        image_set(&image, (Pixel){i % SIDE, i / SIDE}, sum / (samples * samples));
    }
    plot_picture(plot, name, &image, allowed);
    plot_number(plot, "side", SIDE);
    image_free(&image);
}

// Above the place that is hit, by more than the start of the ray that is drawn.
static vec3 above_the_top(vec3 place)
{
    return vec3_of(place[0], fmax(place[1], 1.5), 0);
}

void self_hit(Plot *plot, void *given)
{
    const Sphere sphere = {.center = vec3_of(0, 0, 0), .radius = 1};
    Plane plane = plane_or(given, vec3_of(0.85, 1.8, 0), vec3_of(-1.15, 1.575, 0));
    Light light = lamp_at(above_the_top(plane.light));
    Ray ray = unlucky_ray(sphere, light, above_the_top(plane.eye));
    vec3 point = ray.origin + hit_sphere(ray, sphere) * ray.direction;
    plot_look_flat(plot);
    plot_fill_room(plot);
    plot_keep_clear(plot, (Room){0, 1, 0, 0.33}, (Room){0, 1, 0, 0.33});
    true_numbers(plot, sphere, light, point);
    drawn_rays(plot, sphere, light, ray, point);
    // Right answers round in different ways, and each has specks of its own.
    picture_data(plot, "specks", at_the_point, light.position, 1, 255);
    picture_data(plot, "smooth", offset_from_surface, light.position, plot_is_dragged(plot) ? 1 : 3,
                 COLOR_ROUNDING);
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
        part_of_circle(plot, text_of("ball%d", i).s, balls[i].center, balls[i].radius, 0, 2 * PI,
                       120);
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

void shadow_and_mirror(Plot *plot, void *given)
{
    Plane plane = plane_or(given, vec3_of(0.3, 4.2, 0), vec3_of(-4.4, 2.6, 0));
    Surface surface = {.color = white};
    Surface surfaces[BALLS] = {surface, surface, surface};
    Light light = lamp_at(plane.light);
    Scene scene = {.spheres = balls,
                   .sphere_count = BALLS,
                   .surfaces = surfaces,
                   .surface_count = BALLS,
                   .lights = &light,
                   .light_count = 1};
    Ray seen = {plane.eye, target - plane.eye};
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
    plot_point(plot, "eye", plane.eye);
    plot_point(plot, "lamp", plane.light);
    plot_point(plot, "point", point);
    plot_fit(plot, plane.eye, 0);
    plot_fit(plot, plane.light, 0);
    plot_fit(plot, start + to_hit, 0);
    plot_vector(plot, "seen", plane.eye, point - plane.eye);
    plot_vector(plot, "n", point, n);
    plot_vector(plot, "to_light", start, back.direction);
    plot_vector(plot, "lit", start, fmin(first_t(&scene, back), 1) * back.direction);
    plot_vector(plot, "mirrored", start, to_hit);
    plot_names(plot, {"eye", "grey", .block = "eye"}, {"light", "grey", .block = "lamp"},
               {"$n$", "green", .step = 1, .block = "n", .part = 1},
               {"shadow ray", "orange", .step = 2, .block = "to_light", .part = ANYWHERE},
               {"mirrored ray", "blue", .step = 3, .block = "mirrored", .part = ANYWHERE});
    plot_say(plot, 0, 0, {"visibility: {visibility!}", "orange", .step = 2});
    handle(plot, "the light", "light", plane.light);
    handle(plot, "the eye", "eye", plane.eye);
}
