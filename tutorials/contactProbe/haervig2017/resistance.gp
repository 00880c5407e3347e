# Moment over rolling displacement, to and fro, at the equilibrium overlap
set terminal pngcairo size 1200,540 font "sans,11"
set datafile separator ","
set grid lc rgb "#dddddd"

set output "resistance.png"
set multiplot layout 1,2
f = "postProcessing/curves_rolling.csv"
g = "postProcessing/curvesNaive_rolling.csv"
R = 0.635e-6
FC = 3*pi*R*0.11
a0 = (9*pi*0.11*R**2/2.71e8)**(1.0/3)
M = 4*FC*a0/12*0.4
xi = a0/12*0.4
set xlabel "rolling displacement/xi_{crit}"
set ylabel "moment/yield moment of the original"
set key top left
set xrange [-4:4]
set yrange [-1.3:1.6]
set title "resistance original: the yield stays"
plot f using ($2 == 1 ? $3/xi : NaN):($4/M) with lines lw 5 lc 1 title "chi = 1", \
     f using ($2 == 0.1 ? $3/xi : NaN):($4/M) with lines lw 3 lc 2 title "0.1", \
     f using ($2 == 0.03 ? $3/xi : NaN):($4/M) with lines lw 1 lc 3 title "0.03"
set title "resistance scaled: too weak by chi^{1/5}"
plot g using ($2 == 1 ? $3/xi : NaN):($4/M) with lines lw 2 lc 1 title "chi = 1", \
     g using ($2 == 0.1 ? $3/xi : NaN):($4/M) with lines lw 2 lc 2 title "0.1", \
     0.1**0.2 with lines dt 2 lc 2 title "0.1^{1/5}", \
     g using ($2 == 0.03 ? $3/xi : NaN):($4/M) with lines lw 2 lc 3 title "0.03", \
     0.03**0.2 with lines dt 2 lc 3 title "0.03^{1/5}"
unset multiplot
