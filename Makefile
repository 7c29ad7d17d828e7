# Two commands do everything on a fresh Debian 12: `make demo` and `make test`. Each sets up what is missing first.

OUT ?= out/demo
PRICES ?= out/prices
# What the demo shows: closed forms, the proof for other renderers, and the figures of the paper. Figures 6 and 7 have the views of
# figure 5, and the others here are the dearest. Every scene there is: make demo SCENES=scenes.
DEAR := $(addprefix scenes/calibration/,closed_room.yaml prism_screen.yaml white_furnace.yaml overcast_card.yaml) \
  $(addprefix scenes/,calibration/tinted_pane_projected.yaml paper/figure_6.yaml paper/figure_7.yaml)
SCENES ?= $(filter-out $(DEAR),$(wildcard scenes/calibration/*.yaml scenes/conformance/*.yaml scenes/paper/figure_*.yaml))
ALL := $(foreach folder,calibration conformance paper,$(wildcard scenes/$(folder)/*.yaml))
SLOW := scenes/paper/goblet.yaml scenes/paper/backlit_vase.yaml
AGREEMENT ?= $(abspath out/agreement)
# CPU seconds for all purchases of the demo.
BUDGET_S ?= 60

.PHONY: help setup build demo agreement prices test bench lint format clean

help:
	@echo 'make demo    set up, build, compare the scenes in both engines (5 minutes), say what to open'
	@echo 'make test    set up, then every check: C++ tests (release, sanitizers), linters, Python and end-to-end tests'
	@echo 'make agreement  measure docs/agreement.md again: every scene in both engines (25 CPU minutes)'
	@echo 'make prices  measure again what accuracy costs in both engines, for the four scenes of docs/studies'
	@echo 'make bench   measure the tracer'
	@echo 'make lint    check formats, lint and types        make format  let the formatters write'
	@echo 'make clean   remove build/ and out/               make setup   only install what is missing'

setup:
	@tools/setup.sh

build: setup
	@tools/build.sh release vitrail-tracer

# A line says how close each scene is known to agree, the last one what to open. What is open is no failure of the demo:
# it ends with 0 unless something deviates or fails.
demo: build
	@.venv/bin/vitrail compare $(SCENES) --out $(abspath $(OUT)) --jobs 2 --budget-s $(BUDGET_S) --allow-open

# The goblet and the vase at a price of their own: a draft of each costs as much as twenty other scenes.
# The second round has what the first left of the budget, and knows which purchases lessened noise.
agreement: build
	@.venv/bin/vitrail compare $(filter-out $(SLOW),$(ALL)) --out $(AGREEMENT)/scenes --jobs 2 --picture-width 1 \
	  --rounds 2 --budget-s 400 --allow-open
	@.venv/bin/vitrail compare $(SLOW) --out $(AGREEMENT)/slow --jobs 2 --picture-width 1 --quality draft \
	  --set photons=50000 --rounds 0 --allow-open
	@.venv/bin/vitrail agreement $(AGREEMENT)/scenes $(AGREEMENT)/slow

# A prism takes POV-Ray one run a band, so fewer settings are tried on it.
prices: build
	@.venv/bin/vitrail tradeoff scenes/calibration/ball_lens.yaml --out $(PRICES)/ball_lens --jobs 2
	@.venv/bin/vitrail tradeoff $(addprefix scenes/calibration/,prism_screen.yaml tinted_pane_seen.yaml slab_clear.yaml) \
	  --extent quick --out $(PRICES) --jobs 2

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
