# The two commands are `make demo` and `make test`; `make help` lists the rest. All that they need beyond Rust, a C++ compiler
# and Python is pinned in Cargo.lock and requirements.txt, and installed into .venv and target.

PYTHON ?= python3
VENV := .venv
BIN := $(VENV)/bin
PLUGIN := mitsuba_plugin/spherecap/plugins/spherecap.so
LIBRARY := target/release/libspherecap.a
SHARED := target/release/libspherecap.so
ARCHIVE := build/libspherecap.a
HEADERS := $(wildcard include/*.h)
# The releases of Mitsuba that the plugin can be built for beside the pinned one, and one that it must refuse.
OLDER_MITSUBAS := $(shell sed -n 's/^set(mitsubas [^ ]* \(.*\))/\1/p' mitsuba_plugin/CMakeLists.txt)
MITSUBAS := $(patsubst %,.venv-mitsuba-%/installed,$(OLDER_MITSUBAS) 3.6.4)
DXC := .venv-shaders/libdxcompiler_x86_64.so.3.7
C_RENDERER := build/renderer
INLINE_RENDERER := build/renderer_inline
IRRADIANCE := build/irradiance
CPP := $(wildcard mitsuba_plugin/*.cpp mitsuba_plugin/*.h tests/c/*.c tests/c/*.cpp tests/c/*.h tests/install/*.c examples/*.c \
    examples/c/*.c benches/*.c tools/cuda/emulator/*.[ch])

# `make demo SCENE=cut_light VARIANT=scalar_rgb SPP=16`
SCENE ?= cut_light
VARIANT ?= scalar_rgb
SPP ?= 16

# `make shader-picture SHADER=my.comp`
SHADER ?= examples/direct_light.comp

# `make install PREFIX=$HOME/.local`; DESTDIR is put before every path, for packagers.
PREFIX ?= /usr/local
VERSION := $(shell sed -n 's/^version = "\(.*\)"/\1/p' Cargo.toml | head -n 1)
MSRV := $(shell sed -n 's/^rust-version = "\(.*\)"/\1/p' Cargo.toml)
ABI := $(shell sed -n 's/^#define SPHERECAP_ABI //p' include/spherecap.h)
INSTALLED := include/spherecap.h include/spherecap_record.h lib/libspherecap.a lib/libspherecap.so.$(VERSION) lib/libspherecap.so.$(ABI) \
    lib/libspherecap.so lib/pkgconfig/spherecap.pc lib/cmake/spherecap/spherecapConfig.cmake \
    lib/cmake/spherecap/spherecapConfigVersion.cmake

.DEFAULT_GOAL := help
.PHONY: help demo cross lights check test test-rust test-shaders shader-picture shader-cost prepare-test-python test-python \
    test-mitsubas cuda-check test-long lint format build library install uninstall wheel doc package msrv aarch64 valgrind \
    header shaders accuracy hashes bench instructions bench-inline report speed speed-page fits picture notebook clean FORCE

help: ## List the targets.
	@grep -hE '^[a-z0-9-]+:.*## ' $(MAKEFILE_LIST) | sed 's/:.*## /\t/' | expand -t 14

demo: build ## Render SCENE with `area` and with `spherecap`; print a table, save a picture below out/.
	PYTHONPATH=mitsuba_plugin $(BIN)/python tools/demo.py --scene $(SCENE) --variant $(VARIANT) --spp $(SPP)

# Two of them at a time: one downloads while another compiles.
cross: ## Compare several renderers.
	$(MAKE) --jobs=2 build $(C_RENDERER) $(IRRADIANCE) .venv-luxcore/installed .venv-cycles/installed
	PYTHONPATH=tools:mitsuba_plugin $(BIN)/python -m cross

lights: build ## What the choice among several lights gains: a table of equal-time ratios.
	PYTHONPATH=mitsuba_plugin $(BIN)/python tools/many_lights.py

# What cargo makes for it is kept apart from the release, by file and in small pieces: of an edited kernel, only the pieces that use
# it are compiled again.
check: lint ## Formatting, warnings and the tests of the kernels with fewer inputs: less than a minute.
	SPHERECAP_TESTS=quick cargo test --profile quick --locked --lib --test header --test kernels

# What Python's tests need is built while Rust's tests run.
test: lint ## Run all tests.
	$(MAKE) --jobs=2 --output-sync test-rust prepare-test-python
	$(MAKE) package test-python

test-rust: ## The library and its C ABI.
	cargo test --release --locked -- --show-output

prepare-test-python: build $(C_RENDERER) $(INLINE_RENDERER) $(IRRADIANCE)

# Several files at a time, as compiling kernels and starting programs leaves processors idle; more than four would want much memory.
test-python: prepare-test-python ## The fits, the plugin and the renders.
	PYTHONPATH=mitsuba_plugin $(BIN)/python -m pytest --numprocesses=auto --maxprocesses=4 --dist=loadfile tests

lint: $(VENV)/installed doc ## Formatting and warnings, as errors.
	cargo fmt --check -- tools/cross/irradiance.rs
	cargo clippy --release --locked --all-targets -- -D warnings
	$(BIN)/ruff check
	$(BIN)/ruff format --check
	$(BIN)/clang-format --dry-run -Werror $(CPP)

format: $(VENV)/installed ## Format all sources.
	cargo fmt -- tools/cross/irradiance.rs
	$(BIN)/ruff check --fix
	$(BIN)/ruff format
	$(BIN)/clang-format -i $(CPP)

build: $(PLUGIN) ## The static library and the Mitsuba plugin.

$(LIBRARY): FORCE
	cargo build --release --locked

# Ninja and rustc would look for the jobserver of a make that runs several jobs, which is for sub-makes alone: MAKEFLAGS is not
# for them.
$(PLUGIN): $(LIBRARY) $(VENV)/installed $(HEADERS) $(wildcard mitsuba_plugin/*.* mitsuba_plugin/spherecap/cmake/*)
	$(BIN)/cmake -S mitsuba_plugin -B build -G Ninja -DCMAKE_BUILD_TYPE=Release \
	    -DCMAKE_MAKE_PROGRAM="$(CURDIR)/$(BIN)/ninja" -DMitsubaWheel_PYTHON="$(CURDIR)/$(BIN)/python" \
	    -DSPHERECAP_LIBRARY="$(CURDIR)/$(LIBRARY)"
	@echo "Compiling the emitter for all variants of Mitsuba: a minute or two, without a word in between."
	MAKEFLAGS= $(BIN)/cmake --build build
	touch $@

$(C_RENDERER): tests/c/renderer.c include/spherecap.h $(LIBRARY)
	mkdir -p $(@D)
	$(CC) -std=c99 -O2 -Wall -Wextra -Werror -pedantic -Iinclude $< $(LIBRARY) -lpthread -ldl -lm -o $@

# The same by the inline header, without the library.
$(INLINE_RENDERER): tests/c/renderer.c shaders/spherecap_inline.h
	mkdir -p $(@D)
	$(CC) -std=c99 -O2 -Wall -Wextra -Werror -Wno-unused-function -pedantic -DSPHERECAP_INLINE -Ishaders $< -lm -o $@

# Not by cargo, which would compile everything that the tests need for it, too.
$(IRRADIANCE): tools/cross/irradiance.rs $(LIBRARY)
	mkdir -p $(@D)
	MAKEFLAGS= rustc --edition 2021 -D warnings -O -C panic=abort -L dependency=target/release/deps --extern spherecap=target/release/libspherecap.rlib \
	    $< -o $@

# The other renderers are large, and want other versions of the same packages: each has an environment of its own.
.venv-%/installed: tools/cross/requirements-%.txt
	$(PYTHON) -m venv .venv-$*
	@echo "Installing $* into .venv-$*: a large download."
	@.venv-$*/bin/python -m pip install --quiet --disable-pip-version-check -r $< || { \
	    echo "$* cannot be installed for $$($(PYTHON) --version): CPython 3.11 is what both renderers have packages" \
	    "for; try again with \`make PYTHON=python3.11\`" >&2; exit 1; }
	touch $@

$(VENV)/installed: requirements.txt
	$(PYTHON) -m venv $(VENV)
	@echo "Installing Mitsuba, LLVM and the rest of requirements.txt into $(VENV): a large download, a minute or two."
	@$(BIN)/python -m pip install --quiet --disable-pip-version-check -r requirements.txt
	touch $@

library: $(ARCHIVE) $(SHARED) ## The C library alone, static and shared.

# What Rust makes carries the standard library whole, with its debug information and the bitcode of its compiler: twenty times as
# much as what the headers' functions reach, with names that would meet those of other libraries in Rust, and calls of glibc's
# that linkers warn of in static programs.
$(ARCHIVE): $(LIBRARY) $(HEADERS)
	mkdir -p $(@D)
	$(LD) -r --gc-sections $$(sed -n 's/^[a-z].*\b\(spherecap_[a-z0-9_]*\)(.*/--undefined=\1/p' $(HEADERS)) $< -o $(@:.a=.o)
	objcopy --strip-unneeded --wildcard --remove-section='.llvm*' --keep-global-symbol='spherecap_*' $(@:.a=.o)
	rm -f $@
	$(AR) rcs $@ $(@:.a=.o)

# Programs ask the loader for the ABI's number, which changes when they have to be compiled again.
$(SHARED): FORCE
	cargo rustc --release --locked --lib --crate-type cdylib -- -C strip=symbols -C link-arg=-Wl,-soname,libspherecap.so.$(ABI)

install: library ## Install the C library below PREFIX (/usr/local), with pkg-config file and CMake package.
	install -d $(foreach file,$(INSTALLED),"$(DESTDIR)$(PREFIX)/$(dir $(file))")
	install -m 644 include/spherecap.h include/spherecap_record.h "$(DESTDIR)$(PREFIX)/include"
	install -m 644 $(ARCHIVE) "$(DESTDIR)$(PREFIX)/lib"
	install -m 755 $(SHARED) "$(DESTDIR)$(PREFIX)/lib/libspherecap.so.$(VERSION)"
	ln -sf libspherecap.so.$(VERSION) "$(DESTDIR)$(PREFIX)/lib/libspherecap.so.$(ABI)"
	ln -sf libspherecap.so.$(ABI) "$(DESTDIR)$(PREFIX)/lib/libspherecap.so"
	for file in pkgconfig/spherecap.pc cmake/spherecap/spherecapConfig.cmake cmake/spherecap/spherecapConfigVersion.cmake; do \
	    sed 's/@VERSION@/$(VERSION)/; s/@ABI@/$(ABI)/' packaging/$${file##*/}.in > "$(DESTDIR)$(PREFIX)/lib/$$file" || exit 1; \
	done

uninstall: ## Remove what `make install` installed.
	rm -f $(foreach file,$(INSTALLED),"$(DESTDIR)$(PREFIX)/$(file)")
	-rmdir "$(DESTDIR)$(PREFIX)/lib/cmake/spherecap"

wheel: $(VENV)/installed ## The Python package as a source archive and as a wheel that is built from it, in dist/.
	MAKEFLAGS= $(BIN)/python packaging/wheel.py dist

doc: ## The documentation of the crate, in target/doc/spherecap.
	RUSTDOCFLAGS="-D warnings" cargo doc --release --locked --no-deps

package: ## Is the crate complete as it would be published?
	cargo package --locked --allow-dirty

msrv: ## Compile the library with the oldest Rust that Cargo.toml promises; needs rustup, which fetches it.
	rustup toolchain install $(MSRV) --profile minimal
	cargo +$(MSRV) check --locked --lib --target-dir target/msrv

aarch64: ## Compile the library for ARM; needs rustup, which fetches the standard library for it.
	rustup target add aarch64-unknown-linux-gnu
	cargo build --release --locked --lib --target aarch64-unknown-linux-gnu

valgrind: $(LIBRARY) ## Run the C programs of tests and examples under valgrind, which has to be installed.
	tests/c/valgrind.sh

header: ## Remake the headers in include from src/ffi.
	SPHERECAP_WRITE_HEADER=1 cargo test --release --locked --test header

shaders: ## Remake the kernels as source of other languages, in shaders.
	SPHERECAP_WRITE_SHADERS=1 cargo test --release --locked --lib source

accuracy: ## Remake docs/accuracy.md from what the kernels give.
	SPHERECAP_WRITE_ACCURACY=1 cargo test --release --locked --test kernels accuracy

bench: ## What sampling costs, beside solid angles and the published method; also as out/bench.json.
	cargo bench --locked --bench cost

instructions: ## How many instructions sampling takes; also as out/instructions.json.
	cargo bench --locked --bench instructions

bench-inline: ## What sampling by the inline header costs in C, beside Rust: instructions and times.
	cargo bench --locked --bench inline

report: build out/bench.json out/instructions.json out/maps.json ## Speed against error, as report/index.html: about ten minutes.
	PYTHONPATH=tools:mitsuba_plugin $(BIN)/python -m report

# Everything anew, whatever is there.
speed: build ## Measure for docs/speed.md and the README, on an idle machine, and write both: some eight minutes.
	@echo "Times, instructions and maps of errors: some six minutes."
	cargo bench --locked --bench cost
	cargo bench --locked --bench instructions
	cargo bench --locked --bench maps
	PYTHONPATH=tools:mitsuba_plugin $(BIN)/python -m report.speed_page --measure

speed-page: build ## Write docs/speed.md and the README's figures from what was measured.
	PYTHONPATH=tools:mitsuba_plugin $(BIN)/python -m report.speed_page

# Remade where they are older than what they measure.
out/bench.json out/instructions.json out/maps.json: out/%.json: Cargo.toml Cargo.lock $(shell find src benches -name '*.rs')
	cargo bench --locked --bench $(if $(filter bench,$*),cost,$*)

test-mitsubas: build $(MITSUBAS) ## The plugin with other releases of Mitsuba: large downloads.
	for mitsuba in $(OLDER_MITSUBAS); do \
	    MAKEFLAGS= .venv-mitsuba-$$mitsuba/bin/python -m pip install --quiet --disable-pip-version-check \
	        --no-build-isolation . || exit 1; \
	done
	$(BIN)/python -m pytest tests/mitsubas/smoke.py

.venv-mitsuba-%/installed: requirements.txt mitsuba_plugin/spherecap/cmake/FindMitsubaWheel.cmake
	$(PYTHON) -m venv .venv-mitsuba-$*
	@echo "Installing Mitsuba $* into .venv-mitsuba-$*: a large download."
	@.venv-mitsuba-$*/bin/python -m pip install --quiet --disable-pip-version-check mitsuba==$* \
	    $$(sed -n 's/.*"$*=\([0-9.]*\)".*/nanobind==\1/p' mitsuba_plugin/spherecap/cmake/FindMitsubaWheel.cmake) \
	    $$(grep -E '^(scikit-build-core|karellen-llvm-core|cmake|ninja|numpy|tqdm)==' requirements.txt) || { \
	    echo "Mitsuba $* cannot be installed for $$($(PYTHON) --version): all releases have packages for CPython 3.11; try" \
	    "again with \`make PYTHON=python3.11 test-mitsubas\`" >&2; exit 1; }
	touch $@

test-shaders: .venv-shaders/installed $(DXC) ## Run the shaders on a Vulkan device; needs one, glslang-tools and spirv-tools.
	cargo test --release --locked --test source
	.venv-shaders/bin/python -m pytest tests/shaders/executed.py -s

shader-picture: .venv-shaders/installed ## Render SHADER on a Vulkan device, as out/shader.png.
	mkdir -p out
	.venv-shaders/bin/python tests/shaders/picture.py $(SHADER) out/shader.png

shader-cost: .venv-shaders/installed ## What sampling costs in GLSL on AMD's Navi 21, which need not be there: instructions and registers.
	.venv-shaders/bin/python tests/shaders/cost.py

# DXC comes within a source archive (67 MB) of a package whose other parts would have to be compiled.
$(DXC): | .venv-shaders/installed
	@echo "Downloading DXC: 67 MB."
	@.venv-shaders/bin/python -m pip download --quiet --disable-pip-version-check --no-deps --no-binary :all: \
	    --dest $(@D) compushady==0.17.5
	tar -xzf $(@D)/compushady-0.17.5.tar.gz -C $(@D) --strip-components=3 compushady-0.17.5/compushady/backends/$(@F)
	rm $(@D)/compushady-0.17.5.tar.gz
	touch $@

.venv-shaders/installed: tests/shaders/requirements.txt
	$(PYTHON) -m venv .venv-shaders
	.venv-shaders/bin/python -m pip install --quiet --disable-pip-version-check -r $<
	touch $@

cuda-check: build library ## Pack .cuda/, which checks the CUDA variants on a machine with a GPU.
	tools/cuda/prepare

hashes: ## Remake tests/data/hashes.txt from what the kernels give, where formulas changed.
	SPHERECAP_WRITE_HASHES=1 cargo test --release --locked --lib hashes

test-long: ## The random tests and the hashes, with many more inputs than in `make test`: about ten minutes.
	SPHERECAP_TESTS=long cargo test --release --locked --lib hashes
	SPHERECAP_TESTS=long cargo test --release --locked --test kernels -- strata:: approximate::
	SPHERECAP_TESTS=long cargo test --release --locked --test c_abi numbers_of_every_kind

fits: $(VENV)/installed ## Remake the fitted constants in src/fits.rs.
	$(BIN)/python -m fits

picture: build ## Remake the picture of the README.
	PYTHONPATH=mitsuba_plugin $(BIN)/python tools/demo.py --scene cut_light --spp 4 --width 160 --picture docs/cut_light.png

notebook: build ## Run the cells of docs/tutorial.ipynb, and store what they show.
	PYTHONPATH=mitsuba_plugin $(BIN)/python tools/notebook.py docs/tutorial.ipynb

clean: ## Remove all that was built, rendered and installed here.
	rm -rf target build dist out report .cuda $(VENV) .venv-luxcore .venv-cycles .venv-shaders .venv-mitsuba-* \
	    mitsuba_plugin/spherecap/plugins

FORCE:
