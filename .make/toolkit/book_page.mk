# book_page.mk - the pages of make book: lessons, exercises, figures, and the JavaScript that they load. Included by
# book.mk.
#
# Packages of npm are fetched while the site is built, into build/npm; a page itself fetches nothing from elsewhere.
BOOK_SOURCES := chapters/book
NPM := build/npm
BOOK_PACKAGES := $(NPM)/node_modules/.package-lock.json
$(BOOK_PACKAGES): $(BOOK_SOURCES)/package.json $(BOOK_SOURCES)/package-lock.json
	@command -v npm >/dev/null || { echo "make book needs node and npm: 'make setup FOR=book' installs them" >&2; exit 1; }
	$(call say,fetch,packages of npm for the page)
	$(Q)mkdir -p $(NPM) && cp $^ $(NPM)/
	$(Q)cd $(NPM) && npm ci --ignore-scripts --no-audit --no-fund --loglevel=error >npm.log || { cat npm.log >&2; exit 1; }
	@ln -sfn ../../$(NPM)/node_modules $(BOOK_SOURCES)/node_modules
	@touch $@

# HAND_IN=address: where a class hands in; the start page links to it.
HAND_IN ?=
BOOK_STAMP := $(BOOK)-pages
# FROM=handout: the pages are those of the handout.
BOOK_ROOT := $(if $(FROM),$(WASM)/ray-casting,.)
UNPACKED := $(WASM)/unpacked
$(UNPACKED): build/handout.tar.gz
	$(Q)mkdir -p $(@D) && rm -rf $(WASM)/ray-casting
	$(Q)tar xf $< -C $(@D)
	@touch $@
BOOK_TEXTS := $(wildcard chapters/[0-9]*/README.md chapters/[0-9]*/*.png chapters/[0-9]*/*.svg exercises/*.[ch] exercises/*.hints \
	exercises/optional/README.md exercises/optional/pictures/*.png common/*.h)
BOOK_SCRIPTS := $(wildcard $(BOOK_SOURCES)/*.js $(BOOK_SOURCES)/*/*.js $(BOOK_SOURCES)/*/*.mjs $(BOOK_SOURCES)/page/*)
$(BOOK_STAMP): $(BOOK_PACKAGES) $(BOOK_SCRIPTS) $(BOOK_TEXTS) $(LESSONS_MARKED) $(DRAWN) $(LIST) .make/toolkit/book_page.mk $(if $(FROM),$(UNPACKED))
	$(call say,pages,$(BOOK))
	$(Q)mkdir -p $(BOOK)
	$(Q)$(LIST) > build/book-exercises.txt
	$(Q)$(draw_lesson_steps)
	$(Q)node $(BOOK_SOURCES)/site/make_pages.mjs $(BOOK_ROOT) $(BOOK) build/book-exercises.txt $(if $(FROM),none,$(B)/lessons) \
		$(DRAWN_FIGURES) '$(HAND_IN)'
	@touch $@

# What course and judge read: headers for what the compiler says, hints, blanks, layouts.
BOOK_JUDGED := $(BOOK)/tree/files.json
$(BOOK_JUDGED): $(wildcard common/*.h exercises/*.h exercises/*.hints common/figure/*.gp tests/judge/layouts/*.gp \
		chapters/[0-9]*/figures/yours-and-right.gp) $(BLANKS) $(if $(FROM),$(B)/exercises.names) $(BOOK_PLAN) $(BOOK_SOURCES)/site/pack_texts.mjs
	$(Q)node $(BOOK_SOURCES)/site/pack_texts.mjs $(filter-out %.mjs $(BOOK_PLAN),$^) plan=$(BOOK_PLAN) > $@

BOOK_TABLES := $(STEMS:%=$(BOOK)/tables/%.table.gz)
$(BOOK_TABLES): $(BOOK)/tables/%.gz: $(if $(FROM),$(ARCHIVED),$(TABLE))/%
	$(Q)mkdir -p $(@D)
	$(Q)gzip -9nc $< > $@

# The list of files for the service worker is of all that is there, so it comes last.
$(BOOK)/service_worker.js: $(BOOK_STAMP) $(BOOK_PROGRAMS) $(BOOK_JUDGE) $(BOOK_COURSE) $(BOOK_JUDGED) $(BOOK_PICTURES) $(BOOK_TABLES) \
		$(BOOK)/compiler/sizes.json
	$(Q)node $(BOOK_SOURCES)/site/bundle.mjs $(BOOK)

book: $(BOOK)/service_worker.js ## the course as a site: build/book, for any static host (HAND_IN=address, FROM=handout)
	@echo "The course is in $(BOOK): copy it to any static host."
.PHONY: book

# In Chromium and in Firefox, at the same time; BROWSERS=chromium: only that one.
BROWSERS ?= chromium firefox
browsers-are-here:
	@! command -v node >/dev/null || node tests/proof/book/browsers.mjs $(BROWSERS)
.PHONY: browsers-are-here
ifeq ($(FROM),)
check-book: browsers-are-here book $(call FOR_JUDGING,$(STEMS)) ## tests of the course in a page, with real browsers
	@node tests/proof/book/verdicts.mjs $(BOOK) .
	@for test in $(wildcard tests/proof/book/*.test.mjs); do node $$test || exit 1; done
	@running=; for browser in $(BROWSERS); do \
		for test in $(wildcard tests/proof/book/browser/*.mjs); do BROWSER=$$browser node $$test $(BOOK) || exit 1; done & \
		running="$$running $$!"; \
	done; failed=0; for one in $$running; do wait $$one || failed=1; done; exit $$failed
else
# The verdicts are those of the handout in a terminal, and nothing of a solution is in any file.
check-book: browsers-are-here book
	@cd $(BOOK_ROOT) && MAKEFLAGS= $(MAKE) all >make.log 2>&1 || { cat make.log; exit 1; }
	@node tests/proof/book/handout.mjs $(BOOK) $(BOOK_ROOT) $(WASM)
	@node tests/proof/book/verdicts.mjs $(BOOK) $(BOOK_ROOT)
	@for browser in $(BROWSERS); do BROWSER=$$browser node tests/proof/book/browser/drawn.mjs $(BOOK) || exit 1; done
endif
.PHONY: check-book
