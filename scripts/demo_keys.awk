# awk -v keys=FOLDER/ -f demo_keys.awk OF-DEMOS LINKED LINKED-SUMS READ-SUMS (see passed.sh): for each test of one demo a file
# FOLDER/NUMBER with the sums that its key is made of, and a line "TEST NUMBER".

# The demo whose own a file is, by the names that the tree and CMake give: shaders/NAME.*, demo-NAME.dir/ ...; else empty.
function ownerOf(file,    name) {
    if (match(file, /demo-[^\/]*\.dir\//)) {
        name = substr(file, RSTART + 5, RLENGTH - 10)
    } else if (match(file, /mvgl-shaders\/demo-/)) {
        name = substr(file, RSTART + RLENGTH)
    } else if (file ~ /^(shaders|docs\/errors-and-times|tests\/twins|demos)\/[^\/]*$/ || file ~ /(^|\/)claims\/[^\/]*$/) {
        name = file
        sub(/.*\//, "", name)
        sub(/\..*/, "", name)
    }
    return (name in demos) ? name : ""
}

# Whether a source of the demo's names the other one, in quotes: what is the other's then counts, too.
function names(demo, other,    text, line, file, number, files) {
    if (!(demo in sources)) {
        files[1] = "demos/" demo ".cpp"; files[2] = "tests/claims/" demo ".cpp"
        for (number = 1; number <= 2; number++) {
            while ((getline line < files[number]) > 0) text = text line "\n"
            close(files[number])
        }
        sources[demo] = text
    }
    return demo == other || index(sources[demo], "\"" other "\"") > 0
}

function put(to, demo, sum, file,    owner) {
    owner = ownerOf(file)
    if (owner == "" || names(demo, owner)) print sum, file > to
}

FILENAME == ARGV[1] { test[++tests] = $1; demoOf[tests] = $2; programOf[tests] = $3; rest[tests] = $0; demos[$2]; next }
FILENAME == ARGV[2] { linked[$1, ++links[$1]] = substr($0, length($1) + 2); next }
FILENAME == ARGV[3] { sumOf[substr($0, 67)] = $1; next }
{ readSum[++reads] = $1; readFile[reads] = substr($0, 67) }

END {
    for (number = 1; number <= tests; number++) {
        to = keys number
        print rest[number] > to
        for (link = 1; link <= links[programOf[number]]; link++) {
            file = linked[programOf[number], link]
            put(to, demoOf[number], sumOf[file], file)
        }
        for (each = 1; each <= reads; each++) put(to, demoOf[number], readSum[each], readFile[each])
        close(to)
        print test[number], number
    }
}
