# Sourced by the runners of tests/render, tests/conformance, tests/analytic,
# from the project's root: which programs are run, and how POV-Ray is kept
# apart from the machine it happens to run on. Each may be set from outside.

GLIM=${GLIM:-build/glim}            # the program under test
POVRAY=${POVRAY:-povray}            # the program it is compared with
COMPARE=${COMPARE:-${BUILD:-build}/tests/tools/compare}  # of compare.c
GLIM_COMPARE=${GLIM_COMPARE:-${BUILD:-build}/glim-compare}
JOBS=${JOBS:-$(nproc)}              # how many scenes at once

absolute() { # the runners change directory, so a relative path must not stay
    case $1 in
    /*) echo "$1" ;;
    */*) echo "$PWD/$1" ;;
    *) command -v "$1" || echo "$1" ;;
    esac
}

GLIM=$(absolute "$GLIM")
POVRAY=$(absolute "$POVRAY")
COMPARE=$(absolute "$COMPARE")
GLIM_COMPARE=$(absolute "$GLIM_COMPARE")
INCLUDES=$(dpkg -L povray-includes 2>/dev/null |
    sed -n 's,/colors\.inc$,,p')
export GLIM POVRAY COMPARE GLIM_COMPARE JOBS INCLUDES

# The user's and the system's povray.ini must not reach the pictures; an
# empty file does that, a missing one is an error to POV-Ray.
mkdir -p build
: > build/empty.ini
POVINI=$PWD/build/empty.ini
export POVINI

# A sanitizer's report must not look like the exit status of a refusal.
ASAN_OPTIONS=exitcode=99${ASAN_OPTIONS:+:$ASAN_OPTIONS}
UBSAN_OPTIONS=exitcode=99${UBSAN_OPTIONS:+:$UBSAN_OPTIONS}
TSAN_OPTIONS=exitcode=99${TSAN_OPTIONS:+:$TSAN_OPTIONS}
export ASAN_OPTIONS UBSAN_OPTIONS TSAN_OPTIONS

# One thread, no window, no jitter, and the standard includes for both.
SWITCHES="+FN8 -D -V -P -A -J +WT1 +L$INCLUDES"
export SWITCHES

need() { # need PROGRAM...: say at once what is missing, not scene by scene
    for needed; do
        command -v "$needed" > /dev/null && continue
        echo "${0#"$PWD"/}: $needed is missing" >&2
        exit 2
    done
}
