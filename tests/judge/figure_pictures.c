// figure_pictures.c - a picture that is wrong: yours, what was expected, and where they differ.
#include "tests/judge/figure.h"

#include "common/image.h"
#include "tests/judge/picture_panels.h"

#include <string.h>

// After the scene and the camera comes the image; the results are its pixels.
bool write_pictures(Wrong *wrong, const char *path)
{
    Scene scene;
    Camera camera;
    Image yours, right = {0};
    Message message;
    wire_get_value(wrong->question, &type_Scene, &scene);
    wire_free_value(&type_Scene, &scene);
    WIRE_GET(wrong->question, Camera, camera);
    wire_get_value(wrong->question, &type_Image, &yours);
    bool good = !wrong->question->bad && image_create(&right, yours.size, &message);
    if (good) {
        wire_get_pixels(wrong->yours, &yours);
        wire_get_pixels(wrong->right, &right);
        size_t bytes = 3 * (size_t)right.size.width * (size_t)right.size.height;
        good = !wrong->yours->bad && !wrong->right->bad &&
               memcmp(yours.rgb, right.rgb, bytes) != 0 &&
               picture_panels_write(&yours, &right, 0, path);
    }
    image_free(&right);
    image_free(&yours);
    return good;
}
