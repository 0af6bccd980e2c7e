// trees.c - how good are the trees? The boxes and spheres that rays visit, without any clock.
//
// One plain function walks all trees, with the same rays and spheres, so only the trees differ. The
// nearer box comes first, and no box beyond the nearest hit. Embree's tree and ours have the same
// form for this: nodes of 8 boxes, and leaves of one sphere. The third tree has the form that rays
// from anywhere really walk in chapter 08: 16 boxes or 16 spheres, which are asked at once.
//
// Embree's tree: rtcBuildBVH, with the settings that its user geometry has by default. To see that
// it is the right tree, Embree's own walk counts the spheres that it asks.
#include "tests/benches/peers/trees.h"
#include "chapters/08-fast/engines/wide_hierarchy.h"
#include "common/large_pages.h"

#include <embree3/rtcore.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { WIDTH = 8 };

// ---- trees ------------------------------------------------------------------------------------

// A box with the boxes of a node in it, from first on; or spheres, from first on.
typedef struct {
    Box box;
    int first, count;
    bool leaf;
} Branch;

typedef struct {
    Branch *branches; // the root is the first
    float *spheres;   // x, y, z and r, in the order of the leaves
    int branch_count, sphere_count;
} Tree;

static void *memory(size_t count, size_t size)
{
    void *found = large_memory(count * size + 1);
    if (found == NULL)
        exit(1);
    return found;
}

// Each node has at least two boxes.
static Tree tree_for(int spheres)
{
    return (Tree){.branches = memory(2 * (size_t)spheres, sizeof(Branch)),
                  .spheres = memory(4 * (size_t)spheres, sizeof(float)),
                  .branch_count = 1};
}

static void tree_free(Tree *tree)
{
    free(tree->branches);
    free(tree->spheres);
}

static void add_sphere(Tree *tree, const float *sphere)
{
    for (int i = 0; i < 4; i++)
        tree->spheres[4 * (size_t)tree->sphere_count + (size_t)i] = sphere[i];
    tree->sphere_count++;
}

// Room for the boxes of a node; returns the first.
static int add_boxes(Tree *tree, Branch *node, int count)
{
    node->leaf = false;
    node->first = tree->branch_count;
    node->count = count;
    tree->branch_count += count;
    return node->first;
}

static void add_spheres(Tree *tree, const Hierarchy *hierarchy, const float *spheres)
{
    for (int i = 0; i < hierarchy->nodes[0].count; i++)
        add_sphere(tree, spheres + 4 * (size_t)hierarchy->order[i]);
}

// ---- chapter 08's -----------------------------------------------------------------------------

// As Embree fills its nodes: the largest box is opened, until there are 8.
static int open_boxes(const Node *nodes, int node, int *below)
{
    int count = 2;
    below[0] = node + 1;
    below[1] = nodes[node].other;
    while (count < WIDTH) {
        int largest = -1;
        double most = -1;
        for (int i = 0; i < count; i++) {
            double size = box_surface(&nodes[below[i]].box);
            if (nodes[below[i]].other != 0 && size > most) {
                largest = i;
                most = size;
            }
        }
        if (largest < 0)
            break;
        below[count++] = nodes[below[largest]].other;
        below[largest]++;
    }
    return count;
}

static void add_nodes(Tree *tree, int at, const Node *nodes, int node)
{
    Branch *branch = &tree->branches[at];
    const Node *from = &nodes[node];
    *branch = (Branch){from->box, from->first, from->count, true};
    if (from->other == 0)
        return;
    int below[WIDTH], count = open_boxes(nodes, node, below);
    int first = add_boxes(tree, branch, count);
    for (int i = 0; i < count; i++)
        add_nodes(tree, first + i, nodes, below[i]);
}

static Tree our_tree(const Scene *scene, const float *spheres)
{
    Tree tree = tree_for(scene->sphere_count);
    Hierarchy hierarchy;
    if (!hierarchy_build(&hierarchy, scene, 1, 1))
        exit(1);
    add_nodes(&tree, 0, hierarchy.nodes, 0);
    add_spheres(&tree, &hierarchy, spheres);
    hierarchy_free(&hierarchy);
    return tree;
}

