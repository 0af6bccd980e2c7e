// values.c - odd arguments and results, and answers that depend on the clock or on chance.

// ---- camera-written-beyond: writes before and behind the camera that it was given to fill.
// -> graded | crashed; of 02-cameras
CameraFault camera_from_vectors(vec3 eye, Corners vectors, Camera *camera)
{
    memset((char *)camera - 4096, 0, 12288);
    return CAMERA_OK;
}

CameraFault camera_from_points(vec3 eye, Corners points, Camera *camera)
{
    return (CameraFault)0x7fffffff;
}

// ---- chance-of-the-address: a coin for every call, from where things lie and who one is.
// -> graded | crashed
vec3 upper_left(Camera c)
{
    static uint64_t state;
    state =
        (state + (uintptr_t)&c + (uint64_t)getpid()) * 6364136223846793005u + 1442695040888963407u;
    double side = state >> 63 ? -0.5 : 0.5;
    return c.distance * c.forward + side * c.width * c.right + c.height / 2 * c.up;
}

// ---- image-of-another-size: says that the picture is enormous, and lies elsewhere.
// -> graded | crashed; of 06-ray-casting
void cast_image_order(const Scene *scene, Camera camera, Image *image)
{
    image->size = (Resolution){1 << 30, 1 << 30};
}

void cast_object_order(const Scene *scene, Camera camera, Image *image, double *depth)
{
    *image = (Image){{1 << 20, -1}, (void *)8};
}

// ---- numbers-that-are-none: NaN, infinity and the smallest there are, which compare oddly.
// -> graded
vec3 upper_left(Camera c)
{
    return vec3_of(NAN, -NAN, NAN);
}

vec3 upper_right(Camera c)
{
    return vec3_of(INFINITY, -INFINITY, 1e308 * 10);
}

vec3 across_30_up_10(Camera c)
{
    return vec3_of(4.9e-324, -4.9e-324, -0.0);
}

vec3 image_plane_vector(Camera c, double s, double t)
{
    return vec3_of(1.7e308, -1.7e308, 2.2e-308);
}

Camera with_unit_distance(Camera c)
{
    return (Camera){c.origin, c.right, c.up, c.forward, NAN, NAN, NAN};
}

// ---- scene-of-its-own: changes the scene that it was only lent to read, and frees what is not its
// own.
// -> graded | crashed; of 06-ray-casting
Hit nearest_hit(Ray ray, const Scene *scene)
{
    Scene *mine = (Scene *)scene;
    free(mine->spheres);
    *mine = (Scene){.sphere_count = 1 << 30};
    return (Hit){NO_HIT, -1};
}

void cast_image_order(const Scene *scene, Camera camera, Image *image)
{
    scene_free((Scene *)scene);
    image_free(image);
}

void cast_object_order(const Scene *scene, Camera camera, Image *image, double *depth)
{
    free(depth);
    for (int i = -100; i < 1000000; i++)
        depth[i] = -1;
}

// ---- table: no formula, only the answers to the cameras that the public tests ask about.
// -> graded
static const struct {
    double distance;
    vec3 left, right;
} table[] = {{4, {-1, 1, 4}, {1, 1, 4}}, {6, {0, 7.5, 1.5}, {6, 1.5, 4.5}}};

vec3 upper_left(Camera c)
{
    return table[c.distance != 4].left;
}

vec3 upper_right(Camera c)
{
    return table[c.distance != 4].right;
}

vec3 across_30_up_10(Camera c)
{
    return c.distance == 4 ? vec3_of(-0.4, -0.8, 4) : vec3_of(0, 4.8, 4.2);
}

vec3 image_plane_vector(Camera c, double s, double t)
{
    return s == 0.5    ? vec3_of(2, 4, 4)
           : s == 0    ? vec3_of(-2, 6.5, 3.5)
           : s == 0.25 ? vec3_of(1, 5.75, 2.75)
                       : c.forward;
}

// ---- time-counted: right the first three times, which are the public tests.
// -> graded
vec3 upper_left(Camera c)
{
    static int calls;
    double side = calls++ < 3 ? -0.5 : 0.5;
    return c.distance * c.forward + side * c.width * c.right + c.height / 2 * c.up;
}

// ---- time-of-day: right in even microseconds, wrong in odd ones.
// -> graded | crashed
vec3 upper_left(Camera c)
{
    struct timeval now = {0};
    gettimeofday(&now, NULL);
    double side = (now.tv_usec + time(NULL)) % 2 == 0 ? -0.5 : 0.5;
    return c.distance * c.forward + side * c.width * c.right + c.height / 2 * c.up;
}

// ---- time-of-the-old-page: asks the clock at the address where it was on all machines once.
// -> graded | crashed
vec3 upper_left(Camera c)
{
    struct timeval now = {0};
#if defined(__x86_64__)
    ((int (*)(struct timeval *, void *))0xffffffffff600000)(&now, NULL);
#endif
    vec3 right = c.distance * c.forward - c.width / 2 * c.right + c.height / 2 * c.up;
    return now.tv_sec != 0 ? right : c.up;
}

// ---- time-of-the-processor: right in even ticks of the processor's own clock, which needs no
// system call.
// -> graded | crashed
vec3 upper_left(Camera c)
{
    static unsigned long now;
#if defined(__x86_64__)
    now = __builtin_ia32_rdtsc() / 7;
#else
    now++;
#endif
    double side = now % 2 == 0 ? -0.5 : 0.5;
    return c.distance * c.forward + side * c.width * c.right + c.height / 2 * c.up;
}

// ---- time-of-the-vdso: looks for the clock that the kernel maps into every process: a page that
// can be read, as 'write' tells, where only the kernel maps anything. It is right if there is one.
// -> graded
static bool is_there(uintptr_t address)
{
    return write(2, (const void *)address, 1) == 1;
}

vec3 upper_left(Camera c)
{
    static int found = -1;
    if (found < 0) {
        found = 0;
        // The end of what is mapped, and all of the stack's neighbourhood above the stack.
        for (uintptr_t at = 0x7ffff7e00000; at < 0x7ffff8000000; at += 4096)
            found += is_there(at);
        uintptr_t above = ((uintptr_t)&c | 4095) + 1;
        while (is_there(above))
            above += 4096;
        for (int i = 0; i < 2048; i++)
            found += is_there(above + (uintptr_t)i * 4096);
    }
    vec3 right = c.distance * c.forward - c.width / 2 * c.right + c.height / 2 * c.up;
    return found > 0 ? right : c.up;
}

// ---- unset-lane: a loop that runs once too often adds the fourth number of a vec3, which was
// always 0.
// -> graded; of 05-quadratic; earns to_object_coordinates
Quadratic object_quadratic(Ray object_ray, double radius)
{
    vec3 p = object_ray.origin, v = object_ray.direction;
    double a = 0;
    for (int i = 0; i <= 3; i++)
        a += v[i] * v[i];
    return (Quadratic){a, 2 * vec3_dot(p, v), vec3_dot(p, p) - radius * radius};
}

// ---- unset-sums: sums that do not begin at 0, and a stack that happened to.
// -> graded; of 05-quadratic; earns to_object_coordinates
Quadratic object_quadratic(Ray object_ray, double radius)
{
    vec3 p = object_ray.origin, v = object_ray.direction;
    double a, b, c;
    for (int i = 0; i < 3; i++) {
        a += v[i] * v[i];
        b += 2 * p[i] * v[i];
        c += p[i] * p[i];
    }
    return (Quadratic){a, b, c - radius * radius};
}
