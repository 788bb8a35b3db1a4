#!/usr/bin/env bash
# window_test.sh CASE CUBE-CULL LAUNCHER: one test of the window, on a display of its own.
#
# It does with xdotool what a user does with keyboard and mouse, closes the window with Escape, and looks at what the
# program then reports (--window --report=json): settings, frames drawn, and where each widget stood.
set -u
case=$1 cubeCull=$2 launcher=$3

for tool in xvfb-run xdotool import; do
    command -v $tool >/dev/null || {
        echo "FAILED: $tool is missing; install the packages xvfb, xauth, xdotool and imagemagick"
        exit 1
    }
done
# -noreset: else the server starts anew whenever the last window has closed, and the next program may come too early.
if [ "${4:-}" != inside ]; then
    folder=$(mktemp -d) || exit 1
    runtime=$(mktemp -d) || exit 1
    trap 'rm -rf "$folder" "$runtime"' EXIT
    cd "$folder" || exit 1
    # Wayland's library complains on standard error where there is none, before GLFW turns to X.
    [ -n "${XDG_RUNTIME_DIR:-}" ] || export XDG_RUNTIME_DIR=$runtime
    xvfb-run -a -n "${MVGL_TEST_DISPLAY:-99}" -s "-screen 0 1280x1024x24 -noreset" bash "$(cd "$OLDPWD" && realpath "$0")" "$case" "$cubeCull" "$launcher" inside
    exit $?
fi

# ---- Tools

failures=0
fail() {
    echo "FAILED: $*"
    failures=$((failures + 1))
}
equal() { [ "$2" = "$3" ] || fail "$1: expected '$2', found '$3'"; }
atMost() { awk -v a="$2" -v b="$3" 'BEGIN { exit !(a != "" && a + 0 <= b + 0) }' || fail "$1: $2 must be at most $3"; }
atLeast() { awk -v a="$2" -v b="$3" 'BEGIN { exit !(a != "" && a + 0 >= b + 0) }' || fail "$1: $2 must be at least $3"; }

# As slowly as a hand: newer Dear ImGui asks for the state of Control when the key arrives, not when it was pressed.
withControl() {
    xdotool keydown ctrl && sleep 0.15 && xdotool key "$1" && sleep 0.15 && xdotool keyup ctrl
}

# Waits up to 20 s (the machine may be busy) until the command succeeds.
waitFor() {
    for _ in $(seq 200); do
        "$@" >/dev/null 2>&1 && return 0
        sleep 0.1
    done
    fail "waited in vain for: $*"
    return 1
}
windowCalled() { xdotool search --onlyvisible --name "^$1\$"; }

