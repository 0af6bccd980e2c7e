# exercises.mk - make exercises, watch, hint, debug, reset, submission. Included by the Makefile.

# 'make exercises' judges the answers in exercises/, unless another folder is named. The chapters
# whose answer has not changed are not judged again.
EXERCISES := $(if $(filter command line environment,$(origin ANSWERS)),$(A),exercises)
CHOSEN := $(if $(EX),$(filter $(EX)% 0$(EX)%,$(STEMS)),$(STEMS))
ifeq ($(CHOSEN),)
$(error EX=$(EX): no such chapter, expected 01 to $(lastword $(subst -, ,$(STEMS:%=0$(words $(STEMS))))))
endif
ifneq ($(filter debug reset hint,$(MAKECMDGOALS)),)
ifneq ($(words $(CHOSEN)),1)
$(error which chapter? Say, for example: make $(filter debug reset hint,$(MAKECMDGOALS)) EX=05)
endif
endif
VERDICT := $(B)/$(EXERCISES:/%=%)/verdict
RECORDS := $(STEMS:%=$(VERDICT)/%.record)
ifneq ($(filter exercises watch debug hint status,$(MAKECMDGOALS)),)
ifeq ($(wildcard $(B)/judge),)
$(info Building the judge, once; that takes a moment ...)
endif
endif
# The parts of the answering process besides the answer.
ANSWERING := $(patsubst %,$(B)/tests/judge/%.o,answering answer_calls calls_traced) $(CALLING)
answering = $(ANSWERING) $(B)/dispatch/$(1).o \
	$(lent) $(earlier_answers) $(B)/common.a
# The tests judge. A handout has none, and judges by recorded tables.
include $(firstword $(wildcard .make/toolkit/tests.mk .make/tables.mk))
# Between saving and reading is the linker: the quickest that there is. It leaves out what is for a
# debugger, unless a sanitizer wants to name lines.
QUICK_LINKER = $(firstword $(foreach l,gold mold lld,$(if $(shell command -v ld.$(l)),-fuse-ld=$(l))))
# Not optimised: that takes longer than what it saves. Besides that, the compiler sees what it sees
# for the programs, so that what is right here also builds there. An index beyond the end of an array
# is a crash, not luck. Each function says when it is entered (tests/judge/calls_traced.h).
IS_CLANG := $(findstring clang,$(FLAGS_NOW))
QUICK_FLAGS = $(LANGUAGE) -O0 -ffunction-sections -finstrument-functions $(SANITIZER) $(FOR_STUDENTS) \
	-fsanitize=bounds$(if $(IS_CLANG),,-strict) -fsanitize-undefined-trap-on-error
JUDGES_LAYOUTS := common/figure/plot.gp $(wildcard chapters/*/figures/yours-and-right.gp) $(wildcard tests/judge/layouts/*.gp)

# The pictures of a student's answers, before a chapter is right and after it (tests/course/pictures/).
# In the toolkit the reference, under other names, replaces missing answers; a handout has no reference.
DRAWING_ANSWERS := $(B)/tests/course/pictures/draw.o
$(DRAWING_ANSWERS): EXTRA = $(PNG_CFLAGS) -include $(B)/weak.h
$(DRAWING_ANSWERS): $(B)/weak.h
HAS_REFERENCE := $(wildcard solutions/.)
right_of = $(if $(HAS_REFERENCE),$(B)/solutions/direct/$(1).o)
SPHERES := tests/course/pictures/spheres.nff
RECORDED := $(TABLE)/spheres.png
ifneq ($(HAS_REFERENCE),)
$(RECORDED): $(SPHERES) $(B)/solutions/07-shading
	$(call say,record,$@)
	$(Q)mkdir -p $(@D)
	$(Q)$(B)/solutions/07-shading -o $@ $<
endif
# A program with loops for several processors is built by make alone.
drawing_of = $(if $(wildcard chapters/$(1)/*_lanes.c chapters/$(1)/*/*_lanes.c),,$(call chapter_objects,$(1)) \
	$(B)/chapters/shared.a $(B)/common.a)
