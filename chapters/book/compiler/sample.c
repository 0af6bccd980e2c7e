// sample.c - C as students write it, to train the cut compiler (train.mjs): every statement and
// operator, most of the library, and the warnings of -Wall -Wextra. It is compiled, never run.
#include "common/ray.h"
#include "common/scene.h"
#include "common/sphere.h"
#include "common/vec3.h"

#include <assert.h>
#include <complex.h>
#include <ctype.h>
#include <errno.h>
#include <float.h>
#include <inttypes.h>
#include <limits.h>
#include <math.h>
#include <stdalign.h>
#include <stdarg.h>
#include <stdatomic.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <stdnoreturn.h>
#include <string.h>
#include <tgmath.h>
#include <time.h>

#define SQUARE(x) ((x) * (x))
#define MAX(a, b) ((a) > (b) ? (a) : (b))
#define DEBUG(...) fprintf(stderr, __VA_ARGS__)
#define JOINED(a, b) a##b
#define TEXT(x) #x

enum color { RED, GREEN = 5, BLUE };
typedef enum { NOTHING, ONE_HIT, TWO_HITS } Count;
struct point {
    double x, y;
};
typedef struct {
    struct point at;
    float weight;
    unsigned flags : 3, more : 5;
    char name[16];
} Thing;
union number {
    int i;
    float f;
    unsigned char bytes[4];
};
struct list {
    struct list *next;
    int value;
};
typedef int (*Comparison)(const void *, const void *);
typedef double Matrix[3][3];
static const double epsilon = 1e-9;
static int counter, table[10] = {1, 2, 3}, grid[3][4] = {{1}, {[2] = 5}};
static const char *const names[] = {"red", "green", [BLUE] = "blue", NULL};
static const Matrix identity = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
static volatile int watched;
static _Thread_local int own;
static atomic_int shared_count;
extern int elsewhere;
_Static_assert(sizeof(int) == 4, "int has four bytes");

static inline double square(double x)
{
    return x * x;
}
static int helper(int a, int b);
noreturn static void give_up(const char *format, ...);

static int compare(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return x < y ? -1 : x > y;
}

static void swap(double *a, double *b)
{
    double t = *a;
    *a = *b;
    *b = t;
}

static double sum(int count, ...)
{
    va_list list, copy;
    double total = 0;
    va_start(list, count);
    va_copy(copy, list);
    for (int i = 0; i < count; i++)
        total += va_arg(list, double) + (double)va_arg(copy, int);
    va_end(copy);
    va_end(list);
    return total;
}

static void give_up(const char *format, ...)
{
    va_list list;
    va_start(list, format);
    vfprintf(stderr, format, list);
    va_end(list);
    exit(EXIT_FAILURE);
}

static long long factorial(int n)
{
    return n <= 1 ? 1 : n * factorial(n - 1);
}

static int operators(int a, int b, unsigned u, long l, unsigned long long ull, float f, double d,
                     _Bool t, char c, short s)
{
    int r = a + b - a * b / (b ? b : 1) % 7;
    r += a & b | a ^ ~b;
    r <<= 2, r >>= 1;
    r -= -a + +b - !c;
    r *= 3, r /= 2, r %= 11, r &= 0xff, r |= 0x10, r ^= 0x3;
    r += a++ + ++b - a-- - --b;
    r += (a < b) + (a <= b) + (a > b) + (a >= b) + (a == b) + (a != b);
    r += (f < d) + (f <= d) + (f > d) + (f >= d) + (f == (float)d) + (d != 0);
    r +=
        (u < 5u) + (u <= 5u) + (u > 5u) + (u >= 5u) + (int)(u / 3 + u % 3) + (int)(u << 3 | u >> 2);
    r += (int)(l * 2 / 3 % 5) + (int)(ull * 2 / 3 % 5 << 2 >> 1) + (l < 3) + (ull > 7);
    r += (int)f + (int)d + (int)(unsigned)f + (int)(long)d + (int)(unsigned long)d + (short)d +
         (char)f + (bool)d;
    r += (int)((float)a + (float)u + (float)l + (float)ull) +
         (int)((double)a + (double)u + (double)l + (double)ull);
    r += t && c || s, r += t ? c : s;
    r += c + s, c += 1, s++, c--, s /= 2, t = !t, t |= 1;
    r += (int)sizeof(Thing) + (int)sizeof r + (int)offsetof(Thing, name) + (int)alignof(double);
    f += 1, f -= d, f *= 2, f /= 3, d += f, d -= 1, d *= 2, d /= 3, d++, --f;
    return r + (int)(f + d) + (t, c);
}

