# Ray casting, step by step. 'make help' lists what can be made; README.md says what for.
#
# Which answers are linked is chosen here and nowhere else: ANSWERS=exercises (yours),
# ANSWERS=solutions, or any folder. What it lacks is filled with blanks.
.DELETE_ON_ERROR:
.SUFFIXES:
.DEFAULT_GOAL := all

# As many at a time as there are processors, unless -j says otherwise.
MAKEFLAGS += -j$(shell getconf _NPROCESSORS_ONLN 2>/dev/null || echo 2)

#[ Between '#[' and '#]' stands what the students' handout lacks; behind '#~' what it has instead.
ANSWERS ?= solutions
#]
#~ ANSWERS ?= exercises
STEMS := $(sort $(notdir $(basename $(wildcard exercises/*.h))))

# Answers inside the tree are named from its top, others by their whole path.
A := $(patsubst $(CURDIR)/%,%,$(abspath $(ANSWERS)))
ifneq ($(words $(ANSWERS) $(CURDIR)),2)
$(error make cannot work in, or on answers in, a folder whose path has a blank: '$(or $(ANSWERS),?)')
endif
ifeq ($(wildcard $(A)/.),)
$(error ANSWERS=$(ANSWERS): no such folder)
endif
ifeq ($(wildcard $(STEMS:%=$(A)/%.c)),)
$(error ANSWERS=$(ANSWERS): no answer in it, expected $(firstword $(STEMS)).c and the like)
endif

# Where an answer is missing, the pictures that do without it are drawn all the same.
ifneq ($(A),solutions)
MAKEFLAGS += -k
endif

# SANITIZE=address,undefined builds beside the ordinary build, not over it.
comma := ,
B := build$(if $(SANITIZE),/sanitize-$(subst $(comma),-,$(SANITIZE)))
BUILT := $(B)/$(A:/%=%)

# ---- compiling --------------------------------------------------------------------------------

CFLAGS ?= -O2 -g
WERROR ?= $(if $(CI),-Werror)
# -ffp-contract=off: fused multiplications would make pictures differ between machines.
# -Wno-psabi: gcc notes that a vec3 is passed in another way where AVX is on; that is no concern
# of a build with one compiler and one set of flags, which the stamp below makes sure of.
LANGUAGE := -std=c11 -D_DEFAULT_SOURCE -ffp-contract=off -Wno-psabi -I.
STRICT := -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Wstrict-prototypes -Wmissing-prototypes
# Two warnings are errors for everybody: what is left out there is found by luck or not at all.
FOR_STUDENTS := -Wall -Wextra -Wno-unused-parameter -Werror=return-type \
	-Werror=implicit-function-declaration
SANITIZER := $(if $(SANITIZE),-fsanitize=$(SANITIZE) -fno-sanitize-recover=all)
WARNINGS = $(STRICT) $(WERROR)
COMPILE = $(CC) $(LANGUAGE) $(CFLAGS) $(SANITIZER) $(WARNINGS) $(EXTRA) $(CPPFLAGS) -MMD -MP -c
LINK = $(CC) $(CFLAGS) $(SANITIZER) $(LDFLAGS)

# A change of compiler or flags builds all again: objects of two kinds must not be mixed.
FLAGS_NOW := $(shell $(CC) --version 2>/dev/null | head -n 1) $(LANGUAGE) $(CFLAGS) $(CPPFLAGS) \
	$(LDFLAGS) $(SANITIZER) $(STRICT) $(WERROR)
ifneq ($(FLAGS_NOW),$(shell cat $(B)/flags 2>/dev/null))
$(shell mkdir -p $(B) && printf '%s\n' '$(FLAGS_NOW)' > $(B)/flags)
endif

Q := $(if $(V),,@)
say = $(if $(V),,@$(TALK))
TALK = printf '  %-9s %s\n' '$(1)' '$(2)'
# A student wants the verdict, not what it took.
ifneq ($(filter exercises watch hint debug,$(MAKECMDGOALS)),)
TALK = :
endif

# Libraries are looked for when the first rule needs them, so that 'make setup all' sees what setup
# has just installed.
look = $(if $(shell pkg-config --exists $(1) 2>/dev/null && echo yes),$(shell \
	pkg-config $(2) $(1)),$(error $(1) (or pkg-config) is missing: 'make setup' installs it))
PNG_CFLAGS = $(eval PNG_CFLAGS := $$(call look,libpng,--cflags))$(PNG_CFLAGS)
PNG_LIBS = $(eval PNG_LIBS := $$(call look,libpng,--libs))$(PNG_LIBS)
CHECK_CFLAGS = $(eval CHECK_CFLAGS := $$(call look,check,--cflags))$(CHECK_CFLAGS)
CHECK_LIBS = $(eval CHECK_LIBS := $$(call look,check,--libs))$(CHECK_LIBS)

# 'make setup all' installs before anything is compiled, with -j too.
SETUP_FIRST := $(if $(filter setup,$(MAKECMDGOALS)),| setup)

$(B)/%.o: %.c $(B)/flags $(SETUP_FIRST)
	$(call say,compile,$<)
	$(Q)mkdir -p $(@D)
	$(Q)$(COMPILE) -o $@ $<

$(B)/common/image_png.o: EXTRA = $(PNG_CFLAGS)
$(B)/tests/%.o: EXTRA = $(CHECK_CFLAGS)

$(B)/common.a: $(patsubst %.c,$(B)/%.o,$(wildcard common/*.c))
	$(call say,archive,$@)
	$(Q)rm -f $@ && $(AR) rcs $@ $^

# ---- answers ----------------------------------------------------------------------------------

# Where a folder lacks an answer, the blank stands in.
BLANKS := $(STEMS:%=build/blanks/%.c)
#[ Blanks are made from the solutions.
build/blanks/%.c: solutions/%.c .make/blank.awk
	$(Q)mkdir -p $(@D)
	$(Q)awk -f .make/blank.awk $< > $@
#]
#~ build/blanks/%.c: tests/told/blanks/%.c
#~ 	$(Q)mkdir -p $(@D)
#~ 	$(Q)cp $< $@

# Students' answers: friendly warnings, and every exercise 'weak', so that a test can put the
# reference in the place of one of them (.make/verdict).
$(B)/weak.h: tests/exercises.table .make/proxies.awk
	$(Q)awk -v make=weak -f .make/proxies.awk $< > $@
FOR_ANSWERS = $(FOR_STUDENTS) -include $(B)/weak.h

# An answer counts as changed when its text has changed: dates deceive where files are moved back.
changed = $(shell .make/changed $(1) $(foreach s,$(STEMS),$(s):$(call answer_in,$(2),$(s))))
answer_in = $(or $(wildcard $(1)/$(2).c),build/blanks/$(2).c)
ANSWER_OBJECTS := $(STEMS:%=$(BUILT)/%.o)
ifneq ($(A),solutions)
$(call changed,$(BUILT),$(A))
$(ANSWER_OBJECTS): WARNINGS = $(FOR_ANSWERS)
$(ANSWER_OBJECTS): $(BUILT)/%.o: $(BUILT)/%.sum $(B)/flags $(B)/weak.h build/blanks/%.c $(SETUP_FIRST)
	$(call say,compile,$(call answer_in,$(A),$*))
	$(Q)$(COMPILE) -o $@ $(call answer_in,$(A),$*)
	@sed -i.bak 's|$(call answer_in,$(A),$*)||' $(@:.o=.d) && rm -f $(@:.o=.d.bak)
endif

# ---- programs, scenes, pictures ---------------------------------------------------------------

# Chapter 08 asks nothing: it is the answers of the others, faster.
PROGRAMS := $(patsubst %,$(BUILT)/%,$(STEMS) 08-fast)
chapter_objects = $(patsubst %.c,$(B)/%.o,$(filter-out %_nff.c %_lanes.c,$(wildcard \
	chapters/$(1)/*.c))) $(foreach k,$(LANES_KINDS),$(patsubst %.c,$(B)/%.$(k).o,$(wildcard \
	chapters/$(1)/*_lanes.c)))

# The loops in NAME_lanes.c are compiled for several instruction sets; which of them a processor has
# is asked when the program runs (chapters/08-fast/lanes.c). Nowhere but there may multiplications
# be fused with additions: what these loops decide, they decide with a margin.
LANES_KINDS := baseline $(if $(filter x86_64%,$(shell $(CC) -dumpmachine 2>/dev/null)),avx2 avx512)
FOR_avx2 := -mavx2 -mfma
FOR_avx512 := $(FOR_avx2) -mavx512f -mavx512vl -mavx512bw -mavx512dq -mprefer-vector-width=512
FOR_LANES := -O3 -fopenmp-simd -fno-math-errno -fno-trapping-math -ffp-contract=fast
define lanes_rule
$(B)/%.$(1).o: %.c $(B)/flags $(SETUP_FIRST)
	$$(call say,compile,$$< for $(1))
	$$(Q)mkdir -p $$(@D)
	$$(Q)$$(COMPILE) $$(FOR_LANES) $$(FOR_$(1)) -DLANES_KIND=$(1) -o $$@ $$<
endef
$(foreach k,$(LANES_KINDS),$(eval $(call lanes_rule,$(k))))

# What later chapters show of earlier ones: the camera in figures, and how a scene is drawn.
SHOWS_CAMERA := $(B)/chapters/01-corners/plane.o
DRAWS_SCENES := $(patsubst %,$(B)/chapters/06-ray-casting/%.o,command needs scene_camera)
LIGHTS_SCENES := $(patsubst %,$(B)/chapters/07-shading/%.o,lighting render)
shared_objects = $(SHOWS_CAMERA) $(if $(filter 07% 08%,$(1)),$(DRAWS_SCENES)) $(if $(filter 08%,$(1)),$(LIGHTS_SCENES))

.SECONDEXPANSION:
$(PROGRAMS): $(BUILT)/%: $$(sort $$(call chapter_objects,$$*) $$(call shared_objects,$$*)) $(ANSWER_OBJECTS) $(B)/common.a
	$(call say,link,$@)
	$(Q)$(LINK) -o $@ $^ $(PNG_LIBS) -lm -pthread

# Scenes that a program writes: chapters/NN-stem/NAME_nff.c, and what it is told.
GENERATED := sphereflake-91 sphereflake-820 sphereflake-7381 sunflower
SCENES := $(GENERATED:%=$(B)/scenes/%.nff)
NFF_PROGRAMS := $(patsubst %.c,$(B)/%,$(wildcard chapters/*/*_nff.c))
$(NFF_PROGRAMS): %: %.o $(B)/common.a
	$(call say,link,$@)
	$(Q)$(LINK) -o $@ $^ -lm
$(B)/scenes/sphereflake-91.nff: ARGUMENTS = 2
$(B)/scenes/sphereflake-820.nff: ARGUMENTS = 3
$(B)/scenes/sphereflake-7381.nff: ARGUMENTS = 4
#[ What takes long is for the bench alone.
RANDOM := random-1000 random-100000 random-1000000
BENCH_SCENES := chapters/06-ray-casting/three-spheres.nff $(patsubst %,$(B)/scenes/%.nff, \
	$(filter sphereflake%,$(GENERATED)) sphereflake-66430 sphereflake-597871 $(RANDOM))
SCENES += $(filter-out $(SCENES) chapters/%,$(BENCH_SCENES))
$(B)/scenes/sphereflake-66430.nff: ARGUMENTS = 5
$(B)/scenes/sphereflake-597871.nff: ARGUMENTS = 6
$(RANDOM:%=$(B)/scenes/%.nff): ARGUMENTS = $(*:random-%=%)
#]
generator_of = $(B)/$(basename $(wildcard chapters/*/$(firstword $(subst -, ,$(1)))_nff.c))
$(SCENES): $(B)/scenes/%.nff: $$(call generator_of,$$*)
	$(call say,scene,$@)
	$(Q)mkdir -p $(@D)
	$(Q)$< $(ARGUMENTS) > $@

GALLERY := $(BUILT)/gallery
# A picture that needs what a student has not answered yet is no error: that is said, in one line.
TRY = $(if $(filter solutions,$(ANSWERS)),,.make/draw $@)
CHAPTER_PICTURES := $(filter-out 06% 07%,$(STEMS))
# Light, term by term, and together with the flat one, as on the closing slide.
TERMS := ambient diffuse specular
SHADED := still-something-missing $(TERMS:%=07-%)
PICTURES := $(patsubst %,$(GALLERY)/%.png,$(CHAPTER_PICTURES) $(SHADED) $(GENERATED) \
	$(notdir $(basename $(wildcard chapters/06-ray-casting/*.nff))))
$(CHAPTER_PICTURES:%=$(GALLERY)/%.png): $(GALLERY)/%.png: $(BUILT)/%
	$(call say,cast,$@)
	$(Q)mkdir -p $(@D)
	$(Q)$(TRY) $< --picture $@
$(TERMS:%=$(GALLERY)/07-%.png): $(GALLERY)/07-%.png: chapters/06-ray-casting/three-spheres.nff $(BUILT)/07-shading
	$(call say,cast,$@)
	$(Q)mkdir -p $(@D)
	$(Q)$(TRY) $(BUILT)/07-shading --term $* --depth 0 -o $@ $<
$(GALLERY)/still-something-missing.png: chapters/06-ray-casting/three-spheres.nff $(BUILT)/07-shading
	$(call say,cast,$@)
	$(Q)mkdir -p $(@D)
	$(Q)$(TRY) $(BUILT)/07-shading -o $@
$(GALLERY)/%.png: chapters/06-ray-casting/%.nff $(BUILT)/06-ray-casting
	$(call say,cast,$@)
	$(Q)mkdir -p $(@D)
	$(Q)$(TRY) $(BUILT)/06-ray-casting -o $@ $<
$(GALLERY)/%.png: $(B)/scenes/%.nff $(BUILT)/06-ray-casting
	$(call say,cast,$@)
	$(Q)mkdir -p $(@D)
	$(Q)$(TRY) $(BUILT)/06-ray-casting -o $@ $<

# ---- figures ----------------------------------------------------------------------------------

# A layout chapters/NN-stem/NAME.gp, and the data that the chapter's program computes for it, are a
# script (common/plot.h), which gnuplot draws (.make/figures). FIGURE=name: only that one, or several
# with commas.
FIGURES := $(BUILT)/figures
LAYOUTS := $(wildcard chapters/*/*.gp)
FIGURE_NAMES := $(sort $(notdir $(basename $(LAYOUTS))))
FIGURES_WANTED := $(or $(subst $(comma), ,$(FIGURE)),$(FIGURE_NAMES))
ifneq ($(filter-out $(FIGURE_NAMES),$(FIGURES_WANTED)),)
$(error FIGURE=$(FIGURE): no such figure, expected one of $(FIGURE_NAMES))
endif
SCRIPTS := $(FIGURE_NAMES:%=$(FIGURES)/%.gp)
layout_of = $(filter %/$(1).gp,$(LAYOUTS))
stem_of = $(word 2,$(subst /, ,$(call layout_of,$(1))))
figure_files = $(call layout_of,$(1)) $(wildcard common/*.gp \
	$(foreach f,*.nff figures/*.nff,chapters/$(call stem_of,$(1))/$(f)))
# Beside another's answers, what is right, and what the judge says is wrong.
#[
RIGHT := $(if $(filter-out solutions,$(A)),$(B)/solutions/figures)
ifneq ($(RIGHT),)
RIGHT_PROGRAMS := $(STEMS:%=$(B)/solutions/%)
$(RIGHT_PROGRAMS): $(B)/solutions/%: $$(sort $$(call chapter_objects,$$*) $$(call shared_objects,$$*)) \
		$(STEMS:%=$(B)/solutions/%.o) $(B)/common.a
	$(call say,link,$@)
	$(Q)$(LINK) -o $@ $^ $(PNG_LIBS) -lm
RIGHT_SCRIPTS := $(SCRIPTS:$(FIGURES)/%=$(RIGHT)/%)
$(RIGHT_SCRIPTS): $(RIGHT)/%.gp: $(B)/solutions/$$(call stem_of,$$*) $$(call figure_files,$$*)
	$(Q)mkdir -p $(@D)
	$(Q)$< --figure $* > $@
endif
#]
#~ RIGHT := tests/told/figures
# With something missing, a figure is not yet; that is said in one line.
$(SCRIPTS): $(FIGURES)/%.gp: $(BUILT)/$$(call stem_of,$$*) $$(call figure_files,$$*) \
		$(RIGHT:%=%/$$*.gp) $(if $(RIGHT),$$(ALL_VERDICTS))
	$(Q)mkdir -p $(@D)
	$(Q)$(if $(RIGHT),note=$$(awk -v figure=$* -v verdicts=$(VERDICT) -f .make/notes.awk chapters/*/*.c); \
		.make/script $@ $< --figure $* --beside $(RIGHT)/$*.gp $${note:+--note "$$note"},$< \
		--figure $* > $@)

figures: $(FIGURES_WANTED:%=$(FIGURES)/%.gp) ## the deck's diagrams (FORMAT=svg,pdf,png,tex THEME=light,dark SHAPE=16:9,4:3 STEPS=1 FIGURE=name)
	@FORMAT='$(FORMAT)' THEME='$(THEME)' SHAPE='$(SHAPE)' STEPS='$(STEPS)' \
		.make/figures $(FIGURES) $(FIGURES_WANTED)
	@.make/gallery $(BUILT) $(B)/scenes
	@echo "All on a page: $(PAGE)"
.PHONY: figures

# 'make' draws them for the web. Where gnuplot was missing and has come, they are drawn again. What
# wrong answers make impossible to draw is said, and stops nothing else.
DRAWN := $(BUILT)/drawn
ifeq ($(shell cat $(DRAWN) 2>/dev/null),without gnuplot)
$(shell command -v gnuplot >/dev/null && rm -f $(DRAWN))
endif
$(DRAWN): $(SCRIPTS) .make/figures .make/figure $(wildcard .make/figure-*.awk)
	@FORMAT=svg THEME= SHAPE= STEPS= .make/figures $(FIGURES) $(FIGURE_NAMES); status=$$?; \
		case $$status in 0) : > $@ ;; 3) echo 'without gnuplot' > $@ ;; \
			*) $(if $(filter solutions,$(A)),exit $$status,: > $@) ;; esac

