# glim: `make` builds build/glim, `make help` lists what else there is.
#   MODE=release (default), debug, asan, tsan     CC=gcc or clang
#   BUILD=DIR builds elsewhere                    PREFIX, DESTDIR for install
#   IMAGES=png does without OpenImageIO           EMBREE=3 or 4, if both are here

MODE   ?= release
PREFIX ?= /usr/local
BUILD  ?= build$(if $(filter-out release,$(MODE)),/$(MODE))
VERSION = 0.1

# What building needs, and what testing needs besides; Debian's names. Other
# systems' are in tests/tools/packages. Some releases lack one that ends in "?".
PACKAGES      = gcc g++ make libembree-dev libpng-dev libjpeg-dev \
	libjansson-dev? $(IMAGE_PACKAGES)
TEST_PACKAGES = libcmocka-dev mandoc povray povray-includes povray-examples \
	openimageio-tools $(CLANG_FORMAT)?
GIVEN_CPPFLAGS := $(CPPFLAGS)
DEPS = CC="$(CC)" CXX="$(CXX)" CPPFLAGS="$(GIVEN_CPPFLAGS)" tests/tools/deps
# The version that the tree is written in, and the only one that checks it.
CLANG_FORMAT := $(shell sed -n 's/^\# //p' src/.clang-format)

WARNINGS = -Wall -Wextra -Wshadow -Wundef -Wwrite-strings -Wdouble-promotion \
	-Wpointer-arith -Wcast-qual -Wno-missing-field-initializers
# Vectors are passed by functions that are part of their callers, never called.
WARNINGS += -Wno-psabi
C_WARNINGS = $(WARNINGS) -Wstrict-prototypes -Wmissing-prototypes \
	-Wold-style-definition

# Functions begin with a line of the cache: else a tenth of a hot loop's time
# depends on what lies before it.
FLAGS_release = -O3 -DNDEBUG -falign-functions=64
FLAGS_debug   = -O0 -g
FLAGS_asan    = -O1 -g -fno-omit-frame-pointer \
	-fsanitize=address,undefined,float-cast-overflow \
	-fno-sanitize-recover=all
FLAGS_tsan    = -O1 -g -fsanitize=thread
FLAGS_fuzz    = -O1 -g -fno-omit-frame-pointer \
	-fsanitize=address,undefined,float-cast-overflow,fuzzer-no-link \
	-fno-sanitize-recover=all -fno-sanitize-coverage=trace-cmp
FLAGS = $(FLAGS_$(MODE)) -fno-math-errno -fno-trapping-math -ffp-contract=off \
	-fno-plt

# gcc empties and copies small structs by `rep stos` and `rep movs`, which take
# longer to begin than all of the work: a fiftieth of all time. Others, clang
# among them, don't know how to be told, and don't do so.
ifeq ($(MODE),release)
SMALL_BLOCKS = unrolled_loop:256:noalign,libcall:-1:noalign
BLOCK_FLAGS  = -mmemset-strategy=$(SMALL_BLOCKS) -mmemcpy-strategy=$(SMALL_BLOCKS)
BLOCK_FLAGS := $(shell $(CC) $(BLOCK_FLAGS) -E -x c /dev/null > /dev/null \
	2>&1 && echo $(BLOCK_FLAGS))
FLAGS_release += $(BLOCK_FLAGS)
endif

# What users run is one program to gcc: calls between files can be parts of
# their callers, a twentieth of all time. Other programs are linked as usual.
ifeq ($(MODE),release)
ifeq (,$(findstring clang,$(shell $(CC) --version)))
LTO_COMPILE = -flto -ffat-lto-objects
LTO_LINK    = -flto=auto
NO_LTO_LINK = -fno-lto
endif
endif

# Embree 4 or 3, as <embree4/rtcore.h> is found or not; its library,
# libembree4.so.4 or libembree3.so.3, is loaded when needed: see src/world/rtcore.h.
EMBREE := $(shell $(CC) $(CPPFLAGS) -E -x c -include embree4/rtcore.h \
	/dev/null > /dev/null 2>&1 && echo 4 || echo 3)

