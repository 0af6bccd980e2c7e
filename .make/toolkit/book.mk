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
	-isystem $(WASM)/include -include $(INSTEAD)/system.h \
	-ffunction-sections -fdata-sections $(foreach e,SIGNAL MMAN PROCESS_CLOCKS GETPID,-D_WASI_EMULATED_$(e))
WASM_OPTIMIZE = -O2
WASM_COMPILE = $(WASM_CC) $(WASM_LANGUAGE) $(WASM_OPTIMIZE) $(STRICT) $(WERROR) $(WASM_EXTRA) -MMD -MP -c
# The stack grows down to address 0, so that a program whose stack overflows is stopped.
WASM_LINK = $(WASM_CC) -Wl,--gc-sections -Wl,--strip-debug -Wl,--stack-first -Wl,-z,stack-size=1048576
WASM_LIBS := $(WASM_EMULATED:%=-lwasi-emulated-%) -lm

# Puts files into one.
WRITE_PACK := chapters/book/site/write_pack.mjs

# For the objects of a list of sources: the stand-in if there is one.
instead_of = $(or $(wildcard $(INSTEAD)/$(notdir $(1))),$(1))
wasm_objects = $(foreach source,$(1),$(patsubst %.c,$(WASM)/%.o,$(call instead_of,$(source))))
wasm-is-here:
	@echo 'int main(void) { return 0; }' | $(WASM_CC) -x c -o /dev/null - 2>/dev/null || \
		{ echo "make book needs clang and a C library for WebAssembly: 'make setup FOR=book' installs them" >&2; exit 1; }
.PHONY: wasm-is-here
# Headers that the C library lacks are empty: what is used of them is in system.h.
LACKING := $(addprefix $(WASM)/include/,pthread.h sys/ioctl.h sys/wait.h)
$(LACKING):
	$(Q)mkdir -p $(@D) && touch $@
$(WASM)/%.o: %.c .make/toolkit/book.mk | wasm-is-here $(LACKING)
	$(call say,wasm,$<)
	$(Q)mkdir -p $(@D)
	$(Q)$(WASM_COMPILE) -o $@ $<

# Linked before the C library, so what system.c has is ours.
$(WASM)/common.a: $(call wasm_objects,$(filter-out %/toolkit_file.c %/whole_file.c,$(wildcard common/*.c common/figure/*.c)) $(INSTEAD)/system.c)
$(WASM)/shared.a: $(call wasm_objects,$(wildcard chapters/shared/*.c))
$(WASM)/common.a $(WASM)/shared.a:
	$(Q)rm -f $@ && llvm-ar rcsD $@ $^

# The chapters' programs, with the reference's answers: figures, and pictures, but for chapter 08, whose engines are
# about threads.
BOOK_STEMS := $(filter-out 08-%,$(STEMS))
BOOK_PROGRAMS := $(if $(FROM),,$(STEMS:%=$(BOOK)/programs/%.wasm))
wasm_program = $(call wasm_objects,$(filter-out %_nff.c chapters/08-fast/engines/%,$(wildcard chapters/$(1)/*.c chapters/$(1)/*/*.c)))
$(STEMS:%=$(BOOK)/programs/%.wasm): $(BOOK)/programs/%.wasm: $$(call wasm_program,$$*) $(call wasm_objects,$(foreach s,$(STEMS),$(call exact_of,$(s)))) \
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
		$(WASM)/$(INSTEAD)/check.o $(WASM)/common.a
	$(wasm_link)

# The program that makes a verdict of what the judge has found.
BOOK_COURSE := $(BOOK)/programs/course.wasm
$(BOOK_COURSE): $(call wasm_of,$(B)/tests/course/course.o $(COURSE_PARTS)) $(WASM)/common.a
	$(wasm_link)