pid=
# start TITLE PROGRAM ARGUMENTS...: returns when the window is there and has come to rest.
start() {
    local title=$1
    shift
    "$@" >out 2>err &
    pid=$!
    waitFor windowCalled "$title" || {
        cat err
        kill $pid 2>/dev/null
        exit 1
    }
    window=$(windowCalled "$title" | head -1)
    settle
}
settle() { sleep 0.5; }
# Escape closes the window, and the program ends with status 0.
quit() {
    xdotool key Escape
    for _ in $(seq 200); do
        kill -0 $pid 2>/dev/null || break
        sleep 0.1
    done
    kill -0 $pid 2>/dev/null && fail "Escape does not close the window" && kill $pid
    wait $pid
    equal "exit status" 0 $?
}
at() { xdotool mousemove --window "$window" "$1" "$2"; }
# What the report says: the first line with that name, which is the setting of a knob rather than its place.
reported() { sed -n "s/^ *\"$1\": \"\{0,1\}\([^\"]*[^\",]\)\"\{0,1\},\{0,1\}$/\1/p" "${2:-out}" | head -1; }
# The middle of a widget, "x y"; it is asked of a window that is opened and closed once more.
place() {
    awk -v name="\"$1\":" '/"places"/ { inside = 1 } inside && index($0, name) {
        gsub(/[",]/, " ", $0); n = split($0, w, " ")
        print int((w[n - 3] + w[n - 1]) / 2), int((w[n - 2] + w[n]) / 2); exit }' places
}
learnPlaces() {
    start "$@"
    quit
    cp out places
}
clickOn() {
    local x y
    read -r x y <<<"$(place "$1")"
    [ -n "$y" ] || {
        fail "no widget '$1' in the report"
        return
    }
    at "$x" "$y"
    sleep 0.2
    xdotool click 1
    sleep 0.3
}
sameAsHeadless() { # FILE, by the command line the window reported
    local line
    line=$(reported command)
    # shellcheck disable=SC2086
    (set -- $line && shift && "$cubeCull" "$@" --shot replay.png) || fail "the command line '$line' does not run"
    cmp "$1" replay.png || fail "the picture of '$line' is not the one in the window"
}

# ---- Cases

opens() {
    start 'mvgl: cube-cull' "$cubeCull" --window --report=json
    equal "window's size" "960x600" "$(xdotool getwindowgeometry "$window" | sed -n 's/.*Geometry: //p')"
    import -window root screen.png
    # The picture's corner has its background, the panel its own, and the picture is where it belongs.
    equal "corner of the picture" "srgb(230,255,255)" "$(convert screen.png -format '%[pixel:p{3,3}]' info: | sed 's/a(/(/;s/,1)/)/')"
    equal "middle of the picture" "srgb(0,0,255)" "$(convert screen.png -format '%[pixel:p{300,290}]' info: | sed 's/a(/(/;s/,1)/)/')"
    equal "corner of the panel" "srgb(30,33,38)" "$(convert screen.png -format '%[pixel:p{603,3}]' info: | sed 's/a(/(/;s/,1)/)/')"
    quit
    equal "picture's width" 600 "$(reported width)"
    equal "picture's height" 600 "$(reported height)"
    equal "command" cube-cull "$(reported command)"
    equal "files left in the folder" "err out screen.png" "$(ls | tr '\n' ' ' | sed 's/ $//')"
    equal "standard error" "" "$(cat err)"
}

keys() {
    start 'mvgl: cube-cull' "$cubeCull" --window --report=json
    for _ in 1 2 3; do xdotool key Up && sleep 0.1; done
    quit
    equal "z-dist after three times Up" -3.4 "$(reported z-dist)"
    start 'mvgl: cube-cull' "$cubeCull" --window --report=json
    xdotool keydown Down && sleep 1.5 && xdotool keyup Down # held down, it repeats
    quit
    atMost "z-dist after Down was held" "$(reported z-dist)" -4.6
    start 'mvgl: probe' "$launcher" probe --window --report=json
    xdotool key KP_4 && sleep 0.2 # the number pad
    xdotool key s && sleep 0.2    # the demo has S for itself
    quit
    equal "count after 4 on the number pad" 4 "$(reported count)"
    equal "level after S" 0.375 "$(reported level)"
    equal "pictures saved by a key that the demo has for itself" "" "$(ls ./*.png 2>/dev/null)"
}

slider() {
    learnPlaces 'mvgl: cube-cull' "$cubeCull" --window --report=json
    start 'mvgl: cube-cull' "$cubeCull" --window --report=json
    read -r x y <<<"$(place z-dist)"
    at $((x - 40)) "$y" && sleep 0.2 && xdotool mousedown 1 && sleep 0.2
    at $((x + 60)) "$y" && sleep 0.3 && xdotool mouseup 1 && sleep 0.2
    at 300 300
    quit
    # The bar runs from -10 to 10 over some 220 pixels; 60 right of its middle is between 4 and 7.
    atLeast "z-dist" "$(reported z-dist)" 4
    atMost "z-dist" "$(reported z-dist)" 7
    start 'mvgl: cube-cull' "$cubeCull" --z-dist 3 --cull none --window --report=json
    clickOn "Reset all"
    quit
    equal "command after Reset all" cube-cull "$(reported command)"
}

typed() {
    learnPlaces 'mvgl: cube-cull' "$cubeCull" --window --report=json
    start 'mvgl: cube-cull' "$cubeCull" --window --report=json
    read -r x y <<<"$(place z-dist)"
    typeValue() {
        at "$x" "$y" && sleep 0.2
        xdotool keydown ctrl && sleep 0.1 && xdotool click 1 && sleep 0.1 && xdotool keyup ctrl && sleep 0.3
        withControl a && xdotool type --delay 60 "$1" && xdotool key Return && sleep 0.3
    }
    typeValue 2.125
    quit
    equal "typed z-dist" 2.125 "$(reported z-dist)"
    start 'mvgl: cube-cull' "$cubeCull" --window --report=json
    typeValue 99
    import -window root screen.png
    # Refused, its field red, and not moved to the nearest value that is allowed.
    atLeast "red pixels of the field" "$(convert screen.png -crop 360x600+600+0 -fuzz 1% -fill white -opaque 'rgb(84,23,23)' \
        -fill black +opaque white -format '%[fx:mean*w*h]' info:)" 100
    xdotool key Escape && sleep 0.3 # leaves the field, and only that
    kill -0 $pid || fail "Escape in a field closed the window"
    quit
    equal "z-dist after 99 was refused" -4 "$(reported z-dist)"
}

choice() {
    learnPlaces 'mvgl: cube-cull' "$cubeCull" --window --report=json
    start 'mvgl: cube-cull' "$cubeCull" --window --report=json
    clickOn cull
    xdotool key Escape && sleep 0.3 # closes the list, and only that
    kill -0 $pid || fail "Escape in a list closed the window"
    clickOn cull
    read -r x y <<<"$(place cull)"
    at "$x" $((y + 72)) && sleep 0.2 && xdotool click 1 && sleep 0.3 # some entry below
    clickOn depth
    quit
    [ "$(reported cull)" != back ] || fail "the list did not change the choice"
    equal "depth after a click" off "$(reported depth)"
}

wheel() {
    start 'mvgl: cube-cull' "$cubeCull" --window --report=json
    at 300 300 && sleep 0.2
    for _ in 1 2 3; do xdotool click 4 && sleep 0.1; done
    at 780 300 && sleep 0.2
    for _ in 1 2; do xdotool click 5 && sleep 0.1; done # over the panel: it scrolls
    quit
    equal "z-dist after three notches" -4.6 "$(reported z-dist)"
}

drag() {
    start 'mvgl: cube-cull' "$cubeCull" --window --report=json
    at 300 300
    xdotool mousedown 1
    at 340 300
    at 340 330
    xdotool mouseup 1
    at 100 100 # no button: nothing turns
    settle
    quit
    equal "spin-y after 40 pixels to the right" -40 "$(reported spin-y)"
    equal "spin-x after 30 pixels down" 30 "$(reported spin-x)"
    # A drag that begins on the panel is the panel's, wherever it goes.
    start 'mvgl: cube-cull' "$cubeCull" --window --report=json
    at 700 20 && sleep 0.2 && xdotool mousedown 1 && sleep 0.1
    at 300 300 && sleep 0.1 && at 320 300 && sleep 0.1 && xdotool mouseup 1
    settle
    quit
    equal "spin-y after a drag from the panel" 0 "$(reported spin-y)"
}

replay() {
    RANDOM=4711
    start 'mvgl: cube-cull' "$cubeCull" --window --report=json
    at 300 300 && xdotool mousedown 1
    for _ in $(seq 25); do at $((RANDOM % 590 + 5)) $((RANDOM % 590 + 5)); done
    xdotool mouseup 1 && xdotool click 4 && xdotool click 4
    xdotool key s
    settle
    quit
    [ "$(reported spin-y)" != 0 ] || fail "the drags moved nothing"
    sameAsHeadless cube-cull-1.png
}

save() {
    start 'mvgl: cube-cull' "$cubeCull" --window --report=json
    xdotool key s && sleep 0.3 && xdotool key s && sleep 0.3
    cp cube-cull-1.png first.png && xdotool key Up && xdotool key s && sleep 0.5
    quit
    equal "files" "cube-cull-1-2.png cube-cull-1-3.png cube-cull-1.png" "$(ls cube-cull*.png | tr '\n' ' ' | sed 's/ $//')"
    cmp first.png cube-cull-1.png || fail "a saved picture was replaced"
    cmp cube-cull-1.png cube-cull-1-2.png || fail "the same picture gave other bytes"
    sameAsHeadless cube-cull-1-3.png
    # A folder that cannot be written to: a sentence, and the window stays.
    mkdir gone && (cd gone && exec "$cubeCull" --window --report=json >../out 2>../err) &
    pid=$!
    waitFor windowCalled 'mvgl: cube-cull' && settle
    rmdir gone && xdotool key s && sleep 0.5
    grep -q '^error: .*could not be\|^error: .*cannot' err || fail "no error for a folder that is gone: $(cat err)"
    kill -0 $pid || fail "the window closed"
    quit
}

clipboard() {
    learnPlaces 'mvgl: cube-cull' "$cubeCull" --size 600x1000 --window --report=json
    start 'mvgl: cube-cull' "$cubeCull" --size 600x1000 --window --report=json
    clickOn "Copy command line"
    clickOn "file name" # the way to look into the clipboard: paste it, and save under that name
    withControl v && sleep 0.3 && xdotool key Return && sleep 0.2
    clickOn "Save picture"
    quit
    [ -f "cube-cull --size 600x1000.png" ] || fail "the clipboard did not have the command line: $(ls)"
}

error() {
    start 'mvgl: cube-cull' "$cubeCull" --z-dist -0.2 --window --report=json
    import -window root before.png
    xdotool key Up && sleep 0.5
    import -window root after.png
    convert before.png -crop 600x600+0+0 +repage a.png && convert after.png -crop 600x600+0+0 +repage b.png
    equal "pixels changed of the last good picture" 0 "$(compare -metric AE a.png b.png null: 2>&1)"
    xdotool key s && sleep 0.3
    equal "pictures saved of settings that make none" "" "$(ls cube-cull*.png 2>/dev/null)"
    quit
    equal "the report's error" "--z-dist: must not be 0: the eye would stand on the point it looks at" "$(reported error)"
    equal "z-dist" 0 "$(reported z-dist)"
    start 'mvgl: cube-cull' "$cubeCull" --z-dist -0.2 --window --report=json
    xdotool key Up && sleep 0.3 && xdotool key Up && sleep 0.3
    quit
    equal "error after it was mended" "" "$(reported error)"
    equal "z-dist" 0.2 "$(reported z-dist)"
}

resize() {
    start 'mvgl: cube-cull' "$cubeCull" --window --report=json
    xdotool windowsize "$window" 800 500 && settle
    xdotool key s && sleep 0.5
    quit
    equal "picture" 440x500 "$(reported width)x$(reported height)"
    sameAsHeadless cube-cull-1.png
    start 'mvgl: cube-cull' "$cubeCull" --window --report=json
    xdotool key h && settle
    quit
    equal "picture without the panel" 960x600 "$(reported width)x$(reported height)"
    start 'mvgl: cube-cull' "$cubeCull" --window --report=json --size 333x217
    xdotool windowsize "$window" 200 100 && settle # no room for a picture at all
    xdotool windowsize "$window" 693 217 && settle
    xdotool windowunmap "$window" && sleep 0.3 && xdotool windowmap "$window" && settle
    xdotool windowfocus "$window" && sleep 0.2
    quit
    equal "picture after being too small" 333x217 "$(reported width)x$(reported height)"
}

storm() {
    # A hundred sizes in quick succession, each change of which asks for a picture: down to a single pixel, and minimised.
    start 'mvgl: probe' "$launcher" probe --window --report=json
    local storm=() i
    RANDOM=1234
    for i in $(seq 100); do
        case $((i % 10)) in
            3) storm+=(windowsize "$window" 1 1) ;;
            6) storm+=(windowsize "$window" $((RANDOM % 1200 + 1)) 1) ;;
            8) storm+=(windowunmap "$window" windowsize "$window" $((RANDOM % 1200 + 1)) 300 windowmap "$window") ;;
            *) storm+=(windowsize "$window" $((RANDOM % 1200 + 1)) $((RANDOM % 1000 + 1))) ;;
        esac
        [ $((i % 7)) -ne 0 ] || storm+=(sleep 0.02)
    done
    xdotool "${storm[@]}" windowsize "$window" 753 317
    settle
    xdotool windowfocus "$window" key space && sleep 0.3
    xdotool key ctrl+s && sleep 0.5
    quit
    equal "picture after the storm" 393x317 "$(reported width)x$(reported height)"
    equal "error" "" "$(reported error)"
    equal "standard error" "" "$(cat err)"
    atLeast "pictures drawn on the way" "$(reported demo_frames)" 20
    local line
    line=$(reported command)
    # shellcheck disable=SC2086
    (set -- $line && shift && "$launcher" probe "$@" --shot replay.png) || fail "the command line '$line' does not run"
    cmp probe-*.png replay.png || fail "the picture after the storm is not that of '$line'"
}

