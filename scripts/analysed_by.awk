# By which .cpp files the changed ones are analysed: awk -f analysed_by.awk CHANGED CODE
#
# Both name a file a line, CODE all that there is. Writes a line for each .cpp file to analyse: its name, then the tree's
# headers that it includes, directly or not. A changed header is analysed in one file that includes it: one that is
# analysed anyway, else the .cpp of its own name, else the first one.

# The file that #include "name" means in the file `from`; empty where it is none of the tree's.
function resolve(from, name,    folder, candidate, number, tries) {
    folder = from
    sub(/[^\/]*$/, "", folder)
    tries[1] = folder name; tries[2] = "common/" name; tries[3] = "tests/" name
    for (number = 1; number <= 3; number++) {
        candidate = tries[number]
        while (sub(/[^\/]+\/\.\.\//, "", candidate)) continue
        if (candidate in known) return candidate
    }
    return ""
}

# Adds what `file` includes to includedBy[top, ...] and to the list closure[top].
function follow(top, file,    count, list, number) {
    count = split(direct[file], list, " ")
    for (number = 1; number <= count; number++) {
        if ((top, list[number]) in includedBy) continue
        includedBy[top, list[number]] = 1
        closure[top] = closure[top] " " list[number]
        follow(top, list[number])
    }
}

# The .cpp file by which a changed header is analysed; empty where none includes it, or one is analysed that does.
function reader(header,    number, own) {
    own = header
    sub(/\.h$/, ".cpp", own)
    for (number = 1; number <= sources; number++) {
        if ((source[number] in chosen) && (source[number], header) in includedBy) return ""
    }
    if ((own in known) && (own, header) in includedBy) return own
    for (number = 1; number <= sources; number++) if ((source[number], header) in includedBy) return source[number]
    return ""
}

FILENAME == ARGV[1] { changed[++changes] = $0; next }
{ files[++count] = $0; known[$0] = 1 }

END {
    for (number = 1; number <= count; number++) {
        file = files[number]
        while ((getline line < file) > 0) {
            if (line !~ /^[ \t]*#[ \t]*include[ \t]*"/) continue
            split(line, parts, "\"")
            if ((included = resolve(file, parts[2])) != "") direct[file] = direct[file] " " included
        }
        close(file)
        if (file ~ /\.cpp$/) source[++sources] = file
    }
    for (number = 1; number <= sources; number++) follow(source[number], source[number])
    for (number = 1; number <= changes; number++) if (changed[number] ~ /\.cpp$/) chosen[changed[number]] = 1
    for (number = 1; number <= changes; number++) {
        if (changed[number] !~ /\.cpp$/ && (file = reader(changed[number])) != "") chosen[file] = 1
    }
    for (number = 1; number <= sources; number++) {
        if (source[number] in chosen) print source[number] closure[source[number]]
    }
}
