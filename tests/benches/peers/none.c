// none.c - no peers: the engines by themselves.
#include "tests/benches/measure.h"

const Engine peers[] = {{0}};
