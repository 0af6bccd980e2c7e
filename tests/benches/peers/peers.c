// peers.c - the list of peers, and which of them are installed.
#include "tests/benches/measure.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

const Engine peers[] = {
    {"embree-8", "Embree's sphere points, 8 rays at a time", cast_embree_8, NULL},
    {"embree-16", "Embree's sphere points, 16 rays at a time", cast_embree_16, NULL},
    {"embree-user", "Embree's hierarchy, 16 rays a call, a test of our own", cast_embree_user,
     light_embree},
    {"povray", "POV-Ray", cast_povray, light_povray},
    {"tachyon", "Tachyon", cast_tachyon, NULL},
    {0},
};

bool peer_is_here(const Engine *peer, Message *message)
{
    char command[100];
    snprintf(command, sizeof command, "command -v %s >/dev/null 2>&1", peer->name);
    bool is_embree = strncmp(peer->name, "embree", strlen("embree")) == 0;
    return (is_embree ? embree_is_here() : system(command) == 0) ||
           message_set(message, "%s is not installed, so it is not measured: make setup FOR=bench",
                       peer->name);
}
