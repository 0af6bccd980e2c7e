# svg.awk - makes gnuplot's SVG one that can be read aloud, and that shows the same everywhere.
#
# words: the figure in words, its title in the first line. Fonts get a family to fall back on.
function escaped(text)
{
    gsub(/&/, "\\&amp;", text)
    gsub(/</, "\\&lt;", text)
    gsub(/>/, "\\&gt;", text)
    return text
}
BEGIN {
    getline title < words
    while ((getline line < words) > 0)
        description = description (description == "" ? "" : " ") line
}
/^<svg/ {
    sub(/<svg/, "<svg role=\"img\" aria-labelledby=\"title description\" xml:space=\"preserve\"")
}
/<title>/ && !titled {
    print "<title id=\"title\">" escaped(title) "</title>"
    titled = 1
    next
}
/<desc>/ && !described {
    print "<desc id=\"description\">" escaped(description) "</desc>"
    described = 1
    next
}
# Rings and crosses are hairlines in the SVG of gnuplot 5.4, whatever their width.
/id=.gpPt/ { sub(/stroke-width=.[0-9.]+/, "stroke-width='0.6") }
{
    gsub(/font-family="DejaVu Sans"/, "font-family=\"DejaVu Sans, Verdana, sans-serif\"")
    gsub(/font-family="DejaVu Serif"/, "font-family=\"DejaVu Serif, Georgia, serif\"")
    print
}
