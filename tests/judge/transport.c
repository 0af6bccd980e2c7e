// transport.c - a call by the transport that was chosen.
#include "tests/judge/transport.h"

#include "tests/judge/message.h"

static const Transport *transport;

void transport_use(const Transport *wanted)
{
    transport = wanted;
}

Wire *transport_begin(int exercise)
{
    return transport->begin(exercise);
}

Wire *transport_answer(int exercise)
{
    transport->send(exercise);
    return transport->receive(exercise);
}

void transport_finish(int exercise)
{
    if (transport->finish != NULL)
        transport->finish(exercise);
}

void transport_call(int exercise, void *result, void *const *arguments)
{
    put_arguments(transport_begin(exercise), exercise, arguments);
    get_results(transport_answer(exercise), exercise, result, arguments);
    transport_finish(exercise);
}
