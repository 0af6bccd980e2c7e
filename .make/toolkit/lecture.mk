# lecture.mk - make slides, animations, lessons and lesson-figures. Included by the Makefile.

# ---- slides --------------------------------------------------------------------------------------

# One text becomes the lecture's PDFs: NAME.pdf, NAME-dark.pdf, and of NAME.pdf are made NAME-handout.pdf,
# NAME-questions.pdf (without answers, which are at its end), NAME-notes.pdf; with SHAPE=4:3 NAME-4x3.pdf and so on.
# SLIDES=talk.txt: slides of your own (chapters/slides/lecture.py).
SLIDES ?= chapters/slides.txt
LECTURE := $(BUILT)/slides
SLIDES_NAME := $(notdir $(basename $(SLIDES)))
# Questions to the class, as a lecture: slides ask some of them, and lecture.html has all after each part.
QUESTIONS := $(B)/questions/questions.txt
# ADDRESS=address: where the site is, for the codes on slides.
MAKE_SLIDES := ADDRESS='$(ADDRESS)' QUESTIONS='$(QUESTIONS)' $(PYTHON) chapters/slides/make_slides.py
ifneq ($(filter slides book check-book,$(MAKECMDGOALS)),)
ifeq ($(wildcard $(SLIDES)),)
$(error SLIDES=$(SLIDES): no such file)
endif
SLIDE_SHAPES := $(or $(subst $(comma), ,$(SHAPE)),16:9)
ifneq ($(filter-out 16:9 4:3,$(SLIDE_SHAPES)),)
$(error SHAPE=$(SHAPE): expected 16:9, 4:3 or both)
endif
# Beside words a figure is narrow, as on all slides of 4:3.
ON_SLIDES := $(shell $(MAKE_SLIDES) --figures $(SLIDES) || echo wrong)
ifneq ($(filter wrong,$(ON_SLIDES)),)
$(error SLIDES=$(SLIDES) could not be read)
endif
ifneq ($(filter-out $(FIGURE_NAMES:%=%:beside) $(FIGURE_NAMES:%=%:below) $(OWN_FIGURES:%=%:beside) $(OWN_FIGURES:%=%:below),$(ON_SLIDES)),)
$(error SLIDES=$(SLIDES): no figure $(filter-out $(FIGURE_NAMES) $(OWN_FIGURES),$(patsubst %:below,%,$(ON_SLIDES:%:beside=%))), expected one of $(OWN_FIGURES) $(FIGURE_NAMES))
endif
figures_there = $(patsubst %:$(1),%,$(filter %:$(1),$(ON_SLIDES)))
NARROW_FIGURES := $(call figures_there,beside) $(if $(filter 4:3,$(SLIDE_SHAPES)),$(call figures_there,below))
WIDE_FIGURES := $(if $(filter 16:9,$(SLIDE_SHAPES)),$(call figures_there,below))
endif

# The numbers of the example, by the answers.
NUMBERS_OBJECTS := $(addprefix $(B)/chapters/,lessons/print_numbers.o lessons/numbers.o 02-cameras/forms.o)
$(LECTURE)/numbers: $(NUMBERS_OBJECTS) $(ANSWER_OBJECTS) $(B)/chapters/shared.a $(B)/common.a
	$(call say,link,$@)
	$(Q)mkdir -p $(@D)
	$(Q)$(LINK) -o $@ $^ -lm
$(LECTURE)/numbers.json: $(LECTURE)/numbers
	$(Q)$< > $@

SLIDES_TOLD := $(LECTURE)/told
$(SLIDES_TOLD): FORCE
	@mkdir -p $(@D); echo '$(ADDRESS)' | cmp -s - $@ || echo '$(ADDRESS)' > $@

# The tests of slides need what is compared.
check-all check-long: $(LECTURE)/numbers.json $(QUESTIONS)

slides-ready:
	@$(MAKE_SLIDES) --ready
slides-figures: $(call script_of,$(DRAWN_FIGURES),$(NARROW_FIGURES) $(WIDE_FIGURES)) | slides-ready
	@$(remove_older)
	@export FORMAT=tex THEME= STEPS=1; SHAPE=4:3 $(DRAW_FIGURES) $(DRAWN_FIGURES) $(NARROW_FIGURES) && \
		SHAPE=16:9 $(DRAW_FIGURES) $(DRAWN_FIGURES) $(WIDE_FIGURES)

