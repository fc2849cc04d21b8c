# For the scripts of this folder, which run at the top of the tree: what a
# scene, a method and a run are. Wants GLIM, POVRAY, THREADS, work, lightings.
bench=tests/bench

die() {
    echo "bench: $*" >&2
    exit 1
}

# table FILE: its lines without comments
table() {
    grep -v '^#' "$bench/$1"
}

# scene_file SCENE: the file, written first if it is a generated one
scene_file() {
    case $1 in
    *:*)
        made=$work/$(echo "$1" | tr : -).pov
        [ -s "$made" ] ||
            $work/generate $(echo "$1" | tr : ' ') > "$made" ||
            die "cannot write $made"
        echo "$made" ;;
    */*)
        file=$(dpkg -L povray-examples 2> /dev/null |
            grep "/examples/$1\.pov\$") || die "povray-examples is missing"
        echo "$file" ;;
    *)
        name=${1%%,*}
        for file in examples/light/$name.pov $bench/$name.pov; do
            [ ! -f "$file" ] || break
        done
        [ -f "$file" ] || die "no scene '$name'"
        echo "$file" ;;
    esac
}

# scene_options SCENE: what it declares
scene_options() {
    case $1 in
    *,*) echo "${1#*,}" | tr , '\n' | sed 's/^/Declare=/' | tr '\n' ' ' ;;
    esac
}

# method_find METHOD: sets program, lighting, options; fails if there is none
method_find() {
    value=${1#*:}
    line=$(table methods.txt | awk -v name="${1%%:*}" '$1 == name')
    if [ -n "$line" ]; then
        program=$(echo "$line" | awk '{ print $2 }')
        lighting=$(echo "$line" | awk '{ print $3 }')
        options=$(echo "$line" | awk -v value="$value" '{
            $1 = $2 = $3 = ""; gsub(/%/, value); sub(/^ *-$/, ""); print }')
    else
        program=glim lighting=$1 options="--lighting $1"
    fi
    case $program in
    povray) command="$POVRAY" options="$options -GA" ;;
    *) command="$GLIM" options="$options --stats --quiet" ;;
    esac
    [ "$lighting" = - ] || echo " $lightings " | grep -q " $lighting "
}

# picture_run METHOD SCENE SIZE FORMAT PICTURE: one run, +FORMAT as POV-Ray
# knows it; prints "CPU WALL MEMORY"; what the program said is in PICTURE.log
picture_run() {
    method_find "$1" || return
    log=$5.log across=${3%%x*} down=${3#*x} samples=-A
    case $3$lighting in
    *+A*) samples=+A0.3 down=${down%+A} ;;
    *x*x*path) ;;
    *x*x*) samples="+A0.0 +AM1 +R${3##*x} -J" ;;
    esac
    set -- $options $(scene_options "$2") +I"$(scene_file "$2")" +O"$5" \
        +"$4" +W"$across" +H"${down%x*}" +WT"$THREADS" $samples -D -V
    if ! $work/measure "$log" "$command" "$@"; then
        echo "bench: failed: $command $*" >&2
        [ -s "$log" ] && tail -20 "$log" >&2 ||
            "$command" "$@" 2>&1 | sed 's/-GA//' | tail -20 >&2
        return 1
    fi
}

# reference METHOD SCENE SIZE FORMAT EXTENSION: a kept picture, made when its
# scene, size or method changed. Prints its name.
reference() {
    file=$(scene_file "$2")
    key=$({ echo "$@"; cat "$file"; } | sha256sum | cut -c 1-24)
    kept=$work/reference/$key.$5 new=$work/reference/new.$5
    if [ ! -s "$kept" ]; then
        mkdir -p "$work/reference"
        echo "bench: making a reference of $2 by $1, kept as $kept" >&2
        rm -f "$new"
        picture_run "$1" "$2" "$3" "$4" "$new" > "$kept.times" || return
        mv "$new" "$kept"
        mv "$new.log" "$kept.log"
    fi
    echo "$kept"
}