override CFLAGS   += -std=c11 $(C_WARNINGS) $(FLAGS)
override CXXFLAGS += -std=c++17 $(WARNINGS) -Wno-cast-qual $(FLAGS)
override CPPFLAGS += -Isrc -D_POSIX_C_SOURCE=200809L -D_DEFAULT_SOURCE \
	-DGLIM_VERSION='"$(VERSION)"' -DGLIM_VERSION_NUMBER=$(VERSION) \
	-DGLIM_EMBREE=$(EMBREE)
PICTURE_LDLIBS     = -lpng -ljpeg -lz -lpthread -lm -ldl
override LDLIBS   += $(PICTURE_LDLIBS)
# Image files are a module of their own, loaded when needed: see src/image/codec.h.
# PNG and PPM need none of it, nor do GIF and JPEG to be read, nor EXR to be
# written.
ifneq ($(IMAGES),png)
MODULE = $(BUILD)/glim-image.so
IMAGE_PACKAGES = libopenimageio-dev
endif
MODULE_LDLIBS = -lOpenImageIO -lOpenImageIO_Util

# The language server is a program of its own beside glim, made where Jansson is.
JANSSON := $(shell $(CC) $(CPPFLAGS) -E -x c -include jansson.h /dev/null \
	> /dev/null 2>&1 && echo yes)
ifeq ($(JANSSON),yes)
SERVER = $(BUILD)/glim-language-server
endif

C_SOURCES   = $(shell find src -name '*.c' -not -path 'src/view/*' \
	-not -path 'src/language/*')
