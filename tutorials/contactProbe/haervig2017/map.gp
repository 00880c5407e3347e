# Restitution over lambda = E/(rho v^2) and Ad = 3 gamma/(rho v^2 r), and the sticking limit
set terminal pngcairo size 900,640 font "sans,11"
set datafile separator ","
set output "map.png"
set logscale xy
set xlabel "Ad = 3 gamma/(rho v_n^2 r)"
set ylabel "lambda = E/(rho v_n^2)"
set cblabel "restitution (grey: sticks)"
set cbrange [0:0.9]
set palette rgbformulae 33,13,10
set key top left opaque
set format x "10^{%L}"
set format y "10^{%L}"
set title "Adhesionless restitution 0.86, sphere on a wall"
f = "postProcessing/mapLambdaAd.csv"
plot f using 2:($3 > 0 ? $1 : NaN):3 with points pt 7 ps 0.8 palette notitle, \
     f using 2:($3 == 0 ? $1 : NaN) with points pt 7 ps 0.5 lc rgb "#bbbbbb" title "sticks", \
     [1:1e4] 0.6328*x**2.5 with lines lw 3 lc 0 title "lambda_{crit} = 0.633 Ad^{5/2}"
