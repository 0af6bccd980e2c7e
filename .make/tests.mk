# tests.mk - make check, and the judges. Included by the Makefile.

# What a student reads of what the compiler and the linker say.
EXPLAIN := $(B)/explain
EXPLAIN_OBJECTS := $(patsubst %.c,$(B)/%.o,$(wildcard tests/course/explain*.c))
$(EXPLAIN): $(EXPLAIN_OBJECTS)
	$(call say,link,$@)
	$(Q)$(LINK) -o $@ $^

# What every program of tests is made of: its list of tests, and the words for given and expected.
TESTING := $(patsubst %,$(B)/tests/judge/%.o,record given expect expect_roots runner \
	show random)
COMMON_TESTS := $(patsubst %.c,$(B)/%,$(wildcard tests/common/*.c tests/course/check_*.c))
$(B)/tests/course/check_explain: $(filter-out %_main.o,$(EXPLAIN_OBJECTS))
$(COMMON_TESTS): %: %.o $(TESTING) $(B)/tests/judge/main.o $(B)/common.a
	$(call say,link,$@)
	$(Q)$(LINK) -o $@ $^ $(CHECK_LIBS) $(PNG_LIBS) -lm

# What runs the tests.
RUN := $(B)/tests/check
$(RUN): $(B)/tests/check.o
	$(call say,link,$@)
	$(Q)$(LINK) -o $@ $^

# What packs a student's answers (make submission).
PACK := $(B)/tests/submission/pack
$(PACK): $(patsubst %,$(B)/tests/submission/%.o,pack stored_zip) $(B)/common.a
	$(call say,link,$@)
	$(Q)$(LINK) -o $@ $^ -lm

# The list of the exercises, for programs that are not C (the format is in its source).
LIST := build/judge/list
$(LIST): $(patsubst %,tests/judge/%.c,list exercise types) tests/exercises.def tests/judge/types.def
	$(Q)mkdir -p $(@D)
	$(Q)$(CC) $(LANGUAGE) -o $@ $(filter %.c,$^)

# One call of one exercise, as a message.
CALLING := $(patsubst %,$(B)/tests/judge/%.o,transport message wire exercise types)
# The answering process, for each stem: its number without zeros; 0 is all of them.
answered = $(if $(filter all,$(1)),0,$(patsubst 0%,%,$(firstword $(subst -, ,$(1)))))
DISPATCHES := $(patsubst %,$(B)/judge/dispatch-%.o,$(STEMS) all)
$(DISPATCHES): $(B)/judge/dispatch-%.o: tests/judge/dispatch.c $(B)/flags $(SETUP_FIRST)
	$(call say,compile,$< for $*)
	$(Q)mkdir -p $(@D)
	$(Q)$(COMPILE) -DANSWERED=$(call answered,$*) -o $@ $<

# Which known mistake a wrong answer is.
DIAGNOSIS := suspects evidence explanation paint same

# What the judge draws of a wrong answer.
DRAWING := $(B)/tests/judge/figure.o $(patsubst %,$(B)/tests/judge/figure_%.o,vector camera place section \
	equation pictures)
earlier = $(shell printf '%s\n' $(STEMS) | awk '$$1 < "$(1)"')
#[ The tests themselves, the mistakes and the laws.
# A stem's tests, calling the answers directly: that answer, and the reference for the stems before.
parts = $(patsubst %.c,$(B)/%.o,$(wildcard $(1)*.c))
tests_of = $(call parts,tests/$(1)) $(call parts,tests/$(1)/support)
test_objects = $(call tests_of,$(1)) $(TESTING) $(B)/tests/judge/main.o \
	$(patsubst %,$(B)/solutions/%.o,$(call earlier,$(1))) $(B)/common.a
TESTS := $(STEMS:%=$(BUILT)/tests/%)
$(TESTS): $(BUILT)/tests/%: $(BUILT)/%.o $$(call test_objects,$$*)
	$(call say,link,$@)
	$(Q)mkdir -p $(@D)
	$(Q)$(LINK) -o $@ $^ $(CHECK_LIBS) $(PNG_LIBS) -lm

# The judge: the same tests, asking another process for the answers (proxies). Mistakes and laws
# stand beside the reference, which goes by other names there.
renamed = $(CC) -E -P -x c -I. -DANSWERED=$(1) '-DPREFIX(name)=$(2)\#\#name' tests/judge/rename.def
$(B)/reference.h: tests/judge/rename.def tests/exercises.def
	$(Q)$(call renamed,0,reference_) > $@
BESIDE_REFERENCE := $(foreach kind,mistakes laws variants unknown,$(call parts,tests/[0-9]*/$(kind)))
$(BESIDE_REFERENCE): EXTRA = -include $(B)/reference.h
$(BESIDE_REFERENCE): $(B)/reference.h
REFERENCES := $(STEMS:%=$(B)/tests/reference/%.o)
$(REFERENCES): $(B)/tests/reference/%.o: solutions/%.c $(B)/reference.h $(B)/flags
	$(call say,compile,$< as reference)
	$(Q)mkdir -p $(@D)
	$(Q)$(COMPILE) -include $(B)/reference.h -o $@ $<
