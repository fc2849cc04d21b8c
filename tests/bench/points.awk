# Two or three tables of `glim --probe` side by side: the reference, an
# estimate and, where only penumbra counts, the reference without shadows.
# Prints "COUNT,ERROR,FACTOR,HALF,WORST,TAU,LEAK": points that count, mean
# relative error, exp of the mean |ln factor|, % within a factor 2, the worst
# factor, Kendall's tau, and how far the worst point is off in % of the point
# labelled `bright`. The light of a point is the mean of its colours. Points
# count when they have 1e-4 of the most light at least; penumbra is where 2 to
# 98 % of the light arrives. A factor is taken to be 10,000 at most.
# Lines joined by tabs, as of paste; their fields are apart by blanks.
BEGIN { FS = "\t" }
{
    split($0, table, "\t")
    for (i = 1; i <= 3; i++) {
        fields = split(table[i], word, " ")
        value[i] = fields >= 9 ? (word[7] + word[8] + word[9]) / 3 : 0
        if (i == 1 && fields > 9)
            label = word[10]
    }
    if (label == "bright") {
        bright = value[1]
        label = ""
        next
    }
    if ($3 != "" && !(value[1] > 0.02 * value[3] && value[1] < 0.98 * value[3]))
        next
    all++
    truth[all] = value[1]
    guess[all] = value[2]
    if (value[1] > most)
        most = value[1]
}

function distance(a, b) { return a > b ? a - b : b - a }

END {
    for (i = 1; i <= all; i++) {
        off = distance(guess[i], truth[i])
        if (off > leak)
            leak = off
        if (!(truth[i] > 1e-4 * most))
            continue
        n++
        t[n] = truth[i]
        g[n] = guess[i]
        error += off / truth[i]
        factor = guess[i] / truth[i]
        if (factor < 1e-4) factor = 1e-4
        if (factor > 1e4) factor = 1e4
        l = log(factor)
        if (l < 0) l = -l
        sum += l
        half += l <= log(2)
        if (l > worst) worst = l
    }
    for (i = 1; i <= n; i++)
        for (j = 1; j < i; j++) {
            a = (t[i] > t[j]) - (t[i] < t[j])
            b = (g[i] > g[j]) - (g[i] < g[j])
            tau += a * b
        }
    if (n < 2)
        exit 1
    off = bright ? sprintf("%.3f", 100 * leak / bright) : ""
    printf "%d,%.5f,%.4f,%.1f,%.3f,%.3f,%s\n", n, error / n, exp(sum / n),
        100 * half / n, exp(worst), 2 * tau / (n * (n - 1)), off
}
