# show.awk - leaves out what only follows from another message, and shows the first few.
# One mistake makes several messages; those that only follow from another are left out.
function sort_out(   i, j, name) {
    open_function = unclosed()
    for (i = 1; i <= n; i++) {
        begins[i] = beginning(line_number[i])
        statement[i] = statement_of(line_number[i])
        name = quoted(text[i])
        unknown[i] = is_unknown(i)
        is_letter[i] = unknown[i] && name ~ /^[A-Za-z]$/ && text[i] !~ /function '|unknown type/ &&
            !loop_of(name, line_number[i])
        translation[i] = is_letter[i] ? translated(name, line_number[i]) : letter_of_whole(i)
        is_letter[i] = is_letter[i] || translation[i] != ""
        if (translation[i] != "")
            add_to(letters_of, begins[i], translation[i])
        else if (is_letter[i] && whole_of(name, line_number[i]) == "")
            add_to(strange_letters, begins[i], name)
        else
            is_letter[i] = 0
        lacks_contract[i] = unknown[i] && !(contract in included) && is_declared(name)
        pasted[i] = is_pasted(i)
        # gcc says only once that there is no function fro.
        slip[i] = name
        if (text[i] ~ /^expected expression before '/ && match(ahead[i], /[a-z]+ *\($/))
            slip[i] = line_before(substr(ahead[i], RSTART), "(")
        keyword[i] = unknown[i] || slip[i] != name ? misspelled(slip[i], line_number[i]) : ""
        syntax[i] = is_syntax(i) || pasted[i] || keyword[i] != "" ||
            unknown[i] && name ~ /^(std|new|let|var|def)$/
        count[i] = is_count(i)
        missing_return[i] = is_missing_return(i)
        missing_brace[i] = is_missing_brace(i)
        outside[i] = is_outside(i)
        find_types(i)
        decimal[i] = may_be_decimal_comma(i) ? decimal_comma(line_number[i]) : ""
        if (is_comma(i))
            comma_in[statement[i]] = 1
        if (is_unused_value(i) && !lost_in[begins[i]])
            lost_in[begins[i]] = line_number[i]
        # What a misspelled type was to declare.
        if (unknown[i] && has_word(code[line_number[i]], name) && text[i] !~ /function '/) {
            declares[i] = code[line_number[i]]
            declares[i] = substr(declares[i], index(declares[i], name) + length(name))
            if (match(declares[i], /^ +\**[A-Za-z_][A-Za-z_0-9]*/))
                declares[i] = substr(declares[i], 1, RLENGTH)
            else
                declares[i] = ""
            gsub(/[ *]/, "", declares[i])
        }
    }
    for (i = 1; i <= n; i++)
        for (j = 1; j <= n; j++)
            if (j != i && !dropped[i] && !dropped[j] && follows(j, i))
                dropped[j] = 1
}

function add_to(list, place, what) {
    if (index(", " list[place] ",", ", " what ",") == 0)
        list[place] = list[place] (list[place] == "" ? "" : ", ") what
}

# Whether message j only follows from message i.
function follows(j, i) {
    if (lacks_contract[i] && (j > i || is_warning[j]))
        return 1
    if (pasted[i] && line_number[i] == line_number[j] && (j > i || !pasted[j]))
        return 1
    if (missing_brace[i] && line_number[j] >= open_function)
        return missing_brace[j] ? j > i : missing_return[j] ||
            text[j] ~ /defined but not used|^unused |invalid storage class|[Mm]isleading|clause does not guard|nested function|declared .* but never defined|follows non-static/
    if (statement[i] == statement[j]) {
        if (decimal[i] != "" && (decimal[j] != "" ? j > i : is_warning[j]))
            return 1
        if (syntax[i] && (!syntax[j] || j > i) &&
            (!is_warning[j] || text[j] ~ /clause does not guard|^misleading|operand of comma|no effect/))
            return 1
        if (count[i] && text[j] ~ /^incompatible type for argument|^passing /)
            return 1
        if (!is_warning[i] && is_comma(j))
            return 1
        if (j > i && (text[i] == text[j] ||
                      text[i] ~ /argument [0-9]+ of '/ && text[j] ~ /argument [0-9]+ of '/ &&
                      quoted(text[i]) == quoted(text[j])))
            return 1
        if (j > i && text[i] ~ /'->'|member reference type/ && text[j] ~ /'->'|no member named/ || is_comma(i) && is_comma(j) && j > i)
            return 1
    }
    if (is_signature(i) && j > i && has_word(text[j], quoted(text[i])))
        return 1
    # What nobody declared is taken for a function that returns an int; gcc says so only once.
    if (unknown[i] &&
        (statement[i] == statement[j] || has_word(code[line_number[j]], quoted(text[i]))) &&
        text[j] ~ /'int'|invalid initializer|subscripted value|incompatible implicit|type mismatch in conditional/)
        return 1
    if (begins[i] == 0 || begins[i] != begins[j])
        return 0
    if (is_letter[i] && is_letter[j] && j > i && (translation[i] == "") == (translation[j] == ""))
        return 1
    if (is_signature(i) && text[i] !~ /^static/)
        return 1
    if (outside[i])
        return j > i || is_warning[j] || missing_return[j]
    if (missing_return[i])
        return is_unused_value(j)
    if (!is_warning[i] &&
        (missing_return[j] || text[j] ~ /^missing initializer|^unused variable|set but not used/))
        return 1
    if (j > i && unknown[i] && unknown[j] && quoted(text[i]) == quoted(text[j]))
        return 1
    if (unknown[i] && text[j] ~ /clause does not guard|empty body/ &&
        ends_at_once(line_number[j]) &&
        loop_of(quoted(text[i]), line_number[i]) == line_number[j])
        return 1
    if (unknown[i] && line_number[i] == begins[i] && text[j] ~ /'int'/)
        return 1
    if (j > i && declares[i] != "" && has_word(code[line_number[j]], declares[i]))
        return 1
    # The declaration that lost its semicolon took the next one with it; brackets, the function.
    return syntax[i] && j > i && (outside[j] || text[j] ~ /undeclared/)
}

# ---- showing ------------------------------------------------------------------------------------

function wrapped(line, indent,   out, at) {
    out = ""
    while (length(line) > columns) {
        for (at = columns + 1; at > length(indent) + 20 && substr(line, at, 1) != " "; at--)
            ;
        if (substr(line, at, 1) != " ")
            at = columns
        out = out substr(line, 1, at) "\n"
        sub(/ +\n$/, "\n", out)
        line = substr(line, at + 1)
        sub(/^ +/, "", line)
        line = indent line
    }
    return out line
}

# A quote: the text, the caret below it, and what the compiler would put there. Where the caret
# stands far out, all lines lose the same columns after the margin.
function show_quote(quote, count,   k, caret, margin, gone, line) {
    for (k = 1; k <= count; k++)
        if (!caret && quote[k] ~ /^[ |~]*\^/)
            caret = index(quote[k], "^")
    margin = match(quote[1], /^ *[0-9]+ \|/) ? RLENGTH : 0
    gone = caret > columns - 10 ? caret - 50 : 0
    for (k = 1; k <= count; k++) {
        line = quote[k]
        if (gone)
            line = substr(line, 1, margin) (k == 1 ? " ..." : "    ") \
                substr(line, margin + gone + 5)
        line = substr(line, 1, columns)
        sub(/ +$/, "", line)
        print line
    }
}

function show(i,   lines, lines_count, k, words, quote, quote_count) {
    print wrapped(message[i], "  ")
    lines_count = split(body[i], lines, "\n")
    for (k = 2; k <= lines_count; k++)
        if (index(lines[k], source ":") == 1) {
            show_quote(quote, quote_count)
            quote_count = 0
            print wrapped(lines[k], "  ")
        } else
            quote[++quote_count] = lines[k]
    show_quote(quote, quote_count)
    words = help(i)
    if (words == "" || words in helped)
        return
    helped[words] = 1
    words = wrapped("  help: " words, "        ")
    gsub(/\001/, " ", words)
    print words
}

END {
    for (i = 1; i <= n; i++)
        if (quoted_line[i] == "" && column[i] && answer[line_number[i]] !~ /\t/)
            quote_again(i)
    sort_out()
    errors = 0
    for (i = 1; i <= n; i++)
        errors += !dropped[i] && !is_warning[i]
    if (errors == 0 && elsewhere != "") {
        # What stands before an #include can spoil the header.
        print wrapped(elsewhere, "  ")
        if (where_included != "")
            print wrapped("  help: it shows there, but look at " where_included " and above it.",
                          "        ")
    }
    for (warning = 0; warning <= 1; warning++)
        for (i = 1; i <= n; i++)
            if (!dropped[i] && is_warning[i] == warning && shown++ < most)
                show(i)
    if (shown + unread > most)
        print "... and " shown + unread - most " more"
    # Whatever else a compiler may say.
    if (n == 0 && elsewhere == "")
        for (i = 1; i <= raw_count; i++)
            print wrapped(raw[i], "  ")
}
