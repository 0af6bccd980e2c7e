# Ray casting, step by step. 'make help' lists what can be made; README.md says what for.
# The parts that it includes are in .make/, a subject each.
#
# Which answers are linked is chosen here and nowhere else: ANSWERS=exercises (yours),
# ANSWERS=solutions, or any folder. Missing answers are replaced by blanks.
.DELETE_ON_ERROR:
.SUFFIXES:
.DEFAULT_GOAL := all

# 'make setup all': a second make builds, and finds what setup has installed.
AFTER_SETUP := $(if $(filter setup,$(MAKECMDGOALS)),$(filter-out setup,$(MAKECMDGOALS)))
ifneq ($(AFTER_SETUP),)
$(AFTER_SETUP): after-setup ;
after-setup: setup
	@$(MAKE) --no-print-directory $(AFTER_SETUP)
setup:
	@.make/setup $(FOR)
.PHONY: $(AFTER_SETUP) after-setup setup
else

# No rules but those that are written here (-r). As many jobs as there are processors, unless -j says something else.
# (One shell asks all questions about this machine, because make also asks them between a saved answer and its verdict.)
ASKED := $(shell getconf _NPROCESSORS_ONLN 2>/dev/null || echo 2; uname -m; $(CC) --version 2>/dev/null | { IFS= read -r line; echo "$$line"; })
MAKEFLAGS += -r -j$(firstword $(ASKED))