static int statements(int n, const char *text)
{
    int total = 0;
    if (n < 0)
        return -1;
    else if (n == 0) {
        total = 1;
    } else
        total = 2;
    for (int i = 0, k = n; i < k; i++, k--)
        total += i * k;
    for (;;) {
        if (total++ > 10)
            break;
        else
            continue;
    }
    while (n-- > 0 && total)
        total -= n & 1;
    do {
        total++;
    } while (total % 3);
    switch (n) {
    case 0:
        total = 0;
        break;
    case 1:
    case 2:
        total++; // falls through
    case 3: {
        int inside = total;
        total += inside;
        break;
    }
    case 'a' ... 'f':
    default:
        total--;
    }
    switch ((enum color)n) {
    case RED:
        return 1;
    case GREEN:
        total = 5;
    case BLUE:
        break;
    }
    if (n > 100)
        goto end;
    while (*text != '\0')
        if (isdigit((unsigned char)*text++))
            total += text[-1] - '0';
end:
    return total;
}

static int arrays(int n, double values[], const int many[static 3], double (*rows)[4])
{
    double local[8] = {0}, copies[3][3], sized[n > 0 ? n : 1], *end = local + 8, *p;
    char word[] = "hello", buffer[64];
    int numbers[] = {3, 1, 2}, sum_of = 0;
    memcpy(copies, identity, sizeof copies);
    memset(sized, 0, sizeof sized);
    for (p = local; p != end; ++p)
        *p = (double)(p - local);
    for (size_t i = 0; i < sizeof numbers / sizeof numbers[0]; i++)
        sum_of += numbers[i] * many[i % 3] + table[i] + grid[i % 3][i % 4];
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            copies[i][j] = identity[j][i] * values[i] + rows[i][j];
    qsort(values, (size_t)n, sizeof *values, compare);
    snprintf(buffer, sizeof buffer, "%s %d %5.2f %g %c %p %zu %ld %u %x", word, sum_of, local[1],
             copies[1][1], word[0], (void *)p, strlen(word), (long)n, (unsigned)n, 255u);
    swap(&local[0], &local[1]);
    return sum_of + (int)sized[0] + buffer[0] + (int)*(local + 2) + 2 [numbers];
}

static Thing structures(Thing given, Thing *pointer, const struct point points[], int count)
{
    Thing made = {.at = {1, 2}, .weight = 3.5f, .flags = 2, .name = "thing"}, copy = made,
          *also = &copy;
    union number n = {.f = 1.5f};
    struct point middle = {0}, *at = &made.at;
    for (int i = 0; i < count; i++) {
        middle.x += points[i].x / count;
        middle.y += (points + i)->y / count;
    }
    also->at = middle;
    pointer->flags++, pointer->more |= 3;
    given.at = (struct point){.x = n.i, .y = at->y};
    *pointer = given;
    strncpy(pointer->name, names[GREEN], sizeof pointer->name - 1);
    if (strcmp(pointer->name, "green") == 0)
        (*pointer).weight = -also->weight;
    return count > 0 ? made : *pointer;
}

static struct list *lists(int count)
{
    struct list *first = NULL;
    for (int i = 0; i < count; i++) {
        struct list *item = malloc(sizeof *item);
        if (item == NULL)
            give_up("no memory for %d: %s\n", i, strerror(errno));
        *item = (struct list){first, i};
        first = item;
    }
    for (struct list *item = first, *next; item != NULL; item = next) {
        next = item->next;
        free(item);
    }
    int *numbers = calloc((size_t)count, sizeof(int));
    numbers = realloc(numbers, 2 * sizeof(int) * (size_t)count);
    free(numbers);
    return first;
}

