# slides.mk - make slides. Included by .make/figures.mk.

# One source becomes the lecture's PDFs: NAME.pdf, NAME-dark.pdf, NAME-handout.pdf, NAME-questions.pdf (a
# handout without answers), NAME-notes.pdf; with SHAPE=4:3 NAME-4x3.pdf and so on. SLIDES=talk.tex: slides of
# your own. The figures are those that the source and its parts name.
SLIDES ?= chapters/slides.tex
LECTURE := $(BUILT)/slides
SLIDES_NAME := $(notdir $(basename $(SLIDES)))
ifneq ($(filter slides,$(MAKECMDGOALS)),)
ifeq ($(wildcard $(SLIDES)),)
$(error SLIDES=$(SLIDES): no such file)
endif
SLIDE_SHAPES := $(or $(subst $(comma), ,$(SHAPE)),16:9)
ifneq ($(filter-out 16:9 4:3,$(SLIDE_SHAPES)),)
$(error SHAPE=$(SHAPE): expected 16:9, 4:3 or both)
endif
SLIDE_PARTS := $(foreach part,$(shell sed -n 's/^[^%]*\\input{\([^}]*\)}.*/\1/p' $(SLIDES)), \
	$(firstword $(wildcard $(dir $(SLIDES))$(part).tex chapters/slides/$(part).tex)))
ON_SLIDES := $(filter $(FIGURE_NAMES) $(OWN_FIGURES),$(shell grep -ho '^[^%]*{[a-z0-9-]*}' $(SLIDES) $(SLIDE_PARTS) | tr '{}' '\n\n' | sort -u))
endif

# The numbers, by the answers.
$(LECTURE)/numbers: $(B)/chapters/slides/numbers.o $(ANSWER_OBJECTS) $(B)/chapters/shared.a $(B)/common.a
	$(call say,link,$@)
	$(Q)mkdir -p $(@D)
	$(Q)$(LINK) -o $@ $^ -lm
$(LECTURE)/numbers.tex: $(LECTURE)/numbers
	$(Q)$< > $@

# The tests of slides need what is compared.
check-all check-long: $(LECTURE)/numbers.tex

slides-ready:
	@chapters/make_slides --ready
slides-figures: $(call script_of,$(DRAWN_FIGURES),$(ON_SLIDES)) | slides-ready
	@$(remove_older)
	@FORMAT=tex THEME= SHAPE='$(SHAPE)' STEPS=1 $(DRAW_FIGURES) $(DRAWN_FIGURES) $(ON_SLIDES)

# name_of_slides SHAPE,SUFFIX; slides_rule SHAPE,SUFFIX,THEME,VERSION
name_of_slides = $(LECTURE)/$(SLIDES_NAME)$(if $(filter 4:3,$(1)),-4x3)$(2).pdf
define slides_rule
SLIDE_PDFS += $(call name_of_slides,$(1),$(2))
$(call name_of_slides,$(1),$(2)): $(SLIDES) $(SLIDE_PARTS) chapters/slides/lecture.sty chapters/make_slides \
		$(LECTURE)/numbers.tex $(call script_of,$(DRAWN_FIGURES),$(ON_SLIDES)) | slides-figures
	$$(call say,latex,$$@)
	$$(Q)chapters/make_slides $(SLIDES) $$@ $(DRAWN_FIGURES) $(1) $(3) $(4)
endef
$(foreach shape,$(SLIDE_SHAPES), \
	$(eval $(call slides_rule,$(shape),,light,slides)) \
	$(eval $(call slides_rule,$(shape),-dark,dark,slides)) \
	$(eval $(call slides_rule,$(shape),-handout,light,handout)) \
	$(eval $(call slides_rule,$(shape),-questions,light,questions)) \
	$(eval $(call slides_rule,$(shape),-notes,light,notes)))
slides: $(SLIDE_PDFS) ## the lecture: slides, handouts, notes (SHAPE=4:3, SLIDES=talk.tex; needs LaTeX: make setup FOR=lecturer)
	@echo 'The lecture, from $(SLIDES):'; for pdf in $^; do echo "  $$pdf"; done
.PHONY: slides slides-ready slides-figures
