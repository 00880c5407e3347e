# What comes of an oblique impact
set terminal pngcairo size 1200,540 font "sans,11"
set datafile separator ","
set grid lc rgb "#dddddd"

set output "regimes.png"
set multiplot layout 1,2
set logscale x
set xlabel "impact speed [m/s]"
set ylabel "angle from the normal [degree]"
set xrange [0.45:11]
set yrange [-3:88]
set key below
do for [n = 1:2] {
    f = n == 1 ? "postProcessing/regimes.csv" : "postProcessing/regimesForce.csv"
    set title n == 1 ? "no force" : "tangential force 3e-8 N = 1.3 of the rolling yield"
    plot f using (strcol(8) eq "rebound" ? $3 : NaN):4 with points pt 6 lc rgb "#1f77b4" title "rebound", \
         f using (strcol(8) eq "stick" ? $3 : NaN):4 with points pt 5 lc rgb "#444444" title "stick", \
         f using (strcol(8) eq "roll" ? $3 : NaN):4 with points pt 9 lc rgb "#d62728" title "roll", \
         f using (strcol(8) eq "slide" ? $3 : NaN):4 with points pt 11 lc rgb "#2ca02c" title "slide"
}
unset multiplot
