// stored_zip.c - writes the three parts of a zip: each member after a header of its own, a table of
// all, and where the table is (PKWARE's APPNOTE.TXT, sections 4.3.7, 4.3.12 and 4.3.16).
#include "tests/course/submission/stored_zip.h"

#include <stdint.h>
#include <string.h>

enum {
    VERSION = 20,          // of the format: 2.0
    UNIX = 3 << 8,         // whose permissions the table has
    DATE = 1 << 5 | 1,     // 1980-01-01, the earliest that there is
    FILE_HEADER = 30,      // bytes
    IS_FILE_644 = 0100644, // permissions: a file, written by its owner, read by all
};

// The checksum of ISO 3309, bit by bit: submissions are small.
static uint32_t checksum(const char *bytes, size_t length)
{
    uint32_t sum = UINT32_MAX;
    for (size_t i = 0; i < length; i++) {
        sum ^= (unsigned char)bytes[i];
        for (int bit = 0; bit < 8; bit++)
            sum = sum >> 1 ^ (sum & 1 ? 0xedb88320 : 0);
    }
    return ~sum;
}

// Numbers have their lowest byte first.
static void put(FILE *file, uint32_t number, int bytes)
{
    for (int i = 0; i < bytes; i++)
        putc((int)(number >> 8 * i & 0xff), file);
}

// The fields that a header and an entry of the table share.
static void put_description(FILE *file, const ZipMember *member)
{
    put(file, VERSION, 2);
    put(file, 0, 2); // flags
    put(file, 0, 2); // as it is
    put(file, 0, 2); // time
    put(file, DATE, 2);
    put(file, checksum(member->bytes, member->length), 4);
    put(file, (uint32_t)member->length, 4); // in the archive
    put(file, (uint32_t)member->length, 4);
    put(file, (uint32_t)strlen(member->name), 2);
    put(file, 0, 2); // nothing extra
}

static uint32_t put_member(FILE *file, const ZipMember *member)
{
    fputs("PK\3\4", file);
    put_description(file, member);
    fputs(member->name, file);
    fwrite(member->bytes, 1, member->length, file);
    return (uint32_t)(FILE_HEADER + strlen(member->name) + member->length);
}

static uint32_t put_entry(FILE *file, const ZipMember *member, uint32_t place)
{
    fputs("PK\1\2", file);
    put(file, UNIX | VERSION, 2);
    put_description(file, member);
    put(file, 0, 2); // no comment
    put(file, 0, 2); // the first volume
    put(file, 0, 2); // not known to be text
    put(file, (uint32_t)IS_FILE_644 << 16, 4);
    put(file, place, 4);
    fputs(member->name, file);
    return (uint32_t)(46 + strlen(member->name));
}

void zip_write(FILE *file, const ZipMember members[], size_t count)
{
    uint32_t place = 0, table = 0, end = 0;
    for (size_t i = 0; i < count; i++)
        end += put_member(file, &members[i]);
    for (size_t i = 0; i < count; i++) {
        table += put_entry(file, &members[i], place);
        place += (uint32_t)(FILE_HEADER + strlen(members[i].name) + members[i].length);
    }
    fputs("PK\5\6", file);
    put(file, 0, 4); // one volume
    put(file, (uint32_t)count, 2);
    put(file, (uint32_t)count, 2);
    put(file, table, 4);
    put(file, end, 4);
    put(file, 0, 2); // no comment
}
