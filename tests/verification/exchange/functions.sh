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
