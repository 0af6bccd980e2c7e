// net-names: asks the network for a name, and sends a packet without being connected.
// stem: 01-corners
// expect: graded | crashed | timed out
// earns: nothing
#include "exercises/01-corners.h"
#include <arpa/inet.h>
#include <netdb.h>
#include <stdlib.h>
#include <sys/socket.h>

vec3 upper_left(Camera c)
{
    struct addrinfo *found = NULL;
    if (getaddrinfo("example.org", "80", NULL, &found) == 0)
        return vec3_of(7777, 1, 0);
    struct sockaddr_in port = {.sin_family = AF_INET,
                               .sin_port = htons((unsigned short)atoi("@PORT@"))};
    port.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    int out = socket(AF_INET, SOCK_DGRAM, 0);
    if (out >= 0 && sendto(out, "x", 1, 0, (struct sockaddr *)&port, sizeof port) == 1)
        return vec3_of(7777, 2, 0);
    return c.up;
}
