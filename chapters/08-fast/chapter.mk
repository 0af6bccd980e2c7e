# chapter.mk - the scenes of chapter 08's measurements. They take long and have no picture.
# make bench and the tests of the engines are about this chapter.
ENGINE_CHAPTER := 08-fast
RANDOM := random-1000 random-100000 random-1000000
BENCH_SCENES := chapters/06-ray-casting/three-spheres.nff $(patsubst %,$(B)/scenes/%.nff, \
	$(filter sphereflake%,$(GENERATED)) sphereflake-66430 sphereflake-597871 $(RANDOM))
SCENES += $(filter-out $(SCENES) chapters/%,$(BENCH_SCENES))
$(B)/scenes/sphereflake-66430.nff: ARGUMENTS = 5
$(B)/scenes/sphereflake-597871.nff: ARGUMENTS = 6
$(RANDOM:%=$(B)/scenes/%.nff): ARGUMENTS = $(*:random-%=%)
