# bench.mk - make bench, and its parts. Included by the Makefile.

# Chapter 08's engines; with PEERS=1 beside Embree, POV-Ray and Tachyon. The bench says which of them
# are missing, and goes on.
PEERS :=
EMBREE := $(if $(PEERS),$(shell echo '\#include <embree3/rtcore.h>' | $(CC) -E -x c - >/dev/null 2>&1 && echo yes))
ENGINE_BENCH := $(B)/tests/benches/engines$(if $(PEERS),-and-peers)
ENGINE_OBJECTS := $(filter-out %/main.o,$(call chapter_objects,$(ENGINE_CHAPTER))) $(B)/chapters/shared.a \
	$(STEMS:%=$(B)/solutions/%.o)
PEER_OBJECTS := $(patsubst %,$(B)/tests/benches/peers/%.o,$(if $(PEERS),peers $(if $(EMBREE),embree embree_light,no_embree) programs,none)) \
	$(if $(PEERS),$(B)/chapters/$(SHADING_CHAPTER)/export.o)
$(B)/tests/benches/peers/embree.o: EXTRA = -O3 -march=native -fopenmp-simd -fno-math-errno \
	-fno-trapping-math -ffp-contract=fast -mprefer-vector-width=512
$(B)/tests/benches/peers/programs.o: EXTRA = $(PNG_CFLAGS)
SHADED_BENCH := $(B)/tests/benches/shaded$(if $(PEERS),-and-peers)
$(ENGINE_BENCH): $(patsubst %,$(B)/tests/benches/%.o,engines report)
$(SHADED_BENCH): $(B)/tests/benches/shaded.o
$(ENGINE_BENCH) $(SHADED_BENCH): $(PEER_OBJECTS) $(ENGINE_OBJECTS) $(B)/common.a
	$(call say,link,$@)
	$(Q)$(LINK) -o $@ $(filter %.o,$^) $(filter %.a,$^) $(if $(EMBREE),-lembree3) $(PNG_LIBS) -lm -pthread
WAIT_BENCH := $(if $(EMBREE),$(B)/tests/benches/peers/embree_wait)
$(B)/tests/benches/peers/embree_wait.o: EXTRA = $(PNG_CFLAGS)
$(B)/tests/benches/peers/embree_wait: %: %.o $(B)/tests/benches/peers/embree.o \
		$(B)/tests/benches/by_sscanf.o $(ENGINE_OBJECTS) $(B)/common.a
	$(call say,link,$@)
	$(Q)$(LINK) -o $@ $^ -lembree3 $(PNG_LIBS) -lm -pthread
RAY_BENCH := $(if $(EMBREE),$(B)/tests/benches/peers/any_rays)
$(B)/tests/benches/peers/any_rays: %: %.o $(B)/tests/benches/peers/trees.o $(ENGINE_OBJECTS) \
		$(B)/chapters/shared.a $(ANSWER_OBJECTS) $(B)/common.a
	$(call say,link,$@)
	$(Q)$(LINK) -o $@ $^ -lembree3 $(PNG_LIBS) -lm -pthread
bench-rays: $(RAY_BENCH) $(if $(EMBREE),$(BENCH_SCENES)) ## rays from anywhere, building and trees beside Embree (PEERS=1)
	@$(if $(EMBREE),$(RAY_BENCH) $(BENCH_SCENES),$(if $(PEERS),echo 'Embree 3 is not installed: make setup FOR=bench',echo \
		'bench-rays compares with Embree: make bench-rays PEERS=1'))
BENCH_TABLES := $(B)/tests/benches/tables
$(BENCH_TABLES): %: %.o
	$(call say,link,$@)
	$(Q)$(LINK) -o $@ $^ -lm
bench-engines: $(ENGINE_BENCH) $(BENCH_TABLES) $(BENCH_SCENES) ## rays a second: engines, scenes, threads (PEERS=1: also others)
	@tests/benches/engines.sh $(ENGINE_BENCH) $(BENCH_TABLES) $(B)/bench $(BENCH_SCENES)
TURNS := $(B)/tests/benches/turns
$(B)/tests/benches/alone: %: %.o $(ENGINE_OBJECTS) $(B)/common.a
	$(call say,link,$@)
	$(Q)$(LINK) -o $@ $^ $(PNG_LIBS) -lm -pthread
$(TURNS): %: %.o $(B)/common.a
	$(call say,link,$@)
	$(Q)$(LINK) -o $@ $^ -lm
bench-wait: $(TURNS) $(B)/tests/benches/alone $(WAIT_BENCH) $(if $(PEERS),$(ENGINE_BENCH) $(SAME)) $(BUILT)/$(ENGINE_CHAPTER) $(B)/scenes/sphereflake-597871.nff ## from scene to picture (PEERS=1: also others)
	@PROGRAMS='$(BUILT)' BUILD='$(B)' PEERS='$(PEERS)' tests/benches/wait.sh $(B)/scenes/sphereflake-597871.nff
$(B)/tests/benches/reading: %: %.o $(B)/tests/benches/by_sscanf.o $(B)/common.a
	$(call say,link,$@)
	$(Q)$(LINK) -o $@ $^ $(PNG_LIBS) -lm
bench-reading: $(B)/tests/benches/reading $(filter $(B)/%,$(BENCH_SCENES)) ## scenes: beside sscanf
	@$< $(filter %.nff,$^)
bench-shading: $(TURNS) $(BUILT)/$(SHADING_CHAPTER) $(BUILT)/$(ENGINE_CHAPTER) $(B)/scenes/sphereflake-7381.nff ## shadows and mirrors: how much sooner by the hierarchy
	@PROGRAMS='$(BUILT)' TURNS='$(TURNS)' tests/benches/shading.sh $(B)/scenes/sphereflake-7381.nff
$(B)/tests/benches/pictures.o: EXTRA = $(PNG_CFLAGS)
$(B)/tests/benches/pictures: %: %.o
	$(call say,link,$@)
	$(Q)$(LINK) -o $@ $^ $(PNG_LIBS) -lz
bench-pictures: $(B)/tests/benches/pictures $(BUILT)/$(SHADING_CHAPTER) $(BUILT)/$(ENGINE_CHAPTER) $(SCENES) ## a PNG by libpng's settings: time and size
	@tests/benches/pictures.sh $(B) $(BUILT)
bench-shaded: $(SHADED_BENCH) $(BENCH_TABLES) $(BENCH_SCENES) ## shaded pictures on all scenes (PEERS=1: also POV-Ray, and Embree with our shading)
	@tests/benches/shaded.sh $(SHADED_BENCH) $(BENCH_TABLES) $(B)/bench $(BENCH_SCENES)
# All numbers of chapter 08, in one run.
bench-record: ## the numbers, tables and figure of chapter 08 (PEERS=1, on an idle machine)
	@$(MAKE) --no-print-directory -s -j1 bench-engines bench-shaded bench-rays bench-wait
	@tests/benches/record.sh $(BENCH_TABLES) $(B)/bench chapters/$(ENGINE_CHAPTER)
bench: $(JUDGE) $(GRADABLE:%=%/commands) ## from save to verdict; a class a minute; rays a second
	@$(MAKE) --no-print-directory -s -j1 bench-engines bench-reading bench-wait bench-shading $(if $(PEERS),bench-shaded bench-rays)
	@tests/benches/latency.sh
	@$(if $(GRADABLE),KIT=$(KIT) tests/benches/grade.sh,echo 'grading is not measured: make setup FOR=instructor')
.PHONY: bench bench-rays bench-engines bench-shaded bench-record bench-wait bench-reading bench-shading bench-pictures
