# Sums up default.csv (see `default`): for each section the mean that counts and
# the worst by name, and whether they hold. Ends with 1 if one does not.
function judge(what, found, most) {
    printf "%-44s %10.4f  <= %-6s %s\n", what, found, most,
        found <= most ? "met" : "MISSED"
    missed += found > most
}

function judge_least(what, found, least) {
    printf "%-44s %10.4f  >= %-6s %s\n", what, found, least,
        (found >= least ? "met" : "MISSED")
    missed += found < least
}

NR > 1 && $3 != "" {
    n = ++count[$1]
    name[$1, n] = $2
    value[$1, n] = $3
    sum[$1] += log($3 > 1e-9 ? $3 : 1e-9)
}

END {
    for (section in count) {
        n = count[section]
        rank(section, n)
        middle[section] = value[section, int((n + 1) / 2)]
        worst[section] = value[section, n]
        who[section] = name[section, n]
    }
    if (count["start"])
        judge("a thumbnail, s", worst["start"], 0.02)
    if (count["price"]) {
        n = count["price"]
        judge("price, geometric mean of " n, exp(sum["price"] / n), 2.5)
        judge("price of " who["price"], worst["price"], 6)
    }
    if (count["large"]) {
        n = count["large"]
        judge("price at 1280x960 +A0.3, mean of " n, exp(sum["large"] / n), 1.6)
        judge("of " who["large"], worst["large"], 6)
    }
    if (count["beside"]) {
        n = count["beside"]
        judge_least("POV-Ray over it, mean of " n, exp(sum["beside"] / n), 1.5)
        judge_least("of " name["beside", 1], value["beside", 1], 0.5)
    }
    if (count["seam"])
        judge("seam at " who["seam"] " lamps, of all pixels", worst["seam"],
            0.005)
    if (count["look"]) {
        n = count["look"]
        far = 0
        for (i = 1; i <= n; i++)
            far += value["look", i] > 0.12
        judge("look, FLIP at the median of " n, middle["look"], 0.08)
        judge("look, share beyond 0.12", far / n, 0.2)
    }
    if (count["truth"]) {
        judge("truth, error at the median of " count["truth"],
            middle["truth"], 0.04)
        judge("truth of " who["truth"], worst["truth"], 0.1)
    }
    if (count["flicker"])
        judge("flicker, % at the 95th percentile, " who["flicker"],
            worst["flicker"], 0.5)
    exit missed > 0
}
