# Sorts the rows 1 to n of a section, value[] with name[], the least value first.
function rank(section, n,    i, j, v, s) {
    for (i = 2; i <= n; i++) {
        v = value[section, i]
        s = name[section, i]
        for (j = i - 1; j > 0 && value[section, j] > v; j--) {
            value[section, j + 1] = value[section, j]
            name[section, j + 1] = name[section, j]
        }
        value[section, j + 1] = v
        name[section, j + 1] = s
    }
}
