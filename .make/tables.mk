# A handout has these instead of tests, solutions and references: tables of right results (tests/handout/replay/),
# and the student's own earlier answers. Included by the handout's Makefile.

# A table by itself: what is right passes, and each mistake's values are failed and named.
TABLE_CHECK := $(B)/tests/handout/replay/check
$(TABLE_CHECK): $(JUDGING) $(TABLE_CHECK).o $(B)/common.a | $(TABLES)
	$(link_program)

# The toolkit itself, whatever the contents of exercises/.
CHECKS := $(COMMON_TESTS)
check: $(CHECKS) $(TABLE_CHECK) $(JUDGE) $(BLANKS) ## the tests of the toolkit
	@CC='$(CC)' MAKEFLAGS= $(RUN) $(B)/log $(CHECKS) $(STEMS:%='$(TABLE_CHECK) %') tests/handout/replay/blanks.sh

# A chapter depends on the answers of the earlier ones: each is judged first, and its object file
# (that of the blank, if it does not compile) is linked with the later ones.
earlier_answers = $(patsubst %,$(VERDICT)/%/answer.o,$(call earlier,$(1)))
stands_on = $(call earlier,$(1))

# The calls of a table, made directly.
for_debug = $(B)/tests/handout/replay/debug.o $(READING) \
	$(B)/dispatch/$(1).o \
	$(call earlier_answers,$(1)) $(B)/common.a
