"""themes.py - the colours of figures can be read: contrast as WCAG 2 defines it, computed here."""
import subprocess

from check import Checks

checks = Checks("themes of figures")
LEGIBLE = 4.5
TEXT = ("ink", "grey", "blue", "orange", "green", "pink")


def colors_of(theme):
    """The names of the colours in common/figure/plot.gp, read by gnuplot itself."""
    names = (*TEXT, "background", "surface", "faint")
    words = "; ".join(f'print "{name} ".{name}' for name in names)
    done = subprocess.run(["gnuplot", "-e", f"name='none'; format='txt'; theme='{theme}'; load 'common/figure/plot.gp'; {words}"],
                          capture_output=True, text=True, check=True, timeout=60)
    return dict(line.split() for line in done.stderr.splitlines())


def luminance(color):
    """Relative luminance of '#rrggbb'."""
    channels = [int(color[i:i + 2], 16) / 255 for i in (1, 3, 5)]
    linear = [x / 12.92 if x <= 0.04045 else ((x + 0.055) / 1.055) ** 2.4 for x in channels]
    return 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]


def contrast(a, b):
    light, dark = sorted((luminance(a), luminance(b)), reverse=True)
    return (light + 0.05) / (dark + 0.05)


checks.that("black on white is 21 to 1", abs(contrast("#000000", "#ffffff") - 21) < 1e-9)
checks.that("#777777 on white just fails", 4.47 < contrast("#777777", "#ffffff") < 4.49)
for theme in ("light", "dark"):
    colors = colors_of(theme)
    for name in TEXT:
        for ground in ("background", "surface"):
            ratio = contrast(colors[name], colors[ground])
            checks.that(f"{theme}: {name} can be read on {ground}", ratio >= LEGIBLE,
                        f"{colors[name]} on {colors[ground]} is {ratio:.2f} to 1")
    hues = [colors[name] for name in TEXT]
    checks.that(f"{theme}: no two colours are one", len(set(hues)) == len(hues))
checks.end()
