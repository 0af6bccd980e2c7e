# tables.mk - what a handout has instead of tests, solutions and references: tables of right results (tests/tables/), and
# the student's own earlier answers. Included by .make/exercises.mk.

# A chapter depends on the answers of the earlier ones: each is judged first, and its object file
# (that of the blank, if it does not compile) is linked with the later ones.
earlier_answers = $(patsubst %,$(VERDICT)/%/answer.o,$(call earlier,$(1)))
stands_on = $(call earlier,$(1))

# The numbers of what is right, which figures draw beside a student's.
build/right-figures/%.gp: tests/tables/right-figures.tar
	$(Q)mkdir -p $(@D)
	$(Q)tar xOf $< $*.gp > $@
