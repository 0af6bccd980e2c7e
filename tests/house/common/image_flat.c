// image_flat.c - tests of common/image_flat.c: images of few colours, encoded while they are drawn.
// Expected: the file of the same picture with bytes of red, green and blue.
#include "common/image_flat.h"
#include "tests/house/common/image.h"

static uint32_t color_of(int i)
{
    return (uint32_t)(i * 40503 % 0xffffff);
}

// The number that a pixel gets among the colours of a picture: areas, and single pixels.
static int which(Pixel pixel, int colors)
{
    return (pixel.column % 7 == 0 ? pixel.column * pixel.row : pixel.row / 9) % colors;
}

static size_t bytes_of(const Image *image, uint8_t *bytes, size_t room)
{
    expect_written(image, in_folder("a.png").s);
    FILE *file = fopen(in_folder("a.png").s, "rb");
    ck_assert_ptr_nonnull(file);
    size_t size = fread(bytes, 1, room, file);
    fclose(file);
    return size;
}

// Draws both images: their pixels have `seen` of the colours.
static void draw(const Image *image, Image *full, int seen)
{
    FlatImage *flat = image_flat(image);
    for (int row = 0; row < full->size.height; row++)
        for (int column = 0; column < full->size.width; column++) {
            Pixel pixel = {column, row};
            uint32_t color = color_of(which(pixel, seen));
            int number = flat_number(flat, color);
            flat->numbers[image_index(image, pixel)] = (uint8_t)number;
            flat_are_seen(flat, 1U << number);
            for (int i = 0; i < 3; i++)
                image_bytes(full, pixel)[i] = (uint8_t)(color >> 8 * i);
        }
}

// The rows are set in steps; the steps from the top, from the bottom, or every other one first.
static void give_rows(const Image *image, int step, int order)
{
    int steps = (image->size.height + step - 1) / step;
    for (int i = 0; i < steps; i++) {
        int k = order == 0      ? i
                : order == 1    ? steps - 1 - i
                : 2 * i < steps ? 2 * i
                                : 2 * (steps - 1 - i) + 1;
        int row = k * step, rest = image->size.height - row;
        flat_rows_are_set(image_flat(image), row, rest < step ? rest : step);
    }
}

static void expect_the_same_file(Resolution size, int colors, int unlikely, int seen, int step,
                                 int order)
{
    static uint8_t bytes[2][200000];
    uint32_t all[2 * FLAT_COLORS];
    for (int i = 0; i < colors; i++)
        all[i] = all[colors + i] = color_of((i + colors - unlikely) % colors);
    Image flat = image_of(size.width, size.height), full = image_of(size.width, size.height);
    ck_assert(image_flatten(&flat, all, unlikely > 0 ? colors : 2 * colors, unlikely));
    draw(&flat, &full, seen);
    give_rows(&flat, step, order);
    size_t sizes[] = {bytes_of(&flat, bytes[0], sizeof bytes[0]),
                      bytes_of(&full, bytes[1], sizeof bytes[1])};
    given("size", "%d x %d", size.width, size.height);
    given("colours", "%d, the first %d unlikely, %d seen", colors, unlikely, seen);
    given("rows", "%d at a time, order %d", step, order);
    expect_int((int)sizes[0], (int)sizes[1]);
    ck_assert_mem_eq(bytes[0], bytes[1], sizes[1]);
    image_unflatten(&flat);
    ck_assert_ptr_null(image_flat(&flat));
    image_free(&flat);
    image_free(&full);
}

START_TEST(the_file_is_that_of_the_same_picture)
{
    const Resolution sizes[] = {{1, 1}, {33, 61}, {40, 64}, {7, 65}, {129, 200}};
    const int counts[] = {1, 2, 3, 4, 5, 16, 17, 32};
    folder_begin();
    for (size_t i = 0; i < sizeof sizes / sizeof sizes[0]; i++)
        for (size_t k = 0; k < sizeof counts / sizeof counts[0]; k++)
            expect_the_same_file(sizes[i], counts[k], 0, counts[k], 32, 0);
    folder_end();
}
END_TEST

START_TEST(the_rows_may_be_set_in_any_order)
{
    const int steps[] = {1, 5, 32, 64, 100, 300};
    folder_begin();
    for (size_t i = 0; i < sizeof steps / sizeof steps[0]; i++)
        for (int order = 0; order < 3; order++)
            expect_the_same_file((Resolution){50, 290}, 6, 0, 6, steps[i], order);
    folder_end();
}
END_TEST

