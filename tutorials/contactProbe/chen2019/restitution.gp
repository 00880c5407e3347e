# Restitution over speed: softened by the rule, and by the stiffness alone
set terminal pngcairo size 1200,540 font "sans,11"
set datafile separator ","
set grid lc rgb "#dddddd"

set output "restitution.png"
set multiplot layout 1,2
set xlabel "impact speed [m/s]"
set ylabel "restitution"
set xrange [0.08:4]
set yrange [0:1]
set logscale x
set key top left
f = "postProcessing/speed.csv"
g = "postProcessing/speedStiffnessOnly.csv"
set title "gamma_{mod} = gamma chi^{2/5}: the three coincide"
plot f using ($2 == 1 ? $3 : NaN):5 with lines lw 3 lc 1 title "chi = 1", \
     f using ($2 == 0.1 ? $3 : NaN):5 with points pt 6 ps 1.4 lc 2 title "0.1", \
     f using ($2 == 0.026 ? $3 : NaN):5 with points pt 2 lc 3 title "0.026"
set title "E alone softened: it sticks at higher speeds"
plot g using ($2 == 1 ? $3 : NaN):5 with lines lw 3 lc 1 title "chi = 1", \
     g using ($2 == 0.1 ? $3 : NaN):5 with linespoints pt 6 lc 2 title "0.1", \
     g using ($2 == 0.026 ? $3 : NaN):5 with linespoints pt 2 lc 3 title "0.026"
unset multiplot
