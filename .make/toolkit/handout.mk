# handout.mk - make handout, and the blanks of exercises/. Included by the Makefile.
# Its tables do not have the formulas of mistakes.
ARCHIVED := $(B)/tables/handout
$(STEMS:%=$(ARCHIVED)/%.table): $(ARCHIVED)/%.table: $(TABLE)/%.table
	$(call say,record,$@)
	$(Q)mkdir -p $(@D)
	$(Q)env -u SEED $(RECORD) $* $@ --without-formulas
handout: build/handout.tar.gz ## the students' archive: no solutions, no tests, no mistakes
build/handout.tar.gz: $(STEMS:%=$(ARCHIVED)/%.table) $(RECORDED) $(BLANKS) $(OPTIONAL_BLANKS) $(if $(RIGHT),$(RIGHT_SCRIPTS),$(SCRIPTS)) FORCE
	@cp $(RECORDED) $(ARCHIVED)/ && tests/handout/pack $(@D) $(ARCHIVED) build/blanks $(or $(RIGHT),$(DRAWN_FIGURES))
.PHONY: handout FORCE

skeletons: $(BLANKS) $(OPTIONAL_BLANKS) ##+ write the blanks that solutions/ make; never over changes
	@solutions/write_blanks $^
.PHONY: skeletons
