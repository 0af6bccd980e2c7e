// check.h - the part of Check (libcheck.github.io) that the judge uses, without processes.
//
// A test that fails is left by the page (guard and leave in page.h), because there is no longjmp.
// There is one list of tests, and a case is one test.
#ifndef CHAPTERS_BOOK_INSTEAD_CHECK_H
#define CHAPTERS_BOOK_INSTEAD_CHECK_H

typedef struct {
    const char *name;
    void (*run)(int number);
    const char *file; // as Check has it
    int line;
} TTest;

_Noreturn void ck_abort_msg(const char *format, ...) __attribute__((format(printf, 1, 2)));

typedef struct Suite Suite, SRunner;
typedef struct TCase TCase, TestResult;
typedef enum { CK_PASS, CK_FAILURE } ResultType;
enum { CK_NOFORK, CK_SILENT };

Suite *suite_create(const char *name);
TCase *tcase_create(const char *name); // the suite has it at once
void tcase_add_checked_fixture(TCase *tcase, void (*setup)(void), void (*teardown)(void));
void tcase_add_test(TCase *tcase, const TTest *test);
#define suite_add_tcase(suite, tcase) ((void)(suite))

#define srunner_create(suite) (suite)
#define srunner_free(runner) ((void)(runner))
#define srunner_set_fork_status(runner, status) ((void)(runner))
void srunner_run_all(SRunner *runner, int words);
int srunner_ntests_run(SRunner *runner);
TestResult **srunner_results(SRunner *runner); // to free
ResultType tr_rtype(TestResult *result);
const char *tr_msg(TestResult *result);

#endif
