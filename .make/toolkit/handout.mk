# handout.mk - make handout, and the blanks of exercises/. Included by the Makefile.
handout: build/handout.tar.gz ## the students' archive: no solutions, no tests, no mistakes
build/handout.tar.gz: $(TABLES) $(RECORDED) $(BLANKS) $(OPTIONAL_BLANKS) $(if $(RIGHT),$(RIGHT_SCRIPTS),$(SCRIPTS)) FORCE
	@tests/handout/pack $(@D) $(TABLE) build/blanks $(or $(RIGHT),$(DRAWN_FIGURES))
.PHONY: handout FORCE

skeletons: $(BLANKS) $(OPTIONAL_BLANKS) ## write the blanks that solutions/ make; never over changes
	@solutions/write_blanks $^
.PHONY: skeletons
