# Tracers in a channel with a given profile, gas frozen: do they stay evenly spread? A run script
# sources this after tests/tools/lib.sh, in a directory that holds `case`.
#
# In wall units (u_tau 0.3 m/s, nu 1.5e-5 m2/s: 5e-5 m, 1.67e-4 s) the channel is 800 high; it is 300 m
# long and wide, so that nobody meets anybody or an end of it. Particles: 1e-3 of a wall unit in radius.

perLength=20000
perTime=6000
half=400
lateral=140             # particles along x and z each, 2 m apart

# profile FIELD EDGES: its values in cells between the edges of a half, and mirrored, in SI units.
# U after Reichardt; k and epsilon as in a log layer that ends in the middle, k damped at the wall
profile()
{
    awk -v field="$1" -v edges="$2" -v H=$half -v u=0.3 -v pt=$perTime '
    function at(y,    k, l) {
        if (field == "U") return sprintf("(%.9g 0 0)", u*(log(1 + 0.41*y)/0.41 + 7.8*(1 - exp(-y/11) - y/11*exp(-y/3))))
        k = 3.33*(1 - 0.7*y/H)*(1 - exp(-y/10))^2
        l = y*(1 - y/(2*H))
        if (field == "k") return k*u*u
        if (field == "epsilon") return 0.1643*k^1.5/(0.41*l)*u*u*pt
        return 0.1643*k^0.5/(0.41*l)/0.09*pt }
    BEGIN {
        n = split(edges, e, " ") - 1
        printf "nonuniform List<%s> %d\n(\n", field == "U" ? "vector" : "scalar", 2*n
        for (i = 1; i <= n; i++) print at((e[i] + e[i + 1])/2)
        for (i = n; i >= 1; i--) print at((e[i] + e[i + 1])/2)
        print ")" }'
}

# geometric N G: edges of N cells over the half, the last G times as high as the first
geometric()
{
    awk -v n="$1" -v G="$2" -v H=$half 'BEGIN {
        q = n > 1 ? G^(1/(n - 1)) : 1; d = 1; for (i = 0; i < n; i++) { sum += d; d *= q }
        d = H/sum; y = 0; for (i = 0; i <= n; i++) { printf "%.12g ", y; y += d; d *= q } }'
}

# makeChannel NAME N G TURBULENCE DISPERSION STEP SAMPLE END: the case; times in wall units. The steps are
# such that nobody gets beyond the middle and to the other wall in one of them: what is seen is that of
# one wall
makeChannel()
{
    local name=$1 n=$2 G=$3 model=$4 edges field y
    edges=$(geometric "$n" "$G")
    cp -r case "$name"
    rm -rf "$name"/constant/polyMesh
    cat > "$name/system/blockMeshDict" <<END
FoamFile { version 2.0; format ascii; class dictionary; object blockMeshDict; }
scale 1;
vertices ((-150 0 -150) (150 0 -150) (150 0.04 -150) (-150 0.04 -150) (-150 0 150) (150 0 150) (150 0.04 150) (-150 0.04 150));
blocks (hex (0 1 2 3 4 5 6 7) (1 $((2*n)) 1) simpleGrading (1 ((0.5 0.5 $G) (0.5 0.5 $(awk "BEGIN { printf \"%.12g\", 1/$G }"))) 1));
edges ();
boundary
(
    inlet   { type patch; faces ((0 4 7 3) (0 3 2 1) (4 5 6 7)); }
    outlet  { type patch; faces ((1 2 6 5)); }
    walls   { type wall; faces ((3 7 6 2) (0 1 5 4)); }
);
END
    for field in U k epsilon omega
    do
        profile $field "$edges" > values
        set_ "$name/0/$field" internalField "$(cat values)"
    done
    # nut at walls as nutkWallFunction has it where the first cell is beyond the sublayer
    y=$(awk "BEGIN { split(\"$edges\", e, \" \"); print e[2]/2 }")
    cat > "$name/0/nut" <<END
FoamFile { version 2.0; format ascii; class volScalarField; object nut; }
dimensions [0 2 -1 0 0 0 0];
internalField uniform 0;
boundaryField
{
    walls { type calculated; value uniform $(awk "BEGIN { print $y < 11 ? 0 : 1.5e-5*($y*0.41/log(9.8*$y) - 1) }"); }
    "(inlet|outlet)" { type calculated; value uniform 0; }
}
END
    set_ "$name/constant/turbulenceProperties" RAS/RASModel "$model"
    set_ "$name/constant/dustProperties" subModels/dispersionModel "$5"
    local step
    step=$(awk "BEGIN { printf \"%.12g\", $6/$perTime }")
    set_ "$name/system/controlDict" deltaT "$step"
    set_ "$name/constant/dustProperties" solution/deltaTMax "$step"
    set_ "$name/system/controlDict" writeControl runTime
    set_ "$name/system/controlDict" writeInterval "$(awk "BEGIN { printf \"%.12g\", $7/$perTime }")"
    set_ "$name/system/controlDict" endTime "$(awk "BEGIN { printf \"%.12g\", $8/$perTime }")"
    places $lateral > "$name/constant/places"
    program "log.$name.blockMesh" "$name" blockMesh
}

# places N [SHIFT [GAP]]: of N x N particles, evenly spread over the height but for gaps at the walls [m],
# 2 m apart along x and z
places()
{
    awk -v n="$1" -v shift="${2:-0}" -v gap="${3:-0}" 'BEGIN {
        print "FoamFile { version 2.0; format ascii; class vectorField; object places; }"
        print "("
        for (i = 0; i < n*n; i++) printf "(%.9g %.9g %d)\n", 2*(i % n) - n + shift, gap + (0.04 - 2*gap)*(i + 0.5)/(n*n), 2*int(i/n) - n
        print ")" }'
}

# channel ...: make and run it
channel()
{
    makeChannel "$@"
    program "log.$1" "$1" dustFoam
}

# even NAME FROM: concentration over the mean one and its standard error (from the scatter of
# the samples in ten groups) in bins of y+, of all times from FROM (wall units) on
even()
{
    local time
    for time in $(foamListTimes -case "$1" 2> /dev/null)
    do
        awk "BEGIN { exit !($time*$perTime > $2 - 1) }" || continue
        echo "time"
        values "$1/$time/lagrangian/dust/x" | awk '{ print $2 }'
    done | awk -v H=$half -v pl=$perLength '
    BEGIN { n = split("0 5 10 20 30 40 60 80 100 120 150 180 200 250 300 350 400", e, " ") }
    $1 == "time" { times++; next }
    { y = $1*pl; if (y > H) y = 2*H - y; for (b = 1; b < n; b++) if (y >= e[b] && y < e[b + 1]) c[b, times]++; total++ }
    END { for (b = 1; b < n; b++) {
        m = 0; v = 0; groups = times < 10 ? times : 10
        for (g = 0; g < groups; g++) { s[g] = 0; k[g] = 0 }
        for (t = 1; t <= times; t++) { g = int((t - 1)*groups/times); s[g] += c[b, t]*times/total*H/(e[b + 1] - e[b]); k[g]++; m += c[b, t]/total*H/(e[b + 1] - e[b]) }
        for (g = 0; g < groups; g++) v += (s[g]/k[g] - m)^2
        printf "%g %g %.4f %.4f\n", e[b], e[b + 1], m, sqrt(v/groups/(groups - 1)) } }'
}
