# Restitution over speed
set terminal pngcairo size 1200,540 font "sans,11"
set datafile separator ","
set grid lc rgb "#dddddd"

set output "restitution.png"
set multiplot layout 1,2
set xlabel "impact speed [m/s]"
set ylabel "restitution"
set logscale x
set xrange [0.009:6]
set yrange [0:1]
set key below
f = "postProcessing/speed.csv"
g = "postProcessing/constant.csv"
set title "Attraction and unloading stiffness"
plot f using (strcol(1) eq "dust.flat" ? $3 : NaN):5 with linespoints pt 6 ps 0.7 lc 1 title "c_f = 0", \
     f using (strcol(1) eq "dust.wall" ? $3 : NaN):5 with linespoints pt 6 ps 0.7 lc 2 title "0.05", \
     f using (strcol(1) eq "dust.strong" ? $3 : NaN):5 with linespoints pt 6 ps 0.7 lc 3 title "0.1", \
     f using (strcol(1) eq "dust.average" ? $3 : NaN):5 with linespoints pt 6 ps 0.7 lc 4 title "0.05, average slope", \
     g using (strcol(1) eq "dust.constant" ? $3 : NaN):5 with linespoints pt 6 ps 0.7 lc 5 title "K_R/0.7^2, c_f = 0", \
     g using (strcol(1) eq "dust.bare" ? $3 : NaN):5 with lines dt 2 lc 0 title "K_R/0.7^2, no attraction"
h = "postProcessing/soft.csv"
set title "Softened: s_f = 0.3"
plot h using (strcol(1) eq "dust.wall" ? $3 : NaN):5 with lines lw 3 lc 2 title "as it is", \
     h using (strcol(1) eq "dust.soft" ? $3 : NaN):5 with points pt 6 ps 1.4 lc 1 title "with F_{c0} s_f^{1/2}", \
     h using (strcol(1) eq "dust.softOnly" ? $3 : NaN):5 with linespoints pt 2 lc 3 title "with F_{c0} as it was"
unset multiplot