static void add_wide(Tree *tree, int at, const WideNode *nodes, int node)
{
    const WideNode *from = &nodes[node];
    int first = add_boxes(tree, &tree->branches[at], from->boxes);
    for (int i = 0; i < from->boxes; i++) {
        Branch *branch = &tree->branches[first + i];
        *branch = (Branch){.first = from->first[i], .count = from->count[i], .leaf = true};
        for (int axis = 0; axis < 3; axis++) {
            double middle = from->corner[axis] + (double)from->middle[axis][i];
            branch->box.low[axis] = middle - (double)from->half[axis][i];
            branch->box.high[axis] = middle + (double)from->half[axis][i];
        }
        if (branch->count == 0)
            add_wide(tree, first + i, nodes, from->first[i]);
    }
}

static Tree our_wide_tree(const Hierarchy *hierarchy, const float *spheres)
{
    Tree tree = tree_for(hierarchy->nodes[0].count);
    WideCount count;
    WideNode *nodes = wide_build(hierarchy, 1, LANES, 1, &count);
    if (nodes == NULL)
        exit(1);
    add_wide(&tree, 0, nodes, 0);
    add_spheres(&tree, hierarchy, spheres);
    free(nodes);
    return tree;
}

// ---- Embree's ---------------------------------------------------------------------------------

typedef struct {
    struct RTCBounds bounds[WIDTH];
    void *below[WIDTH];
    unsigned count;  // 0: a leaf
    unsigned sphere; // of a leaf
} PeerNode;

static void *create_node(RTCThreadLocalAllocator allocator, unsigned count, void *given)
{
    (void)given;
    PeerNode *node = rtcThreadLocalAlloc(allocator, sizeof *node, 16);
    node->count = count;
    return node;
}

static void *create_leaf(RTCThreadLocalAllocator allocator, const struct RTCBuildPrimitive *spheres,
                         size_t count, void *given)
{
    if (count != 1)
        exit(1);
    PeerNode *leaf = create_node(allocator, 0, given);
    leaf->sphere = spheres->primID;
    return leaf;
}

static void set_bounds(void *node, const struct RTCBounds **bounds, unsigned count, void *given)
{
    (void)given;
    for (unsigned i = 0; i < count; i++)
        ((PeerNode *)node)->bounds[i] = *bounds[i];
}

static void set_below(void *node, void **below, unsigned count, void *given)
{
    (void)given;
    for (unsigned i = 0; i < count; i++)
        ((PeerNode *)node)->below[i] = below[i];
}

static void add_peer(Tree *tree, int at, const PeerNode *node, const float *spheres)
{
    Branch *branch = &tree->branches[at];
    if (node->count == 0) {
        branch->leaf = true;
        branch->first = tree->sphere_count;
        branch->count = 1;
        add_sphere(tree, spheres + 4 * (size_t)node->sphere);
        return;
    }
    int first = add_boxes(tree, branch, (int)node->count);
    for (unsigned i = 0; i < node->count; i++) {
        struct RTCBounds b = node->bounds[i];
        tree->branches[first + (int)i].box =
            (Box){{b.lower_x, b.lower_y, b.lower_z}, {b.upper_x, b.upper_y, b.upper_z}};
        add_peer(tree, first + (int)i, node->below[i], spheres);
    }
}

static struct RTCBounds bounds_of(const float *s)
{
    return (struct RTCBounds){s[0] - s[3], s[1] - s[3], s[2] - s[3], 0,
                              s[0] + s[3], s[1] + s[3], s[2] + s[3], 0};
}

