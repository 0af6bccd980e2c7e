// explain_headers.c - see explain_headers.h.
//
// The headers are ours, and laid out by clang-format: a declaration begins in the first column,
// lines inside braces do not.
#include "tests/course/explain_headers.h"

#include <ctype.h>
#include <dirent.h>
#include <stdlib.h>
#include <string.h>

// ---- lists that grow ----------------------------------------------------------------------------

static void *grown(void *list, size_t count, size_t *room, size_t size)
{
    if (count < *room)
        return list;
    *room = *room == 0 ? 64 : 2 * *room;
    void *larger = text_memory(*room * size);
    if (count > 0)
        memcpy(larger, list, count * size);
    return larger;
}

static void add_name(Headers *headers, const char *name, const char *header)
{
    if (name[0] == '\0')
        return;
    headers->names =
        grown(headers->names, headers->name_count, &headers->name_room, sizeof *headers->names);
    headers->names[headers->name_count++] = (DeclaredName){name, header};
}

static const char *without_comment(const char *line)
{
    const char *comment = strstr(line, "//");
    if (comment == NULL)
        return line;
    while (comment > line && (comment[-1] == ' ' || comment[-1] == '\t'))
        comment--;
    return text_part(line, 0, (size_t)(comment - line));
}

// ---- structs and enums --------------------------------------------------------------------------

static const char *letters_of(const char *text)
{
    return text_replaced(text, "[^A-Za-z_0-9]+", "");
}

// "double x, y", "const Sphere *spheres", "double t[2]", "void (*progress)(const Image *image)".
static void read_fields(DeclaredType *type, const char *declaration)
{
    declaration = text_replaced(declaration, "[ \t]+", " ");
    declaration = text_without(declaration, "^ ?(const )?");
    Match match;
    if (text_find(declaration, "\\(\\*[a-z_]+\\)", &match))
        declaration =
            text_format("function %s", text_part(declaration, match.at + 2, match.length - 3));
    size_t kind = strcspn(declaration, " ");
    if (kind == 0 || declaration[kind] == '\0' || declaration[kind + 1] == '\0')
        return;
    for (const char *at = declaration + kind; at != NULL;) {
        size_t length = strcspn(at, ",");
        const char *field = text_part(at, 0, length);
        field = text_part(field, 0, strcspn(field, "["));
        const char *name = letters_of(field);
        type->parts = text_format("%s%s%s", type->parts, type->parts[0] != '\0' ? ", " : "", name);
        type->fields[type->field_count++] =
            (Field){name, text_part(declaration, 0, kind), text_has(field, "*")};
        at = at[length] == ',' ? at + length + 1 : NULL;
    }
}

static void read_struct(DeclaredType *type, const char *content)
{
    type->fields = text_memory((size_t)(text_count(content, ',') + text_count(content, ';') + 1) *
                               sizeof(Field));
    for (const char *end; (end = strchr(content, ';')) != NULL; content = end + 1)
        read_fields(type, text_part(content, 0, (size_t)(end - content)));
}

static void read_enum(Headers *headers, DeclaredType *type, const char *content)
{
    content = text_replaced(text_replaced(content, "=[^,]*", ""), " +", "");
    for (int i = 1; content[0] != '\0'; i++) {
        size_t length = strcspn(content, ",");
        const char *name = text_part(content, 0, length);
        content += length + (content[length] == ',');
        add_name(headers, name, type->header);
        if (i <= 3)
            type->values = text_format("%s%s%s%s", type->values, i > 1 ? ", " : "", name,
                                       i == 3 && content[0] != '\0' ? ", ..." : "");
    }
}

// From  typedef struct {  or  enum Tag {  to the closing brace and its name.
static void read_type(Headers *headers, const char *line, size_t length, char **rest,
                      const char *header)
{
    bool is_enum = text_has(text_part(line, 0, length), "enum");
    const char *tag =
        strstr(line, is_enum ? "enum" : "struct") + strlen(is_enum ? "enum" : "struct");
    tag = letters_of(text_part(tag, 0, strcspn(tag, "{")));
    const char *content = line + length;
    for (char *more; !text_has(content, "}") && (more = text_next_line(rest)) != NULL;)
        content = text_format("%s %s", content, without_comment(more));
    size_t inside = strcspn(content, "}");
    const char *name = letters_of(text_from(content, inside));
    DeclaredType type = {
        .name = name[0] != '\0' ? name : tag, .header = header, .parts = "", .values = ""};
    add_name(headers, type.name, header);
    content = text_part(content, 0, inside);
    if (is_enum)
        read_enum(headers, &type, content);
    else
        read_struct(&type, content);
    if (type.name[0] == '\0')
        return;
    headers->types =
        grown(headers->types, headers->type_count, &headers->type_room, sizeof *headers->types);
    headers->types[headers->type_count++] = type;
}

// ---- functions and other names ------------------------------------------------------------------

static void read_function(Headers *headers, const char *line, char **rest, const char *header)
{
    line = text_without(line, "^static inline ");
    for (char *more; !text_has(line, ")") && (more = text_next_line(rest)) != NULL;)
        line = text_format("%s%s", line, more);
    line = text_replaced(text_part(line, 0, strcspn(line, ")") + 1), "  +", " ");
    size_t end = strcspn(line, "("), begin = end;
    while (begin > 0 && is_word_character(line[begin - 1]))
        begin--;
    DeclaredFunction function = {.name = text_part(line, begin, end - begin),
                                 .header = header,
                                 .prototype = line,
                                 .arguments = text_from(line, end),
                                 .type = bare_type(text_part(line, 0, begin))};
    add_name(headers, function.name, header);
    headers->functions = grown(headers->functions, headers->function_count, &headers->function_room,
                               sizeof *headers->functions);
    headers->functions[headers->function_count++] = function;
}

