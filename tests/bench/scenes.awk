# Reads features.txt or large.txt and writes FOLDER/NAME.pov for each row, then
# prints "NAME KIND [generate:N]". What a line that begins with a space says
# belongs to the row before.
function finish(    file, text) {
    if (name == "")
        return
    if (kind == "head")
        head = rest
    else if (kind == "frame")
        frame[name] = rest
    else if (rest ~ /^generate:/)
        print name, kind, rest
    else {
        text = rest
        if (kind in frame) {
            text = frame[kind]
            at = index(text, "%")
            text = substr(text, 1, at - 1) rest substr(text, at + 1)
        }
        file = folder "/" kind "-" name ".pov"
        printf "%s\n%s\n", head, text > file
        close(file)
        print name, kind
    }
    name = ""
}

/^#/ { next }

/^ / {
    rest = rest "\n" $0
    next
}

{
    finish()
    kind = $1
    name = $2
    rest = $0
    sub(/^[^ ]+ +[^ ]+ +/, "", rest)
}

END { finish() }
