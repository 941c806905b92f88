# SPDX-License-Identifier: BSD-3-Clause
# Each target is one script in tools/; the scripts do the set-up they need by themselves.
.DEFAULT_GOAL := help
.PHONY: help build demo test check verify bench docs package test-fresh format lock clean

help:  ## this list
	@sed -n 's/^\([a-z-]*\):.*##/  make \1\t/p' Makefile | expand -t 18

build:  ## set up the machine and build build/release/bin/percolith
	@tools/build.sh

demo:  ## build, run a well whose pressure splits rock, draw and animate it
	@tools/demo.sh

test:  ## build with warnings as errors; unit, command-line and reference tests, documents, format, fuzzing
	@tools/test.sh

check:  ## clang-tidy, and the tests under the address and undefined-behaviour sanitizers
	@tools/check.sh

verify:  ## compare with all references; CASE=name for one
	@tools/verify.sh $(CASE)

bench:  ## measure, and write build/bench/report.json
	@tools/bench.sh

docs:  ## the documentation as a site that needs no network, build/docs/index.html
	@tools/docs.sh

package:  ## the archive and the wheel of the Python package, installed by itself and tried
	@tools/package.sh

test-fresh:  ## repeat `make demo` and `make test` on a bare Debian 12 (needs root)
	@tools/test_fresh.sh

format:  ## format all C++ sources
	@tools/format.sh --fix

lock:  ## renew the hashed lists of Python packages
	@tools/lock.sh

clean:  ## remove everything that was built, results of the demo included
	rm -rf build
