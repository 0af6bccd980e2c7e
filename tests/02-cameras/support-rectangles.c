// support-rectangles.c - eye and four vectors, eye and four points, and eye, corner and two vectors
// are three ways to give one rectangle, so each is called with the same rectangles.
#include "tests/02-cameras/support.h"

enum { MOST_PARTS = 5 };

static int parts_of(Form form)
{
    return form == CORNER ? 4 : 5;
}

// Says what is given, and calls the function.
static CameraFault ask(Form form, const vec3 *in, Camera *camera)
{
    *camera = untouched();
    given_vec3("eye", in[0]);
    if (form == CORNER) {
        given_vec3("lower left", in[1]);
        given_vec3("across", in[2]);
        given_vec3("up", in[3]);
        return camera_from_corner(in[0], in[1], in[2], in[3], camera);
    }
    given(form == VECTORS ? "vectors" : "points",
          "upper left %s, upper right %s, lower left %s, lower right %s", vec3_text_to(in[1], 10).s,
          vec3_text_to(in[2], 10).s, vec3_text_to(in[3], 10).s, vec3_text_to(in[4], 10).s);
    Corners corners = {in[1], in[2], in[3], in[4]};
    return form == VECTORS ? camera_from_vectors(in[0], corners, camera)
                           : camera_from_points(in[0], corners, camera);
}

// Vectors from the eye to upper left, upper right, lower left, lower right, in the words of a form.
static void put(Form form, vec3 eye, const vec3 *vectors, vec3 *in)
{
    in[0] = eye;
    for (int i = 0; i < 4; i++)
        in[1 + i] = form == VECTORS ? vectors[i] : eye + vectors[i];
    if (form == CORNER) {
        in[1] = eye + vectors[2];
        in[2] = vectors[3] - vectors[2];
        in[3] = vectors[0] - vectors[2];
    }
}

static void vectors_of(Camera c, vec3 *vectors)
{
    vec3 middle = c.distance * c.forward;
    vec3 right = 0.5 * c.width * c.right, up = 0.5 * c.height * c.up;
    vectors[0] = middle - right + up;
    vectors[1] = middle + right + up;
    vectors[2] = middle - right - up;
    vectors[3] = middle + right - up;
}

static void take_apart(Form form, Camera c, vec3 *in)
{
    vec3 vectors[4];
    vectors_of(c, vectors);
    put(form, c.origin, vectors, in);
}

void finds(Form form, const vec3 *in, Camera expected)
{
    Camera found;
    CameraFault fault = ask(form, in, &found);
    expect_found(fault, found, expected);
}

// Some large and some small: rounding grows with the numbers, so the tolerance for a rectangle
// depends on its size.
void finds_random_cameras(Form form)
{
    for (int i = 0; i < 15; i++) {
        Camera c = random_camera();
        double size = i < 9 ? 1 : i % 2 == 0 ? 1e4 : 1e-4;
        c.distance *= size;
        c.width *= size;
        c.height *= size;
        vec3 in[MOST_PARTS];
        take_apart(form, c, in);
        finds(form, in, c);
    }
}

void finds_cameras_of_any_size(Form form)
{
    enum { COUNT = 13 };
    for (int i = 0; i < COUNT; i++) {
        double size;
        Camera c = camera_of_any_size(i, COUNT, &size), found;
        vec3 in[MOST_PARTS];
        take_apart(form, c, in);
        CameraFault fault = ask(form, in, &found);
        expect_found_of_size(fault, found, c, size);
    }
}

void keeps_the_rays(Form form)
{
    for (int i = 0; i < 15; i++) {
        Camera c = camera_number(i), found;
        Normalized place = random_place();
        vec3 in[MOST_PARTS];
        take_apart(form, c, in);
        CameraFault fault = ask(form, in, &found);
        expect_same_ray_through(place, fault, found, c);
    }
}

