# The two commands of a fresh machine are `make run` and `make test`; both install what they need first.
include packaging/packages.mk
FUZZ_SECONDS ?= 600
# ON: a warning ends the build. CI sets it; who builds from source with another compiler is not to be stopped.
WERROR ?= OFF

.PHONY: build program run test test-kernel test-qgis verify validate bench docs package test-package release soak asan tsan fuzz tidy format clean \
  setup setup-test

setup:
	$(call install,$(BUILD_PACKAGES) $(NODE_PACKAGES))

setup-test: setup
	$(call install,$(TEST_PACKAGES))

# A whole build compiles several files at once, which takes half the time (CONTRIBUTING says how to build while editing).
build: setup
	@cmake --preset release -DTALUS_TESTS=OFF -DTALUS_UNITY=ON -DTALUS_WERROR=$(WERROR) >/dev/null && cmake --build --preset release

# The program alone, without the Python package.
program: setup
	@cmake --preset release -DTALUS_TESTS=OFF -DTALUS_UNITY=ON -DTALUS_WERROR=$(WERROR) >/dev/null && cmake --build --preset release --target talus_cli

run: program
	@build/talus run examples/tutorial-1/tutorial-1-2d.toml -o out/tutorial-1-2d
	@build/talus run examples/tutorial-1/tutorial-1-3d.toml -o out/tutorial-1-3d
	@echo "Open out/tutorial-1-2d/report.html and out/tutorial-1-3d/report.html in a browser."

test: setup-test
	@cmake --preset release -DTALUS_TESTS=ON -DTALUS_UNITY=ON -DTALUS_WERROR=$(WERROR) >/dev/null && bench/build.py test cmake --build --preset release
	@ctest --preset release

# While editing the kernel: builds what its tests need, file by file, and runs them.
test-kernel: setup-test
	@cmake --preset release -B build-kernel -DTALUS_TESTS=ON -DTALUS_UNITY=OFF -DTALUS_WERROR=$(WERROR) >/dev/null && \
	  cmake --build build-kernel --target talus_kernel_tests
	@ctest --test-dir build-kernel -L kernel -j2 --output-on-failure

verify: program
	@build/talus verify

# Field experiments, a few minutes. The results must be those that docs/validation.md gives.
validate: program
	@build/talus validate -o out/validation
	@for f in validation/*/results.csv; do diff $$f out/$$f || exit 1; done

bench: setup
	@cmake --preset bench -DTALUS_UNITY=ON -DTALUS_WERROR=$(WERROR) >/dev/null && cmake --build --preset bench
	@bench/run-all build-bench

asan: setup-test
	@cmake --preset asan-ubsan -DTALUS_UNITY=ON -DTALUS_WERROR=$(WERROR) -DTALUS_TEST_FOLDERS="$(TEST_FOLDERS)" >/dev/null && cmake --build --preset asan-ubsan && ctest --preset asan-ubsan

tsan: setup-test
	@cmake --preset tsan -DTALUS_UNITY=ON -DTALUS_WERROR=$(WERROR) -DTALUS_TEST_FOLDERS="$(TEST_FOLDERS)" >/dev/null && cmake --build --preset tsan && ctest --preset tsan

# The QGIS plugin, in a QGIS without a window.
test-qgis: program
	$(call install,$(QGIS_PACKAGES))
	@TALUS_PROGRAM=build/talus QT_QPA_PLATFORM=offscreen PYTHONDONTWRITEBYTECODE=1 \
	  /usr/bin/python3 -m unittest discover -s qgis/tests

# The site of the documentation, for reading without a network.
docs: setup
	$(call install,$(DOCS_PACKAGES))
	@[ -d web/node_modules/katex ] || npm ci --prefix web --ignore-scripts --no-audit --no-fund --loglevel=error
	@rm -rf build-docs && sphinx-build -q -W --keep-going -b html -c docs/site -d build-docs/doctrees . build-docs/html
	@python3 docs/site/check.py build-docs/html

# Debian packages, an archive of the program with all its libraries, and one of the source: build/packages.
package: setup
	$(call install,$(PACK_PACKAGES))
	@cmake --preset release -DTALUS_TESTS=OFF -DTALUS_UNITY=ON -DTALUS_WERROR=$(WERROR) --no-warn-unused-cli \
	  -DTALUS_PYTHON_DIR=lib/python3/dist-packages >/dev/null && cmake --build --preset release --target all talus_bundled
	@packaging/package build/packages

# The packages in a fresh Debian 12 and the archive in another folder, as their users have them. Needs root.
test-package: package
	$(call install,mmdebstrap)
	@packaging/test build/packages

# A release is a tag on a commit for which everything holds: make release VERSION=1.2.3.
release: setup-test
	@packaging/release "$(VERSION)"

# Hostile bytes for every reader, each for FUZZ_SECONDS.
fuzz: setup
	$(call install,$(FUZZ_PACKAGES))
	@cmake --preset fuzz >/dev/null && cmake --build --preset fuzz
	@fuzz/run build-fuzz $(FUZZ_SECONDS)

# Random rocks on random ground by the hundred thousand, 2,000 random projects, and calibrations of a hundred synthetic
# sites.
soak: setup-test
	@cmake --preset release -DTALUS_TESTS=ON -DTALUS_UNITY=ON -DTALUS_WERROR=$(WERROR) >/dev/null && cmake --build --preset release
	@TALUS_TEST_EFFORT=50 build/talus_kernel_tests --gtest_filter='*RandomRocks*:RandomBlocks*'
	@TALUS_TEST_EFFORT=50 build/talus_tests --gtest_filter='*RandomProjects*:*CalibrationCoverage*:Kinds*'

clean:
	rm -rf build build-* out

format: ; @git ls-files '*.cpp' '*.hpp' | xargs clang-format -i

tidy: setup-test
	@cmake -S . -B build-tidy -G Ninja -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON -DCMAKE_EXPORT_COMPILE_COMMANDS=ON >/dev/null
	@git ls-files 'src/talus/*.cpp' | xargs -P 2 -n 4 clang-tidy -p build-tidy --quiet
