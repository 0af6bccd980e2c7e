// pages.c - reads the text of a PDF of slides, as pdftohtml -xml prints it, and tells what it
// found.
//
//   pdftohtml -xml -i -zoom 10 -stdout slides.pdf | pages QUESTION
//
//   titles     the largest text of each page, once for pages in a row that have the same
//   exercises  the text that names the exercise, likewise; 'page 7: none' if a page has none
//   small      each text below 24 of 540 units of a page's height, with its page and its size
//   notes      each page that has no text in its right half
//
// Text outside the page, which Beamer puts there until its step comes, does not count.
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_FONTS = 5000, LONGEST = 4000 };

typedef struct {
    int number;
    double width, height;
    char title[LONGEST], exercise[LONGEST];
    int title_size;
    bool has_right_half;
} Page;

static int font_sizes[MOST_FONTS];
static const char *question;

// The number of an attribute, NAME="12"; 0 if there is none.
static double attribute(const char *line, const char *name)
{
    char wanted[40];
    snprintf(wanted, sizeof wanted, " %s=\"", name);
    const char *at = strstr(line, wanted);
    return at == NULL ? 0 : strtod(at + strlen(wanted), NULL);
}

// The words between the tags of a line.
static void words_of(const char *line, char words[LONGEST])
{
    size_t n = 0;
    bool inside = false;
    for (; *line != '\0' && *line != '\n' && n + 1 < LONGEST; line++) {
        if (*line == '<' || *line == '>')
            inside = *line == '<';
        else if (!inside)
            words[n++] = *line;
    }
    words[n] = '\0';
}

static void text(Page *page, const char *line)
{
    char words[LONGEST];
    double left = attribute(line, "left"), top = attribute(line, "top");
    int font = (int)attribute(line, "font");
    words_of(line, words);
    if (left < 0 || left >= page->width || top < 0 || top >= page->height || font >= MOST_FONTS ||
        strspn(words, " ") == strlen(words))
        return;
    int size = font_sizes[font];
    if (size > page->title_size) {
        page->title_size = size;
        strcpy(page->title, words);
    }
    if (strncmp(words, "Exercise", 8) == 0)
        strcpy(page->exercise, words);
    page->has_right_half |= left > page->width / 2;
    // pdftohtml cuts the digits off.
    int least = (int)(24 * page->height / 540);
    if (strcmp(question, "small") == 0 && size < least)
        printf("page %d: %.1f units: %s\n", page->number, size * 540 / page->height, words);
}

static void page_ends(const Page *page)
{
    static char last[LONGEST];
    if (strcmp(question, "titles") == 0 && strcmp(page->title, last) != 0)
        printf("%s\n", strcpy(last, page->title));
    if (strcmp(question, "exercises") == 0 && page->exercise[0] == '\0')
        printf("page %d: none\n", page->number);
    else if (strcmp(question, "exercises") == 0 && strcmp(page->exercise, last) != 0)
        printf("%s\n", strcpy(last, page->exercise));
    if (strcmp(question, "notes") == 0 && !page->has_right_half)
        printf("page %d\n", page->number);
}

int main(int argc, char **argv)
{
    static char line[LONGEST];
    Page page = {0};
    question = argc == 2 ? argv[1] : "";
    if (strstr(" titles exercises small notes ", question) == NULL || question[0] == '\0') {
        fprintf(stderr, "Usage: %s titles|exercises|small|notes\n", argv[0]);
        return 2;
    }
    while (fgets(line, sizeof line, stdin) != NULL) {
        if (strncmp(line, "<page ", 6) == 0)
            page = (Page){.number = (int)attribute(line, "number"),
                          .width = attribute(line, "width"),
                          .height = attribute(line, "height")};
        else if (strstr(line, "<fontspec ") != NULL && attribute(line, "id") < MOST_FONTS)
            font_sizes[(int)attribute(line, "id")] = (int)attribute(line, "size");
        else if (strncmp(line, "<text ", 6) == 0)
            text(&page, line);
        else if (strncmp(line, "</page>", 7) == 0)
            page_ends(&page);
    }
    if (page.number == 0) {
        fprintf(stderr, "%s: no page\n", argv[0]);
        return 1;
    }
    return 0;
}
