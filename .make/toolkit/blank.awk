# blank.awk - makes the blank of an exercise from its solution.
#
# Between BEGIN SOLUTION and END SOLUTION only the stub lines stay, without their mark '//~'.
# A part that has no stub lines (helpers of the solution) goes, with its markers.
/^ *\/\/ BEGIN SOLUTION$/ {
    begin = $0
    stub = ""
    inside = 1
    next
}
/^ *\/\/ END SOLUTION$/ {
    if (!inside)
        wrong("END SOLUTION without BEGIN SOLUTION")
    if (stub != "")
        printf "%s\n%s%s\n", begin, stub, $0
    else
        dropped = 1
    inside = 0
    next
}
inside {
    if (/^ *\/\/~/) {
        sub(/\/\/~ ?/, "")
        sub(/ +$/, "")
        stub = stub $0 "\n"
    }
    next
}
dropped && /^$/ {
    dropped = 0
    next
}
{
    dropped = 0
    print
}
END {
    if (inside)
        wrong("BEGIN SOLUTION without END SOLUTION")
}
function wrong(what) {
    print FILENAME ":" FNR ": " what > "/dev/stderr"
    exit 1
}
