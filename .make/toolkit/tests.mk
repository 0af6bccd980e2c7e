# tests.mk - make check: the tests of the exercises, and the judges that ask what they ask; and make bench. Included by
# .make/exercises.mk, unless the tests are missing, as in a handout.

# ---- the tests, the mistakes and the laws -----------------------------------------------------

# The tests, mistakes and laws of the stems. Each program has those of all stems, and its first argument
# chooses the stem (tests/judge/known.h).
parts = $(patsubst %.c,$(B)/%.o,$(wildcard $(1)*.c))
tests_of = $(call parts,tests/$(1))
known = $(call parts,tests/[0-9]*/$(1))
ALL_TESTS := $(call parts,tests/[0-9])
# The tests call proxies, which ask whoever answers. Mistakes and laws are beside the reference, which goes
# by other names there; so do answers that are linked into a program (tests/judge/reference/proxies.c).
as_names = sed -n 's/^ *\# *define //p'
$(B)/reference.names: tests/judge/names.def tests/exercises.def
	$(Q)mkdir -p $(@D)
	$(Q)$(call renamed,0,reference_) | $(as_names) > $@
# What is known of the stems: an entry need not use every parameter of its function (tests/judge/known.h).
KNOWN_ANSWERS := $(foreach kind,wrong right verdicts,$(call known,$(kind)))
FACTS := $(call known,facts)
BESIDE_REFERENCE := $(KNOWN_ANSWERS) $(FACTS)
$(BESIDE_REFERENCE): EXTRA = $(AS_KNOWN)
$(BESIDE_REFERENCE): $(B)/reference.h
$(REFERENCES): $(B)/tests/reference/%.o: $(B)/solutions/%.o $(B)/reference.names
	$(Q)mkdir -p $(@D)
	$(Q)objcopy --redefine-syms=$(B)/reference.names $< $@
# What the tests call.
CALLED := $(B)/tests/judge/reference/proxies.o $(CALLING) $(REFERENCES)
# With the reference for the chapters before, one mistake costs once; and the judge lends.
lent = $(B)/tests/judge/reference/lent_answers.o
earlier_answers = $(patsubst %,$(B)/solutions/%.o,$(call earlier,$(1)))

# The program that makes the tables of the tests and of all that is known. A table is made again if something of its
# stem changes.
RECORD := $(B)/tests/record
RECORDING := $(TESTING) $(CALLED) $(patsubst %,$(B)/tests/judge/%.o,laws table reference/record)
$(RECORD): $(ALL_TESTS) $(call known,wrong) $(FACTS) $(RECORDING) $(B)/common.a
	$(link_program)
$(TABLES): $(TABLE)/%.table: $$(call parts,tests/$$*) $$(call parts,tests/$$*/wrong) $$(call parts,tests/$$*/facts) $(RECORDING) $(B)/common.a | $(RECORD)
	$(call say,record,$@)
	$(Q)mkdir -p $(@D)
	$(Q)env -u SEED $(RECORD) $* $@

# The tests alone, calling an answer in their own process, and the reference for all other stems.
$(STEMS:%=$(B)/answer_names/%): $(B)/answer_names/%: tests/judge/names.def tests/exercises.def
	$(Q)mkdir -p $(@D)
	$(Q)$(call renamed,$(call answered,$*),answer_) | $(as_names) > $@
define direct_answers
$(STEMS:%=$(1)/direct/%.o): $(1)/direct/%.o: $(2)/%.o $(B)/answer_names/%
	$$(Q)mkdir -p $$(@D)
	$$(Q)objcopy --redefine-syms=$(B)/answer_names/$$* $$< $$@
endef
$(foreach folder,$(sort $(BUILT) $(B)/solutions $(B)/blanks),$(eval $(call direct_answers,$(folder),$(folder))))
DIRECT := $(ALL_TESTS) $(TESTING) $(CALLED) $(B)/tests/judge/reference/test_main.o
TESTS := $(BUILT)/tests
$(TESTS): $(DIRECT) $(STEMS:%=$(BUILT)/direct/%.o) $(B)/common.a
	$(link_program)
