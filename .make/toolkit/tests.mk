# tests.mk - make check: the tests of the exercises, and the judges that ask what they ask. Included by
# .make/exercises.mk, unless the tests are missing, as in a handout (.make/tables.mk).

# ---- the tests, the mistakes and the laws -----------------------------------------------------

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
renamed = $(CC) -E -P -x c -I. -DANSWERED=$(1) '-DPREFIX(name)=$(2)\#\#name' tests/judge/reference/rename.def
$(B)/reference.h: tests/judge/reference/rename.def tests/exercises.def $(SETUP_FIRST)
	$(Q)$(call renamed,0,reference_) > $@
BESIDE_REFERENCE := $(foreach kind,mistakes laws variants unknown,$(call parts,tests/[0-9]*/$(kind)))
$(BESIDE_REFERENCE): EXTRA = -include $(B)/reference.h
$(BESIDE_REFERENCE): $(B)/reference.h
REFERENCES := $(STEMS:%=$(B)/tests/reference/%.o)
$(REFERENCES): $(B)/tests/reference/%.o: solutions/%.c $(B)/reference.h $(B)/flags.mk $(SETUP_FIRST)
	$(call say,compile,$< as reference)
	$(Q)mkdir -p $(@D)
	$(Q)$(COMPILE) -include $(B)/reference.h -o $@ $<
# What the answers do beside the known mistakes.
HEARING := $(patsubst %,$(B)/tests/judge/%.o,reference/hearing reference/proxies reference/corners \
	switchboard $(DIAGNOSIS)) \
	$(B)/tests/judge/numbers.o $(CALLING) $(call parts,tests/[0-9]*/laws) $(REFERENCES)
# What calls an answering process.
TO_PROCESS := $(patsubst %,$(B)/tests/judge/%.o,call kept process ending system_call)
# With the reference for the chapters before, one mistake costs once; and the judge lends.
lent = $(B)/tests/judge/reference/lent.o
earlier_answers = $(patsubst %,$(B)/solutions/%.o,$(call earlier,$(1)))
for_debug = $(call test_objects,$(1))
JUDGES := $(STEMS:%=$(B)/judge/%)
$(JUDGES): $(B)/judge/%: $$(call tests_of,$$*) $$(call parts,tests/$$*/mistakes) $(TESTING) \
		$(HEARING) $(TO_PROCESS) $$(call parts,tests/$$*/probes) $(DRAWING) \
		$(REPORTING) $(patsubst %,$(B)/tests/judge/%.o,judge reference/right) $(B)/common.a
	$(call say,link,$@)
	$(Q)mkdir -p $(@D)
	$(Q)$(LINK) -o $@ $^ $(CHECK_LIBS) $(PNG_LIBS) -lm
# The matrix: the same, and in the place of the answering process a table that the reference fills.
MATRICES := $(STEMS:%=$(B)/tests/matrix/%)
$(call parts,tests/[0-9]*/composed): EXTRA = -include $(B)/weak.h
$(call parts,tests/[0-9]*/composed): $(B)/weak.h
$(MATRICES): $(B)/tests/matrix/%: $$(call tests_of,$$*) $$(call parts,tests/$$*/mistakes) \
		$$(call parts,tests/$$*/probes) $$(call parts,tests/$$*/variants) $$(call parts,tests/$$*/composed) $$(call parts,tests/$$*/unknown) \
		$(TESTING) $(HEARING) $(patsubst %,$(B)/tests/proof/%.o,matrix missing table) $(B)/common.a
	$(call say,link,$@)
	$(Q)mkdir -p $(@D)
	$(Q)$(LINK) -o $@ $^ $(CHECK_LIBS) $(PNG_LIBS) -lm

# What a new chapter lacks before anything of it can be linked.
lacks = $(or $(firstword $(foreach f,solutions/$(1).c tests/$(1).c tests/$(1)/mistakes.c \
	chapters/$(1)/README.md chapters/$(1)/main.c,$(if $(wildcard $(f)),,$(f)))), \
	$(if $(shell grep -F '"$(1)"' tests/exercises.def),,an entry in tests/exercises.def))
LACKS := $(if $(filter missing,$(MAKECMDGOALS)),$(strip $(foreach s,$(CHOSEN),$(call lacks,$(s)))))
missing: $(if $(LACKS),,$$(addprefix $$(B)/tests/matrix/,$$(CHOSEN))) ## what a new exercise or chapter still lacks (EX=02)
	@$(if $(LACKS),echo 'Next: $(CHOSEN) lacks $(LACKS)'; exit 1,for matrix in $^; do $$matrix --missing || exit 1; done)
