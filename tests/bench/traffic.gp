# SPDX-License-Identifier: GPL-3.0-or-later
# gnuplot -e "folder='DIR'" traffic.gp: draws DIR/traffic.svg from DIR/traffic.tsv (consensus_bench).
set terminal svg size 1200,460 font "sans,13" background "white"
set output folder."/traffic.svg"
set datafile separator "\t"
set datafile missing NaN  # rows of other plots must not break the lines
set logscale xy 2
set logscale y 10
set xlabel "agents"
set ylabel "kB until the last change (claims: until proven)"
set xtics (2, 4, 8, 16, 32, 64)
set key top left
set xrange [1.8:72]
set multiplot layout 1,3 title "500 tasks, no loss; solid: whole, dashed: as differences, dotted: as orders of tasks"
row(policy, graph, column) = (strcol(4) eq policy && strcol(3) eq graph && $2 == 500) ? column / 1000.0 : NaN
do for [graph in "complete ring line"] {
  set title graph
  plot folder."/traffic.tsv" using 1:(row("claims", graph, $6)) with linespoints lc rgb "#0072b2" pt 7 title "claims", \
       "" using 1:(row("claims", graph, $7)) with linespoints dt 2 lc rgb "#0072b2" pt 7 notitle, \
       "" using 1:(row("claims", graph, $8)) with linespoints dt 3 lc rgb "#0072b2" pt 7 notitle, \
       "" using 1:(row("cbba", graph, $6)) with linespoints lc rgb "#d55e00" pt 5 title "cbba", \
       "" using 1:(row("cbba", graph, $7)) with linespoints dt 2 lc rgb "#d55e00" pt 5 notitle, \
       "" using 1:(row("acbba", graph, $6)) with linespoints lc rgb "#009e73" pt 9 title "acbba"
}
unset multiplot
