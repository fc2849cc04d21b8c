# targets.txt, then bench.csv: says of each target what was found and whether
# it is met. A row that ends in * is every row that begins so; the worst is
# told. Targets of rows or methods that were not measured are counted only.
# Exit status 1 if any is missed.
FNR == NR {
    if ($0 !~ /^#/ && NF)
        target[++targets] = $0
    next
}
{
    columns = split($0, word, ",")
    for (i = 1; i <= columns; i++)
        if (FNR == 1)
            column[i] = word[i]
        else
            value[word[2], word[3], column[i]] = word[i]
    if (FNR > 1 && !(word[2] in methods))
        row[++rows] = word[2]
    methods[word[2]] = 1
    if (word[14] == "povray")
        povray[word[2]] = word[3]
}

function cpu(name, method) {
    return (name, method, "cpu") in value ? value[name, method, "cpu"] : 0
}

# The figure of a row and a method, or "" when it was not measured.
function figure(name, method, what,    mine, other) {
    mine = cpu(name, method)
    if (!mine)
        return ""
    if ((name, method, what) in value && what != "wall" && what != "rays")
        return value[name, method, what]
    if (what == "memory")
        return cpu(name, "rays") ? value[name, method, "mb"] - \
            value[name, "rays", "mb"] : ""
    if (what == "wall")
        return name in povray ? value[name, povray[name], "wall"] / \
            value[name, method, "wall"] : ""
    if (what == "floor")
        return cpu(name, "floor") ? mine / cpu(name, "floor") : ""
    if (what ~ /^to-/) {
        other = cpu(substr(what, 4), method)
        return other ? mine / other : ""
    }
    other = cpu(name, what == "povray" ? povray[name] : what)
    return other ? other / mine : ""
}

# Whether `a` is worse than `b` where at least, or at most, a number is wanted.
function worse(a, b, least) {
    return least ? a < b : a > b
}

END {
    format = "%-5s %-20s %-18s %-14s %9s  %-9s %s\n"
    printf format, "issue", "row", "method", "figure", "found", "target", ""
    for (i = 1; i <= targets; i++) {
        split(target[i], t, " +")
        least = t[5] == "at-least"
        whole = t[2] !~ /\*$/
        start = whole ? t[2] : substr(t[2], 1, length(t[2]) - 1)
        found = ""
        for (r = 1; r <= rows; r++) {
            if (whole ? row[r] != start : index(row[r], start) != 1)
                continue
            mine = figure(row[r], t[3], t[4])
            if (mine == "" || (found != "" && !worse(mine + 0, found, least)))
                continue
            found = mine + 0
            where = row[r]
        }
        if (found == "") {
            skipped++
            continue
        }
        bad = worse(found, t[6] + 0, least)
        missed += bad
        printf format, t[1], where, t[3], t[4], sprintf("%.4g", found),
            (least ? ">= " : "<= ") t[6], bad ? "MISSED" : "met"
    }
    printf "%d targets missed, %d not measured\n", missed, skipped
    exit missed > 0
}