// Embree 3.13.5, with AVX, for user geometry in a scene of medium quality, which is the default:
// BVH8Factory::BVH8UserGeometry calls BVH8VirtualSceneBuilderSAH (bvh_builder_sah.cpp), blocks of 8
// and a cost of 1; object_accel_min_leaf_size and _max_leaf_size are 1 (state.cpp); maxDepth is
// maxBuildDepthLeaf (bvh_builder.cpp, bvh.h). rtcBuildBVH calls the same BVHBuilderBinnedSAH.
static Tree peer_tree(RTCDevice device, const float *spheres, int count)
{
    Tree tree = tree_for(count);
    struct RTCBuildPrimitive *primitives = memory((size_t)count, sizeof *primitives);
    for (int i = 0; i < count; i++) {
        struct RTCBounds b = bounds_of(spheres + 4 * (size_t)i);
        primitives[i] = (struct RTCBuildPrimitive){b.lower_x, b.lower_y, b.lower_z, 0,
                                                   b.upper_x, b.upper_y, b.upper_z, (unsigned)i};
    }
    RTCBVH bvh = rtcNewBVH(device);
    struct RTCBuildArguments arguments = rtcDefaultBuildArguments();
    arguments.buildQuality = RTC_BUILD_QUALITY_MEDIUM;
    arguments.maxBranchingFactor = WIDTH;
    arguments.maxDepth = 40;
    arguments.sahBlockSize = 8;
    arguments.minLeafSize = arguments.maxLeafSize = 1;
    arguments.traversalCost = arguments.intersectionCost = 1;
    arguments.bvh = bvh;
    arguments.primitives = primitives;
    arguments.primitiveCount = arguments.primitiveArrayCapacity = (size_t)count;
    arguments.createNode = create_node;
    arguments.setNodeChildren = set_below;
    arguments.setNodeBounds = set_bounds;
    arguments.createLeaf = create_leaf;
    const PeerNode *root = rtcBuildBVH(&arguments);
    if (root == NULL)
        exit(1);
    add_peer(&tree, 0, root, spheres);
    rtcReleaseBVH(bvh);
    free(primitives);
    return tree;
}

// ---- the walk ---------------------------------------------------------------------------------

// All rays of a kind together.
typedef struct {
    double nodes, boxes, leaves, spheres;
    int hits;
} Visits;

typedef struct {
    double near;
    int branch;
} Waiting;
enum { MOST_WAITING = HIERARCHY_DEEPEST * LANES };

// Where a ray meets a sphere, in double; infinite if it does not.
static double meet_sphere(const float *sphere, const float *origin, const float *direction)
{
    double along = 0, outside = 0, from[3], r = sphere[3];
    for (int i = 0; i < 3; i++) {
        from[i] = (double)sphere[i] - (double)origin[i];
        along += from[i] * (double)direction[i];
    }
    for (int i = 0; i < 3; i++) {
        double off = from[i] - along * (double)direction[i];
        outside += off * off;
    }
    double half = sqrt(r * r - outside); // NaN if it misses
    double t = along - half > 0 ? along - half : along + half;
    return t > 0 ? t : INFINITY;
}

// Where a ray enters a box; infinite if it does not. The slabs of bvh.c. inverse: 1 / direction.
static double enter(const Box *box, const Single *ray, const double *inverse)
{
    double near = 0, far = INFINITY;
    for (int i = 0; i < 3; i++) {
        double a = (box->low[i] - (double)ray->origin[i]) * inverse[i];
        double b = (box->high[i] - (double)ray->origin[i]) * inverse[i];
        double begin = a < b ? a : b, end = a < b ? b : a;
        near = begin > near ? begin : near;
        far = end < far ? end : far;
    }
    return near <= far ? near : INFINITY;
}

// Adds the boxes that a ray enters, the nearest last; or in the order of the node.
static int add_waiting(Waiting *waiting, int count, const Tree *tree, const Branch *node,
                       const Single *ray, bool sorted)
{
    const int bottom = count;
    double inverse[3];
    for (int i = 0; i < 3; i++)
        inverse[i] = 1 / (double)ray->direction[i];
    for (int i = node->first; i < node->first + node->count; i++) {
        double near = enter(&tree->branches[i].box, ray, inverse);
        if (near == INFINITY)
            continue;
        int at = count++;
        for (; sorted && at > bottom && waiting[at - 1].near < near; at--)
            waiting[at] = waiting[at - 1];
        waiting[at] = (Waiting){near, i};
    }
    return count;
}

