# Points of a tube along x made those of one with a bend of 90 degrees about the axis z at y = -B:
# straight until x = l, then round, then straight
#
#   awk -v l= -v B= -f bend.awk constant/polyMesh/points
function bent(x, y, z,    a) {
    a = (x - l)/B
    if (a <= 0) return sprintf("(%.15g %.15g %.15g)", x, y, z)
    if (a < pi/2) return sprintf("(%.15g %.15g %.15g)", l + sin(a)*(B + y), cos(a)*(B + y) - B, z)
    return sprintf("(%.15g %.15g %.15g)", l + B + y, pi/2*B - (x - l) - B, z)
}
BEGIN { pi = atan2(0, -1) }
/^\(-?[0-9].* .* .*\)$/ { gsub(/[()]/, ""); print bent($1, $2, $3); next }
{ print }
