# chapter.mk - the pictures of chapter 06: of its scenes, and of scenes that its programs write
# (NAME_nff.c).
GENERATED := sphereflake-91 sphereflake-820 sphereflake-7381 sunflower
$(B)/scenes/sphereflake-91.nff: ARGUMENTS = 2
$(B)/scenes/sphereflake-820.nff: ARGUMENTS = 3
$(B)/scenes/sphereflake-7381.nff: ARGUMENTS = 4
SCENES += $(GENERATED:%=$(B)/scenes/%.nff)

PICTURES += $(patsubst %,$(GALLERY)/%.png,$(GENERATED) \
	$(notdir $(basename $(wildcard chapters/06-ray-casting/*.nff))))
$(GALLERY)/%.png: chapters/06-ray-casting/%.nff $(BUILT)/06-ray-casting
	$(call say,cast,$@)
	$(Q)mkdir -p $(@D)
	$(Q)$(TRY) $(BUILT)/06-ray-casting -o $@ $<
$(GALLERY)/%.png: $(B)/scenes/%.nff $(BUILT)/06-ray-casting
	$(call say,cast,$@)
	$(Q)mkdir -p $(@D)
	$(Q)$(TRY) $(BUILT)/06-ray-casting -o $@ $<
