// image.c - tests of common/image.c, common/image_png.c and common/whole_file.c: colors, the image
// in memory, the picture as a file. Expected: the conventions that they declare; the same picture,
// read back by libpng itself. What the programs say of their files is in
// tests/house/command_line.txt; which row is the top one is seen in every picture of a lesson.
#include "common/image.h"

#include "common/whole_file.h"
#include "tests/judge/test.h"

#include <png.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

static Image image_of(int width, int height)
{
    Image image;
    Message message;
    if (!image_create(&image, (Resolution){width, height}, &message))
        ck_abort_msg("%s", message.text);
    return image;
}

// No two neighbours are alike, nor are red, green and blue.
static Image pattern_of(int width, int height)
{
    Image image = image_of(width, height);
    for (int i = 0; i < 3 * width * height; i++)
        image.rgb[i] = (uint8_t)(i * 37 + i / 256);
    return image;
}

// ---- colors and pixels ---------------------------------------------------------------------

TEST(byte_from_color, a_byte_is_255_times_the_color_rounded)
{
    for (int byte = 0; byte < 256; byte++) {
        given_number("color", byte / 255.0);
        expect_int(byte_from_color(byte / 255.0), byte);
        given_number("color", (byte + 0.49) / 255);
        expect_int(byte_from_color((byte + 0.49) / 255), byte);
        given_number("color", (byte - 0.49) / 255);
        expect_int(byte_from_color((byte - 0.49) / 255), byte);
    }
    given_number("color", 0.5);
    expect_int(byte_from_color(0.5), 128);
    for (int i = 0; i < 1000; i++) {
        double c = random_number(0, 1);
        given_number("color", c);
        expect_int(byte_from_color(c), lround(255 * c));
    }
}

TEST(byte_from_color, colors_outside_0_to_1_are_clamped)
{
    const double low[] = {-0.0, -1e-9, -1, -2, -1e300, -INFINITY};
    const double high[] = {1, 1 + 1e-9, 1.01, 2, 257.0 / 255, 1e300, INFINITY};
    for (int i = 0; i < 6; i++) {
        given_number("color", low[i]);
        expect_int(byte_from_color(low[i]), 0);
    }
    for (int i = 0; i < 7; i++) {
        given_number("color", high[i]);
        expect_int(byte_from_color(high[i]), 255);
    }
}

TEST(byte_from_color, a_color_that_is_no_number_is_black)
{
    expect_int(byte_from_color(NAN), 0);
    expect_int(byte_from_color(copysign(NAN, -1)), 0);
    Image image = pattern_of(1, 1);
    image_set(&image, (Pixel){0, 0}, vec3_of(NAN, 1, NAN));
    expect_vec3(vec3_of(image.rgb[0], image.rgb[1], image.rgb[2]), vec3_of(0, 255, 0), 0);
    image_free(&image);
}

// ---- the image in memory --------------------------------------------------------------------

TEST(image_create, a_new_image_is_black)
{
    Image image = image_of(7, 5);
    expect_pair(image.size.width, image.size.height, 7, 5, 0);
    for (int i = 0; i < 3 * 7 * 5; i++)
        expect_int(image.rgb[i], 0);
    image_free(&image);
    ck_assert_ptr_null(image.rgb);
}

TEST(image_create, impossible_sizes_are_refused)
{
    const Resolution bad[] = {{0, 0},          {0, 5},
                              {5, 0},          {-1, 5},
                              {5, -1},         {-2147483647 - 1, 2147483647},
                              {16385, 1},      {1, 16385},
                              {2147483647, 1}, {1000000000, 1000000000},
                              {65536, 65536},  {-5, -5},
                              {46341, 46341}};
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        Image image;
        Message message = {""};
        char size[40];
        snprintf(size, sizeof size, "%d x %d", bad[i].width, bad[i].height);
        given("size", "%s", size);
        expect_law(!image_create(&image, bad[i], &message), "refused", "an image");
        given("size", "%s", size);
        expect_law(strstr(message.text, size) != NULL && strstr(message.text, "16384") != NULL,
                   "its size, and what is expected", "%s", message.text);
        ck_assert_ptr_null(image.rgb);
        image_free(&image);
    }
}

// The image written to a file, and the file decoded by libpng's simplified interface.
static Image read_back(const Image *image)
{
    char path[] = "/tmp/image-XXXXXX";
    Message message;
    close(mkstemp(path));
    expect_law(image_write_png(image, path, &message), "written", "%s", message.text);
    png_image png = {.version = PNG_IMAGE_VERSION};
    if (png_image_begin_read_from_file(&png, path) == 0)
        ck_abort_msg("%s", png.message);
    // Eight bits of red, green and blue: no alpha, not linear. A palette holds the same.
    ck_assert_uint_eq(png.format & ~PNG_FORMAT_FLAG_COLORMAP, PNG_FORMAT_RGB);
    png.format = PNG_FORMAT_RGB;
    Image found = image_of((int)png.width, (int)png.height);
    if (png_image_finish_read(&png, NULL, found.rgb, 0, NULL) == 0)
        ck_abort_msg("%s", png.message);
    unlink(path);
    return found;
}

TEST(image_write_png, a_picture_is_read_back_as_it_was_written)
{
    const Resolution sizes[] = {{1, 1}, {1, 9}, {9, 1}, {64, 48}, {317, 211}};
    for (int i = 0; i < 5; i++) {
        Image image = pattern_of(sizes[i].width, sizes[i].height), found = read_back(&image);
        given("size", "%d x %d", image.size.width, image.size.height);
        expect_pair(found.size.width, found.size.height, image.size.width, image.size.height, 0);
        expect_same_image(&found, &image);
        image_free(&found);
        image_free(&image);
    }
}

// Half of the file is written when the signal comes.
static bool write_and_raise(FILE *file, const void *given, const char *path, Message *message)
{
    (void)path;
    (void)message;
    fputs("half of it", file);
    fflush(file);
    raise(*(const int *)given);
    return true;
}

TEST(file_write_whole, a_program_that_a_signal_ends_leaves_the_older_file)
{
    char path[] = "/tmp/image-XXXXXX", found[10] = "";
    int older = mkstemp(path), status;
    ck_assert_int_eq(write(older, "older", 5), 5);
    pid_t child = fork();
    ck_assert_int_ge(child, 0);
    if (child == 0) {
        signal(SIGTERM, SIG_DFL); // Check's own handler would end the tests
        file_write_whole(path, write_and_raise, &(int){SIGTERM}, &(Message){""});
    }
    ck_assert_int_eq(waitpid(child, &status, 0), child);
    expect_law(WIFSIGNALED(status) && WTERMSIG(status) == SIGTERM, "ended by the signal",
               "wait status %d", status);
    FILE *file = fopen(path, "rb");
    ck_assert_ptr_nonnull(file);
    found[fread(found, 1, sizeof found - 1, file)] = '\0';
    expect_text(found, "older");
    fclose(file);
    close(older);
    unlink(path);
}