# A students' handout has no solutions/, no tests of the exercises and no .make/toolkit/. The
# existing files decide.
ANSWERS ?= $(if $(wildcard solutions/.),solutions,exercises)
STEMS := $(sort $(notdir $(basename $(wildcard exercises/*.h))))

# Questions that matter only when all chapters are built or drawn are not asked between a saved
# answer and its verdict.
JUDGES_ONLY := $(if $(filter-out exercises watch hint debug reset status submission optional tasks,$(or $(MAKECMDGOALS),all)),,yes)

# Answers inside the tree are named from its top, others by their whole path. Not by patsubst: the
# path of the tree may have a '%'.
A := $(subst |,,$(subst |$(CURDIR)/,,|$(abspath $(ANSWERS))))
ifneq ($(words $(CURDIR)),1)
$(error make cannot work in a folder whose path has a blank: '$(CURDIR)'. Rename the folder, or copy it to another place)
endif
ifneq ($(words $(ANSWERS)),1)
$(error ANSWERS='$(ANSWERS)': expected one folder, whose path has no blank)
endif
ifneq ($(findstring %,$(A)),)
$(error ANSWERS='$(ANSWERS)': expected a folder whose path has no '%')
endif
ifeq ($(wildcard $(A)/.),)
$(error ANSWERS=$(ANSWERS): no such folder)
endif
ifeq ($(wildcard $(STEMS:%=$(A)/%.c)),)
$(error ANSWERS=$(ANSWERS): no answer in it, expected $(firstword $(STEMS)).c and the like)
endif

# If an answer is missing, the pictures that do not need it are still drawn.
ifneq ($(A),solutions)
MAKEFLAGS += -k
endif

# SANITIZE=address,undefined builds beside the ordinary build, not over it.
comma := ,
B := build$(if $(SANITIZE),/sanitize-$(subst $(comma),-,$(SANITIZE)))
# EXAMPLE=name: with the numbers of chapters/examples/NAME.txt, beside the build with the deck's.
ANSWERS_BUILT := $(B)/$(A:/%=%)
# WORDS=german.txt: figures with words of your own (chapters/words.txt), beside those in English.
BUILT := $(B)$(EXAMPLE:%=/examples/%)$(if $(WORDS),/words/$(basename $(notdir $(WORDS))))/$(A:/%=%)

# All that is made is in build/, which must be ours: not a tree that can only be read, nor one that
# was built with sudo. 'find' stops at the first file that cannot be written, if it knows how: test then asks
# once more, because a file that another make has just removed cannot be written either.
ifneq ($(filter-out setup help clean,$(or $(MAKECMDGOALS),all)),)
OURS := $(shell { [ -d build ] || mkdir -p build 2>/dev/null; } && [ -w build ] && echo yes; \
	find build ! -writable ! -type l -exec test -e '{}' ';' ! -exec test -w '{}' ';' -print -quit 2>/dev/null)
ifeq ($(OURS)$(wildcard build/.),)
$(error make cannot write into $(CURDIR): it needs a copy of the tree that is yours)
endif
NOT_OURS := $(filter-out yes,$(OURS))
ifneq ($(NOT_OURS),)
$(error make cannot write to '$(NOT_OURS)' (was it made with sudo?): remove the folder 'build' (sudo rm -rf build), or take a copy of the tree that is yours)
endif
ifneq ($(wildcard tests/given.tar),)
$(shell [ -e build/given ] && [ ! tests/given.tar -nt build/given ] || { tar xmf tests/given.tar -C build && touch -r tests/given.tar build/given; })
endif
endif
# What only programs read (layouts, scenes, hints, tables) is one file in a handout, and is unpacked where programs look
# for it (common/toolkit_file.h). So are the laws and the blanks.
GIVEN := $(if $(wildcard tests/given.tar),build/)
vpath %/laws.c build

# ---- compiling --------------------------------------------------------------------------------

CFLAGS ?= -O2 -g
WERROR ?= $(if $(CI),-Werror)
# -ffp-contract=off: fused multiplications would make pictures differ between machines.
# -Wno-psabi: gcc notes that a vec3 is passed in another way if AVX is on. That does not matter in a
# build with one compiler and one set of flags, which the stamp below guarantees.
# -Wno-enum-float-conversion: clang 19 warns of a double times a number that an enum names.
LANGUAGE := -std=c11 -D_DEFAULT_SOURCE -ffp-contract=off -Wno-psabi -I.
STRICT := -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Wstrict-prototypes -Wmissing-prototypes \
	-Wno-enum-float-conversion
# Two warnings are errors for everybody: what is left out there is found by luck or not at all. Three of -Wextra
# and -Wall are about code that means what its writer thinks: (Roots){2}, (Roots){1, t}, size_t i < count.
FOR_STUDENTS := -Wall -Wextra -Wno-unused-parameter -Wno-missing-field-initializers -Wno-missing-braces \
	-Wno-sign-compare -Werror=return-type -Werror=implicit-function-declaration
SANITIZER := $(if $(SANITIZE),-fsanitize=$(SANITIZE) -fno-sanitize-recover=all)
WARNINGS = $(STRICT) $(WERROR)
COMPILE = $(CC) $(LANGUAGE) $(CFLAGS) $(OPTIMIZE) $(SANITIZER) $(WARNINGS) $(EXTRA) $(CPPFLAGS) -MMD -MP -c
LINK = $(CC) $(CFLAGS) $(SANITIZER) $(LDFLAGS)

# A change of compiler or flags builds all again: objects of two kinds must not be mixed.
FLAGS_NOW := $(wordlist 3,99,$(ASKED)) $(LANGUAGE) $(CFLAGS) $(CPPFLAGS) \
	$(LDFLAGS) $(SANITIZER) $(STRICT) $(WERROR)
include $(wildcard $(B)/flags.mk)
ifneq ($(strip $(FLAGS_NOW)),$(strip $(FLAGS_WERE)))
$(shell { mkdir -p $(B) && printf 'FLAGS_WERE := %s\n' '$(FLAGS_NOW)' > $(B)/flags.mk; } 2>/dev/null)
endif

# What reads and writes text while the tree is built; it leaves nothing beside the sources.
PYTHON := python3 -B

Q := $(if $(V),,@)
say = $(if $(V),,@$(TALK))
TALK = printf '  %-9s %s\n' '$(1)' '$(2)'
# A student wants the verdict, not what it took.
ifneq ($(filter exercises watch hint debug submission optional tasks,$(MAKECMDGOALS)),)
TALK = :
endif

# Make, for a recipe that 'make -n' must not run, as it would if $(MAKE) were in it.
MAKE_AGAIN = $(MAKE)

# Libraries are looked for when the first rule needs them: 'make setup' installs them.
look = $(if $(shell pkg-config --exists $(1) 2>/dev/null && echo yes),$(shell \
	pkg-config $(2) $(1)),$(error $(1) (or pkg-config) is missing: 'make setup' installs it))
PNG_CFLAGS = $(eval PNG_CFLAGS := $$(call look,libpng,--cflags))$(PNG_CFLAGS)
PNG_LIBS = $(eval PNG_LIBS := $$(call look,libpng,--libs))$(PNG_LIBS)
CHECK_CFLAGS = $(eval CHECK_CFLAGS := $$(call look,check,--cflags))$(CHECK_CFLAGS)
CHECK_LIBS = $(eval CHECK_LIBS := $$(call look,check,--libs))$(CHECK_LIBS)

$(B)/%.o: %.c $(B)/flags.mk
	$(call say,compile,$<)
	$(Q)mkdir -p $(@D)
	$(Q)$(COMPILE) -o $@ $<

$(B)/common/image_png.o: EXTRA = $(PNG_CFLAGS)
$(B)/tests/%.o: EXTRA = $(CHECK_CFLAGS)

$(B)/common.a: $(patsubst %.c,$(B)/%.o,$(wildcard common/*.c common/figure/*.c))
# The code that the programs of several chapters share. From both archives the linker takes what it needs.
$(B)/chapters/shared.a: $(patsubst %.c,$(B)/%.o,$(wildcard chapters/shared/*.c))
$(B)/common.a $(B)/chapters/shared.a:
	$(call say,archive,$@)
	$(Q)rm -f $@ && $(AR) rcs $@ $^

# ---- answers ----------------------------------------------------------------------------------

# If a folder lacks an answer, the blank is used.
BLANKS := $(STEMS:%=build/blanks/%.c)
# Blanks are made from the solutions.
build/blanks/%.c: solutions/%.c solutions/make_blank
	$(Q)mkdir -p $(@D)
	$(Q)solutions/make_blank $< > $@

# Students' answers: friendly warnings, and every exercise 'weak', so that a test can put the
# reference in the place of one of them (tests/course/judging.c).
$(B)/weak.h: tests/judge/names.def tests/exercises.def
	$(Q)$(CC) -E -P -x c -I. $< > $@
FOR_ANSWERS = $(FOR_STUDENTS) -include $(B)/weak.h
# Helpers may go anywhere, so two chapters may use one name: only the exercises are seen from outside.
$(B)/exercises.names: $(B)/weak.h
	$(Q)sed -n 's/^ *# *pragma weak //p' $< > $@
HIDE_HELPERS = objcopy --keep-global-symbols=$(B)/exercises.names

# The judge, the programs and the engines have right answers with all their digits where the slide's formulas, which
# are the solution, lose some.
exact_of = $(or $(wildcard tests/$(1)/exact.c),solutions/$(1).c)
EXACT := $(patsubst tests/%/exact.c,%,$(wildcard tests/*/exact.c))
$(EXACT:%=$(B)/solutions/%.o): $(B)/solutions/%.o: tests/%/exact.c $(B)/flags.mk
	$(call say,compile,$<)
	$(Q)mkdir -p $(@D)
	$(Q)$(COMPILE) -o $@ $<

# An answer counts as changed when its text has changed: dates deceive where files are moved back.
answer_in = $(or $(wildcard $(1)/$(2).c),build/blanks/$(2).c)
ANSWER_OBJECTS := $(STEMS:%=$(ANSWERS_BUILT)/%.o)
ifneq ($(A),solutions)
$(STEMS:%=$(ANSWERS_BUILT)/%.text): $(ANSWERS_BUILT)/%.text: build/blanks/%.c FORCE
	@mkdir -p $(@D)
	@cmp -s $(call answer_in,$(A),$*) $@ || cp $(call answer_in,$(A),$*) $@
$(ANSWER_OBJECTS): WARNINGS = $(FOR_ANSWERS)
$(ANSWER_OBJECTS): $(ANSWERS_BUILT)/%.o: $(ANSWERS_BUILT)/%.text $(B)/flags.mk $(B)/weak.h \
		$(B)/exercises.names build/blanks/%.c
	$(call say,compile,$(call answer_in,$(A),$*))
	$(Q)$(COMPILE) -o $@ $(call answer_in,$(A),$*) || { rm -f $(@:.o=.d); exit 1; }
	$(Q)$(HIDE_HELPERS) $@
	@sed -i.bak 's|$(call answer_in,$(A),$*)||' $(@:.o=.d) && rm -f $(@:.o=.d.bak)
endif

# The example's object comes before the archive that has the deck's.
ifneq ($(EXAMPLE),)
EXAMPLE_TEXT := chapters/examples/$(EXAMPLE).txt
ifeq ($(wildcard $(EXAMPLE_TEXT)),)
$(error EXAMPLE=$(EXAMPLE): there is no $(EXAMPLE_TEXT), expected one of $(patsubst chapters/examples/%.txt,%,$(wildcard chapters/examples/*.txt)))
endif
ifneq ($(filter-out slides figures animations,$(or $(MAKECMDGOALS),all)),)
$(error EXAMPLE=$(EXAMPLE) goes with make slides, figures or animations; for the lessons and tests, change chapters/example.h)
endif
EXAMPLE_HEADER := $(B)/examples/$(EXAMPLE)/example.h
EXAMPLE_OBJECT := $(B)/examples/$(EXAMPLE)/example.o
ANSWER_OBJECTS += $(EXAMPLE_OBJECT)
$(EXAMPLE_HEADER): $(EXAMPLE_TEXT) chapters/examples/read_example.py chapters/example.h
	$(Q)mkdir -p $(@D)
	$(Q)$(PYTHON) chapters/examples/read_example.py $< > $@
$(EXAMPLE_OBJECT): chapters/shared/example.c $(EXAMPLE_HEADER) $(B)/flags.mk
	$(call say,compile,$(EXAMPLE_TEXT))
	$(Q)$(COMPILE) -include $(EXAMPLE_HEADER) -o $@ $<
endif

# ---- programs, scenes, pictures ---------------------------------------------------------------

# A chapter is a folder with a main.c.
CHAPTERS := $(patsubst chapters/%/main.c,%,$(sort $(wildcard chapters/*/main.c)))
PROGRAMS := $(CHAPTERS:%=$(BUILT)/%)
chapter_objects = $(patsubst %.c,$(B)/%.o,$(filter-out %_nff.c %_lanes.c,$(wildcard \
	chapters/$(1)/*.c chapters/$(1)/*/*.c))) $(foreach k,$(LANES_KINDS),$(patsubst %.c,$(B)/%.$(k).o,$(wildcard \
	chapters/$(1)/*/*_lanes.c)))

# The loops in NAME_lanes.c are compiled for several instruction sets; which of them a processor has
# is asked when the program runs (parallel.c of that chapter). Nowhere but there may multiplications
# be fused with additions: what these loops decide, they decide with a margin. The steps of light
# have no margin: they must have the solutions' bits.
LANES_KINDS := baseline $(if $(JUDGES_ONLY),,$(if $(filter x86_64%,$(shell $(CC) -dumpmachine 2>/dev/null)),avx2 avx512))
FOR_avx2 := -mavx2 -mfma
FOR_avx512 := $(FOR_avx2) -mavx512f -mavx512vl -mavx512bw -mavx512dq -mprefer-vector-width=512
FOR_LANES := -O3 -fopenmp-simd -fno-math-errno -fno-trapping-math -ffp-contract=fast
define lanes_rule
$(B)/%.$(1).o: %.c $(B)/flags.mk
	$$(call say,compile,$$< for $(1))
	$$(Q)mkdir -p $$(@D)
	$$(Q)$$(COMPILE) $$(FOR_LANES) $$(FOR_$(1)) -DLANES_KIND=$(1) -o $$@ $$<
endef
$(foreach k,$(LANES_KINDS),$(eval $(call lanes_rule,$(k))))
$(LANES_KINDS:%=$(B)/chapters/08-fast/engines/light_steps_lanes.%.o): FOR_LANES += -ffp-contract=off

.SECONDEXPANSION:
# Programs of other answers than the solutions note which they call.
ANSWERS_CALLED := $(if $(filter-out solutions,$(A)),$(B)/tests/judge/answers_called.o)
NOTE_CALLS := $(if $(ANSWERS_CALLED),$$(sed 's/^/-Wl,--wrap=/' $(B)/exercises.names))
$(PROGRAMS): $(BUILT)/%: $$(call chapter_objects,$$*) $(ANSWER_OBJECTS) $(ANSWERS_CALLED) $(B)/chapters/shared.a $(B)/common.a
	$(call say,link,$@)
	$(Q)mkdir -p $(@D)
	$(Q)$(LINK) $(NOTE_CALLS) -o $@ $^ $(PNG_LIBS) -lm -pthread

GALLERY := $(BUILT)/gallery
# A picture that lacks an answer is not an error: its program says so in one line (common/answers.h).
TRY = $(if $(filter solutions,$(ANSWERS)),,NOT_YET=$@)
# The picture of a chapter, which chapters/gallery/contents.txt describes in words. The other pictures
# of a chapter, and the scenes of which they are cast, are in its chapter.mk.
CHAPTER_PICTURES := $(filter $(CHAPTERS),$(file <chapters/gallery/contents.txt))
PICTURES := $(CHAPTER_PICTURES:%=$(GALLERY)/%.png)
$(PICTURES): $(GALLERY)/%.png: $(BUILT)/%
	$(call say,cast,$@)
	$(Q)mkdir -p $(@D)
	$(Q)$(TRY) $< --picture $@
SCENES :=
include $(sort $(wildcard chapters/*/chapter.mk))

# Scenes that a program writes: chapters/NN-stem/NAME_nff.c writes NAME-x.nff, given its ARGUMENTS.
NFF_PROGRAMS := $(patsubst %.c,$(B)/%,$(wildcard chapters/*/*_nff.c))
$(NFF_PROGRAMS): %: %.o $(B)/chapters/shared.a $(B)/common.a
	$(call say,link,$@)
	$(Q)$(LINK) -o $@ $^ -lm
generator_of = $(B)/$(basename $(wildcard chapters/*/$(firstword $(subst -, ,$(1)))_nff.c))
$(SCENES): $(B)/scenes/%.nff: $$(call generator_of,$$*)
	$(call say,scene,$@)
	$(Q)mkdir -p $(@D)
	$(Q)$< $(ARGUMENTS) > $@

include .make/figures.mk

# The stamp tells whether there was anything to do.
$(BUILT)/made: $(PROGRAMS) $(PICTURES) $(PAGE) $(B)/compile_commands.json $$(FOR_EXERCISES)
	@touch $@
	@$(eval DONE := yes)

all: $(BUILT)/made ## build, cast pictures, draw figures (ANSWERS=folder: by it)
	@if [ -s $(DRAWN) ]; then figures="No figures: 'make setup' installs $$(cat $(DRAWN))"; \
		else figures='Figures: $(DRAWN_FIGURES)/'; fi; \
	if [ -e $(PAGE) ]; then page='$(PAGE)'; else page="none, 'make setup' installs python3"; fi; \
	$(if $(DONE),printf '%s\n' 'Done. Programs: $(BUILT)/NN-stem' 'Pictures: $(GALLERY)/' "$$figures" \
		"All on one page: $$page",echo "Nothing to do: all is up to date. The page: $$page")
	$(SAY_WRONG)

setup: ## install what is missing (FOR=lecturer, instructor, contributor, book, bench)
	@.make/setup $(FOR)

include .make/tests.mk
include .make/exercises.mk
include $(wildcard .make/toolkit/instructor.mk .make/toolkit/lecture.mk .make/toolkit/book.mk)
include .make/house.mk

.PHONY: all setup check exercises watch hint debug reset
# Which headers each object includes; but not those of another build, nor between a saved answer and its verdict those
# of tests of the toolkit. (The empty rule: make would look for a way to make each of these files.)
OTHER_BUILDS := $(B)/sanitize-* $(B)/wasm* $(if $(JUDGES_ONLY),$(B)/tests/house $(B)/tests/proof $(B)/tests/grade)
INCLUDED := $(shell find $(B) \( -name '' $(OTHER_BUILDS:%=-o -path '%') \) -prune -o -name '*.d' -print 2>/dev/null)
-include $(INCLUDED)
$(INCLUDED): ;
endif
