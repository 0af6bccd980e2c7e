// image_png.c - tests of common/image_png.c: the picture as a file.
// Expected: the same picture, read back by libpng itself.
#include "tests/house/common/image.h"
#include "tests/house/common/other_order.h"

#include <png.h>
#include <sys/stat.h>

// The picture in a file, decoded by libpng's simplified interface.
static Image read_back(const char *path)
{
    png_image png = {.version = PNG_IMAGE_VERSION};
    if (png_image_begin_read_from_file(&png, path) == 0)
        ck_abort_msg("%s", png.message);
    // Eight bits of red, green and blue: no alpha, not linear. A palette holds the same.
    ck_assert_uint_eq(png.format & ~PNG_FORMAT_FLAG_COLORMAP, PNG_FORMAT_RGB);
    png.format = PNG_FORMAT_RGB;
    Image image = image_of((int)png.width, (int)png.height);
    if (png_image_finish_read(&png, NULL, image.rgb, 0, NULL) == 0)
        ck_abort_msg("%s", png.message);
    return image;
}

static void expect_picture(const char *path, const Image *expected)
{
    Image found = read_back(path);
    given("path", "%s", path);
    expect_pair(found.size.width, found.size.height, expected->size.width, expected->size.height,
                0);
    given("path", "%s", path);
    expect_same_image(&found, expected);
    image_free(&found);
}

START_TEST(a_picture_is_read_back_as_it_was_written)
{
    const Resolution sizes[] = {{1, 1}, {1, 9}, {9, 1}, {64, 48}, {317, 211}};
    folder_begin();
    for (int i = 0; i < 5; i++) {
        Image image = pattern_of(sizes[i].width, sizes[i].height);
        expect_written(&image, in_folder("a.png").s);
        expect_picture(in_folder("a.png").s, &image);
        image_free(&image);
    }
    expect_int(files_in_folder(), 1);
    folder_end();
}
END_TEST

START_TEST(of_whatever_number_of_colours_a_picture_is_read_back_as_it_was_written)
{
    const int counts[] = {1, 2, 3, 4, 5, 16, 17, 255, 256, 257, 1000};
    folder_begin();
    for (size_t k = 0; k < sizeof counts / sizeof counts[0]; k++)
        for (int width = 33; width <= 40; width++) {
            // Runs, and single pixels.
            Image image = image_of(width, 61);
            for (int i = 0; i < width * 61; i++) {
                int color = i % 4 == 0 ? i / 2 : i;
                color = (i < 500 ? color / 50 : color) % counts[k];
                image.rgb[3 * i] = (uint8_t)(color * 7);
                image.rgb[3 * i + 1] = (uint8_t)(color / 256 + 3);
                image.rgb[3 * i + 2] = (uint8_t)(255 - color);
            }
            given("colours", "%d", counts[k]);
            expect_written(&image, in_folder("a.png").s);
            expect_picture(in_folder("a.png").s, &image);
            image_free(&image);
        }
    folder_end();
}
END_TEST

// A high picture is encoded in many bands; here are more than are held in memory together.
START_TEST(the_bands_of_a_picture_may_be_encoded_in_any_order)
{
    static uint8_t bytes[2][100000];
    const int counts[] = {3, 200, 1000};
    folder_begin();
    for (int k = 0; k < 3; k++) {
        Image image = image_of(7, 3000);
        for (int i = 0; i < 7 * 3000; i++) {
            image.rgb[3 * i] = (uint8_t)(i / 50 % counts[k]);
            image.rgb[3 * i + 1] = (uint8_t)(i / 50 % counts[k] / 256);
        }
        size_t sizes[2];
        for (int order = 0; order < 2; order++) {
            workers_are(order == 0 ? NULL : last_part_first, order == 0 ? NULL : at_once, 2);
            most_parts = 0;
            expect_written(&image, in_folder("a.png").s);
            expect_picture(in_folder("a.png").s, &image);
            FILE *file = fopen(in_folder("a.png").s, "rb");
            sizes[order] = fread(bytes[order], 1, sizeof bytes[order], file);
            fclose(file);
        }
        expect_law(most_parts > 1, "several bands at a time", "%d", most_parts);
        ck_assert_uint_eq(sizes[0], sizes[1]);
        ck_assert_mem_eq(bytes[0], bytes[1], sizes[0]);
        image_free(&image);
    }
    folder_end();
}
END_TEST

