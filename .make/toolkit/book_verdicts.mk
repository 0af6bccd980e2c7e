# book_verdicts.mk - the same verdicts in the page as in the terminal: a test over all known answers. Included by
# book.mk.
#
# What a known answer is linked with, in the terminal (KNOWN) and for the page (WASM_KNOWN), an object a chapter
# (tests/proof/book/known_answers.h).
KNOWN := $(B)/known
WASM_KNOWN := $(WASM)/known
KNOWN_PARTS := $(patsubst %,$(B)/tests/%.o,proof/book/known_answers judge/stem)
by_number = -DANSWERED=$(call answered,$(1)) '-DSOLUTION="$(call exact_of,$(1))"' -include $(B)/weak.h
KNOWN_TWO := tests/proof/book/answer_by_number.c tests/proof/book/reference_answers.c
$(BOOK_STEMS:%=$(KNOWN)/%.o): $(KNOWN)/%.o: $(KNOWN_TWO) $(B)/weak.h $(KNOWN_PARTS) $(B)/$(INSTEAD)/tanf.o $(REFERENCES) \
		$$(foreach kind,wrong right verdicts,$$(call parts,tests/$$*/$$(kind)))
	$(call say,compile,known answers of $*)
	$(Q)mkdir -p $(@D)
	$(Q)$(CC) $(LANGUAGE) -O2 -w -finstrument-functions $(call by_number,$*) -c -o $(@D)/$*-number.o $(word 1,$^)
	$(Q)$(CC) $(LANGUAGE) -O2 -w $(call by_number,$*) -c -o $(@D)/$*-reference.o $(word 2,$^)
	$(Q)ld -r -o $@ $(@D)/$*-number.o $(@D)/$*-reference.o $(filter-out $(B)/weak.h,$(wordlist 3,999,$^))
$(BOOK_STEMS:%=$(WASM_KNOWN)/%.o): $(WASM_KNOWN)/%.o: $(KNOWN_TWO) $(B)/weak.h $(call wasm_of,$(KNOWN_PARTS)) $(WASM_REFERENCES) \
		$$(call wasm_of,$$(foreach kind,wrong right verdicts,$$(call parts,tests/$$*/$$(kind))))
	$(call say,wasm,known answers of $*)
	$(Q)mkdir -p $(@D)
	$(Q)$(WASM_CC) $(WASM_LANGUAGE) -O2 -w $(call by_number,$*) -c -o $(@D)/$*-number.o $(word 1,$^)
	$(Q)$(WASM_CC) $(WASM_LANGUAGE) -O2 -w $(call by_number,$*) -c -o $(@D)/$*-reference.o $(word 2,$^)
	$(Q)wasm-ld -r -o $@ $(@D)/$*-number.o $(@D)/$*-reference.o $(filter-out $(B)/weak.h,$(wordlist 3,999,$^))
# How an exercise is called by its number: an answer that is judged has that already, a picture has not.
KNOWN_CALLS := $(patsubst %,$(B)/tests/judge/%.o,exercise types)
$(KNOWN)/exercise.a: $(KNOWN_CALLS)
$(WASM_KNOWN)/exercise.a: $(call wasm_of,$(KNOWN_CALLS))
$(KNOWN)/exercise.a $(WASM_KNOWN)/exercise.a:
	$(Q)mkdir -p $(@D)
	$(Q)rm -f $@ && llvm-ar rcsD $@ $^
# In the terminal the answer and the judge have the page's tanf: those of C libraries differ in the last digit.
SAME_TANF := $(KNOWN)/tanf.so
$(SAME_TANF): $(INSTEAD)/tanf.c
	$(Q)mkdir -p $(@D)
	$(Q)$(CC) $(LANGUAGE) -O2 -shared -fPIC -o $@ $< -lm
LIST_KNOWN := $(B)/tests/proof/book/list_known
$(LIST_KNOWN): $(LIST_KNOWN).o $(KNOWN_PARTS) $(KNOWN_ANSWERS) $(REFERENCES) \
		$(KNOWN_CALLS) $(B)/common.a
	$(call say,link,$@)
	$(Q)$(LINK) -o $@ $^ -lm

check-book-verdicts: book-judge book-programs $(LIST_KNOWN) $(SAME_TANF) $(foreach of,$(KNOWN) $(WASM_KNOWN),$(BOOK_STEMS:%=$(of)/%.o) $(of)/exercise.a) \
		$(call FOR_JUDGING,$(STEMS)) ## the page's verdicts against the terminal's (COUNT=... of them, SEED=...)
	@COUNT='$(or $(COUNT),$(if $(filter check-book-verdicts,$(MAKECMDGOALS)),,2))' CC='$(CC)' node tests/proof/book/verdicts.mjs '$(B)' '$(WASM)' '$(BOOK)' $(if $(EX),$(CHOSEN),$(BOOK_STEMS))
.PHONY: check-book-verdicts
$(if $(FROM),,check-book: check-book-verdicts)
