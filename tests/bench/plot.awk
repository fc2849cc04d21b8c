# Lines "SERIES X Y [LABEL]" to an SVG picture with two logarithmic axes; set
# title, across and up (what the axes are). Points of a series in order.
function log10(v) { return log(v) / log(10) }
function place_x(x) { return 70 + 500 * (log10(x) - left) / (right - left) }
function place_y(y) { return 380 - 330 * (log10(y) - low) / (high - low) }

# Escaped for XML.
function text(x, y, anchor, words) {
    gsub(/&/, "\\&amp;", words)
    gsub(/</, "\\&lt;", words)
    printf "<text x='%.1f' y='%.1f' text-anchor='%s'>%s</text>\n", x, y,
        anchor, words
}

function line(x1, y1, x2, y2, colour) {
    printf "<line x1='%.1f' y1='%.1f' x2='%.1f' y2='%.1f' stroke='%s'/>\n",
        x1, y1, x2, y2, colour
}

# The power of ten, in words that fit under an axis.
function power(exponent) {
    return exponent >= -2 && exponent <= 4 ? 10 ^ exponent + 0 : "1e" exponent
}

function axes(    e, m, x, y) {
    for (e = left; e <= right; e++)
        for (m = 1; m < 10; m++) {
            x = place_x(m * 10 ^ e)
            if (x < 570.1)
                line(x, 50, x, 380, m == 1 ? "#bbb" : "#eee")
            if (m == 1)
                text(x, 398, "middle", power(e))
        }
    for (e = low; e <= high; e++)
        for (m = 1; m < 10; m++) {
            y = place_y(m * 10 ^ e)
            if (y > 49.9)
                line(70, y, 570, y, m == 1 ? "#bbb" : "#eee")
            if (m == 1)
                text(64, y + 4, "end", power(e))
        }
    text(320, 24, "middle", title)
    text(320, 420, "middle", across)
    printf "<text transform='translate(20,215) rotate(-90)' "
    printf "text-anchor='middle'>%s</text>\n", up
}

function floor(v,    i) {
    i = int(v)
    return i > v ? i - 1 : i
}

$2 > 0 && $3 > 0 {
    if (!($1 in number)) {
        number[$1] = ++count
        name[count] = $1
    }
    n = ++points[$1]
    at_x[$1, n] = $2
    at_y[$1, n] = $3
    label[$1, n] = $4
    if (!any++)
        least_x = most_x = $2 + 0
    if (any == 1)
        least_y = most_y = $3 + 0
    if ($2 + 0 < least_x) least_x = $2 + 0
    if ($2 + 0 > most_x) most_x = $2 + 0
    if ($3 + 0 < least_y) least_y = $3 + 0
    if ($3 + 0 > most_y) most_y = $3 + 0
}

END {
    if (!any)
        exit 1
    split("#d62728 #1f77b4 #2ca02c #9467bd #ff7f0e #17becf #8c564b", hue, " ")
    left = floor(log10(least_x) + 1e-9)
    right = -floor(-log10(most_x) + 1e-9)
    low = floor(log10(least_y) + 1e-9)
    high = -floor(-log10(most_y) + 1e-9)
    if (right == left) right++
    if (high == low) high++
    print "<svg xmlns='http://www.w3.org/2000/svg' width='700' height='440' " \
        "font-family='sans-serif' font-size='12'>"
    print "<rect width='700' height='440' fill='white'/>"
    axes()
    for (i = 1; i <= count; i++) {
        s = name[i]
        colour = hue[(i - 1) % 7 + 1]
        path = ""
        for (n = 1; n <= points[s]; n++) {
            x = place_x(at_x[s, n])
            y = place_y(at_y[s, n])
            path = path sprintf("%.1f,%.1f ", x, y)
            printf "<circle cx='%.1f' cy='%.1f' r='3' fill='%s'/>\n", x, y,
                colour
            if (label[s, n] != "")
                text(x + 5, y - 5, "start", label[s, n])
        }
        printf "<polyline points='%s' fill='none' stroke='%s'/>\n", path,
            colour
        printf "<rect x='585' y='%d' width='12' height='3' fill='%s'/>\n",
            44 + 18 * i, colour
        text(602, 50 + 18 * i, "start", s)
    }
    print "</svg>"
}
