# chapter.mk - the pictures of chapter 07: each term of the light alone; and the flat and the shaded
# picture together, as on the closing slide.
SHADING_CHAPTER := 07-shading
TERMS := ambient diffuse specular
TERM_PICTURES := $(TERMS:%=$(GALLERY)/07-%.png)
PICTURES += $(GALLERY)/still-something-missing.png $(TERM_PICTURES)
$(TERM_PICTURES): $(GALLERY)/07-%.png: chapters/06-ray-casting/three-spheres.nff $(BUILT)/07-shading
	$(call say,cast,$@)
	$(Q)mkdir -p $(@D)
	$(Q)$(TRY) $(BUILT)/07-shading --term $* --depth 0 -o $@ $<
$(GALLERY)/still-something-missing.png: chapters/06-ray-casting/three-spheres.nff $(BUILT)/07-shading
	$(call say,cast,$@)
	$(Q)mkdir -p $(@D)
	$(Q)$(TRY) $(BUILT)/07-shading -o $@

# Chapter 08 casts the last picture, with chapter 07's light. Without the engines of 08, as in a handout,
# each ray asks every sphere, so the picture is small.
SCENES += $(B)/scenes/finale.nff
FINALE := $(GALLERY)/finale.png
FINALE_BY := $(if $(wildcard chapters/08-fast/engines/.),08-fast --shaded --samples 2 --threads 2,07-shading -s 320x180)
finale: $(FINALE) $$(FOR_SAY_WRONG) ## the picture of README.md (ANSWERS=exercises: by your code)
	@echo "The picture: $(FINALE)"
	$(SAY_WRONG)
$(FINALE): $(B)/scenes/finale.nff $(BUILT)/$(firstword $(FINALE_BY))
	$(call say,cast,$@)
	$(Q)mkdir -p $(@D)
	$(Q)$(TRY) $(BUILT)/$(FINALE_BY) -o $@ $<
.PHONY: finale