# What the answers do beside the known mistakes.
HEARING := $(patsubst %,$(B)/tests/judge/%.o,hearing proxies corners switchboard $(DIAGNOSIS)) \
	$(B)/tests/told/layout.o $(CALLING) $(call parts,tests/[0-9]*/laws) $(REFERENCES)
# What calls an answering process.
TO_PROCESS := $(patsubst %,$(B)/tests/judge/%.o,call kept process ending system_call)
JUDGES := $(STEMS:%=$(B)/judge/%)
$(JUDGES): $(B)/judge/%: $$(call tests_of,$$*) $$(call parts,tests/$$*/mistakes) $(TESTING) \
		$(HEARING) $(TO_PROCESS) $(B)/tests/%/probes.o $(DRAWING) \
		$(patsubst %,$(B)/tests/judge/%.o,judge report right) $(B)/common.a
	$(call say,link,$@)
	$(Q)$(LINK) -o $@ $^ $(CHECK_LIBS) $(PNG_LIBS) -lm
# The matrix: the same, and in the place of the answering process a table that the reference fills.
MATRICES := $(STEMS:%=$(B)/tests/matrix/%)
$(call parts,tests/[0-9]*/composed): EXTRA = -include $(B)/weak.h
$(call parts,tests/[0-9]*/composed): $(B)/weak.h
$(MATRICES): $(B)/tests/matrix/%: $$(call tests_of,$$*) $$(call parts,tests/$$*/mistakes) \
		$(B)/tests/%/probes.o $(B)/tests/%/variants.o $$(call parts,tests/$$*/composed) $(B)/tests/%/unknown.o \
		$(TESTING) $(HEARING) $(patsubst %,$(B)/tests/judge/%.o,matrix missing table) $(B)/common.a
	$(call say,link,$@)
	$(Q)mkdir -p $(@D)
	$(Q)$(LINK) -o $@ $^ $(CHECK_LIBS) $(PNG_LIBS) -lm

missing: $$(addprefix $$(B)/tests/matrix/,$$(CHOSEN)) ## what an exercise still lacks that was just added (EX=02)
	@for matrix in $^; do $$matrix --missing || exit 1; done
.PHONY: missing

# Wrong answers that nobody has thought of: slips of the pen in every answer that is known, which
# the compiler sifts, and a program a stem that tries them. GENERATED_SEED=... makes others.
GENERATED_SEED ?= 2015
GENERATED_MOST ?= 400
MUTATE := $(B)/tests/generated/mutate
$(MUTATE): $(patsubst %,$(B)/tests/generated/%.o,mutate put source slips statements pen)
	$(call say,link,$@)
	$(Q)$(LINK) -o $@ $^
