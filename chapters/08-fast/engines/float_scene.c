// float_scene.c - steps 4 and 5: the scene becomes floats, seen from the eye, in the order of the
// hierarchy. Tiles of pixels are cast in floats; step 3 decides the pixels in doubt.
#include "chapters/08-fast/engines/float_scene.h"
#include "chapters/08-fast/engines/bins.h"
#include "chapters/08-fast/engines/engine.h"
#include "common/clock.h"
#include "exercises/04-pixel-ray.h"

#include <stdlib.h>

typedef struct {
    const Work *work;
    Walk *walk;
    const BinsLanes *lanes;
    int *colors;
    Hierarchy hierarchy;
    WideHierarchy wide; // if it is needed
    // For this camera.
    Eye eye;
    Seen *seen;
    SeenBox *boxes; // if wide is not needed
    float *x, *y;
    atomic_bool badly; // floats are not good enough
    View view;
} FloatScene;

// ---- the scene --------------------------------------------------------------------------------

// False if floats cannot decide about the sphere: it touches the eye, or its size is extreme.
static bool set_seen(Seen *seen, const Camera *camera, vec3 c, double r)
{
    double distance = vec3_length(c), doubt = 0x1p-20 * (distance + r), more = doubt * (r + doubt);
    bool around = distance < 0.999 * r;
    *seen = (Seen){.x = (float)vec3_dot(c, camera->right),
                   .y = (float)vec3_dot(c, camera->up),
                   .z = (float)vec3_dot(c, camera->forward),
                   .first = (float)(around ? r * r - more : r * r + more),
                   .second = (float)(around ? r * r + more : r * r - more),
                   .side = around ? -1 : 1,
                   .doubt = (float)doubt};
    return r > 1e-12 && r < 1e12 && distance < 1e12 && (around || distance > 1.001 * r);
}

// Some spheres as floats, and where they are on the screen, by the rectangles of step 6.
static void see_spheres(void *given, int part)
{
    FloatScene *scene = given;
    const Scene *from = scene->work->scene;
    const Camera *camera = &scene->work->camera;
    Positions positions = {0};
    Places places;
    int begin = part * PLACES, count = least(from->sphere_count - begin, PLACES);
    for (int i = 0; i < count; i++) {
        const Sphere *sphere = &from->spheres[scene->hierarchy.order[begin + i]];
        vec3 c = sphere->center - camera->origin;
        position_set(&positions, i, c, sphere->radius);
        if (!set_seen(&scene->seen[begin + i], camera, c, sphere->radius))
            atomic_store(&scene->badly, true);
        scene->seen[begin + i].color = scene->colors[sphere->surface];
    }
    scene->lanes->place(&scene->eye, &positions, count, &places);
    for (int i = 0; i < count; i++) {
        Seen *seen = &scene->seen[begin + i];
        seen->left = places.left[i] / BLOCK;
        seen->top = places.top[i] / BLOCK;
        seen->right = (unsigned short)((places.right[i] + BLOCK - 1) / BLOCK);
        seen->bottom = (unsigned short)((places.bottom[i] + BLOCK - 1) / BLOCK);
    }
}

static void see_boxes(void *given, int part)
{
    FloatScene *scene = given;
    for (int i = part * PLACES; i < (part + 1) * PLACES && i < scene->hierarchy.node_count; i++) {
        Box box = scene->hierarchy.nodes[i].box;
        double more = 0;
        for (int axis = 0; axis < 3; axis++) {
            box.low[axis] -= scene->view.eye[axis];
            box.high[axis] -= scene->view.eye[axis];
            more = fmax(more, 0x1p-19 * fmax(-box.low[axis], box.high[axis]));
        }
        for (int axis = 0; axis < 3; axis++) {
            scene->boxes[i].low[axis] = (float)(box.low[axis] - more);
            scene->boxes[i].high[axis] = (float)(box.high[axis] + more);
        }
    }
}

static int parts(int of, int size)
{
    return (of + size - 1) / size;
}

static void set_view(FloatScene *scene, bool wide)
{
    Camera camera = scene->work->camera;
    Resolution screen = scene->work->image->size;
    double width = camera.width / camera.distance, height = camera.height / camera.distance;
    View *view = &scene->view;
    *view = (View){.nodes = scene->work->scene->sphere_count > 0 ? scene->hierarchy.nodes : NULL,
                   .wide = wide ? &scene->wide : NULL,
                   .boxes = scene->boxes,
                   .seen = scene->seen,
                   .background = scene->colors[scene->work->scene->surface_count],
                   .columns = parts(screen.width, BLOCK),
                   .rows = parts(screen.height, BLOCK),
                   .x = scene->x,
                   .y = scene->y};
    view_store(view->eye, camera.origin);
    view_store(view->right, camera.right);
    view_store(view->up, camera.up);
    view_store(view->ahead, camera.forward);
    for (int i = 0; i < screen.width + TILE; i++)
        scene->x[i] = (float)(((i + 0.5) / screen.width - 0.5) * width);
    for (int i = 0; i < screen.height + TILE; i++)
        scene->y[i] = (float)((0.5 - (i + 0.5) / screen.height) * height);
}

