// picture.h - from a function of the pixel to a PNG file, and where pictures go.
#ifndef COMMON_PICTURE_H
#define COMMON_PICTURE_H

#include "common/image.h"

// Colors every pixel and writes the picture. Returns what main returns: 0, or 1 with the reason
// on stderr, a blank that was called among them; then nothing is written.
int picture_write(const char *path, Resolution size, Color (*color)(Pixel pixel, void *given),
                  void *given);

// The size of a picture with the aspect ratio of an image plane: its longer side has this many
// pixels.
Resolution picture_shaped(double width, double height, int side);

// Writes an image unless a blank was called; the same return.
int picture_save(const Image *image, const char *path);

// The folder in which this program lies, as it was called; "." where argv[0] does not say.
// Not for freeing: one static buffer.
const char *picture_program_folder(const char *program);

#endif
