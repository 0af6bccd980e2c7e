# tex.awk - makes gnuplot's LaTeX picture one that any document can take in.
#
# Labels as LaTeX writes them (gnuplot leaves them as they are), a background no larger than the
# picture, and the name of the graphics without a folder. words: the figure in words; graphics: name.

# Outside mathematics, gnuplot's own marks: x_1, x^2, {/:Italic x}, {/*0.8 small}.
function text(s,    out, c, part, done)
{
    out = ""
    while (s != "") {
        done = done c
        c = substr(s, 1, 1)
        s = substr(s, 2)
        if (c == "\\") {
            # \small, \%: that is LaTeX already.
            out = out c substr(s, 1, 1)
            s = substr(s, 2)
        } else if (c == "_" && done ~ /[A-Za-z][A-Za-z]$/ && s ~ /^[A-Za-z][A-Za-z]/) {
            out = out "\\_" # of a name, as in upper_left
        } else if (c == "_" || c == "^") {
            part = substr(s, 1, 1)
            if (part == "{")
                part = substr(s, 1, index(s, "}"))
            s = substr(s, length(part) + 1)
            out = out (c == "_" ? "\\textsubscript{" : "\\textsuperscript{") part "}"
        } else if (c == "{" && substr(s, 1, 1) == "/") {
            match(s, /^\/('[^']*')?[^ ]* /)
            part = substr(s, 1, RLENGTH)
            s = substr(s, RLENGTH + 1)
            out = out "{" (part ~ /Italic/ ? "\\itshape " : "") (part ~ /Bold/ ? "\\bfseries " : "") \
                (part ~ /\*0/ ? "\\small " : part ~ /\*/ ? "\\large " : "")
        } else {
            out = out plain(c)
        }
    }
    return replaced(out, "  ", "~ ")
}
function plain(c)
{
    return c ~ /[%&#]/ ? "\\" c : c ~ /[<>|]/ ? "\\ensuremath{" c "}" : c == "~" ? "\\~{}" : c
}
# Not by gsub, for which a backslash is more than itself.
function replaced(s, what, by,    parts, n, i, out)
{
    n = split(s, parts, what)
    out = parts[1]
    for (i = 2; i <= n; i++)
        out = out by parts[i]
    return out
}
# Letters that LaTeX does not know, wherever they are.
function known(s,    i)
{
    for (i = 1; i < letters; i += 2)
        if (index(s, letter[i]))
            s = replaced(s, letter[i], "\\ensuremath{" letter[i + 1] "}")
    return s
}
# Factors stand apart; LaTeX would set d f like the name of one thing.
function mathematics(s)
{
    while (match(s, /[A-Za-z0-9)] [A-Za-z(]/))
        s = substr(s, 1, RSTART) "\\," substr(s, RSTART + 2)
    # Spaces at its ends are spaces.
    if (sub(/^ +/, "", s))
        s = "\\ " s
    if (sub(/ +$/, "", s))
        s = s "\\ "
    return replaced(s, "%", "\\%")
}
function label(s,    parts, n, i, out)
{
    sub(/^¦/, "", s)
    n = split(s, parts, "$")
    out = text(parts[1])
    for (i = 2; i <= n; i++)
        out = out (i % 2 == 0 ? "$" mathematics(parts[i]) "$" : text(parts[i]))
    return known(out)
}
BEGIN {
    letters = split("− - ½ \\frac12 ¼ \\frac14 ⅓ \\frac13 · \\cdot{} × \\times{} ± \\pm{} " \
        "² ^2 ³ ^3 ₀ _0 ₁ _1 ₂ _2 ′ ^\\prime ° ^\\circ √ \\surd{} … \\ldots{} ∞ \\infty{} " \
        "≤ \\le{} ≥ \\ge{} ≠ \\ne{} ≈ \\approx{} ∈ \\in{} ⟂ \\perp{} • \\bullet{} " \
        "→ \\to{} ← \\leftarrow{} ↑ \\uparrow{} ↓ \\downarrow{} ⇒ \\Rightarrow{} " \
        "Δ \\Delta{} α \\alpha{} β \\beta{} θ \\theta{} λ \\lambda{} π \\pi{} φ \\varphi{}", letter, " ")
    while ((getline line < words) > 0)
        print "%" (line == "" ? "" : " " line)
}
/^% GNUPLOT/ {
    print "% Drawn by gnuplot. Needs the packages graphicx and color; where it is not in the folder of the document,"
    print "% \\graphicspath must name its folder, too."
    next
}
/colorbox\{gpBackground\}/ {
    match($0, /makebox\([0-9.]*,[0-9.]*\)/)
    split(substr($0, RSTART + 8, RLENGTH - 9), size, ",")
    print "    \\put(0,0){\\color{gpBackground}\\rule{" size[1] "\\unitlength}{" size[2] "\\unitlength}}%"
    next
}
/\\includegraphics\[/ {
    sub(/\{[^{}]*\}\}%$/, "{" graphics "}}%")
}
/\\put\(.*\\strut\{\}/ {
    match($0, /^.*\\strut\{\}/)
    before = substr($0, 1, RLENGTH)
    after = before ~ /rotatebox/ ? "}}}%" : "}}%"
    print before label(substr($0, RLENGTH + 1, length($0) - RLENGTH - length(after))) after
    next
}
# gnuplot takes a label that begins with a brace or a bracket for one that says where it is.
/^ *\\put\(.*\\makebox\(0,0\)/ {
    print "a label of LaTeX begins with { or [, and would be misplaced: " $0 >"/dev/stderr"
    exit 1
}
{
    print
}
