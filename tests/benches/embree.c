// embree.c - Embree 3 as a peer: its own sphere points, and user geometry with a test of 16 lanes.
//
// Built for this machine's instructions (-march=native), as Embree is. It takes only fields of
// what it is given, never a vec3 by value. EMBREE_CONFIG in the environment is added to Embree's
// configuration: isa=avx2, for example, is Embree on a processor without AVX-512.
#include "tests/benches/embree.h"
#include "chapters/08-fast/engines/engine.h"
#include "common/clock.h"

#include <stdio.h>
#include <stdlib.h>

enum { LANES = 16, TILE = 4 }; // packets of 4 x 4 pixels, or 4 x 2

typedef struct {
    const Work *work;
    const int *colors;
    EmbreeSpheres spheres;
    int lanes;
    float eye[3], corner[3], right[3], down[3]; // directions: corner + column right + row down
} Peer;

// ---- spheres ---------------------------------------------------------------------------------

static void bounds_of(const struct RTCBoundsFunctionArguments *of)
{
    const float *s = (const float *)of->geometryUserPtr + 4 * (size_t)of->primID;
    *of->bounds_o = (struct RTCBounds){s[0] - s[3], s[1] - s[3], s[2] - s[3], 0,
                                       s[0] + s[3], s[1] + s[3], s[2] + s[3], 0};
}

// Embree's packets of N rays are arrays of N numbers, in this order (struct RTCRayHit16); a packet
// that only asks whether its rays hit anything ends after the flags.
enum { FROM = 0, NEAR = 3, WAY = 4, FAR = 8, PRIMITIVE = 17, GEOMETRY = 18 };

// The discriminant from the ray's distance, r^2 - |l|^2: in float the textbook's loses its digits.
// numbers is NULL if it only matters that there is a hit: Embree's sign for that is tfar below 0.
static inline void ask(int n, const int *valid, float *restrict packet, const float *s,
                       const unsigned *numbers)
{
    const float *from = packet + FROM * n, *way = packet + WAY * n, *near = packet + NEAR * n;
    float *far = packet + FAR * n;
    unsigned *primitive = (unsigned *)packet + PRIMITIVE * n;
    unsigned *geometry = (unsigned *)packet + GEOMETRY * n;
    float x = s[0], y = s[1], z = s[2], r = s[3];
#pragma omp simd
    for (int i = 0; i < n; i++) {
        float dx = way[i], dy = way[n + i], dz = way[2 * n + i];
        float fx = x - from[i], fy = y - from[n + i], fz = z - from[2 * n + i];
        float a = 1 / (dx * dx + dy * dy + dz * dz);
        float middle = (fx * dx + fy * dy + fz * dz) * a;
        float lx = fx - middle * dx, ly = fy - middle * dy, lz = fz - middle * dz;
        float D = (r * r - (lx * lx + ly * ly + lz * lz)) * a;
        float half = __builtin_sqrtf(D > 0 ? D : 0);
        float t = middle - half > near[i] ? middle - half : middle + half;
        int hit = (valid[i] != 0) & (D >= 0) & (t > near[i]) & (t < far[i]);
        far[i] = hit ? (numbers != NULL ? t : -INFINITY) : far[i];
        if (numbers != NULL) {
            primitive[i] = hit ? numbers[0] : primitive[i];
            geometry[i] = hit ? numbers[1] : geometry[i];
        }
    }
}

// Embree divides a call for 16 rays into packets as large as the processor's vectors: 16 with
// AVX-512, 8 with AVX, otherwise 4. If the size is a constant, the compiler makes vectors.
static inline void ask_packet(unsigned n, const int *valid, void *packet, const float *sphere,
                              const unsigned *numbers)
{
    if (n == 16)
        ask(16, valid, packet, sphere, numbers);
    else if (n == 8)
        ask(8, valid, packet, sphere, numbers);
    else
        ask((int)n, valid, packet, sphere, numbers);
}

static void ask_nearest(const struct RTCIntersectFunctionNArguments *of)
{
    const float *spheres = of->geometryUserPtr;
    const unsigned numbers[] = {of->primID, of->geomID};
    ask_packet(of->N, of->valid, of->rayhit, spheres + 4 * (size_t)of->primID, numbers);
}

static void ask_any(const struct RTCOccludedFunctionNArguments *of)
{
    const float *spheres = of->geometryUserPtr;
    ask_packet(of->N, of->valid, of->ray, spheres + 4 * (size_t)of->primID, NULL);
}

// With user geometry or Embree's own spheres.
static bool build(EmbreeSpheres *to, const Scene *scene, int threads, bool user)
{
    char config[80];
    const char *more = getenv("EMBREE_CONFIG");
    snprintf(config, sizeof config, "threads=%d,set_affinity=0,%s", threads, more ? more : "");
    size_t count = (size_t)scene->sphere_count;
    *to = (EmbreeSpheres){.device = rtcNewDevice(config),
                          .spheres = malloc((count + 1) * 4 * sizeof *to->spheres)};
    if (to->device == NULL || to->spheres == NULL)
        return false;
    for (size_t i = 0; i < count; i++) {
        for (int k = 0; k < 3; k++)
            to->spheres[4 * i + (size_t)k] = (float)scene->spheres[i].center[k];
        to->spheres[4 * i + 3] = (float)scene->spheres[i].radius;
    }
    double began = clock_seconds();
    RTCGeometry geometry =
        rtcNewGeometry(to->device, user ? RTC_GEOMETRY_TYPE_USER : RTC_GEOMETRY_TYPE_SPHERE_POINT);
    to->scene = rtcNewScene(to->device);
    if (user) {
        rtcSetGeometryUserPrimitiveCount(geometry, (unsigned)count);
        rtcSetGeometryUserData(geometry, to->spheres);
        rtcSetGeometryBoundsFunction(geometry, bounds_of, NULL);
        rtcSetGeometryIntersectFunction(geometry, ask_nearest);
        rtcSetGeometryOccludedFunction(geometry, ask_any);
    } else {
        rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT4,
                                   to->spheres, 0, 4 * sizeof(float), count);
    }
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(to->scene, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(to->scene);
    measured.build += clock_seconds() - began;
    return rtcGetDeviceError(to->device) == RTC_ERROR_NONE;
}

