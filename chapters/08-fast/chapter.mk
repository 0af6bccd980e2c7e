# chapter.mk - the scenes of chapter 08's measurements. They take long and have no picture.
# make bench and the tests of the engines are about this chapter.
ENGINE_CHAPTER := 08-fast
RANDOM := random-1000 random-100000 random-1000000
BENCH_SCENES := chapters/06-ray-casting/three-spheres.nff $(patsubst %,$(B)/scenes/%.nff, \
	$(filter sphereflake%,$(GENERATED)) sphereflake-66430 sphereflake-597871 $(RANDOM))
SCENES += $(filter-out $(SCENES) chapters/%,$(BENCH_SCENES))
$(B)/scenes/sphereflake-66430.nff: ARGUMENTS = 5
$(B)/scenes/sphereflake-597871.nff: ARGUMENTS = 6
$(RANDOM:%=$(B)/scenes/%.nff): ARGUMENTS = $(*:random-%=%)

# Where there are engines, the figure is printed by a program without them: a site compiles none of them.
ifneq ($(wildcard chapters/08-fast/engines/.),)
FIGURES_OF_$(ENGINE_CHAPTER) := rectangles
WITHOUT_ENGINES := $(B)/chapters/$(ENGINE_CHAPTER)/without_engines.o
$(WITHOUT_ENGINES): chapters/08-fast/main.c $(B)/flags.mk
	$(call say,compile,$< without engines)
	$(Q)mkdir -p $(@D)
	$(Q)$(COMPILE) -DWITHOUT_ENGINES -o $@ $<
$(BUILT)/rectangles: $(WITHOUT_ENGINES) $(patsubst %,$(B)/chapters/08-fast/%.o,rectangles figures/figures) \
		$(ANSWER_OBJECTS) $(ANSWERS_CALLED) $(B)/chapters/shared.a $(B)/common.a
	$(call say,link,$@)
	$(Q)mkdir -p $(@D)
	$(Q)$(LINK) $(NOTE_CALLS) -o $@ $^ $(PNG_LIBS) -lm
endif

# The gallery's large pictures, with shadows and mirrors. A handout has no engines, and none of them.
ifneq ($(wildcard chapters/08-fast/engines/.),)
SHADED_PICTURES := $(patsubst %,$(GALLERY)/shaded-%.png,sphereflake-7381 sunflower)
PICTURES += $(SHADED_PICTURES) $(FINALE)
$(SHADED_PICTURES): $(GALLERY)/shaded-%.png: $(B)/scenes/%.nff $(BUILT)/$(ENGINE_CHAPTER)
	$(call say,cast,$@)
	$(Q)mkdir -p $(@D)
	$(Q)$(TRY) $(BUILT)/$(ENGINE_CHAPTER) --shaded --depth 3 --samples 2 --threads 2 -s 1280x720 -o $@ $<

# The picture of 7381 spheres takes chapter 06 long.
$(GALLERY)/sphereflake-7381.png: $(B)/scenes/sphereflake-7381.nff $(BUILT)/$(ENGINE_CHAPTER)
	$(call say,cast,$@)
	$(Q)mkdir -p $(@D)
	$(Q)$(TRY) $(BUILT)/$(ENGINE_CHAPTER) -o $@ $<
endif
