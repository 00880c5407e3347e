# Gmsh file of a block of nx ny nz bricks, or of six tetrahedra for each of them
#
#   awk -f mesh.awk -v shape=box|annulus -v cell=hex|tet -v nx= -v ny= -v nz= \
#       -v lx= -v ly= -v lz= [-v x0=] [-v grading=] [-v shake=] [-v wallTop=1] [-v inside=1] [-v sides=1]
#
# box: lx ly lz from (x0 0 0), wall at y = 0 (wallTop: and at y = ly).
# annulus: the upper half between radius 1 (wall; inside: open) and ly (open; inside: wall), x along
# the flow; nx cells round it.
# grading: last over first cell in y. shake: inner points are moved by this share of a cell.
# sides: left right front back low high are patches instead of open and wall.
# Lengths in units of the caller's choice.
function node(i, j, k) { return 1 + i + (nx + 1)*(j + (ny + 1)*k) }
function height(j) { return q == 1 ? j/ny : (q^j - 1)/(q^ny - 1) }
function noise(n) { n = sin(12.9898*n)*43758.5453; return 2*(n - int(n)) - (n < 0 ? -1 : 1) }

function point(i, j, k,    a, r, di, dj, dk, n)
{
    di = dj = dk = 0
    if (shake && i > 0 && i < nx && j > 0 && j < ny && k > 0 && k < nz)
    {
        n = node(i, j, k)
        di = shake*noise(n); dj = shake*noise(n + 0.3); dk = shake*noise(n + 0.6)
    }
    r = height(j) + dj*(height(j + 1) - height(j))
    if (shape == "box")
        return sprintf("%.17g %.17g %.17g", x0 + lx*(i + di)/nx, ly*r, lz*(k + dk)/nz)
    a = pi*(1 - (i + di)/nx)
    r = 1 + (ly - 1)*r
    return sprintf("%.17g %.17g %.17g", r*cos(a), i == 0 || i == nx ? 0 : r*sin(a), lz*(k + dk)/nz)
}

# A quad of the boundary, corner to corner as the tetrahedra have it
function side(tag, a, b, c, d)
{
    if (cell == "hex") element(3, tag, a " " b " " c " " d)
    else { element(2, tag, a " " b " " c); element(2, tag, a " " c " " d) }
}
function element(type, tag, nodes) { line[++n] = type " 2 " tag " " tag " " nodes }

function tetrahedra(i, j, k,    p, c, m, v)
{
    for (p = 1; p <= 6; p++)
    {
        c[1] = i; c[2] = j; c[3] = k
        v[0] = node(c[1], c[2], c[3])
        for (m = 1; m <= 3; m++) { c[substr(order[p], m, 1)]++; v[m] = node(c[1], c[2], c[3]) }
        element(4, 7, p % 2 ? v[0] " " v[1] " " v[2] " " v[3] : v[0] " " v[2] " " v[1] " " v[3])
    }
}

BEGIN {
    pi = atan2(0, -1); q = grading ? grading^(1/(ny - 1)) : 1
    split("123 132 231 213 312 321", order)
    patches = split(sides ? "left right front back low high" : "open wall", patch)
    print "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n" patches + 1
    for (p = 1; p <= patches; p++) print 2, p, "\"" patch[p] "\""
    print "3 7 \"gas\"\n$EndPhysicalNames\n$Nodes\n" (nx + 1)*(ny + 1)*(nz + 1)
    for (k = 0; k <= nz; k++) for (j = 0; j <= ny; j++) for (i = 0; i <= nx; i++)
        print node(i, j, k), point(i, j, k)
    for (k = 0; k < nz; k++) for (j = 0; j < ny; j++) for (i = 0; i < nx; i += nx)
        for (e = 0; e < 2; e++)
            side(sides ? 1 + e : 1, node(e*nx, j, k), node(e*nx, j + 1, k), node(e*nx, j + 1, k + 1), node(e*nx, j, k + 1))
    for (k = 0; k < nz; k++) for (i = 0; i < nx; i++) for (e = 0; e < 2; e++)
        side(sides ? 3 + e : inside ? 1 + e : e && !wallTop ? 1 : 2, node(i, e*ny, k), node(i + 1, e*ny, k), node(i + 1, e*ny, k + 1), node(i, e*ny, k + 1))
    for (j = 0; j < ny; j++) for (i = 0; i < nx; i++) for (e = 0; e < 2; e++)
        side(sides ? 5 + e : 1, node(i, j, e*nz), node(i + 1, j, e*nz), node(i + 1, j + 1, e*nz), node(i, j + 1, e*nz))
    for (k = 0; k < nz; k++) for (j = 0; j < ny; j++) for (i = 0; i < nx; i++)
        if (cell == "hex")
            element(5, 7, node(i, j, k) " " node(i + 1, j, k) " " node(i + 1, j + 1, k) " " node(i, j + 1, k) \
                " " node(i, j, k + 1) " " node(i + 1, j, k + 1) " " node(i + 1, j + 1, k + 1) " " node(i, j + 1, k + 1))
        else tetrahedra(i, j, k)
    print "$EndNodes\n$Elements\n" n
    for (i = 1; i <= n; i++) print i, line[i]
    print "$EndElements"
}
