# figures.mk - make figures, and the page of pictures and figures. Included by the Makefile.

# A layout chapters/NN-stem/figures/NAME.gp, and the data that the chapter's program computes for it, are a
# script (common/figure/plot.h), which gnuplot draws (chapters/gallery/draw_figures.py). Each figure has a
# folder: DRAWN_FIGURES/NAME/NAME.gp, NAME.svg and so on.
# FIGURE=name: only that one, or several with commas.
DRAWN_FIGURES := $(BUILT)/figures
LAYOUTS := $(wildcard $(GIVEN)chapters/*/figures/*.gp)
FIGURE_NAMES := $(sort $(notdir $(basename $(LAYOUTS))))

ifneq ($(WORDS),)
ifneq ($(filter-out slides figures animations,$(or $(MAKECMDGOALS),all)),)
$(error WORDS=$(WORDS) goes with make figures, slides or animations)
endif
ifneq ($(shell $(PYTHON) chapters/gallery/check_words.py $(WORDS) && echo yes),yes)
$(error WORDS=$(WORDS) cannot be used)
endif
SAY_WORDS := FIGURE_WORDS='$(WORDS)'
endif

# ---- figures of your own, from any folder: FIGURES=folder ----------------------------------------

# The first line of FOLDER/NAME.gp names the numbers that it draws: '# data: FIGURE [OPTION]...' those of a
# chapter's figure, '# data: FILE.c' those of a source beside it (chapters/shared/own_figure.h).
ifneq ($(FIGURES),)
ifneq ($(words $(FIGURES))$(findstring %,$(FIGURES)),1)
$(error FIGURES='$(FIGURES)': expected one folder, whose path has no blank and no '%')
endif
ifeq ($(wildcard $(FIGURES)/.),)
$(error FIGURES=$(FIGURES): no such folder)
endif
OWN_FIGURES := $(sort $(notdir $(basename $(wildcard $(FIGURES)/*.gp))))
ifeq ($(OWN_FIGURES),)
$(error FIGURES=$(FIGURES): no figure in it, expected a layout NAME.gp)
endif
endif

OWN_WANTED := $(if $(FIGURE),$(filter $(subst $(comma), ,$(FIGURE)),$(OWN_FIGURES)),$(OWN_FIGURES))
hash := \#
own_layout = $(FIGURES)/$(1).gp
read_data = $(eval DATA_OF_$(1) := $(firstword $(shell sed -n '1s/^$(hash) data: *//p' '$(own_layout)' 2>/dev/null)))
check_own = $(if $(wildcard $(own_layout)),,$(error $(own_layout): cannot be read, expected a file name without blanks)) \
	$(if $(filter $(1),$(FIGURE_NAMES)),$(error $(own_layout): a chapter has a figure of this name, expected another one)) \
	$(if $(DATA_OF_$(1)),,$(error $(own_layout):1: expected '$(hash) data: FIGURE', where FIGURE is whose numbers it draws: \
		$(FIGURE_NAMES); or '$(hash) data: FILE.c')) \
	$(if $(filter-out %.c $(FIGURE_NAMES),$(DATA_OF_$(1))),$(error $(own_layout):1: no figure '$(DATA_OF_$(1))', \
		expected one of $(FIGURE_NAMES), or a FILE.c)) \
	$(if $(filter-out $(notdir $(wildcard $(FIGURES)/*.c)),$(filter %.c,$(DATA_OF_$(1)))),$(error \
		$(own_layout):1: no $(DATA_OF_$(1)) in $(FIGURES)))
$(foreach figure,$(OWN_WANTED),$(call read_data,$(figure))$(call check_own,$(figure)))

# Figures of your own are read again each time, because FIGURES may have been another folder; they are drawn again
# only if their script has changed. The options of the first line are words, not commands.
OWN_SCRIPTS := $(foreach figure,$(OWN_WANTED),$(DRAWN_FIGURES)/$(figure)/$(figure).gp)
OWN_PROGRAMS := $(sort $(foreach figure,$(OWN_WANTED),$(patsubst %.c,$(BUILT)/own-figures/%,$(filter %.c,$(DATA_OF_$(figure))))))
own_program = $(or $(patsubst %.c,$(BUILT)/own-figures/%,$(filter %.c,$(DATA_OF_$(1)))),$(call program_of,$(DATA_OF_$(1))))
print_own = $(if $(filter %.c,$(DATA_OF_$(*F))),$< --layout $(call own_layout,$(*F)) --figure $(basename $(DATA_OF_$(*F))), \
	sed -n '1s/^$(hash) data: *//p' $(call own_layout,$(*F)) | NOT_YET=$(@D) xargs $< --layout $(call own_layout,$(*F)) --figure)
$(OWN_SCRIPTS): $(DRAWN_FIGURES)/%.gp: $$(call own_program,$$(*F)) FORCE
	$(Q)mkdir -p $(@D)
	$(Q)export $(SAY_WORDS) NOT_YET=$(@D); $(print_own) > $@.new || \
		{ rm -f $@.new; echo '$(call own_layout,$(*F)):1: its data could not be computed' >&2; exit 1; }
	$(Q)$(take_script)
$(OWN_PROGRAMS): $(BUILT)/own-figures/%: $(FIGURES)/%.c $(ANSWER_OBJECTS) $(B)/chapters/shared.a $(B)/common.a FORCE
	$(call say,compile,$<)
	$(Q)mkdir -p $(@D)
	$(Q)$(CC) $(LANGUAGE) $(CFLAGS) $(SANITIZER) $(FOR_STUDENTS) $(LDFLAGS) -o $@ $(filter %.c %.o %.a,$^) $(PNG_LIBS) -lm
FIGURES_WANTED := $(or $(subst $(comma), ,$(FIGURE)),$(OWN_FIGURES),$(FIGURE_NAMES))
ifneq ($(filter-out $(FIGURE_NAMES) $(OWN_FIGURES),$(FIGURES_WANTED)),)
$(error FIGURE=$(FIGURE): no such figure, expected one of $(OWN_FIGURES) $(FIGURE_NAMES))
endif
script_of = $(foreach name,$(2),$(1)/$(name)/$(name).gp)
SCRIPTS := $(call script_of,$(DRAWN_FIGURES),$(FIGURE_NAMES))
layout_of = $(filter %/$(1).gp,$(LAYOUTS))
stem_of = $(word 2,$(subst /, ,$(patsubst $(GIVEN)%,%,$(call layout_of,$(1)))))
program_of = $(BUILT)/$(or $(FIGURES_OF_$(stem_of)),$(stem_of))
figure_files = $(call layout_of,$(1)) $(WORDS) $(wildcard $(GIVEN)common/figure/*.gp \
	$(foreach s,$(call stem_of,$(1)),chapters/$(s)/*.nff $(GIVEN)chapters/$(s)/figures/*.nff))
# Beside another's answers, what is right, by the solutions or as a handout has recorded it, and what the
# judge says is wrong.
RIGHT_BUILT := $(B)$(EXAMPLE:%=/examples/%)/solutions
RIGHT := $(if $(wildcard solutions/.),$(if $(filter-out solutions,$(A)),$(RIGHT_BUILT)/figures),build/right-figures)
# A handout has only the numbers, so its scripts need no folders.
right_script_of = $(RIGHT)/$(if $(RIGHT_SCRIPTS),$(1)/)$(1).gp
ifneq ($(filter $(RIGHT_BUILT)/%,$(RIGHT)),)
RIGHT_PROGRAMS := $(STEMS:%=$(RIGHT_BUILT)/%)
$(RIGHT_PROGRAMS): $(RIGHT_BUILT)/%: $$(call chapter_objects,$$*) \
		$(STEMS:%=$(B)/solutions/%.o) $(EXAMPLE_OBJECT) $(B)/chapters/shared.a $(B)/common.a
	$(call say,link,$@)
	$(Q)$(LINK) -o $@ $^ $(PNG_LIBS) -lm
RIGHT_SCRIPTS := $(call script_of,$(RIGHT),$(FIGURE_NAMES))
$(RIGHT_SCRIPTS): $(RIGHT)/%.gp: $(RIGHT_BUILT)/$$(call stem_of,$$(*F)) $$(call figure_files,$$(*F))
	$(Q)mkdir -p $(@D)
	$(Q)$< --figure $(*F) > $@.new || { rm -rf $(@D); exit 1; }; $(take_script)
endif
# Nothing that was drawn from another script remains beside a new one, in whatever format. Without a script there is
# no figure.
take_script = if [ ! -s $@.new ]; then rm -rf $(@D); else \
	cmp -s $@.new $@ || find $(@D) -mindepth 1 ! -name $(@F).new -delete; mv $@.new $@; fi
# A figure of your own, an animation and slides that this run does not draw have older numbers if the example or an
# answer has changed since.
NEW_NUMBERS = $(wildcard $(or $(EXAMPLE_HEADER),chapters/example.h) $(if $(filter solutions,$(A)),solutions/*.c,$(STEMS:%=$(ANSWERS_BUILT)/%.text)))
remove_older = find $(BUILT)/figures/*/*.gp $(BUILT)/animations/*/*.gp $(BUILT)/slides/*.pdf \
	\( -name '' $(NEW_NUMBERS:%=-o ! -newer %) \) 2>/dev/null | { gone=; while read -r old; do \
	case $$old in *.gp) old=$${old%/*} ;; esac; rm -rf "$$old"; gone="$$gone $${old\#\#*/}"; done; \
	[ -z "$$gone" ] || echo "Removed, because of their older numbers:$$gone"; }

# A figure that calls an answer that is missing is not drawn: its program says so in one line (NOT_YET,
# common/answers.h), and no older figure is left in its place. Below a wrong figure is what the judge says of the
# answers that it calls.
$(SCRIPTS): $(DRAWN_FIGURES)/%.gp: $$(call program_of,$$(*F)) $$(call figure_files,$$(*F)) \
		$(if $(RIGHT),$$(call right_script_of,$$(*F)) $$(RECORDS))
	$(Q)mkdir -p $(@D)
	$(Q)$(if $(RIGHT),$(beside_right),$(SAY_WORDS) $< --figure $(*F) > $@.new || { rm -rf $(@D); exit 1; }; $(take_script))
define beside_right
names=$$({ $< --figure $(*F) --answers; } 2>/dev/null); note=$${names:+$$($(COURSE) note $(PLAN) $$names)}; \
$(SAY_WORDS) NOT_YET=$(@D) $< --figure $(*F) --beside $(call right_script_of,$(*F)) $${note:+--note "$$note"} > $@.new || \
	case $$? in 1[2-9]?) echo '  not yet   $(@D): crashed' ;; *) echo '  not yet   $(@D): its program has said why' ;; esac; \
$(take_script)
endef

DRAW_FIGURES := $(PYTHON) chapters/gallery/draw_figures.py
MAKE_PAGE := $(PYTHON) chapters/gallery/gallery.py $(BUILT) $(B)/scenes
figures: $(call script_of,$(DRAWN_FIGURES),$(FIGURES_WANTED)) ## the deck's diagrams (FORMAT=svg,pdf,png,tex THEME=light,dark SHAPE=16:9,4:3 STEPS=1 FIGURE=name; FIGURES=folder, WORDS=file: your own)
	@FORMAT='$(FORMAT)' THEME='$(THEME)' SHAPE='$(SHAPE)' STEPS='$(STEPS)' \
		$(DRAW_FIGURES) $(DRAWN_FIGURES) $(FIGURES_WANTED)
	@$(remove_older)
	@$(MAKE_PAGE)
	@echo "All on a page: $(PAGE)"
.PHONY: figures

# 'make' draws them for the web: also 4:3, for phones. If gnuplot or python3 was missing and is there now, they are drawn
# again. A figure that wrong answers make impossible is reported, and stops nothing else.
DRAWN := $(BUILT)/drawn
$(if $(JUDGES_ONLY),,$(shell [ ! -s $(DRAWN) ] || ! command -v "$$(cat $(DRAWN))" >/dev/null || rm -f $(DRAWN)))
$(DRAWN): $(SCRIPTS) $(addprefix chapters/gallery/,draw_figures.py jobs.py latex_picture.py)
	@$(remove_older)
	@command -v python3 >/dev/null || { echo python3 > $@; exit; }; \
		FORMAT=svg THEME= SHAPE=16:9,4:3 STEPS= $(DRAW_FIGURES) $(DRAWN_FIGURES) $(FIGURE_NAMES); status=$$?; \
		case $$status in 0) : > $@ ;; 3) echo gnuplot > $@ ;; *) $(if $(filter solutions,$(A)),exit $$status,: > $@) ;; esac

# All of it on a page.
PAGE := $(GALLERY)/index.html
$(PAGE): $(PICTURES) $(DRAWN) $(addprefix chapters/gallery/,gallery.py gallery.css contents.txt) \
		$(wildcard $(GALLERY)/*.png $(BUILT)/animations/*/*.*) $(wildcard chapters/*/README.md)
	@if command -v python3 >/dev/null; then $(MAKE_PAGE); else rm -f $@; \
		echo "python3 is missing, so the figures and the page of pictures, $@, are left out: 'make setup' installs it"; fi

# For the test of that page.
list-pictures:
	@echo $(sort $(notdir $(basename $(PICTURES))))
.PHONY: list-pictures
