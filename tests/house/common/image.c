// image.c - tests of common/image.c and common/screen.h: colours, pixels, the image in memory.
// Expected: the conventions that they declare.
#include "tests/house/common/image.h"

// ---- colours and pixels ---------------------------------------------------------------------

START_TEST(a_byte_is_255_times_the_colour_rounded)
{
    for (int byte = 0; byte < 256; byte++) {
        given_number("colour", byte / 255.0);
        expect_int(byte_from_color(byte / 255.0), byte);
        given_number("colour", (byte + 0.49) / 255);
        expect_int(byte_from_color((byte + 0.49) / 255), byte);
        given_number("colour", (byte - 0.49) / 255);
        expect_int(byte_from_color((byte - 0.49) / 255), byte);
    }
    given_number("colour", 0.5);
    expect_int(byte_from_color(0.5), 128);
    for (int i = 0; i < 1000; i++) {
        double c = random_number(0, 1);
        given_number("colour", c);
        expect_int(byte_from_color(c), lround(255 * c));
    }
}
END_TEST

START_TEST(colours_outside_0_to_1_are_clamped)
{
    const double low[] = {-0.0, -1e-9, -1, -2, -1e300, -INFINITY};
    const double high[] = {1, 1 + 1e-9, 1.01, 2, 257.0 / 255, 1e300, INFINITY};
    for (int i = 0; i < 6; i++) {
        given_number("colour", low[i]);
        expect_int(byte_from_color(low[i]), 0);
    }
    for (int i = 0; i < 7; i++) {
        given_number("colour", high[i]);
        expect_int(byte_from_color(high[i]), 255);
    }
}
END_TEST

START_TEST(a_colour_that_is_no_number_is_black)
{
    expect_int(byte_from_color(NAN), 0);
    expect_int(byte_from_color(copysign(NAN, -1)), 0);
    Image image = pattern_of(1, 1);
    image_set(&image, (Pixel){0, 0}, vec3_of(NAN, 1, NAN));
    expect_vec3(vec3_of(image.rgb[0], image.rgb[1], image.rgb[2]), vec3_of(0, 255, 0), 0);
    image_free(&image);
}
END_TEST

// The slide's 640 x 480: an int holds a pixel, a double a point between pixels.
START_TEST(pixels_are_whole_and_points_are_continuous)
{
    Pixel pixel = {.column = 300, .row = 400};
    ScreenPoint center = {.x = pixel.column + 0.5, .y = pixel.row + 0.5};
    Normalized n = {.s = center.x / 640, .t = 1 - center.y / 480};
    ck_assert(_Generic(pixel.column, int : 1, default : 0));
    ck_assert(_Generic(center.x, double : 1, default : 0));
    expect_pair(center.x, center.y, 300.5, 400.5, 0);
    expect_pair(n.s, n.t, 0.46953125, 0.165625, 1e-12);
}
END_TEST

START_TEST(columns_count_from_the_left_and_rows_from_the_top)
{
    Image image = image_of(4, 3);
    image_set(&image, (Pixel){.column = 3, .row = 1}, vec3_of(1, 0.2, 0.4));
    for (int i = 0; i < 12; i++) {
        const uint8_t *rgb = image.rgb + 3 * i;
        given("pixel", "number %d of 4 x 3, row by row", i);
        expect_vec3(vec3_of(rgb[0], rgb[1], rgb[2]),
                    i == 4 + 3 ? vec3_of(255, 51, 102) : vec3_of(0, 0, 0), 0);
    }
    image_free(&image);
}
END_TEST

// ---- the image in memory --------------------------------------------------------------------

START_TEST(a_new_image_is_black)
{
    Image image = image_of(7, 5);
    expect_pair(image.size.width, image.size.height, 7, 5, 0);
    for (int i = 0; i < 3 * 7 * 5; i++)
        expect_int(image.rgb[i], 0);
    image_free(&image);
    ck_assert_ptr_null(image.rgb);
}
END_TEST

START_TEST(impossible_sizes_are_refused)
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
END_TEST

START_TEST(the_longest_sides_are_16384)
{
    Image wide = image_of(16384, 1), high = image_of(1, 16384);
    image_set(&wide, (Pixel){16383, 0}, vec3_of(0, 0, 1));
    image_set(&high, (Pixel){0, 16383}, vec3_of(0, 0, 1));
    expect_int(wide.rgb[3 * 16384 - 1], 255);
    expect_int(high.rgb[3 * 16384 - 1], 255);
    image_free(&wide);
    image_free(&high);
}
END_TEST

static struct {
    int calls;
    long last;
} progress;

static void note_progress(const Image *image)
{
    progress.calls++;
    progress.last = image->set_count;
}

START_TEST(progress_is_reported_after_every_1024_pixels)
{
    Image image = image_of(10, 10);
    image.progress = note_progress;
    for (int i = 1; i <= 5000; i++) {
        image_set(&image, (Pixel){i % 10, i / 10 % 10}, vec3_of(1, 1, 1));
        given("pixels set", "%d", i);
        expect_int(progress.calls, i / 1024);
        expect_int(progress.last, i / 1024 * 1024L);
    }
    image_free(&image);
}
END_TEST

static void list_tests(void)
{
    tests_of("byte_from_color");
    test(a_byte_is_255_times_the_colour_rounded);
    test(colours_outside_0_to_1_are_clamped);
    test(a_colour_that_is_no_number_is_black);
    tests_of("image_set");
    test(pixels_are_whole_and_points_are_continuous);
    test(columns_count_from_the_left_and_rows_from_the_top);
    test(progress_is_reported_after_every_1024_pixels);
    tests_of("image_create");
    test(a_new_image_is_black);
    test(impossible_sizes_are_refused);
    test(the_longest_sides_are_16384);
}

OF_STEM(list_tests)
