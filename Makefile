# SPDX-License-Identifier: Apache-2.0
# A thin front for the three things most wanted; all else is CMake (see CONTRIBUTING.md).
.PHONY: run test bench parity build clean

dioptre = build/release/dioptre

# The compiler units of this program need up to half a gigabyte each.
jobs ?= $(shell nproc)

# Builds the program and renders a first picture: build/showcase.png.
run: packages = build
run: tests = OFF
run: packages build
	$(dioptre) +Iexamples/showcase.pov +Obuild/showcase.png +W800 +H600 +A0.3 -D
	@echo "The picture: build/showcase.png"

# Every test there is.
test: packages = build test
test: tests = ON
test: packages build
	ctest --test-dir build/release --output-on-failure --parallel $(jobs)

# Times Dioptre and POV-Ray on the scenes of bench/.
bench: packages = build bench
bench: tests = OFF
bench: packages build
	bench/compare --dioptre $(dioptre)

# Compares the images of POV-Ray's own scenes; writes docs/parity.md.
parity: packages = build test
parity: tests = OFF
parity: packages build
	tools/parity --dioptre $(dioptre) --jobs $(jobs)

packages:
	@tools/install_packages $(packages)

build: packages
	@mkdir -p build
	@cmake --preset release -DDIOPTRE_TESTS=$(tests) > build/configure.log 2>&1 \
	  || { cat build/configure.log; exit 1; }
	cmake --build --preset release --parallel $(jobs)

clean:
	rm -rf build
