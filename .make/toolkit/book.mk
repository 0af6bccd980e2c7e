# book.mk - the C side of make book: what a page runs, compiled to WebAssembly (chapters/book/README.md).
# Included by the Makefile.
#
# Debian's clang compiles the same sources as for the terminal. A file that cannot be compiled there (libpng,
# signals, processes) has one of the same name in chapters/book/instead/.
WASM_CC := clang --target=wasm32-wasi -mmutable-globals
# FROM=handout: for a class whose solutions stay private. The site is made of what make handout packs, and judges by
# recorded tables; it has its own folders, so nothing of the other site is ever in it.
FROM ?=
ifneq ($(filter-out handout,$(FROM)),)
$(error FROM=$(FROM): the course in a page is made FROM=handout, or without FROM of the whole toolkit)
endif
WASM := build/wasm$(FROM:%=-%)
BOOK := build/book$(FROM:%=-%)
INSTEAD := chapters/book/instead
WASM_EMULATED := signal mman process-clocks getpid
WASM_LANGUAGE := -std=c11 -D_DEFAULT_SOURCE -ffp-contract=off -I. -isystem $(INSTEAD)/include \
	-include $(INSTEAD)/include/no_processes.h \
	-ffunction-sections -fdata-sections $(foreach e,SIGNAL MMAN PROCESS_CLOCKS GETPID,-D_WASI_EMULATED_$(e))
WASM_OPTIMIZE = -O2
WASM_COMPILE = $(WASM_CC) $(WASM_LANGUAGE) $(WASM_OPTIMIZE) $(STRICT) $(WERROR) $(WASM_EXTRA) -MMD -MP -c
# The stack grows down to address 0, so that a program whose stack overflows is stopped.
WASM_LINK = $(WASM_CC) -Wl,--gc-sections -Wl,--strip-debug -Wl,--stack-first -Wl,-z,stack-size=1048576
WASM_LIBS := $(WASM_EMULATED:%=-lwasi-emulated-%) -lm

# For the objects of a list of sources: the stand-in if there is one.
instead_of = $(or $(wildcard $(INSTEAD)/$(notdir $(1))),$(1))
wasm_objects = $(foreach source,$(1),$(patsubst %.c,$(WASM)/%.o,$(call instead_of,$(source))))
wasm-is-here:
	@echo 'int main(void) { return 0; }' | $(WASM_CC) -x c -o /dev/null - 2>/dev/null || \
		{ echo "make book needs clang and a C library for WebAssembly: 'make setup FOR=book' installs them" >&2; exit 1; }
.PHONY: wasm-is-here
$(WASM)/%.o: %.c .make/toolkit/book.mk | wasm-is-here
	$(call say,wasm,$<)
	$(Q)mkdir -p $(@D)
	$(Q)$(WASM_COMPILE) -o $@ $<

# Linked before the C library, so its tanf is ours.
$(WASM)/common.a: $(call wasm_objects,$(wildcard common/*.c common/figure/*.c)) $(WASM)/$(INSTEAD)/tanf.o
$(WASM)/shared.a: $(call wasm_objects,$(wildcard chapters/shared/*.c))
$(WASM)/common.a $(WASM)/shared.a:
	$(Q)rm -f $@ && llvm-ar rcsD $@ $^

# The chapters' programs, with the reference's answers: figures and pictures. Chapter 08 is about threads.
BOOK_STEMS := $(filter-out 08-%,$(STEMS))
BOOK_PROGRAMS := $(if $(FROM),,$(BOOK_STEMS:%=$(BOOK)/programs/%.wasm))
wasm_program = $(call wasm_objects,$(filter-out %_nff.c,$(wildcard chapters/$(1)/*.c chapters/$(1)/*/*.c)))
$(BOOK_STEMS:%=$(BOOK)/programs/%.wasm): $(BOOK)/programs/%.wasm: $$(call wasm_program,$$*) $(call wasm_objects,$(foreach s,$(BOOK_STEMS),$(call exact_of,$(s)))) \
		$(WASM)/shared.a $(WASM)/common.a
	$(call say,wasm,$@)
	$(Q)mkdir -p $(@D)
	$(Q)$(WASM_LINK) -Wl,--strip-all -o $@ $^ $(WASM_LIBS)

# ---- verdicts ----------------------------------------------------------------------------------

wasm_of = $(call wasm_objects,$(patsubst $(B)/%.o,%.c,$(1)))
define wasm_link
	$(call say,wasm,$@)
	$(Q)mkdir -p $(@D)
	$(Q)$(WASM_LINK) -Wl,--strip-all -Wl,--export=__stack_pointer -o $@ $(filter %.o %.a,$^) $(WASM_LIBS)
endef

