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