time_() {
    # Frames go by the clock: 60 a second, however many of them were drawn.
    start 'mvgl: probe' "$launcher" probe --window --report=json
    sleep 3
    quit
    local expected
    expected=$(awk -v s="$(reported seconds)" 'BEGIN { print 60 * s + 1 }')
    atLeast "frame" "$(reported frame)" "$(awk -v e="$expected" 'BEGIN { print e - 20 }')" # a third of a second late
    atMost "frame" "$(reported frame)" "$expected"
    # ... and no more are drawn than that, though the swap does not wait on this display.
    atMost "frames drawn" "$(reported window_frames)" "$(awk -v s="$(reported seconds)" 'BEGIN { print 63 * s + 10 }')"
    start 'mvgl: probe' "$launcher" probe --window --report=json
    xdotool key space && settle
    sleep 2
    quit
    equal "playing after the space bar" false "$(reported playing)"
    atMost "frame after a pause" "$(reported frame)" 90
}

paused() {
    start 'mvgl: probe' "$launcher" probe --frame 37 --window --report=json
    xdotool key ctrl+s && sleep 0.5
    quit
    equal "frame" 37 "$(reported frame)"
    equal "command" "probe --frame 37" "$(reported command)"
    "$launcher" probe --frame 37 --shot replay.png && cmp replay.png probe-37.png || fail "not frame 37's picture"
    learnPlaces 'mvgl: probe' "$launcher" probe --frame 37 --size 400x900 --window --report=json
    start 'mvgl: probe' "$launcher" probe --frame 37 --size 400x900 --window --report=json
    clickOn Step && clickOn Step
    quit
    equal "frame after two steps" 39 "$(reported frame)"
    start 'mvgl: probe' "$launcher" probe --frame 37 --size 400x900 --window --report=json
    clickOn Restart
    quit
    equal "frame after Restart" 1 "$(reported frame)"
}

