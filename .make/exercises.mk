# exercises.mk - make exercises, watch, hint, debug, reset, submission. Included by the Makefile.

# 'make exercises' judges what stands in exercises/, unless another folder is named. The chapters
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
ALL_VERDICTS := $(STEMS:%=$(VERDICT)/%/table)
VERDICTS := $(CHOSEN:%=$(VERDICT)/%/table)
JUDGING_FOR := $(filter exercises watch debug hint $(if $(RIGHT),all figures slides),$(or $(MAKECMDGOALS),all))
ifneq ($(JUDGING_FOR),)
ifeq ($(wildcard $(B)/judge/$(firstword $(CHOSEN))),)
$(info Building the judge, once; that takes a moment ...)
endif
$(call changed,$(VERDICT),$(EXERCISES))
endif
# What the answering process holds besides the answer.
answering = $(B)/tests/judge/answering.o $(CALLING) $(B)/judge/dispatch-$(1).o \
	$(lent) $(earlier_answers) $(B)/common.a
# The tests judge. A handout has none, and judges by recorded tables.
include $(firstword $(wildcard .make/toolkit/tests.mk .make/tables.mk))
# Between saving and reading stands the linker: the quickest that is there.
QUICK_LINKER := $(if $(filter exercises watch hint debug,$(MAKECMDGOALS)),$(firstword $(foreach l, \
	gold mold lld,$(if $(shell command -v ld.$(l)),-fuse-ld=$(l)))))
# Not optimised: that takes longer than what it saves. Besides that, the compiler sees what it sees
# for the programs, so that what is right here also builds there. An index beyond the end of an array
# is a crash, not luck.
IS_CLANG := $(findstring clang,$(FLAGS_NOW))
QUICK_FLAGS = $(LANGUAGE) -O0 -ffunction-sections $(SANITIZER) $(FOR_STUDENTS) \
	-fsanitize=bounds$(if $(IS_CLANG),,-strict) -fsanitize-undefined-trap-on-error
JUDGES_LAYOUTS := common/figure/plot.gp chapters/01-corners/figures/yours-and-right.gp $(wildcard tests/judge/layouts/*.gp)
# How to judge a chapter is written down, so that 'make watch' can do it again without make.
$(ALL_VERDICTS): $(VERDICT)/%/table: $(VERDICT)/%.sum .make/verdict $(EXPLAIN) $(B)/weak.h $(B)/exercises.names \
		build/blanks/%.c $(B)/judge/% $$(call answering,$$*) $(JUDGES_LAYOUTS) $(LIST)
	@printf '%s\n' "COMPILE='$(CC) $(QUICK_FLAGS) -include $(B)/weak.h -c'" \
		"LINK='$(LINK) $(QUICK_LINKER)'" "OBJECTS='$(call answering,$*)'" "EXPLAIN='$(EXPLAIN)'" \
		$(if $(value stands_on),"STANDS_ON='$(call stands_on,$*)'" "HIDE_HELPERS='$(HIDE_HELPERS)'") \
		'export COMPILE LINK OBJECTS EXPLAIN STANDS_ON HIDE_HELPERS' \
		'exec .make/verdict $(@D) $(call answer_in,$(EXERCISES),$*) $(B)/judge/$*' > $(@D).sh
	@sh $(@D).sh

# What the first verdict needs is built by 'make all' already: nobody waits for it then. Not the student's
# own answers, on which a chapter of a handout stands.
FOR_EXERCISES = $(JUDGES) $(LIST) $(EXPLAIN) $(B)/weak.h $(B)/exercises.names $(BLANKS) \
	$(filter-out $(VERDICT)/%,$(sort $(foreach stem,$(STEMS),$(call answering,$(stem)))))

exercises: $(VERDICTS) ## what is right, wrong, not yet (EX=05: one chapter)
	@.make/exercises $(VERDICT) $(EXERCISES) $(CHOSEN)

watch: $(VERDICTS) ## judge again whenever an answer is saved
	@.make/watch $(VERDICT) $(EXERCISES) $(CHOSEN)

hint: $(VERDICTS) ## one hint more each time it is asked for (EX=05)
	@name=$$(awk '$$1 !~ /^[+!]/ { if (!($$2 in first)) first[$$2] = $$1; if ($$2 != "right") last = $$1 } \
			END { print ("wrong" in first ? first["wrong"] : "unanswered" in first ? first["unanswered"] : last) }' \
			$(VERDICT)/$(CHOSEN)/table); \
		[ -n "$$name" ] || { echo "$(CHOSEN) needs no hint: make exercises EX=$(EX)"; exit 0; }; \
		.make/hint exercises/$(CHOSEN).hints "$$name" $(call answer_in,$(EXERCISES),$(CHOSEN)) \
		$(VERDICT)/$(CHOSEN).hint

debug: $(VERDICTS) $(if $(filter debug,$(MAKECMDGOALS)),$(call for_debug,$(CHOSEN)) $(B)/exercises.names) ## gdb at the call that failed (EX=05)
	@mkdir -p $(B)/debug
	@$(CC) $(LANGUAGE) -g3 -O0 -c -o $(B)/debug/$(CHOSEN).o $(call answer_in,$(EXERCISES),$(CHOSEN))
	@$(HIDE_HELPERS) $(B)/debug/$(CHOSEN).o
	@$(CC) -o $(B)/debug/$(CHOSEN) $(B)/debug/$(CHOSEN).o $(call for_debug,$(CHOSEN)) $(CHECK_LIBS) $(PNG_LIBS) -lm
	@.make/debug $(VERDICT)/$(CHOSEN) $(CHOSEN) $(B)/debug/$(CHOSEN)

reset: $(BLANKS) ## put a blank back; your answer is kept beside it (EX=05)
	@.make/reset build/blanks/$(CHOSEN).c exercises/$(CHOSEN).c

submission: $(PACK) $(BLANKS) ## one archive of your answers, to hand in
	@$(PACK) build/submission.zip $(EXERCISES) build/blanks $(STEMS)
.PHONY: submission
