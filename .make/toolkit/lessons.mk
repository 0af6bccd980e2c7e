# lessons.mk - make lesson-figures: the figures that are committed, for readers who build nothing. Included
# by the Makefile.
LESSON_FIGURES := $(B)/tests/house/figures/lesson_figures
$(LESSON_FIGURES): $(LESSON_FIGURES).o
	$(call say,link,$@)
	$(Q)$(LINK) -o $@ $^

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
check check-all check-long: $(LESSON_FIGURES) $(DRAWN_PICTURES)
check-all check-long: $(B)/scenes/finale.nff
lesson-figures: $(DRAWN) $(LESSON_FIGURES) $(DRAWN_PICTURES) $(SAME) ## write the figures and pictures that the lessons show, and the figures' words
	@export FORMAT=svg THEME= SHAPE=16:9,4:3; STEPS= $(DRAW_FIGURES) $(DRAWN_FIGURES) $(FIGURE_NAMES) && \
		STEPS=1 $(DRAW_FIGURES) $(DRAWN_FIGURES) $$($(LESSON_FIGURES) --in-steps $(CHAPTERS:%=chapters/%))
	@$(LESSON_FIGURES) --write $(DRAWN_FIGURES) $(CHAPTERS:%=chapters/%)
	@for picture in $(LESSON_PICTURES); do \
		drawn=$(B)/so-far/$${picture##*/}; [ -e $$drawn ] || drawn=$(GALLERY)/$${picture##*/}; \
		$(SAME) $$drawn $$picture >/dev/null || { cp $$drawn $$picture && echo "wrote $$picture"; }; done
.PHONY: lesson-figures
