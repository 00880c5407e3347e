# Force over overlap in units of F_C and delta_C: JKR with its neck, and without
set terminal pngcairo size 1200,540 font "sans,11"
set datafile separator ","
set grid lc rgb "#dddddd"

set output "forceOverlap.png"
set multiplot layout 1,2
f = "postProcessing/neck_forceOverlap.csv"
R = 5e-6
g = 0.05
E = 2.0879e9
FC = 3*pi*R*g
dC = (9*pi*g*R**2/E)**(2.0/3)/(2*6**(1.0/3)*R)
set xlabel "overlap/delta_C"
set ylabel "force/F_C, compressive positive"
set key top left
set title "A slow load cycle"
plot f using (strcol(1) eq "dust.free" && $3 == 0 ? $4/dC : NaN):($5/FC) with lines lw 4 lc 1 title "JKR, loading", \
     f using (strcol(1) eq "dust.free" && $3 == 1 ? $4/dC : NaN):($5/FC) with lines lw 2 lc 2 title "unloading", \
     f using (strcol(1) eq "dust.simple" ? $4/dC : NaN):($5/FC) with points pt 6 ps 0.6 lc 3 title "simplifiedJKR"
set title "The neck: ends at -delta_C, -5/9 F_C; holds F_C"
set xrange [-1.3:2]
set yrange [-1.2:0.6]
replot
unset multiplot
