# tests.mk - make check: the tests of the exercises, and the judges that ask what they ask. Included by
# .make/exercises.mk, unless the tests are missing, as in a handout (.make/tables.mk).

# ---- the tests, the mistakes and the laws -----------------------------------------------------

# The tests, mistakes and laws of the stems. Each program has those of all stems, and its first argument
# chooses the stem (tests/judge/stem.h).
parts = $(patsubst %.c,$(B)/%.o,$(wildcard $(1)*.c))
tests_of = $(call parts,tests/$(1)) $(call parts,tests/$(1)/support)
known = $(call parts,tests/[0-9]*/$(1))
ALL_TESTS := $(call parts,tests/[0-9]) $(call known,support)
define link_program
	$(call say,link,$@)
	$(Q)mkdir -p $(@D) && rm -rf $@
	$(Q)$(LINK) -o $@ $^ $(CHECK_LIBS) $(PNG_LIBS) -lm
endef

# The tests call proxies, which ask whoever answers. Mistakes and laws are beside the reference, which goes
# by other names there; so do answers that are linked into a program (tests/judge/direct_answers.h).
renamed = $(CC) -E -P -x c -I. -DANSWERED=$(1) '-DPREFIX(name)=$(2)\#\#name' tests/judge/reference/rename.def
as_names = sed -n 's/^ *\# *define //p'
$(B)/reference.h: tests/judge/reference/rename.def tests/exercises.def $(SETUP_FIRST)
	$(Q)$(call renamed,0,reference_) > $@
$(B)/reference.names: $(B)/reference.h
	$(Q)$(as_names) $< > $@
BESIDE_REFERENCE := $(foreach kind,mistakes laws variants unknown,$(call known,$(kind)))
$(BESIDE_REFERENCE): EXTRA = -include $(B)/reference.h
$(BESIDE_REFERENCE): $(B)/reference.h
REFERENCES := $(STEMS:%=$(B)/tests/reference/%.o)
$(REFERENCES): $(B)/tests/reference/%.o: $(B)/solutions/%.o $(B)/reference.names
	$(Q)mkdir -p $(@D)
	$(Q)objcopy --redefine-syms=$(B)/reference.names $< $@
# The comparison of answers with the known mistakes.
HEARING := $(patsubst %,$(B)/tests/judge/%.o,reference/mistake_comparison reference/proxies reference/corners \
	switchboard $(DIAGNOSIS)) \
	$(B)/tests/judge/numbers.o $(CALLING) $(call known,laws) $(REFERENCES)
# The code that calls an answering process.
TO_PROCESS := $(patsubst %,$(B)/tests/judge/%.o,process_transport recorded_calls process one_processor crash_reason system_call)
# With the reference for the chapters before, one mistake costs once; and the judge lends.
lent = $(B)/tests/judge/reference/lent_answers.o
earlier_answers = $(patsubst %,$(B)/solutions/%.o,$(call earlier,$(1)))
$(JUDGE): $(ALL_TESTS) $(call known,mistakes) $(call known,probes) $(TESTING) \
		$(HEARING) $(TO_PROCESS) $(DRAWING) \
		$(REPORTING) $(patsubst %,$(B)/tests/judge/%.o,judge reference/right_answer) $(B)/common.a
	$(link_program)

# The tests alone, calling an answer in their own process, and the reference for all other stems.
$(STEMS:%=$(B)/answer_names/%): $(B)/answer_names/%: tests/judge/reference/rename.def tests/exercises.def $(SETUP_FIRST)
	$(Q)mkdir -p $(@D)
	$(Q)$(call renamed,$(call answered,$*),answer_) | $(as_names) > $@
define direct_answers
$(STEMS:%=$(1)/direct/%.o): $(1)/direct/%.o: $(2)/%.o $(B)/answer_names/%
	$$(Q)mkdir -p $$(@D)
	$$(Q)objcopy --redefine-syms=$(B)/answer_names/$$* $$< $$@
endef
$(foreach folder,$(sort $(BUILT) $(B)/solutions $(B)/blanks),$(eval $(call direct_answers,$(folder),$(folder))))
DIRECT := $(ALL_TESTS) $(TESTING) $(HEARING) $(patsubst %,$(B)/tests/judge/%.o,test_main call_directly direct_answers)
TESTS := $(BUILT)/tests
$(TESTS): $(DIRECT) $(STEMS:%=$(BUILT)/direct/%.o) $(B)/common.a
	$(link_program)
