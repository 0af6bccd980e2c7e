#!/bin/sh
# mistaken_figures.sh - the deck's figures with every known mistake (with MISTAKES=10 each tenth).
# Only reads the tree.
set -u
. tests/house/runner/library.sh
once 'mistaken_figures, long' "figures of every known mistake"
MISTAKES=${MISTAKES:-1} counted sh tests/house/mistaken_figures.sh
finish 'mistaken_figures, long'
