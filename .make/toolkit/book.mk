# book.mk - the C side of make book: what a page runs, compiled to WebAssembly (chapters/book/README.md).
# Included by the Makefile.
#
# Debian's clang compiles the same sources as for the terminal. A file that cannot be compiled there (libpng,
# signals, processes) has one of the same name in chapters/book/instead/.
WASM_CC := clang --target=wasm32-wasi
WASM := build/wasm
BOOK := build/book
INSTEAD := chapters/book/instead
WASM_EMULATED := signal mman process-clocks getpid
WASM_LANGUAGE := -std=c11 -D_DEFAULT_SOURCE -ffp-contract=off -I. -O2 -ffunction-sections -fdata-sections \
	$(foreach e,SIGNAL MMAN PROCESS_CLOCKS GETPID,-D_WASI_EMULATED_$(e))
WASM_COMPILE = $(WASM_CC) $(WASM_LANGUAGE) $(STRICT) $(WERROR) $(WASM_EXTRA) -MMD -MP -c
# The stack grows down to address 0, so that a program whose stack overflows is stopped.
WASM_LINK = $(WASM_CC) -Wl,--gc-sections -Wl,--strip-debug -Wl,--stack-first -Wl,-z,stack-size=1048576
WASM_LIBS := $(WASM_EMULATED:%=-lwasi-emulated-%) -lm

# For the objects of a list of sources: the stand-in if there is one.
instead_of = $(or $(wildcard $(INSTEAD)/$(notdir $(1))),$(1))
wasm_objects = $(foreach source,$(1),$(patsubst %.c,$(WASM)/%.o,$(call instead_of,$(source))))
$(WASM)/%.o: %.c .make/toolkit/book.mk
	$(call say,wasm,$<)
	$(Q)mkdir -p $(@D)
	$(Q)$(WASM_COMPILE) -o $@ $<

$(WASM)/common.a: $(call wasm_objects,$(wildcard common/*.c common/figure/*.c))
$(WASM)/shared.a: $(call wasm_objects,$(wildcard chapters/shared/*.c))
$(WASM)/common.a $(WASM)/shared.a:
	$(Q)rm -f $@ && llvm-ar rcsD $@ $^

# The chapters' programs, with the reference's answers: figures and pictures. Chapter 08 is about threads.
BOOK_STEMS := $(filter-out 08-%,$(STEMS))
BOOK_PROGRAMS := $(BOOK_STEMS:%=$(BOOK)/programs/%.wasm)
wasm_program = $(call wasm_objects,$(filter-out %_nff.c,$(wildcard chapters/$(1)/*.c chapters/$(1)/*/*.c)))
$(BOOK_PROGRAMS): $(BOOK)/programs/%.wasm: $$(call wasm_program,$$*) $(call wasm_objects,$(BOOK_STEMS:%=solutions/%.c)) \
		$(WASM)/shared.a $(WASM)/common.a
	$(call say,wasm,$@)
	$(Q)mkdir -p $(@D)
	$(Q)$(WASM_LINK) -Wl,--strip-all -o $@ $^ $(WASM_LIBS)

book-programs: $(BOOK_PROGRAMS)
.PHONY: book-programs

include .make/toolkit/book_page.mk

# The rules of the other programs do not need these.
-include $(if $(JUDGES_ONLY),,$(shell find $(WASM) -name '*.d' 2>/dev/null))
