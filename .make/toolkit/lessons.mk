# lessons.mk - make lesson-figures: the figures that are committed, for readers who build nothing. Included
# by the Makefile.
LESSON_FIGURES := $(B)/tests/house/figures/lesson_figures
$(LESSON_FIGURES): $(LESSON_FIGURES).o
	$(call say,link,$@)
	$(Q)$(LINK) -o $@ $^

# The tests of them need what compares them, and the scene of the last picture.
check check-all check-long: $(LESSON_FIGURES)
check-all check-long: $(B)/scenes/finale.nff
lesson-figures: $(DRAWN) $(LESSON_FIGURES) ## write the figures that the lessons show, and their words
	@FORMAT=svg THEME= SHAPE= STEPS=1 $(DRAW_FIGURES) $(FIGURES) \
		$$($(LESSON_FIGURES) --in-steps $(CHAPTERS:%=chapters/%))
	@$(LESSON_FIGURES) --write $(FIGURES) $(CHAPTERS:%=chapters/%)
.PHONY: lesson-figures