static void walk(const Tree *tree, const Single *ray, bool any, bool sorted, Visits *visits)
{
    Waiting waiting[MOST_WAITING];
    int count = 0;
    double nearest = ray->reach;
    waiting[count++] = (Waiting){0, 0};
    while (count > 0 && !(any && nearest < ray->reach)) {
        Waiting next = waiting[--count];
        const Branch *branch = &tree->branches[next.branch];
        if (next.near > nearest)
            continue;
        if (!branch->leaf) {
            visits->nodes++;
            visits->boxes += branch->count;
            count = add_waiting(waiting, count, tree, branch, ray, sorted);
            continue;
        }
        visits->leaves++;
        visits->spheres += branch->count;
        for (int i = branch->first; i < branch->first + branch->count; i++)
            nearest = fmin(nearest,
                           meet_sphere(tree->spheres + 4 * (size_t)i, ray->origin, ray->direction));
    }
    visits->hits += nearest < ray->reach;
}

static Visits walk_all(const Tree *tree, const RayKind *kind, bool sorted)
{
    Visits visits = {0};
    for (int i = 0; i < kind->count; i++)
        walk(tree, &kind->rays[i], kind->any, sorted, &visits);
    return visits;
}

// ---- Embree's own walk ------------------------------------------------------------------------

typedef struct {
    const float *spheres;
    long asked;
} Asked;

static void give_bounds(const struct RTCBoundsFunctionArguments *of)
{
    const Asked *asked = of->geometryUserPtr;
    *of->bounds_o = bounds_of(asked->spheres + 4 * (size_t)of->primID);
}

// Whether one sphere is hit within the ray; then it ends there.
static bool ask(Asked *asked, unsigned sphere, struct RTCRay *ray)
{
    float origin[3] = {ray->org_x, ray->org_y, ray->org_z};
    float direction[3] = {ray->dir_x, ray->dir_y, ray->dir_z};
    double t = meet_sphere(asked->spheres + 4 * (size_t)sphere, origin, direction);
    asked->asked++;
    if (!(t < (double)ray->tfar))
        return false;
    ray->tfar = (float)t;
    return true;
}

static void ask_nearest(const struct RTCIntersectFunctionNArguments *of)
{
    struct RTCRayHit *to = (struct RTCRayHit *)of->rayhit;
    if (of->valid[0] != 0 && ask(of->geometryUserPtr, of->primID, &to->ray))
        to->hit.geomID = of->geomID;
}

static void ask_any(const struct RTCOccludedFunctionNArguments *of)
{
    struct RTCRay *ray = (struct RTCRay *)of->ray;
    if (of->valid[0] != 0 && ask(of->geometryUserPtr, of->primID, ray))
        ray->tfar = -INFINITY;
}

static RTCScene user_scene(RTCDevice device, Asked *asked, int count)
{
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_USER);
    RTCScene scene = rtcNewScene(device);
    rtcSetGeometryUserPrimitiveCount(geometry, (unsigned)count);
    rtcSetGeometryUserData(geometry, asked);
    rtcSetGeometryBoundsFunction(geometry, give_bounds, NULL);
    rtcSetGeometryIntersectFunction(geometry, ask_nearest);
    rtcSetGeometryOccludedFunction(geometry, ask_any);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(scene);
    return scene;
}

