# What the Makefiles of all samples begin with.
SHELL := bash
.SHELLFLAGS := -euo pipefail -c
.DELETE_ON_ERROR:
.SECONDARY:

# Where the tools are; empty: on the PATH.
BINDIR ?=
ifneq ($(BINDIR),)
export PATH := $(BINDIR):$(PATH)
endif