# What an answer is linked with: one object for each chapter, and common.a. The reference for the chapters before is in
# it, except FROM=handout: there the student's answers are linked too (tools.js).
ANSWERING_LINKS := $(STEMS:%=$(WASM)/link/%.o)
WASM_ANSWERING := $(STEMS:%=$(WASM)/answering/%.o)
WASM_DISPATCHES := $(STEMS:%=$(WASM)/dispatch/%.o)
define wasm_for_chapter
	$(Q)mkdir -p $(@D)
	$(Q)$(WASM_COMPILE) -DANSWERED=$(call answered,$(*F)) -o $@ $<
endef
$(WASM_ANSWERING): WASM_EXTRA = $(if $(FROM),-DEARLIER_ANSWERS)
$(WASM_ANSWERING): $(WASM)/answering/%.o: $(INSTEAD)/answering.c .make/toolkit/book.mk
	$(wasm_for_chapter)
$(WASM_DISPATCHES): $(WASM)/dispatch/%.o: tests/judge/dispatch.c .make/toolkit/book.mk
	$(wasm_for_chapter)
$(ANSWERING_LINKS): $(WASM)/link/%.o: $(WASM)/answering/%.o $(WASM)/dispatch/%.o $(call wasm_of,$(CALLING) $(if $(FROM),,$(lent))) \
		$(patsubst %,$(WASM)/%.o,$(INSTEAD)/steps tests/judge/answer_calls) \
		$$(if $$(FROM),,$$(call wasm_objects,$$(foreach s,$$(call earlier,$$*),$$(call exact_of,$$(s)))))
	$(call say,wasm,$@)
	$(Q)mkdir -p $(@D)
	$(Q)wasm-ld -r -o $@ $^
# The names that an answer's link wraps (answering.c), for each chapter. FROM=handout: those of the answers before it too,
# because a verdict tells which of them it depends on.
$(STEMS:%=$(WASM)/names/%): $(WASM)/names/%: $$(addprefix $(B)/answer_names/,$$(if $$(FROM),$$(call earlier,$$*)) $$*) \
		.make/toolkit/book.mk
	$(Q)mkdir -p $(@D)
	$(Q)sed 's/ .*//' $(filter-out %.mk,$^) > $@

