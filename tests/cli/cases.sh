# What suites of cases share: sourced in the project's folder with $GLIM set. A
# case is a function case_NAME, which fails when it returns false and runs in a
# directory of its own; the last line of the suite is `run_cases SUITE "$@"`.
top=$PWD
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
unset POVINI
HOME=$work export HOME

# ---- helpers -------------------------------------------------------------

glim() { # runs glim; $status, ./out and ./err are what it left
    "$GLIM" "$@" > out 2> err < /dev/null
    status=$?
}

ok() { # ARGUMENT...: glim must succeed and say nothing
    glim "$@"
    [ $status -eq 0 ] && [ ! -s err ] ||
        { echo "    glim $*: status $status"; sed 's/^/    /' err; return 1; }
}

fails() { # TEXT ARGUMENT...: status 1, and the text somewhere in the message
    text=$1
    shift
    glim "$@"
    [ $status -eq 1 ] && grep -qF -- "$text" err && return
    echo "    glim $*: status $status, wanted: $text"
    sed 's/^/    /' err
    return 1
}

warns() { # TEXT ARGUMENT...: status 0 and a warning
    text=$1
    shift
    glim "$@"
    [ $status -eq 0 ] && grep -qF -- "glim: warning: $text" err && return
    echo "    glim $*: status $status, wanted: warning: $text"
    sed 's/^/    /' err
    return 1
}

size() { # FILE: WIDTHxHEIGHT and the kind of numbers
    oiiotool --info "$1" | sed 's/^.*: *\([0-9]*\) x *\([0-9]*\), \([0-9]\) channel, \([a-z0-9]*\) .*/\1x\2 \3 \4/'
}

is() { # FILE WANTED: as size says
    [ "$(size "$1")" = "$2" ] || { echo "    $1: $(size "$1"), not $2"; return 1; }
}

pixel() { # FILE X Y: the numbers in the file, not premultiplied
    oiiotool -q --iconfig oiio:UnassociatedAlpha 1 --dumpdata "$1" |
        sed -n "s/^ *Pixel ($2, $3): *\([0-9. -]*[0-9]\).*/\1/p"
}

same() { # FILE FILE: equal pixels
    oiiotool -q --diff "$1" "$2" > /dev/null || { echo "    $1 and $2 differ"; return 1; }
}

until_true() { # COMMAND...: waits for a state, a minute at most
    for _ in $(seq 1200); do
        "$@" > /dev/null 2>&1 && return
        sleep 0.05
    done
    echo "    waited for a minute: $*"
    return 1
}

small='+W16 +H12'

scenes() { # what all cases find in their directory
    cat > scene.pov << 'END'
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location -5*z look_at 0 right 4*x up 3*y }
box { <-2, -2, 0>, <0, 2, 1>
  pigment { rgbt <0.5, 0.18, 0.002, 0> }
  finish { ambient 0 diffuse 0 emission 1 } }
box { <0, -2, 0>, <1, 2, 1>
  pigment { rgbt <0.5, 0.25, 1, 0.5> }
  finish { ambient 0 diffuse 0 emission 1 } }
END
    cat > clock.pov << 'END'
#version 3.7;
global_settings { assumed_gamma 1 }
#debug concat("clock ", str(clock, 0, 3), " delta ", str(clock_delta, 0, 3),
  " on ", str(clock_on, 0, 0), " frame ", str(frame_number, 0, 0),
  " of ", str(initial_frame, 0, 0), " ", str(final_frame, 0, 0),
  " size ", str(image_width, 0, 0), " ", str(image_height, 0, 0), "\n")
camera { location -5*z look_at 0 }
background { rgb 0.1 }
END
    cat > slow.pov << 'END'
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 20 }
camera { location <0, 1, -5> look_at 0 }
light_source { <5, 9, -5>, 1 area_light 3*x, 3*y, 17, 17 }
plane { y, -1 pigment { checker rgb 1, rgb 0.5 } finish { reflection 0.5 } }
sphere { 0, 1 pigment { rgb 1 } finish { reflection 0.5 } }
END
}

# ---- running them ----------------------------------------------------------

run_cases() { # SUITE [CASE...]
    suite=$1
    shift
    passed=0 failed=0
    for name in ${*:-$(sed -n 's/^case_\([a-z_0-9]*\)() {.*/\1/p' "$top/tests/$suite/run")}; do
        mkdir "$work/$name" && cd "$work/$name" || exit 1
        scenes
        if "case_$name"; then
            passed=$((passed + 1))
        else
            echo "$suite/$name: FAILED"
            failed=$((failed + 1))
        fi
        cd "$top" || exit 1
    done
    echo "$suite: $passed passed, $failed failed"
    [ $failed -eq 0 ]
}