// The palette has the colours that are seen, and no other.
START_TEST(other_colours_may_be_seen_than_expected)
{
    folder_begin();
    const int counts[] = {1, 2, 3, 5, 18};
    for (size_t i = 0; i < sizeof counts / sizeof counts[0]; i++)
        for (int unlikely = 0; unlikely < counts[i]; unlikely += 2)
            for (int seen = 1; seen <= counts[i]; seen += 3)
                expect_the_same_file((Resolution){31, 70}, counts[i], unlikely, seen, 32, 0);
    folder_end();
}
END_TEST

START_TEST(bands_are_encoded_as_soon_as_their_rows_and_the_one_above_are_set)
{
    const uint32_t colors[] = {0, 1};
    Image image = image_of(10, 3 * BAND_ROWS);
    ck_assert(image_flatten(&image, colors, 2, 0));
    FlatImage *flat = image_flat(&image);
    memset(flat->numbers, 0, 10 * 3 * BAND_ROWS);
    flat_rows_are_set(flat, BAND_ROWS, BAND_ROWS);
    ck_assert_ptr_null(flat->bands[1].stream);
    flat_rows_are_set(flat, 0, BAND_ROWS - 1);
    ck_assert_ptr_null(flat->bands[0].stream);
    flat_rows_are_set(flat, BAND_ROWS - 1, 1);
    ck_assert_ptr_nonnull(flat->bands[0].stream);
    ck_assert_ptr_nonnull(flat->bands[1].stream);
    ck_assert_ptr_null(flat->bands[2].stream);
    flat_rows_are_set(flat, 2 * BAND_ROWS, BAND_ROWS);
    ck_assert_ptr_nonnull(flat->bands[2].stream);
    image_unflatten(&image);
    image_free(&image);
}
END_TEST

START_TEST(bands_are_encoded_again_only_if_other_colours_are_seen_than_expected)
{
    const uint32_t colors[] = {7, 3, 5}; // the first one is unlikely
    for (int seen = 1; seen < 8; seen++) {
        Image image = image_of(10, BAND_ROWS);
        ck_assert(image_flatten(&image, colors, 3, 1));
        FlatImage *flat = image_flat(&image);
        memset(flat->numbers, 0, 10 * BAND_ROWS);
        flat_are_seen(flat, (uint32_t)seen);
        flat_rows_are_set(flat, 0, BAND_ROWS);
        uint32_t palette[FLAT_COLORS];
        expect_int(flat_palette(flat, palette), __builtin_popcount((unsigned)seen));
        given("seen", "%d", seen);
        expect_int(flat->bands[0].stream != NULL, seen == 3); // the colours 3 and 5
        image_unflatten(&image);
        image_free(&image);
    }
}
END_TEST

START_TEST(one_image_at_a_time_is_flat)
{
    const uint32_t color = 0;
    Image first = image_of(10, 10), second = image_of(10, 10);
    ck_assert(image_flatten(&first, &color, 1, 0));
    ck_assert(!image_flatten(&second, &color, 1, 0));
    ck_assert_ptr_null(image_flat(&second));
    image_unflatten(&second);
    ck_assert_ptr_nonnull(image_flat(&first));
    image_unflatten(&first);
    ck_assert(image_flatten(&second, &color, 1, 0));
    image_unflatten(&second);
    image_free(&first);
    image_free(&second);
}
END_TEST

START_TEST(an_image_of_many_colours_is_not_flattened)
{
    uint32_t colors[FLAT_COLORS + 1];
    for (int i = 0; i <= FLAT_COLORS; i++)
        colors[i] = color_of(i);
    Image image = image_of(10, 10);
    ck_assert(!image_flatten(&image, colors, FLAT_COLORS + 1, 0));
    ck_assert_ptr_null(image_flat(&image));
    colors[FLAT_COLORS] = colors[0];
    ck_assert(image_flatten(&image, colors, FLAT_COLORS + 1, 0));
    expect_int(image_flat(&image)->color_count, FLAT_COLORS);
    for (int i = 0; i < FLAT_COLORS; i++)
        ck_assert_uint_eq(image_flat(&image)->colors[flat_number(image_flat(&image), colors[i])],
                          colors[i]);
    image_unflatten(&image);
    image_free(&image);
}
END_TEST

static void list_tests(void)
{
    tests_of("image_flat");
    test(the_file_is_that_of_the_same_picture);
    test(the_rows_may_be_set_in_any_order);
    test(other_colours_may_be_seen_than_expected);
    test(bands_are_encoded_as_soon_as_their_rows_and_the_one_above_are_set);
    test(bands_are_encoded_again_only_if_other_colours_are_seen_than_expected);
    test(one_image_at_a_time_is_flat);
    test(an_image_of_many_colours_is_not_flattened);
}

OF_STEM(list_tests)
