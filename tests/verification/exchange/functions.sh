# Boxes of gas and dust for tests of the exchange, made by makeCase. A run script sources this
# after tests/tools/lib.sh.

here=$PWD
makeCase=$DUSTFOAM_DIR/tests/verification/exchange/makeCase
calc() { awk "BEGIN { printf \"%.15g\", $1 }"; }

# lattice N LOW STEP: the places of N^3 particles
lattice() { awk -v n="$1" -v a="$2" -v s="$3" 'BEGIN { OFMT = "%.12g"
    for (i = 0; i < n; i++) for (j = 0; j < n; j++) for (k = 0; k < n; k++) print a + s*i, a + s*j, a + s*k }'; }

# program LOG COMMAND...: in the case that holds the log
program()
{
    (cd "${1%/*}" && "${@:2}" > "${1##*/}" 2>&1) || { tail -n 20 "$1"; die "'${*:2}' failed in ${1%/*}"; }
}

# mesh CASE: hexahedra of blockMesh; a test may define another
mesh() { program "$1/log.blockMesh" blockMesh; }

# solve CASE [NAME=VALUE ...]: make the case and run it, on $ranks ranks; its balance of
# momentum must close
ranks=1
solve()
{
    "$makeCase" "$@"
    mesh "$1"
    if [ "$ranks" -eq 1 ]
    then
        program "$1/log.dustFoam" dustFoam
    else
        program "$1/log.decomposePar" decomposePar
        local rank
        for rank in "$1"/processor*
        do
            cp "$1"/constant/places* "$rank/constant"
        done
        program "$1/log.dustFoam" mpirun -np "$ranks" --oversubscribe dustFoam -parallel
    fi
    taken "$1"
}
taken()
{
    local differ
    differ=$(sed -n 's/.*got by the particles differ by at most \([^ ]*\) .*/\1/p' "$1/log.dustFoam")
    expect_between "$1: taken by the gas less got by the particles, over what was exchanged" "$differ" 0 1e-12
}

# velocities CASE: time and mean velocity of the gas along x
velocities() { awk '!/^#/ { gsub(/[()]/, ""); print $1, $2 }' "$1"/postProcessing/momentum/0/*.dat; }

# Dust of a mass loading L and relaxation time tau: density and viscosity for 64 particles of
# 2 um in 1 cm3 of gas of 1.2 kg/m3 (heavy, so that it takes no space; slow, so that drag is linear)
dust() { calc "$1*1.2e-6/(64*3.14159265358979/6*8e-18)"; }
viscosity() { calc "$(dust "$1")*4e-12/(18*$2)"; }

# values FILE: of a particle field, one per line; OpenFOAM writes equal values as N{value}
values()
{
    awk '/^[0-9]+\{.*\}$/ { n = $0 + 0; gsub(/^[^{]*\{|\}$/, ""); while (n-- > 0) print; exit }
        /^[0-9]+\(.*\)$/ { gsub(/^[^(]*\(|\)$/, ""); gsub(/\) \(/, "\n"); gsub(/ /, /\n/ ? " " : "\n"); print; exit }
        /^\($/ { on = 1; next }
        /^\)$/ { exit }
        on' "$1" | tr -d '()'
}

# ends FIELD CASE NX NY: of its last time, means over the first and the last cells along x
ends()
{
    awk -v n="$3" -v m=$(($4*$4)) '/^internalField.*\(.*\)/ { gsub(/.*\(|\).*/, ""); for (i = 0; i < NF; i++) p[i % n] += $(i + 1)/m; exit }
        /^\($/ { on = 1; next } /^\)$/ { exit } on { p[i % n] += $1/m; i++ }
        END { printf "%.12g %.12g\n", p[0], p[n - 1] }' "$2/$(foamListTimes -case "$2" -latestTime 2> /dev/null)/$1"
}

# gradient CASE LENGTH NX NY: of the pressure along a bed [Pa/m]
gradient() { calc "1.2*($(ends p "$1" "$3" "$4" | sed 's/ / - /'))/($2*($3 - 1)/$3)"; }

# ergun PHI MU U SLIP: Ergun's gradient, spheres of 1e-4 m, gas of 1.2 kg/m3, viscous part over SLIP
ergun() { calc "150*$2*$1^2/((1-$1)^2*1e-8*$4)*$3 + 1.75*1.2*$1/((1-$1)*1e-4)*$3^2"; }

# bed PHI RATIO RE DRAG SLIP [NAME [ENTRY=VALUE ...]]: pressure gradient of a bed that nothing moves, in
# cells of RATIO d, over Ergun's with the viscous part divided by SLIP
bed()
{
    local phi=$1 ratio=$2 Re=$3 drag=$4 cc=$5 name=bed-$1-$2-$3-${6:-}
    # a lattice of m spheres across (above 0.53 of m face-centred cells) and twice as many along x, closed
    # by cells of ratio*d; of the largest cells one across and four along
    awk -v phi="$phi" -v q="$ratio" 'BEGIN {
        d = 1e-4; fcc = phi > 0.53; a = d*(3.14159265358979/6/phi*(fcc ? 4 : 1))^(1/3)
        m = q > 5 ? int(q*d/a + 0.5) : q > 3 ? int(2*q*d/a + 0.5) : (q > 0.5 ? 6 : 3) - (q > 0.5 ? 2 : 1)*fcc
        n = q > 5 ? 4*m : 2*m; h = m*a; L = n*a
        ny = int(h/(q*d) + 0.5); if (ny < 1) ny = 1
        print h, L, ny, n/m*ny > "bed.size"
        for (i = 0; i < n; i++) for (j = 0; j < m; j++) for (k = 0; k < m; k++)
            if (!fcc) printf "%.12g %.12g %.12g\n", a*(i + 0.5), a*(j + 0.5), a*(k + 0.5)
            else for (e = 0; e < 4; e++) printf "%.12g %.12g %.12g\n", a*(i + 0.25 + 0.5*(e == 1 || e == 2)),
                a*(j + 0.25 + 0.5*(e == 1 || e == 3)), a*(k + 0.25 + 0.5*(e == 2 || e == 3)) }' > "$name.places"
    read -r h L ny nx < bed.size
    local U mu=1.8e-5 sides=wall
    [ "${phi:2:1}" -lt 6 ] || sides=patch       # that lattice does not end at planes
    U=$(calc "$Re*$mu/(1.2*1e-4)")      # in the gaps
    solve "$name" places="$here/$name.places" diameter=1e-4 density=1e12 modulus=1e18 mu=$mu U="$U" sides=$sides speed='0 0 0' drag="$drag" \
        length="$L" height="$h" nx="$nx" ny="$ny" dt="$(calc "0.1*$h/$U")" end="$(calc "2*$h/$U")" "${@:7}"
    expect_close "bed of $phi, cell/d $ratio, Re $Re ${6:-}: pressure gradient [Pa/m]" "$(gradient "$name" "$L" "$nx" "$ny")" \
        "$(ergun "$phi" $mu "$U" "$cc")" 0.02
}
