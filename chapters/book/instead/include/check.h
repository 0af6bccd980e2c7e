// check.h - the part of Check (libcheck.github.io) that the judge uses, without processes.
//
// A test that fails is left by the page (guard and leave in page.h), because there is no longjmp.
#ifndef CHAPTERS_BOOK_INSTEAD_CHECK_H
#define CHAPTERS_BOOK_INSTEAD_CHECK_H

typedef struct {
    const char *name;
    void (*run)(int number);
    const char *file; // as Check has it
    int line;
} TTest;

#define START_TEST(test)                                                                           \
    static void test##_run(int _i);                                                                \
    static const TTest test##_test = {#test, test##_run, __FILE__, __LINE__};                      \
    static const TTest *test = &test##_test;                                                       \
    static void test##_run(int _i __attribute__((unused)))
#define END_TEST

_Noreturn void ck_abort_msg(const char *format, ...) __attribute__((format(printf, 1, 2)));

typedef struct Suite Suite;
typedef struct TCase TCase;
typedef struct SRunner SRunner;
typedef struct TestResult TestResult;
typedef enum { CK_PASS, CK_FAILURE } ResultType;
enum { CK_NOFORK, CK_SILENT };

Suite *suite_create(const char *name);
TCase *tcase_create(const char *name);
void tcase_add_checked_fixture(TCase *tcase, void (*setup)(void), void (*teardown)(void));
void suite_add_tcase(Suite *suite, TCase *tcase);
void tcase_add_test(TCase *tcase, const TTest *test);

SRunner *srunner_create(Suite *suite);
void srunner_free(SRunner *runner); // and the suite
void srunner_set_fork_status(SRunner *runner, int status);
void srunner_run_all(SRunner *runner, int words);
int srunner_ntests_run(SRunner *runner);
TestResult **srunner_results(SRunner *runner); // to free
ResultType tr_rtype(TestResult *result);
const char *tr_msg(TestResult *result);

#endif
