# For the scripts of this folder that draw scenes of other people and those of
# features.txt and large.txt, after common.sh: where they are and how one is
# drawn.
EXAMPLES=$(dpkg -L povray-examples 2> /dev/null | grep '/examples$')
INCLUDES=$(dpkg -L povray-includes 2> /dev/null | sed -n 's,/colors\.inc$,,p')
[ -d "$EXAMPLES" ] || die "povray-examples is missing"
# The user's and the system's povray.ini must not reach the pictures.
: > $work/empty.ini
POVINI=$PWD/$work/empty.ini
export POVINI
measure=$PWD/$work/measure

# draw PROGRAM PICTURE SCENE OPTION...: prints "CPU WALL MEMORY"; nothing if it
# failed, or took 300 s of processor time
draw() {
    program=$1 picture=$2 scene=$3
    shift 3
    (cd "${scene%/*}" 2> /dev/null && ulimit -t 300 &&
        "$measure" "$picture.log" "$program" "+I${scene##*/}" "+O$picture.png" \
            +FN -D -V -P -J +WT1 "+L$INCLUDES" "$@") || return
    # A frame has a number in its name.
    [ ! -f "${picture}01.png" ] || mv "${picture}01.png" "$picture.png"
}

# show_copy NAME: the scene of povray-examples in a folder of its own, since some
# write files beside themselves; remove it when done
show_copy() {
    folder=$(mktemp -d) &&
        find "$EXAMPLES/${1%/*}" -maxdepth 1 -type f -exec cp {} "$folder" \; &&
        echo "$folder/${1##*/}.pov"
}

# show_frame NAME: options of scenes that show one item a frame
show_frame() {
    case $1 in portfolio/*) echo '+KFI1 +KFF20 +SF1 +EF1' ;; esac
}

# rows TABLE: writes the table's scenes, prints "NAME KIND SCENE"
rows() {
    folder=$PWD/$work/ordinary.$1
    mkdir -p "$folder"
    awk -v folder="$folder" -f $bench/scenes.awk $bench/$1.txt |
        while read -r name kind made; do
            case $made in
            '') echo "$name" "$kind" "$folder/$kind-$name.pov" ;;
            *) echo "$name" "$kind" "$PWD/$(scene_file "triangles:${made#*:}")" ;;
            esac
        done
}
