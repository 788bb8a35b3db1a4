# awk -v keys=FOLDER/ -v machine=TEXT -f demo_keys.awk OF-DEMOS LINKED LINKED-SUMS READ-SUMS (see passed.sh): for each test of
# one demo a file FOLDER/NUMBER with the text and the sums that its key is made of, and a line "TEST NUMBER".

# The demo whose own a file is, by the names that the tree and CMake give: demos/NAME/*, shaders/NAME.*, demo-NAME.dir/ ...; else
# empty.
# A golden picture's is the one that draws it.
function ownerOf(file,    name) {
    if (file in drawnBy) return drawnBy[file]
    if (match(file, /(demo|twin)-[^\/]*\.dir\//)) {
        name = substr(file, RSTART + 5, RLENGTH - 10)
    } else if (match(file, /^(demos|shaders|tests)\/[^\/]+\//) || match(file, /test-claims\.dir\/[^\/]+\/claims\.cpp/)) {
        name = file
        sub(/.*test-claims\.dir\//, "", name)
        sub(/^(demos|shaders|tests)\//, "", name)
        sub(/\/.*/, "", name)
        if (name == "claims" || name == "twins") name = flatName(file)
    } else if (match(file, /mvgl-shaders\/demo-/)) {
        name = substr(file, RSTART + RLENGTH)
    } else if (file ~ /^(shaders|docs\/errors-and-times|tests\/twins|demos)\/[^\/]*$/ || file ~ /(^|\/)claims\/[^\/]*$/) {
        name = flatName(file)
    }
    return (name in demos) ? name : ""
}

function flatName(file) {
    sub(/.*\//, "", file)
    sub(/\..*/, "", file)
    return file
}

function textOf(file,    text, line) {
    if (!(file in texts)) {
        while ((getline line < file) > 0) text = text line "\n"
        close(file)
        texts[file] = text
    }
    return texts[file]
}

function textsOfFolder(demo,    folder) {
    folder = "demos/" demo "/"
    return textOf(folder demo ".cpp") textOf(folder "knobs.cpp") textOf(folder "study.cpp") textOf("tests/" demo "/claims.cpp")
}

# Whether a source of the demo's names the other one, in quotes, or a page that is read has a command, or a number, of it:
# what is the other's then counts, too.
function names(number, other,    demo) {
    demo = demoOf[number]
    if (demo == other) return 1
    if (index(textOf("demos/" demo ".cpp") textOf("tests/claims/" demo ".cpp") textsOfFolder(demo), "\"" other "\"") > 0) return 1
    return reads[number] == "pages" && (textOf("demos/" demo ".md") textOf("demos/" demo "/" demo ".md")) ~ ("(run|study) " other "[^a-z0-9-]")
}

# Golden pictures and pages are read only by the tests that say so.
function isRead(number, file) {
    if (file ~ /^tests\/goldens\//) return reads[number] == "goldens"
    if (file ~ /\.md$/) return reads[number] == "pages" && file ~ /^demos\//
    return 1
}

function put(to, number, sum, file,    owner) {
    owner = ownerOf(file)
    if (owner == "" || names(number, owner)) print sum, file > to
}

BEGIN {
    cases = "tests/goldens/cases.txt"
    while ((getline < cases) > 0) {
        if ($1 == "" || $1 ~ /^#/) continue
        drawnBy["tests/goldens/" $1 ".png"] = $2
        casesOf[$2] = casesOf[$2] $0 "\n"
    }
    close(cases)
}

FILENAME == ARGV[1] {
    test[++tests] = $1; demoOf[tests] = $2; programsOf[tests] = $3; rest[tests] = $0; demos[$2]
    reads[tests] = $4 ~ /^reads:/ ? substr($4, 7) : ""
    next
}
FILENAME == ARGV[2] { linked[$1, ++links[$1]] = substr($0, length($1) + 2); next }
FILENAME == ARGV[3] { sumOf[substr($0, 67)] = $1; next }
{ readSum[++files] = $1; readFile[files] = substr($0, 67) }

END {
    for (number = 1; number <= tests; number++) {
        to = keys number
        print machine > to
        print rest[number] > to
        count = split(programsOf[number], programs, ",")
        for (each = 1; each <= count; each++) {
            for (link = 1; link <= links[programs[each]]; link++) {
                file = linked[programs[each], link]
                put(to, number, sumOf[file], file)
            }
        }
        for (each = 1; each <= files; each++) {
            file = readFile[each]
            if (file == cases) {
                # Of the list of pictures, what is the demo's.
                if (isRead(number, file)) print casesOf[demoOf[number]] > to
            } else if (isRead(number, file)) {
                put(to, number, readSum[each], file)
            }
        }
        close(to)
        print test[number], number
    }
}