// Vectors that do not give a camera: upper left, upper right, lower left, lower right. If the edges
// or the middle of the corners are not straight ahead, the reason may also be 'off the axis'; an
// eye in the very middle is not off the axis. A line or a point may be refused as not a rectangle.
// A test ends at the first that is accepted, so the first one is one that half a check refuses.
static const struct {
    const char *what;
    vec3 vectors[4];
    int reasons;
} no_cameras[] = {
    {"a trapezoid", {{-1, 1, 4}, {1, 1, 4}, {-2, -1, 4}, {2, -1, 4}}, RECTANGLE},
    {"a parallelogram", {{-0.5, 1, 4}, {1.5, 1, 4}, {-1.5, -1, 4}, {0.5, -1, 4}}, RECTANGLE},
    {"a parallelogram that hardly leans",
     {{-1.001, 1, 4}, {0.999, 1, 4}, {-0.999, -1, 4}, {1.001, -1, 4}},
     RECTANGLE},
    {"a parallelogram that leans by a ten millionth",
     {{-1.0000001, 1, 4}, {0.9999999, 1, 4}, {-0.9999999, -1, 4}, {1.0000001, -1, 4}},
     RECTANGLE},
    {"a rectangle except for one corner",
     {{-1.5, 1, 4}, {0.5, 1, 4}, {-1.5, -1, 4}, {2.5, -1, 4}},
     RECTANGLE | AXIS},
    {"a rectangle except for one corner, slightly moved",
     {{-1, 1, 4}, {1, 1, 4}, {-1, -1, 4}, {1.001, -1, 4}},
     RECTANGLE | AXIS},
    {"a rectangle, far away, except for one corner, moved by a millionth",
     {{-1, 1, 1000}, {1, 1, 1000}, {-1, -1, 1000}, {1.000001, -1, 1000}},
     RECTANGLE | AXIS},
    {"a rectangle except for its upper left corner",
     {{-1.5, 1, 4}, {1, 1, 4}, {-1, -1, 4}, {1, -1, 4}},
     RECTANGLE | AXIS},
    {"a rectangle except for its upper right corner",
     {{-1, 1, 4}, {1, 1.5, 4}, {-1, -1, 4}, {1, -1, 4}},
     RECTANGLE | AXIS},
    {"a rectangle except for its lower left corner",
     {{-1, 1, 4}, {1, 1, 4}, {-1.5, -1.5, 4}, {1, -1, 4}},
     RECTANGLE | AXIS},
    {"a rectangle except for one corner, bent back",
     {{-1, 1, 4}, {1, 1, 4}, {-1, -1, 4}, {1, -1, 5}},
     RECTANGLE | AXIS},
    {"a rectangle with its lower corners swapped",
     {{-1, 1, 4}, {1, 1, 4}, {1, -1, 4}, {-1, -1, 4}},
     RECTANGLE},
    // Opposite edges are of equal length, and so are the diagonals.
    {"a saddle", {{-1, 1, 5}, {1, 1, 3}, {-1, -1, 3}, {1, -1, 5}}, RECTANGLE | AXIS},

    {"a rectangle above and to the side", {{0, 2, 4}, {2, 2, 4}, {0, 0, 4}, {2, 0, 4}}, AXIS},
    {"a rectangle to the side", {{0, 1, 4}, {2, 1, 4}, {0, -1, 4}, {2, -1, 4}}, AXIS},
    {"a rectangle slightly to the side",
     {{-1.001, 1, 4}, {0.999, 1, 4}, {-1.001, -1, 4}, {0.999, -1, 4}},
     AXIS},
    {"a rectangle to the side by four ten millionths",
     {{-1.0000004, 1, 4}, {0.9999996, 1, 4}, {-1.0000004, -1, 4}, {0.9999996, -1, 4}},
     AXIS},
    {"a rectangle below by four ten millionths",
     {{-1, 0.9999996, 4}, {1, 0.9999996, 4}, {-1, -1.0000004, 4}, {1, -1.0000004, 4}},
     AXIS},
    {"a rectangle above", {{-1, 2, 4}, {1, 2, 4}, {-1, 0, 4}, {1, 0, 4}}, AXIS},
    {"a rectangle slightly below",
     {{-1, 0.999, 4}, {1, 0.999, 4}, {-1, -1.001, 4}, {1, -1.001, 4}},
     AXIS},
    {"a rectangle that leans back", {{-1, 1, 5}, {1, 1, 5}, {-1, -1, 3}, {1, -1, 3}}, AXIS},
    {"a rectangle turned to the side", {{-1, 1, 3}, {1, 1, 5}, {-1, -1, 3}, {1, -1, 5}}, AXIS},

    {"a rectangle around the eye",
     {{-1, 1, 0}, {1, 1, 0}, {-1, -1, 0}, {1, -1, 0}},
     DISTANCE | AXIS},
    {"a rectangle beside the eye", {{1, 1, 0}, {3, 1, 0}, {1, -1, 0}, {3, -1, 0}}, DISTANCE | AXIS},
    {"the eye itself, four times",
     {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}},
     DISTANCE | WIDTH | HEIGHT | RECTANGLE | AXIS},
    {"a vertical line", {{0, 1, 4}, {0, 1, 4}, {0, -1, 4}, {0, -1, 4}}, WIDTH | RECTANGLE},
    {"one point, four times",
     {{0, 0, 4}, {0, 0, 4}, {0, 0, 4}, {0, 0, 4}},
     WIDTH | HEIGHT | RECTANGLE},
    {"a triangle", {{0, 1, 4}, {0, 1, 4}, {-1, -1, 4}, {1, -1, 4}}, WIDTH | RECTANGLE},
    {"a horizontal line", {{-1, 0, 4}, {1, 0, 4}, {-1, 0, 4}, {1, 0, 4}}, HEIGHT | RECTANGLE},
};

