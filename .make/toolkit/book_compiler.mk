# book_compiler.mk - the compiler of the page: clang of npm's @yowasp/clang, cut down, and a pack of headers and
# libraries. Included by book.mk.
#
# All is compressed with xz, which leaves less than gzip, and no host has to do anything for it (compiler.js).
COMPILER := chapters/book/compiler
CLANG_OF_NPM := $(NPM)/node_modules/@yowasp/clang/gen
WASM_COMPILER := $(WASM)/compiler
BOOK_COMPILER := $(BOOK)/compiler
COMPRESSED := small.wasm.xz whole.wasm.xz pack.xz

CUT := $(addprefix $(COMPILER)/,cut_compiler.mjs cut.js kept.js)
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
$(WASM_COMPILER)/pack: $(COMPILER)/flags.json $(COMPILER)/write_pack.js $(WASM_COMPILER)/include/stddef.h $(STRIPPED) \
		$(B)/weak.h $(wildcard common/*.h exercises/*.h) $(ANSWERING_LINKS) $(if $(ANSWERING_LINKS),$(STEMS:%=$(WASM)/names/%) $(WASM)/common.a)
	$(call say,pack,headers and libraries)
	$(Q)node $(COMPILER)/write_pack.js $@ $< $(PACKED)

# xz-decompress knows no other check. The small one is fetched by each student, so it is packed as well as can be.
XZ := xz --check=crc32 --threads=1 --stdout
$(BOOK_COMPILER)/small.wasm.xz: XZ_HOW := --lzma2=preset=8,dict=8MiB
$(BOOK_COMPILER)/whole.wasm.xz: XZ_HOW := --lzma2=preset=1,dict=8MiB
$(BOOK_COMPILER)/pack.xz: XZ_HOW := --lzma2=preset=9e,dict=4MiB
$(COMPRESSED:%=$(BOOK_COMPILER)/%): $(BOOK_COMPILER)/%.xz: $(WASM_COMPILER)/% .make/toolkit/book_compiler.mk
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
TRAINED := $(wildcard solutions/0[1-7]*.c exercises/0[1-7]*.c solutions/optional/*.c $(COMPILER)/sample.c \
	chapters/0*/*.c chapters/0*/*/*.c common/*.c common/figure/*.c tests/judge/*.c tests/course/*.c tests/explain/*.c)
SLIPS ?= 2000
book-train: $(WASM_COMPILER)/whole.wasm $(WASM_COMPILER)/pack $(BOOK_PICTURES)
	$(call say,train,clang)
	$(Q)node $(COMPILER)/write_pack.js $(WASM_COMPILER)/training $(COMPILER)/flags.json $(PACKED) tests/=tests chapters/=chapters
	$(Q)wasm-split --instrument --profile-export=__write_profile -all $(WASM_COMPILER)/whole.wasm -o $(WASM_COMPILER)/noting.wasm
	$(Q)node $(COMPILER)/train.mjs $(WASM_COMPILER)/noting.wasm $(CLANG_OF_NPM)/llvm.core.wasm $(WASM_COMPILER)/training \
		$(WASM)/pictures.pack $(COMPILER)/kept.txt $(SLIPS) $(TRAINED) > $(WASM_COMPILER)/kept.new
	$(Q)mv $(WASM_COMPILER)/kept.new $(COMPILER)/kept.txt
.PHONY: book-train