# For a debugger an answer keeps its names: the tests of its stem, and nobody in between.
for_debug = $(call tests_of,$(1)) $(TESTING) $(B)/tests/judge/test_main.o $(call earlier_answers,$(1)) $(B)/common.a
# tests/proof/mutants.sh links these with each of its answers.
$(STEMS:%=objects-of-%): objects-of-%: $$(call for_debug,$$*)
	@echo $^ $(CHECK_LIBS) $(PNG_LIBS) -lm

# Blanks are made afresh, whatever is in exercises/, and must pass nothing.
BLANK_TESTS := $(B)/tests/blanks
$(STEMS:%=$(B)/blanks/%.o): WARNINGS = $(FOR_STUDENTS)
$(STEMS:%=$(B)/blanks/%.o): $(B)/blanks/%.o: build/blanks/%.c $(B)/flags.mk
	$(call say,compile,$<)
	$(Q)mkdir -p $(@D)
	$(Q)$(COMPILE) -o $@ $<
$(BLANK_TESTS): $(DIRECT) $(STEMS:%=$(B)/blanks/direct/%.o) $(B)/common.a
	$(link_program)

# The matrix: the tests and all that is known, and in the place of the answering process a table that the
# reference fills.
MATRIX := $(B)/tests/matrix
$(call known,composed): EXTRA = -include $(B)/weak.h
$(call known,composed): $(B)/weak.h
$(MATRIX): $(ALL_TESTS) $(foreach kind,mistakes probes variants composed unknown,$(call known,$(kind))) \
		$(TESTING) $(HEARING) $(patsubst %,$(B)/tests/proof/%.o,matrix missing memorised_answers) $(B)/common.a
	$(link_program)

# The missing parts of a new chapter, as long as it cannot be linked.
lacks = $(or $(firstword $(foreach f,solutions/$(1).c tests/$(1).c tests/$(1)/mistakes.c \
	chapters/$(1)/README.md chapters/$(1)/main.c,$(if $(wildcard $(f)),,$(f)))), \
	$(if $(shell grep -F '"$(1)"' tests/exercises.def),,an entry in tests/exercises.def))
LACKS := $(if $(filter missing,$(MAKECMDGOALS)),$(strip $(foreach s,$(CHOSEN),$(call lacks,$(s)))))
missing: $(if $(LACKS),,$(MATRIX)) ## what a new exercise or chapter still lacks (EX=02)
	@$(if $(LACKS),echo 'Next: $(CHOSEN) lacks $(LACKS)'; exit 1,for stem in $(CHOSEN); do $(MATRIX) $$stem --missing || exit 1; done)
.PHONY: missing

# Wrong answers that nobody has thought of: slips of the pen in every answer that is known, which
# the compiler sifts, and a program a stem that tries them. GENERATED_SEED=... makes others.
GENERATED_SEED ?= 2015
GENERATED_MOST ?= 400
MUTATE := $(B)/tests/proof/generated/mutate
$(MUTATE): $(patsubst %,$(B)/tests/proof/generated/%.o,mutate write_mutants source slips statements slip_text)
	$(call say,link,$@)
	$(Q)$(LINK) -o $@ $^
MUTANTS := $(STEMS:%=$(B)/generated/%.o)
answers_of = $(wildcard solutions/$(1).c tests/$(1)/mistakes*.[ch] tests/$(1)/variants*.[ch])
AS_REFERENCE = $(CC) $(LANGUAGE) -w -include $(B)/reference.h
$(MUTANTS): $(B)/generated/%.o: $(MUTATE) $$(call answers_of,$$*) $(B)/reference.h $(B)/flags.mk
	$(call say,mutate,$*)
	$(Q)rm -rf $(@D)/$* && mkdir -p $(@D)/$*
	$(Q)for source in $(filter %.c,$(call answers_of,$*)); do \
		$(AS_REFERENCE) '-DOF_STEM(part)=' -E "$$source" -o "$(@D)/$*/$$(echo "$$source" | tr / -).i" || exit 1; done
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
TRIALS := $(B)/tests/try_generated
$(TRIALS): $(ALL_TESTS) $(call known,mistakes) $(call known,probes) $(TESTING) $(HEARING) $(MUTANTS) \
		$(patsubst %,$(B)/tests/proof/generated/%.o,judge_mutants truth guard question ask_screen ask_cameras \
		ask_spheres ask_scenes ask_lights) $(B)/tests/handout/direct_transport.o $(B)/common.a
	$(link_program)