# What casts in a page, tile by tile: with the reference's answers; and as an object, for those of a student.
CASTING := $(call wasm_objects,chapters/book/cast/cast.c $(wildcard chapters/08-fast/engines/*.c) \
	chapters/06-ray-casting/explain.c chapters/06-ray-casting/figures/shown.c chapters/07-shading/explain_light.c)
# Vectors of 16 bytes: every browser since 2023 has them, and a picture takes half the time.
$(filter %_lanes.o,$(CASTING)): WASM_EXTRA = $(FOR_LANES) -ffp-contract=off -msimd128
CASTING_LINK := $(WASM)/link/cast.o
BOOK_CASTING := $(if $(FROM),,$(BOOK)/programs/cast.wasm)
$(BOOK)/programs/cast.wasm: $(CASTING) $(call wasm_objects,$(foreach s,$(STEMS),$(call exact_of,$(s)))) $(WASM)/shared.a $(WASM)/common.a
	$(call say,wasm,$@)
	$(Q)mkdir -p $(@D)
	$(Q)$(WASM_LINK) -mexec-model=reactor -Wl,--strip-all -o $@ $^ $(WASM_LIBS)

# The gallery of mistakes: a scene cast with any of them, and its questions, which nobody should read by chance.
BOOK_MISTAKES := $(if $(FROM),,$(BOOK)/programs/mistaken.wasm $(BOOK)/mistakes.json.gz)
$(call wasm_of,$(call known,wrong)): WASM_EXTRA = $(AS_KNOWN)
$(call wasm_of,$(call known,wrong)): $(B)/reference.h
$(call wasm_of,$(call known,wrong)): WASM_OPTIMIZE = -Os
WASM_SWITCHED := $(STEMS:%=$(WASM)/tests/switched/%.o)
$(WASM_SWITCHED): $(WASM)/tests/switched/%.o: tests/proof/switched.c solutions/%.c $(B)/weak.h
	$(Q)mkdir -p $(@D)
	$(Q)$(WASM_COMPILE) -DANSWERED=$(call answered,$*) -include $(B)/weak.h -include solutions/$*.c -o $@ $<
$(BOOK)/programs/mistaken.wasm: $(WASM)/chapters/book/cast/mistaken.o $(CASTING) $(WASM_SWITCHED) \
		$(call wasm_of,$(call known,wrong) $(B)/tests/judge/known.o $(CALLING)) $(WASM)/shared.a $(WASM)/common.a
	$(call say,wasm,$@)
	$(Q)mkdir -p $(@D)
	$(Q)$(WASM_LINK) -mexec-model=reactor -Wl,--strip-all -o $@ $^ $(WASM_LIBS)
$(BOOK)/mistakes.json.gz: chapters/mistakes/questions.txt chapters/mistakes/show_mistakes.py $(call known,wrong) | $(B)/tests/mistaken/06-ray-casting
	$(Q)mkdir -p $(@D) $(WASM)
	$(Q)$(SHOW_MISTAKES) gallery $(B) > $(WASM)/mistakes.json && gzip -9nc $(WASM)/mistakes.json > $@

# What the pictures of an answer are linked with, an object each: what draws them, the chapters' programs, the
# reference as answer_NAME, and for each exercise one that puts this in the place of NAME.
PICTURE_LINKS := $(WASM)/link/drawing.o $(BOOK_STEMS:%=$(WASM)/link/%-program.o) $(if $(FROM),,$(STEMS:%=$(WASM)/link/%-right.o) $(CASTING_LINK))
WASM_DRAW := $(WASM)/tests/course/pictures/draw.o
$(WASM_DRAW): WASM_EXTRA = -include $(B)/weak.h
$(WASM_DRAW): $(B)/weak.h
$(WASM)/link/drawing.o: $(WASM_DRAW) $(WASM)/$(INSTEAD)/steps.o
$(BOOK_STEMS:%=$(WASM)/link/%-program.o): $(WASM)/link/%-program.o: $$(call wasm_program,$$*) $(WASM)/$(INSTEAD)/steps.o
$(CASTING_LINK): $(CASTING)
# The linker of the page would need the whole compiler to read that an object has vectors.
$(WASM)/link/drawing.o $(CASTING_LINK) $(BOOK_STEMS:%=$(WASM)/link/%-program.o):
	$(call say,wasm,$@)
	$(Q)mkdir -p $(@D)
	$(Q)wasm-ld -r -o $@ $^
	$(Q)llvm-objcopy --remove-section=target_features $@
# Only definitions are renamed: the reference calls the functions of a student, also those of its own chapter.
$(STEMS:%=$(WASM)/right/%.c): $(WASM)/right/%.c: $$(call exact_of,$$*) $(WASM)/names/%
	$(Q)mkdir -p $(@D)
	$(Q)sed -E "s/^([A-Za-z].*[ *])($$(paste -sd'|' $(WASM)/names/$*))\(/\1answer_\2(/" $< > $@
$(STEMS:%=$(WASM)/link/%-right.o): $(WASM)/link/%-right.o: $(WASM)/right/%.c
	$(call say,wasm,$@)
	$(Q)mkdir -p $(@D)
	$(Q)$(WASM_COMPILE) -Wno-missing-prototypes -o $@ $<
REFERENCE_LINKS := $(WASM)/link/reference
$(REFERENCE_LINKS)/made: $(INSTEAD)/reference_instead.c tests/exercises.def $(foreach s,$(STEMS),$(WASM)/names/$(s))
	$(call say,wasm,$(@D))
	$(Q)mkdir -p $(@D)
	$(Q)for name in $$(cat $(filter $(WASM)/names/%,$^)); do \
		$(WASM_CC) $(WASM_LANGUAGE) -DWANTED_$$name='~, ~' -Os -c -o $(@D)/$$name.o $< || exit 1; done
	$(Q)touch $@
# The colors that the pictures of the first chapters are given: a picture that page programs can read.
BOOK_SPHERES := build/wasm/link/spheres.png
ifneq ($(FROM),)
$(BOOK_SPHERES): FORCE
	@$(MAKE) FROM= $@
else
$(BOOK_SPHERES): $(SPHERES) $(BOOK)/programs/07-shading.wasm chapters/book/run_program.mjs
	$(call say,record,$@)
	$(Q)mkdir -p $(@D)
	$(Q)node chapters/book/run_program.mjs $(BOOK)/programs/07-shading.wasm -o $@ $< && touch $@
endif

# All of that in one file, which is fetched when the first picture is drawn. Paths as in the plan.
BOOK_PICTURES := $(BOOK)/pictures.pack.gz
$(BOOK_PICTURES): $(PICTURE_LINKS) $(if $(FROM),,$(REFERENCE_LINKS)/made) $(BOOK_SPHERES) $(WASM)/shared.a $(SPHERES) $(wildcard chapters/[0-9]*/*.nff)
	$(call say,pack,$@)
	$(Q)node $(WRITE_PACK) $(WASM)/pictures.pack \
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

book-programs: $(BOOK_PROGRAMS) $(BOOK_CASTING)
book-judge: $(BOOK_JUDGE) $(BOOK_COURSE) $(ANSWERING_LINKS) $(WASM)/common.a $(STEMS:%=$(WASM)/names/%) $(BOOK_PLAN) \
	$(BOOK_PICTURES)
.PHONY: book-programs book-judge

# ---- the pages: lessons, exercises, figures, and the JavaScript that they load -------------------

# Packages of npm are fetched while the site is built, into build/npm; a page itself fetches nothing from elsewhere. Those
# that only tests need are added by the first of these.
BOOK_SOURCES := chapters/book
NPM := build/npm
BOOK_PACKAGES := $(NPM)/for-pages
BOOK_TEST_PACKAGES := $(NPM)/for-tests
fetch_packages = cd $(NPM) && npm $(1) --ignore-scripts --no-audit --no-fund --loglevel=error >npm.log || { cat npm.log >&2; exit 1; }
$(BOOK_PACKAGES): $(BOOK_SOURCES)/package.json $(BOOK_SOURCES)/package-lock.json
	@command -v npm >/dev/null || { echo "make book needs node and npm: 'make setup FOR=book' installs them" >&2; exit 1; }
	$(call say,fetch,packages of npm for the page)
	$(Q)mkdir -p $(NPM) && cp $^ $(NPM)/
	$(Q)$(call fetch_packages,ci --omit=dev)
	@ln -sfn ../../$(NPM)/node_modules $(BOOK_SOURCES)/node_modules
	@touch $@
$(BOOK_TEST_PACKAGES): $(BOOK_PACKAGES)
	$(call say,fetch,packages of npm for its tests)
	$(Q)$(call fetch_packages,install --no-save --include=dev)
	@touch $@

# HAND_IN=address: where a class hands in; the start page links to it.
HAND_IN ?=
# ADDRESS=address: where the site will be, for search engines and shared links.
ADDRESS ?=
BOOK_TOLD := $(WASM)/told
$(BOOK_TOLD): FORCE
	@mkdir -p $(@D); echo '$(HAND_IN) $(ADDRESS)' | cmp -s - $@ || echo '$(HAND_IN) $(ADDRESS)' > $@
# What a shared link shows.
$(BOOK)/share.png: chapters/07-shading/finale.png
	$(Q)mkdir -p $(@D) && cp $< $@
$(BOOK)/service_worker.js: $(BOOK)/share.png
BOOK_STAMP := $(BOOK)-pages
# FROM=handout: the pages are those of the handout.
BOOK_ROOT := $(if $(FROM),$(WASM)/ray-casting,.)
UNPACKED := $(WASM)/unpacked
$(UNPACKED): build/handout.tar.gz
	$(Q)mkdir -p $(@D) && rm -rf $(WASM)/ray-casting
	$(Q)tar xf $< -C $(@D) && tar xf $(@D)/ray-casting/tests/given.tar -C $(@D)/ray-casting
	@touch $@
BOOK_TEXTS := $(wildcard chapters/[0-9]*/README.md chapters/[0-9]*/*.png chapters/[0-9]*/*.svg exercises/*.[ch] exercises/*.hints \
	exercises/optional/README.md exercises/optional/pictures/*.png common/*.h)
BOOK_SCRIPTS := $(wildcard $(BOOK_SOURCES)/*.js $(BOOK_SOURCES)/*/*.js $(BOOK_SOURCES)/*/*.mjs $(BOOK_SOURCES)/page/*)
# The slides of the lecture: chapters/slides.txt, and each step of their figures. Films are those of 'make animations'.
BOOK_LECTURE := build/book-lecture.html
$(BOOK_LECTURE): $(SLIDE_SOURCES) chapters/slides/lecture_page.py $(call script_of,$(DRAWN_FIGURES),$(NARROW_FIGURES) $(WIDE_FIGURES)) $(DRAWN)
	@export FORMAT=svg THEME= STEPS=1; SHAPE=4:3 $(DRAW_FIGURES) $(DRAWN_FIGURES) $(NARROW_FIGURES) && \
		SHAPE=16:9 $(DRAW_FIGURES) $(DRAWN_FIGURES) $(WIDE_FIGURES)
	$(Q)$(PYTHON) chapters/slides/lecture_page.py $(SLIDES) $(LECTURE)/numbers.json $(DRAWN_FIGURES) $(QUESTIONS) > $@
$(BOOK_STAMP): $(if $(FROM),,$(BOOK_LECTURE))
$(BOOK_STAMP): $(BOOK_PACKAGES) $(BOOK_SCRIPTS) $(BOOK_TEXTS) $(LESSONS_MARKED) $(DRAWN) $(LIST) $(BOOK_TOLD) .make/toolkit/book.mk $(if $(FROM),$(UNPACKED))
	$(call say,pages,$(BOOK))
	$(Q)mkdir -p $(BOOK)
	$(Q)$(LIST) > build/book-exercises.txt
	$(Q)$(draw_lesson_steps)
	$(Q)node $(BOOK_SOURCES)/site/make_pages.mjs $(BOOK_ROOT) $(BOOK) build/book-exercises.txt $(if $(FROM),none,$(B)/lessons) \
		$(DRAWN_FIGURES) $(BOOK_LECTURE) $(BUILT)/animations '$(HAND_IN)' '$(ADDRESS)'
	@touch $@

# What course and judge read: headers for what the compiler says, hints, blanks, layouts.
BOOK_JUDGED := $(BOOK)/tree/files.json
$(BOOK_JUDGED): $(wildcard common/*.h exercises/*.h exercises/*.hints common/figure/*.gp tests/judge/layouts/*.gp \
		chapters/[0-9]*/figures/yours-and-right.gp) $(BLANKS) $(if $(FROM),$(B)/exercises.names) $(BOOK_PLAN) $(WRITE_PACK)
	$(Q)node $(WRITE_PACK) $@ $(filter-out %.mjs $(BOOK_PLAN),$^) plan=$(BOOK_PLAN)

BOOK_TABLES := $(STEMS:%=$(BOOK)/tables/%.table.gz)
$(BOOK_TABLES): $(BOOK)/tables/%.gz: $(if $(FROM),$(ARCHIVED),$(TABLE))/%
	$(Q)mkdir -p $(@D)
	$(Q)gzip -9nc $< > $@

# The list of files for the service worker is of all that is there, so it comes last.
$(BOOK)/service_worker.js: $(BOOK_STAMP) $(BOOK_PROGRAMS) $(BOOK_CASTING) $(BOOK_MISTAKES) $(BOOK_JUDGE) $(BOOK_COURSE) $(BOOK_JUDGED) $(BOOK_PICTURES) $(BOOK_TABLES) \
		$(BOOK)/compiler/sizes.json
	$(Q)node $(BOOK_SOURCES)/site/bundle.mjs $(BOOK)

book: $(BOOK)/service_worker.js ## the course as a site: build/book, for any static host (HAND_IN=address, ADDRESS=address, FROM=handout)
	@echo "The course is in $(BOOK): copy it to any static host."
.PHONY: book

# In Chromium and in Firefox, at the same time; BROWSERS=chromium: only that one; BROWSERS=webkit: WebKitGTK, a part of it.
BROWSERS ?= chromium firefox
browsers-are-here:
	@for browser in $(BROWSERS); do \
		case $$browser in chromium) names="$$CHROMIUM chromium chromium-browser google-chrome" ;; webkit) names=WebKitWebDriver ;; *) names="$$FIREFOX firefox-esr firefox" ;; esac; \
		found=; for name in $$names; do command -v $$name >/dev/null && found=yes; done; \
		[ -n "$$found" ] || { echo "check-book: $$browser is missing: 'make setup FOR=contributor' installs it" >&2; exit 1; }; done
