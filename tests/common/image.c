// image.c - tests of common/image.c, common/image_png.c and common/screen.h.
// Expected: the conventions that they declare. What was written is read back by libpng itself.
#include "common/image.h"
#include "common/whole_file.h"

#include "tests/judge/test.h"

#include <dirent.h>
#include <errno.h>
#include <png.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

// ---- an image, and a folder of its own for a test -------------------------------------------

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

static char folder[200];

static void folder_begin(void)
{
    const char *temporary = getenv("TMPDIR");
    snprintf(folder, sizeof folder, "%.150s/image-XXXXXX", temporary != NULL ? temporary : "/tmp");
    ck_assert_ptr_nonnull(mkdtemp(folder));
}

typedef struct {
    char s[500];
} Path;

static Path in_folder(const char *name)
{
    Path path;
    snprintf(path.s, sizeof path.s, "%s/%s", folder, name);
    return path;
}

// How many files the folder holds.
static int files_in_folder(void)
{
    DIR *open = opendir(folder);
    ck_assert_ptr_nonnull(open);
    int count = 0;
    for (struct dirent *entry; (entry = readdir(open)) != NULL;)
        count += strcmp(entry->d_name, ".") != 0 && strcmp(entry->d_name, "..") != 0;
    closedir(open);
    return count;
}

static void folder_end(void)
{
    DIR *open = opendir(folder);
    ck_assert_ptr_nonnull(open);
    for (struct dirent *entry; (entry = readdir(open)) != NULL;)
        remove(in_folder(entry->d_name).s);
    closedir(open);
    ck_assert_int_eq(rmdir(folder), 0);
}

static void put_file(const char *path, const char *text)
{
    FILE *file = fopen(path, "wb");
    ck_assert_ptr_nonnull(file);
    ck_assert_int_ge(fputs(text, file), 0);
    ck_assert_int_eq(fclose(file), 0);
}

static void expect_file(const char *path, const char *text)
{
    char found[100] = "";
    FILE *file = fopen(path, "rb");
    given("file", "%s", path);
    expect_law(file != NULL, "the older file", "%s", strerror(errno));
    found[fread(found, 1, sizeof found - 1, file)] = '\0';
    fclose(file);
    given("file", "%s", path);
    expect_text(found, text);
}

static void expect_written(const Image *image, const char *path)
{
    Message message = {""};
    given("path", "%s", path);
    expect_law(image_write_png(image, path, &message), "written", "%s", message.text);
}

static void expect_not_written(const Image *image, const char *path, const char *words)
{
    Message message = {""};
    given("path", "%s", path);
    expect_law(!image_write_png(image, path, &message), "refused", "written");
    given("path", "%s", path);
    expect_law(strstr(message.text, path) == message.text && strstr(message.text, words) != NULL,
               words, "%s", message.text);
}

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

// ---- the picture as a file ------------------------------------------------------------------

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

// ---- where it cannot be written -------------------------------------------------------------

// A device to write to. Root gets a copy of it in the folder: should the code ever rename over
// devices again, the machine's own would be gone. An empty path, said aloud, where there is none.
static Path device(const char *name)
{
    Path path;
    struct stat status;
    snprintf(path.s, sizeof path.s, "/dev/%s", name);
    if (getuid() != 0)
        return path;
    Path copy = in_folder(name);
    if (stat(path.s, &status) == 0 && mknod(copy.s, S_IFCHR | 0666, status.st_rdev) == 0 &&
        chmod(copy.s, 0666) == 0) {
        FILE *file = fopen(copy.s, "wb");
        if (file != NULL) {
            fclose(file);
            return copy;
        }
    }
    printf("skipped: writing to %s as root, who cannot make another such device\n", path.s);
    fflush(stdout);
    return (Path){""};
}

static void expect_device(const char *path)
{
    struct stat status;
    ck_assert_int_eq(lstat(path, &status), 0);
    given("path", "%s", path);
    expect_law(S_ISCHR(status.st_mode), "a device still", "mode %o", (unsigned)status.st_mode);
}