bool embree_spheres(EmbreeSpheres *spheres, const Scene *scene, int threads)
{
    return build(spheres, scene, threads, true);
}

void embree_free(EmbreeSpheres *spheres)
{
    rtcReleaseScene(spheres->scene);
    rtcReleaseDevice(spheres->device);
    free(spheres->spheres);
}

// ---- rays ------------------------------------------------------------------------------------

static void set_rays(Peer *peer)
{
    const Camera *camera = &peer->work->camera;
    Resolution size = peer->work->image->size;
    for (int i = 0; i < 3; i++) {
        double right = camera->width / size.width * camera->right[i];
        double down = -camera->height / size.height * camera->up[i];
        peer->eye[i] = (float)camera->origin[i];
        peer->right[i] = (float)right;
        peer->down[i] = (float)down;
        peer->corner[i] =
            (float)(camera->distance * camera->forward[i] + (0.5 - size.width / 2.0) * right +
                    (0.5 - size.height / 2.0) * down);
    }
}

static void paint(const Peer *peer, int column, int row, unsigned geometry, unsigned sphere)
{
    Image *image = peer->work->image;
    paint_pixel(image, image_index(image, (Pixel){column, row}), peer->work->scene, peer->colors,
                geometry == RTC_INVALID_GEOMETRY_ID ? -1 : (int)sphere);
}

// Packets of RTCRayHit8 and RTCRayHit16 differ in type only.
#define CAST_PACKET(N)                                                                             \
    static void cast_packet_##N(const Peer *peer, int left, int top)                               \
    {                                                                                              \
        struct RTCRayHit##N packet;                                                                \
        int valid[N];                                                                              \
        Resolution size = peer->work->image->size;                                                 \
        for (int i = 0; i < N; i++) {                                                              \
            int column = left + i % TILE, row = top + i / TILE;                                    \
            valid[i] = column < size.width && row < size.height ? -1 : 0;                          \
            float x = (float)column, y = (float)row;                                               \
            packet.ray.org_x[i] = peer->eye[0];                                                    \
            packet.ray.org_y[i] = peer->eye[1];                                                    \
            packet.ray.org_z[i] = peer->eye[2];                                                    \
            packet.ray.dir_x[i] = peer->corner[0] + x * peer->right[0] + y * peer->down[0];        \
            packet.ray.dir_y[i] = peer->corner[1] + x * peer->right[1] + y * peer->down[1];        \
            packet.ray.dir_z[i] = peer->corner[2] + x * peer->right[2] + y * peer->down[2];        \
            packet.ray.tnear[i] = packet.ray.time[i] = 0;                                          \
            packet.ray.tfar[i] = INFINITY;                                                         \
            packet.ray.mask[i] = ~0u;                                                              \
            packet.ray.id[i] = packet.ray.flags[i] = 0;                                            \
            packet.hit.geomID[i] = packet.hit.instID[0][i] = RTC_INVALID_GEOMETRY_ID;              \
        }                                                                                          \
        struct RTCIntersectContext context;                                                        \
        rtcInitIntersectContext(&context);                                                         \
        context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;                                       \
        rtcIntersect##N(valid, peer->spheres.scene, &context, &packet);                            \
        for (int i = 0; i < N; i++)                                                                \
            if (valid[i] != 0)                                                                     \
                paint(peer, left + i % TILE, top + i / TILE, packet.hit.geomID[i],                 \
                      packet.hit.primID[i]);                                                       \
    }
CAST_PACKET(8)
CAST_PACKET(16)

static void cast_band(void *given, int band)
{
    const Peer *peer = given;
    int rows = peer->lanes / TILE;
    for (int left = 0; left < peer->work->image->size.width; left += TILE)
        (peer->lanes == 8 ? cast_packet_8 : cast_packet_16)(peer, left, band * rows);
}

static bool cast(const Work *work, Message *message, int lanes, bool user)
{
    int *colors = colors_of(work->scene);
    Peer peer = {.work = work, .colors = colors, .lanes = lanes};
    if (colors == NULL || !build(&peer.spheres, work->scene, work->threads, user))
        return message_set(message, "Embree cannot be set up");
    set_rays(&peer);
    double began = clock_seconds();
    int rows = lanes / TILE;
    in_parallel(work->threads, (work->image->size.height + rows - 1) / rows, cast_band, &peer);
    measured.cast = clock_seconds() - began;
    embree_free(&peer.spheres);
    free(colors);
    return true;
}

bool cast_embree_8(const Work *work, Message *message)
{
    return cast(work, message, 8, false);
}
bool cast_embree_16(const Work *work, Message *message)
{
    return cast(work, message, 16, false);
}
bool cast_embree_user(const Work *work, Message *message)
{
    return cast(work, message, 16, true);
}
