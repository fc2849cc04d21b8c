# Sums up ordinary.csv: geometric means, the least by name, the best; and what
# has fallen below the baseline, which holds POV-Ray's time over glim's and its
# memory over glim's. Times of one program vary by a quarter on a shared
# machine, those below a twentieth of a second by more: `slack` allows for it.
# With `accept` what was measured is written into the baseline instead. Ends
# with 1 if any has fallen.
BEGIN {
    slack = 0.7
    memory_slack = 0.85
    while ((getline line < baseline) > 0) {
        split(line, field, " ")
        key = field[1] "," field[2]
        if (line ~ /^#/)
            continue
        if (accept) {
            kept[++rows] = key
            row[key] = line
        } else {
            least_time[key] = field[3]
            least_memory[key] = field[4]
        }
    }
    close(baseline)
}

NR > 1 && $3 > 0 && $5 > 0 {
    key = $1 "," $2
    ratio = $5 / $3
    memory = $6 / $4
    if (!($1 in count))
        order[++sections] = $1
    n = ++count[$1]
    name[$1, n] = $2
    value[$1, n] = ratio
    sum[$1] += log(ratio)
    if (!(key in row))
        kept[++rows] = key
    row[key] = sprintf("%s %s %.2f %.2f", $1, $2, ratio, memory)
    if (key in least_time) {
        allowed = least_time[key] * ($3 < 0.05 ? slack * slack : slack)
        if (ratio < allowed)
            fallen[++lost] = sprintf("%s %s: %.2f times quicker, was %.2f",
                $1, $2, ratio, least_time[key])
        if (memory < least_memory[key] * memory_slack)
            fallen[++lost] = sprintf("%s %s: %.2f times less memory, was %.2f",
                $1, $2, memory, least_memory[key])
    }
}

END {
    print "\nPOV-Ray's processor time over glim's"
    for (i = 1; i <= sections; i++) {
        s = order[i]
        n = count[s]
        rank(s, n)
        printf "%-12s %3d rows, geometric mean %.2f, best %s %.1f\n", s, n,
            exp(sum[s] / n), name[s, n], value[s, n]
        printf "    least:"
        for (k = 1; k <= 10 && k <= n; k++)
            printf " %s %.2f", name[s, k], value[s, k]
        print ""
    }
    if (accept) {
        print "# SECTION ROW POV-Ray's time / glim's, its memory / glim's;" \
            " written by BASELINE=accept" > baseline
        for (i = 1; i <= rows; i++)
            print row[kept[i]] > baseline
    }
    for (i = 1; i <= lost; i++)
        print "fallen below the baseline: " fallen[i]
    exit lost > 0
}
