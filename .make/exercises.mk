# exercises.mk - make exercises, watch, hint, debug, reset, submission. Included by the Makefile.

# 'make exercises' judges the answers in exercises/, unless another folder is named. The chapters
# whose answer has not changed are not judged again.
EXERCISES := $(if $(filter command line environment,$(origin ANSWERS)),$(A),exercises)
CHOSEN := $(if $(EX),$(filter $(EX)% 0$(EX)%,$(STEMS)),$(STEMS))
ifeq ($(CHOSEN),)
$(error EX=$(EX): no such chapter, expected 01 to $(lastword $(subst -, ,$(STEMS:%=0$(words $(STEMS))))))
endif
ifneq ($(filter debug reset,$(MAKECMDGOALS)),)
ifneq ($(words $(CHOSEN)),1)
$(error which chapter? Say, for example: make $(filter debug reset,$(MAKECMDGOALS)) EX=05)
endif
endif
VERDICT := $(B)/$(EXERCISES:/%=%)/verdict
RECORDS := $(STEMS:%=$(VERDICT)/%.record)
ifneq ($(filter exercises watch debug hint status submission,$(MAKECMDGOALS)),)
ifeq ($(wildcard $(B)/judge),)
$(info Building the judge, once; that takes a moment ...)
endif
endif
# The parts of the answering process besides the answer.
ANSWERING := $(patsubst %,$(B)/tests/judge/%.o,answering answer_calls calls_traced) $(CALLING)
answering = $(B)/answering/$(1).o $(earlier_answers) $(B)/common.a
# The tests judge. A handout has none, nor solutions: it judges by tables of right results (tests/given.tar).
ifneq ($(wildcard .make/toolkit/tests.mk),)
include .make/toolkit/tests.mk
else
# A chapter depends on the answers of the earlier ones: each is judged first, and its object file
# (that of the blank, if it does not compile) is linked with the later ones.
earlier_answers = $(patsubst %,$(VERDICT)/%/answer.o,$(call earlier,$(1)))
stands_on = $(call earlier,$(1))
endif
# Linked in advance, so that nobody waits for it at each verdict.
$(STEMS:%=$(B)/answering/%.o): $(B)/answering/%.o: $(ANSWERING) $(B)/dispatch/%.o $(lent)
	$(call say,link,$@)
	$(Q)mkdir -p $(@D)
	$(Q)$(CC) -r -nostdlib -Wl,-S -o $@ $^
# Not optimised: that takes longer than what it saves. Besides that, the compiler sees what it sees
# for the programs, so that what is right here also builds there. An index beyond the end of an array
# is a crash, not luck. Each function says when it is entered, and the memory of its variables is filled first
# (tests/judge/message.h).
IS_CLANG := $(findstring clang,$(FLAGS_NOW))
FILL_FIRST := $(if $(filter x86_64,$(word 2,$(ASKED))),-pg -mfentry)
ANSWER_FLAGS = $(LANGUAGE) -O0 -ffunction-sections -finstrument-functions $(FILL_FIRST) $(SANITIZER) $(FOR_STUDENTS) \
	-fsanitize=bounds$(if $(IS_CLANG),,-strict) -fsanitize-undefined-trap-on-error