MUTANTS := $(STEMS:%=$(B)/generated/%.o)
answers_of = $(wildcard solutions/$(1).c tests/$(1)/mistakes*.[ch] tests/$(1)/variants*.[ch])
AS_REFERENCE = $(CC) $(LANGUAGE) -w -include $(B)/reference.h
$(MUTANTS): $(B)/generated/%.o: $(MUTATE) $$(call answers_of,$$*) $(B)/reference.h $(B)/flags
	$(call say,mutate,$*)
	$(Q)rm -rf $(@D)/$* && mkdir -p $(@D)/$*
	$(Q)for source in $(filter %.c,$(call answers_of,$*)); do \
		$(AS_REFERENCE) -E "$$source" -o "$(@D)/$*/$$(echo "$$source" | tr / -).i" || exit 1; done
	$(Q)$(call mutants_of,/dev/null)
	$(Q)$(subst -w,-Werror=incompatible-pointer-types,$(AS_REFERENCE)) $(ALL_ERRORS) -fsyntax-only \
		$(@D)/$*.c 2> $(@D)/$*.errors || true
	$(Q)$(call mutants_of,$(@D)/$*.errors)
	$(Q)$(subst -w,-Winit-self -Werror=uninitialized,$(AS_REFERENCE)) $(ALL_ERRORS) -O0 -c -o /dev/null \
		$(@D)/$*.c 2>> $(@D)/$*.errors || true
	$(Q)$(call mutants_of,$(@D)/$*.errors)
	$(Q)$(AS_REFERENCE) -O0 -c -o $@ $(@D)/$*.c
# The compiler says first what is no C, and of the rest what reads variables that were never set:
# that is different for whoever asks.
mutants_of = $(MUTATE) $(GENERATED_SEED) $(GENERATED_MOST) $(1) $(@D)/$*/*.i > $(@D)/$*.c
ALL_ERRORS = $(if $(findstring clang,$(CC)),-ferror-limit=0)
TRIALS := $(STEMS:%=$(B)/tests/generated/%)
$(TRIALS): $(B)/tests/generated/%: $$(call tests_of,$$*) $$(call parts,tests/$$*/mistakes) \
		$(B)/tests/%/probes.o $(TESTING) $(HEARING) $(B)/generated/%.o \
		$(patsubst %,$(B)/tests/generated/%.o,try truth guard question ask_screen ask_cameras \
		ask_spheres ask_scenes ask_lights) $(B)/tests/told/here.o $(B)/common.a
	$(call say,link,$@)
	$(Q)$(LINK) -o $@ $^ $(CHECK_LIBS) $(PNG_LIBS) -lm

# Blanks are made afresh, whatever stands in exercises/, and must pass nothing.
BLANK_TESTS := $(STEMS:%=$(B)/tests/blanks/%)
$(BLANK_TESTS:%=%.o): WARNINGS = $(FOR_STUDENTS)
$(BLANK_TESTS:%=%.o): $(B)/tests/blanks/%.o: build/blanks/%.c $(B)/flags
	$(call say,compile,$<)
	$(Q)mkdir -p $(@D)
	$(Q)$(COMPILE) -o $@ $<
$(BLANK_TESTS): $(B)/tests/blanks/%: $(B)/tests/blanks/%.o $$(call test_objects,$$*)
	$(call say,link,$@)
	$(Q)$(LINK) -o $@ $^ $(CHECK_LIBS) $(PNG_LIBS) -lm