START_TEST(a_full_device_is_reported_and_stays_a_device)
{
    // Small pictures fail when the file is flushed, large ones before.
    Image images[] = {pattern_of(2, 2), pattern_of(300, 300)};
    folder_begin();
    Path full = device("full");
    for (int i = 0; i < 2; i++) {
        if (full.s[0] != '\0') {
            expect_not_written(&images[i], full.s, strerror(ENOSPC));
            expect_device(full.s);
        }
        image_free(&images[i]);
    }
    folder_end();
}
END_TEST

START_TEST(a_device_is_written_to)
{
    Image image = pattern_of(300, 300);
    folder_begin();
    Path null = device("null");
    if (null.s[0] != '\0') {
        expect_written(&image, null.s);
        expect_device(null.s);
    }
    image_free(&image);
    folder_end();
}
END_TEST

START_TEST(a_link_to_a_device_stays_and_so_does_the_device)
{
    Image image = pattern_of(2, 2);
    struct stat status;
    folder_begin();
    Path full = device("full"), link = in_folder("link.png");
    if (full.s[0] != '\0') {
        ck_assert_int_eq(symlink(full.s, link.s), 0);
        expect_not_written(&image, link.s, strerror(ENOSPC));
        ck_assert_int_eq(lstat(link.s, &status), 0);
        ck_assert(S_ISLNK(status.st_mode));
        expect_device(full.s);
    }
    image_free(&image);
    folder_end();
}
END_TEST

START_TEST(a_folder_is_no_picture)
{
    Image image = pattern_of(2, 2);
    folder_begin();
    expect_not_written(&image, folder, "is a folder");
    expect_int(files_in_folder(), 0);
    image_free(&image);
    folder_end();
}
END_TEST

START_TEST(a_folder_that_is_missing_is_named)
{
    Image image = pattern_of(2, 2);
    folder_begin();
    expect_not_written(&image, in_folder("no/such/a.png").s, strerror(ENOENT));
    put_file(in_folder("file").s, "older");
    expect_not_written(&image, in_folder("file/a.png").s, strerror(ENOTDIR));
    expect_file(in_folder("file").s, "older");
    expect_int(files_in_folder(), 1);
    image_free(&image);
    folder_end();
}
END_TEST

// In a child, which may give up its rights and its limits for good.
static void expect_in_child(bool (*holds)(const Image *), const Image *image)
{
    fflush(NULL);
    pid_t child = fork();
    ck_assert_int_ge(child, 0);
    if (child == 0)
        _exit(holds(image) ? 0 : 1);
    int status;
    ck_assert_int_eq(waitpid(child, &status, 0), child);
    ck_assert(WIFEXITED(status));
    ck_assert_int_eq(WEXITSTATUS(status), 0);
}

// Root may write everywhere, so it becomes somebody else; where it cannot, this says so.
static bool becomes_nobody(void)
{
    if (getuid() != 0 || (setgid(65534) == 0 && setuid(65534) == 0))
        return true;
    printf("skipped: folders and files that are read-only, since root cannot be another user\n");
    fflush(stdout);
    return false;
}

static bool is_refused_read_only(const Image *image)
{
    Message message = {""};
    if (!becomes_nobody())
        return true;
    return !image_write_png(image, in_folder("new.png").s, &message) &&
           strstr(message.text, strerror(EACCES)) != NULL &&
           !file_path_is_writable(in_folder("new.png").s, &message) &&
           !image_write_png(image, in_folder("old.png").s, &message) &&
           strstr(message.text, strerror(EACCES)) != NULL;
}

START_TEST(a_read_only_folder_is_refused_and_the_older_picture_stays)
{
    Image image = pattern_of(2, 2);
    folder_begin();
    put_file(in_folder("old.png").s, "older");
    ck_assert_int_eq(chmod(folder, 0555), 0);
    expect_in_child(is_refused_read_only, &image);
    ck_assert_int_eq(chmod(folder, 0755), 0);
    expect_file(in_folder("old.png").s, "older");
    expect_int(files_in_folder(), 1);
    image_free(&image);
    folder_end();
}
END_TEST