# Blanks are made afresh, whatever is in exercises/, and must pass nothing.
BLANK_TESTS := $(B)/tests/blanks
$(STEMS:%=$(B)/blanks/%.o): WARNINGS = $(FOR_STUDENTS)
$(STEMS:%=$(B)/blanks/%.o): $(B)/blanks/%.o: build/blanks/%.c $(B)/flags.mk
	$(call say,compile,$<)
	$(Q)mkdir -p $(@D)
	$(Q)$(COMPILE) -o $@ $<
$(BLANK_TESTS): $(DIRECT) $(STEMS:%=$(B)/blanks/direct/%.o) $(B)/common.a
	$(link_program)

# The matrix: all that is known, and in the place of the answering process a function of this one.
MATRIX := $(B)/tests/matrix
$(MATRIX): $(KNOWN_ANSWERS) $(JUDGING) $(REFERENCES) $(B)/tests/proof/matrix.o $(B)/common.a | $(TABLES)
	$(link_program)

# The missing parts of a new chapter, as long as it cannot be linked.
lacks = $(or $(firstword $(foreach f,solutions/$(1).c tests/$(1).c tests/$(1)/wrong.c \
	chapters/$(1)/README.md chapters/$(1)/main.c,$(if $(wildcard $(f)),,$(f)))), \
	$(if $(shell grep -F '"$(1)"' tests/exercises.def),,an entry in tests/exercises.def))
LACKS := $(if $(filter missing,$(MAKECMDGOALS)),$(strip $(foreach s,$(CHOSEN),$(call lacks,$(s)))))
missing: $(if $(LACKS),,$(MATRIX)) ##+ what a new exercise or chapter still lacks (EX=02)
	@$(if $(LACKS),echo 'Next: $(CHOSEN) lacks $(LACKS)'; exit 1,for stem in $(CHOSEN); do $(MATRIX) $$stem --missing || exit 1; done)
.PHONY: missing

# Wrong answers that nobody has thought of: slips of the pen in every answer that is known, which
# the compiler sifts, and a program that tries them. GENERATED_SEED=... makes others.
GENERATED_SEED ?= 2015
GENERATED_MOST ?= 200
MUTATE := tests/proof/generated/mutate.py
MUTANTS := $(STEMS:%=$(B)/generated/%.o)
answers_of = $(wildcard $(call exact_of,$(1)) tests/$(1)/wrong.c tests/$(1)/right.c)
AS_REFERENCE = $(CC) $(LANGUAGE) -w -DWITHOUT_LINES_OF_CALLS -include $(B)/reference.h
$(MUTANTS): $(B)/generated/%.o: $(MUTATE) $$(call answers_of,$$*) $(B)/reference.h $(B)/flags.mk tests/judge/known.h
	$(call say,mutate,$*)
	$(Q)rm -rf $(@D)/$* && mkdir -p $(@D)/$*
	$(Q)for source in $(filter %.c,$(call answers_of,$*)); do \
		$(AS_REFERENCE) '-DOF_STEM(part)=' '-DADD_KNOWN(kind, number)=' -E "$$source" -o "$(@D)/$*/$$(echo "$$source" | tr / -).i" || exit 1; done
	$(Q)$(call mutants_of,/dev/null)
	$(Q)$(subst -w,-Werror=incompatible-pointer-types,$(AS_REFERENCE)) $(ALL_ERRORS) -fsyntax-only \
		$(@D)/$*.c 2> $(@D)/$*.errors || true
	$(Q)$(call mutants_of,$(@D)/$*.errors)
	$(Q)$(subst -w,-Winit-self -Werror=uninitialized,$(AS_REFERENCE)) $(ALL_ERRORS) -O0 -c -o /dev/null \
		$(@D)/$*.c 2>> $(@D)/$*.errors || true
	$(Q)$(call mutants_of,$(@D)/$*.errors)
	$(Q)$(AS_REFERENCE) -O0 -fsanitize=bounds -fsanitize-undefined-trap-on-error -c -o $@ $(@D)/$*.c
