# The sticking limit: exponent and constant
set terminal pngcairo size 1200,540 font "sans,11"
set datafile separator ","
set grid lc rgb "#dddddd"

set output "critical.png"
set multiplot layout 1,2
f = "postProcessing/critical_sticking.csv"
c = "postProcessing/stickingConstant.csv"
set logscale xy
set format "10^{%L}"
set xlabel "Ad"
set ylabel "lambda_{crit}"
set key top left
set title "lambda_{crit} = c Ad^{5/2}"
plot for [e in "1 3 5 7 86 95"] f using (strcol(1) eq "dust.e0".e ? $5 : NaN):4 \
         with points pt 7 title "e = 0.".e, \
     [0.2:2e4] 5350*x**2.5 with lines dt 2 lc 0 title "slope 5/2", \
     [0.2:2e4] 0.1004*x**2.5 with lines dt 2 lc 0 notitle
unset logscale x
set format x "%g"
set xrange [0:1]
set xlabel "adhesionless restitution e"
set ylabel "c = lambda_{crit}/Ad^{5/2}"
set yrange [0.05:1e4]
set key top right
set title "The constant of the sticking limit"
plot c using 1:2 with linespoints pt 7 lw 2 lc 1 title "contactProbe", \
     "-" using 1:2 with points pt 6 ps 2.5 lw 2 lc 2 title "closed form: 147.2, 0.633"
0.3,147.2
0.86,0.633
e
unset multiplot