# Slips of the pen in the solutions (tests/proof/mutants.sh).
SOLUTION_MUTANTS := $(B)/tests/proof/mutants/mutants
$(SOLUTION_MUTANTS): $(patsubst %,$(B)/tests/proof/mutants/%.o,mutants line_slips mutant_sum)
	$(call say,link,$@)
	$(Q)$(LINK) -o $@ $^

# Every engine of chapter 08 against the first: of scenes that are made, and of files; what memory
# it takes; and shadows and mirrors against chapter 07, and the grids of lights against its shadows.
SAME_ENGINES := $(patsubst %,$(B)/tests/house/engines/%,same_pictures same_pictures_of_files memory)
ENGINES := $(patsubst %,$(B)/tests/house/engines/%,same_pictures same_shading same_shadows same_steps)
ENGINES_LONG := $(filter-out $(ENGINES),$(SAME_ENGINES))
$(SAME_ENGINES): $(patsubst %,$(B)/tests/house/engines/%.o,compare_engines test_scenes difficult_scenes far_scenes scene_parts)
$(B)/tests/house/engines/same_shading: $(B)/tests/house/engines/shading_scenes.o
$(ENGINES) $(ENGINES_LONG): %: %.o $(filter-out %/main.o,$(call chapter_objects,$(ENGINE_CHAPTER))) $(B)/chapters/shared.a \
		$(STEMS:%=$(B)/solutions/%.o) $(B)/common.a
	$(call say,link,$@)
	$(Q)$(LINK) $(WRAPPED:%=-Wl,--wrap=%) -o $@ $^ $(PNG_LIBS) -lm -pthread
$(B)/tests/house/engines/same_steps: WRAPPED = pixel_ray hit_sphere surface_normal off_surface mirror_direction \
	ray_to_light shade clamp_color

# Questions that a hostile answer may ask while the reference is lent.
ODD_QUESTIONS := $(B)/tests/proof/odd_questions
$(ODD_QUESTIONS): $(ODD_QUESTIONS).o $(CALLING) $(REFERENCES) $(B)/common.a
	$(call say,link,$@)
	$(Q)$(LINK) -o $@ $^ -lm

# The code that follows from the entry of a type.
TYPES := $(B)/tests/proof/check_types
$(TYPES): $(TYPES).o $(B)/tests/judge/test_main.o $(TESTING) $(CALLING) $(patsubst %,$(B)/tests/%.o,judge/numbers judge/equal_numbers) \
		$(B)/common.a
	$(call say,link,$@)
	$(Q)$(LINK) -o $@ $^ $(CHECK_LIBS) $(PNG_LIBS) -lm

# Numbers as they are read against the C library's.
NUMBERS := $(B)/tests/proof/exact/numbers
$(NUMBERS): $(NUMBERS).o $(B)/common.a
	$(call say,link,$@)
	$(Q)$(LINK) -o $@ $^ -lm

# Figures of random wrong answers.
WRONG_FIGURE := $(B)/tests/proof/wrong_figure
$(WRONG_FIGURE): $(WRONG_FIGURE).o $(call known,mistakes) $(call known,support) $(TESTING) $(HEARING) $(TO_PROCESS) \
		$(DRAWING) $(B)/tests/judge/reference/right_answer.o $(B)/common.a
	$(link_program)

# Examples with other numbers.
RANDOM_EXAMPLE := $(B)/tests/proof/random_example
$(RANDOM_EXAMPLE): $(RANDOM_EXAMPLE).o $(B)/common.a
	$(call say,link,$@)
	$(Q)$(LINK) -o $@ $^ -lm

SAME := $(B)/tests/same_picture
$(B)/tests/proof/same_picture.o: EXTRA = $(PNG_CFLAGS)
$(SAME): $(B)/tests/proof/same_picture.o
	$(call say,link,$@)
	$(Q)$(LINK) -o $@ $^ $(PNG_LIBS)

# ---- recorded tables ----------------------------------------------------------------------------