VIEW_SOURCES = $(wildcard src/view/*.c)
SERVER_OBJECTS = $(patsubst %.c,$(BUILD)/%.o,$(wildcard src/language/*.c))
CXX_SOURCES = $(shell find src -name '*.cpp')
OBJECTS = $(C_SOURCES:%.c=$(BUILD)/%.o)
MODULE_OBJECTS = $(CXX_SOURCES:%=$(BUILD)/%.o)
LIBRARY_OBJECTS = $(filter-out %/main.o,$(OBJECTS))
PROGRAMS = $(BUILD)/glim $(BUILD)/glim-compare $(VIEW) $(SERVER)

# The window needs SDL; without it there is none.
VIEW_PACKAGES = libsdl2-dev libsdl2-ttf-dev fonts-dejavu-core
VIEW_OBJECTS = $(VIEW_SOURCES:%.c=$(BUILD)/%.o)
VIEW := $(shell $(CC) $(CPPFLAGS) -E -x c -include SDL2/SDL_ttf.h /dev/null \
	> /dev/null 2>&1 && echo $(BUILD)/glim-view)

# Which of how many: only the dry run before knows how many there are.
TICK = @$(eval TICKS += .)echo "  $(if $(TOTAL),[$(words $(TICKS))/$(TOTAL)] )$(1)"
BUILD_ALL = total=$$($(MAKE) -n $(1) | grep -c '^echo "  '); \
	$(MAKE) --no-print-directory $(CORES) TOTAL=$$total $(1)
# All cores, unless -j says something else.
CORES = $(if $(findstring -j,$(MAKEFLAGS)),,-j$(shell \
	nproc 2> /dev/null || getconf _NPROCESSORS_ONLN))

all: needed ## build build/glim and others (installs what they need, but SDL)
	+@$(call BUILD_ALL,programs)

# What can be built once packages are installed only the next make sees.
programs: $(PROGRAMS)

$(BUILD)/glim: $(BUILD)/src/main.o $(BUILD)/libglim.a | $(MODULE) $(SERVER)
	$(call TICK,link $@)
	@$(CXX) $(FLAGS) $(LTO_LINK) -Wl,-z,now $(LDFLAGS) -o $@ $^ $(LDLIBS)

# No Embree: nothing of the tracer is in it.
$(BUILD)/glim-compare: $(BUILD)/src/compare/main.o $(BUILD)/libglim.a | \
		$(MODULE)
	$(call TICK,link $@)
	@$(CXX) $(FLAGS) $(NO_LTO_LINK) $(LDFLAGS) -o $@ $^ $(PICTURE_LDLIBS)

# Nothing of the tracer is in it, either.
$(BUILD)/glim-language-server: $(SERVER_OBJECTS) $(BUILD)/libglim.a
	$(call TICK,link $@)
	@$(CXX) $(FLAGS) $(NO_LTO_LINK) $(LDFLAGS) -o $@ $^ -ljansson \
		$(PICTURE_LDLIBS)

# Texts that are a part of it: each line a string of C.
$(BUILD)/text/grammar.inc: $(sort $(wildcard grammar/*.ebnf))
$(BUILD)/text/manual.inc: man/glim.5
$(BUILD)/text/%.inc:
	@mkdir -p $(@D)
	@cat $^ | sed -e 's/\\/\\\\/g' -e 's/"/\\"/g' -e 's/.*/"&\\n"/' > $@
$(BUILD)/src/language/grammar.o: $(BUILD)/text/grammar.inc
$(BUILD)/src/language/manual.o: $(BUILD)/text/manual.inc
$(SERVER_OBJECTS): override CPPFLAGS += -I$(BUILD)/text

# Polynomials of few coefficients are worked out in registers, if gcc doesn't
# make vectors of loops over three of them, which then go by way of memory.
$(BUILD)/src/scene/polynomial.o: override CFLAGS += -fno-tree-vectorize

# What decides the bits of pictures, as a hash: see src/cli/build.h.
$(BUILD)/text/build.inc: $(sort $(shell find src -name '*.[ch]' -o -name '*.cpp'))
	@mkdir -p $(@D)
	@{ cat $^; $(CC) --version | head -n 1; echo '$(FLAGS)'; } | \
		sha256sum | sed 's/^\(.\{16\}\).*/"\1"/' > $@
$(BUILD)/src/cli/build.o: $(BUILD)/text/build.inc
$(BUILD)/src/cli/build.o: override CPPFLAGS += -I$(BUILD)/text

# What the program and its module must have in common: see src/image/codec.h.
CODEC_OBJECTS = $(BUILD)/src/image/file.o $(BUILD)/src/image/file.cpp.o
$(BUILD)/text/codec.inc: $(sort $(wildcard src/image/*.[ch] src/image/*.cpp))
	@mkdir -p $(@D)
	@cat $^ | sha256sum | sed 's/^\(.\{16\}\).*/"\1"/' > $@
$(CODEC_OBJECTS): $(BUILD)/text/codec.inc
$(CODEC_OBJECTS): override CPPFLAGS += -I$(BUILD)/text

# A twentieth of its time isn't worth half the time of building everything.
$(BUILD)/glim-view: $(VIEW_OBJECTS) $(BUILD)/libglim.a | $(MODULE)
	$(call TICK,link $@)
	@$(CXX) $(FLAGS) $(NO_LTO_LINK) $(LDFLAGS) -o $@ $^ $(LDLIBS) -lSDL2_ttf -lSDL2

$(MODULE): $(MODULE_OBJECTS)
	$(call TICK,link $@)
	@$(CXX) $(FLAGS) -shared -o $@ $^ $(MODULE_LDLIBS)

$(BUILD)/libglim.a: $(LIBRARY_OBJECTS)
	@rm -f $@
	@$(AR) rcs $@ $^

$(BUILD)/%.o: %.c
	$(call TICK,$(CC) $<)
	@mkdir -p $(@D)
	@$(CC) $(CPPFLAGS) $(CFLAGS) $(LTO_COMPILE) -MMD -MP -c -o $@ $<

$(BUILD)/%.cpp.o: %.cpp
	$(call TICK,$(CXX) $<)
	@mkdir -p $(@D)
	@$(CXX) $(CPPFLAGS) $(CXXFLAGS) -fPIC -isystem /usr/include/Imath \
		-MMD -MP -c -o $@ $<

demo: needed ## build, render an example, say where the picture is
	+@$(call BUILD_ALL,programs)
	@tests/tools/demo $(BUILD)/glim

needed:
	@$(DEPS) $(PACKAGES)

deps: ## install the Debian packages that building needs, glim-view too
	@$(DEPS) $(PACKAGES) $(VIEW_PACKAGES)

test-deps: ## install the Debian packages that testing needs
	@$(DEPS) $(PACKAGES) $(VIEW_PACKAGES) $(TEST_PACKAGES)

test: test-deps ## everything: "N passed, N failed" is the last line
	+@$(call BUILD_ALL,programs $(UNIT_TESTS) $(TEST_TOOLS))
	@BUILD=$(abspath $(BUILD)) GLIM=$(abspath $(BUILD)/glim) MODE=$(MODE) \
		tests/run

UNIT_TESTS = $(patsubst %.c,$(BUILD)/%,$(wildcard tests/unit/test_*.c))
TEST_TOOLS = $(patsubst %.c,$(BUILD)/%,$(wildcard tests/tools/*.c)) \
	$(BUILD)/tests/fuzz/replay

$(BUILD)/tests/unit/%: $(BUILD)/tests/unit/%.o $(BUILD)/libglim.a
	@$(CXX) $(FLAGS) $(NO_LTO_LINK) $(LDFLAGS) -o $@ $^ $(LDLIBS) -lcmocka

$(BUILD)/tests/tools/%: $(BUILD)/tests/tools/%.o $(BUILD)/libglim.a
	@$(CXX) $(FLAGS) $(NO_LTO_LINK) $(LDFLAGS) -o $@ $^ $(LDLIBS)

$(BUILD)/tests/fuzz/replay: $(BUILD)/tests/fuzz/parser.o \
		$(BUILD)/tests/fuzz/replay.o $(BUILD)/libglim.a
	@$(CXX) $(FLAGS) $(NO_LTO_LINK) $(LDFLAGS) -o $@ $^ $(LDLIBS)

.SECONDARY:

conformance: all ## every scene of povray-examples by both programs
	@$(DEPS) povray povray-includes povray-examples openimageio-tools
	@$(MAKE) --no-print-directory $(BUILD)/tests/tools/compare
	@GLIM=$(abspath $(BUILD)/glim) tests/conformance/run

bench: all $(BUILD)/tests/tools/limit ## what light costs, and how right it is, as ratios (BENCH=quick)
	@GLIM=$(abspath $(BUILD)/glim) tests/bench/run

reference: all $(BUILD)/tests/tools/figures ## path against POV-Ray's radiosity and Embree's path tracer
	@$(DEPS) povray openimageio-tools embree-tools
	@BUILD=$(abspath $(BUILD)) GLIM=$(abspath $(BUILD)/glim) tests/reference/run

latency: all $(BUILD)/tests/tools/speak ## how soon glim-view shows a change, and the language server answers
	@$(DEPS) povray povray-examples
	@BUILD=$(abspath $(BUILD)) GLIM=$(abspath $(BUILD)/glim) tests/language/latency
	@GLIM=$(abspath $(BUILD)/glim) tests/view/latency

view-camera: all $(BUILD)/tests/tools/compare ## 100 camera blocks of glim-view, drawn by both programs
	@$(DEPS) povray openimageio-tools
	@BUILD=$(abspath $(BUILD)) GLIM=$(abspath $(BUILD)/glim) tests/view/camera

# The scenes that are too large to be kept; the others are in examples/light.
bench-scenes: ## write build/bench/forest.pov and triangles.pov
	@mkdir -p build/bench
	@$(CC) -O2 -o build/bench/generate tests/bench/generate.c -lm
	build/bench/generate forest > build/bench/forest.pov
	build/bench/generate triangles > build/bench/triangles.pov

farm-test: all ## farms: a real Slurm on this machine, 200 kills, damage, make's jobs
	@$(DEPS) slurm-wlm munge parallel openimageio-tools
	@$(MAKE) --no-print-directory $(BUILD)/tests/tools/runnable
	@BUILD=$(abspath $(BUILD)) GLIM=$(abspath $(BUILD)/glim) tests/farm/run

hostile: all ## 700 inputs that mean harm: an error or a picture, soon
	@GLIM=$(abspath $(BUILD)/glim) MODE=$(MODE) tests/hostile/run

FUZZ_SECONDS ?= 600
fuzz: ## the parser under libFuzzer for FUZZ_SECONDS (600)
	@$(DEPS) clang $(PACKAGES)
	@$(MAKE) --no-print-directory $(CORES) MODE=fuzz CC=clang CXX=clang++ \
		BUILD=build/fuzz build/fuzz/fuzz-parser
	tests/fuzz/run build/fuzz/fuzz-parser $(FUZZ_SECONDS)

fuzz-language: all $(BUILD)/tests/tools/speak ## the language server under random edits for FUZZ_SECONDS
	@BUILD=$(abspath $(BUILD)) GLIM=$(abspath $(BUILD)/glim) \
		FUZZ_SECONDS=$(FUZZ_SECONDS) tests/language/run random

$(BUILD)/fuzz-parser: $(BUILD)/tests/fuzz/parser.o $(BUILD)/libglim.a
	@$(CXX) $(FLAGS) -fsanitize=fuzzer $(LDFLAGS) -o $@ $^ $(LDLIBS)

lint: ## layers, grammar, format, man pages
	@tests/tools/check-layers
	@tests/tools/check-grammar
	@tests/tools/check-format
	@mandoc -Tlint -Wwarning man/*.[15]

format: ## rewrite the sources in the project's style
	@tests/tools/check-format -i

html: all ## the manuals, and the examples' pictures, as build/html
	@$(DEPS) mandoc
	@tests/tools/html $(BUILD)/glim $(BUILD)/html

install: all ## into DESTDIR PREFIX
	install -D -m 755 $(BUILD)/glim $(DESTDIR)$(PREFIX)/bin/glim
	install -D -m 755 $(BUILD)/glim-compare \
		$(DESTDIR)$(PREFIX)/bin/glim-compare
	$(if $(SERVER),install -D -m 755 $(SERVER) \
		$(DESTDIR)$(PREFIX)/bin/glim-language-server)
	$(if $(MODULE),install -D -m 644 $(MODULE) \
		$(DESTDIR)$(PREFIX)/lib/glim/glim-image.so)
	$(if $(VIEW),install -D -m 755 $(VIEW) \
		$(DESTDIR)$(PREFIX)/bin/glim-view)
	$(if $(VIEW),install -D -m 644 man/glim-view.1 \
		$(DESTDIR)$(PREFIX)/share/man/man1/glim-view.1)
	install -D -m 644 man/glim.1 $(DESTDIR)$(PREFIX)/share/man/man1/glim.1
	install -D -m 644 man/glim-compare.1 \
		$(DESTDIR)$(PREFIX)/share/man/man1/glim-compare.1
	install -D -m 644 man/glim.5 $(DESTDIR)$(PREFIX)/share/man/man5/glim.5

uninstall: ## remove what install put there
	rm -f $(DESTDIR)$(PREFIX)/bin/glim \
		$(DESTDIR)$(PREFIX)/bin/glim-compare \
		$(DESTDIR)$(PREFIX)/bin/glim-language-server \
		$(DESTDIR)$(PREFIX)/bin/glim-view \
		$(DESTDIR)$(PREFIX)/share/man/man1/glim-view.1 \
		$(DESTDIR)$(PREFIX)/lib/glim/glim-image.so \
		$(DESTDIR)$(PREFIX)/share/man/man1/glim.1 \
		$(DESTDIR)$(PREFIX)/share/man/man1/glim-compare.1 \
		$(DESTDIR)$(PREFIX)/share/man/man5/glim.5

clean: ## remove build/
	rm -rf build

help: ## this list
	@sed -n 's/^\([a-z-]*\):.*## /  make \1\t/p' Makefile | expand -t 24

.PHONY: all programs demo needed deps test-deps test conformance bench reference \
	latency view-camera bench-scenes farm-test hostile fuzz fuzz-language lint format html \
	install uninstall clean help
-include $(OBJECTS:.o=.d) $(VIEW_OBJECTS:.o=.d) $(MODULE_OBJECTS:.o=.d) \
	$(SERVER_OBJECTS:.o=.d)
-include $(wildcard $(BUILD)/tests/*/*.d)