static void read_typedef(Headers *headers, const char *line, const char *header)
{
    line = text_without(line, " *(__attribute__|\\(|;).*");
    const char *last = strrchr(line, ' ');
    add_name(headers, last == NULL ? line : last + 1, header);
}

static void read_header(Headers *headers, const char *header)
{
    char *rest = text_of_file(header);
    if (rest == NULL)
        return;
    for (const char *line; (line = text_next_line(&rest)) != NULL;) {
        Match match;
        if (!isalpha((unsigned char)line[0]) && line[0] != '#')
            continue;
        line = without_comment(line);
        if (text_begins(line, "#define ")) {
            const char *name = line + strlen("#define ");
            add_name(headers, text_part(name, 0, text_span_of_word(name)), header);
        } else if (text_has(line, "{") &&
                   text_find(line, "^[a-z ]*(struct|enum)[A-Za-z ]*\\{", &match))
            read_type(headers, line, match.length, &rest, header);
        else if (text_begins(line, "typedef "))
            read_typedef(headers, line, header);
        else if (text_has(line, "(") &&
                 text_matches(line, "^[A-Za-z_][A-Za-z_0-9 *]*[ *][A-Za-z_0-9]+\\("))
            read_function(headers, line, &rest, header);
    }
}

static int by_name(const void *left, const void *right)
{
    return strcmp(*(const char *const *)left, *(const char *const *)right);
}

static void read_folder(Headers *headers, const char *folder)
{
    DIR *files = opendir(folder);
    if (files == NULL)
        return;
    Lines paths = {NULL, 0};
    for (const struct dirent *file; (file = readdir(files)) != NULL;) {
        size_t length = strlen(file->d_name);
        if (file->d_name[0] != '.' && length > 2 && text_is(file->d_name + length - 2, ".h"))
            lines_add(&paths, text_format("%s/%s", folder, file->d_name));
    }
    closedir(files);
    if (paths.count > 0)
        qsort(paths.line, paths.count, sizeof *paths.line, by_name);
    for (size_t i = 0; i < paths.count; i++)
        read_header(headers, paths.line[i]);
}

Headers headers_read(void)
{
    Headers headers = {.names = NULL};
    read_folder(&headers, "exercises");
    read_folder(&headers, "common");
    return headers;
}

// ---- asking -------------------------------------------------------------------------------------

const char *header_of(const Headers *headers, const char *name)
{
    for (size_t i = headers->name_count; i > 0; i--)
        if (text_is(headers->names[i - 1].name, name))
            return headers->names[i - 1].header;
    return NULL;
}

static bool is_constant(const char *name)
{
    return text_matches(name, "^[A-Z][A-Z_0-9]+$");
}

const DeclaredName *header_name_like(const Headers *headers, const char *name, bool is_type,
                                     const char *last_header)
{
    for (size_t i = 0; i < headers->name_count; i++) {
        const DeclaredName *other = &headers->names[i];
        if (strcasecmp(other->name, name) == 0 && !text_is(other->name, name) &&
            (is_type || is_constant(other->name)) &&
            (!text_begins(other->header, "exercises") || strcmp(other->header, last_header) <= 0))
            return other;
    }
    return NULL;
}

const DeclaredFunction *header_function(const Headers *headers, const char *name)
{
    for (size_t i = headers->function_count; i > 0; i--)
        if (text_is(headers->functions[i - 1].name, name))
            return &headers->functions[i - 1];
    return NULL;
}

static const DeclaredType *type_named(const Headers *headers, const char *name)
{
    for (size_t i = headers->type_count; i > 0; i--)
        if (text_is(headers->types[i - 1].name, name))
            return &headers->types[i - 1];
    return NULL;
}

bool header_type(const Headers *headers, const char *name)
{
    return text_is_one_of(name, "double int float bool vec3 Color") ||
           type_named(headers, name) != NULL;
}

const char *header_parts(const Headers *headers, const char *type)
{
    const DeclaredType *declared = type_named(headers, type);
    return declared != NULL ? declared->parts : "";
}

const Field *header_field(const Headers *headers, const char *type, const char *field)
{
    const DeclaredType *declared = type_named(headers, type);
    for (size_t i = 0; declared != NULL && i < declared->field_count; i++)
        if (text_is(declared->fields[i].name, field))
            return &declared->fields[i];
    return NULL;
}

const char *header_values(const Headers *headers, const char *type)
{
    const DeclaredType *declared = type_named(headers, type);
    return declared != NULL ? declared->values : "";
}

Lines header_parameter_types(const char *arguments)
{
    Lines types = {NULL, 0};
    const char *at = arguments + (arguments[0] == '(');
    for (size_t length; at != NULL && at[0] != '\0' && at[0] != ')';
         at = at[length] == ',' ? at + length + 1 : NULL) {
        length = strcspn(at, ",)");
        const char *type = text_without(text_part(at, 0, length), "^ *(const )?");
        lines_add(&types, text_part(type, 0, strcspn(type, " *")));
    }
    return types;
}