reload() {
    mkdir shaders && export PROBE_SHADERS=$PWD/shaders
    cat >shaders/probe.vert <<'END'
void main() { gl_Position = vec4(vec2(gl_VertexID & 1, gl_VertexID >> 1) - 0.5, 0.0, 1.0); }
END
    fragment() { printf 'uniform float level;\nout vec4 fragColor;\nvoid main() { fragColor = vec4(%s); }\n' "$1" >shaders/probe.frag; }
    middle() { import -window root screen.png && convert screen.png -format '%[pixel:p{200,150}]' info: | sed 's/a(/(/;s/,1)/)/'; }
    showsWithinASecond() { # WHAT EXPECTED
        local until=$(($(date +%s%N) + 1000000000)) found=
        while [ "$(date +%s%N)" -lt $until ]; do
            found=$(middle)
            [ "$found" = "$2" ] && return
        done
        found=$(middle) # looking itself takes time on a busy machine: once more
        equal "$1" "$2" "$found"
    }
    fragment 'level, 1.0, 0.0, 1.0'
    start 'mvgl: probe' "$launcher" probe --frame 1 --level 0 --window --report=json
    equal "the square" "srgb(0,255,0)" "$(middle)"
    fragment '1.0, level, 0.0, 1.0'
    showsWithinASecond "the square after an edit" "srgb(255,0,0)"
    fragment '1.0, level, 0.0, nonsense'
    waitFor grep -q '^error: shaders/probe.frag' err
    grep -q '^shaders/probe.frag:3: .*nonsense' err || fail "the mistake is not told by file and line: $(cat err)"
    equal "the square after a mistake" "srgb(255,0,0)" "$(middle)"
    fragment '0.0, level, 1.0, 1.0'
    showsWithinASecond "the square after it was mended" "srgb(0,0,255)"
    quit
    equal "error after it was mended" "" "$(reported error)"
    start 'mvgl: probe' "$launcher" probe --frame 1 --level 0 --window --report=json
    fragment 'nonsense'
    waitFor grep -q '^error: ' err
    quit
    reported error | grep -q 'shaders/probe.frag:3' || fail "the report does not have the mistake: $(reported error)"
}

