# The fitted curve and the points
set terminal pngcairo size 900,540 font "sans,11"
set datafile separator ","
set grid lc rgb "#dddddd"
set output "inversion.png"
set logscale x
set xrange [0.9:25]
set yrange [0:1]
set xlabel "impact speed [m/s]"
set ylabel "restitution"
set key bottom right
plot "postProcessing/calibrated_curve.csv" using 1:2 with lines lw 2 title "fitted curve", \
     "postProcessing/calibrated_fit.csv" using 1:2 with points pt 7 ps 1.5 title "points"
