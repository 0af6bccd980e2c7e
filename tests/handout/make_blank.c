// make_blank.c - makes the blank of an exercise from its solution: make_blank SOLUTION.c >BLANK.c
//
// Between BEGIN SOLUTION and END SOLUTION only the stub lines stay, without their mark '//~'. A
// part that has no stub lines (helpers of the solution) is removed, with its markers and the empty
// line after it.
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char *path;
static int line_number;

static void wrong(const char *what)
{
    fprintf(stderr, "%s:%d: %s\n", path, line_number, what);
    exit(1);
}

static char *without_indent(char *line)
{
    return line + strspn(line, " ");
}

static bool is_marker(char *line, const char *marker)
{
    return strcmp(without_indent(line), marker) == 0;
}

// The line without its mark and the blank after it; if nothing else is left, without its indent.
static void put_stub(char *line)
{
    char *mark = without_indent(line), *rest = mark + 3;
    rest += *rest == ' ';
    size_t length = strlen(rest);
    while (length > 0 && rest[length - 1] == ' ')
        length--;
    if (length > 0)
        printf("%.*s%.*s", (int)(mark - line), line, (int)length, rest);
    printf("\n");
}

static void make_blank(FILE *solution)
{
    char *line = NULL, *begin = NULL;
    size_t size = 0;
    ssize_t length;
    bool inside = false, has_stub = false, dropped = false;
    while ((length = getline(&line, &size, solution)) > 0) {
        line_number++;
        if (line[length - 1] == '\n')
            line[length - 1] = '\0';
        if (is_marker(line, "// BEGIN SOLUTION")) {
            free(begin);
            begin = strdup(line);
            inside = true;
            has_stub = false;
        } else if (is_marker(line, "// END SOLUTION")) {
            if (!inside)
                wrong("END SOLUTION without BEGIN SOLUTION");
            inside = false;
            dropped = !has_stub;
            if (has_stub)
                printf("%s\n", line);
        } else if (inside && strncmp(without_indent(line), "//~", 3) == 0) {
            if (!has_stub)
                printf("%s\n", begin);
            has_stub = true;
            put_stub(line);
        } else if (!inside) {
            if (!dropped || line[0] != '\0')
                printf("%s\n", line);
            dropped = false;
        }
    }
    if (inside)
        wrong("BEGIN SOLUTION without END SOLUTION");
    free(line);
    free(begin);
}

int main(int argc, char **argv)
{
    if (argc != 2) {
        fprintf(stderr, "Usage: %s SOLUTION.c\n", argv[0]);
        return 2;
    }
    path = argv[1];
    FILE *solution = fopen(path, "r");
    if (solution == NULL) {
        perror(path);
        return 1;
    }
    make_blank(solution);
    fclose(solution);
    if (fflush(stdout) != 0) {
        perror("the blank cannot be written");
        return 1;
    }
    return 0;
}
