# The two commands are `make demo` and `make test`; `make help` lists the rest. All that they need beyond Rust, a C++ compiler
# and Python is pinned in Cargo.lock and requirements.txt, and installed into .venv and target.

PYTHON ?= python3
VENV := .venv
BIN := $(VENV)/bin
PLUGIN := mitsuba_plugin/spherecap/plugins/spherecap.so
LIBRARY := target/release/libspherecap.a
CPP := $(wildcard mitsuba_plugin/*.cpp mitsuba_plugin/*.h tests/c/*.c tests/c/*.cpp tests/c/*.h examples/*.c)

# `make demo SCENE=cut_light VARIANT=scalar_rgb SPP=16`
SCENE ?= cut_light
VARIANT ?= scalar_rgb
SPP ?= 16

.DEFAULT_GOAL := help
.PHONY: help demo test test-rust test-python test-long lint format build header accuracy bench instructions fits picture clean FORCE

help: ## List the targets.
	@grep -hE '^[a-z-]+:.*## ' $(MAKEFILE_LIST) | sed 's/:.*## /\t/' | expand -t 14

demo: build ## Render SCENE with `area` and with `spherecap`; print a table, save a picture below out/.
	PYTHONPATH=mitsuba_plugin $(BIN)/python tools/demo.py --scene $(SCENE) --variant $(VARIANT) --spp $(SPP)

test: lint test-rust test-python ## Run all tests.

test-rust: ## The library and its C ABI.
	cargo test --release --locked -- --show-output

test-python: build ## The fits, the plugin and the renders.
	PYTHONPATH=mitsuba_plugin $(BIN)/python -m pytest tests

lint: $(VENV)/installed ## Formatting and warnings, as errors.
	cargo fmt --check
	cargo clippy --release --locked --all-targets -- -D warnings
	$(BIN)/ruff check
	$(BIN)/ruff format --check
	$(BIN)/clang-format --dry-run -Werror $(CPP)

format: $(VENV)/installed ## Format all sources.
	cargo fmt
	$(BIN)/ruff check --fix
	$(BIN)/ruff format
	$(BIN)/clang-format -i $(CPP)

build: $(PLUGIN) ## The static library and the Mitsuba plugin.

$(LIBRARY): FORCE
	cargo build --release --locked

$(PLUGIN): $(LIBRARY) $(VENV)/installed include/spherecap.h $(wildcard mitsuba_plugin/*.* mitsuba_plugin/cmake/*)
	$(BIN)/cmake -S mitsuba_plugin -B build -G Ninja -DCMAKE_BUILD_TYPE=Release \
	    -DCMAKE_MAKE_PROGRAM=$(abspath $(BIN)/ninja) -DMitsubaWheel_PYTHON=$(abspath $(BIN)/python) -DSPHERECAP_LIBRARY=$(abspath $(LIBRARY))
	$(BIN)/cmake --build build
	touch $@

$(VENV)/installed: requirements.txt
	$(PYTHON) -m venv $(VENV)
	$(BIN)/python -m pip install --quiet --disable-pip-version-check -r requirements.txt
	touch $@

header: ## Remake include/spherecap.h from src/ffi*.rs.
	SPHERECAP_WRITE_HEADER=1 cargo test --release --locked --test header

accuracy: ## Remake docs/accuracy.md from what the kernels give.
	SPHERECAP_WRITE_ACCURACY=1 cargo test --release --locked --test accuracy

bench: ## What sampling costs, beside solid angles and the published method; also as out/bench.json.
	cargo bench --locked --bench cost

instructions: ## How many instructions sampling takes; needs valgrind.
	cargo bench --locked --bench instructions

test-long: ## The random tests, with many more inputs than in `make test`: about ten minutes.
	PROPTEST_CASES=2000000 cargo test --release --locked --test strata
	SPHERECAP_FUZZ_TRIALS=20000000 cargo test --release --locked --test c_abi numbers_of_every_kind

fits: $(VENV)/installed ## Remake the fitted constants in src/fits.rs.
	$(BIN)/python -m fits

picture: build ## Remake the picture of the README.
	PYTHONPATH=mitsuba_plugin $(BIN)/python tools/demo.py --scene cut_light --spp 4 --width 160 --picture docs/cut_light.png

clean: ## Remove all that was built, rendered and installed here.
	rm -rf target build out $(VENV) mitsuba_plugin/spherecap/plugins

FORCE:
