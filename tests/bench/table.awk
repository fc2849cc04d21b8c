# Prints rows of bench.csv as a table, with ratios of CPU time to POV-Ray, to
# rays and to the floor of the same row. With `section` only the heading.
function heading() {
    title["speed"] = "Conventional light against POV-Ray"
    title["yardstick"] = "POV-Ray's yardstick"
    title["light"] = "Lighting methods"
    title["growth"] = "Growth"
    printf "\n%s\n", title[section]
    printf "%-16s %-12s %8s %8s %6s %8s %7s %8s %8s %8s\n", "", "", "CPU",
        "wall", "MB", "rays", "error", "POV-Ray", "rays", "floor"
    printf "%-16s %-12s %8s %8s %6s %8s %7s %8s %8s %8s\n", "row", "method",
        "s", "s", "", "million", "%", "/ it", "/ it", "it /"
}
BEGIN {
    if (section != "")
        heading()
}

{
    count++
    name = $2
    size = $4
    method[count] = $3
    cpu[count] = $6
    wall[count] = $7
    memory[count] = $8
    rays[count] = $9
    error[count] = $10
    if ($14 == "povray")
        povray = $6
    if ($3 == "rays")
        conventional = $6
    if ($3 == "floor")
        least = $6
}

# "-" where there is nothing to say.
function ratio(above, below) {
    return above > 0 && below > 0 ? sprintf("%.3g", above / below) : "-"
}

END {
    for (i = 1; i <= count; i++) {
        many = rays[i] == "" ? "-" : sprintf("%.3f", rays[i] / 1e6)
        wrong = error[i] == "" ? "-" : sprintf("%.2f", 100 * error[i])
        head = i == 1 ? name : i == 2 ? "  " size : ""
        printf "%-16s %-12s %8.3f %8.3f %6.0f %8s %7s %8s %8s %8s\n",
            head, method[i], cpu[i], wall[i], memory[i], many, wrong,
            ratio(povray, cpu[i]), ratio(conventional, cpu[i]),
            ratio(cpu[i], least)
    }
}
