# Restitution over alpha and 1/A*: dem::System on the integrated curves
set terminal pngcairo size 900,640 font "sans,11"
set datafile separator ","
set grid lc rgb "#dddddd"
set output "map.png"
set logscale x
set xrange [2:200]
set yrange [0:1]
set xlabel "1/A* = (E/(rho v^2))^{1/3} (rho v^2 r/gamma)^{5/6}"
set ylabel "restitution"
set key top left title "alpha"
f = "postProcessing/mapAstar.csv"
g = "postProcessing/calibrated_map.csv"
plot for [k = 1:5] a = word("0 0.1 0.2 0.4 0.8", k) g using ($1 == a + 0 ? $2 : NaN):3 with lines lw 2 lc k title a, \
     for [k = 1:5] a = word("0 0.1 0.2 0.4 0.8", k) f using ($1 == a + 0 ? $2 : NaN):3 with points pt 6 lc k notitle, \
     NaN with lines lc 0 title "integrated", NaN with points pt 6 lc 0 title "contactProbe"
