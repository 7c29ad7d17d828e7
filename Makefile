# Two commands do everything on a fresh Debian 12: `make demo` and `make test`. Each sets up what is missing first.

OUT ?= out/demo
SCENES ?= $(wildcard scenes/calibration/*.yaml) $(wildcard scenes/paper/*.yaml)

.PHONY: help setup build demo test bench lint format clean

help:
	@echo 'make demo    set up, build, compare the calibration and paper scenes in both engines, say where the report is'
	@echo 'make test    set up, then every check: C++ tests (release, sanitizers), linters, Python and end-to-end tests'
	@echo 'make bench   measure the tracer'
	@echo 'make lint    check formats, lint and types        make format  let the formatters write'
	@echo 'make clean   remove build/ and out/               make setup   only install what is missing'

setup:
	@tools/setup.sh

build: setup
	@tools/build.sh release vitrail-tracer

# The last lines say the verdicts and where the report is; the exit code is the verdict.
demo: build
	@.venv/bin/vitrail compare $(SCENES) --out $(abspath $(OUT))

test:
	@tools/test.sh

bench: build
	@tools/bench.sh

lint: setup
	@tools/lint.sh

format: setup
	@tools/lint.sh --fix

clean:
	rm -rf build out
