# blockMeshDict of a straight round tube along x: radius R, length L; n cells across the half of
# the square in its middle, m from there to the wall, l along it
#
#   awk -v R= -v L= -v n= -v m= -v l= -f tube.awk
function ring(k, i) { return 8*k + 4 + i % 4 }
BEGIN {
    c = 0.55*R/sqrt(2); o = R/sqrt(2); pi = atan2(0, -1)
    split("-1 -1 1 -1 1 1 -1 1", s, " ")
    print "FoamFile { version 2.0; format ascii; class dictionary; object blockMeshDict; }\nscale 1;\nvertices ("
    for (k = 0; k < 2; k++) for (j = 0; j < 2; j++) for (i = 0; i < 4; i++)
        printf "(%.12g %.12g %.12g)\n", k*L, s[2*i + 1]*(j ? o : c), s[2*i + 2]*(j ? o : c)
    print ");\nblocks ("
    printf "hex (0 1 2 3 8 9 10 11) (%d %d %d) simpleGrading (1 1 1)\n", 2*n, 2*n, l
    for (i = 0; i < 4; i++)
        printf "hex (%d %d %d %d %d %d %d %d) (%d %d %d) simpleGrading (1 0.3 1)\n", \
            (i + 1) % 4, i, ring(0, i), ring(0, i + 1), 8 + (i + 1) % 4, 8 + i, ring(1, i), ring(1, i + 1), 2*n, m, l
    print ");\nedges ("
    for (k = 0; k < 2; k++) for (i = 0; i < 4; i++) {
        a = (i - 1)*pi/2
        printf "arc %d %d (%.12g %.12g %.12g)\n", ring(k, i), ring(k, i + 1), k*L, R*cos(a), R*sin(a)
        printf "arc %d %d (%.12g %.12g %.12g)\n", 8*k + i, 8*k + (i + 1) % 4, k*L, 1.2*c*cos(a), 1.2*c*sin(a)
    }
    print ");\nboundary ("
    for (k = 0; k < 2; k++) {
        printf "%s { type patch; faces ( (%d %d %d %d)\n", k ? "outlet" : "inlet", 8*k, 8*k + 1, 8*k + 2, 8*k + 3
        for (i = 0; i < 4; i++)
            printf "(%d %d %d %d)\n", 8*k + i, 8*k + (i + 1) % 4, ring(k, i + 1), ring(k, i)
        print "); }"
    }
    print "wall { type wall; faces ("
    for (i = 0; i < 4; i++) printf "(%d %d %d %d)\n", ring(0, i), ring(0, i + 1), ring(1, i + 1), ring(1, i)
    print "); } );"
}
