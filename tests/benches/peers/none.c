// none.c - no peers: the engines by themselves.
#include "tests/benches/measure.h"

const Engine peers[] = {{0}};

bool peer_is_here(const Engine *peer, Message *message)
{
    (void)peer, (void)message;
    return false;
}
