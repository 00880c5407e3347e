# Collisions in time, in units that the softening leaves: t chi^{2/5}, overlap chi^{2/5}
set terminal pngcairo size 1200,540 font "sans,11"
set datafile separator ","
set grid lc rgb "#dddddd"

set output "time.png"
set multiplot layout 1,2
f = "postProcessing/time_history.csv"
set xlabel "time chi^{2/5} [us]"
set key bottom left
do for [v in "0.6 0.3"] {
    set title v eq "0.6" ? "0.6 m/s: rebounds" : "0.3 m/s: sticks"
    set ylabel "overlap chi^{2/5} [nm] (lines), 20 x speed/impact speed (dashed)"
    plot for [k = 1:3] c = word("1 0.1 0.026", k) f using ($2 == c + 0 && $3 == v + 0 ? $5*$2**0.4*1e6 : NaN):($6*$2**0.4*1e9) with lines lw 7 - 2*k lc k title "chi = ".c, \
         for [k = 1:3] c = word("1 0.1 0.026", k) f using ($2 == c + 0 && $3 == v + 0 ? $5*$2**0.4*1e6 : NaN):(20*$7/$3) with lines lw 7 - 2*k dt 2 lc k notitle
}
unset multiplot
