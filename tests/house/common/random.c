// random.c - tests of tests/judge/random.c. Expected: SplitMix64 computed apart, in another
// language, whose own first numbers from seed 1234567 are those that are published.
#include "tests/judge/record.h"
#include "tests/judge/test.h"

#include <stdint.h>
#include <stdlib.h>

static void begin(const char *seed, const char *test)
{
    if (seed == NULL)
        unsetenv("SEED");
    else
        setenv("SEED", seed, 1);
    random_take_seed();
    random_begin(test, false);
}

// The first 53 bits of the next numbers of 64.
static void expect_bits(int64_t first, int64_t second, int64_t third)
{
    const int64_t bits[] = {first, second, third};
    for (int i = 0; i < 3; i++)
        expect_number(random_number(0, 0x1p53), (double)bits[i], 0);
}

START_TEST(without_a_seed_every_test_has_the_stream_of_2015)
{
    begin(NULL, "one_test");
    expect_bits(0x1c89fde2e90b91, 0xff300a139bce0, 0x1975f6515733ef);
    begin(NULL, "another_test");
    expect_bits(0x1c89fde2e90b91, 0xff300a139bce0, 0x1975f6515733ef);
}
END_TEST

START_TEST(a_seed_and_a_name_give_the_same_stream_on_any_machine)
{
    begin("0", "a");
    expect_bits(0x1898beb3ff26f6, 0x17e2f0dccefe2f, 0x17594d4b39186f);
    begin("9223372036854775807", "the_same_test");
    expect_bits(0x1e6f10b3c08f1, 0x5c5969d0dd5ea, 0x1308939329724d);
    begin("0", "a");
    expect_bits(0x1898beb3ff26f6, 0x17e2f0dccefe2f, 0x17594d4b39186f);
}
END_TEST

static void number_of(const char *seed, const char *test, double *number)
{
    begin(seed, test);
    *number = random_number(0, 1);
}

START_TEST(other_seeds_and_other_names_have_other_streams)
{
    double number[6];
    number_of("1", "a_test", &number[0]);
    number_of("2", "a_test", &number[1]);
    number_of("1", "", &number[2]);
    number_of("1", "a_tesu", &number[3]);
    number_of("1", "t_aest", &number[4]);
    number_of(NULL, "a_test", &number[5]);
    for (int i = 0; i < 6; i++)
        for (int j = 0; j < i; j++)
            expect_int(number[i] != number[j], 1);
}
END_TEST

START_TEST(only_what_is_made_from_a_seed_is_hidden)
{
    begin(NULL, "a_test");
    random_vec3(0, 1);
    expect_int(record_now()->hidden, false);
    begin("5", "a_test");
    expect_int(record_now()->hidden, false);
    random_unit();
    expect_int(record_now()->hidden, true);
}
END_TEST

static void list_tests(void)
{
    tests_of("random_number");
    test(without_a_seed_every_test_has_the_stream_of_2015);
    test(a_seed_and_a_name_give_the_same_stream_on_any_machine);
    test(other_seeds_and_other_names_have_other_streams);
    test(only_what_is_made_from_a_seed_is_hidden);
}

OF_STEM(list_tests)
