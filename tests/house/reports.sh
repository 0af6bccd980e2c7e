#!/bin/sh
# reports.sh - what is written of a graded class, read back by others, with hostile names in it.
# Only reads the tree.
. tests/house/runner/library.sh
once reports "reports of a graded class"
needs reports 'reports' python3
python3 -B tests/grade/check reports test_comment test_report_formats test_report_tables \
    test_report_pages test_report_files
