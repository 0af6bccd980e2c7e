# slides.mk - make slides. Included by .make/figures.mk.

# chapters/slides.tex shows how figures become slides: light and dark, in steps. The figures it takes
# are read from it; SLIDES=talk.tex: slides of your own, written alike.
SLIDES ?= chapters/slides.tex
ON_SLIDES := $(if $(JUDGES_ONLY),,$(filter $(FIGURE_NAMES),$(shell grep -o '^[^%]*{[a-z0-9-]*}' $(SLIDES) 2>/dev/null | tr '{}' '\n\n' | sort -u)))
slides: $(call script_of,$(DRAWN_FIGURES),$(ON_SLIDES)) $(DRAW_FIGURES) ## figures on Beamer slides, in steps (needs LaTeX: make setup FOR=lecturer)
	@chapters/make_slides --ready
	@FORMAT=tex THEME= SHAPE= STEPS=1 $(DRAW_FIGURES) $(DRAWN_FIGURES) $(ON_SLIDES)
	@chapters/make_slides $(DRAWN_FIGURES) $(SLIDES)
.PHONY: slides
