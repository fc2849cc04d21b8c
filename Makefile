# glim: `make` builds build/glim, `make help` lists what else there is.
#   MODE=release (default), debug, asan, tsan     CC=gcc or clang
#   BUILD=DIR builds elsewhere                    PREFIX, DESTDIR for install

MODE   ?= release
PREFIX ?= /usr/local
BUILD  ?= build$(if $(filter-out release,$(MODE)),/$(MODE))
VERSION = 0.1

PACKAGES = build-essential pkg-config libembree-dev libopenimageio-dev

WARNINGS = -Wall -Wextra -Wshadow -Wundef -Wwrite-strings -Wdouble-promotion \
	-Wpointer-arith -Wcast-qual
C_WARNINGS = $(WARNINGS) -Wstrict-prototypes -Wmissing-prototypes \
	-Wold-style-definition -Wdeclaration-after-statement
C_WARNINGS := $(filter-out -Wdeclaration-after-statement,$(C_WARNINGS))

FLAGS_release = -O3 -DNDEBUG
FLAGS_debug   = -O0 -g
FLAGS_asan    = -O1 -g -fno-omit-frame-pointer -fsanitize=address,undefined \
	-fno-sanitize-recover=undefined
FLAGS_tsan    = -O1 -g -fsanitize=thread
FLAGS = $(FLAGS_$(MODE)) -fno-math-errno -ffp-contract=off

CFLAGS   += -std=c11 $(C_WARNINGS) $(FLAGS)
CXXFLAGS += -std=c++17 $(WARNINGS) -Wno-cast-qual $(FLAGS)
CPPFLAGS += -Isrc -D_POSIX_C_SOURCE=200809L -D_DEFAULT_SOURCE \
	-DGLIM_VERSION='"$(VERSION)"' -DGLIM_VERSION_NUMBER=$(VERSION)
LDLIBS   += -lembree3 -lOpenImageIO -lOpenImageIO_Util -lpthread -lm

C_SOURCES   = $(shell find src -name '*.c')
CXX_SOURCES = $(shell find src -name '*.cpp')
OBJECTS = $(C_SOURCES:%.c=$(BUILD)/%.o) $(CXX_SOURCES:%.cpp=$(BUILD)/%.o)
LIBRARY_OBJECTS = $(filter-out $(BUILD)/src/main.o,$(OBJECTS))

all: $(BUILD)/glim ## build build/glim

$(BUILD)/glim: $(BUILD)/src/main.o $(BUILD)/libglim.a
	$(CXX) $(FLAGS) $(LDFLAGS) -o $@ $^ $(LDLIBS)

$(BUILD)/libglim.a: $(LIBRARY_OBJECTS)
	@rm -f $@
	$(AR) rcs $@ $^

$(BUILD)/%.o: %.c
	@mkdir -p $(@D)
	$(CC) $(CPPFLAGS) $(CFLAGS) -MMD -MP -c -o $@ $<

$(BUILD)/%.o: %.cpp
	@mkdir -p $(@D)
	$(CXX) $(CPPFLAGS) $(CXXFLAGS) -isystem /usr/include/Imath -MMD -MP -c -o $@ $<

format: ## rewrite the sources in the project's style
	clang-format -i --style=file:src/.clang-format $(C_SOURCES) \
		$(CXX_SOURCES) $(shell find src tests -name '*.h' -o -name '*.c')

clean: ## remove build/
	rm -rf build

help: ## this list
	@sed -n 's/^\([a-z-]*\):.*## /  make \1\t/p' Makefile | expand -t 24

.PHONY: all format clean help
-include $(OBJECTS:.o=.d)
