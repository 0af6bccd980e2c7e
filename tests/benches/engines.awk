# engines.awk - what make bench-engines measured, as the tables of chapter 08's lesson (Markdown).
#
# Usage: awk -F, -f engines.awk FILE.csv
# First rays a second, in millions, with one thread, and below that how many times as fast as the
# better one of Embree's, the geometric mean over the scenes, by threads; then what a first picture takes,
# hierarchy and all, of the scenes with many spheres.

# Three digits, without trailing noise: 1094, 48.9, 0.0102.
function short(x, digits) {
    digits = 2 - int(log(x) / log(10) + (x < 1 ? -1 : 0) + 1e-9)
    return sprintf("%." (digits > 0 ? digits : 0) "f", x)
}
# Embree's two kinds of packet are one column: the better one.
function column_of(engine) {
    return engine ~ /^embree-[0-9]+$/ ? "Embree, its spheres" : engine == "embree-user" ? "Embree, 16-lane callback" \
        : engine == "povray" ? "POV-Ray" : engine == "tachyon" ? "Tachyon" : "`" engine "`"
}
NR > 1 {
    name = column_of($3)
    if (!($1 in spheres)) {
        scenes[++scene_count] = $1
        spheres[$1] = $2
    }
    if (!(name in known)) {
        known[name] = 1
        columns[++column_count] = name
    }
    threads[$4] = 1
    if ($8 > rate[$1, name, $4]) {
        rate[$1, name, $4] = $8
        # Of who is slow, a smaller picture was cast.
        if ($5 == 1920 && $6 == 1080)
            frame[$1, name, $4] = $12
        times[$1, name, $4] = $13
    }
}
function head(first, i, line, under) {
    line = "| " first
    under = "|---"
    for (i = 1; i <= column_count; i++) {
        line = line " | " columns[i]
        under = under "|---:"
    }
    print line " |"
    print under "|"
}
function mean_row(n, i, s, sum, count, line) {
    line = "| **times Embree, " n (n == 1 ? " thread**" : " threads**")
    for (i = 1; i <= column_count; i++) {
        sum = count = 0
        for (s = 1; s <= scene_count; s++)
            if ((scenes[s], columns[i], n) in times) {
                sum += log(times[scenes[s], columns[i], n])
                count++
            }
        line = line " | " (count ? short(exp(sum / count)) : "")
    }
    print line " |"
}
END {
    head("millions of rays a second")
    for (s = 1; s <= scene_count; s++) {
        line = "| " scenes[s]
        for (i = 1; i <= column_count; i++)
            line = line " | " ((scenes[s], columns[i], 1) in rate ? short(1e-6 * rate[scenes[s], columns[i], 1]) : "")
        print line " |"
    }
    for (n = 1; n <= 256; n++)
        if (n in threads)
            mean_row(n)
    print ""
    head("milliseconds to the first picture")
    for (s = 1; s <= scene_count; s++) {
        if (spheres[scenes[s]] < 50000)
            continue
        line = "| " scenes[s]
        for (i = 1; i <= column_count; i++)
            line = line " | " ((scenes[s], columns[i], 1) in frame ? short(frame[scenes[s], columns[i], 1]) : "")
        print line " |"
    }
}