# Without link-time optimisation and what a debugger reads, linking takes two thirds of the time.
LINK_SOON := -Wl,-S $(if $(IS_CLANG),,-fno-use-linker-plugin)
JUDGES_LAYOUTS := $(wildcard $(addprefix $(GIVEN),common/figure/plot.gp chapters/*/figures/yours-and-right.gp tests/judge/layouts/*.gp))

# The pictures of a student's answers, before a chapter is right and after it (tests/course/pictures/).
# In the toolkit the reference, under other names, replaces missing answers; a handout has no reference.
DRAWING_ANSWERS := $(B)/tests/course/pictures/draw.o
$(DRAWING_ANSWERS): EXTRA = $(PNG_CFLAGS) -include $(B)/weak.h
$(DRAWING_ANSWERS): $(B)/weak.h
HAS_REFERENCE := $(wildcard solutions/.)
right_of = $(if $(HAS_REFERENCE),$(B)/solutions/direct/$(1).o)
SPHERES := $(GIVEN)tests/course/pictures/spheres.nff
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

# The calls of a test, made directly, for gdb.
for_debug = $(B)/tests/judge/debug.o $(READING) $(B)/dispatch/$(1).o $(earlier_answers) $(B)/common.a

# The program that judges answers and prints verdicts (tests/course/course.c), and its plan.
COURSE := $(B)/course
$(COURSE): $(B)/tests/course/course.o $(COURSE_PARTS) $(B)/common.a
	$(call say,link,$@)
	$(Q)$(LINK) -o $@ $^ -lm
PLAN := $(VERDICT)/plan
plan_lines = $(foreach s,$(STEMS),'chapter	$(s)' 'objects	$(call answering,$(s))' \
	$(if $(value stands_on),'stands on	$(call stands_on,$(s))') $(if $(HAS_REFERENCE),'right	$(call right_of,$(s))') \
	'program	$(B)/tests/judge/calls_traced.o $(call drawing_of,$(s))')
$(PLAN): $(COURSE) $(JUDGE) $(TABLES) $(B)/weak.h $(B)/flags.mk $(JUDGES_LAYOUTS) Makefile $(wildcard .make/*.mk .make/toolkit/*.mk) \
		$(foreach s,$(STEMS),$(filter-out $(VERDICT)/%,$(call answering,$(s))))
	@mkdir -p $(@D)
	@printf '%s\n' 'answers	$(EXERCISES)' 'built	$(B)/$(EXERCISES:/%=%)' \
		'compile	$(CC) $(ANSWER_FLAGS) -include $(B)/weak.h -c' 'link	$(LINK) $(LINK_SOON)' 'judge	$(JUDGE)' \
		"tools	$$(cat $^ | cksum)" 'hide	$(HIDE_HELPERS)' \
		$(if $(value stands_on),,'lend	-Wl$(comma)--defsym=NAME=lent_NAME') 'draw	$(DRAW_FIGURES) --one' \
		$(if $(HAS_REFERENCE),'reference	-Wl$(comma)--defsym=NAME=answer_NAME') \
		'drawing	$(DRAWING_ANSWERS) $(B)/tests/judge/calls_traced.o $(B)/common.a' \
		'spheres	$(SPHERES) $(RECORDED)' 'libraries	$(PNG_LIBS) -lpthread' $(plan_lines) > $@.new
	@mv $@.new $@
# All that course uses.
FOR_JUDGING = $(PLAN) $(B)/exercises.names $(BLANKS) $(FOR_PICTURES)
USED_WITH = $(if $(value stands_on),$(STEMS),$(1))
# 'make all' already builds everything that the first verdict needs, so nobody waits for it.
FOR_EXERCISES = $(call FOR_JUDGING,$(STEMS))

exercises: $(call FOR_JUDGING,$(call USED_WITH,$(CHOSEN))) ## what is right, wrong, not yet (EX=05: one chapter)
	$(Q)$(COURSE) exercises $(PLAN) $(CHOSEN)

watch: $(call FOR_JUDGING,$(call USED_WITH,$(CHOSEN))) ## judge again whenever an answer is saved
	$(Q)$(COURSE) watch $(PLAN) $(CHOSEN)

hint: $(call FOR_JUDGING,$(call USED_WITH,$(CHOSEN))) ## one hint more each time (EX=05: of that chapter)
	$(Q)$(COURSE) hint $(PLAN) $(CHOSEN)

status: $(call FOR_JUDGING,$(call USED_WITH,$(CHOSEN))) ##+ for scripts: a line for each function; fails unless all are right
	$(Q)$(COURSE) judge $(PLAN) $(CHOSEN) && $(COURSE) status $(PLAN) $(CHOSEN)

debug: $(call FOR_JUDGING,$(call USED_WITH,$(CHOSEN))) $(if $(filter debug,$(MAKECMDGOALS)),$(filter-out $(VERDICT)/%,$(call for_debug,$(CHOSEN)))) ## gdb at the call that failed (EX=05)
	@mkdir -p $(B)/debug
	$(Q)$(COURSE) judge $(PLAN) $(CHOSEN)
	@$(CC) $(LANGUAGE) -g3 -O0 -c -o $(B)/debug/$(CHOSEN).o $(call answer_in,$(EXERCISES),$(CHOSEN))
	@$(HIDE_HELPERS) $(B)/debug/$(CHOSEN).o
	@$(CC) -o $(B)/debug/$(CHOSEN) $(B)/debug/$(CHOSEN).o $(call for_debug,$(CHOSEN)) $(CHECK_LIBS) $(PNG_LIBS) -lm
	$(Q)$(COURSE) debug $(PLAN) $(CHOSEN) $(B)/debug/$(CHOSEN)

reset: $(BLANKS) $(COURSE) $(PLAN) ## put a blank back; your answer is kept beside it (EX=05)
	$(Q)$(COURSE) reset $(PLAN) $(CHOSEN)

# For what is made of the records: they change only if a verdict does.
$(VERDICT)/judged: $(call FOR_JUDGING,$(STEMS)) FORCE
	$(Q)$(COURSE) judge $(PLAN) $(STEMS)
$(RECORDS): $(VERDICT)/judged ;
.PHONY: status FORCE

# For what draws by a student's answers: the programs are optimised, so that a variable that was never set may hold
# what makes the picture right. The verdicts are about the answers.
SAY_WRONG = $(if $(filter solutions,$(A)),,@$(COURSE) faults $(PLAN) $(STEMS))
FOR_SAY_WRONG = $(if $(filter solutions,$(A)),,$(FOR_EXERCISES))

# It is packed also if nothing can be judged (-k), and whatever is wrong in it.
SUBMISSION := build/submission.zip
packed: $(BLANKS)
	@command -v python3 >/dev/null || { echo "An archive needs python3, which 'make setup' installs; or hand in the files $(EXERCISES)/*.c as they are."; exit 1; }
	@$(PACK) $(SUBMISSION) $(EXERCISES) build/blanks $(STEMS)
submission: packed $(call FOR_JUDGING,$(STEMS)) ## one archive of your answers, to hand in
	$(Q)$(COURSE) faults $(PLAN) $(STEMS)
.PHONY: packed submission

# ---- optional tasks: without marks; their picture is compared with a committed one ---------------

# Each task is a program of its own, exercises/optional/NAME.c, linked with the answers.
OPTIONAL := $(sort $(notdir $(basename $(wildcard exercises/optional/*.c solutions/optional/*.c))))
OPTIONAL_BLANKS := $(OPTIONAL:%=build/blanks/optional/%.c)
TASKS := $(if $(TASK),$(filter $(TASK) $(foreach n,01 02 03 04 05 06 07 08 09,$(n)-$(TASK)),$(OPTIONAL)),$(OPTIONAL))
ifeq ($(TASKS),)
$(error TASK=$(TASK): no such task, expected one of $(OPTIONAL))
endif
TASK_FOLDER := $(BUILT)/optional
COMPARE_TASK := $(B)/tests/course/pictures/compare_task
$(COMPARE_TASK).o: EXTRA = $(PNG_CFLAGS)
$(COMPARE_TASK): $(COMPARE_TASK).o $(B)/tests/judge/picture_panels.o $(B)/common.a
	$(call say,link,$@)
	$(Q)$(LINK) -o $@ $^ $(PNG_LIBS) -lm

TASK_PROGRAMS := $(OPTIONAL:%=$(TASK_FOLDER)/%)
task_source = $(call answer_in,$(A),optional/$(1))
$(TASK_PROGRAMS): $(TASK_FOLDER)/%: $$(call task_source,$$*) $(ANSWER_OBJECTS) $(B)/chapters/shared.a \
		$(B)/common.a $(B)/flags.mk $(wildcard common/*.h chapters/shared/*.h exercises/*.h)
	$(call say,compile,$<)
	$(Q)mkdir -p $(@D)
	$(Q)$(CC) $(LANGUAGE) $(CFLAGS) $(SANITIZER) $(if $(filter solutions,$(A)),$(STRICT) $(WERROR),$(FOR_STUDENTS)) \
		$(LDFLAGS) -o $@ $(filter %.c %.o %.a,$^) $(PNG_LIBS) -lm

# The picture of a task, and how far it is from the expected one.
TASK_STATES := $(OPTIONAL:%=$(TASK_FOLDER)/%.state)
$(TASK_STATES): $(TASK_FOLDER)/%.state: $(TASK_FOLDER)/% $(COMPARE_TASK) exercises/optional/pictures/%.png \
		$(wildcard $(GIVEN)exercises/optional/*.nff)
	$(Q)rm -f $(@:.state=.png) $(@:.state=-panels.png)
	$(Q)$< -o $(@:.state=.png) > $(@:.state=.words) 2>&1 || echo "the program ended with status $$?" >> $(@:.state=.words)
	$(Q)$(COMPARE_TASK) $* $(@D) $(word 3,$^) > $@

# The programs are those of EXERCISES, which in the toolkit is another folder than ANSWERS.
optional: $(OPTIONAL_BLANKS) $(COMPARE_TASK) ## tasks without marks: pictures to compare with (TASK=name)
	@MAKEFLAGS= $(MAKE_AGAIN) --no-print-directory tasks $(MAKEOVERRIDES) ANSWERS='$(EXERCISES)'
	@$(if $(TASK),state=$(B)/$(EXERCISES:/%=%)/optional/$(TASKS).state; printf '%s: ' $(TASKS); cat $$state; sed q $$state | grep -qx right)
# A line of the list has at most 80 columns. A task's source begins with '// NAME.c - what it is.'
list_task = printf '  %-18s %s\n' $(1) "$$(sed 's/;.*//; q' $(TASK_FOLDER)/$(1).state 2>/dev/null || echo 'not begun')"; \
	sed 's|^.*\.c - |    |; q' $(call task_source,$(1));
# For the list, tasks whose blank has not changed are not built.
BEGUN = $(if $(TASK),$(TASKS),$(strip $(foreach t,$(TASKS),$(if $(shell \
	cmp -s $(call task_source,$(t)) build/blanks/optional/$(t).c || echo begun),$(t)))))
tasks: $(if $(filter tasks,$(MAKECMDGOALS)),$(BEGUN:%=$(TASK_FOLDER)/%.state))
	@$(if $(TASK),:,rm -f $(patsubst %,$(TASK_FOLDER)/%.state,$(filter-out $(BEGUN),$(TASKS))); \
		$(foreach t,$(TASKS),$(call list_task,$(t))))
.PHONY: optional tasks
