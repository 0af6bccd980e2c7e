// laws-colors.c - laws of the colours for a display: they fit, and the display shows them as
// intended.
#include "tests/07-shading/laws.h"

#include "tests/judge/reference/distinct_digits.h"

static const double enough = 1e-8;

static const char *const names[] = {"red", "green", "blue"};

void law_clamp_color(Color yours, Color color)
{
    for (int i = 0; i < 3; i++) {
        bool fits = color[i] >= 0 && color[i] <= 1;
        if (!(yours[i] >= -enough && yours[i] <= 1 + enough))
            law_broken("your %s is %s; it must be at least 0 and at most 1", names[i],
                       number_text(yours[i]).s);
        else if (fits && !(fabs(yours[i] - color[i]) <= enough))
            law_broken("your %s is %s; it was %s, between 0 and 1, and must not change", names[i],
                       apart(yours[i], color[i]).yours.s, apart(yours[i], color[i]).right.s);
        else if (!fits && !(fabs(yours[i] - (color[i] > 1)) <= enough))
            law_broken("your %s is %s; it was %s, and %d is the nearest value that fits", names[i],
                       number_text(yours[i]).s, number_text(color[i]).s, color[i] > 1);
        else
            continue;
        return;
    }
}

void law_gamma_encode(Color yours, Color color, double gamma)
{
    for (int i = 0; i < 3; i++) {
        double shown = pow(yours[i], gamma);
        if (yours[i] >= -enough &&
            (fabs(yours[i]) <= enough ? color[i] <= 1e-4 : fabs(shown - color[i]) <= enough))
            continue;
        Apart a = apart(shown, color[i]);
        if (!(yours[i] >= 0 && isfinite(yours[i])))
            law_broken("your %s is %s, which no display can show", names[i],
                       number_text(yours[i]).s);
        else
            law_broken("your %s is %s: the display raises it to the power of gamma, which gives "
                       "%s, but it should give %s",
                       names[i], number_text(yours[i]).s, a.yours.s, a.right.s);
        return;
    }
}