// A corner and two vectors can give no other shapes.
static bool is_parallelogram(const vec3 *corners)
{
    return vec3_length(corners[1] - corners[0] - (corners[3] - corners[2])) == 0;
}

// In a world of that size: the eye's coordinates and all lengths are multiplied by it.
static void refuses_one(Form form, size_t shape, double size)
{
    vec3 in[MOST_PARTS], vectors[4];
    Camera after;
    for (int i = 0; i < 4; i++)
        vectors[i] = size * no_cameras[shape].vectors[i];
    put(form, size * vec3_of(2, 2, -4), vectors, in);
    given("corners of", "%s", no_cameras[shape].what);
    CameraFault fault = ask(form, in, &after);
    expect_refused(fault, after, no_cameras[shape].reasons, 0);
}

static bool can_say(Form form, size_t shape)
{
    return form != CORNER || is_parallelogram(no_cameras[shape].vectors);
}

void refuses(Form form, int reasons)
{
    for (size_t i = 0; i < sizeof no_cameras / sizeof no_cameras[0]; i++)
        if ((reasons >> first_of(no_cameras[i].reasons) & 1) == 1 && can_say(form, i))
            refuses_one(form, i, 1);
}

// Powers of two, which round nothing: about 1e-9 and 1e9.
void refuses_in_worlds_of_any_size(Form form)
{
    for (size_t i = 0; i < sizeof no_cameras / sizeof no_cameras[0]; i++)
        if (can_say(form, i))
            refuses_one(form, i, i % 3 == 2 ? 0x1p30 : 0x1p-30);
}

void refuses_what_was_pushed(Form form)
{
    for (int i = 0; i < 12; i++) {
        Camera c = random_camera(), after;
        double by = random_number(0.1, 0.9);
        vec3 aside = by * c.width * c.right, ahead = by * c.distance * c.forward;
        const struct {
            const char *what;
            vec3 upper, lower, lower_right; // how far these are pushed, the last one more
            int reasons;
        } pushes[] = {
            {"a rectangle pushed to the side", aside, aside, 0 * aside, AXIS},
            {"a rectangle pushed into a parallelogram", aside, -aside, 0 * aside, RECTANGLE},
            {"a rectangle pushed until it leans", ahead, -ahead, 0 * aside, AXIS},
            {"a rectangle with one corner pushed", 0 * aside, 0 * aside, aside, RECTANGLE | AXIS},
        };
        int push = i % (form == CORNER ? 3 : 4);
        vec3 vectors[4], in[MOST_PARTS];
        vectors_of(c, vectors);
        for (int k = 0; k < 4; k++)
            vectors[k] += k < 2 ? pushes[push].upper : pushes[push].lower;
        vectors[3] += pushes[push].lower_right;
        put(form, c.origin, vectors, in);
        given("corners of", "%s", pushes[push].what);
        CameraFault fault = ask(form, in, &after);
        expect_refused(fault, after, pushes[push].reasons, 0);
    }
}

// Corners that are NaN or infinitely far away are not those of a rectangle straight ahead; nor are
// points seen from such an eye.
void refuses_what_is_not_finite(Form form)
{
    for (int part = 0; part < parts_of(form); part++)
        for (int axis = 0; axis < 3; axis++) {
            vec3 in[MOST_PARTS];
            Camera after;
            take_apart(form, camera_of_the_deck(), in);
            in[part][axis] = not_finite(part + axis);
            CameraFault fault = ask(form, in, &after);
            bool is_only_the_eye = form == VECTORS && part == 0;
            expect_refused(fault, after, FINITE, is_only_the_eye ? 0 : RECTANGLE | AXIS);
        }
}
