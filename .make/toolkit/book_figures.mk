# book_figures.mk - what the live figures of make book need, besides the chapters' programs. Included by book.mk.

# gnuplot, and the layouts and scenes that the programs read. Compressed by xz, as the compiler is.
BOOK_GNUPLOT := $(BOOK)/figures/gnuplot.wasm.xz
$(BOOK_GNUPLOT): $(BOOK_PACKAGES) .make/toolkit/book_figures.mk
	$(Q)mkdir -p $(@D)
	$(Q)$(XZ) --lzma2=preset=9e,dict=2MiB $(NPM)/node_modules/gnuplot-wasm/src/gnuplot.wasm > $@
BOOK_LAYOUTS := $(BOOK)/figures/files.json
$(BOOK_LAYOUTS): $(wildcard common/figure/*.gp chapters/[0-9]*/*.nff chapters/[0-9]*/figures/*.gp \
		chapters/[0-9]*/figures/*.nff) $(BOOK_SOURCES)/site/pack_texts.mjs
	$(Q)mkdir -p $(@D)
	$(Q)node $(BOOK_SOURCES)/site/pack_texts.mjs $(filter-out %.mjs,$^) > $@

# The numbers in a lesson, for the example that a figure shows (instead/lesson_example.c).
LESSON_NUMBERS := $(LESSONS:%=$(BOOK)/programs/%-numbers.wasm)
wasm_parts = $(filter-out %/main.o,$(call wasm_program,$(1)))
EXAMPLE_WRAPS := $(foreach of,camera place point pixel ray sphere,-Wl,--wrap=example_$(of))
$(LESSON_NUMBERS): $(BOOK)/programs/%-numbers.wasm: $(WASM)/chapters/lessons/%.o $(WASM)/chapters/lessons/numbers.o \
		$(WASM)/$(INSTEAD)/lesson_example.o $$(call wasm_parts,$$*) \
		$(call wasm_objects,$(foreach s,$(BOOK_STEMS),$(call exact_of,$(s)))) $(WASM)/shared.a $(WASM)/common.a
	$(call say,wasm,$@)
	$(Q)mkdir -p $(@D)
	$(Q)$(WASM_LINK) -Wl,--strip-all $(EXAMPLE_WRAPS) -o $@ $^ $(WASM_LIBS)

BOOK_FIGURES := $(BOOK_GNUPLOT) $(BOOK_LAYOUTS) $(if $(FROM),,$(LESSON_NUMBERS))
$(BOOK)/service_worker.js: $(BOOK_FIGURES)