# name_of_slides SHAPE,SUFFIX; slides_rule SHAPE,SUFFIX,THEME; paper_rule SHAPE,VERSION
name_of_slides = $(LECTURE)/$(SLIDES_NAME)$(if $(filter 4:3,$(1)),-4x3)$(2).pdf
SLIDE_SOURCES := $(SLIDES) $(wildcard chapters/slides/*.py chapters/slides/*.sty) $(LECTURE)/numbers.json $(QUESTIONS)
define slides_rule
SLIDE_PDFS += $(call name_of_slides,$(1),$(2))
$(call name_of_slides,$(1),$(2)): $(SLIDE_SOURCES) $(SLIDES_TOLD) $(call script_of,$(DRAWN_FIGURES),$(NARROW_FIGURES) $(WIDE_FIGURES)) | slides-figures
	$$(call say,latex,$$@)
	$$(Q)$(MAKE_SLIDES) $(SLIDES) $(LECTURE)/numbers.json $(DRAWN_FIGURES) $(1) $(3) $$@
endef
define paper_rule
SLIDE_PDFS += $(call name_of_slides,$(1),-$(2))
$(call name_of_slides,$(1),-$(2)): $(call name_of_slides,$(1))
	$$(call say,latex,$$@)
	$$(Q)$(MAKE_SLIDES) $(SLIDES) $(LECTURE)/numbers.json $$< $(1) $(2) $$@
endef
$(foreach shape,$(SLIDE_SHAPES), \
	$(eval $(call slides_rule,$(shape),,light)) \
	$(eval $(call slides_rule,$(shape),-dark,dark)) \
	$(foreach version,handout questions notes,$(eval $(call paper_rule,$(shape),$(version)))))
slides: $(SLIDE_PDFS) ## the lecture: slides, handouts, notes (SHAPE=4:3, SLIDES=talk.txt, ADDRESS=address; needs LaTeX: make setup FOR=lecturer)
	@echo 'The lecture, from $(SLIDES):'; for pdf in $^; do echo "  $$pdf"; done
.PHONY: slides slides-ready slides-figures

# ---- animations: what moves, as videos and as numbered pictures ----------------------------------

# A layout chapters/animations/NAME.gp, and the data of all its moments, which the answers compute
# (print_animation.c), are a script; gnuplot draws a frame for each of its steps (draw_animations.py).
# ANIMATION=name: only that one, or several with commas. SCENE=file.nff: with a scene of yours.
ANIMATIONS := $(BUILT)/animations
MOVING_LAYOUTS := $(filter-out %/frame.gp,$(wildcard chapters/animations/*.gp))
ANIMATION_NAMES := $(sort $(notdir $(basename $(MOVING_LAYOUTS)))) turntable
ANIMATIONS_WANTED := $(or $(subst $(comma), ,$(ANIMATION)),$(ANIMATION_NAMES))
ifneq ($(filter-out $(ANIMATION_NAMES),$(ANIMATIONS_WANTED)),)
$(error ANIMATION=$(ANIMATION): no such animation, expected one of $(ANIMATION_NAMES))
endif
ifneq ($(if $(SCENE),$(wildcard $(SCENE)),none),$(or $(SCENE),none))
$(error SCENE=$(SCENE): no such file, expected a scene)
endif

# The data are those of the figures of chapters 05 and 06.
PRINT_ANIMATION := $(BUILT)/print_animation
MOVING_CHAPTERS := 05-quadratic 06-ray-casting
$(PRINT_ANIMATION): $(B)/chapters/animations/print_animation.o \
		$(filter-out %/main.o,$(foreach stem,$(MOVING_CHAPTERS),$(call chapter_objects,$(stem)))) \
		$(ANSWER_OBJECTS) $(ANSWERS_CALLED) $(B)/chapters/shared.a $(B)/common.a
	$(call say,link,$@)
	$(Q)$(LINK) $(NOTE_CALLS) -o $@ $^ $(PNG_LIBS) -lm -pthread

# Printed again each time: the frames of the same script are not drawn again. An animation that calls an
# answer that is missing is not drawn.
STORIES := $(filter-out turntable,$(ANIMATIONS_WANTED))
MOVING_SCRIPTS := $(foreach name,$(STORIES),$(ANIMATIONS)/$(name)/$(name).gp)
$(MOVING_SCRIPTS): $(PRINT_ANIMATION) FORCE
	@mkdir -p $(@D)
	@$(SAY_WORDS) $(if $(filter solutions,$(ANSWERS)),,NOT_YET=$(@D)) $< $(basename $(@F)) $(SCENE) > $@.new
	@$(take_script)
DRAW_ANIMATIONS := $(PYTHON) chapters/animations/draw_animations.py

# The last picture, cast from FRAMES sides by chapter 08, with SAMPLES x SAMPLES rays a pixel.
SAMPLES ?= 1
TURNED := $(or $(SCENE),$(B)/scenes/finale.nff)
TURNING := $(filter turntable,$(ANIMATIONS_WANTED))
animations: $(MOVING_SCRIPTS) $(if $(TURNING),$(TURNED) $(BUILT)/$(ENGINE_CHAPTER)) ## videos, and numbered pictures (FORMAT=mp4,webm,gif,apng,png THEME=light,dark ANIMATION=name)
	@export FORMAT='$(FORMAT)' THEME='$(THEME)' FRAMES='$(FRAMES)'; \
		there=$$(for name in $(STORIES); do [ ! -s $(ANIMATIONS)/$$name/$$name.gp ] || echo $$name; done); \
		[ -z "$$there" ] || $(DRAW_ANIMATIONS) $(ANIMATIONS) $$there $(if $(TURNING),&& \
		mkdir -p $(ANIMATIONS)/turntable && cp chapters/animations/turntable.txt $(ANIMATIONS)/turntable && \
		$(DRAW_ANIMATIONS) $(ANIMATIONS) --turn turntable $(TURNED) \
			$(BUILT)/$(ENGINE_CHAPTER) --shaded --samples $(SAMPLES) -s 1280x720 --threads 1)
	@$(remove_older)
	@$(MAKE_PAGE)
	@echo 'Animations: $(ANIMATIONS)/, and on the page: $(PAGE)'
.PHONY: animations
check check-all check-long: $(PRINT_ANIMATION)

# ---- lessons, with their numbers, figures and pictures, as they are committed for readers who build nothing ---

# Lessons have numbers of the example (chapters/example.h) in the lines that chapters/lessons/lines.txt has; a program
# prints these numbers (numbers.c), and fill.py puts them in, and the output of the chapter's program.
LESSONS := $(filter $(CHAPTERS),$(file <chapters/lessons/lines.txt))
EXAMPLE_NUMBERS := $(B)/chapters/lessons/numbers
$(EXAMPLE_NUMBERS): $(NUMBERS_OBJECTS) $(STEMS:%=$(B)/solutions/%.o) $(B)/chapters/shared.a $(B)/common.a
	$(call say,link,$@)
	$(Q)$(LINK) -o $@ $^ -lm
FILL := $(PYTHON) chapters/lessons/fill.py $(EXAMPLE_NUMBERS)
FILLED := $(LESSONS:%=$(B)/lessons/%.md)
$(FILLED): $(B)/lessons/%.md: $(addprefix chapters/lessons/,lines.txt fill.py) $(EXAMPLE_NUMBERS) $(B)/solutions/% chapters/%/README.md
	$(Q)mkdir -p $(@D)
	$(Q)$(B)/solutions/$* > $(@:.md=.txt)
	$(Q)if command -v python3 >/dev/null; then $(FILL) $(@:.md=.txt) chapters/$*/README.md; \
		else cat chapters/$*/README.md; fi > $@

# The same with each number marked, for a page (chapters/lessons/fill.py).
LESSONS_MARKED := $(LESSONS:%=$(B)/lessons/%.marked.md)
$(LESSONS_MARKED): $(B)/lessons/%.marked.md: $(B)/lessons/%.md
	$(Q)$(FILL) $(@:.marked.md=.txt) chapters/$*/README.md marked > $@

# Numbers that are not an example are named before anything is made of them.
CHECK_EXAMPLE := $(B)$(EXAMPLE:%=/examples/%)/check_example
$(CHECK_EXAMPLE): $(B)/chapters/lessons/check_example.o $(EXAMPLE_OBJECT) $(B)/chapters/shared.a $(B)/common.a
	$(call say,link,$@)
	$(Q)$(LINK) -o $@ $^ -lm
EXAMPLE_CHECKED := $(CHECK_EXAMPLE).ok
$(EXAMPLE_CHECKED): $(CHECK_EXAMPLE)
	@$< && touch $@
$(FILLED) $(if $(filter solutions,$(A)),$(SCRIPTS) $(PICTURES)): | $(EXAMPLE_CHECKED)

# If the example has other numbers, the lessons change, and with them their figures and pictures. So 'make' writes
# them as well. Lessons that are as they should be keep their dates.
LESSONS_MADE := $(B)/lessons/made
$(LESSONS_MADE): $(FILLED) | $(DRAWN) $(PICTURES) $$(FOR_EXERCISES)
	@written=; for stem in $(LESSONS); do lesson=chapters/$$stem/README.md; \
		cmp -s $(B)/lessons/$$stem.md $$lesson || { written=yes; cp $(B)/lessons/$$stem.md $$lesson && echo "wrote $$lesson"; }; done; \
	[ -z "$$written" ] || MAKEFLAGS= $(MAKE_AGAIN) --no-print-directory $(MAKEOVERRIDES) lesson-figures || exit; \
	touch $@
ifeq ($(A)$(EXAMPLE),solutions)
$(BUILT)/made $(PAGE): $(LESSONS_MADE)
endif
lessons: $(LESSONS_MADE) ##+ write the numbers of chapters/example.h into the lessons ('make' does it as well)
.PHONY: lessons

LESSON_FIGURES := python3 -B chapters/lessons/lesson_figures.py
# Of some figures a lesson also shows a step.
draw_lesson_steps = FORMAT=svg THEME= SHAPE=16:9,4:3 STEPS=1 $(DRAW_FIGURES) $(DRAWN_FIGURES) \
	$$($(LESSON_FIGURES) --in-steps $(CHAPTERS:%=chapters/%))

# Pictures that the lessons show, chapters/NN-stem/NAME.png: those that programs draw, $(GALLERY)/NAME.png.
# Two take too long; they have tests of their own (tests/house/shading.txt, tests/proof/shading.sh).
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
lesson-figures: $(DRAWN) $(DRAWN_PICTURES) ##+ write the figures and pictures that the lessons show, and the figures' words
	@$(draw_lesson_steps)
	@$(LESSON_FIGURES) --write $(DRAWN_FIGURES) $(CHAPTERS:%=chapters/%)
	@for picture in $(LESSON_PICTURES); do \
		drawn=$(B)/so-far/$${picture##*/}; [ -e $$drawn ] || drawn=$(GALLERY)/$${picture##*/}; \
		$(PYTHON) tests/house/figures/png.py $$drawn $$picture >/dev/null || { cp $$drawn $$picture && echo "wrote $$picture"; }; done
.PHONY: lesson-figures

# ---- a known mistake, shown to a class -------------------------------------------------------------

SHOW_MISTAKES := $(PYTHON) chapters/mistakes/show_mistakes.py
mistake: $$(MISTAKEN) $(call script_of,$(B)/solutions/figures,$(FIGURE_NAMES)) ## what a known mistake does to pictures and figures (NAME=no-flip; make mistakes lists them)
	@$(if $(NAME),$(SHOW_MISTAKES) show $(B) '$(NAME)',echo "make mistake NAME=no-flip: which? 'make mistakes' lists them" >&2; exit 2)
mistakes: $$(MISTAKEN) ##+ the known mistakes that have names, and a page with their pictures
	@$(SHOW_MISTAKES) list $(B)
$(QUESTIONS): chapters/mistakes/questions.txt chapters/mistakes/show_mistakes.py | $(B)/tests/mistaken/06-ray-casting $(B)/tests/mistaken/07-shading
	$(call say,ask,$@)
	$(Q)$(SHOW_MISTAKES) questions $(B)
questions: $(QUESTIONS) ##+ questions to the class, made of known mistakes (make slides SLIDES=build/questions/questions.txt)
.PHONY: mistake mistakes questions