launcher_() {
    start 'mvgl' "$launcher"
    xdotool key Return # the first one is chosen at the start
    waitFor windowCalled 'mvgl: probe' && settle
    equal "window's size" "760x300" "$(xdotool getwindowgeometry "$window" | sed -n 's/.*Geometry: //p')"
    xdotool key BackSpace
    waitFor windowCalled 'mvgl' && settle
    xdotool key Right && sleep 0.2 && xdotool key Return && sleep 0.5 # it cannot be opened
    windowCalled 'mvgl' >/dev/null || fail "a demo that fails must lead back to the menu"
    kill -0 $pid || fail "a demo that fails ended the program"
    xdotool key Right && sleep 0.2 && xdotool key Return
    waitFor windowCalled 'mvgl: cube-cull' && settle
    quit
    # With reports, and by mouse
    start 'mvgl: probe' "$launcher" probe --window --report=json
    xdotool key BackSpace
    waitFor windowCalled 'mvgl' && settle
    quit
    cp out places
    equal "reports of the demo and the menu" "probe 1" "$(reported demo) $(grep -c '"menu"' out)"
    sed -i '1,/^}/d' places # the menu's own
    start 'mvgl: probe' "$launcher" probe --window --report=json
    xdotool key BackSpace
    waitFor windowCalled 'mvgl' && settle
    clickOn cube-cull
    waitFor windowCalled 'mvgl: cube-cull' && settle
    xdotool key Up && sleep 0.2
    quit
    equal "the last report's demo" cube-cull "$(sed -n 's/^  "demo": "\(.*\)",/\1/p' out | tail -1)"
    grep -q '"z-dist": "-3.8"' out || fail "the demo opened from the menu has no working keys"
    "$launcher" broken 2>err && fail "a demo that fails, asked for by name, must end with an error"
    equal "its error" "error: broken: must never open; that is what it is for" "$(cat err)"
}

