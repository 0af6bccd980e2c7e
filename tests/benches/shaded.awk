# shaded.awk - what make bench-shaded measured, as a table of chapter 08's lesson (Markdown).
#
# Usage: awk -F, -f shaded.awk FILE.csv
# Of one and of four samples: the milliseconds of chapter 08 with one thread, then how many times as
# long each peer takes. Below that the geometric means over the scenes, by threads.

# Three digits.
function short(x, digits) {
    digits = 2 - int(log(x) / log(10) + (x < 1 ? -1 : 0) + 1e-9)
    return sprintf("%." (digits > 0 ? digits : 0) "f", x)
}
NR > 1 {
    name = $3 == "embree-user" ? "Embree" : $3 == "povray" ? "POV-Ray" : ""
    if (!($1 in known))
        scenes[++scene_count] = $1
    known[$1] = 1
    if (name != "" && !(name in column)) {
        column[name] = 1
        peers[++peer_count] = name
    }
    samples[$4] = threads[$5] = 1
    ms[$1, name, $4, $5] = $7
    times[$1, name, $4, $5] = $8
}
function cell(line, text) {
    return line " | " text
}
function mean(name, n, t, i, sum, count) {
    for (i = 1; i <= scene_count; i++)
        if ((scenes[i], name, n, t) in times) {
            sum += log(times[scenes[i], name, n, t])
            count++
        }
    return count ? short(exp(sum / count)) : ""
}
END {
    line = "| milliseconds for a shaded picture"
    under = "|---"
    for (n = 1; n <= 64; n++)
        if (n in samples) {
            line = cell(line, n (n == 1 ? " sample" : " samples"))
            under = under "|---:"
            for (k = 1; k <= peer_count; k++) {
                line = cell(line, peers[k] ", times")
                under = under "|---:"
            }
        }
    print line " |"
    print under "|"
    for (i = 1; i <= scene_count; i++) {
        line = "| " scenes[i]
        for (n = 1; n <= 64; n++)
            if (n in samples) {
                line = cell(line, (scenes[i], "", n, 1) in ms ? short(ms[scenes[i], "", n, 1]) : "")
                for (k = 1; k <= peer_count; k++)
                    line = cell(line, (scenes[i], peers[k], n, 1) in times ? short(times[scenes[i], peers[k], n, 1]) : "")
            }
        print line " |"
    }
    for (t = 1; t <= 256; t++)
        if (t in threads) {
            line = "| **mean, " t (t == 1 ? " thread**" : " threads**")
            for (n = 1; n <= 64; n++)
                if (n in samples) {
                    line = cell(line, "")
                    for (k = 1; k <= peer_count; k++)
                        line = cell(line, mean(peers[k], n, t))
                }
            print line " |"
        }
}