# The program that writes the tables; and other right answers, compared with them.
TELL := $(B)/replay/tell
$(TELL): $(ALL_TESTS) $(call known,mistakes) $(call known,probes) $(TESTING) $(HEARING) $(B)/tests/handout/replay/table.o \
		$(patsubst %,$(B)/tests/handout/%.o,make_table test_recorder accepted_results direct_transport) $(B)/common.a
	$(link_program)
TABLES := $(STEMS:%=$(TABLE)/%.table)
$(TABLES): $(TABLE)/%.table: $(TELL)
	$(call say,tell,$@)
	$(Q)env -u SEED $< $* $@
TABLE_VARIANTS := $(B)/replay/variants
$(TABLE_VARIANTS): $(filter-out $(HEARING),$(REPLAY)) $(call known,variants) \
		$(patsubst %,$(B)/tests/handout/%.o,variants direct_transport) $(HEARING) $(B)/common.a | $(TABLES)
	$(link_program)

KIT := $(B)/grading
CAN_GRADE := $(if $(JUDGES_ONLY),,$(shell pkg-config --exists libseccomp 2>/dev/null && command -v python3 && \
	command -v ld))

# The variables of the test scripts. Grading has no sanitizers, because a sandbox has no room for them.
GRADABLE := $(if $(SANITIZE),,$(if $(CAN_GRADE),$(KIT)))
FOR_TESTS = GENERATED_SEED='$(GENERATED_SEED)' KIT='$(GRADABLE)' PROGRAMS='$(BUILT)' BUILD='$(B)' ANSWERS='$(A)' CC='$(CC)' MAKEFLAGS= SANITIZE= \
	COMPILER='$(CC) $(LANGUAGE) $(CFLAGS) $(SANITIZER)'
CHECKS := $(COMMON_TESTS) $(NUMBERS) $(TYPES) $(ODD_QUESTIONS) $(ENGINES)
OF_STEMS := $(TESTS) $(MATRIX) $(TABLE_CHECK) $(TABLE_VARIANTS)
of_stems = $(foreach program,$(OF_STEMS),$(STEMS:%='$(program) %'))
FOR_CHECKS := $(DRAW_FIGURES) $(MAKE_PAGE) $(EXPLAIN) $(BLANK_TESTS) $(PROGRAMS) $(PACK) $(GENERATED:%=$(B)/scenes/%.nff) $(SAME) $(B)/tests/benches/tables $(OF_STEMS) $(JUDGE) $(GRADABLE:%=%/commands)
# The scripts judge answers beside each other, each in a folder of its own, by the ordinary build: so all of that
# is there before they begin, and none of them builds it.
READY = $(DRAW_FIGURES) $(MAKE_PAGE) $(PROGRAMS) $(PACK) $(DIRECT) $(FOR_EXERCISES)
ready: $$(READY)
READY_HERE = $(if $(SANITIZE),,$(READY))
READY_FIRST = $(if $(SANITIZE),$(if $(BRIEF),,MAKEFLAGS= $(MAKE_AGAIN) --no-print-directory $(MAKEOVERRIDES) SANITIZE= ready &&))
.PHONY: ready

check: $(RUN) $(CHECKS) $(FOR_CHECKS) $$(READY_HERE) ## the tests (two minutes on two cores)
	@$(READY_FIRST) $(FOR_TESTS) $(RUN) $(BUILT)/log $(CHECKS) $(of_stems) $(wildcard tests/house/*.sh)

# The tests that need longer: exact arithmetic, a minute of fuzzing, the tree as its users have it. With BRIEF=1
# (another compiler, a sanitizer) only what it can make a difference to.
FOR_LONG := $(FOR_CHECKS) $(ENGINES_LONG) $(WRONG_FIGURE) $(if $(BRIEF),,$(TRIALS) $(SOLUTION_MUTANTS) $(BENCH_SCENES) $(RANDOM_EXAMPLE))
.PHONY: check-all check-long
check-all: $(RUN) $(CHECKS) $(FOR_LONG) $$(READY_HERE) ## all tests, also those that need longer
	@$(READY_FIRST) $(FOR_TESTS) LONG=yes $(RUN) $(BUILT)/log $(CHECKS) $(of_stems) $(wildcard tests/house/*.sh tests/proof/*.sh)

check-long: $(RUN) $(NUMBERS) $(FOR_LONG) ## only those that need longer
	@$(FOR_TESTS) $(RUN) $(BUILT)/log $(wildcard tests/proof/*.sh)