sameAgain() {
    start 'mvgl: cube-cull' "$launcher" cube-cull --window --report=json
    xdotool key s && sleep 0.5 && xdotool key BackSpace
    waitFor windowCalled 'mvgl' && settle
    xdotool key Left && sleep 0.2 && xdotool key Left && sleep 0.2 && xdotool key Return
    waitFor windowCalled 'mvgl: probe' && settle
    xdotool key BackSpace
    waitFor windowCalled 'mvgl' && settle
    xdotool key Right && sleep 0.2 && xdotool key Right && sleep 0.2 && xdotool key Return
    waitFor windowCalled 'mvgl: cube-cull' && settle
    xdotool key s && sleep 0.5
    quit
    cmp cube-cull-1.png cube-cull-1-2.png || fail "after another demo the first one's picture is another"
}

idle() {
    ticks() { awk '{ print $14 + $15 }' /proc/$pid/stat; }
    start 'mvgl: cube-cull' "$cubeCull" --window --report=json
    sleep 1
    local before after
    before=$(ticks) && sleep 3 && after=$(ticks)
    quit
    echo "at rest: $((after - before)) ticks of $((3 * $(getconf CLK_TCK))) in 3 s"
    atMost "processor time at rest, ticks in 3 s" $((after - before)) $((3 * $(getconf CLK_TCK) / 50)) # 2 %
    # Opening gives some events (shown, exposed, focus), each worth three frames; resting some 5 s at 60 gives 300.
    atMost "window frames of a window at rest" "$(reported window_frames)" 30
    equal "demo frames of a window at rest" 1 "$(reported demo_frames)"
    # The same for an animated demo while it is paused, and for the menu.
    start 'mvgl: probe' "$launcher" probe --frame 5 --window --report=json
    sleep 3
    xdotool key BackSpace
    waitFor windowCalled 'mvgl'
    sleep 3
    quit
    for frames in $(sed -n 's/.*"window_frames": \([0-9]*\).*/\1/p' out); do atMost "window frames at rest" "$frames" 30; done
}

compare_() {
    local settings="--spin-x 20 --spin-y 30" back front
    # shellcheck disable=SC2086
    {
        "$cubeCull" $settings --cull back --shot back.png
        "$cubeCull" $settings --cull front --shot front.png
        start 'mvgl: cube-cull' "$cubeCull" $settings --compare cull=back,front --window --report=json
    }
    # Columns of the picture, below its labels, are those of one setting: sides SAVED LEFT-TO-X RIGHT-FROM-X
    sides() {
        back=$(differing "$1" back.png "$2x560+0+40") front=$(differing "$1" front.png "$((600 - $3))x560+$3+40")
        equal "pixels of $1 left of the line that are not A's" 0 "$back"
        equal "pixels of $1 right of the line that are not B's" 0 "$front"
    }
    differing() { # FILE FILE AREA: how many pixels
        convert "$1" -crop "$3" +repage x.png && convert "$2" -crop "$3" +repage y.png
        compare -metric AE x.png y.png null: 2>&1
    }
    xdotool key s && sleep 0.5
    mv cube-cull-1.png halves.png && sides halves.png 299 302
    at 303 200 && sleep 0.2 && xdotool mousedown 1 && sleep 0.1 # near the line, not on it
    at 250 200 && sleep 0.1 && at 150 220 && sleep 0.2 && xdotool mouseup 1 && sleep 0.2
    at 300 500 && sleep 0.2 # the line stays where it was let go
    xdotool key s && sleep 0.5
    mv cube-cull-1.png dragged.png && sides dragged.png 149 152
    for _ in 1 2 3 4 5; do xdotool key bracketright && sleep 0.1; done
    xdotool key bracketleft && sleep 0.2
    xdotool key s && sleep 0.5
    mv cube-cull-1.png keys.png && sides keys.png 197 200
    sleep 0.5
    quit
    equal "the divider" 0.33 "$(printf %.2f "$(reported divider)")"
    equal "settings after the line was dragged" "20 30" "$(reported spin-x) $(reported spin-y)"
    # Dragging and pushing the line draws neither of the two again.
    equal "demo frames" 2 "$(reported demo_frames)"
    equal "command" "cube-cull $settings --compare cull=back,front" "$(reported command)"
    differing back.png front.png 600x600+0+0 >count
    equal "the difference" "$(awk '{ printf "difference: %.2f %% of pixels, at most 255 of 255", 100 * $1 / 360000 }' count)" \
        "$(reported difference)"
    # The other knobs are for both.
    # shellcheck disable=SC2086
    start 'mvgl: cube-cull' "$cubeCull" $settings --compare cull=back,front --window --report=json
    at 100 300 && xdotool mousedown 1 && at 110 300 && xdotool mouseup 1 && sleep 0.3
    xdotool key s && sleep 0.5
    quit
    equal "spin-y after a drag far from the line" 20 "$(reported spin-y)"
    "$cubeCull" --spin-x 20 --spin-y 20 --cull back --shot back.png
    "$cubeCull" --spin-x 20 --spin-y 20 --cull front --shot front.png
    sides cube-cull-1.png 299 302
    # At rest
    start 'mvgl: cube-cull' "$cubeCull" --compare cull=back,front --window --report=json
    sleep 4
    quit
    equal "demo frames at rest" 2 "$(reported demo_frames)"
    atMost "window frames at rest" "$(reported window_frames)" 30
}

