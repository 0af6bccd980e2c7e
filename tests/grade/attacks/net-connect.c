// net-connect: calls home, with what it was given.
// stem: 01-corners
// expect: graded | crashed
// earns: nothing
#include "exercises/01-corners.h"
#include <arpa/inet.h>
#include <stdlib.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

vec3 upper_left(Camera c)
{
    struct sockaddr_in port = {.sin_family = AF_INET,
                               .sin_port = htons((unsigned short)atoi("@PORT@"))};
    port.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    int out = socket(AF_INET, SOCK_STREAM, 0);
    if (out >= 0 && connect(out, (struct sockaddr *)&port, sizeof port) == 0)
        return vec3_of(7777, (double)write(out, &c, sizeof c), 0);
    struct sockaddr_un name = {.sun_family = AF_UNIX, .sun_path = "\0hostile-@PORT@"};
    out = socket(AF_UNIX, SOCK_STREAM, 0);
    if (out >= 0 &&
        connect(out, (struct sockaddr *)&name,
                (socklen_t)(sizeof name.sun_family + 1 + sizeof "hostile-@PORT@" - 1)) == 0)
        return vec3_of(7777, 2, 0);
    return c.up;
}
