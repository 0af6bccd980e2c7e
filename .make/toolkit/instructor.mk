# instructor.mk - make handout, and make grade. Included by the Makefile.

# ---- the students' archive, and the blanks of exercises/ -------------------------------------------

# The archive's tables do not have the formulas of mistakes.
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

# ---- grading: the kit that sandboxes are shown, and what else marks a class -------------------------

# Everything that a sandbox shows of this tree is in KIT: the headers that an answer may include; for
# each stem what the answering process holds besides the answer, linked in advance, to
# save time; and the commands that use them.
CONFINE := $(KIT)/confine
SECCOMP_LIBS = $(if $(CAN_GRADE),$(shell pkg-config --libs libseccomp),$(error grading needs python3, \
	ld and libseccomp: 'make setup FOR=instructor' installs them))
$(CONFINE): $(B)/tests/grade/confine/confine.o
	$(call say,link,$@)
	$(Q)mkdir -p $(@D)
	$(Q)$(LINK) -static -o $@ $^ $(SECCOMP_LIBS)

# The explainer of compiler messages. It also runs in a sandbox.
KIT_EXPLAIN := $(KIT)/explain
$(KIT_EXPLAIN): $(EXPLAIN_OBJECTS)
	$(call say,link,$@)
	$(Q)mkdir -p $(@D)
	$(Q)$(LINK) -static -o $@ $^

KIT_HEADER := $(KIT)/headers/weak.h
$(KIT_HEADER): $(B)/weak.h $(wildcard common/*.h exercises/*.h)
	$(Q)mkdir -p $(@D)/common $(@D)/exercises
	$(Q)cp common/*.h $(@D)/common && cp exercises/*.h $(@D)/exercises && cp $< $@

# The blanks, weak: of an answer from which functions are missing, those are not answered yet.
KIT_BLANKS := $(STEMS:%=$(KIT)/link/blank-%.o)
$(KIT_BLANKS): $(KIT)/link/blank-%.o: build/blanks/%.c $(B)/weak.h $(B)/flags.mk
	$(Q)mkdir -p $(@D)
	$(Q)$(CC) $(ANSWER_FLAGS) -include $(B)/weak.h -c -o $@ $<

library = $(shell $(CC) -print-file-name=$(1))
C_LIBRARIES = $(foreach l,libm.a libc.a libgcc.a libgcc_eh.a,$(call library,$(l)))
# The functions of the C library that answers usually call.
IN_ADVANCE := printf fprintf snprintf puts fputs putchar malloc calloc free qsort memcpy memset \
	strcmp rand abort __assert_fail sqrt fabs tan floor ceil round fmin fmax
$(B)/tests/grade/confine/entry.o: EXTRA = -fno-stack-protector
KIT_LINKS := $(STEMS:%=$(KIT)/link/%.o)
$(KIT_LINKS): $(KIT)/link/%.o: $(B)/tests/grade/confine/entry.o $$(call answering,$$*)
$(KIT)/link/%.o:
	$(call say,link,$@)
	$(Q)mkdir -p $(@D)
	$(Q)ld -r -S -o $@ $(IN_ADVANCE:%=-u %) $(foreach o,crt1.o crti.o crtbeginT.o,$(call library,$(o))) $^ \
		--start-group $(C_LIBRARIES) --end-group

# All chapters in one process, which draws a picture; and the picture that it should be.
$(KIT)/link/all.o: $(B)/tests/grade/confine/entry.o $(ANSWERING) \
	$(B)/dispatch/all.o
KIT_LINKS += $(KIT)/link/all.o
PICTURE := $(KIT)/picture
DRAW := $(PICTURE)/draw
$(DRAW): $(B)/tests/grade/mark/picture.o $(STEMS:%=$(B)/solutions/direct/%.o) \
		$(B)/chapters/shared/scene_camera.o $(TESTING) $(CALLED) $(TO_PROCESS) $(B)/common.a
	$(link_program)
SCENE_TO_DRAW := $(wildcard chapters/*/three-spheres.nff)
$(KIT)/expected.png: $(DRAW) $(SCENE_TO_DRAW)
	$(Q)$(DRAW) nobody $(SCENE_TO_DRAW) $@

