# Picture of the stability map, from cases.csv: each case a dot, step over bound against every
# other axis, and the verdicts of each law
set datafile separator ","
set datafile missing NaN
set terminal pngcairo size 1800,1500 font "Sans,10"
set output "stabilityMap.png"
set multiplot layout 4,4 title "Stability map: verdict over step/bound and each axis"

verdicts = "right refused unstableBeyondBound SILENT"
colours = "#4daf4a #999999 #ff7f00 #e41a1c"
small(v) = v == 4 ? 1.2 : v == 3 ? 0.5 : 0.12
shape(v) = v == 4 ? 5 : 7

set logscale xy
set ylabel "step / bound"
set yrange [0.05:2]
set format x "10^{%T}"
unset key

array column[12] = [5, 6, 7, 8, 9, 10, 11, 12, 14, 15, 16, 17]
array name[12] = ["E [Pa]", "d [m]", "gamma [J/m^2]", "v [m/s]", "restitution", "size ratio", \
    "mass ratio", "chi", "initial overlap / d", "tau_p / step", "contacts", "weight [g]"]
do for [a = 1:12] {
    set xlabel name[a]
    plot for [v = 1:4] "cases.csv" every ::1 \
        using (column(column[a]) > 0 ? column(column[a]) : NaN): \
              (strcol(18) eq word(verdicts, v) ? column(13) : NaN) \
        with points pt shape(v) ps small(v) lc rgb word(colours, v)
}

# Counts by normal law, and by scene
unset logscale
set format x "%g"
set yrange [0:*]
set ylabel "cases"
set xlabel ""
set style fill solid 0.8
set boxwidth 0.8
set key outside above
laws = "Hertz simplifiedJKR JKR DMT vanDerWaals cohesivePlastic"
scenes = "headOn obliquePair obliqueWall overlapPair overlapWall pressed placed drag chain cluster crowd bullet"
set xtics rotate by -35
starts(text, with) = substr(text, 1, strlen(with) + 1) eq with . "+"
# stacked from the back: all, then without the last verdict, ...
upTo(v) = v == 1 ? "right" : v == 2 ? "right refused" : \
    v == 3 ? "right refused unstableBeyondBound" : verdicts
within(s, v) = strstrt(" " . upTo(v) . " ", " " . s . " ") > 0
set xtics ("Hertz" 1, "simplifiedJKR" 2, "JKR" 3, "DMT" 4, "vanDerWaals" 5, "cohesivePlastic" 6)
index(text) = (starts(text, "Hertz") ? 1 : starts(text, "simplifiedJKR") ? 2 : \
    starts(text, "JKR") ? 3 : starts(text, "DMT") ? 4 : starts(text, "vanDerWaals") ? 5 : 6)
set xrange [0.4:6.6]
plot for [v = 4:1:-1] "cases.csv" every ::1 \
    using (index(strcol(2))):(within(strcol(18), v) ? 1 : 0) smooth frequency with boxes \
    lc rgb word(colours, v) title word(verdicts, v)
set xtics ("headOn" 1, "obliquePair" 2, "obliqueWall" 3, "overlapPair" 4, "overlapWall" 5, \
    "pressed" 6, "placed" 7, "drag" 8, "chain" 9, "cluster" 10, "crowd" 11, "bullet" 12)
which(text) = sum [k = 1:12] (word(scenes, k) eq text ? k : 0)
set xrange [0.4:12.6]
unset key
plot for [v = 4:1:-1] "cases.csv" every ::1 \
    using (which(strcol(3))):(within(strcol(18), v) ? 1 : 0) smooth frequency with boxes \
    lc rgb word(colours, v)
# error over band: how near the right ones come to the limit
set xrange [1e-8:3]
set logscale xy
set yrange [0.5:*]
set format x "10^{%T}"
set xtics auto norotate
set xlabel "error / band"
set ylabel "cases per bin"
set boxwidth 0.08
unset logscale x
set xrange [-8:0.5]
set format x "10^{%g}"
plot "< awk -F, '$18 == \"right\" && $19 > 0 && $20 > 0 {++n[int(10*log($19/$20)/log(10) - 100)]} END {for (k in n) print (k + 100)/10 \",\" n[k]}' cases.csv" \
    using 1:2 with boxes lc rgb "#4daf4a"
unset multiplot