START_TEST(the_first_row_of_the_file_is_the_top_one)
{
    Image image = image_of(2, 2);
    folder_begin();
    image_set(&image, (Pixel){.column = 1, .row = 0}, vec3_of(1, 0.2, 0));
    expect_written(&image, in_folder("a.png").s);
    Image found = read_back(in_folder("a.png").s);
    const uint8_t expected[12] = {0, 0, 0, 255, 51, 0};
    ck_assert_mem_eq(found.rgb, expected, 12);
    image_free(&found);
    image_free(&image);
    folder_end();
}
END_TEST

START_TEST(the_same_image_gives_the_same_file)
{
    Image image = pattern_of(40, 30);
    static char bytes[2][20000];
    size_t lengths[2];
    folder_begin();
    for (int i = 0; i < 2; i++) {
        expect_written(&image, in_folder("a.png").s);
        FILE *file = fopen(in_folder("a.png").s, "rb");
        ck_assert_ptr_nonnull(file);
        lengths[i] = fread(bytes[i], 1, sizeof bytes[i], file);
        fclose(file);
    }
    ck_assert_uint_eq(lengths[0], lengths[1]);
    ck_assert_mem_eq(bytes[0], bytes[1], lengths[0]);
    image_free(&image);
    folder_end();
}
END_TEST

START_TEST(an_older_picture_is_replaced_and_keeps_its_permissions)
{
    Image image = pattern_of(5, 4);
    struct stat status;
    folder_begin();
    Path path = in_folder("a.png");
    put_file(path.s, "older");
    const mode_t modes[] = {0600, 0640, 0664};
    for (int i = 0; i < 3; i++) {
        ck_assert_int_eq(chmod(path.s, modes[i]), 0);
        expect_written(&image, path.s);
        ck_assert_int_eq(stat(path.s, &status), 0);
        ck_assert_uint_eq(status.st_mode & 07777, modes[i]);
    }
    expect_picture(path.s, &image);
    expect_int(files_in_folder(), 1);
    image_free(&image);
    folder_end();
}
END_TEST

START_TEST(a_new_picture_has_the_permissions_of_a_new_file)
{
    Image image = pattern_of(5, 4);
    struct stat status;
    folder_begin();
    umask(027);
    expect_written(&image, in_folder("a.png").s);
    ck_assert_int_eq(stat(in_folder("a.png").s, &status), 0);
    ck_assert_uint_eq(status.st_mode & 07777, 0640);
    ck_assert_uint_eq(umask(0), 027);
    image_free(&image);
    folder_end();
}
END_TEST

START_TEST(through_a_link_the_file_is_replaced_and_the_link_stays)
{
    Image image = pattern_of(5, 4);
    struct stat status;
    folder_begin();
    put_file(in_folder("real.png").s, "older");
    ck_assert_int_eq(symlink("real.png", in_folder("link.png").s), 0);
    expect_written(&image, in_folder("link.png").s);
    ck_assert_int_eq(lstat(in_folder("link.png").s, &status), 0);
    ck_assert(S_ISLNK(status.st_mode));
    ck_assert_int_eq(lstat(in_folder("real.png").s, &status), 0);
    ck_assert(S_ISREG(status.st_mode));
    expect_picture(in_folder("real.png").s, &image);
    expect_int(files_in_folder(), 2);
    image_free(&image);
    folder_end();
}
END_TEST

START_TEST(names_may_hold_spaces_and_need_no_folder)
{
    Image image = pattern_of(5, 4);
    folder_begin();
    ck_assert_int_eq(chdir(folder), 0);
    expect_written(&image, "my %s picture.png");
    expect_picture(in_folder("my %s picture.png").s, &image);
    image_free(&image);
    folder_end();
}
END_TEST

static void list_tests(void)
{
    tests_of("image_write_png");
    test(a_picture_is_read_back_as_it_was_written);
    test(of_whatever_number_of_colours_a_picture_is_read_back_as_it_was_written);
    test(the_bands_of_a_picture_may_be_encoded_in_any_order);
    test(the_first_row_of_the_file_is_the_top_one);
    test(the_same_image_gives_the_same_file);
    test(an_older_picture_is_replaced_and_keeps_its_permissions);
    test(a_new_picture_has_the_permissions_of_a_new_file);
    test(through_a_link_the_file_is_replaced_and_the_link_stays);
    test(names_may_hold_spaces_and_need_no_folder);
}

OF_STEM(list_tests)
