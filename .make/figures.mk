# figures.mk - make figures, and the page of pictures and figures. Included by the Makefile.

# A layout chapters/NN-stem/figures/NAME.gp, and the data that the chapter's program computes for it, are a
# script (common/figure/plot.h), which gnuplot draws (chapters/gallery/draw_figures.c). Each figure has a
# folder: DRAWN_FIGURES/NAME/NAME.gp, NAME.svg and so on.
# FIGURE=name: only that one, or several with commas.
DRAWN_FIGURES := $(BUILT)/figures
LAYOUTS := $(wildcard chapters/*/figures/*.gp)
FIGURE_NAMES := $(sort $(notdir $(basename $(LAYOUTS))))
include .make/own_figures.mk
FIGURES_WANTED := $(or $(subst $(comma), ,$(FIGURE)),$(OWN_FIGURES),$(FIGURE_NAMES))
ifneq ($(filter-out $(FIGURE_NAMES) $(OWN_FIGURES),$(FIGURES_WANTED)),)
$(error FIGURE=$(FIGURE): no such figure, expected one of $(OWN_FIGURES) $(FIGURE_NAMES))
endif
script_of = $(foreach name,$(2),$(1)/$(name)/$(name).gp)
SCRIPTS := $(call script_of,$(DRAWN_FIGURES),$(FIGURE_NAMES))
layout_of = $(filter %/$(1).gp,$(LAYOUTS))
stem_of = $(word 2,$(subst /, ,$(call layout_of,$(1))))
figure_files = $(call layout_of,$(1)) $(wildcard common/figure/*.gp \
	$(foreach f,*.nff figures/*.nff,chapters/$(call stem_of,$(1))/$(f)))
# Beside another's answers, what is right, by the solutions or as a handout has recorded it, and what the
# judge says is wrong.
RIGHT := $(if $(wildcard solutions/.),$(if $(filter-out solutions,$(A)),$(B)/solutions/figures),tests/handout/replay/figures)
# A handout has only the numbers, so its scripts need no folders.
right_script_of = $(RIGHT)/$(if $(RIGHT_SCRIPTS),$(1)/)$(1).gp
ifneq ($(filter $(B)/%,$(RIGHT)),)
RIGHT_PROGRAMS := $(STEMS:%=$(B)/solutions/%)
$(RIGHT_PROGRAMS): $(B)/solutions/%: $$(call chapter_objects,$$*) \
		$(STEMS:%=$(B)/solutions/%.o) $(B)/chapters/shared.a $(B)/common.a
	$(call say,link,$@)
	$(Q)$(LINK) -o $@ $^ $(PNG_LIBS) -lm
RIGHT_SCRIPTS := $(call script_of,$(RIGHT),$(FIGURE_NAMES))
$(RIGHT_SCRIPTS): $(RIGHT)/%.gp: $(B)/solutions/$$(call stem_of,$$(*F)) $$(call figure_files,$$(*F))
	$(Q)mkdir -p $(@D)
	$(Q)$< --figure $(*F) > $@
endif
# A figure that calls an answer that is missing is not drawn: its program says so in one line (NOT_YET,
# common/answers.h), and no older figure is left in its place. Below a wrong figure is what the judge says of the
# answers that it calls.
$(SCRIPTS): $(DRAWN_FIGURES)/%.gp: $(BUILT)/$$(call stem_of,$$(*F)) $$(call figure_files,$$(*F)) \
		$(if $(RIGHT),$$(call right_script_of,$$(*F)) $$(RECORDS))
	$(Q)mkdir -p $(@D)
	$(Q)$(if $(RIGHT),$(beside_right),$< --figure $(*F) > $@)
define beside_right
note=$$($(COURSE) note $(PLAN) $$({ $< --figure $(*F) --answers; } 2>/dev/null)); \
NOT_YET=$(@D) $< --figure $(*F) --beside $(call right_script_of,$(*F)) $${note:+--note "$$note"} > $@.new || \
	echo '  not yet   $(@D): crashed'; \
if [ -s $@.new ]; then mv $@.new $@; else rm -rf $(@D); fi
endef

DRAW_FIGURES := $(B)/chapters/gallery/draw_figures
MAKE_PAGE := $(B)/chapters/gallery/gallery
figures: $(call script_of,$(DRAWN_FIGURES),$(FIGURES_WANTED)) $(DRAW_FIGURES) $(MAKE_PAGE) ## the deck's diagrams (FORMAT=svg,pdf,png,tex THEME=light,dark SHAPE=16:9,4:3 STEPS=1 FIGURE=name; FIGURES=folder: your own)
	@FORMAT='$(FORMAT)' THEME='$(THEME)' SHAPE='$(SHAPE)' STEPS='$(STEPS)' \
		$(DRAW_FIGURES) $(DRAWN_FIGURES) $(FIGURES_WANTED)
	@$(MAKE_PAGE) $(BUILT) $(B)/scenes
	@echo "All on a page: $(PAGE)"
.PHONY: figures

# 'make' draws them for the web: also 4:3, for phones. If gnuplot was missing and is there now, they are drawn again. A figure
# that wrong answers make impossible is reported, and stops nothing else.
DRAWN := $(BUILT)/drawn
ifeq ($(if $(JUDGES_ONLY),,$(shell cat $(DRAWN) 2>/dev/null)),without gnuplot)
$(shell command -v gnuplot >/dev/null && rm -f $(DRAWN))
endif
$(DRAWN): $(SCRIPTS) $(DRAW_FIGURES) chapters/gallery/draw_figures.c chapters/gallery/latex_picture.c \
		chapters/gallery/svg_picture.c
	@FORMAT=svg THEME= SHAPE=16:9,4:3 STEPS= $(DRAW_FIGURES) $(DRAWN_FIGURES) $(FIGURE_NAMES); status=$$?; \
		case $$status in 0) : > $@ ;; 3) echo 'without gnuplot' > $@ ;; \
			*) $(if $(filter solutions,$(A)),exit $$status,: > $@) ;; esac

# All of it on a page.
$(DRAW_FIGURES): $(B)/chapters/gallery/latex_picture.o $(B)/chapters/gallery/svg_picture.o
$(DRAW_FIGURES) $(MAKE_PAGE): %: %.o $(B)/common.a
	$(call say,link,$@)
	$(Q)$(LINK) -o $@ $^ -lm
PAGE := $(GALLERY)/index.html
$(PAGE): $(PICTURES) $(DRAWN) $(MAKE_PAGE) chapters/gallery/gallery.css chapters/gallery/contents.txt $(wildcard $(GALLERY)/*.png $(BUILT)/animations/*/*.*) \
		$(wildcard chapters/*/README.md chapters/*/picture.txt)
	@$(MAKE_PAGE) $(BUILT) $(B)/scenes

# For the test of that page.
list-pictures:
	@echo $(sort $(notdir $(basename $(PICTURES))))
.PHONY: list-pictures

include $(wildcard .make/toolkit/slides.mk)