# With UNSAFE=1 there may be no sandbox to build.
KIT_CONFINE := $(if $(UNSAFE),$(if $(CAN_GRADE),$(CONFINE)),$(CONFINE))
$(KIT)/commands: Makefile .make/exercises.mk .make/toolkit/instructor.mk $(KIT_CONFINE) $(KIT_EXPLAIN) $(KIT_HEADER) $(KIT_LINKS) $(KIT_BLANKS) \
		$(B)/common.a $(KIT)/expected.png $(LIST) $(JUDGE) $(RECORD) \
		$(if $(findstring =$(abspath $(PICTURE)),$(file <$(KIT)/commands)),,FORCE) # paths: the tree may have been moved
	$(Q)mkdir -p $(KIT)/blanks && cp $(STEMS:%=build/blanks/%.c) $(KIT)/blanks/
	$(Q)cp $(B)/common.a $(KIT)/link/ && cp $(SCENE_TO_DRAW) $(PICTURE)/scene.nff
	$(Q)printf '%s\n' 'JUDGE=$(abspath $(JUDGE))' 'RECORD=$(abspath $(RECORD))' 'PICTURE=$(abspath $(PICTURE))' \
		'LAYOUTS=$(abspath $(JUDGES_LAYOUTS))' \
		'COMPILE=$(CC) $(ANSWER_FLAGS) -I$(abspath $(KIT)/headers) -include $(abspath $(KIT_HEADER)) -c' \
		'PARTS=$(if $(IS_CLANG),,-pass-exit-codes -wrapper)' \
		'LINK=ld -static -s -z noexecstack -e graded_start' \
		'LIBRARIES=--start-group $(abspath $(KIT)/link/common.a) $(C_LIBRARIES) --end-group $(foreach \
		o,crtend.o crtn.o,$(call library,$(o)))' > $@

# The ten submissions of the instructor's page.
EXAMPLE_CLASS := build/example-class
EXAMPLE_BLANKS := build/blanks/01-corners.c build/blanks/03-screen.c
$(EXAMPLE_CLASS): tests/grade/example/class.txt tests/grade/example/unpack.py $(EXAMPLE_BLANKS) $(LIST)
	$(Q)rm -rf $@ && PYTHONPATH=tests python3 -B -m grade.example.unpack $@
	$(Q)mkdir $@/blank && cp $(EXAMPLE_BLANKS) $@/blank
grade: $(filter $(EXAMPLE_CLASS),$(SUBMISSIONS))

# By the environment, where any folder's name is just a name.
grade: export SUBMISSIONS := $(SUBMISSIONS)
grade: export OUT := $(or $(OUT),build/grades)
grade: export POLICY := $(POLICY)
grade: $(KIT)/commands ## mark a class: SUBMISSIONS=dir OUT=build/grades
	@python3 -B tests/grade $(KIT)

# A '$' in them is the instructor's own.
grade-set: override export COMMENT := $(value COMMENT)
grade-set: override export WHO := $(value WHO)
grade-set: $(LIST) ## a decision: WHO=anna WHAT='extra days' VALUE=2 COMMENT=ill
	@PYTHONPATH=tests python3 -B -m grade.people.decide
return: $(LIST) ## marks for a platform: FOR=moodle GRADES=worksheet.csv
	@PYTHONPATH=tests python3 -B -m grade.people.hand_back

term: ## the weeks of a term beside each other: WEEKS=folder
	@PYTHONPATH=tests python3 -B -m grade.people.term
similar: $(LIST) $(BLANKS) ## who agrees in an unusual way: OUT/similar.html
	@PYTHONPATH=tests python3 -B -m grade.people.similar

# What git tracks, with the changes in the working tree; at its root the programs that Gradescope starts.
GRADESCOPE := build/gradescope.zip
AS_SOMEBODY := GIT_AUTHOR_DATE=2000-01-01T00:00:00Z GIT_COMMITTER_DATE=2000-01-01T00:00:00Z \
	git -c user.name=make -c user.email=make@localhost
gradescope: ## build/gradescope.zip, an autograder for Gradescope
	$(Q)mkdir -p build && changed=$$($(AS_SOMEBODY) stash create) && git archive --format=zip -o $(GRADESCOPE) \
		$(patsubst %,--add-file=tests/grade/recipes/gradescope/%,setup.sh run_autograder) \
		--prefix=toolkit/ $${changed:-HEAD}
	@echo "$(GRADESCOPE): $$(($$(wc -c <$(GRADESCOPE)) / 1024)) KB. It holds the solutions: not for students."
.PHONY: grade grade-set return term similar gradescope
