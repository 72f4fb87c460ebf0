# Needs python3 (3.11 or newer, with venv) and make; everything else is installed into .venv, what
# speed is compared with into .venv-bench.
#   make demo    build the 16/20 bevel pair, straight and spiral, and compare exact with polyhedral properties
#   make test    run the tests
#   make fuzz    feed spoilt files to every reader, FUZZ_SECONDS=60 of them; what breaks one goes into tests/fuzz/corpus
#   make web     build the view that turns in notebooks and the designer page (Node 20.19 or newer, npm)
#   make serve   build them and open the designer page
#   make test-browser    test both in Chromium (CHROMIUM=/path/to/it)
#   make check   lint, format check, types, import layers
#   make bench   compare speed with other tools
#   make interop hold files to CadQuery, build123d (each in an environment of its own), trimesh, lib3mf and admesh

PYTHON ?= python3
VENV := .venv
BIN := $(VENV)/bin
INSTALLED := $(VENV)/installed
BENCH_VENV := .venv-bench
BENCH_INSTALLED := $(BENCH_VENV)/installed
export PIP_DISABLE_PIP_VERSION_CHECK := 1

FUZZ_SECONDS ?= 60
CHROMIUM ?= chromium

.PHONY: demo test fuzz web serve test-browser check bench interop clean
.DELETE_ON_ERROR:

demo: $(INSTALLED)
	$(BIN)/gearwright demo

test: $(INSTALLED)
	$(BIN)/python -m pytest

fuzz: $(INSTALLED)
	FUZZ_SECONDS=$(FUZZ_SECONDS) $(BIN)/python -m pytest tests/fuzz

web:
	@command -v npm >/dev/null || { echo "make: npm was not found; install Node 20.19 or newer" >&2; exit 1; }
	npm --prefix web ci
	npm --prefix web run build

serve: $(INSTALLED) web
	$(BIN)/gearwright serve --open

test-browser: $(INSTALLED) web
	@command -v $(CHROMIUM) >/dev/null || { \
	  echo "make: $(CHROMIUM) was not found; on Debian: apt-get install chromium, or name one: make CHROMIUM=/path" >&2; exit 1; }
	PYTHON=$(abspath $(BIN))/python CHROMIUM=$$(command -v $(CHROMIUM)) npm --prefix web test

check: $(INSTALLED)
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .
	$(BIN)/mypy
	$(BIN)/lint-imports

bench: $(BENCH_INSTALLED)
	@for benchmark in benchmarks/*.py; do echo "== $$benchmark"; $(BENCH_VENV)/bin/python "$$benchmark" || exit 1; done

interop: $(INSTALLED) .venv-cadquery/installed .venv-build123d/installed
	@command -v admesh >/dev/null || { \
	  echo "make: admesh was not found; on Debian and Ubuntu: apt-get install admesh" >&2; exit 1; }
	$(BIN)/python -m pytest interop/test_meshes.py
	.venv-cadquery/bin/python -m pytest interop/test_cadquery.py
	.venv-build123d/bin/python -m pytest interop/test_build123d.py

clean:
	rm -rf $(VENV) $(BENCH_VENV) .venv-cadquery .venv-build123d out

# The stamp is as new as pyproject.toml, so that a second run installs nothing.
$(INSTALLED): pyproject.toml | $(BIN)/python
	$(BIN)/python -m pip install --quiet --editable '.[dev]'
	@touch $@

$(BENCH_INSTALLED): pyproject.toml | $(BIN)/python
	@$(BIN)/python -m venv $(BENCH_VENV)
	$(BENCH_VENV)/bin/python -m pip install --quiet --editable '.[bench]'
	@touch $@

# CadQuery and build123d bring different versions of Open CASCADE.
.venv-cadquery/installed .venv-build123d/installed: .venv-%/installed: pyproject.toml | $(BIN)/python
	@$(BIN)/python -m venv .venv-$*
	.venv-$*/bin/python -m pip install --quiet --editable . $* 'pytest>=8' 'pytest-xdist>=3.6'
	@touch $@

$(BIN)/python:
	@command -v $(PYTHON) >/dev/null || { \
	  echo "make: $(PYTHON) was not found; install Python 3.11 or newer, or name one: make PYTHON=/path/to/python3" >&2; exit 1; }
	@$(PYTHON) -c 'import sys; sys.exit(sys.version_info < (3, 11))' || { \
	  echo "make: Python 3.11 or newer is needed, $(PYTHON) is $$($(PYTHON) -V 2>&1);" >&2; \
	  echo "      name another one: make PYTHON=/path/to/python3.11" >&2; exit 1; }
	@$(PYTHON) -c 'import venv, ensurepip' 2>/dev/null || { \
	  echo "make: $(PYTHON) has no venv module; on Debian and Ubuntu: apt-get install python3-venv" >&2; exit 1; }
	@echo "Making $(VENV) (once) ..." >&2
	@$(PYTHON) -m venv $(VENV)
