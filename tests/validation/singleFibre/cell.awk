# blockMeshDict of the air round a fibre of radius 1 along z, to the circle of radius b (Kuwabara's
# cell): n cells round a quarter, m from the fibre outwards, one along z from 0 to l; lengths times
# unit. Patches: wall, open
#
#   awk -v unit= -v b= -v l= -v n= -v m= -v grading= -f cell.awk
BEGIN {
    print "FoamFile { version 2.0; format ascii; class dictionary; object blockMeshDict; }"
    printf "scale %.12g;\nvertices (\n", unit
    split("1 0 0 1 -1 0 0 -1", c, " ")
    for (z = 0; z < 2; z++) for (k = 0; k < 2; k++) for (i = 0; i < 4; i++)
        printf "(%.12g %.12g %.12g)\n", (k ? b : 1)*c[2*i + 1], (k ? b : 1)*c[2*i + 2], z*l
    print ");\nblocks ("
    for (i = 0; i < 4; i++) {
        j = (i + 1) % 4
        printf "hex (%d %d %d %d %d %d %d %d) (%d %d 1) simpleGrading (%g 1 1)\n", \
            i, i + 4, j + 4, j, i + 8, i + 12, j + 12, j + 8, m, n, grading
        arcs = arcs sprintf("arc %d %d (%.12g %.12g 0)\narc %d %d (%.12g %.12g 0)\n", i, j, s(i), s(i + 3), i + 4, j + 4, b*s(i), b*s(i + 3)) \
            sprintf("arc %d %d (%.12g %.12g %.12g)\narc %d %d (%.12g %.12g %.12g)\n", i + 8, j + 8, s(i), s(i + 3), l, i + 12, j + 12, b*s(i), b*s(i + 3), l)
        wall = wall sprintf("(%d %d %d %d)\n", i, j, j + 8, i + 8)
        open = open sprintf("(%d %d %d %d)\n(%d %d %d %d)\n(%d %d %d %d)\n", i + 4, i + 12, j + 12, j + 4, \
            i, j, j + 4, i + 4, i + 8, i + 12, j + 12, j + 8)
    }
    print ");\nedges (\n" arcs ");\nboundary ( wall { type wall; faces (\n" wall "); } open { type patch; faces (\n" open "); } );"
}
# x of the middle of quarter i; its y is that of i + 3
function s(i) { return (i % 4 == 0 || i % 4 == 3 ? 1 : -1)*sqrt(0.5) }