# The judge: what is known about the exercises is called once in a call, so it is small rather than quick.
WASM_REFERENCES := $(STEMS:%=$(WASM)/tests/reference/%.o)
$(WASM_REFERENCES): $(WASM)/tests/reference/%.o: $$(call exact_of,$$*) $(B)/reference.h
	$(call say,wasm,$< for the judge)
	$(Q)mkdir -p $(@D)
	$(Q)$(WASM_COMPILE) -include $(B)/reference.h -o $@ $<
$(call wasm_of,$(LAWS)): WASM_EXTRA = $(AS_KNOWN)
$(call wasm_of,$(LAWS)): $(B)/reference.h
$(call wasm_of,$(LAWS)): WASM_OPTIMIZE = -Oz
BOOK_JUDGE := $(BOOK)/programs/judge.wasm
$(WASM)/tests/judge/table.o: WASM_EXTRA = '-DTABLES="tables"'
$(BOOK_JUDGE): $(call wasm_of,$(JUDGING)) $(if $(FROM),,$(WASM_REFERENCES)) \
		$(call wasm_of,$(TO_PROCESS) $(DRAWING) $(REPORTING) $(B)/tests/judge/judge.o) \
		$(patsubst %,$(WASM)/$(INSTEAD)/%.o,check no_processes) $(WASM)/common.a
	$(wasm_link)

# The program that makes a verdict of what the judge has found.
BOOK_COURSE := $(BOOK)/programs/course.wasm
$(BOOK_COURSE): $(call wasm_of,$(B)/tests/course/course.o $(COURSE_PARTS)) \
		$(WASM)/$(INSTEAD)/no_processes.o $(WASM)/common.a
	$(wasm_link)

# What an answer is linked with: one object for each chapter, and common.a. The reference for the chapters before is in
# it, except FROM=handout: there the student's answers are linked too (tools.js).
ANSWERING_LINKS := $(STEMS:%=$(WASM)/link/%.o)
WASM_WRAPS := $(STEMS:%=$(WASM)/wraps/%.o)
WASM_DISPATCHES := $(STEMS:%=$(WASM)/dispatch/%.o)
define wasm_for_chapter
	$(Q)mkdir -p $(@D)
	$(Q)$(WASM_COMPILE) -DANSWERED=$(call answered,$(*F)) -o $@ $<
endef
$(WASM_WRAPS): WASM_EXTRA = $(if $(FROM),-DEARLIER_ANSWERS)
$(WASM_WRAPS): $(WASM)/wraps/%.o: $(INSTEAD)/calls_traced.c .make/toolkit/book.mk
	$(wasm_for_chapter)
$(WASM_DISPATCHES): $(WASM)/dispatch/%.o: tests/judge/dispatch.c .make/toolkit/book.mk
	$(wasm_for_chapter)
$(ANSWERING_LINKS): $(WASM)/link/%.o: $(WASM)/wraps/%.o $(WASM)/dispatch/%.o $(call wasm_of,$(CALLING) $(if $(FROM),,$(lent))) \
		$(patsubst %,$(WASM)/%.o,$(INSTEAD)/answering $(INSTEAD)/steps tests/judge/answer_calls) \
		$$(if $$(FROM),,$$(call wasm_objects,$$(foreach s,$$(call earlier,$$*),$$(call exact_of,$$(s)))))
	$(call say,wasm,$@)
	$(Q)mkdir -p $(@D)
	$(Q)wasm-ld -r -o $@ $^
# The names that an answer's link wraps (calls_traced.c), for each chapter. FROM=handout: those of the answers before it too,
# because a verdict tells which of them it depends on.
$(STEMS:%=$(WASM)/names/%): $(WASM)/names/%: $$(addprefix $(B)/answer_names/,$$(if $$(FROM),$$(call earlier,$$*)) $$*) \
		.make/toolkit/book.mk
	$(Q)mkdir -p $(@D)
	$(Q)sed 's/ .*//' $(filter-out %.mk,$^) > $@

# What the pictures of an answer are linked with, an object each: what draws them, the chapters' programs, the
# reference as answer_NAME, and for each exercise one that puts this in the place of NAME.
PICTURE_LINKS := $(WASM)/link/drawing.o $(BOOK_STEMS:%=$(WASM)/link/%-program.o) $(if $(FROM),,$(BOOK_STEMS:%=$(WASM)/link/%-right.o))
WASM_DRAW := $(WASM)/tests/course/pictures/draw.o
$(WASM_DRAW): WASM_EXTRA = -include $(B)/weak.h
$(WASM_DRAW): $(B)/weak.h
$(WASM)/link/drawing.o: $(WASM_DRAW) $(WASM)/$(INSTEAD)/steps.o
$(BOOK_STEMS:%=$(WASM)/link/%-program.o): $(WASM)/link/%-program.o: $$(call wasm_program,$$*) $(WASM)/$(INSTEAD)/steps.o
$(WASM)/link/drawing.o $(BOOK_STEMS:%=$(WASM)/link/%-program.o):
	$(call say,wasm,$@)
	$(Q)mkdir -p $(@D)
	$(Q)wasm-ld -r -o $@ $^
