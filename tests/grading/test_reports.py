"""test_reports.py - all tests of the reports. tests/shell/reports.sh runs it."""
import sys
import traceback

import test_comment
import test_report_files
import test_report_formats
import test_report_pages
import test_report_tables
from sentences import check, finish

MODULES = (
    test_comment,
    test_report_formats,
    test_report_tables,
    test_report_pages,
    test_report_files,
)
for module in MODULES:
    for test in module.TESTS:
        try:
            test()
        except Exception:  # a report that cannot be read is a failure, not the end of the test
            check(f"{module.__name__}.{test.__name__} came to its end", False)
            traceback.print_exc(limit=-4, file=sys.stdout)
sys.exit(finish("reports"))
