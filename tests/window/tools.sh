# Sourced by window_test.sh: a display of its own, a program whose window is driven on it, and what that reports.
#
# Nothing here waits for a moment. The program prints a report each time its window has come to rest (--window
# --report=json): each input waits for the report that has it handled, and what is asked then stays as it is.
# $state has what the tests need themselves; the present folder belongs to the program.

limit=60 # seconds that a state may take to come, however busy the machine is

failures=0
fail() {
    echo "FAILED: $*"
    failures=$((failures + 1))
}
# die SENTENCE: what follows would say nothing; with what the program said last.
die() {
    echo "FAILED: $*"
    sed 's/^/  standard error: /' "$state/err"
    sed -n '/^  "error"/p; /^  "knobs"/,/^  }/p; /^  "window"/,/^  }/p' "$state/report"
    exit 1
}
equal() { [ "$2" = "$3" ] || fail "$1: expected '$2', found '$3'"; }
atMost() { awk -v a="$2" -v b="$3" 'BEGIN { exit !(a != "" && a + 0 <= b + 0) }' || fail "$1: $2 must be at most $3"; }
atLeast() { awk -v a="$2" -v b="$3" 'BEGIN { exit !(a != "" && a + 0 >= b + 0) }' || fail "$1: $2 must be at least $3"; }

# ---- Display

# openDisplay SIZE OPTIONS...: an X server whose number is its own to find, and which goes with this test however that ends.
# -noreset: else it starts anew whenever the last window has closed, and the next program may come too early.
openDisplay() {
    setpriv --pdeathsig TERM Xvfb -displayfd 4 -screen 0 "$1x24" -noreset -nolisten tcp "${@:2}" \
        4>"$state/display" 2>"$state/server" &
    server=$!
    await "the X server ($(cat "$state/server"))" test -s "$state/display"
    DISPLAY=:$(cat "$state/display")
    export DISPLAY
    unset WAYLAND_DISPLAY XAUTHORITY
}

# ---- Reports

