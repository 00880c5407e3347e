# Collisions in time, and the same as force over overlap
set terminal pngcairo size 1200,540 font "sans,11"
set datafile separator ","
set grid lc rgb "#dddddd"

set output "time.png"
set multiplot layout 1,2
f = "postProcessing/time_history.csv"
set xlabel "time [ns]"
set ylabel "overlap [nm]"
set key top right
set title "Two impacts"
plot f using ($3 == 0.5 ? $5*1e9 : NaN):($6*1e9) with lines lw 2 lc 1 title "0.5 m/s: rebounds", \
     f using ($3 == 0.03 ? $5*1e9 : NaN):($6*1e9) with lines lw 2 lc 2 title "0.03 m/s: sticks"
set xlabel "overlap [nm]"
set ylabel "force [uN], compressive positive"
set key top left
set title "The same, force over overlap"
plot f using ($3 == 0.5 ? $6*1e9 : NaN):($8*1e6) with lines lw 2 lc 1 title "0.5 m/s: rebounds", \
     f using ($3 == 0.03 ? $6*1e9 : NaN):($8*1e6) with lines lw 2 lc 2 title "0.03 m/s: sticks"
unset multiplot