// False if there is not enough memory. Free it in both cases.
static bool build(FloatScene *scene, const Work *work, Walk *walk, bool wide)
{
    const Resolution size = work->image->size;
    *scene = (FloatScene){.work = work,
                          .walk = walk,
                          .lanes = LANES_BEST(bins),
                          .colors = colors_of(work->scene),
                          .eye = eye_of(work)};
    scene->seen = malloc(((size_t)work->scene->sphere_count + 1) * sizeof *scene->seen);
    scene->x = malloc(((size_t)size.width + TILE) * sizeof *scene->x);
    scene->y = malloc(((size_t)size.height + TILE) * sizeof *scene->y);
    return scene->colors != NULL && scene->seen != NULL && scene->x != NULL && scene->y != NULL &&
           hierarchy_build(&scene->hierarchy, work->scene, wide ? BOXES : SMALL_LEAF) &&
           (wide ? wide_build(&scene->wide, &scene->hierarchy)
                 : (scene->boxes = malloc((size_t)scene->hierarchy.node_count *
                                          sizeof *scene->boxes)) != NULL);
}

static void destroy(FloatScene *scene)
{
    free(scene->y);
    free(scene->x);
    free(scene->boxes);
    free(scene->seen);
    free(scene->colors);
    wide_free(&scene->wide);
    hierarchy_free(&scene->hierarchy);
}

// ---- the picture ------------------------------------------------------------------------------

// Step 3 decides the pixels in doubt, in double.
static void cast_tile(void *given, int part)
{
    const FloatScene *scene = given;
    const Work *work = scene->work;
    Image *image = work->image;
    int across = parts(image->size.width, TILE);
    Tile tile = {.column = part % across * TILE_BLOCKS, .row = part / across * TILE_BLOCKS};
    scene->walk(&scene->view, &tile);
    int left = tile.column * BLOCK, top = tile.row * BLOCK;
    int right = least(left + TILE, image->size.width);
    int bottom = least(top + TILE, image->size.height);
    scene->lanes->paint(tile.colors, TILE, right - left, bottom - top,
                        image_bytes(image, (Pixel){left, top}), 3 * (size_t)image->size.width);
    for (int row = top; tile.doubts && row < bottom; row++)
        for (int column = left; column < right; column++) {
            Pixel pixel = {column, row};
            if (tile.colors[(row - top) * TILE + column - left] != IN_DOUBT)
                continue;
            Hit hit = hierarchy_nearest(&scene->hierarchy, work->scene,
                                        pixel_ray(work->camera, image->size, pixel));
            paint_pixel(image, image_index(image, pixel), work->scene, scene->colors, hit.sphere);
        }
}

// If floats are not good enough at all, step 3 casts the picture. That is also the case for rays
// nearly at right angles to the view.
static bool cast_by(const Work *work, Message *message, Walk *walk, bool wide)
{
    if (extreme_scene(work))
        return cast_extreme(work, message);
    FloatScene scene;
    Resolution screen = work->image->size;
    Camera camera = work->camera;
    bool ready = build(&scene, work, walk, wide);
    if (work->built != NULL)
        *work->built = clock_seconds();
    if (!ready) {
        message_set(message, "no memory for a hierarchy of %d spheres", work->scene->sphere_count);
    } else {
        set_view(&scene, wide);
        in_parallel(work->threads, parts(work->scene->sphere_count, PLACES), see_spheres, &scene);
        if (!wide)
            in_parallel(work->threads, parts(scene.hierarchy.node_count, PLACES), see_boxes,
                        &scene);
        if (scene.badly || camera.width > 500 * camera.distance ||
            camera.height > 500 * camera.distance)
            ready = cast_bvh(work, message);
        else
            in_parallel(work->threads, parts(screen.width, TILE) * parts(screen.height, TILE),
                        cast_tile, &scene);
    }
    destroy(&scene);
    return ready;
}

bool cast_packet(const Work *work, Message *message)
{
    return cast_by(work, message, LANES_BEST(walk_packets), false);
}

bool cast_tiles(const Work *work, Message *message)
{
    return cast_by(work, message, LANES_BEST(walk_frustum), true);
}
