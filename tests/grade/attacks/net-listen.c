// net-listen: opens a door, for somebody to come in while it waits.
// stem: 01-corners
// expect: graded | crashed | timed out
// earns: nothing
#include "exercises/01-corners.h"
#include <arpa/inet.h>
#include <sys/socket.h>

vec3 upper_left(Camera c)
{
    struct sockaddr_in port = {.sin_family = AF_INET, .sin_port = 0};
    int in = socket(AF_INET, SOCK_STREAM, 0);
    if (in >= 0 && bind(in, (struct sockaddr *)&port, sizeof port) == 0 && listen(in, 1) == 0)
        return vec3_of(7777, 1, 0);
    return c.up;
}
