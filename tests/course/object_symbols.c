// object_symbols.c - the global symbols of a compiled file, without a program that reads it.
//
// A student's source decides what is in the file, so nothing is read outside its bounds.
#include "tests/course/object_symbols.h"

#include "tests/course/whole_text.h"

#include <stdlib.h>
#include <string.h>

#ifdef __linux__
#include <link.h>

typedef struct {
    char *bytes;
    size_t size;
} Object;

// Copies what is at a place of the file: it may be at any address. False beyond the end.
static bool copy_from(const Object *object, size_t at, void *into, size_t size)
{
    if (at > object->size || size > object->size - at)
        return false;
    memcpy(into, object->bytes + at, size);
    return true;
}

static bool is_of_this_machine(const ElfW(Ehdr) * header)
{
    const unsigned char own_class = sizeof(void *) == 8 ? ELFCLASS64 : ELFCLASS32;
    return memcmp(header->e_ident, ELFMAG, SELFMAG) == 0 &&
           header->e_ident[EI_CLASS] == own_class && header->e_type == ET_REL &&
           header->e_shentsize == sizeof(ElfW(Shdr));
}

static bool section(const Object *object, const ElfW(Ehdr) * header, size_t number,
                    ElfW(Shdr) * into)
{
    return number < header->e_shnum &&
           copy_from(object, header->e_shoff + number * sizeof *into, into, sizeof *into);
}

// A name that ends inside the section of names; NULL if it does not.
static const char *name_at(const Object *object, const ElfW(Shdr) * names, size_t at)
{
    if (names->sh_offset > object->size || names->sh_size > object->size - names->sh_offset ||
        at >= names->sh_size)
        return NULL;
    const char *name = object->bytes + names->sh_offset + at;
    return memchr(name, '\0', names->sh_size - at) != NULL ? name : NULL;
}

// The macros for the parts of st_info and st_other are the same for 32 and 64 bits.
static ObjectSymbol described(const ElfW(Sym) * symbol, const char *name)
{
    int type = ELF64_ST_TYPE(symbol->st_info), binding = ELF64_ST_BIND(symbol->st_info);
    bool is_defined = symbol->st_shndx != SHN_UNDEF;
    bool is_plain =
        (binding == STB_GLOBAL || binding == STB_WEAK) && symbol->st_other == STV_DEFAULT &&
        (type == STT_FUNC || type == STT_OBJECT || (type == STT_NOTYPE && !is_defined)) &&
        (!is_defined || symbol->st_shndx < SHN_LORESERVE) && strchr(name, '@') == NULL;
    return (ObjectSymbol){name, is_defined, type == STT_FUNC, is_plain};
}

static bool look_at_all(const Object *object, bool (*look)(const ObjectSymbol *, void *),
                        void *given)
{
    ElfW(Ehdr) header;
    ElfW(Shdr) table, names;
    size_t number = 0;
    if (!copy_from(object, 0, &header, sizeof header) || !is_of_this_machine(&header))
        return false;
    do
        if (!section(object, &header, number++, &table))
            return false;
    while (table.sh_type != SHT_SYMTAB);
    if (!section(object, &header, table.sh_link, &names))
        return false;
    // sh_info: the first that is global.
    for (size_t i = table.sh_info; i < table.sh_size / sizeof(ElfW(Sym)); i++) {
        ElfW(Sym) symbol;
        if (!copy_from(object, table.sh_offset + i * sizeof symbol, &symbol, sizeof symbol))
            return false;
        const char *name = name_at(object, &names, symbol.st_name);
        if (name == NULL)
            return false;
        ObjectSymbol it = described(&symbol, name);
        if (!look(&it, given))
            return false;
    }
    return true;
}

bool object_symbols(const char *path, bool (*look)(const ObjectSymbol *, void *), void *given)
{
    Object object;
    object.bytes = whole_text(path, &object.size);
    bool good = object.bytes != NULL && look_at_all(&object, look, given);
    free(object.bytes);
    return good;
}
#else
bool object_symbols(const char *path, bool (*look)(const ObjectSymbol *, void *), void *given)
{
    (void)path;
    (void)look;
    (void)given;
    return false;
}
#endif