# All of it on a page.
PAGE := $(GALLERY)/index.html
$(PAGE): $(PICTURES) $(DRAWN) .make/gallery .make/gallery.css $(wildcard $(GALLERY)/*.png) \
		$(wildcard chapters/*/README.md chapters/*/picture.txt)
	@.make/gallery $(BUILT) $(B)/scenes

#[
# ---- slides -----------------------------------------------------------------------------------

# chapters/slides.tex shows how figures become slides: light and dark, in steps. The figures it takes
# are read from it; SLIDES=talk.tex: slides of your own, written alike.
SLIDES ?= chapters/slides.tex
ON_SLIDES := $(filter $(FIGURE_NAMES),$(shell grep -o '^[^%]*{[a-z0-9-]*}' $(SLIDES) 2>/dev/null | tr '{}' '\n\n' | sort -u))
slides: $(ON_SLIDES:%=$(FIGURES)/%.gp) ## figures on Beamer slides, in steps (needs LaTeX: make setup FOR=lecturer)
	@.make/slides --ready
	@FORMAT=tex THEME= SHAPE= STEPS=1 .make/figures $(FIGURES) $(ON_SLIDES)
	@.make/slides $(FIGURES) $(SLIDES)
.PHONY: slides
#]

# The stamp tells whether there was anything to do.
$(BUILT)/made: $(PROGRAMS) $(PICTURES) $(PAGE) $(B)/compile_commands.json
	@touch $@
	@$(eval DONE := yes)

all: $(BUILT)/made ## build, cast the pictures and draw the figures (ANSWERS=folder: by those)
	@if [ -s $(DRAWN) ]; then figures="no figures, for gnuplot is missing ('make setup' installs it)"; \
		else figures='figures: $(FIGURES)/'; fi; \
	echo "$(if $(DONE),Done,Nothing to do: all is up to date). Programs: $(BUILT)/NN-stem. Pictures: $(GALLERY)/, $$figures; all on a page: $(PAGE)"

setup: ## install what is missing (FOR=lecturer, instructor, contributor)
	@.make/setup $(FOR)

# ---- tests ------------------------------------------------------------------------------------

# What every program of tests is made of: its list of tests, and the words for given and expected.
TESTING := $(patsubst %,$(B)/tests/judge/%.o,record given expect expect_roots runner \
	show random)
COMMON_TESTS := $(patsubst tests/common/%.c,$(B)/tests/common/%,$(wildcard tests/common/*.c))
$(COMMON_TESTS): %: %.o $(TESTING) $(B)/tests/judge/main.o $(B)/common.a
	$(call say,link,$@)
	$(Q)$(LINK) -o $@ $^ $(CHECK_LIBS) $(PNG_LIBS) -lm

# The answering process, for each stem: one call of one exercise, as a message.
DISPATCHES := $(patsubst %,$(B)/judge/dispatch-%.o,$(STEMS) all)
$(DISPATCHES:.o=.c): $(B)/judge/dispatch-%.c: tests/exercises.table .make/proxies.awk
	$(Q)mkdir -p $(@D)
	$(Q)awk -v make=dispatch -v stem=$* -f .make/proxies.awk $< > $@
#[
LENT := $(STEMS:%=$(B)/judge/lent-%.o)
$(LENT:.o=.c): $(B)/judge/lent-%.c: tests/exercises.table .make/proxies.awk
	$(Q)mkdir -p $(@D)
	$(Q)awk -v make=lent -v stem=$* -f .make/proxies.awk $< > $@
#]
$(DISPATCHES) $(LENT) $(patsubst %,$(B)/judge/%.o,proxies layouts exercises rights): %.o: %.c $(B)/flags
	$(call say,compile,$<)
	$(Q)$(COMPILE) -o $@ $<

# What the judge draws of a wrong answer.
DRAWING := $(B)/tests/judge/figure.o $(patsubst %,$(B)/tests/judge/figure_%.o,vector camera place section \
	equation pictures)
earlier = $(shell printf '%s\n' $(STEMS) | awk '$$1 < "$(1)"')
#[ The tests themselves, the mistakes and the laws.
# A stem's tests, calling the answers directly: that answer, and the reference for the stems before.
parts = $(patsubst %.c,$(B)/%.o,$(wildcard $(1)*.c))
test_objects = $(call parts,tests/$(1)) $(TESTING) $(B)/tests/judge/main.o \
	$(patsubst %,$(B)/solutions/%.o,$(call earlier,$(1))) $(B)/common.a
TESTS := $(STEMS:%=$(BUILT)/tests/%)
$(TESTS): $(BUILT)/tests/%: $(BUILT)/%.o $$(call test_objects,$$*)
	$(call say,link,$@)
	$(Q)mkdir -p $(@D)
	$(Q)$(LINK) -o $@ $^ $(CHECK_LIBS) $(PNG_LIBS) -lm

# The judge: the same tests, asking another process for the answers (proxies). Mistakes and laws
# stand beside the reference, which goes by other names there.
$(B)/reference.h: tests/exercises.table .make/proxies.awk
	$(Q)awk -v make=reference -f .make/proxies.awk $< > $@
$(B)/judge/proxies.c: tests/exercises.table .make/proxies.awk
	$(Q)mkdir -p $(@D)
	$(Q)awk -v make=proxies -f .make/proxies.awk $< > $@
# The same by the reference: the judge's, for what it lends, and the matrix's.
LENDERS := $(STEMS:%=$(B)/judge/lender-%.o)
$(LENDERS): $(B)/judge/lender-%.o: $(B)/judge/dispatch-%.c $(B)/reference.h $(B)/flags
	$(call say,compile,$< as reference)
	$(Q)$(COMPILE) -include $(B)/reference.h -o $@ $<
BESIDE_REFERENCE := $(call parts,tests/mistakes/) $(call parts,tests/laws/) \
	$(call parts,tests/variants/)
$(BESIDE_REFERENCE): EXTRA = -include $(B)/reference.h
$(BESIDE_REFERENCE): $(B)/reference.h
REFERENCES := $(STEMS:%=$(B)/tests/reference/%.o)
$(REFERENCES): $(B)/tests/reference/%.o: solutions/%.c $(B)/reference.h $(B)/flags
	$(call say,compile,$< as reference)
	$(Q)mkdir -p $(@D)
	$(Q)$(COMPILE) -include $(B)/reference.h -o $@ $<
JUDGING := $(TESTING) $(patsubst %,$(B)/tests/judge/%.o,call corners kept process ending wire same \
	suspects switchboard system_call) $(B)/judge/proxies.o $(call parts,tests/laws/) $(REFERENCES)
JUDGES := $(STEMS:%=$(B)/judge/%)
$(JUDGES): $(B)/judge/%: $$(call parts,tests/$$*) $$(call parts,tests/mistakes/$$*) $(JUDGING) \
		$(B)/judge/lender-%.o $(B)/judge/layouts.o $(DRAWING) \
		$(patsubst %,$(B)/tests/judge/%.o,judge report right) $(B)/common.a
	$(call say,link,$@)
	$(Q)$(LINK) -o $@ $^ $(CHECK_LIBS) $(PNG_LIBS) -lm
# The matrix: the same, and in the place of the answering process a table that the reference fills.
MATRICES := $(STEMS:%=$(B)/tests/matrix/%)
$(MATRICES): $(B)/tests/matrix/%: $$(call parts,tests/$$*) $$(call parts,tests/mistakes/$$*) \
		$(B)/tests/variants/%.o $(filter-out %/call.o,$(JUDGING)) $(B)/judge/lender-%.o \
		$(patsubst %,$(B)/tests/judge/%.o,matrix table) $(B)/common.a
	$(call say,link,$@)
	$(Q)mkdir -p $(@D)
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
$(SAME_ENGINES): $(patsubst %,$(B)/tests/fast/%.o,against made made_difficult parts)
$(B)/tests/fast/lit: $(B)/tests/fast/lit_scenes.o
$(ENGINES) $(ENGINES_LONG): %: %.o $(filter-out %/main.o,$(call chapter_objects,08-fast)) $(DRAWS_SCENES) \
		$(LIGHTS_SCENES) \
		$(STEMS:%=$(B)/solutions/%.o) $(B)/common.a
	$(call say,link,$@)
	$(Q)$(LINK) -o $@ $^ $(PNG_LIBS) -lm -pthread

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
$(B)/judge/layouts.c $(B)/judge/exercises.c: $(B)/judge/%.c: tests/exercises.table .make/proxies.awk
	$(Q)mkdir -p $(@D)
	$(Q)awk -v make=$* -f .make/proxies.awk $< > $@
$(STEMS:%=$(B)/told/path/%.c): $(B)/told/path/%.c:
	$(Q)mkdir -p $(@D)
	$(Q)printf '#include "tests/told/replay.h"\n\nconst char told_path[] = "%s";\n' \
		$(TABLE)/$*.table > $@
$(STEMS:%=$(B)/told/path/%.o): %.o: %.c $(B)/flags
	$(Q)$(COMPILE) -o $@ $<
TOLD := $(patsubst %,$(B)/tests/told/%.o,layout table) $(B)/judge/layouts.o
REPLAY := $(TESTING) $(patsubst %,$(B)/tests/judge/%.o,wire same suspects switchboard) $(TOLD) \
	$(patsubst %,$(B)/tests/told/%.o,replay expect)

# A table by itself: what is right passes, and each mistake's values are failed and named.
TABLE_CHECKS := $(STEMS:%=$(B)/told/check/%)
$(TABLE_CHECKS): $(B)/told/check/%: $(REPLAY) $(B)/told/path/%.o $(B)/tests/told/check.o \
		$(B)/judge/exercises.o $(B)/common.a | $(TABLE)/%.table
	$(call say,link,$@)
	$(Q)mkdir -p $(@D)
	$(Q)$(LINK) -o $@ $^ $(CHECK_LIBS) $(PNG_LIBS) -lm

#[ Where the tables come from; and right answers written otherwise, held against them.
TELLERS := $(STEMS:%=$(B)/told/tell/%)
$(TELLERS): $(B)/told/tell/%: $$(call parts,tests/$$*) $$(call parts,tests/mistakes/$$*) \
		$(filter-out %/call.o,$(JUDGING)) $(TOLD) \
		$(patsubst %,$(B)/tests/told/%.o,tell asked takes here) \
		$(B)/judge/dispatch-%.o $(B)/common.a
	$(call say,link,$@)
	$(Q)mkdir -p $(@D)
	$(Q)$(LINK) -o $@ $^ $(CHECK_LIBS) $(PNG_LIBS) -lm
TABLES := $(STEMS:%=$(TABLE)/%.table)
$(TABLES): $(TABLE)/%.table: $(B)/told/tell/%
	$(call say,tell,$@)
	$(Q)env -u SEED ASAN_OPTIONS=detect_leaks=0 $< $@
TABLE_VARIANTS := $(STEMS:%=$(B)/told/variants/%)
$(TABLE_VARIANTS): $(B)/told/variants/%: $(REPLAY) $(B)/told/path/%.o $(B)/tests/variants/%.o \
		$(patsubst %,$(B)/tests/told/%.o,variants here) $(B)/judge/dispatch-%.o \
		$(B)/judge/proxies.o $(call parts,tests/laws/) $(REFERENCES) $(B)/common.a \
		| $(TABLE)/%.table
	$(call say,link,$@)
	$(Q)mkdir -p $(@D)
	$(Q)$(LINK) -o $@ $^ $(CHECK_LIBS) $(PNG_LIBS) -lm

KIT := $(B)/grading
CAN_GRADE := $(shell pkg-config --exists libseccomp 2>/dev/null && command -v python3 && \
	command -v objdump)

# What the shell scripts among the tests are told. Grading has no sanitizers: a sandbox has no room.
GRADABLE := $(if $(SANITIZE),,$(if $(CAN_GRADE),$(KIT)))
FOR_TESTS = KIT='$(GRADABLE)' PROGRAMS='$(BUILT)' BUILD='$(B)' ANSWERS='$(A)' CC='$(CC)' MAKEFLAGS= SANITIZE= \
	COMPILER='$(CC) $(LANGUAGE) $(CFLAGS) $(SANITIZER)'
CHECKS := $(COMMON_TESTS) $(NUMBERS) $(TESTS) $(ENGINES) $(MATRICES) $(TABLE_CHECKS) $(TABLE_VARIANTS)
FOR_CHECKS := $(BLANK_TESTS) $(PROGRAMS) $(GENERATED:%=$(B)/scenes/%.nff) $(SAME) $(JUDGES) $(GRADABLE:%=%/commands)
check: $(CHECKS) $(FOR_CHECKS) ## the tests, at most a minute
	@$(FOR_TESTS) .make/check $(BUILT)/log $(CHECKS) $(wildcard tests/shell/*.sh)

# What needs longer: exact arithmetic, a minute of fuzzing, the tree as its users have it.
check-all: $(CHECKS) $(FOR_CHECKS) $(ENGINES_LONG) $(if $(BRIEF),,$(BENCH_SCENES)) ## those that need longer, too
	@$(FOR_TESTS) .make/check $(BUILT)/log $(CHECKS) $(wildcard tests/shell/*.sh tests/long/*.sh)

handout: build/handout.tar.gz ## the students' archive: no solutions, no tests, no mistakes
build/handout.tar.gz: $(TABLES) $(BLANKS) $(if $(RIGHT),$(RIGHT_SCRIPTS),$(SCRIPTS)) FORCE
	@.make/handout $(@D) $(TABLE) build/blanks $(or $(RIGHT),$(FIGURES))
.PHONY: handout FORCE
#]
# ---- the exercises ----------------------------------------------------------------------------

# 'make exercises' judges what stands in exercises/, unless another folder is named. The chapters
# whose answer has not changed are not judged again.
EXERCISES := $(if $(filter command line environment,$(origin ANSWERS)),$(A),exercises)
CHOSEN := $(if $(EX),$(filter $(EX)% 0$(EX)%,$(STEMS)),$(STEMS))
ifeq ($(CHOSEN),)
$(error EX=$(EX): no such chapter, expected 01 to $(lastword $(subst -, ,$(STEMS:%=0$(words $(STEMS))))))
endif
ifneq ($(filter debug reset hint,$(MAKECMDGOALS)),)
ifneq ($(words $(CHOSEN)),1)
$(error which chapter? Say, for example: make $(filter debug reset hint,$(MAKECMDGOALS)) EX=05)
endif
endif
VERDICT := $(B)/$(EXERCISES:/%=%)/verdict
ALL_VERDICTS := $(STEMS:%=$(VERDICT)/%/table)
VERDICTS := $(CHOSEN:%=$(VERDICT)/%/table)
JUDGING_FOR := $(filter exercises watch debug hint $(if $(RIGHT),all figures slides),$(or $(MAKECMDGOALS),all))
ifneq ($(JUDGING_FOR),)
ifeq ($(wildcard $(B)/judge/$(firstword $(CHOSEN))),)
$(info Building the judge, once; that takes a moment ...)
endif
$(call changed,$(VERDICT),$(EXERCISES))
endif
# What the answering process holds besides the answer.
answering = $(B)/tests/judge/answering.o $(B)/tests/judge/wire.o $(B)/judge/dispatch-$(1).o \
	$(lent) $(earlier_answers) $(B)/common.a
#[ With the reference for the chapters before, one mistake costs once; and the judge lends.
lent = $(B)/judge/lent-$(1).o
earlier_answers = $(patsubst %,$(B)/solutions/%.o,$(call earlier,$(1)))
for_debug = $(call test_objects,$(1))
#]
#~ include .make/handout.mk
# Between saving and reading stands the linker: the quickest that is there.
QUICK_LINKER := $(if $(filter exercises watch hint debug,$(MAKECMDGOALS)),$(firstword $(foreach l, \
	gold mold lld,$(if $(shell command -v ld.$(l)),-fuse-ld=$(l)))))
# And the compiler, with all that every answer includes already read. Not optimised: that takes
# longer than what it saves. An index beyond the end of an array is a crash, not luck.
IS_CLANG := $(findstring clang,$(FLAGS_NOW))
QUICK_FLAGS = $(LANGUAGE) -O0 -ffunction-sections $(SANITIZER) $(FOR_STUDENTS) \
	-fsanitize=bounds$(if $(IS_CLANG),,-strict) -fsanitize-undefined-trap-on-error
QUICK_HEADER := $(B)/judge/answer.h
$(QUICK_HEADER): $(B)/weak.h $(wildcard common/*.h) $(B)/flags
	$(Q)mkdir -p $(@D)
	$(Q)(grep -v system_header $<; printf '#include "common/%s.h"\n' answers camera image ray scene) > $@
	$(Q)$(CC) $(QUICK_FLAGS) -x c-header -o $@.$(if $(IS_CLANG),pch,gch) $@
EXPLAIN := .make/explain $(wildcard .make/explaining/*.awk)
JUDGES_LAYOUTS := common/plot.gp chapters/01-corners/yours-and-right.gp $(wildcard tests/judge/layouts/*.gp)
# How to judge a chapter is written down, so that 'make watch' can do it again without make.
$(ALL_VERDICTS): $(VERDICT)/%/table: $(VERDICT)/%.sum .make/verdict $(EXPLAIN) $(QUICK_HEADER) \
		build/blanks/%.c $(B)/judge/% $$(call answering,$$*) $(JUDGES_LAYOUTS)
	@printf '%s\n' "COMPILE='$(CC) $(QUICK_FLAGS) -include $(QUICK_HEADER) -c'" \
		"LINK='$(LINK) $(QUICK_LINKER)'" "OBJECTS='$(call answering,$*)'" \
		$(if $(value stands_on),"STANDS_ON='$(call stands_on,$*)'") \
		'export COMPILE LINK OBJECTS STANDS_ON' \
		'exec .make/verdict $(@D) $(call answer_in,$(EXERCISES),$*) $(B)/judge/$*' > $(@D).sh
	@sh $(@D).sh

exercises: $(VERDICTS) ## what is right, wrong, not yet (EX=05: one chapter)
	@.make/exercises $(VERDICT) $(EXERCISES) $(CHOSEN)

watch: $(VERDICTS) ## judge again whenever an answer is saved
	@.make/watch $(VERDICT) $(EXERCISES) $(CHOSEN)

hint: $(VERDICTS) ## one hint more each time it is asked for (EX=05)
	@name=$$(awk '$$1 !~ /^[+!]/ && $$2 != "right" { \
			if ($$2 ~ /^(wrong|unanswered)$$/ && wants == "") wants = $$1; else waits = $$1 } \
			END { print wants != "" ? wants : waits }' $(VERDICT)/$(CHOSEN)/table); \
		[ -n "$$name" ] || { echo "$(CHOSEN) needs no hint: make exercises EX=$(EX)"; exit 0; }; \
		.make/hint exercises/$(CHOSEN).hints "$$name" $(call answer_in,$(EXERCISES),$(CHOSEN)) \
		$(VERDICT)/$(CHOSEN).hint

debug: $(VERDICTS) $(if $(filter debug,$(MAKECMDGOALS)),$(call for_debug,$(CHOSEN))) ## gdb at the call that failed (EX=05)
	@mkdir -p $(B)/debug
	@$(CC) $(LANGUAGE) -g3 -O0 $(CHECK_CFLAGS) -o $(B)/debug/$(CHOSEN) $(call answer_in,$(EXERCISES),$(CHOSEN)) \
		$(call for_debug,$(CHOSEN)) $(CHECK_LIBS) $(PNG_LIBS) -lm
	@.make/debug $(VERDICT)/$(CHOSEN) $(CHOSEN) $(B)/debug/$(CHOSEN)

reset: $(BLANKS) ## put a blank back; your answer is kept beside it (EX=05)
	@.make/reset build/blanks/$(CHOSEN).c exercises/$(CHOSEN).c
#[

# ---- grading ----------------------------------------------------------------------------------

include .make/grading.mk

skeletons: $(BLANKS) ## write the blanks that solutions/ make; never over changes
	@.make/skeletons $(BLANKS)

# Chapter 08's engines; with PEERS=1 beside Embree, POV-Ray and Tachyon.
PEERS :=
ifneq ($(PEERS),)
ifeq ($(shell echo '#include <embree3/rtcore.h>' | $(CC) -E -x c - >/dev/null 2>&1 && echo yes),)
$(error PEERS=$(PEERS) needs Embree 3: libembree-dev of Debian 12, embree3 elsewhere)
endif
endif
ENGINE_BENCH := $(B)/tests/benches/engines$(if $(PEERS),-and-peers)
ENGINE_OBJECTS := $(filter-out %/main.o,$(call chapter_objects,08-fast)) $(DRAWS_SCENES) $(LIGHTS_SCENES) \
	$(STEMS:%=$(B)/solutions/%.o)
PEER_OBJECTS := $(patsubst %,$(B)/tests/benches/peers/%.o,$(if $(PEERS),peers embree programs,none)) \
	$(if $(PEERS),$(B)/chapters/07-shading/export.o)
$(B)/tests/benches/peers/embree.o: EXTRA = -O3 -march=native -fopenmp-simd -fno-math-errno \
	-fno-trapping-math -ffp-contract=fast -mprefer-vector-width=512
$(B)/tests/benches/peers/programs.o: EXTRA = $(PNG_CFLAGS)
$(ENGINE_BENCH): $(patsubst %,$(B)/tests/benches/%.o,engines report) $(PEER_OBJECTS) \
		$(ENGINE_OBJECTS) $(B)/common.a
	$(call say,link,$@)
	$(Q)$(LINK) -o $@ $^ $(if $(PEERS),-lembree3) $(PNG_LIBS) -lm -pthread
WAIT_BENCH := $(if $(PEERS),$(B)/tests/benches/peers/embree_wait)
$(B)/tests/benches/peers/embree_wait.o: EXTRA = $(PNG_CFLAGS)
$(B)/tests/benches/peers/embree_wait: %: %.o $(B)/tests/benches/peers/embree.o $(ENGINE_OBJECTS) \
		$(B)/common.a
	$(call say,link,$@)
	$(Q)$(LINK) -o $@ $^ -lembree3 $(PNG_LIBS) -lm -pthread
bench-engines: $(ENGINE_BENCH) $(BENCH_SCENES) ## rays a second: engines, scenes, threads (PEERS=1: others, too)
	@tests/benches/engines.sh $(ENGINE_BENCH) $(B)/bench $(BENCH_SCENES)
bench-wait: $(WAIT_BENCH) $(if $(PEERS),$(ENGINE_BENCH) $(SAME)) $(BUILT)/08-fast $(B)/scenes/sphereflake-597871.nff ## from scene to picture (PEERS=1: others, too)
	@PROGRAMS='$(BUILT)' BUILD='$(B)' PEERS='$(PEERS)' tests/benches/wait.sh $(B)/scenes/sphereflake-597871.nff
bench-shading: $(BUILT)/07-shading $(BUILT)/08-fast $(B)/scenes/sphereflake-7381.nff ## shadows and mirrors: how much sooner by the hierarchy
	@PROGRAMS='$(BUILT)' tests/benches/shading.sh $(B)/scenes/sphereflake-7381.nff
$(B)/tests/benches/pictures.o: EXTRA = $(PNG_CFLAGS)
$(B)/tests/benches/pictures: %: %.o
	$(call say,link,$@)
	$(Q)$(LINK) -o $@ $^ $(PNG_LIBS) -lz
bench-pictures: $(B)/tests/benches/pictures $(BUILT)/07-shading $(BUILT)/08-fast $(SCENES) ## a PNG by libpng's settings: time and size
	@tests/benches/pictures.sh $(B) $(BUILT)
bench: $(JUDGES) $(GRADABLE:%=%/commands) ## from save to verdict; a class a minute; rays a second
	@$(MAKE) --no-print-directory -s -j1 bench-engines bench-wait bench-shading
	@tests/benches/latency.sh
	@$(if $(GRADABLE),KIT=$(KIT) tests/benches/grade.sh,echo 'grading is not measured: make setup FOR=instructor')
#]

# ---- the habits of the house ------------------------------------------------------------------

C_SOURCES = $(wildcard common/*.[ch] chapters/*/*.[ch] exercises/*.h solutions/*.c \
	tests/*.[ch] tests/*/*.[ch] tests/grading/confine/*.[ch])
FORMATTED = $(C_SOURCES) $(wildcard tests/benches/peers/*.c)
format: ## lay out the C sources (clang-format)
	@clang-format -i $(FORMATTED)

format-check: ## fails where 'make format' would change something
	@clang-format --dry-run -Werror $(FORMATTED)

# Not in tests/mistakes, where bugs are what is wanted.
tidy: $(B)/compile_commands.json ## look for bugs (clang-tidy)
	clang-tidy --quiet -p $(B) $(filter-out tests/mistakes/%,$(filter %.c,$(C_SOURCES)))

$(B)/compile_commands.json: Makefile $(filter %.c,$(C_SOURCES)) $(SETUP_FIRST)
	@mkdir -p $(@D)
	@for f in $(filter %.c,$(C_SOURCES)); do \
		printf '{"directory": "%s", "file": "%s", "command": "%s -c %s"},\n' \
			'$(CURDIR)' "$$f" '$(CC) $(LANGUAGE) $(STRICT) $(PNG_CFLAGS)' "$$f"; \
	done | sed '1s/^/[/; $$s/,$$/]/' > $@

clean: ## remove what was built
	rm -rf build

help: ## this
	@awk -F ':.*## ' '/^[a-z-]+:.*## / { printf "  make %-13s %s\n", $$1, $$2 }' Makefile \
		$(filter %.mk,$(MAKEFILE_LIST))

.PHONY: all setup check exercises watch hint debug reset format format-check tidy clean help
#[
.PHONY: check-all bench grade gradescope skeletons
#]
-include $(shell find $(B) -name '*.d' 2>/dev/null)