# Every engine of chapter 08 against the first: of scenes that are made, and of files; what memory
# it takes; and shadows and mirrors against chapter 07.
SAME_ENGINES := $(patsubst %,$(B)/tests/fast/%,same files memory)
ENGINES := $(B)/tests/fast/same $(B)/tests/fast/lit
ENGINES_LONG := $(filter-out $(ENGINES),$(SAME_ENGINES))
$(SAME_ENGINES): $(patsubst %,$(B)/tests/fast/%.o,against made made_difficult made_far parts)
$(B)/tests/fast/lit: $(B)/tests/fast/lit_scenes.o
$(ENGINES) $(ENGINES_LONG): %: %.o $(filter-out %/main.o,$(call chapter_objects,08-fast)) $(B)/chapters/shared.a \
		$(STEMS:%=$(B)/solutions/%.o) $(B)/common.a
	$(call say,link,$@)
	$(Q)$(LINK) -o $@ $^ $(PNG_LIBS) -lm -pthread

# What a hostile answer asks for when the reference is lent.
ODD_QUESTIONS := $(B)/tests/lending/odd_questions
$(ODD_QUESTIONS): $(ODD_QUESTIONS).o $(CALLING) $(REFERENCES) $(B)/common.a
	$(call say,link,$@)
	$(Q)$(LINK) -o $@ $^ -lm

# What a type's entry brings.
TYPES := $(B)/tests/judge/check_types
$(TYPES): $(TYPES).o $(B)/tests/judge/main.o $(TESTING) $(CALLING) $(patsubst %,$(B)/tests/%.o,told/layout judge/same) \
		$(B)/common.a
	$(call say,link,$@)
	$(Q)$(LINK) -o $@ $^ $(CHECK_LIBS) $(PNG_LIBS) -lm

# Numbers as they are read against the C library's.
NUMBERS := $(B)/tests/exact/numbers
$(NUMBERS): $(NUMBERS).o $(B)/common.a
	$(call say,link,$@)
	$(Q)$(LINK) -o $@ $^ -lm

SAME := $(B)/tests/same_picture
$(B)/tests/judge/same_picture.o: EXTRA = $(PNG_CFLAGS)
$(SAME): $(B)/tests/judge/same_picture.o
	$(call say,link,$@)
	$(Q)$(LINK) -o $@ $^ $(PNG_LIBS)
#]

# ---- tests without the tests ------------------------------------------------------------------

# What the tests ask and what is right, as a table that no test and no answer can be read from
# (tests/told/): made here, and all that a handout has to judge by.
#[
TABLE := $(B)/told
#]
#~ TABLE := tests/told
$(STEMS:%=$(B)/told/path/%.c): $(B)/told/path/%.c:
	$(Q)mkdir -p $(@D)
	$(Q)printf '#include "tests/told/replay.h"\n\nconst char told_path[] = "%s";\n' \
		$(TABLE)/$*.table > $@
$(STEMS:%=$(B)/told/path/%.o): %.o: %.c $(B)/flags
	$(Q)$(COMPILE) -o $@ $<
TOLD := $(patsubst %,$(B)/tests/told/%.o,layout table) $(CALLING)
REPLAY := $(TESTING) $(patsubst %,$(B)/tests/judge/%.o,switchboard $(DIAGNOSIS)) $(TOLD) \
	$(patsubst %,$(B)/tests/told/%.o,replay expect)

# A table by itself: what is right passes, and each mistake's values are failed and named.
TABLE_CHECKS := $(STEMS:%=$(B)/told/check/%)
$(TABLE_CHECKS): $(B)/told/check/%: $(REPLAY) $(B)/told/path/%.o $(B)/tests/told/check.o \
		$(B)/common.a | $(TABLE)/%.table
	$(call say,link,$@)
	$(Q)mkdir -p $(@D)
	$(Q)$(LINK) -o $@ $^ $(CHECK_LIBS) $(PNG_LIBS) -lm