$(BOOK_STEMS:%=$(WASM)/right/%.h): $(WASM)/right/%.h: tests/judge/names.def tests/exercises.def
	$(Q)mkdir -p $(@D)
	$(Q)$(call renamed,$(call answered,$*),answer_) > $@
$(BOOK_STEMS:%=$(WASM)/link/%-right.o): $(WASM)/link/%-right.o: $$(call exact_of,$$*) $(WASM)/right/%.h
	$(call say,wasm,$@)
	$(Q)mkdir -p $(@D)
	$(Q)$(WASM_COMPILE) -MF $(WASM)/right/$*.d -include $(WASM)/right/$*.h -o $@ $<
REFERENCE_LINKS := $(WASM)/link/reference
$(REFERENCE_LINKS)/made: $(INSTEAD)/reference_instead.c tests/exercises.def $(foreach s,$(BOOK_STEMS),$(WASM)/names/$(s))
	$(call say,wasm,$(@D))
	$(Q)mkdir -p $(@D)
	$(Q)for name in $$(cat $(filter $(WASM)/names/%,$^)); do \
		$(WASM_CC) $(WASM_LANGUAGE) -DWANTED_$$name='~, ~' -Os -c -o $(@D)/$$name.o $< || exit 1; done
	$(Q)touch $@
# The colours that the pictures of the first chapters are given: a picture that page programs can read.
BOOK_SPHERES := build/wasm/link/spheres.png
ifneq ($(FROM),)
$(BOOK_SPHERES): FORCE
	@$(MAKE) FROM= $@
else
$(BOOK_SPHERES): $(SPHERES) $(BOOK)/programs/07-shading.wasm chapters/book/run_program.mjs
	$(call say,record,$@)
	$(Q)mkdir -p $(@D)
	$(Q)node chapters/book/run_program.mjs $(BOOK)/programs/07-shading.wasm -o $@ $<
endif

# All of that in one file, which is fetched when the first picture is drawn. Paths as in the plan.
BOOK_PICTURES := $(BOOK)/pictures.pack.gz
$(BOOK_PICTURES): $(PICTURE_LINKS) $(if $(FROM),,$(REFERENCE_LINKS)/made) $(BOOK_SPHERES) $(WASM)/shared.a $(SPHERES) $(wildcard chapters/[0-9]*/*.nff)
	$(call say,pack,$@)
	$(Q)node chapters/book/compiler/write_pack.js $(WASM)/pictures.pack chapters/book/compiler/flags.json \
		$(if $(FROM),,$$(for f in $(REFERENCE_LINKS)/*.o; do echo link/reference/$${f##*/}=$$f; done)) $(foreach f,$(PICTURE_LINKS) $(BOOK_SPHERES) $(WASM)/shared.a,link/$(notdir $(f))=$(f)) \
		$(foreach f,$(filter %.nff,$^),$(f)=$(f))
	$(Q)gzip -9nc $(WASM)/pictures.pack > $@

# How course judges in a page: its commands are the page's (judge.js), its paths those of the terminal.
BOOK_PLAN := $(BOOK)/tree/plan
$(BOOK_PLAN): .make/toolkit/book.mk
	$(Q)mkdir -p $(@D)
	$(Q)printf '%s\n' 'answers	exercises' 'built	build/exercises' 'draw	draw --one' 'compile	compile' 'link	link' \
		$(if $(FROM),'hide	hide','lend	--lend=NAME' 'reference	link/reference/NAME.o') \
		'drawing	link/drawing.o' 'spheres	$(SPHERES) link/spheres.png' 'judge	judge' 'libraries	link/common.a' \
		$(foreach s,$(STEMS),'chapter	$(s)' 'objects	link/$(s).o$(if $(FROM),$(foreach e,$(call earlier,$(s)), build/exercises/verdict/$(e)/answer.o))' \
			$(if $(FROM),'stands on	$(call earlier,$(s))') $(if $(filter $(s),$(BOOK_STEMS)),$(if $(FROM),,'right	link/$(s)-right.o') \
			'program	link/$(s)-program.o link/shared.a')) > $@

book-programs: $(BOOK_PROGRAMS)
book-judge: $(BOOK_JUDGE) $(BOOK_COURSE) $(ANSWERING_LINKS) $(WASM)/common.a $(STEMS:%=$(WASM)/names/%) $(BOOK_PLAN) \
	$(BOOK_PICTURES)
.PHONY: book-programs book-judge

include .make/toolkit/book_page.mk
include .make/toolkit/book_figures.mk
include .make/toolkit/book_compiler.mk

# The rules of the other programs do not need these.
-include $(if $(JUDGES_ONLY),,$(shell find $(WASM) -name '*.d' 2>/dev/null))