.PHONY: missing

# Wrong answers that nobody has thought of: slips of the pen in every answer that is known, which
# the compiler sifts, and a program a stem that tries them. GENERATED_SEED=... makes others.
GENERATED_SEED ?= 2015
GENERATED_MOST ?= 400
MUTATE := $(B)/tests/proof/generated/mutate
$(MUTATE): $(patsubst %,$(B)/tests/proof/generated/%.o,mutate put source slips statements pen)
	$(call say,link,$@)
	$(Q)$(LINK) -o $@ $^
MUTANTS := $(STEMS:%=$(B)/generated/%.o)
answers_of = $(wildcard solutions/$(1).c tests/$(1)/mistakes*.[ch] tests/$(1)/variants*.[ch])
AS_REFERENCE = $(CC) $(LANGUAGE) -w -include $(B)/reference.h
$(MUTANTS): $(B)/generated/%.o: $(MUTATE) $$(call answers_of,$$*) $(B)/reference.h $(B)/flags.mk
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
TRIALS := $(STEMS:%=$(B)/tests/proof/generated/%)
$(TRIALS): $(B)/tests/proof/generated/%: $$(call tests_of,$$*) $$(call parts,tests/$$*/mistakes) \
		$$(call parts,tests/$$*/probes) $(TESTING) $(HEARING) $(B)/generated/%.o \
		$(patsubst %,$(B)/tests/proof/generated/%.o,try truth guard question ask_screen ask_cameras \
		ask_spheres ask_scenes ask_lights) $(B)/tests/handout/here.o $(B)/common.a
	$(call say,link,$@)
	$(Q)$(LINK) -o $@ $^ $(CHECK_LIBS) $(PNG_LIBS) -lm

# Blanks are made afresh, whatever stands in exercises/, and must pass nothing.
BLANK_TESTS := $(STEMS:%=$(B)/tests/blanks/%)
$(BLANK_TESTS:%=%.o): WARNINGS = $(FOR_STUDENTS)
$(BLANK_TESTS:%=%.o): $(B)/tests/blanks/%.o: build/blanks/%.c $(B)/flags.mk
	$(call say,compile,$<)
	$(Q)mkdir -p $(@D)
	$(Q)$(COMPILE) -o $@ $<
$(BLANK_TESTS): $(B)/tests/blanks/%: $(B)/tests/blanks/%.o $$(call test_objects,$$*)
	$(call say,link,$@)
	$(Q)$(LINK) -o $@ $^ $(CHECK_LIBS) $(PNG_LIBS) -lm

# Every engine of chapter 08 against the first: of scenes that are made, and of files; what memory
# it takes; and shadows and mirrors against chapter 07.
SAME_ENGINES := $(patsubst %,$(B)/tests/house/engines/%,same files memory)
ENGINES := $(B)/tests/house/engines/same $(B)/tests/house/engines/lit
ENGINES_LONG := $(filter-out $(ENGINES),$(SAME_ENGINES))
$(SAME_ENGINES): $(patsubst %,$(B)/tests/house/engines/%.o,against made made_difficult made_far parts)
$(B)/tests/house/engines/lit: $(B)/tests/house/engines/lit_scenes.o
$(ENGINES) $(ENGINES_LONG): %: %.o $(filter-out %/main.o,$(call chapter_objects,08-fast)) $(B)/chapters/shared.a \
		$(STEMS:%=$(B)/solutions/%.o) $(B)/common.a
	$(call say,link,$@)
	$(Q)$(LINK) -o $@ $^ $(PNG_LIBS) -lm -pthread

# What a hostile answer asks for when the reference is lent.
ODD_QUESTIONS := $(B)/tests/proof/odd_questions
$(ODD_QUESTIONS): $(ODD_QUESTIONS).o $(CALLING) $(REFERENCES) $(B)/common.a
	$(call say,link,$@)
	$(Q)$(LINK) -o $@ $^ -lm

# What a type's entry brings.
TYPES := $(B)/tests/proof/check_types
$(TYPES): $(TYPES).o $(B)/tests/judge/main.o $(TESTING) $(CALLING) $(patsubst %,$(B)/tests/%.o,judge/numbers judge/same) \
		$(B)/common.a
	$(call say,link,$@)
	$(Q)$(LINK) -o $@ $^ $(CHECK_LIBS) $(PNG_LIBS) -lm

# Numbers as they are read against the C library's.
NUMBERS := $(B)/tests/proof/exact/numbers
$(NUMBERS): $(NUMBERS).o $(B)/common.a
	$(call say,link,$@)
	$(Q)$(LINK) -o $@ $^ -lm

