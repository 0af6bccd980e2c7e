# optional.mk - make optional: tasks without marks, whose picture is compared with a committed one.
# Included by the Makefile.

# Each task is a program of its own, exercises/optional/NAME.c, linked with the answers.
OPTIONAL := $(sort $(notdir $(basename $(wildcard exercises/optional/*.c solutions/optional/*.c))))
OPTIONAL_BLANKS := $(OPTIONAL:%=build/blanks/optional/%.c)
TASKS := $(if $(TASK),$(filter $(TASK) $(foreach n,01 02 03 04 05 06 07 08 09,$(n)-$(TASK)),$(OPTIONAL)),$(OPTIONAL))
ifeq ($(TASKS),)
$(error TASK=$(TASK): no such task, expected one of $(OPTIONAL))
endif
TASK_FOLDER := $(BUILT)/optional
TASK_STATE := $(B)/tests/course/optional/task_state
$(TASK_STATE).o: EXTRA = $(PNG_CFLAGS)
$(TASK_STATE): $(TASK_STATE).o $(B)/tests/judge/picture_panels.o $(B)/common.a
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
$(TASK_STATES): $(TASK_FOLDER)/%.state: $(TASK_FOLDER)/% $(TASK_STATE) exercises/optional/pictures/%.png \
		$(wildcard exercises/optional/*.nff)
	$(Q)rm -f $(@:.state=.png) $(@:.state=-panels.png)
	$(Q)$< -o $(@:.state=.png) > $(@:.state=.words) 2>&1 || echo "the program ended with status $$?" >> $(@:.state=.words)
	$(Q)$(TASK_STATE) check $* $(@D) $(word 3,$^)

# The programs are those of EXERCISES, which in the toolkit is another folder than ANSWERS.
optional: $(OPTIONAL_BLANKS) $(TASK_STATE) ## tasks without marks: pictures to compare with (TASK=name)
	@MAKEFLAGS= $(MAKE_AGAIN) --no-print-directory tasks $(MAKEOVERRIDES) ANSWERS='$(EXERCISES)'
	@$(if $(TASK),$(TASK_STATE) show $(TASKS) $(B)/$(EXERCISES:/%=%)/optional)
# For the list, tasks whose blank has not changed are not built.
BEGUN = $(if $(TASK),$(TASKS),$(strip $(foreach t,$(TASKS),$(if $(shell \
	cmp -s $(call task_source,$(t)) build/blanks/optional/$(t).c || echo begun),$(t)))))
tasks: $(if $(filter tasks,$(MAKECMDGOALS)),$(BEGUN:%=$(TASK_FOLDER)/%.state))
	@$(if $(TASK),,rm -f $(patsubst %,$(TASK_FOLDER)/%.state,$(filter-out $(BEGUN),$(TASKS))); \
		$(TASK_STATE) list $(TASK_FOLDER) $(foreach t,$(TASKS),$(call task_source,$(t))))
.PHONY: optional tasks