comparePanel() {
    local probe=("$launcher" probe --frame 5 --size 400x1000 --window --report=json)
    learnPlaces 'mvgl: probe' "${probe[@]}"
    start 'mvgl: probe' "${probe[@]}"
    clickOn "Compare with"
    xdotool key Escape && sleep 0.3 # closes the list, and only that
    kill -0 $pid || fail "Escape in the list of knobs closed the window"
    clickOn "Compare with"
    xdotool key Escape && sleep 0.3
    quit
    equal "what is compared after Escape" "" "$(reported compare)"
    # The list hangs open below its box; its second line is the second knob. Then the places are those of a comparison.
    start 'mvgl: probe' "${probe[@]}"
    clickOn "Compare with"
    read -r x y <<<"$(place "Compare with")"
    at "$x" $((y + 54)) && sleep 0.3 && xdotool click 1 && sleep 0.4
    quit
    cp out places
    equal "what is compared" "count with 9" "$(reported compare) with $(reported compare_with)"
    equal "command" "probe --compare count=3,9 --frame 5 --size 400x1000" "$(reported command)"
    # Each view, saved as it is shown; mood does not change the picture, level does.
    probe+=(--compare level=0.25,0.75)
    learnPlaces 'mvgl: probe' "${probe[@]}"
    "$launcher" probe --frame 5 --size 400x1000 --level 0.25 --shot a.png
    "$launcher" probe --frame 5 --size 400x1000 --level 0.75 --shot b.png
    middle() { convert "$1" -format '%[pixel:p{150,500}] %[pixel:p{250,500}]' info: | sed 's/a(/(/g;s/,1)/)/g'; }
    for view in divider A B difference; do
        start 'mvgl: probe' "${probe[@]}"
        clickOn "$view"
        xdotool key ctrl+s && sleep 0.5
        mv probe-5.png "view-$view.png"
        quit
    done
    local a b
    read -r a _ <<<"$(middle a.png)" && read -r b _ <<<"$(middle b.png)"
    [ "$a" != "$b" ] || fail "the two settings have the same picture"
    equal "view divider" "$a $b" "$(middle view-divider.png)"
    equal "view A" "$a $a" "$(middle view-A.png)"
    equal "view B" "$b $b" "$(middle view-B.png)"
    # 128 levels apart: 96 + 159 * 128 / 255 green in full red
    equal "view difference" "srgb(255,175,0) srgb(255,175,0)" "$(middle view-difference.png)"
    # A key and a drag that move the compared knob move A; a setting that B cannot have is told with its name.
    start 'mvgl: probe' "$launcher" probe --frame 5 --mood loud --compare level=0.5,1 --window --report=json
    xdotool key n && sleep 0.3
    quit
    equal "error" "with level = 1: --level: must be less than 1 while --mood is loud" "$(reported error)"
    equal "level after its key" 0.375 "$(reported level)"
    start 'mvgl: probe' "${probe[@]}"
    clickOn "Stop comparing"
    xdotool key ctrl+s && sleep 0.5
    quit
    equal "command after the end" "probe --frame 5 --size 400x1000" "$(reported command)"
    cmp probe-5.png a.png || fail "after the end the picture is not A's"
}

