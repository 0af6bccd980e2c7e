"""example_figures.py - the figures of random examples (random_example.py) are clear, in both shapes.

    example_figures.py FIRST COUNT
"""
import sys

from check import SHAPES, Checks, drawn
from random_example import example_number, figures_of

first, count = map(int, sys.argv[1:])
checks = Checks(f"figures of {count} examples from {first} on")
for number in range(first, first + count):
    for line in figures_of(example_number(number)):
        program, figure, *options = line.split()
        for shape in SHAPES:
            drawn(checks, program, figure, options, shape)
checks.end()
