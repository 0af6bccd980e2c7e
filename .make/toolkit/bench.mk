# bench.mk - make bench, and its parts. Included by the Makefile.
#
# PEERS=1 measures chapter 08 beside Embree and POV-Ray; the benches name those that are not installed, and
# go on. OPTIONS are a bench's own, for example OPTIONS='-r 3 -l 1' (tests/benches/flat.c and shaded.c).
PEERS :=
OPTIONS :=
EMBREE := $(if $(PEERS),$(shell echo '\#include <embree3/rtcore.h>' | $(CC) -E -x c - >/dev/null 2>&1 && echo yes))
BENCHES := $(B)/tests/benches/flat $(B)/tests/benches/shaded
$(B)/tests/benches/embree.o: EXTRA = -O3 -march=native -fopenmp-simd -fno-math-errno \
	-fno-trapping-math -ffp-contract=fast -mprefer-vector-width=512
$(B)/tests/benches/peers.o: EXTRA = $(PNG_CFLAGS)
$(BENCHES): %: %.o $(patsubst %,$(B)/tests/benches/%.o,peers $(if $(EMBREE),embree embree_light)) \
		$(filter-out %/main.o,$(call chapter_objects,$(ENGINE_CHAPTER))) $(B)/chapters/$(SHADING_CHAPTER)/export.o \
		$(B)/chapters/shared.a $(STEMS:%=$(B)/solutions/%.o) $(B)/common.a
	$(call say,link,$@)
	$(Q)$(LINK) -o $@ $(filter %.o,$^) $(filter %.a,$^) $(if $(EMBREE),-lembree3) $(PNG_LIBS) -lm -pthread

MEASURED := $(B)/bench
bench-flat: $(B)/tests/benches/flat $(BENCH_SCENES) ##+ rays a second: engines, scenes, threads (PEERS=1: also Embree and POV-Ray)
bench-shaded: $(B)/tests/benches/shaded $(BENCH_SCENES) ##+ shaded pictures on all scenes (PEERS=1: also Embree and POV-Ray)
bench-flat bench-shaded:
	@mkdir -p $(MEASURED)
	@$< $(if $(PEERS),-p) $(OPTIONS) -o $(MEASURED) $(BENCH_SCENES) | tee $(MEASURED)/$@.txt
	@python3 -B tests/benches/tables.py $(MEASURED) > $(MEASURED)/tables.md && echo 'written: $(MEASURED)/$@.txt, *.csv, tables.md'

# Chapter 08 gets the numbers that were just measured: its tables, CSV files and figure.
LESSON_08 := chapters/$(ENGINE_CHAPTER)
bench-record: ##+ the numbers, tables and figure of chapter 08 (PEERS=1, on an idle machine)
	@$(MAKE) --no-print-directory -s -j1 bench-flat bench-shaded
	@python3 -B tests/benches/tables.py $(MEASURED) $(LESSON_08)/README.md > $(MEASURED)/README.md
	@cp $(MEASURED)/README.md $(LESSON_08)/ && cp $(MEASURED)/*.csv $(LESSON_08)/figures/
	@$(MAKE) --no-print-directory -s bench-figure
bench-figure: # chapter 08's figure, from its CSV files
	@python3 -B tests/benches/tables.py -f $(LESSON_08)/figures > $(B)/bench-figure.gp
	@for theme in light dark; do \
		gnuplot -e "theme = '$$theme'" $(B)/bench-figure.gp tests/benches/flat.gp > $(B)/bench-figure-$$theme.svg || exit 1; done
	@$(LESSON_FIGURES) --svg $(B)/bench-figure-light.svg $(B)/bench-figure-dark.svg 'Rays per second' \
		'Rays per second over spheres, both logarithmic.' > $(LESSON_08)/rays-per-second.svg
bench: $(JUDGE) $(GRADABLE:%=%/commands) ## from save to verdict; a class a minute; rays a second
	@$(MAKE) --no-print-directory -s -j1 bench-flat $(if $(PEERS),bench-shaded)
	@tests/benches/latency.sh
	@$(if $(GRADABLE),python3 -B tests/benches/grade.py $(KIT),echo 'grading is not measured: make setup FOR=instructor')
.PHONY: bench bench-flat bench-shaded bench-record bench-figure
