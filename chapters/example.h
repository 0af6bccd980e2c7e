// example.h - the numbers of the example that the whole lecture uses.
//
// To lecture with other numbers, change them here and run make. The programs, the lessons, their
// figures and pictures, the slides, and the tests that use the example follow. All numbers are the
// deck's, 'Ray Tracing, Part I'. Programs take them through chapters/shared/example.h.

#ifndef CHAPTERS_EXAMPLE_H
#define CHAPTERS_EXAMPLE_H

// The slide 'Camera': the eye p, and three unit vectors at right angles to each other.
#define EXAMPLE_EYE 2, 2, -4
#define EXAMPLE_RIGHT 1, 0, 0
#define EXAMPLE_UP 0, 1, 0
#define EXAMPLE_FORWARD 0, 0, 1
// The image plane: d, w and h, each greater than 0.
#define EXAMPLE_DISTANCE 4
#define EXAMPLE_WIDTH 2
#define EXAMPLE_HEIGHT 2

// A place on the image plane, across from the left and up from the bottom, from 0 to 1. (The deck's
// question, and the function across_30_up_10, always ask for 30% and 10%.)
#define EXAMPLE_PLACE 0.3, 0.1

// The slide 'Normalized screen coordinates': the size of the screen in pixels, and a point (x, y)
// on it. In chapter 04 it is the pixel (column, row), so both are whole numbers.
#define EXAMPLE_SCREEN 640, 480
#define EXAMPLE_POINT 300, 400

// The slide 'Intersecting a ray and a sphere'. The ray must meet the sphere twice, in front of p.
#define EXAMPLE_RAY_ORIGIN -4, -1, 0
#define EXAMPLE_RAY_DIRECTION 0.89, 0.45, 0
#define EXAMPLE_CENTER 0, 0, 0
#define EXAMPLE_RADIUS 1

#endif