# What the last complete report says, by name; where a widget stands is under "at WIDGET".
declare -A values
# Reads it, into $state/report too.
lastReport() {
    local name value
    values=()
    while IFS=$'\t' read -r name value; do
        [ -n "${values[$name]+set}" ] || values[$name]=$value
    done < <(awk -v file="$state/report" '
        /^{$/ { text = "" } { text = text $0 "\n" } /^}$/ { last = text }
        END {
            printf "%s", last >file
            count = split(last, lines, "\n")
            for (i = 1; i <= count; ++i) {
                line = lines[i]
                if (!sub(/^ *"/, "", line) || !(colon = index(line, "\": "))) continue
                name = substr(line, 1, colon - 1)
                value = substr(line, colon + 3)
                sub(/,$/, "", value)
                if (sub(/^"/, "", value)) sub(/"$/, "", value)
                gsub(/\\"/, "\"", value)
                gsub(/\\\\/, "\\", value)
                if (value == "{" || value == "[") places = name == "places"
                else print (places ? "at " : "") name "\t" value
            }
        }' "$state/out")
}
reported() { echo "${values[$1]-}"; }
# says NAME VALUE...: the window is at rest, and the report has these values.
says() {
    [ "${values[settled]-}" = true ] || return 1
    while [ $# -gt 0 ]; do
        [ "${values[$1]-}" = "$2" ] || return 1
        shift 2
    done
}

# await WHAT COMMAND...: until the command succeeds. It is asked whenever there is another report, and ten times a second,
# for what no report says.
await() {
    local what=$1 deadline=$((SECONDS + limit)) looks
    shift
    for ((looks = 0; ; ++looks)); do
        if ((looks % 5 == 0)) || [ "$state/out" -nt "$state/report" ]; then
            lastReport
            "$@" >/dev/null 2>&1 && return
            if [ -n "$pid" ] && ! kill -0 $pid 2>/dev/null; then
                lastReport
                "$@" >/dev/null 2>&1 && return
                die "the program has ended, in wait for $what"
            fi
            [ $SECONDS -lt $deadline ] || die "waited $limit s in vain for $what"
        fi
        read -rt 0.02 <&9 # sleeps without another program
    done
}
exec 9<> <(:) # which nobody writes to
# awaitReport NAME VALUE...
awaitReport() { await "$*" says "$@"; }

# ---- A program and its window

pid=
# launch PROGRAM ARGUMENTS...: returns when its window has come to rest for the first time.
launch() {
    : >"$state/out"
    "$@" --window --report=json >"$state/out" 2>"$state/err" &
    pid=$!
    keys=0 buttons=0 wheel=0
    awaitReport
}
# start TITLE PROGRAM ARGUMENTS...: the same; `window` is then the window of that title.
start() {
    launch "${@:2}"
    window=$(windowCalled "$1")
    [ -n "$window" ] || die "no window is called '$1'"
}
windowCalled() { xdotool search --onlyvisible --name "^$1\$" | head -1; }
# Escape closes the window, and the program ends with status 0.
quit() {
    xdotool key Escape
    awaitEnd "the end of the program after Escape"
    equal "exit status" 0 $status
    [ $status = 0 ] || sed 's/^/  standard error: /' "$state/err"
}
# awaitEnd WHAT: `status` is then what the program ended with.
awaitEnd() {
    local ending=$pid
    pid=
    await "$1" ended $ending
    wait $ending
    status=$?
}
# ended PROCESS: gone, or nobody has asked yet how it ended.
ended() { ! kill -0 "$1" || grep -q '^State:.Z' "/proc/$1/status"; }

# ---- What a user does; each returns when the window has done its part and is at rest

# press KEY...: one after the other, as xdotool names them (ctrl+s).
press() {
    local key
    for key in "$@"; do
        xdotool key "$key"
        plus=${key//[^+]/}
        keysDone $((${#plus} + 1))
    done
}
keysDone() { # HOW-MANY
    keys=$((keys + $1))
    await "a key to be handled" areKeysDone
    keys=$(reported keys)
}
areKeysDone() { says keys_held 0 && [ "$(reported keys)" -ge $keys ]; }
# Holding control while something else is done.
holdControl() {
    xdotool keydown ctrl
    awaitReport keys_held 1
}
letControl() {
    xdotool keyup ctrl
    keysDone 1
}
# write TEXT: letters, digits and dots.
write() {
    xdotool type --delay 20 "$1"
    keysDone ${#1}
}

# at X Y: the mouse, in the window, in the window's own coordinates.
at() {
    xdotool mousemove --window "$window" $(($1 * perUnit)) $(($2 * perUnit))
    awaitReport mouse "$1,$2"
}
perUnit=1 # pixels of the real screen for each
buttonDown() {
    xdotool mousedown 1
    buttons=$((buttons + 1))
    awaitReport buttons $buttons buttons_held 1
}
buttonUp() {
    xdotool mouseup 1
    awaitReport buttons $buttons buttons_held 0
}
click() { buttonDown && buttonUp; }
# turn BUTTON NOTCHES: the wheel; 4 away from the user, 5 towards.
turn() {
    xdotool click --repeat "$2" "$1"
    wheel=$((wheel + $2))
    awaitReport wheel $wheel
}
# resize WIDTH HEIGHT: the window, and waits for a picture of that size: PICTURE, "440x500".
resize() {
    xdotool windowsize "$window" "$1" "$2"
    await "a picture of $3" pictureIs "$3"
}
pictureIs() { says && [ "$(reported width)x$(reported height)" = "$1" ]; }

# place WIDGET: its middle as it stands now, "x y".
place() {
    local left top right bottom
    IFS=, read -r left top right bottom <<<"${values["at $1"]-}"
    [ -z "$bottom" ] || echo "$(((${left%.*} + ${right%.*}) / 2)) $(((${top%.*} + ${bottom%.*}) / 2))"
}
# reach WIDGET: scrolls the panel by the wheel until all of the widget is in the window.
reach() {
    local left top right bottom height=${values[size]#*x} previous=
    while :; do
        IFS=, read -r left top right bottom <<<"${values["at $1"]-}"
        [ -n "$bottom" ] || die "no widget '$1' in the report"
        [ "${top%.*}" -lt 0 ] || [ "${bottom%.*}" -ge "$height" ] || return 0
        [ "$top" != "$previous" ] || die "'$1' stays out of the window, at $top to $bottom of $height"
        previous=$top
        at $(((${left%.*} + ${right%.*}) / 2)) $((height / 2))
        if [ "${top%.*}" -lt 0 ]; then turn 4 1; else turn 5 1; fi
    done
}
clickOn() { # WIDGET
    reach "$1"
    local x y
    read -r x y <<<"$(place "$1")"
    at "$x" "$y" && click
}

# ---- Pictures

# screenshot FILE.ppm: of the screen come to rest: twice the same, and not of one colour.
screenshot() { await "a screen at rest" twiceTheSame "$1"; }
twiceTheSame() {
    import -window root "$1" && import -window root "$state/again.ppm" && cmp "$1" "$state/again.ppm" &&
        [ "$(identify -format %k "$1")" -gt 1 ]
}
pixel() { convert "$1" -format "%[pixel:p{$2}]" info: | sed 's/a(/(/;s/,1)/)/'; } # FILE X,Y
differing() {                                                                  # FILE FILE: how many pixels
    compare -metric AE "$1" "$2" null: 2>&1
}
sameAsHeadless() { # FILE, by the command line the window reported
    local line
    line=$(reported command)
    sh -c "$line --shot '$state/replay.png'" || fail "the command line '$line' does not run"
    cmp "$1" "$state/replay.png" || fail "the picture of '$line' is not the one in the window"
}