SAME := $(B)/tests/same_picture
$(B)/tests/proof/same_picture.o: EXTRA = $(PNG_CFLAGS)
$(SAME): $(B)/tests/proof/same_picture.o
	$(call say,link,$@)
	$(Q)$(LINK) -o $@ $^ $(PNG_LIBS)

# ---- recorded tables ----------------------------------------------------------------------------

# Where the tables come from; and right answers written otherwise, held against them.
TELLERS := $(STEMS:%=$(B)/replay/tell/%)
$(TELLERS): $(B)/replay/tell/%: $$(call tests_of,$$*) $$(call parts,tests/$$*/mistakes) \
		$$(call parts,tests/$$*/probes) $(TESTING) $(HEARING) $(B)/tests/handout/replay/table.o \
		$(patsubst %,$(B)/tests/handout/%.o,tell asked takes here) $(B)/common.a
	$(call say,link,$@)
	$(Q)mkdir -p $(@D)
	$(Q)$(LINK) -o $@ $^ $(CHECK_LIBS) $(PNG_LIBS) -lm
TABLES := $(STEMS:%=$(TABLE)/%.table)
$(TABLES): $(TABLE)/%.table: $(B)/replay/tell/%
	$(call say,tell,$@)
	$(Q)env -u SEED $< $@
TABLE_VARIANTS := $(patsubst tests/%/variants.c,$(B)/replay/variants/%,$(wildcard tests/[0-9]*/variants.c))
$(TABLE_VARIANTS): $(B)/replay/variants/%: $(filter-out $(HEARING),$(REPLAY)) $(B)/replay/path/%.o $(B)/tests/%/variants.o \
		$(patsubst %,$(B)/tests/handout/%.o,variants here) $(HEARING) $(B)/common.a | $(TABLE)/%.table
	$(call say,link,$@)
	$(Q)mkdir -p $(@D)
	$(Q)$(LINK) -o $@ $^ $(CHECK_LIBS) $(PNG_LIBS) -lm

KIT := $(B)/grading
CAN_GRADE := $(if $(JUDGES_ONLY),,$(shell pkg-config --exists libseccomp 2>/dev/null && command -v python3 && \
	command -v objdump))

# What the shell scripts among the tests are told. Grading has no sanitizers: a sandbox has no room.
GRADABLE := $(if $(SANITIZE),,$(if $(CAN_GRADE),$(KIT)))
FOR_TESTS = GENERATED_SEED='$(GENERATED_SEED)' KIT='$(GRADABLE)' PROGRAMS='$(BUILT)' BUILD='$(B)' ANSWERS='$(A)' CC='$(CC)' MAKEFLAGS= SANITIZE= \
	COMPILER='$(CC) $(LANGUAGE) $(CFLAGS) $(SANITIZER)'
CHECKS := $(COMMON_TESTS) $(NUMBERS) $(TYPES) $(ODD_QUESTIONS) $(TESTS) $(ENGINES) $(MATRICES) $(TABLE_CHECKS) $(TABLE_VARIANTS)
FOR_CHECKS := $(DRAW_FIGURES) $(MAKE_PAGE) $(EXPLAIN) $(BLANK_TESTS) $(PROGRAMS) $(PACK) $(GENERATED:%=$(B)/scenes/%.nff) $(SAME) $(JUDGES) $(GRADABLE:%=%/commands)
check: $(RUN) $(CHECKS) $(FOR_CHECKS) ## the tests (two minutes on two cores)
	@$(FOR_TESTS) $(RUN) $(BUILT)/log $(CHECKS) $(wildcard tests/house/*.sh)

# What needs longer: exact arithmetic, a minute of fuzzing, the tree as its users have it. With BRIEF=1
# (another compiler, a sanitizer) only what it can make a difference to.
FOR_LONG := $(FOR_CHECKS) $(ENGINES_LONG) $(if $(BRIEF),,$(TRIALS) $(BENCH_SCENES))
.PHONY: check-all check-long
check-all: $(RUN) $(CHECKS) $(FOR_LONG) ## those that need longer, too
	@$(FOR_TESTS) $(RUN) $(BUILT)/log $(CHECKS) $(wildcard tests/house/*.sh tests/proof/*.sh)

check-long: $(RUN) $(FOR_LONG) ## only those that need longer
	@$(FOR_TESTS) $(RUN) $(BUILT)/log $(NUMBERS) $(wildcard tests/proof/*.sh)