# The compiler says first what is no C, and of the rest what reads variables that were never set:
# that is different for whoever asks.
mutants_of = python3 $(MUTATE) $(GENERATED_SEED) $(GENERATED_MOST) $(1) $(@D)/$*/*.i > $(@D)/$*.c
ALL_ERRORS = $(if $(findstring clang,$(CC)),-ferror-limit=0 -fno-caret-diagnostics,-fno-diagnostics-show-caret)
TRIALS := $(B)/tests/try_mutants
# Tables of other seeds: the same tests with other random numbers.
OTHER_SEEDS := 1 2
define other_tables
$(STEMS:%=$(B)/tables/seed-$(1)/%.table): $(B)/tables/seed-$(1)/%.table: $(TABLE)/%.table
	$$(call say,record,$$@)
	$$(Q)mkdir -p $$(@D)
	$$(Q)SEED=$(1) $(RECORD) $$* $$@
endef
$(foreach seed,$(OTHER_SEEDS),$(eval $(call other_tables,$(seed))))
$(TRIALS): $(JUDGING) $(REFERENCES) $(MUTANTS) $(B)/tests/proof/generated/try_mutants.o $(B)/common.a | \
		$(TABLES) $(foreach seed,$(OTHER_SEEDS),$(STEMS:%=$(B)/tables/seed-$(seed)/%.table))
	$(link_program)

# Every engine of chapter 08 against chapters 06 and 07: scenes that are made, and files.
ENGINES := $(B)/tests/house/engines/same_pictures
$(ENGINES): %: %.o $(B)/tests/house/engines/scenes.o $(filter-out %/main.o,$(call chapter_objects,$(ENGINE_CHAPTER))) \
		$(B)/chapters/shared.a $(STEMS:%=$(B)/solutions/%.o) $(B)/common.a
	$(call say,link,$@)
	$(Q)$(LINK) -o $@ $^ $(PNG_LIBS) -lm -pthread

# The deck's figures by known mistakes: a program for each chapter that has figures.
SWITCHED := $(STEMS:%=$(B)/tests/switched/%.o)
$(SWITCHED): $(B)/tests/switched/%.o: tests/proof/switched.c solutions/%.c $(B)/weak.h $(B)/flags.mk
	$(Q)mkdir -p $(@D)
	$(Q)$(COMPILE) -DANSWERED=$(call answered,$*) -include $(B)/weak.h -include solutions/$*.c -o $@ $<
MISTAKEN := $(patsubst %,$(B)/tests/mistaken/%,$(sort $(foreach figure,$(FIGURE_NAMES),$(call stem_of,$(figure)))))
$(MISTAKEN): $(B)/tests/mistaken/%: $(B)/tests/proof/mistaken_figures.o $$(call chapter_objects,$$*) $(call known,wrong) \
		$(TESTING) $(filter-out $(REFERENCES),$(CALLED)) $(SWITCHED) $(B)/tests/judge/answers_called.o $(B)/chapters/shared.a $(B)/common.a | $(B)/exercises.names
	$(call say,link,$@)
	$(Q)mkdir -p $(@D)
	$(Q)$(LINK) -Wl,--wrap=main $$(sed 's/^/-Wl,--wrap=/' $(B)/exercises.names) -o $@ $^ $(CHECK_LIBS) $(PNG_LIBS) -lm -pthread

KIT := $(B)/grading
CAN_GRADE := $(if $(JUDGES_ONLY),,$(shell pkg-config --exists libseccomp 2>/dev/null && command -v python3 && \
	command -v ld))

# The variables of the test scripts. Grading has no sanitizers, because a sandbox has no room for them.
GRADABLE := $(if $(SANITIZE),,$(if $(CAN_GRADE),$(KIT)))
FOR_TESTS = GENERATED_SEED='$(GENERATED_SEED)' KIT='$(GRADABLE)' PROGRAMS='$(BUILT)' BUILD='$(B)' ANSWERS='$(A)' CC='$(CC)' MAKEFLAGS= SANITIZE= \
	COMPILER='$(CC) $(LANGUAGE) $(CFLAGS) $(SANITIZER)'
CHECKS := $(COMMON_TESTS) $(ENGINES)
OF_STEMS := $(TESTS) $(MATRIX)
with_arguments = $(foreach program,$(OF_STEMS),$(STEMS:%='$(program) %')) 'tests/explain/check_cases.py $(EXPLAIN)' \
	'tests/proof/seeds.sh 4711' 'tests/house/grade.sh modules' 'tests/house/grade.sh attacks'
TRANSCRIPTS := $(wildcard tests/house/*.txt)
HOUSE := $(TRANSCRIPTS) $(wildcard tests/house/*.sh)
FOR_CHECKS := $(EXPLAIN) $(LIST) $(BLANK_TESTS) $(PROGRAMS) $(GENERATED:%=$(B)/scenes/%.nff) $(OF_STEMS) $(JUDGE) $(GRADABLE:%=%/commands) $(if $(BRIEF),,$(MISTAKEN))
# The scripts judge answers beside each other, each in a folder of its own, by the ordinary build: so all of that
# is there before they begin, and none of them builds it.
READY = $(PROGRAMS) $(DIRECT) $(FOR_EXERCISES)
ready: $$(READY)
READY_HERE = $(if $(SANITIZE),,$(READY))
READY_FIRST = $(if $(SANITIZE),$(if $(BRIEF),,MAKEFLAGS= $(MAKE_AGAIN) --no-print-directory $(MAKEOVERRIDES) SANITIZE= ready &&))
.PHONY: ready

check: $(CHECKS) $(FOR_CHECKS) $$(READY_HERE) ## the tests (T=word: only those with it in their name)
	@$(READY_FIRST) $(FOR_TESTS) $(RUN) $(BUILT)/log $(CHECKS) $(with_arguments) $(HOUSE)

accept: $(FOR_CHECKS) $$(READY) ##+ what the transcripts' commands print is now right: read the difference (T=word)
	@$(FOR_TESTS) $(PYTHON) tests/house/runner/transcript.py --accept $(foreach text,$(TRANSCRIPTS),$(if $(T),$(if \
		$(findstring $(T),$(text)),$(text)),$(text)))
.PHONY: accept

# The tests that need longer: a minute of fuzzing, the tree as its users have it. With BRIEF=1
# (another compiler, a sanitizer) only what it can make a difference to.
FOR_LONG := $(FOR_CHECKS) $(ENGINES) $(if $(BRIEF),,$(TRIALS) $(BENCH_SCENES) $(B)/tests/benches/flat)
# PROOFS='fuzz seeds': only these of tests/proof/.
PROOF_SCRIPTS := $(if $(PROOFS),$(PROOFS:%=tests/proof/%.sh),$(wildcard tests/proof/*.sh) \
	'tests/house/grade.sh long' 'tests/house/grade.sh attacks all')
.PHONY: check-all check-long
check-all: $(CHECKS) $(FOR_LONG) $$(READY_HERE) ##+ all tests, also those that need longer
	@$(READY_FIRST) $(FOR_TESTS) $(RUN) $(BUILT)/log $(CHECKS) $(with_arguments) $(HOUSE) $(PROOF_SCRIPTS)

check-long: $(FOR_LONG) ##+ only those that need longer (PROOFS='fuzz seeds': only these)
	@$(FOR_TESTS) $(RUN) $(BUILT)/log $(PROOF_SCRIPTS)

# ---- measurements: make bench, and its parts ----------------------------------------------------

# PEERS=1 measures chapter 08 beside Embree and POV-Ray; the benches name those that are not installed, and
# go on. OPTIONS are a bench's own, for example OPTIONS='-r 3 -l 1' (tests/benches/flat.c and shaded.c).
PEERS :=
OPTIONS :=
EMBREE := $(if $(PEERS),$(shell echo '\#include <embree3/rtcore.h>' | $(CC) -E -x c - >/dev/null 2>&1 && echo yes))
BENCHES := $(B)/tests/benches/flat $(B)/tests/benches/shaded
$(B)/tests/benches/embree.o: EXTRA = -O3 -march=native -fopenmp-simd -fno-math-errno \
	-fno-trapping-math -ffp-contract=fast -mprefer-vector-width=512
$(B)/tests/benches/peers.o: EXTRA = $(PNG_CFLAGS)
$(BENCHES): %: %.o $(patsubst %,$(B)/tests/benches/%.o,peers $(if $(EMBREE),embree embree_light)) \
		$(filter-out %/main.o,$(call chapter_objects,$(ENGINE_CHAPTER))) $(B)/chapters/$(SHADING_CHAPTER)/export.o \
		$(B)/chapters/shared.a $(STEMS:%=$(B)/solutions/%.o) $(B)/common.a
	$(call say,link,$@)
	$(Q)$(LINK) -o $@ $(filter %.o,$^) $(filter %.a,$^) $(if $(EMBREE),-lembree3) $(PNG_LIBS) -lm -pthread

MEASURED := $(B)/bench
bench-flat: $(B)/tests/benches/flat $(BENCH_SCENES) ##+ rays a second: engines, scenes, threads (PEERS=1: also Embree and POV-Ray)
bench-shaded: $(B)/tests/benches/shaded $(BENCH_SCENES) ##+ shaded pictures on all scenes (PEERS=1: also Embree and POV-Ray)
bench-flat bench-shaded:
	@mkdir -p $(MEASURED)
	@$< $(if $(PEERS),-p) $(OPTIONS) -o $(MEASURED) $(BENCH_SCENES) | tee $(MEASURED)/$@.txt
	@python3 -B tests/benches/tables.py $(MEASURED) > $(MEASURED)/tables.md && echo 'written: $(MEASURED)/$@.txt, *.csv, tables.md'

# Chapter 08 gets the numbers that were just measured: its table, CSV files and figure.
LESSON_08 := chapters/$(ENGINE_CHAPTER)
bench-record: ##+ the numbers, tables and figure of chapter 08 (PEERS=1, on an idle machine)
	@$(MAKE) --no-print-directory -s -j1 bench-flat bench-shaded
	@python3 -B tests/benches/tables.py $(MEASURED) $(LESSON_08)/engines.md > $(MEASURED)/engines.md
	@cp $(MEASURED)/engines.md $(LESSON_08)/ && cp $(MEASURED)/*.csv $(LESSON_08)/figures/
	@$(MAKE) --no-print-directory -s bench-figure
bench-figure: # chapter 08's figure, from its CSV files
	@python3 -B tests/benches/tables.py -f $(LESSON_08)/figures > $(B)/bench-figure.gp
	@for theme in light dark; do \
		gnuplot -e "theme = '$$theme'" $(B)/bench-figure.gp tests/benches/flat.gp > $(B)/bench-figure-$$theme.svg || exit 1; done
	@$(LESSON_FIGURES) --svg $(B)/bench-figure-light.svg $(B)/bench-figure-dark.svg 'Rays per second' \
		'Rays per second over spheres, both logarithmic.' > $(LESSON_08)/rays-per-second.svg
bench: $(JUDGE) $(GRADABLE:%=%/commands) ## from save to verdict; a class a minute; rays a second
	@$(MAKE) --no-print-directory -s -j1 bench-flat $(if $(PEERS),bench-shaded)
	@tests/benches/latency.sh
	@$(if $(GRADABLE),python3 -B tests/benches/grade.py $(KIT),echo 'grading is not measured: make setup FOR=instructor')
bench-grade: $(KIT)/commands # a class a minute; equal work for several tasks
	@python3 -B tests/benches/grade.py $(KIT)
.PHONY: bench bench-grade bench-flat bench-shaded bench-record bench-figure