static double numbers(double x, double y, float f, long double wide)
{
    double r = sqrt(x) + pow(x, 2) + fabs(y) + sin(x) + cos(x) + tan(x) + asin(x) + acos(x) +
               atan(x) + atan2(y, x);
    r += floor(x) + ceil(x) + round(x) + trunc(x) + fmod(x, y) + exp(x) + log(x) + log10(x) +
         log2(x) + cbrt(x) + hypot(x, y);
    r += fmin(x, y) + fmax(x, y) + copysign(x, y) + ldexp(x, 2) + nextafter(x, y) + fma(x, y, x) +
         (double)lround(x);
    r += sqrtf(f) + powf(f, 2) + fabsf(f) + sinf(f) + floorf(f) + f * 2.0f - 1.f;
    r += isnan(x) || isinf(y) || !isfinite(x) || signbit(y) || x == INFINITY || isless(x, y)
             ? NAN
             : DBL_EPSILON;
    r += (double)(wide * 2.0L) + (double)sqrtl(wide) + M_PI + HUGE_VAL + DBL_MAX + 0x1p-3 + 1e10 +
         .5 + 5. + 0x7f + 017 + 100L + 3u;
    r += abs((int)x) + (double)labs((long)x) + rand() % 10 + (double)(time(NULL) % 2) +
         atof("1.5") + atoi("3") + strtod("2", NULL);
    complex double z = x + y * I;
    return r + creal(z * z) + cimag(z) + (x > y ? x : y) + MAX(x, y) + SQUARE(x) +
           JOINED(ep, silon);
}

static vec3 vectors(vec3 a, vec3 b, double s, const Sphere *sphere, Ray ray)
{
    vec3 c = a + b - a * b / s, zero = {0}, made = {1, 2, 3}, moved = ray.origin;
    c += a, c -= b, c *= s, c /= 2;
    c = -c;
    c[0] = a[1] * b[2] - a[2] * b[1];
    c[1] = made[0] += 2;
    double d = 0;
    for (int i = 0; i < 3; i++)
        d += a[i] * b[i];
    moved += ray.direction * s;
    return d > 0 ? c * d : zero - s * moved * sphere->radius + (vec3){1, 0, 0};
}

static int functions(Comparison compared, double (*f)(double), void (*nothing)(void))
{
    double (*all[])(double) = {sin, cos, square, f};
    double x = 0, y = 1;
    for (int i = 0; i < 4; i++)
        x += all[i](y) + (*f)(y);
    if (nothing)
        nothing();
    return compared(&x, &y) + helper(1, 2) + (int)factorial(5) + (int)sum(2, 1.0, 2.0);
}

static int helper(int a, int b)
{
    static int calls = 0;
    const int *p = a > b ? &a : &b;
    int *q = (int *)p;
    int16_t small = (int16_t)a;
    uint8_t byte = (uint8_t)b;
    int64_t large = INT64_C(1) << 40;
    bool found = false;
    assert(p != NULL);
    calls++;
    counter += (int)large;
    watched = own++;
    atomic_fetch_add(&shared_count, 1);
    printf("%d %s\n", *p, TEXT(a + b)), puts("x"), putchar('\n'), DEBUG("%d\n", calls);
    printf("%" PRId64 " %lf %e %i %o %X %-5d|%05d|%+d|%.3s|%*d\n", large, 1.5, 2.5, 1, 8, 255, 1, 2,
           3, "abcdef", 4, 5);
    if (sscanf("1 2", "%d %lf", q, &(double){0}) != 2 || fgets((char[8]){0}, 8, stdin) == NULL ||
        getchar() == EOF)
        return *q + small + byte + found + _Generic(a, int : 1, double : 2, default : 3);
    return __builtin_popcount((unsigned)a) + (int)strtol("12", NULL, 10) + tolower('A') +
           (strchr("abc", 'b') != NULL);
}

// Each of these draws a warning.
int odd(int a, unsigned b, double d, float f, char *text, Thing thing)
{
    int unused, unset, set = 0;
    double values[3];
    if (a = 1)
        set = unset;
    if (a < b || d == f)
        ;
    if (a & 1 == 0 || b < 0)
        a == 3;
    int big = 3.7 * 1e12, shifted = 1 << 40, zero = a / 0;
    printf("%d %s\n", d, a);
    values[5] = 1 / 2 * d;
    char c = 300;
    for (int i = 0; i < 3; i++)
        ;
    a++;
    if (a)
        if (b)
            a = 1;
        else
            a = 2;
    a = a;
    text == "yes";
    return big + shifted + zero + c + abs(d) + thing.more + (sizeof(text) / sizeof(text[0])) +
           (a++ + a++) + set;
}

int user(Thing *thing, int n)
{
    return operators(n, 2, 3, 4, 5, 6, 7, 1, 'c', 9) + statements(n, "a1") +
           functions(compare, square, NULL) +
           arrays(n, (double[]){1, 2}, table, (double(*)[4])grid) +
           structures(*thing, thing, &thing->at, 1).at.x + (lists(n) != NULL) +
           (int)numbers(n, n, 1, 1) + (int)vectors((vec3){1}, (vec3){2}, 1, NULL, (Ray){0})[0] +
           (int)epsilon;
}