study() {
    local integral=("$launcher" integral --size 400x1000 --window --report=json)
    learnPlaces 'mvgl: integral' "${integral[@]}"
    equal "where it was measured" "Committed, measured on: no driver, a machine of long ago, 1 thread." "$(reported study)"
    equal "the row of the present settings" "trapezia 4" "$(reported here)"
    # A longer time stands higher, a smaller error further left, an error of 0 left of all; what has failed nowhere.
    local x4 y4 x64 y64 x0
    read -r x4 y4 <<<"$(place "point simpson 4")" && read -r x64 y64 <<<"$(place "point simpson 64")"
    read -r x0 _ <<<"$(place "point exact")"
    [ "$y64" -lt "$y4" ] || fail "64 strips take longer than 4 and must stand higher: $y64 and $y4"
    [ "$x64" -lt "$x4" ] || fail "64 strips are nearer than 4 and must stand further left: $x64 and $x4"
    [ "$x0" -lt "$x64" ] || fail "no error at all must stand left of all: $x0 and $x64"
    equal "a row that failed" "" "$(place "point simpson 255")"
    start 'mvgl: integral' "${integral[@]}"
    clickOn "point simpson 16"
    quit
    equal "row after a click on its point" "simpson 16" "$(reported here)"
    equal "command after a click on a point" "integral --rule simpson --n 16 --size 400x1000" "$(reported command)"
    # Beside the points a click sets nothing.
    start 'mvgl: integral' "${integral[@]}"
    at $((x64 + 3)) $((y64 - 60)) && sleep 0.2 && xdotool click 1 && sleep 0.3
    quit
    equal "row after a click beside the points" "trapezia 4" "$(reported here)"
    equal "demo frames" 1 "$(reported demo_frames)"
    atMost "window frames at rest" "$(reported window_frames)" 40
    # It begins with the scene of its settings; settings that were not measured are at no point.
    start 'mvgl: integral' "${integral[@]}" --function root --n 64
    quit
    equal "row in another scene" "trapezia 64" "$(reported here)"
    start 'mvgl: integral' "${integral[@]}" --n 5
    quit
    equal "row of settings that were not measured" "" "$(reported here)"
}

measure() {
    mkdir tmp && export TMPDIR=$PWD/tmp
    local integral=("$launcher" integral --n 16 --size 400x1000 --window --report=json) child
    made() { [ -n "$(ls tmp)" ]; }
    gone() { [ -z "$(ls tmp)" ]; }
    learnPlaces 'mvgl: integral' "${integral[@]}"
    start 'mvgl: integral' "${integral[@]}"
    clickOn "Measure here"
    waitFor made && waitFor gone && settle
    quit
    reported study | grep -q "^Measured here: .* threads\.$" || fail "the plot is not the one measured here: $(reported study)"
    equal "row of the present settings, as measured" "trapezia 16" "$(reported here)"
    equal "standard error" "" "$(cat err)"
    # A long one: closing the window ends it, and so do Cancel and a window that is killed.
    export PROBE_SLOW=1
    cp places before
    slowOne() {
        cp before places
        start 'mvgl: integral' "${integral[@]}"
        clickOn "Measure here"
        waitFor made && sleep 1
        child=$(pgrep -P $pid)
        [ -n "$child" ] || fail "no program measures"
    }
    ended() { ! kill -0 "$child" 2>/dev/null; }
    slowOne
    quit
    equal "measuring while the window was closed" true "$(reported measuring)"
    ended || fail "the measurement outlives the window"
    gone || fail "a closed window leaves its folder: $(ls tmp)"
    cp out cancel
    slowOne
    cp cancel places && clickOn Cancel
    waitFor ended
    gone || fail "Cancel leaves the folder: $(ls tmp)"
    quit
    equal "measuring after Cancel" false "$(reported measuring)"
    reported study | grep -q '^Committed' || fail "after Cancel the committed study must be shown: $(reported study)"
    slowOne
    kill -KILL $pid && wait $pid 2>/dev/null
    waitFor ended
}

noDisplay() {
    env -u DISPLAY -u WAYLAND_DISPLAY "$cubeCull" >out 2>err
    equal "exit status" 1 $?
    equal "sentence" "error: window: needs a display (DISPLAY or WAYLAND_DISPLAY); use --shot FILE without" "$(cat err)"
    env -u WAYLAND_DISPLAY DISPLAY=:9999 "$cubeCull" >out 2>err
    equal "exit status with a display that is not there" 1 $?
    equal "lines on standard error" 1 "$(wc -l <err)"
    grep -q '^error: window: needs a display that answers' err || fail "no clear sentence: $(cat err)"
    env -u DISPLAY -u WAYLAND_DISPLAY "$cubeCull" --shot a.png || fail "a picture without a window needs no display"
    # A driver below the floor is named with its version.
    MESA_GL_VERSION_OVERRIDE=3.0 "$cubeCull" >out 2>err
    equal "exit status with OpenGL 3.0" 1 $?
    grep -q '^error: window: needs OpenGL 3.3 core; this driver has, 3.0' err || fail "the version is not told: $(cat err)"
}

case $case in
    same-again) sameAgain ;;
    no-display) noDisplay ;;
    time) time_ ;;
    compare) compare_ ;;
    compare-panel) comparePanel ;;
    launcher) launcher_ ;;
    opens | keys | slider | typed | choice | wheel | drag | replay | save | clipboard | error | resize | storm | paused | reload | idle | study | measure)
        "$case"
        ;;
    *) fail "there is no case '$case'" ;;
esac
[ $failures -eq 0 ] && echo "passed: $case"
exit $((failures > 0))
