"""themes.py - the colours of figures can be read."""
import subprocess

from check import Checks, color, contrast

checks = Checks("themes of figures")
LEGIBLE = 4.5
TEXT = ("ink", "grey", "blue", "orange", "green", "pink")


def colors_of(theme):
    """The names of the colours in common/figure/plot.gp, read by gnuplot itself."""
    names = (*TEXT, "background", "surface", "faint")
    words = "; ".join(f'print "{name} ".{name}' for name in names)
    done = subprocess.run(["gnuplot", "-e", f"name='none'; format='txt'; theme='{theme}'; load 'common/figure/plot.gp'; {words}"],
                          capture_output=True, text=True, check=True, timeout=60)
    return {name: color(code) for name, code in map(str.split, done.stderr.splitlines())}


checks.that("black on white is 21 to 1", abs(contrast((0, 0, 0), (255, 255, 255)) - 21) < 1e-9)
checks.that("#777777 on white just fails", 4.47 < contrast((119, 119, 119), (255, 255, 255)) < 4.49)
for theme in ("light", "dark"):
    colors = colors_of(theme)
    for name in TEXT:
        for ground in ("background", "surface"):
            ratio = contrast(colors[name], colors[ground])
            checks.that(f"{theme}: {name} can be read on {ground}", ratio >= LEGIBLE,
                        f"{colors[name]} on {colors[ground]} is {ratio:.2f} to 1")
    hues = [colors[name] for name in TEXT]
    checks.that(f"{theme}: no two colours are one", len(set(map(tuple, hues))) == len(hues))
checks.end()
