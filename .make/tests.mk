# tests.mk - what the tests and the judges consist of, and tables of what is right. Included by the
# Makefile.

# The messages of the compiler and the linker, as a student reads them.
EXPLAIN := $(B)/explain
EXPLAIN_OBJECTS := $(patsubst %.c,$(B)/%.o,$(wildcard tests/explain/*.c))
$(EXPLAIN): $(EXPLAIN_OBJECTS)
	$(call say,link,$@)
	$(Q)$(LINK) -o $@ $^

# The common parts of all test programs: the list of tests, the words for given and expected, the lecture's example.
TESTING := $(patsubst %,$(B)/tests/judge/%.o,test runner known exercise) $(B)/tests/course/page.o $(B)/chapters/shared/example.o
COMMON_TESTS := $(patsubst %.c,$(B)/%,$(wildcard tests/house/common/*.c tests/house/judge/*.c tests/course/check_*.c))
# The parts of the program that judges answers (tests/course/course.c).
COURSE_PARTS := $(patsubst %.c,$(B)/%.o,$(filter-out %/course.c tests/course/check_%, \
	$(wildcard tests/course/*.c))) $(filter-out %/main.o,$(EXPLAIN_OBJECTS)) $(patsubst %,$(B)/tests/judge/%.o,exercise)
$(filter $(B)/tests/course/%,$(COMMON_TESTS)): $(filter-out %/page.o,$(COURSE_PARTS))
$(filter $(B)/tests/house/judge/%,$(COMMON_TESTS)): $$(CALLING) $$(REFERENCES)
$(COMMON_TESTS): %: %.o $(TESTING) $(B)/tests/judge/reference/test_main.o $(B)/common.a
	$(call say,link,$@)
	$(Q)$(LINK) -o $@ $(filter %.o,$^) $(B)/common.a $(CHECK_LIBS) $(PNG_LIBS) -lm

# Compiling what is known of the stems takes longer than running it: not optimised. But every call goes
# through its message.
FOR_EACH_CALL := $(patsubst %,$(B)/tests/judge/%.o,exercise numbers message table questions suspects answers_called)
$(filter-out $(FOR_EACH_CALL),$(patsubst %.c,$(B)/%.o,$(wildcard tests/[0-9]*.c tests/[0-9]*/*.c tests/judge/*.c))): OPTIMIZE = -O0

# The program that runs the tests: T=word, only those that have it in their name.
RUN := $(PYTHON) tests/house/runner/run_tests.py

# The program that packs a student's answers (make submission).
PACK := $(PYTHON) tests/course/pack_submission.py

# The judge of all stems: by the tests, or in a handout by tables.
JUDGE := $(B)/judge

# The list of the exercises, for programs that are not C (the format is in its source).
LIST := build/list_exercises
$(LIST): $(patsubst %,tests/judge/%.c,list_exercises exercise) tests/exercises.def tests/judge/types.def
	$(Q)mkdir -p $(@D)
	$(Q)$(CC) $(LANGUAGE) -o $@ $(filter %.c,$^)

# One call of one exercise, as a message.
CALLING := $(patsubst %,$(B)/tests/judge/%.o,message numbers exercise)
# The answering process, for each stem: its number without zeros; 0 is all of them.
answered = $(if $(filter all,$(1)),0,$(patsubst 0%,%,$(firstword $(subst -, ,$(1)))))
DISPATCHES := $(patsubst %,$(B)/dispatch/%.o,$(STEMS) all)
$(DISPATCHES): $(B)/dispatch/%.o: tests/judge/dispatch.c $(B)/flags.mk
	$(call say,compile,$< for $*)
	$(Q)mkdir -p $(@D)
	$(Q)$(COMPILE) -DANSWERED=$(call answered,$*) -o $@ $<

# The judge's report on answers, for a program.
REPORTING := $(B)/tests/course/chapter_record.o

# The judge's figures of a wrong answer.
DRAWING := $(patsubst %,$(B)/tests/judge/%.o,figure picture_panels)
before = $(if $(filter-out $(2),$(firstword $(1))),$(firstword $(1)) $(call before,$(wordlist 2,99,$(1)),$(2)))
earlier = $(strip $(call before,$(STEMS),$(1)))

# ---- the judge --------------------------------------------------------------------------------

# It asks what the tables say: the questions of the tests, the right results and those of known mistakes, from
# which nobody can read a test or an answer (tests/judge/table.h). They are made from the tests; a handout has them.
# The laws go with it; as beside the reference (tests/judge/known.h), an exercise has another name in them.
renamed = $(CC) -E -P -x c -I. -DANSWERED=$(1) '-DPREFIX(name)=$(2)\#\#name' tests/judge/names.def
$(B)/reference.h: tests/judge/names.def tests/judge/parameters.h tests/exercises.def
	$(Q){ $(call renamed,0,reference_); $(CC) -E -P -x c -I. -DFORMS tests/judge/names.def; } > $@
AS_KNOWN = -include $(B)/reference.h -Wno-unused-parameter
LAWS := $(patsubst $(GIVEN)%.c,$(B)/%.o,$(wildcard $(GIVEN)tests/[0-9]*/laws.c))
$(LAWS): EXTRA = $(AS_KNOWN)
$(LAWS): $(B)/reference.h
TABLE := $(if $(GIVEN),build,$(B))/tables
TABLES := $(STEMS:%=$(TABLE)/%.table)
$(B)/tests/judge/table.o: EXTRA = '-DTABLES="$(TABLE)"'
READING := $(B)/tests/judge/table.o $(CALLING)
JUDGING := $(TESTING) $(patsubst %,$(B)/tests/judge/%.o,questions suspects laws) $(READING) $(LAWS)
# The code that calls an answering process; and what the judge lends to it, where the solutions are.
TO_PROCESS := $(patsubst %,$(B)/tests/judge/%.o,process_transport process)
REFERENCES := $(if $(wildcard solutions/.),$(STEMS:%=$(B)/tests/reference/%.o))
define link_program
	$(call say,link,$@)
	$(Q)mkdir -p $(@D) && rm -rf $@
	$(Q)$(LINK) -o $@ $(filter %.o,$^) $(B)/common.a $(CHECK_LIBS) $(PNG_LIBS) -lm
endef
$(JUDGE): $(JUDGING) $(TO_PROCESS) $(DRAWING) $(REPORTING) $(REFERENCES) $(B)/tests/judge/judge.o $(B)/common.a | $(TABLES)
	$(link_program)
