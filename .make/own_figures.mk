# own_figures.mk - make figures FIGURES=folder: figures of your own, from any folder. Included by .make/figures.mk.

# The first line of FOLDER/NAME.gp names the numbers that it draws: '# data: FIGURE [OPTION]...' those of a
# chapter's figure, '# data: FILE.c' those of a source beside it (chapters/shared/own_figure.h).
ifneq ($(FIGURES),)
ifneq ($(words $(FIGURES))$(findstring %,$(FIGURES)),1)
$(error FIGURES='$(FIGURES)': expected one folder, whose path has no blank and no '%')
endif
ifeq ($(wildcard $(FIGURES)/.),)
$(error FIGURES=$(FIGURES): no such folder)
endif
OWN_FIGURES := $(sort $(notdir $(basename $(wildcard $(FIGURES)/*.gp))))
ifeq ($(OWN_FIGURES),)
$(error FIGURES=$(FIGURES): no figure in it, expected a layout NAME.gp)
endif
endif

OWN_WANTED := $(if $(FIGURE),$(filter $(subst $(comma), ,$(FIGURE)),$(OWN_FIGURES)),$(OWN_FIGURES))
hash := \#
own_layout = $(FIGURES)/$(1).gp
read_data = $(eval DATA_OF_$(1) := $(firstword $(shell sed -n '1s/^$(hash) data: *//p' '$(own_layout)' 2>/dev/null)))
check_own = $(if $(wildcard $(own_layout)),,$(error $(own_layout): cannot be read, expected a file name without blanks)) \
	$(if $(filter $(1),$(FIGURE_NAMES)),$(error $(own_layout): a chapter has a figure of this name, expected another one)) \
	$(if $(DATA_OF_$(1)),,$(error $(own_layout):1: expected '$(hash) data: FIGURE', where FIGURE is whose numbers it draws: \
		$(FIGURE_NAMES); or '$(hash) data: FILE.c')) \
	$(if $(filter-out %.c $(FIGURE_NAMES),$(DATA_OF_$(1))),$(error $(own_layout):1: no figure '$(DATA_OF_$(1))', \
		expected one of $(FIGURE_NAMES), or a FILE.c)) \
	$(if $(filter-out $(notdir $(wildcard $(FIGURES)/*.c)),$(filter %.c,$(DATA_OF_$(1)))),$(error \
		$(own_layout):1: no $(DATA_OF_$(1)) in $(FIGURES)))
$(foreach figure,$(OWN_WANTED),$(call read_data,$(figure))$(call check_own,$(figure)))

# Figures of your own are read again each time, because FIGURES may have been another folder; they are drawn again
# only if their script has changed. The options of the first line are words, not commands.
OWN_SCRIPTS := $(foreach figure,$(OWN_WANTED),$(DRAWN_FIGURES)/$(figure)/$(figure).gp)
OWN_PROGRAMS := $(sort $(foreach figure,$(OWN_WANTED),$(patsubst %.c,$(BUILT)/own-figures/%,$(filter %.c,$(DATA_OF_$(figure))))))
own_program = $(or $(patsubst %.c,$(BUILT)/own-figures/%,$(filter %.c,$(DATA_OF_$(1)))),$(BUILT)/$(call stem_of,$(DATA_OF_$(1))))
print_own = $(if $(filter %.c,$(DATA_OF_$(*F))),$< --layout $(call own_layout,$(*F)) --figure $(basename $(DATA_OF_$(*F))), \
	sed -n '1s/^$(hash) data: *//p' $(call own_layout,$(*F)) | NOT_YET=$(@D) xargs $< --layout $(call own_layout,$(*F)) --figure)
$(OWN_SCRIPTS): $(DRAWN_FIGURES)/%.gp: $$(call own_program,$$(*F)) FORCE
	$(Q)mkdir -p $(@D)
	$(Q)NOT_YET=$(@D) $(print_own) > $@.new || \
		{ rm -f $@.new; echo '$(call own_layout,$(*F)):1: its data could not be computed' >&2; exit 1; }
	$(Q)$(take_script)
$(OWN_PROGRAMS): $(BUILT)/own-figures/%: $(FIGURES)/%.c $(ANSWER_OBJECTS) $(B)/chapters/shared.a $(B)/common.a FORCE
	$(call say,compile,$<)
	$(Q)mkdir -p $(@D)
	$(Q)$(CC) $(LANGUAGE) $(CFLAGS) $(SANITIZER) $(FOR_STUDENTS) $(LDFLAGS) -o $@ $(filter %.c %.o %.a,$^) $(PNG_LIBS) -lm
