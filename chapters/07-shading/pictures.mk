# pictures.mk - what chapter 07 casts: light, term by term, and together with the flat one, as on the
# closing slide.
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