START_TEST(a_read_only_picture_is_refused_and_stays)
{
    Image image = pattern_of(2, 2);
    folder_begin();
    put_file(in_folder("old.png").s, "older");
    put_file(in_folder("new.png").s, "older");
    ck_assert_int_eq(chmod(in_folder("old.png").s, 0444), 0);
    ck_assert_int_eq(chmod(in_folder("new.png").s, 0444), 0);
    ck_assert_int_eq(chmod(folder, 0777), 0);
    expect_in_child(is_refused_read_only, &image);
    expect_file(in_folder("old.png").s, "older");
    expect_file(in_folder("new.png").s, "older");
    expect_int(files_in_folder(), 2);
    image_free(&image);
    folder_end();
}
END_TEST

// A limit on the size of files breaks a write in the middle, as a full disk does.
static bool is_broken_in_the_middle(const Image *image)
{
    Message message = {""};
    signal(SIGXFSZ, SIG_IGN);
    if (setrlimit(RLIMIT_FSIZE, &(struct rlimit){5000, 5000}) != 0)
        return false;
    return !image_write_png(image, in_folder("old.png").s, &message) &&
           strstr(message.text, strerror(EFBIG)) != NULL &&
           !image_write_png(image, in_folder("new.png").s, &message);
}

START_TEST(a_write_that_breaks_in_the_middle_leaves_the_older_picture_and_nothing_else)
{
    Image image = image_of(200, 200);
    for (int i = 0; i < 3 * 200 * 200; i++)
        image.rgb[i] = (uint8_t)random_number(0, 256); // so that it is not compressed
    folder_begin();
    put_file(in_folder("old.png").s, "older");
    expect_in_child(is_broken_in_the_middle, &image);
    expect_file(in_folder("old.png").s, "older");
    expect_int(files_in_folder(), 1);
    image_free(&image);
    folder_end();
}
END_TEST

START_TEST(whether_a_path_can_be_written_is_known_before_any_work)
{
    Message message = {""};
    folder_begin();
    ck_assert_int_eq(chdir(folder), 0);
    put_file(in_folder("old.png").s, "older");
    ck_assert(file_path_is_writable(in_folder("old.png").s, &message));
    ck_assert(file_path_is_writable(in_folder("new.png").s, &message));
    ck_assert(file_path_is_writable("new.png", &message));
    ck_assert(file_path_is_writable("/dev/full", &message));
    ck_assert_str_eq(message.text, "");
    ck_assert(!file_path_is_writable(folder, &message));
    ck_assert_ptr_nonnull(strstr(message.text, "is a folder"));
    ck_assert(!file_path_is_writable(in_folder("no/a.png").s, &message));
    ck_assert_ptr_nonnull(strstr(message.text, strerror(ENOENT)));
    ck_assert(!file_path_is_writable(in_folder("old.png/").s, &message));
    ck_assert_ptr_nonnull(strstr(message.text, strerror(ENOTDIR)));
    expect_file(in_folder("old.png").s, "older");
    expect_int(files_in_folder(), 1);
    folder_end();
}
END_TEST

void list_tests(void)
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
    tests_of("image_write_png");
    test(a_picture_is_read_back_as_it_was_written);
    test(of_whatever_number_of_colours_a_picture_is_read_back_as_it_was_written);
    test(the_first_row_of_the_file_is_the_top_one);
    test(the_same_image_gives_the_same_file);
    test(an_older_picture_is_replaced_and_keeps_its_permissions);
    test(a_new_picture_has_the_permissions_of_a_new_file);
    test(through_a_link_the_file_is_replaced_and_the_link_stays);
    test(names_may_hold_spaces_and_need_no_folder);
    test(a_full_device_is_reported_and_stays_a_device);
    test(a_device_is_written_to);
    test(a_link_to_a_device_stays_and_so_does_the_device);
    test(a_folder_is_no_picture);
    test(a_folder_that_is_missing_is_named);
    test(a_read_only_folder_is_refused_and_the_older_picture_stays);
    test(a_read_only_picture_is_refused_and_stays);
    test(a_write_that_breaks_in_the_middle_leaves_the_older_picture_and_nothing_else);
    tests_of("file_path_is_writable");
    test(whether_a_path_can_be_written_is_known_before_any_work);
}