FOR_PICTURES = $(DRAWING_ANSWERS) $(B)/tests/judge/calls_traced.o $(RECORDED) $(B)/common.a \
	$(foreach s,$(STEMS),$(call right_of,$(s))) $(foreach s,$(1),$(call drawing_of,$(s)))

# The answering processes without an answer, which load it as they start (tests/course/shared_answer.h), and
# the names that they, their libraries and the linker define. They have all of common/ that needs no library.
SHARED := $(if $(SANITIZE),,$(wildcard /proc/self/exe))
LOADING := $(STEMS:%=$(B)/answering/%)
ANY_ANSWER := $(B)/answering/any/answer.so
LENT_SHARED := $(patsubst %.o,%.pic.o,$(lent))
$(ANY_ANSWER): $(B)/exercises.names $(SETUP_FIRST)
	$(Q)mkdir -p $(@D)
	$(Q)sed 's/.*/void &(void); void &(void) {}/' $< | $(CC) -shared -fPIC -Wl,-soname,answer.so -o $@ -x c -
without_answers = $(filter %.o,$(filter-out $(VERDICT)/%,$(call answering,$(1))))
$(LOADING): $(B)/answering/%: $$(call without_answers,$$*) \
		$(filter-out %/image_png.o %/image_bands.o %/image_flat.o %/picture.o,$(patsubst %.c,$(B)/%.o,$(wildcard common/*.c))) $(ANY_ANSWER)
	$(call say,link,$@)
	$(Q)$(LINK) -rdynamic -Wl,-S -Wl,-rpath,'$$ORIGIN' -o $@ $^ -Wl,--no-as-needed -lm
$(LOADING:%=%.names): %.names: %
	$(Q){ echo _GLOBAL_OFFSET_TABLE_; nm -gP --defined-only $<; for library in libc libm; do \
		nm -DgP --defined-only "$$($(CC) -print-file-name=$$library.so.6)" 2>/dev/null; done; } | sed 's/[@ ].*//' > $@
$(B)/%.pic.o: %.c $(B)/flags.mk $(SETUP_FIRST)
	$(call say,compile,$<)
	$(Q)mkdir -p $(@D)
	$(Q)$(COMPILE) -fPIC -o $@ $<
FOR_SHARED = $(if $(SHARED),$(patsubst %,$(B)/answering/%.names,$(1)) $(LENT_SHARED))

# Half of the time to compile a short answer is spent reading <math.h>, which most contracts include: gcc finds
# those precompiled, ahead of -I. (the answers' names are made weak there, because nothing may come before).
PRECOMPILED := $(if $(IS_CLANG),,$(STEMS:%=$(B)/precompiled/exercises/%.h))
$(PRECOMPILED): $(B)/precompiled/%: % $(wildcard common/*.h) $(B)/weak.h $(B)/flags.mk $(SETUP_FIRST)
	$(Q)mkdir -p $(@D) && rm -f $@.gch
	$(Q)printf '%s\n' '#include "$(B)/weak.h"' '#include_next "$<"' > $@
	$(Q)if [ "$$($(CC) $(LANGUAGE) -E $< | wc -c)" -gt 20000 ]; then $(COMPILE_QUICKLY) -x c-header -o $@.gch $@ 2>/dev/null || true; fi
# For the compiler that waits (tests/course/waiting_compiler.h). In an included file it would not mention
# constants that nobody uses.
	$(Q)printf '%s\n' '#include "$<"' '#pragma GCC diagnostic warning "-Wunused-const-variable=2"' \
		'#include "/dev/stdin"' > $(B)/precompiled/$(basename $(*F)).c
COMPILE_EARLY = $(subst -I.,-I$(B)/precompiled -I.,$(COMPILE_QUICKLY)) -c
COMPILE_QUICKLY = $(CC) -pipe $(QUICK_FLAGS) $(if $(SHARED),-fPIC)

# The program that judges answers and prints verdicts (tests/course/course.c), and its plan.
COURSE := $(B)/course
$(COURSE): $(B)/tests/course/course.o $(COURSE_PARTS) $(B)/tests/judge/show.o $(B)/common.a
	$(call say,link,$@)
	$(Q)$(LINK) -o $@ $^ -lm
PLAN := $(VERDICT)/plan
# cc says (-###) which linker it would start, and how; course starts that one itself. Nothing is needed
# for optimising at link time, nor a build id. The libraries are named by their files, because to find them the
# linker would list folders of thousands of files; and gold reads only the parts of them that it needs. The
# assembler works while the compiler does (-pipe).
QUICK = $(QUICK_LINKER) $(if $(filter %=gold,$(QUICK_LINKER)),-Wl$(comma)--no-map-whole-files) $(if $(SANITIZE),,-Wl$(comma)-S)
QUICK_PROGRAM = $(shell command -v $(if $(QUICK_LINKER),$(patsubst -fuse-ld=%,ld.%,$(QUICK_LINKER)),ld))
library_file = $(firstword $(filter /%,$(foreach ending,so.1 so a,$(shell $(CC) -print-file-name=lib$(1).$(ending)))) -l$(1))
ANY_OBJECT := $(B)/tests/course/page.o
as_linker = sed -n 's/"//g; /^ .* -o NAME /{ s/ -plugin [^ ]*//; s/ -plugin-opt=[^ ]*//g; s/ -fuse-ld=[^ ]*//; \
	s/ --build-id / /; $(foreach l,m c gcc gcc_s,s| -l$(l) | $(call library_file,$(l)) |g; s| -l$(l) | $(call library_file,$(l)) |g;) \
	$(if $(SANITIZE),,s/ -L[^ ]*//g;) s|^ [^ ]*/collect2|$(QUICK_PROGRAM)|; s| $(ANY_OBJECT) | OBJECTS |; s/^ */directly	/p; }'
# cc also says which compiler and assembler it would start, in two lines.
ANY_SOURCE := tests/course/page.c
as_compiler = sed -n 's/"//g; /^ .*cc1 .* -o - |$$/{ N; s| $(ANY_SOURCE) | SOURCE |; s/ |\n */ | /; s/^ *//; /SOURCE.* -o OBJECT$$/p; }'
plan_lines = $(foreach s,$(STEMS),'chapter	$(s)' 'objects	$(call answering,$(s))' \
	$(if $(value stands_on),'stands on	$(call stands_on,$(s))') $(if $(HAS_REFERENCE),'right	$(call right_of,$(s))') \
	'program	$(B)/tests/judge/calls_traced.o $(call drawing_of,$(s))')
$(PLAN): $(ANY_OBJECT) Makefile $(wildcard .make/*.mk .make/toolkit/*.mk) $(B)/flags.mk
	@mkdir -p $(@D)
	@early=$$($(COMPILE_EARLY) -### -o OBJECT $(ANY_SOURCE) 2>&1 | $(as_compiler)); \
	directly=$$($(LINK) $(QUICK) -### -o NAME $(ANY_OBJECT) -lm 2>&1 | $(as_linker)); \
	printf '%s\n' 'answers	$(EXERCISES)' 'built	$(B)/$(EXERCISES:/%=%)' 'verdict	$(@D)' \
		'figures	$(B)/$(EXERCISES:/%=%)/figures' 'draw	$(DRAW_FIGURES) --one' 'blanks	build/blanks' \
		'compile	$(COMPILE_QUICKLY) -include $(B)/weak.h -c' \
		$(if $(PRECOMPILED),"compile early	$${early:-$(COMPILE_EARLY) -o OBJECT SOURCE}" 'precompiled	$(B)/precompiled' \
			'headers	$(wildcard common/*.h) $(B)/weak.h') \
		'link	$(LINK)' 'quick	$(QUICK)' \
		$(if $(value stands_on),'hide	$(HIDE_HELPERS)','lend	-Wl$(comma)--defsym=NAME=lent_NAME') \
		'drawing	$(DRAWING_ANSWERS) $(B)/tests/judge/calls_traced.o $(B)/common.a' \
		'spheres	$(SPHERES) $(RECORDED)' 'libraries	$(foreach word,$(PNG_LIBS) -lpthread,$(if $(filter -l%,$(word)),$(call library_file,$(word:-l%=%)),$(word)))' \
		$(if $(HAS_REFERENCE),'reference	-Wl$(comma)--defsym=NAME=answer_NAME') \
		$${directly:+"$$directly"} \
		$(if $(SHARED),'shared	$(shell command -v ld) -shared -z now -z text -S --hash-style=gnu -soname answer.so -o' \
			'loading	$(B)/answering' $(if $(LENT_SHARED),'lend shared	--defsym=NAME=lent_NAME' 'lent	$(LENT_SHARED)')) \
		'judge	$(JUDGE)' 'used	$(B)/weak.h $(COURSE) $(JUDGES_LAYOUTS)' $(plan_lines) > $@.new
	@mv $@.new $@
# All that course uses.
FOR_JUDGING = $(COURSE) $(PLAN) $(DRAW_FIGURES) $(B)/weak.h $(B)/exercises.names $(BLANKS) $(JUDGES_LAYOUTS) \
	$(FOR_PICTURES) $(JUDGE) $(FOR_SHARED) $(filter $(1:%=$(B)/precompiled/exercises/%.h),$(PRECOMPILED)) $(foreach s,$(1),$(filter-out $(VERDICT)/%,$(call answering,$(s))))
USED_WITH = $(if $(value stands_on),$(STEMS),$(1))
# 'make all' already builds everything that the first verdict needs, so nobody waits for it.
FOR_EXERCISES = $(call FOR_JUDGING,$(STEMS))

# Make starts course itself, without a shell, and has nothing to add to what course has said.
exercises: export QUIET_MAKE := yes
exercises: $(call FOR_JUDGING,$(call USED_WITH,$(CHOSEN))) ## what is right, wrong, not yet (EX=05: one chapter)
	@$(COURSE) exercises $(PLAN) $(CHOSEN)

watch: $(call FOR_JUDGING,$(call USED_WITH,$(CHOSEN))) ## judge again whenever an answer is saved
	@$(COURSE) watch $(PLAN) $(CHOSEN)

hint: $(call FOR_JUDGING,$(call USED_WITH,$(CHOSEN))) ## one hint more each time it is asked for (EX=05)
	@$(COURSE) hint $(PLAN) $(CHOSEN)

status: $(call FOR_JUDGING,$(call USED_WITH,$(CHOSEN))) ## how each function is, a line each
	@$(COURSE) judge $(PLAN) $(CHOSEN) && $(COURSE) status $(PLAN) $(CHOSEN)

debug: $(call FOR_JUDGING,$(call USED_WITH,$(CHOSEN))) $(if $(filter debug,$(MAKECMDGOALS)),$(filter-out $(VERDICT)/%,$(call for_debug,$(CHOSEN)))) ## gdb at the call that failed (EX=05)
	@mkdir -p $(B)/debug
	@$(COURSE) judge $(PLAN) $(CHOSEN)
	@$(CC) $(LANGUAGE) -g3 -O0 -c -o $(B)/debug/$(CHOSEN).o $(call answer_in,$(EXERCISES),$(CHOSEN))
	@$(HIDE_HELPERS) $(B)/debug/$(CHOSEN).o
	@$(CC) -o $(B)/debug/$(CHOSEN) $(B)/debug/$(CHOSEN).o $(call for_debug,$(CHOSEN)) $(CHECK_LIBS) $(PNG_LIBS) -lm
	@$(COURSE) debug $(PLAN) $(CHOSEN) $(B)/debug/$(CHOSEN)

reset: $(BLANKS) $(COURSE) $(PLAN) ## put a blank back; your answer is kept beside it (EX=05)
	@$(COURSE) reset $(PLAN) $(CHOSEN)

# For what is made of the records: they change only if a verdict does.
$(VERDICT)/judged: $(call FOR_JUDGING,$(STEMS)) FORCE
	@$(COURSE) judge $(PLAN) $(STEMS)
$(RECORDS): $(VERDICT)/judged ;
.PHONY: status FORCE

submission: $(PACK) $(BLANKS) ## one archive of your answers, to hand in
	@$(PACK) build/submission.zip $(EXERCISES) build/blanks $(STEMS)
.PHONY: submission
