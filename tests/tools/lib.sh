# Helpers for the tests' run scripts. A run script starts with
#
#   #!/bin/bash
#   source "$DUSTFOAM_DIR/tests/tools/lib.sh"
#
# which sets -euo pipefail. Every expect_* prints one line and goes on; the script
# ends with exit code 1 if one of them failed, or if it made no check at all.
#
#   expect_close NAME VALUE EXPECTED TOL   |VALUE - EXPECTED| <= TOL |EXPECTED|
#                                          (EXPECTED 0: |VALUE| <= TOL)
#   expect_between NAME VALUE LOW HIGH     LOW <= VALUE <= HIGH
#   expect_true NAME COMMAND [ARG ...]     COMMAND succeeds
#   expect_false NAME COMMAND [ARG ...]    COMMAND fails
#   expect_in NAME FILE REGEX              a line of FILE matches (grep -E)
#   figure NAME VALUE [UNIT]               a number to show, not judged
#   set_ FILE ENTRY VALUE                  of a dictionary
#   die MESSAGE                            stop here: failed

set -euo pipefail

checks=0
failures=0

# Not a number (nan, inf, empty) is always a failure
number()
{
    [[ $1 =~ ^[-+]?([0-9]+\.?[0-9]*|\.[0-9]+)([eE][-+]?[0-9]+)?$ ]]
}

verdict()
{
    local result=$1
    shift
    checks=$((checks + 1))
    if [ "$result" -eq 0 ]
    then
        echo "ok   $*"
    else
        failures=$((failures + 1))
        echo "FAIL $*"
    fi
}

expect_close()
{
    local result=1
    if number "$2" && number "$3"
    then
        awk -v v="$2" -v e="$3" -v t="$4" 'BEGIN {
            d = v - e; if (d < 0) d = -d
            s = e < 0 ? -e : e; if (s == 0) s = 1
            exit !(d <= t*s) }' && result=0
    fi
    verdict $result "$1: $2, expected $3 within $4"
}

expect_between()
{
    local result=1
    if number "$2"
    then
        awk -v v="$2" -v a="$3" -v b="$4" 'BEGIN { exit !(a <= v && v <= b) }' && result=0
    fi
    verdict $result "$1: $2, expected $3 .. $4"
}

expect_true()
{
    local name=$1 result=0
    shift
    "$@" || result=$?
    verdict $result "$name"
}

expect_false()
{
    local name=$1 result=1
    shift
    "$@" || result=0
    verdict $result "$name"
}

expect_in()
{
    local result=0
    grep -Eq -- "$3" "$2" || result=1
    verdict $result "$1: '$3' in $2"
}

figure()
{
    echo "figure $1: ${*:2}"
}

set_() { foamDictionary "$1" -entry "$2" -set "$3" > /dev/null || die "cannot set $2 in $1"; }

die()
{
    echo "FAIL $*"
    exit 1
}

finishTest()
{
    local code=$?
    if [ $code -eq 0 ] && [ $checks -eq 0 ]
    then
        echo "FAIL this test checked nothing"
        code=1
    fi
    echo "$checks checks, $failures failed"
    [ $failures -eq 0 ] || code=1
    exit $code
}
trap finishTest EXIT

# compile_dem SOURCE PROGRAM [FLAG ...]: a C++ program that uses the DEM library only
compile_dem()
{
    # shellcheck disable=SC2046 # mpicxx prints several words
    g++ -std=c++17 -O2 -march="${DUSTFOAM_MARCH:-x86-64-v3}" -DEIGEN_MAX_ALIGN_BYTES=32 -Wall -Wextra -Wno-cast-function-type \
        -I"$DUSTFOAM_DIR/src/DEM" -I"$DUSTFOAM_DIR/tests/tools/DEM" -isystem "${DUSTFOAM_EIGEN:-/usr/include/eigen3}" \
        $(mpicxx --showme:compile) "${@:3}" "$1" -o "$2" -L"$FOAM_USER_LIBBIN" -lDEM \
        $(mpicxx --showme:link) || die "$1 does not compile"
}
