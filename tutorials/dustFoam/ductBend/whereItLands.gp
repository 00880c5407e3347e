# Which size lands where:  gnuplot whereItLands.gp  (whereItLands.csv -> whereItLands.png)
set datafile separator ","
set terminal pngcairo size 900,480
set output "whereItLands.png"
set style data histograms
set style histogram rowstacked
set style fill solid 0.9 border -1
set boxwidth 0.8
set xlabel "diameter [um]"
set ylabel "share of what has landed or left [%]"
set yrange [0:100]
set key outside right reverse invert Left
columns = int(system("head -n 1 whereItLands.csv | tr ',' '\\n' | wc -l"))
plot for [i=3:columns] "whereItLands.csv" using i:xtic(1) title columnheader(i) lc (i < columns ? i - 2 : 0)
