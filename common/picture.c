// picture.c - the loop over all pixels, and the end of every program that draws.
#include "common/picture.h"

#include "common/answers.h"
#include "common/options.h"
#include "common/whole_file.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

Resolution picture_shaped(double width, double height, int side)
{
    double longer = fmax(width, height);
    return (Resolution){(int)fmax(2, round(side * (width / longer))),
                        (int)fmax(2, round(side * (height / longer)))};
}

int picture_save(const Image *image, const char *path)
{
    Message message;
    if (answers_report() != 0) {
        fprintf(stderr, "%s: not drawn, since an answer is missing\n", path);
        return EXIT_COULD_NOT;
    }
    if (!image_write_png(image, path, &message)) {
        fprintf(stderr, "%s\n", message.text);
        return EXIT_COULD_NOT;
    }
    return EXIT_DONE;
}

int picture_write(const char *path, Resolution size, Color (*color)(Pixel pixel, void *given),
                  void *given)
{
    Image image;
    Message message;
    if (!file_path_is_writable(path, &message) || !image_create(&image, size, &message)) {
        fprintf(stderr, "%s\n", message.text);
        return EXIT_COULD_NOT;
    }
    for (int row = 0; row < size.height; row++)
        for (int column = 0; column < size.width; column++)
            image_set(&image, (Pixel){column, row}, color((Pixel){column, row}, given));
    int status = picture_save(&image, path);
    image_free(&image);
    return status;
}

const char *picture_program_folder(const char *program)
{
    static char folder[4096];
    const char *slash = strrchr(program, '/');
    if (slash == NULL || (size_t)(slash - program) >= sizeof folder)
        return ".";
    memcpy(folder, program, (size_t)(slash - program));
    folder[slash - program] = '\0';
    return slash == program ? "/" : folder;
}
