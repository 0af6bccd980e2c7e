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
		$(wildcard exercises/optional/*.nff)
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
