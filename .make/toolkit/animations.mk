# animations.mk - make animations: what moves, as videos and as numbered pictures. Included by the Makefile.

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
$(PRINT_ANIMATION): $(patsubst %,$(B)/chapters/animations/%.o,print_animation moments) \
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
	@$(if $(filter solutions,$(ANSWERS)),,NOT_YET=$(@D)) $< $(basename $(@F)) $(SCENE) > $@.new
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
