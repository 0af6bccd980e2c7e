"""grade - marks a class. README.md is the instructor's page; this is the way of a submission, in its order.

collect   a folder, an archive or an export becomes at most one text per chapter
confine   where hostile code is compiled and run (C), and whether this machine has room for it
mark      compiles, links, has it judged, reads the judge's report and gives marks: a record for each submission
people    whose it is, what the instructor decides, how marks change, and what goes back to the students
report    the record in every format that people and programs read
attacks   a class of hostile submissions, which tests all of these
check     the other tests
"""