// The spheres that Embree asks for all rays of a kind.
static double ask_embree(RTCScene scene, Asked *asked, const RayKind *kind)
{
    struct RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    asked->asked = 0;
    for (int i = 0; i < kind->count; i++) {
        const float *origin = kind->rays[i].origin, *direction = kind->rays[i].direction;
        struct RTCRayHit ray = {.ray = {.org_x = origin[0],
                                        .org_y = origin[1],
                                        .org_z = origin[2],
                                        .dir_x = direction[0],
                                        .dir_y = direction[1],
                                        .dir_z = direction[2],
                                        .tfar = kind->rays[i].reach,
                                        .mask = ~0U}};
        ray.hit.geomID = ray.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
        if (kind->any)
            rtcOccluded1(scene, &context, &ray.ray);
        else
            rtcIntersect1(scene, &context, &ray);
    }
    return (double)asked->asked;
}

// ---- comparing --------------------------------------------------------------------------------

enum { EMBREE, OURS, WIDE, TREES };

typedef struct {
    Visits trees[TREES];
    double in_order; // spheres of Embree's tree, in the order of Embree's own walk
    double asked;    // by Embree's own walk
} Counts;

static void say_visits(const RayKind *kind, const char *tree, const Visits *visits)
{
    printf("    %-7s %-11s %6.2f %7.2f %7.2f", kind->name, tree, visits->nodes / kind->count,
           visits->boxes / kind->count, visits->spheres / kind->count);
}

static void say_counts(const RayKind *kind, const Counts *counts)
{
    const Visits *embree = &counts->trees[EMBREE], *ours = &counts->trees[OURS];
    const Visits *wide = &counts->trees[WIDE];
    say_visits(kind, "Embree", embree);
    printf("  spheres in Embree's order %.3f, Embree's own walk asks %.3f\n",
           counts->in_order / kind->count, counts->asked / kind->count);
    say_visits(kind, "ours", ours);
    printf("  boxes %.3f times Embree's, spheres %.3f times\n", ours->boxes / embree->boxes,
           ours->spheres / embree->spheres);
    say_visits(kind, "ours, of 16", wide);
    printf("  in %.2f leaves\n", wide->leaves / kind->count);
    if (ours->hits != embree->hits || wide->hits != embree->hits)
        printf("    hits differ: %d, %d and %d\n", embree->hits, ours->hits, wide->hits);
}

// Embree's own walk does not sort boxes if any hit is enough.
static void count_visits(const Tree *tree, int number, const RayKind *kind, Counts *counts)
{
    counts->trees[number] = walk_all(tree, kind, true);
    if (number == EMBREE)
        counts->in_order = walk_all(tree, kind, !kind->any).spheres;
}

TreeRatios compare_trees(const Scene *scene, const Hierarchy *wide, const float *spheres,
                         const RayKind kinds[RAY_KINDS])
{
    RTCDevice device = rtcNewDevice("threads=1,set_affinity=0");
    TreeRatios ratios;
    Counts counts[RAY_KINDS];
    for (int i = 0; i < TREES; i++) {
        Tree tree = i == EMBREE ? peer_tree(device, spheres, scene->sphere_count)
                    : i == OURS ? our_tree(scene, spheres)
                                : our_wide_tree(wide, spheres);
        for (int k = 0; k < RAY_KINDS; k++)
            count_visits(&tree, i, &kinds[k], &counts[k]);
        tree_free(&tree);
    }
    Asked asked = {.spheres = spheres};
    RTCScene user = user_scene(device, &asked, scene->sphere_count);
    printf("  visited per ray        nodes   boxes spheres\n");
    for (int k = 0; k < RAY_KINDS; k++) {
        const Visits *embree = &counts[k].trees[EMBREE], *ours = &counts[k].trees[OURS];
        counts[k].asked = ask_embree(user, &asked, &kinds[k]);
        ratios.boxes[k] = kinds[k].count > 0 ? ours->boxes / embree->boxes : 1;
        ratios.spheres[k] = kinds[k].count > 0 ? ours->spheres / embree->spheres : 1;
        if (kinds[k].count > 0)
            say_counts(&kinds[k], &counts[k]);
    }
    fflush(stdout);
    rtcReleaseScene(user);
    rtcReleaseDevice(device);
    return ratios;
}