.PHONY: browsers-are-here
ifeq ($(FROM),)
check-book: browsers-are-here book $(BOOK_TEST_PACKAGES) $(PAGE) $(call FOR_JUDGING,$(STEMS)) ##+ tests of the course in a page, with real browsers
	@node tests/proof/book/verdicts.mjs $(BOOK) .
	@for test in $(wildcard tests/proof/book/*.test.mjs); do node $$test || exit 1; done
	@running=; for browser in $(BROWSERS); do \
		case $$browser in webkit) tests=tests/proof/book/webkit.mjs ;; *) tests="$(wildcard tests/proof/book/browser/*.mjs)" ;; esac; \
		for test in $$tests; do BROWSER=$$browser node $$test $(BOOK) || exit 1; done & \
		running="$$running $$!"; \
	done; failed=0; for one in $$running; do wait $$one || failed=1; done; exit $$failed
else
# The verdicts are those of the handout in a terminal, and nothing of a solution is in any file.
check-book: browsers-are-here book $(BOOK_TEST_PACKAGES)
	@cd $(BOOK_ROOT) && MAKEFLAGS= $(MAKE) all >make.log 2>&1 || { cat make.log; exit 1; }
	@node tests/proof/book/handout.mjs $(BOOK) $(BOOK_ROOT) $(WASM)
	@node tests/proof/book/verdicts.mjs $(BOOK) $(BOOK_ROOT)
	@for browser in $(BROWSERS); do BROWSER=$$browser CHAPTERS=01 node tests/proof/book/browser/student.mjs $(BOOK) || exit 1; done
endif
.PHONY: check-book

bench-book: book $(BOOK_TEST_PACKAGES) ##+ the course in a page, measured: times, frames a second (BROWSER=firefox, MBIT=10)
	@node tests/benches/book.mjs $(BOOK) $(or $(MBIT),10)
.PHONY: bench-book

# ---- what the live figures need, besides the chapters' programs ----------------------------------

# gnuplot, and the layouts and scenes that the programs read. Compressed by xz, as the compiler is.
BOOK_GNUPLOT := $(BOOK)/figures/gnuplot.wasm.xz
$(BOOK_GNUPLOT): $(BOOK_PACKAGES) .make/toolkit/book.mk
	$(Q)mkdir -p $(@D)
	$(Q)$(XZ) --lzma2=preset=9e,dict=2MiB $(NPM)/node_modules/gnuplot-wasm/src/gnuplot.wasm > $@
BOOK_LAYOUTS := $(BOOK)/figures/files.json
$(BOOK_LAYOUTS): $(wildcard common/figure/*.gp chapters/[0-9]*/*.nff chapters/[0-9]*/figures/*.gp \
		chapters/[0-9]*/figures/*.nff) $(WRITE_PACK)
	$(Q)mkdir -p $(@D)
	$(Q)node $(WRITE_PACK) $@ $(filter-out %.mjs,$^)

# The numbers in the lessons, for the example that a figure shows.
LESSON_NUMBERS := $(BOOK)/programs/numbers.wasm
$(LESSON_NUMBERS): $(NUMBERS_OBJECTS:$(B)/%=$(WASM)/%) \
		$(call wasm_objects,$(foreach s,$(BOOK_STEMS),$(call exact_of,$(s)))) $(WASM)/shared.a $(WASM)/common.a
	$(call say,wasm,$@)
	$(Q)mkdir -p $(@D)
	$(Q)$(WASM_LINK) -Wl,--strip-all -o $@ $^ $(WASM_LIBS)

# The scenes that pages cast: the first is on the start page.
BOOK_SCENES := $(if $(FROM),,$(patsubst %,$(BOOK)/scenes/%.nff.gz,finale three-spheres sphereflake-91 sphereflake-820 sunflower))
$(BOOK)/scenes/three-spheres.nff.gz: chapters/06-ray-casting/three-spheres.nff
$(filter-out %/three-spheres.nff.gz,$(BOOK_SCENES)): $(BOOK)/scenes/%.gz: $(B)/scenes/%
$(BOOK_SCENES):
	$(Q)mkdir -p $(@D)
	$(Q)gzip -9nc $< > $@
$(BOOK)/service_worker.js: $(BOOK_SCENES)

BOOK_FIGURES := $(BOOK_GNUPLOT) $(BOOK_LAYOUTS) $(if $(FROM),,$(LESSON_NUMBERS))
$(BOOK)/service_worker.js: $(BOOK_FIGURES)

# ---- the compiler of the page: clang of npm's @yowasp/clang, cut down, and headers and libraries ---

# All is compressed with xz, which leaves less than gzip, and no host has to do anything for it (compiler.js).
COMPILER := chapters/book/compiler
CLANG_OF_NPM := $(NPM)/node_modules/@yowasp/clang/gen
WASM_COMPILER := $(WASM)/compiler
BOOK_COMPILER := $(BOOK)/compiler
COMPRESSED := small.wasm.xz whole.wasm.xz pack.xz

CUT := $(addprefix $(COMPILER)/,cut.js)
$(WASM_COMPILER)/whole.wasm: KEPT :=
$(WASM_COMPILER)/small.wasm: KEPT := $(COMPILER)/kept.txt
$(WASM_COMPILER)/small.wasm: $(COMPILER)/kept.txt
$(WASM_COMPILER)/whole.wasm $(WASM_COMPILER)/small.wasm: $(CUT) $(BOOK_PACKAGES)
	$(call say,cut,$@)
	$(Q)mkdir -p $(@D)
	$(Q)node $< $(CLANG_OF_NPM)/llvm.core.wasm $@ $(KEPT)

# The compiler's own headers, those for C on any processor; Debian's for the C library, with Debian's library.
$(WASM_COMPILER)/include/stddef.h: $(BOOK_PACKAGES)
	$(Q)mkdir -p $(WASM_COMPILER)
	$(Q)tar xf $(CLANG_OF_NPM)/llvm-resources.tar -C $(WASM_COMPILER) --wildcards --no-wildcards-match-slash -m \
		$(foreach name,__std* __float* float iso646 limits stdalign stdarg stdatomic stdbool std[cdin]* tgmath inttypes,'include/$(name).h')
WASM_LIBC = $(eval WASM_LIBC := $$(shell $(WASM_CC) -print-file-name=libc.a))$(WASM_LIBC)
WASM_LIBRARIES := libm.a crt1-command.o crt1-reactor.o $(WASM_EMULATED:%=libwasi-emulated-%.a)
# The two large ones, without what only a debugger reads; and without the C library's tables of character sets, ciphers and
# patterns, which would be half of what is fetched of it. Their headers are left out as well, so the compiler says so.
NOT_PACKED := iconv.o crypt_des.o crypt_blowfish.o crypt_sha512.o crypt_sha256.o crypt_md5.o regcomp.o regexec.o glob.o
STRIPPED := $(WASM_COMPILER)/lib/libc.a $(WASM_COMPILER)/lib/builtins.a
$(STRIPPED): $(COMPILER)/strip_archive.mjs
	$(call say,strip,$@)
	$(Q)node $< $(if $(filter %/libc.a,$@),$(WASM_LIBC),$$($(WASM_CC) -print-libgcc-file-name)) $@ $(NOT_PACKED)
PACKED = weak.h=$(B)/weak.h common/=common exercises/=exercises include/=$(subst /lib/,/include/,$(dir $(WASM_LIBC))) \
	$(foreach name,iconv crypt regex glob,-include/$(name).h) \
	clang/include/=$(WASM_COMPILER)/include \
	$(foreach name,$(WASM_LIBRARIES),lib/$(name)=$(dir $(WASM_LIBC))$(name)) \
	$(foreach library,$(STRIPPED),lib/$(notdir $(library))=$(library)) \
	$(foreach o,$(ANSWERING_LINKS),link/$(notdir $(o))=$(o) names/$(basename $(notdir $(o)))=$(WASM)/names/$(basename $(notdir $(o)))) \
	$(if $(ANSWERING_LINKS),lib/common.a=$(WASM)/common.a)
$(WASM_COMPILER)/pack: $(WRITE_PACK) $(WASM_COMPILER)/include/stddef.h $(STRIPPED) \
		$(B)/weak.h $(wildcard common/*.h exercises/*.h) $(ANSWERING_LINKS) $(if $(ANSWERING_LINKS),$(STEMS:%=$(WASM)/names/%) $(WASM)/common.a)
	$(call say,pack,headers and libraries)
	$(Q)node $< $@ $(PACKED)

# xz-decompress knows no other check. The small one is fetched by each student, so it is packed as well as can be; the whole
# one hardly ever: 3 % larger in two thirds of the time.
XZ := xz --check=crc32 --threads=1 --stdout
$(BOOK_COMPILER)/small.wasm.xz: XZ_HOW := --lzma2=preset=8,dict=8MiB
$(BOOK_COMPILER)/whole.wasm.xz: XZ_HOW := --lzma2=preset=1,dict=8MiB,depth=3
$(BOOK_COMPILER)/pack.xz: XZ_HOW := --lzma2=preset=9e,dict=4MiB
$(COMPRESSED:%=$(BOOK_COMPILER)/%): $(BOOK_COMPILER)/%.xz: $(WASM_COMPILER)/% .make/toolkit/book.mk
	$(call say,compress,$@)
	$(Q)mkdir -p $(@D)
	$(Q)$(XZ) $(XZ_HOW) $< > $@
$(BOOK_COMPILER)/sizes.json: $(COMPRESSED:%=$(BOOK_COMPILER)/%)
	@{ printf '{'; cd $(BOOK) && for file in $(COMPRESSED:%=compiler/%); do \
		printf '"%s": %d, ' $$file $$(wc -c < $$file); done; printf '"of": "bytes"}\n'; } > $@
book-compiler: $(BOOK_COMPILER)/sizes.json
.PHONY: book-compiler

# The list of what a cut compiler keeps: what a training enters is added to it, and after another version of
# @yowasp/clang it begins anew. Wants binaryen, and takes long.
TRAINED := $(wildcard solutions/0[1-7]*.c exercises/0[1-7]*.c solutions/optional/*.c \
	chapters/0*/*.c chapters/0*/*/*.c common/*.c common/figure/*.c tests/judge/*.c tests/course/*.c tests/explain/*.c)
SLIPS ?= 2000
book-train: $(WASM_COMPILER)/whole.wasm $(WASM_COMPILER)/pack $(BOOK_PICTURES)
	$(call say,train,clang)
	$(Q)node $(WRITE_PACK) $(WASM_COMPILER)/training $(PACKED) tests/=tests chapters/=chapters
	$(Q)wasm-split --instrument --profile-export=__write_profile -all $(WASM_COMPILER)/whole.wasm -o $(WASM_COMPILER)/noting.wasm
	$(Q)node $(COMPILER)/train.mjs $(WASM_COMPILER)/noting.wasm $(CLANG_OF_NPM)/llvm.core.wasm $(WASM_COMPILER)/training \
		$(WASM)/pictures.pack $(COMPILER)/kept.txt $(SLIPS) $(TRAINED) > $(WASM_COMPILER)/kept.new
	$(Q)mv $(WASM_COMPILER)/kept.new $(COMPILER)/kept.txt
.PHONY: book-train

# The rules of the other programs do not need these.
-include $(if $(JUDGES_ONLY),,$(shell find $(WASM) -name ray-casting -prune -o -name '*.d' -print 2>/dev/null))
