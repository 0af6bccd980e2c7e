// no_embree.c - instead of embree.c if Embree 3 is not installed.
#include "tests/benches/measure.h"

bool embree_is_here(void)
{
    return false;
}

bool cast_embree_8(const Work *work, Message *message)
{
    (void)work;
    return message_set(message, "Embree 3 is not installed");
}

bool cast_embree_16(const Work *work, Message *message)
{
    return cast_embree_8(work, message);
}

bool cast_embree_user(const Work *work, Message *message)
{
    return cast_embree_8(work, message);
}

bool light_embree(const Work *work, Style style, Message *message)
{
    (void)style;
    return cast_embree_8(work, message);
}
