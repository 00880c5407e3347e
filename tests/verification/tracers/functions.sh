# Flows with a closed form, given at the cells' centres and on the boundary, and particles in them.
# For scripts that have sourced lib.sh
tracers=$DUSTFOAM_DIR/tests/verification/tracers

# program LOG CASE COMMAND...
program()
{
    local log=$1 directory=$2
    shift 2
    (cd "$directory" && "$@") > "$log" 2>&1 || { tail -n 20 "$log"; die "'$*' failed in $directory"; }
}

# mesh CASE UNIT OPTION...: as mesh.awk makes it
mesh()
{
    local name=$1 unit=$2 boundary=$1/constant/polyMesh/boundary options=() option
    for option in "${@:3}"
    do
        options+=(-v "$option")
    done
    cp -r "$tracers/case" "$name"
    awk -f "$tracers/mesh.awk" "${options[@]}" > "$name/mesh.msh"
    program "log.gmshToFoam.$name" "$name" gmshToFoam mesh.msh
    awk '/^ *wall$/ { wall = 1 } wall && /type/ { sub(/patch;/, "wall;"); wall = 0 } { print }' \
        "$boundary" > "$boundary.new"
    mv "$boundary.new" "$boundary"
    program "log.transformPoints.$name" "$name" transformPoints -scale "($unit $unit $unit)"
    mkdir "$name/0"
    program "log.writeCellCentres.$name" "$name" postProcess -func writeCellCentres
}

# gas CASE OPTION...: as gas.awk makes it
gas()
{
    local name=$1 options=() option
    for option in "${@:2}"
    do
        options+=(-v "$option")
    done
    awk -f "$tracers/gas.awk" "${options[@]}" "$name/0/C" > "$name/0/U"
    rm "$name"/0/C*
    cat > "$name/0/p" <<- END
		FoamFile { version 2.0; format ascii; class volScalarField; object p; }
		dimensions [0 2 -2 0 0 0 0];
		internalField uniform 0;
		boundaryField { ".*" { type zeroGradient; } }
	END
}

# dust CASE DIAMETER END STEPS LONGEST: particles at the places of the standard input
dust()
{
    { echo 'FoamFile { version 2.0; format ascii; class vectorField; object places; }'
        echo '('; cat; echo ')'; } > "$1/constant/places"
    set_ "$1/constant/dustProperties" \
        subModels/injectionModels/byHand/sizeDistribution/fixedValueDistribution/value "$2"
    set_ "$1/system/controlDict" endTime "$3"
    set_ "$1/system/controlDict" deltaT "$(awk -v t="$3" -v n="$4" 'BEGIN { print t/n }')"
    set_ "$1/constant/dustProperties" solution/deltaTMax "$5"
    program "log.dustFoam.$1" "$1" dustFoam
}

# balance CASE N: deposited and still airborne
balance() { tail -n 1 "$1"/postProcessing/deposition/0/balance.csv | cut -d, -f"$2"; }
