# house.mk - make format, tidy, clean, help: the habits of the house. Included by the Makefile, last, so that
# 'make help' lists them last.
C_SOURCES = $(wildcard common/*.[ch] common/*/*.[ch] chapters/*/*.[ch] chapters/*/*/*.[ch] exercises/*.h solutions/*.c solutions/*/*.c) \
	$(filter-out tests/benches/embree% tests/grade/attacks/%,$(wildcard tests/*.[ch] \
	tests/*/*.[ch] tests/*/*/*.[ch]))
FORMATTED = $(C_SOURCES) $(wildcard tests/benches/embree*.c)
format: ##+ lay out the C sources (clang-format)
	@clang-format -i $(FORMATTED)

format-check: ##+ fails where 'make format' would change something
	@clang-format --dry-run -Werror $(FORMATTED)

# Not in known mistakes, where bugs are what is wanted, nor in files that only compile for WebAssembly or with a
# chapter's number.
NOT_TIDY = $(wildcard tests/[0-9]*/wrong.c) chapters/book/instead/% tests/proof/book/reference_answers.c \
	tests/proof/book/answer_by_number.c
tidy: $(B)/compile_commands.json ##+ look for bugs (clang-tidy)
	clang-tidy --quiet -p $(B) $(filter-out $(NOT_TIDY),$(filter %.c,$(C_SOURCES)))

# For tidy and for editors: what is known of the exercises as beside the reference; and the students' answers, with
# the warnings that they get.
KNOWN_SOURCES = $(filter %/wrong.c %/right.c %/verdicts.c %/laws.c %/facts.c,$(C_SOURCES))
STUDENTS_SOURCES = $(STEMS:%=exercises/%.c) $(wildcard exercises/optional/*.c)
commands_of = for f in $(1); do printf '{"directory": "%s", "file": "%s", "command": "%s -c %s"},\n' \
	'$(CURDIR)' "$$f" '$(CC) $(LANGUAGE) $(2)' "$$f"; done
$(B)/compile_commands.json: Makefile .make/house.mk $(filter %.c,$(C_SOURCES)) $(if $(KNOWN_SOURCES),$(B)/reference.h)
	@mkdir -p $(@D)
	@{ $(call commands_of,$(filter-out $(KNOWN_SOURCES),$(filter %.c,$(C_SOURCES))),$(STRICT) $(PNG_CFLAGS)); \
		$(call commands_of,$(KNOWN_SOURCES),$(STRICT) $(AS_KNOWN)); \
		$(call commands_of,$(STUDENTS_SOURCES),$(FOR_STUDENTS)); } | sed '1s/^/[/; $$s/,$$/]/' > $@

clean: ## remove what was built
	rm -rf build

# What a target is for: behind '##' what a person needs, on one screen; behind '##+' what a contributor or a script needs.
help: ## this (ALL=1: also what writes and tests the toolkit)
	@awk -F ' ##[+]? ' -v all='$(ALL)' '/^[a-z-]+:.* ##[+]? / && (all || !/ ##[+] /) { \
		sub(/:.*/, "", $$1); line = sprintf("  make %-13s", $$1); count = split($$2, words, " "); \
		for (i = 1; i <= count; i++) { \
			if (length(line " " words[i]) > 80) { print line; line = sprintf("%20s", "") } \
			line = line " " words[i] } \
		print line }' $(filter Makefile %.mk,$(MAKEFILE_LIST))

.PHONY: format format-check tidy clean help
