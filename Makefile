# `make fit` is the reproducible run; `make help` lists the rest.
CONFIG ?= configs/preetham.toml
PYTHON ?= python3
RUN := .venv/bin/python -m skylight_sh

.PHONY: help fit test conformance bench speed stability lighting fuzz verify machines noise mutants lint reference times clean

help: ## List the targets
	@grep -E '^[a-z]+:.*## ' Makefile | sed -E 's/^([a-z]+):.*## /\1: /' | column -t -s ':' || true

fit: .venv/run.stamp ## Run every stage of CONFIG and print where the report is
	@$(RUN) run $(CONFIG)

test: .venv/dev.stamp ## Run the tests
	@.venv/bin/python -m pytest -n auto --dist loadfile

conformance: .venv/dev.stamp ## Run the tests that need more tools: node, Mono, shader compilers, a browser, clang, an emulator
	@.venv/bin/python -m pytest -m tools -n auto --dist loadfile

bench: .venv/run.stamp ## Measure error against time
	@$(RUN) bench $(CONFIG)

stability: .venv/dev.stamp ## Stress the numerics
	@$(RUN) stability $(CONFIG)

lighting: .venv/run.stamp ## Measure what lit surfaces really lose by the tables of CONFIG; CONFIG=--all: of every shipped config
	@.venv/bin/python -m skylight_sh.studies.lighting $(CONFIG)

fuzz: .venv/run.stamp ## Call headers with 10^7 inputs of any bits each (twenty minutes; needs gcc and clang)
	@.venv/bin/python -m skylight_sh.studies.stability.fuzz 1e7

verify: .venv/run.stamp ## Run the released result's config again and compare every byte
	@$(RUN) verify reports/reference

machines: .venv/run.stamp ## Run CONFIG under many kernels, threads and workers, and compare every byte (ten minutes)
	@.ci/machines $(CONFIG)

noise: .venv/run.stamp ## Run CONFIG on truths with noise, 30 seeds, and compare every byte (ten minutes)
	@.venv/bin/python -m skylight_sh.studies.stability.same_bytes $(CONFIG)

mutants: .venv/dev.stamp ## Change numbers, signs and comparisons of the numerics, and name changes that no test notices (an hour)
	@cd tests && ../.venv/bin/python -m mutants $(MUTANTS)

lint: .venv/dev.stamp ## Check style and types
	@.venv/bin/ruff check . && .venv/bin/ruff format --check . && .venv/bin/mypy

reference: .venv/dev.stamp ## Release the default config's result, a picture of a scene and what the README claims into reports/reference
	@$(RUN) run configs/preetham.toml
	@.venv/bin/python -m skylight_sh.studies.courtyard reports/preetham/export/skylight_sh.npz
	@$(RUN) run configs/preetham.toml >/dev/null
	@$(RUN) run configs/valley.toml >/dev/null
	@mkdir -p reports/reference && find reports/reference -mindepth 1 ! -name speed.json ! -name times.json -delete
	@cd reports/preetham && cp -r export figures errors.csv references.csv summary.json SHA256SUMS index.html ../reference/
	@cp reports/valley/figures/surroundings.png reports/reference/valley.png
	@$(RUN) render courtyard --slices 8 --size 1024x576 --turbidity 2.5 --output reports/reference/day.png
	@.venv/bin/python -m skylight_sh.studies.claims code
	@.venv/bin/python -m skylight_sh.studies.claims measure
	@.venv/bin/python -m skylight_sh.studies.claims write

speed: .venv/run.stamp ## Release what `make bench` has measured of the default config, and write the README's figures
	@.venv/bin/python -m skylight_sh.studies.claims speed reports/preetham/bench
	@.venv/bin/python -m skylight_sh.studies.claims write

times: .venv/run.stamp ## Measure how long each shipped config takes (ten minutes), and write the README's figures
	@.venv/bin/python -m skylight_sh.studies.claims time
	@.venv/bin/python -m skylight_sh.studies.claims write

clean: ## Delete the environment, the store and all runs but the reference
	rm -rf .venv artifacts build dist pipeline/*.egg-info .mypy_cache .ruff_cache .hypothesis
	find reports -mindepth 1 -maxdepth 1 ! -name reference -exec rm -rf {} +
	find . -name __pycache__ -prune -exec rm -rf {} +

.venv/bin/python:
	$(PYTHON) -c 'import sys; sys.exit("Python 3.11 or newer is needed; set PYTHON=...") if sys.version_info < (3, 11) else None'
	$(PYTHON) -m venv .venv

# matplotlib indexes the machine's fonts once, at its first import.
.venv/run.stamp: pyproject.toml setup.py requirements.lock | .venv/bin/python
	.venv/bin/python -m pip install --quiet --disable-pip-version-check -c requirements.lock -e '.[pipeline]'
	.venv/bin/python -c 'import matplotlib.font_manager'
	@touch $@

.venv/dev.stamp: .venv/run.stamp
	.venv/bin/python -m pip install --quiet --disable-pip-version-check -c requirements.lock -e '.[pipeline,dev]'
	.venv/bin/python -m pip install --quiet --disable-pip-version-check --no-deps tests/example_light
	@touch $@
