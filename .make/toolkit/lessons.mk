# lessons.mk - make lesson-figures: the figures that are committed, for readers who build nothing. Included
# by the Makefile.
LESSON_FIGURES := $(B)/tests/house/figures/lesson_figures
$(LESSON_FIGURES): $(LESSON_FIGURES).o
	$(call say,link,$@)
	$(Q)$(LINK) -o $@ $^

# Pictures that the lessons show, chapters/NN-stem/NAME.png: those that programs draw, $(GALLERY)/NAME.png.
# Two take too long; they have tests of their own (tests/house/fast.sh, tests/proof/finale.sh).
LESSON_PICTURES := $(filter-out %/sphereflake.png %/finale.png,$(wildcard chapters/[0-9]*/*.png))
DRAWN_PICTURES := $(patsubst %,$(GALLERY)/%,$(notdir $(LESSON_PICTURES)))

# The tests of all these need what is compared, and what compares it.
check check-all check-long: $(LESSON_FIGURES) $(DRAWN_PICTURES)
check-all check-long: $(B)/scenes/finale.nff
lesson-figures: $(DRAWN) $(LESSON_FIGURES) $(DRAWN_PICTURES) $(SAME) ## write the figures and pictures that the lessons show, and the figures' words
	@export FORMAT=svg THEME= SHAPE=16:9,4:3; STEPS= $(DRAW_FIGURES) $(FIGURES) $(FIGURE_NAMES) && \
		STEPS=1 $(DRAW_FIGURES) $(FIGURES) $$($(LESSON_FIGURES) --in-steps $(CHAPTERS:%=chapters/%))
	@$(LESSON_FIGURES) --write $(FIGURES) $(CHAPTERS:%=chapters/%)
	@for picture in $(LESSON_PICTURES); do \
		drawn=$(GALLERY)/$${picture##*/}; \
		$(SAME) $$drawn $$picture >/dev/null || { cp $$drawn $$picture && echo "wrote $$picture"; }; done
.PHONY: lesson-figures