#[ Where the tables come from; and right answers written otherwise, held against them.
TELLERS := $(STEMS:%=$(B)/told/tell/%)
$(TELLERS): $(B)/told/tell/%: $$(call tests_of,$$*) $$(call parts,tests/$$*/mistakes) \
		$(B)/tests/%/probes.o $(TESTING) $(HEARING) $(B)/tests/told/table.o \
		$(patsubst %,$(B)/tests/told/%.o,tell asked takes here) $(B)/common.a
	$(call say,link,$@)
	$(Q)mkdir -p $(@D)
	$(Q)$(LINK) -o $@ $^ $(CHECK_LIBS) $(PNG_LIBS) -lm
TABLES := $(STEMS:%=$(TABLE)/%.table)
$(TABLES): $(TABLE)/%.table: $(B)/told/tell/%
	$(call say,tell,$@)
	$(Q)env -u SEED $< $@
TABLE_VARIANTS := $(STEMS:%=$(B)/told/variants/%)
$(TABLE_VARIANTS): $(B)/told/variants/%: $(filter-out $(HEARING),$(REPLAY)) $(B)/told/path/%.o $(B)/tests/%/variants.o \
		$(patsubst %,$(B)/tests/told/%.o,variants here) $(HEARING) $(B)/common.a | $(TABLE)/%.table
	$(call say,link,$@)
	$(Q)mkdir -p $(@D)
	$(Q)$(LINK) -o $@ $^ $(CHECK_LIBS) $(PNG_LIBS) -lm

KIT := $(B)/grading
CAN_GRADE := $(shell pkg-config --exists libseccomp 2>/dev/null && command -v python3 && \
	command -v objdump)

# What the shell scripts among the tests are told. Grading has no sanitizers: a sandbox has no room.
GRADABLE := $(if $(SANITIZE),,$(if $(CAN_GRADE),$(KIT)))
FOR_TESTS = GENERATED_SEED='$(GENERATED_SEED)' KIT='$(GRADABLE)' PROGRAMS='$(BUILT)' BUILD='$(B)' ANSWERS='$(A)' CC='$(CC)' MAKEFLAGS= SANITIZE= \
	COMPILER='$(CC) $(LANGUAGE) $(CFLAGS) $(SANITIZER)'
CHECKS := $(COMMON_TESTS) $(NUMBERS) $(TYPES) $(ODD_QUESTIONS) $(TESTS) $(ENGINES) $(MATRICES) $(TABLE_CHECKS) $(TABLE_VARIANTS)
FOR_CHECKS := $(EXPLAIN) $(BLANK_TESTS) $(PROGRAMS) $(PACK) $(GENERATED:%=$(B)/scenes/%.nff) $(SAME) $(JUDGES) $(GRADABLE:%=%/commands)
check: $(RUN) $(CHECKS) $(FOR_CHECKS) ## the tests, at most a minute
	@$(FOR_TESTS) $(RUN) $(BUILT)/log $(CHECKS) $(wildcard tests/shell/*.sh)

# What needs longer: exact arithmetic, a minute of fuzzing, the tree as its users have it. With BRIEF=1
# (another compiler, a sanitizer) only what it can make a difference to.
FOR_LONG := $(FOR_CHECKS) $(ENGINES_LONG) $(if $(BRIEF),,$(TRIALS) $(BENCH_SCENES))
check-all: $(RUN) $(CHECKS) $(FOR_LONG) ## those that need longer, too
	@$(FOR_TESTS) $(RUN) $(BUILT)/log $(CHECKS) $(wildcard tests/shell/*.sh tests/long/*.sh)

check-long: $(RUN) $(FOR_LONG) ## only those that need longer
	@$(FOR_TESTS) $(RUN) $(BUILT)/log $(NUMBERS) $(wildcard tests/long/*.sh)

handout: build/handout.tar.gz ## the students' archive: no solutions, no tests, no mistakes
build/handout.tar.gz: $(TABLES) $(BLANKS) $(if $(RIGHT),$(RIGHT_SCRIPTS),$(SCRIPTS)) FORCE
	@.make/handout $(@D) $(TABLE) build/blanks $(or $(RIGHT),$(FIGURES))
.PHONY: handout FORCE
#]
