// image.h - for the tests of images: an image, and a folder of its own to write it to.
#ifndef TESTS_COMMON_IMAGE_H
#define TESTS_COMMON_IMAGE_H

#include "common/image.h"
#include "tests/judge/test.h"

#include <dirent.h>
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static inline Image image_of(int width, int height)
{
    Image image;
    Message message;
    if (!image_create(&image, (Resolution){width, height}, &message))
        ck_abort_msg("%s", message.text);
    return image;
}

// No two neighbours are alike, nor are red, green and blue.
static inline Image pattern_of(int width, int height)
{
    Image image = image_of(width, height);
    for (int i = 0; i < 3 * width * height; i++)
        image.rgb[i] = (uint8_t)(i * 37 + i / 256);
    return image;
}

static char folder[200];

static inline void folder_begin(void)
{
    const char *temporary = getenv("TMPDIR");
    snprintf(folder, sizeof folder, "%.150s/image-XXXXXX", temporary != NULL ? temporary : "/tmp");
    ck_assert_ptr_nonnull(mkdtemp(folder));
}

typedef struct {
    char s[500];
} Path;

static inline Path in_folder(const char *name)
{
    Path path;
    snprintf(path.s, sizeof path.s, "%s/%s", folder, name);
    return path;
}

// How many files the folder holds.
static inline int files_in_folder(void)
{
    DIR *open = opendir(folder);
    ck_assert_ptr_nonnull(open);
    int count = 0;
    for (struct dirent *entry; (entry = readdir(open)) != NULL;)
        count += strcmp(entry->d_name, ".") != 0 && strcmp(entry->d_name, "..") != 0;
    closedir(open);
    return count;
}

static inline void folder_end(void)
{
    DIR *open = opendir(folder);
    ck_assert_ptr_nonnull(open);
    for (struct dirent *entry; (entry = readdir(open)) != NULL;)
        remove(in_folder(entry->d_name).s);
    closedir(open);
    ck_assert_int_eq(rmdir(folder), 0);
}

static inline void put_file(const char *path, const char *text)
{
    FILE *file = fopen(path, "wb");
    ck_assert_ptr_nonnull(file);
    ck_assert_int_ge(fputs(text, file), 0);
    ck_assert_int_eq(fclose(file), 0);
}

static inline void expect_file(const char *path, const char *text)
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

static inline void expect_written(const Image *image, const char *path)
{
    Message message = {""};
    given("path", "%s", path);
    expect_law(image_write_png(image, path, &message), "written", "%s", message.text);
}

static inline void expect_not_written(const Image *image, const char *path, const char *words)
{
    Message message = {""};
    given("path", "%s", path);
    expect_law(!image_write_png(image, path, &message), "refused", "written");
    given("path", "%s", path);
    expect_law(strstr(message.text, path) == message.text && strstr(message.text, words) != NULL,
               words, "%s", message.text);
}

#endif
