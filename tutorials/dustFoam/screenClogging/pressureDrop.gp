# Pressure drop and capture over time:  gnuplot pressureDrop.gp  (writes pressureDrop.png)
set datafile separator ","
set terminal pngcairo size 900,420
set output "pressureDrop.png"
set xlabel "time [ms]"
set ylabel "pressure drop [Pa]"
set y2label "mass of the deposit [ug]"
set y2tics
set ytics nomirror
set key top left
files = system("ls postProcessing/pressureDrop/*/pressureDrop.csv")
plot for [f in files] f using (1e3*$1):2 skip 1 with lines lw 2 lc 1 title (f eq word(files, 1) ? "pressure drop" : ""), \
     for [f in files] f using (1e3*$1):(1e9*$3) skip 1 axes x1y2 with lines lw 2 lc 2 title (f eq word(files, 1) ? "deposit" : "")
