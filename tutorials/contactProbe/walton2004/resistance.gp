# Bending and twisting, to and fro, at the equilibrium overlap
set terminal pngcairo size 1200,540 font "sans,11"
set datafile separator ","
set grid lc rgb "#dddddd"

set output "resistance.png"
set multiplot layout 1,2
B = 2.5e-7*sqrt(2.5e-6*5e-7/(4*pi*2e7*2.5e-6))
set key top left
set xlabel "rolling displacement [nm]"
set ylabel "moment/B_{max} without build-up"
set title "Bending"
f = "postProcessing/cycle_rolling.csv"
plot f using (strcol(1) eq "dust.flat" ? $3*1e9 : NaN):($4/B) with lines lw 2 lc 1 title "c_f = 0", \
     f using (strcol(1) eq "dust.wall" ? $3*1e9 : NaN):($4/B) with lines lw 2 lc 2 title "0.05", \
     f using (strcol(1) eq "dust.strong" ? $3*1e9 : NaN):($4/B) with lines lw 2 lc 3 title "0.1"
set xlabel "twist [rad]"
set title "Twisting, t_f = 0.5"
f = "postProcessing/cycle_twisting.csv"
plot f using (strcol(1) eq "dust.flat" ? $3 : NaN):($4/B) with lines lw 2 lc 1 title "c_f = 0", \
     f using (strcol(1) eq "dust.wall" ? $3 : NaN):($4/B) with lines lw 2 lc 2 title "0.05", \
     f using (strcol(1) eq "dust.strong" ? $3 : NaN):($4/B) with lines lw 2 lc 3 title "0.1"
unset multiplot
