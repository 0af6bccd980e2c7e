// whole_file.c - tests of common/whole_file.c: where a picture cannot be written, or not whole.
// Expected: the older file as it was, and a message with its path and the reason.
#include "common/whole_file.h"

#include "tests/house/common/image.h"

#include <signal.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>

// A device to write to. Root gets a copy of it in the folder: should the code ever rename over
// devices again, the machine's own would be gone. If there is none: an empty path, and a message.
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

static void list_tests(void)
{
    tests_of("image_write_png");
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

OF_STEM(list_tests)
