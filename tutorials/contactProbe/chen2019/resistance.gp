# Resistance to rolling and sliding, to and fro, at the equilibrium overlap
set terminal pngcairo size 1200,540 font "sans,11"
set datafile separator ","
set grid lc rgb "#dddddd"

set output "resistance.png"
set multiplot layout 1,2
R = 5e-6
FC = 3*pi*R*0.05
set key top left
set xrange [-4:4]
set yrange [-1.3:2.0]
f = "postProcessing/curves_rolling.csv"
g = "postProcessing/curvesNaive_rolling.csv"
M = 4*FC*0.0085*R
xi = 0.0085*R
set xlabel "rolling displacement/(theta_{crit} R)"
set ylabel "moment/yield moment of the original"
set title "Rolling; dashed: everything softened, weaker by chi^{2/5}"
plot f using ($2 == 1 ? $3/xi : NaN):($4/M) with lines lw 5 lc 1 title "chi = 1", \
     f using ($2 == 0.1 ? $3/xi : NaN):($4/M) with lines lw 3 lc 2 title "0.1", \
     f using ($2 == 0.026 ? $3/xi : NaN):($4/M) with lines lw 1 lc 3 title "0.026", \
     g using ($2 == 0.1 ? $3/xi : NaN):($4/M) with lines lw 2 dt 2 lc 2 title "0.1, all softened", \
     g using ($2 == 0.026 ? $3/xi : NaN):($4/M) with lines lw 2 dt 2 lc 3 title "0.026, all softened"
f = "postProcessing/curves_sliding.csv"
g = "postProcessing/curvesNaive_sliding.csv"
F = 0.3*2*FC
set xrange [*:*]
set xlabel "sliding displacement [nm]"
set ylabel "force/(mu 2 F_C)"
set title "Sliding: the limit stays, the spring is softer"
plot f using ($2 == 1 ? $3*1e9 : NaN):($4/F) with lines lw 2 lc 1 title "chi = 1", \
     f using ($2 == 0.1 ? $3*1e9 : NaN):($4/F) with lines lw 2 lc 2 title "0.1", \
     f using ($2 == 0.026 ? $3*1e9 : NaN):($4/F) with lines lw 2 lc 3 title "0.026", \
     g using ($2 == 0.026 ? $3*1e9 : NaN):($4/F) with lines lw 2 dt 2 lc 3 title "0.026, all softened"
unset multiplot
