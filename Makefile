# Two commands do everything: `make run` and `make test`. `make help` lists the rest.
# All caches stay inside the clone, so that nothing is written elsewhere.

SHELL := /bin/bash
.SHELLFLAGS := -eu -o pipefail -c
.DELETE_ON_ERROR:
.DEFAULT_GOAL := help

PYTHON ?= python3
BIN := .venv/bin
CACHE := $(CURDIR)/.cache
export PIP_CACHE_DIR := $(CACHE)/pip
export PIP_DISABLE_PIP_VERSION_CHECK := 1
export npm_config_cache := $(CACHE)/npm
export npm_config_update_notifier := false
export PYTHONDONTWRITEBYTECODE :=
export PATH := $(CURDIR)/.venv/bin:$(PATH)
# Two test processes share the processors; threads for each would only wait for each other.
test test-long: export OPENBLAS_NUM_THREADS := 1

FRONT_END := $(shell find static/src static/scripts -type f -not -name tokens.css -not -name api-types.ts 2>/dev/null) \
	static/vite.config.ts static/tsconfig.json
PIP := $(BIN)/python -m pip install -q -c constraints.txt

.PHONY: help
help: ## List the commands
	@awk -F ':.*## ' '/^[a-z-]+:.*## / {printf "  make %-10s %s\n", $$1, $$2}' $(MAKEFILE_LIST)

.PHONY: run
run: .venv/.run-ready static/dist/.ready ## Prepare everything and serve on http://127.0.0.1:8000
	@$(BIN)/manner prepare
	@exec $(BIN)/manner serve

.PHONY: dev
dev: .venv/.run-ready static/dist/.ready ## Serve with reload, front end rebuilt on change
	@$(BIN)/manner prepare
	@trap 'kill 0' EXIT; (cd static && npm run -s dev) & $(BIN)/manner serve --reload

.PHONY: test
test: .venv/.test-ready static/dist/.ready browser ## Lint, types, front-end tests, and the test suite on SQLite, PostgreSQL and Chromium
	@$(MAKE) --no-print-directory -j2 lint test-front-end
	@HOME=$(CACHE)/home $(BIN)/python -m pytest -n 2 --dist worksteal -m 'not long' $(PYTEST_ARGS)

.PHONY: test-long
test-long: .venv/.test-ready static/dist/.ready browser ## Run every template in every size and language as well
	@HOME=$(CACHE)/home $(BIN)/python -m pytest -n 2 --dist worksteal -m long $(PYTEST_ARGS)

.PHONY: test-front-end
test-front-end: static/dist/.ready
	@cd static && npm test --silent

.PHONY: lint lint-python lint-front-end
lint: lint-python lint-front-end ## Formatting, style, types and import directions

lint-python: .venv/.test-ready
	@$(BIN)/ruff format --check -q . && $(BIN)/ruff check -q .
	@$(BIN)/mypy
	@$(BIN)/lint-imports

lint-front-end: .venv/.test-ready static/dist/.ready
	@cd static && npm run -s check

.PHONY: format
format: .venv/.test-ready ## Format the Python code and mend what can be mended
	@$(BIN)/ruff format -q . && $(BIN)/ruff check -q --fix .

.PHONY: messages
messages: .venv/.run-ready ## Bring the translations' catalogs up to date with the pages
	@$(BIN)/python -m app.messages

.PHONY: bench
bench: .venv/.bench-ready static/dist/.ready browser ## Measure speed beside peers: one table
	@HOME=$(CACHE)/home $(BIN)/python -m tests.bench $(BENCH_ARGS)

.PHONY: pictures
pictures: .venv/.test-ready static/dist/.ready browser ## Take the documentation's pictures anew
	@HOME=$(CACHE)/home $(BIN)/python -m tests.support.pictures

.PHONY: clean
clean: ## Remove what was built and installed; the data folder stays
	rm -rf .venv .cache static/dist static/node_modules build *.egg-info .mypy_cache .ruff_cache \
		.pytest_cache .hypothesis .import_linter_cache
	find . -name __pycache__ -type d -prune -exec rm -rf {} +

# --- what the commands stand on ---------------------------------------------------------------

.venv/bin/python:
	@$(PYTHON) -c 'import sys; sys.exit(sys.version_info < (3, 11))' 2>/dev/null || \
		{ echo "Manner needs Python 3.11 or newer. On Debian: sudo apt-get install python3" >&2; exit 1; }
	@$(PYTHON) -c 'import ensurepip, venv' 2>/dev/null || \
		{ echo "Python's venv is missing. On Debian: sudo apt-get install python3-venv" >&2; exit 1; }
	@echo "Making the virtual environment"
	@$(PYTHON) -m venv .venv

.venv/.run-ready: pyproject.toml constraints.txt | .venv/bin/python
	@echo "Installing the server's packages"
	@$(PIP) -e .
	@touch $@

.venv/.test-ready: .venv/.run-ready
	@echo "Installing what tests need"
	@$(PIP) -e '.[dev]'
	@touch $@

.venv/.bench-ready: .venv/.test-ready
	@$(PIP) -e '.[bench]'
	@touch $@

# A Node of 20.19 or newer is used where there is one; otherwise the wheel brings it.
.venv/.node-ready: | .venv/.run-ready
	@node -e 'const [a, b] = process.versions.node.split("."); process.exit(+a > 20 || (+a === 20 && +b >= 19) ? 0 : 1)' 2>/dev/null \
		&& npm --version >/dev/null 2>&1 || { echo "Installing Node from its wheel"; $(PIP) -e '.[node]'; }
	@touch $@

static/node_modules/.ready: static/package-lock.json static/package.json .venv/.node-ready
	@echo "Installing the front end's packages"
	@cd static && npm ci --loglevel error --no-audit --no-fund
	@touch $@

static/dist/.ready: static/node_modules/.ready $(FRONT_END)
	@echo "Building the front end"
	@cd static && npm run -s build -- --logLevel warn
	@touch $@

.PHONY: browser
browser:
	@mkdir -p $(CACHE)/home
	@command -v chromium chromium-browser google-chrome >/dev/null || { \
		echo "Installing Chromium for the browser tests"; \
		sudo=$$([ $$(id -u) = 0 ] || echo sudo); \
		$$sudo apt-get update -q >/dev/null && $$sudo apt-get install -qy --no-install-recommends chromium >/dev/null; } || \
		{ echo "Chromium is missing. On Debian: sudo apt-get install chromium" >&2; exit 1; }
