# Force over overlap of simplifiedJKR, as it is and scaled by F_C and delta_0
set terminal pngcairo size 1200,540 font "sans,11"
set datafile separator ","
set grid lc rgb "#dddddd"

set output "forceOverlap.png"
set multiplot layout 1,2
f = "postProcessing/curves_forceOverlap.csv"
energy(chi) = 0.11*chi**0.4
R = 0.635e-6
FC(chi) = 3*pi*R*energy(chi)
d0(chi) = (9*pi*energy(chi)*R**2/(2.71e8*chi))**(2.0/3)/(3*R)
set key top left
set xlabel "overlap [nm]"
set ylabel "force [uN], compressive positive"
set title "simplifiedJKR, contact begins and ends at overlap 0"
plot f using ($2 == 1 ? $4*1e9 : NaN):($5*1e6) with lines lw 2 lc 1 title "chi = 1", \
     f using ($2 == 0.1 ? $4*1e9 : NaN):($5*1e6) with lines lw 2 lc 2 title "0.1", \
     f using ($2 == 0.03 ? $4*1e9 : NaN):($5*1e6) with lines lw 2 lc 3 title "0.03"
set xlabel "overlap/delta_0"
set ylabel "force/F_C"
set title "One curve in scaled units; -8/9 at overlap 0"
set xrange [-0.2:3]
set yrange [-1.2:6]
plot f using ($2 == 1 ? $4/d0(1) : NaN):($5/FC(1)) with lines lw 5 lc 1 title "chi = 1", \
     f using ($2 == 0.1 ? $4/d0(0.1) : NaN):($5/FC(0.1)) with lines lw 3 lc 2 title "0.1", \
     f using ($2 == 0.03 ? $4/d0(0.03) : NaN):($5/FC(0.03)) with lines lw 1 lc 3 title "0.03", \
     -8.0/9 with lines dt 2 lc 0 title "-8/9"
unset multiplot
