// peers.c - the list of peers.
#include "tests/benches/measure.h"

const Engine peers[] = {
    {"embree-8", "Embree's sphere points, 8 rays at a time", cast_embree_8, NULL},
    {"embree-16", "Embree's sphere points, 16 rays at a time", cast_embree_16, NULL},
    {"embree-user", "Embree's hierarchy, 16 rays a call, a test of our own", cast_embree_user,
     NULL},
    {"povray", "POV-Ray", cast_povray, NULL},
    {"tachyon", "Tachyon", cast_tachyon, NULL},
    {0},
};
