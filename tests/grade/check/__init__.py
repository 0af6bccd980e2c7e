"""check - the tests of the grader. run_tests.py runs them."""
