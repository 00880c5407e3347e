# Slow load cycles: build-up of the attraction; slope of unloading
set terminal pngcairo size 1200,540 font "sans,11"
set datafile separator ","
set grid lc rgb "#dddddd"

set output "loadCycle.png"
set multiplot layout 1,2
f = "postProcessing/cycle_forceOverlap.csv"
set xlabel "overlap [nm]"
set ylabel "force [uN], compressive positive"
set key top left
set title "Attraction F_c = F_{c0} + c_f F_{Rmax}"
plot f using (strcol(1) eq "dust.flat" ? $4*1e9 : NaN):($5*1e6) with lines lw 2 lc 1 title "c_f = 0", \
     f using (strcol(1) eq "dust.wall" ? $4*1e9 : NaN):($5*1e6) with lines lw 2 lc 2 title "0.05", \
     f using (strcol(1) eq "dust.strong" ? $4*1e9 : NaN):($5*1e6) with lines lw 2 lc 3 title "0.1"
set title "Unloading stiffness K_2"
plot f using (strcol(1) eq "dust.wall" ? $4*1e9 : NaN):($5*1e6) with lines lw 2 lc 2 title "initial slope", \
     f using (strcol(1) eq "dust.average" ? $4*1e9 : NaN):($5*1e6) with lines lw 2 lc 4 title "average slope", \
     f using (strcol(1) eq "dust.constant" ? $4*1e9 : NaN):($5*1e6) with lines lw 2 lc 5 title "K_R/0.7^2, c_f = 0"
unset multiplot
