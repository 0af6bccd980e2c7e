# lessons.mk - make lessons, and lesson-figures: the lessons, with their numbers, figures and pictures, as they
# are committed for readers who build nothing. Included by the Makefile.

# Lessons with numbers of the example (chapters/example.h) are made from chapters/lessons/NN-stem.md; the program
# of NN-stem.c fills in its numbers and the output of the chapter's program (chapters/lessons/fill.h).
LESSONS := $(patsubst chapters/lessons/%.md,%,$(wildcard chapters/lessons/*.md))
FILL_LESSON := $(LESSONS:%=$(B)/chapters/lessons/%)
parts_of = $(filter-out %/main.o,$(call chapter_objects,$(1)))
$(FILL_LESSON): %: %.o $(B)/chapters/lessons/fill.o $(B)/chapters/lessons/numbers.o $$(call parts_of,$$(@F)) \
		$(STEMS:%=$(B)/solutions/%.o) $(B)/chapters/shared.a $(B)/common.a
	$(call say,link,$@)
	$(Q)$(LINK) -o $@ $^ $(PNG_LIBS) -lm -pthread
FILLED := $(LESSONS:%=$(B)/lessons/%.md)
$(FILLED): $(B)/lessons/%.md: chapters/lessons/%.md $(B)/chapters/lessons/% $(B)/solutions/% chapters/%/README.md
	$(Q)mkdir -p $(@D)
	$(Q)$(B)/solutions/$* > $(@:.md=.txt)
	$(Q)$(B)/chapters/lessons/$* $< $(@:.md=.txt) chapters/$*/README.md > $@

# The same with each number marked, for a page (chapters/lessons/fill.c).
LESSONS_MARKED := $(LESSONS:%=$(B)/lessons/%.marked.md)
$(LESSONS_MARKED): $(B)/lessons/%.marked.md: $(B)/lessons/%.md
	$(Q)$(B)/chapters/lessons/$* chapters/lessons/$*.md $(@:.marked.md=.txt) chapters/$*/README.md marked > $@

# Numbers that are not an example are named before anything is made of them.
CHECK_EXAMPLE := $(B)/chapters/lessons/check_example
$(CHECK_EXAMPLE): %: %.o $(B)/chapters/shared.a $(B)/common.a
	$(call say,link,$@)
	$(Q)$(LINK) -o $@ $^ -lm
EXAMPLE_CHECKED := $(B)/lessons/example
$(EXAMPLE_CHECKED): $(CHECK_EXAMPLE)
	@mkdir -p $(@D)
	@$< && touch $@
$(FILLED) $(if $(filter solutions,$(A)),$(SCRIPTS) $(PICTURES)): | $(EXAMPLE_CHECKED)

# If the example has other numbers, the lessons change, and with them their figures and pictures. So 'make' writes
# them as well; but it does not write over a lesson that was changed by hand instead of its source. Lessons that
# are as they should be keep their dates.
LESSONS_MADE := $(B)/lessons/made
$(LESSONS_MADE): $(FILLED) | $(DRAWN) $(PICTURES) $$(FOR_EXERCISES)
	@written=; kept=; for stem in $(LESSONS); do \
		lesson=chapters/$$stem/README.md; source=chapters/lessons/$$stem.md; \
		if cmp -s $(B)/lessons/$$stem.md $$lesson; then :; \
		elif [ -z '$(filter lessons,$(MAKECMDGOALS))' ] && [ $$lesson -nt $$source ] && [ $$lesson -nt chapters/example.h ]; then \
			kept=yes; echo "$$lesson differs from what $$source makes: 'make lessons' writes it again"; \
		else written=yes; cp $(B)/lessons/$$stem.md $$lesson && echo "wrote $$lesson"; fi; done; \
	[ -z "$$written" ] || MAKEFLAGS= $(MAKE_AGAIN) --no-print-directory $(MAKEOVERRIDES) lesson-figures || exit; \
	[ -n "$$kept" ] || touch $@
ifeq ($(A),solutions)
$(BUILT)/made $(PAGE): $(LESSONS_MADE)
endif
lessons: $(LESSONS_MADE) ## write the numbers of chapters/example.h into the lessons ('make' does it as well)
.PHONY: lessons

LESSON_FIGURES := python3 -B chapters/lessons/lesson_figures.py
# Of some figures a lesson also shows a step.
draw_lesson_steps = FORMAT=svg THEME= SHAPE=16:9,4:3 STEPS=1 $(DRAW_FIGURES) $(DRAWN_FIGURES) \
	$$($(LESSON_FIGURES) --in-steps $(CHAPTERS:%=chapters/%))

# Pictures that the lessons show, chapters/NN-stem/NAME.png: those that programs draw, $(GALLERY)/NAME.png.
# Two take too long; they have tests of their own (tests/house/fast_program.sh, tests/proof/finale.sh).
LESSON_PICTURES := $(filter-out %/sphereflake.png %/finale.png,$(wildcard chapters/[0-9]*/*.png))
# Some of them are drawn before a chapter is right (tests/course/pictures), here by the solutions.
SO_FAR := $(filter 01-spheres.png 04-spheres.png 07-%.png,$(notdir $(LESSON_PICTURES)))
DRAWN_PICTURES := $(patsubst %,$(GALLERY)/%,$(filter-out $(SO_FAR),$(notdir $(LESSON_PICTURES)))) \
	$(SO_FAR:%=$(B)/so-far/%)
DRAW_SO_FAR := $(B)/tests/house/draw_so_far
$(DRAW_SO_FAR): $(DRAWING_ANSWERS) $(STEMS:%=$(B)/solutions/%.o) $(B)/chapters/shared.a $(B)/common.a
	$(call say,link,$@)
	$(Q)mkdir -p $(@D)
	$(Q)$(LINK) -o $@ $^ $(PNG_LIBS) -lm
$(SO_FAR:%=$(B)/so-far/%): $(B)/so-far/%.png: $(DRAW_SO_FAR) $(SPHERES) $(RECORDED)
	$(Q)mkdir -p $(@D)
	$(Q)$(DRAW_SO_FAR) $(SPHERES) $(RECORDED) $* $@

# The tests of all these need what is compared, and what compares it.
check check-all check-long: $(FILLED) $(DRAWN_PICTURES)
check-all check-long: $(B)/scenes/finale.nff
lesson-figures: $(DRAWN) $(DRAWN_PICTURES) ## write the figures and pictures that the lessons show, and the figures' words
	@$(draw_lesson_steps)
	@$(LESSON_FIGURES) --write $(DRAWN_FIGURES) $(CHAPTERS:%=chapters/%)
	@for picture in $(LESSON_PICTURES); do \
		drawn=$(B)/so-far/$${picture##*/}; [ -e $$drawn ] || drawn=$(GALLERY)/$${picture##*/}; \
		$(PYTHON) tests/house/figures/same_picture.py $$drawn $$picture >/dev/null || { cp $$drawn $$picture && echo "wrote $$picture"; }; done
.PHONY: lesson-figures
