#!/usr/bin/env bash
# window_test.sh CASE CUBE-CULL LAUNCHER: one test of the window, on a display of its own.
#
# It does with xdotool what a user does with keyboard and mouse, waits for the report that has it handled (tools.sh), and
# looks at what that says: settings, frames drawn, and where each widget stands.
set -u
case=$1 cubeCull=$2 launcher=$3

for tool in Xvfb xdotool import xprop; do
    command -v $tool >/dev/null || {
        echo "FAILED: $tool is missing; install the packages xvfb, xdotool, imagemagick and x11-utils"
        exit 1
    }
done
. "$(dirname "${BASH_SOURCE[0]}")/tools.sh"
state=$(mktemp -d) && folder=$(mktemp -d) && cd "$folder" || exit 1
touch "$state/out" "$state/err" "$state/report"
server=
trap '[ -z "$pid" ] || kill $pid 2>/dev/null; [ -z "$server" ] || kill $server; rm -rf "$folder" "$state"' EXIT
# Wayland's library complains on standard error where there is none, before GLFW turns to X.
[ -n "${XDG_RUNTIME_DIR:-}" ] || export XDG_RUNTIME_DIR=$state
export XDG_STATE_HOME=$state/kept # what a panel remembers is the test's own

# ---- Cases

opens() {
    start 'mvgl: cube-cull' "$cubeCull"
    equal "window's size" "960x600" "$(xdotool getwindowgeometry "$window" | sed -n 's/.*Geometry: //p')"
    screenshot "$state/screen.ppm"
    # The picture's corner has its background, the panel its own, and the picture is where it belongs.
    equal "corner of the picture" "srgb(230,255,255)" "$(pixel "$state/screen.ppm" 3,3)"
    equal "middle of the picture" "srgb(0,0,255)" "$(pixel "$state/screen.ppm" 300,290)"
    equal "corner of the panel" "srgb(30,33,38)" "$(pixel "$state/screen.ppm" 603,3)"
    press ctrl+l
    screenshot "$state/light.ppm"
    equal "corner of the light panel" "srgb(246,247,249)" "$(pixel "$state/light.ppm" 603,3)"
    equal "the picture beside it" "srgb(230,255,255)" "$(pixel "$state/light.ppm" 3,3)"
    clickOn "light panel"
    screenshot "$state/dark.ppm"
    equal "corner of the panel, dark again" "srgb(30,33,38)" "$(pixel "$state/dark.ppm" 603,3)"
    quit
    equal "picture's width" 600 "$(reported width)"
    equal "picture's height" 600 "$(reported height)"
    equal "command" "$cubeCull" "$(reported command)"
    equal "files left in the folder" "" "$(ls)"
    equal "standard error" "" "$(cat "$state/err")"
    # Without a flag there is a window as well, and Escape closes it, as often as it takes until it is there to hear it.
    "$cubeCull" 2>"$state/err" &
    pid=$!
    await "a window without a flag" isCalled 'mvgl: cube-cull'
    local ending=$pid
    pid=
    await "its end after Escape" escaped $ending
    # A report opens none, though there is a display.
    timeout $limit "$cubeCull" --report=json >"$state/out" 2>"$state/err"
    equal "exit status of a report" 0 $?
    lastReport
    equal "host of a report" OSMesa "$(reported host)"
    timeout $limit "$cubeCull" --report >"$state/out"
    equal "exit status of a report in words" 0 $?
    equal "first line of a report in words" "cube-cull, frame 1, 600x600" "$(head -1 "$state/out")"
}
isCalled() { [ -n "$(windowCalled "$1")" ]; }
escaped() {
    ended "$1" && return
    xdotool key Escape
    return 1
}

keys() {
    start 'mvgl: cube-cull' "$cubeCull"
    press Up Up Up
    awaitReport z-dist -3.4
    quit
    start 'mvgl: probe' "$launcher" probe
    press KP_4 # the number pad
    press s    # the demo has S for itself
    quit
    equal "count after 4 on the number pad" 4 "$(reported count)"
    equal "level after S" 0.375 "$(reported level)"
    equal "pictures saved by a key that the demo has for itself" "" "$(ls)"
}

people() { # a window that reports to no program opens as it is best on this machine
    # It is driven without a report, by a clock of which a frame takes a few MS, and saves a picture, $saved, whose line is $line
    alone() { # TITLE MS PROGRAM ARGUMENTS...
        "${sham[@]}" SHAM=paced SHAM_MS="$2" "${@:3}" 2>"$state/err" &
        pid=$!
        await "a window for people" isCalled "$1"
        window=$(windowCalled "$1")
        saved=${1#mvgl: }-1.png
        await "a picture" savesPicture
        geometry=$(xdotool getwindowgeometry "$window" | sed -n 's/.*Geometry: //p')
        local ending=$pid
        pid=
        await "its end after Escape" escaped $ending
        line=$("$3" --from "$saved" --copyable)
    }
    savesPicture() { # the key may come before the window hears it
        [ -s "$saved" ] && return
        xdotool key --window "$window" s
        return 1
    }
    # Less than 8 ms a frame: smooth edges, and the picture's line says so.
    alone 'mvgl: cube-cull' 1 "$cubeCull" --size 64x64
    equal "line of a fast picture" "$cubeCull --size 64x64 --multisample 4" "$line"
    sh -c "$line --shot again.png" && cmp "$saved" again.png || fail "the line '$line' makes another picture"
    rm ./*.png
    # Who has asked for none gets none, and so does who opens that line again.
    alone 'mvgl: cube-cull' 1 "$cubeCull" --size 64x64 --multisample 0
    equal "line of a picture without" "$cubeCull --size 64x64 --multisample 0" "$line"
    rm ./*.png
    alone 'mvgl: cube-cull' 9 "$cubeCull" --size 64x64
    equal "line of a slow picture" "$cubeCull --size 64x64" "$line"
    rm ./*.png
    # 80 % of the screen's height, as wide as high beside 360 for the panel
    alone 'mvgl: cube-cull' 1 "$cubeCull"
    equal "the window of a picture of 600x600 on a screen of 1280x1024" 1179x819 "$geometry"
    equal "line of a picture as large as that" "$cubeCull --size 819x819 --multisample 4" "$line"
}

tips() { # words about a widget come when the mouse has rested on it, and go when it is pressed
    start 'mvgl: cube-cull' "$cubeCull"
    local x y
    read -r x y <<<"$(place z-dist)"
    local before
    before=$(date +%s%N)
    at "$x" "$y"
    # On a busy machine the half second may be over by then
    [ $(($(date +%s%N) - before)) -gt 400000000 ] || equal "words as soon as the mouse is there" "" "$(reported tip)"
    await "words about z-dist" says tip 'where the eye stands on the z axis, looking at the middle\n-10 .. 10; initially -4'
    buttonDown
    awaitReport tip ""
    buttonUp
    await "words again" isTold
    at 300 300
    awaitReport tip ""
    quit
}
widened() { # the panel by its edge, and the study's plot with it
    local left top right bottom before
    start 'mvgl: integral' "$launcher" integral --size 900x900
    IFS=, read -r left top right bottom <<<"${values["at plot"]}"
    before=$((${right%.*} - ${left%.*}))
    at 901 500 && buttonDown
    at 701 500 && buttonUp
    await "a narrower picture" pictureIs 701x900
    IFS=, read -r left top right bottom <<<"${values["at plot"]}"
    equal "the plot's width" $((before + 199)) $((${right%.*} - ${left%.*}))
    atLeast "the plot's height" $((${bottom%.*} - ${top%.*})) $(((before + 199) * 65 / 100))
    # Not narrower than it was, and a quarter stays to the picture
    at 700 500 && buttonDown
    at 1100 500 && buttonUp
    await "the picture as it was" pictureIs 900x900
    at 900 500 && buttonDown
    at 100 500 && buttonUp
    await "a quarter of the window" pictureIs 315x900
    quit
}

isTold() { says && [ -n "$(reported tip)" ]; }

folds() { # a section stays folded, in this window and in the next one; what does nothing is folded
    local y
    start 'mvgl: cube-cull' "$cubeCull"
    y=${values["at section Compare"]}
    clickOn "section Settings"
    await "a section less" isGone z-dist
    [ "$y" != "${values["at section Compare"]}" ] || fail "what is below has not moved up"
    quit
    start 'mvgl: probe' "$launcher" probe --frame 1
    isGone level || fail "the section is open again in the next window"
    clickOn "section Settings"
    await "the section" isThere level
    quit
    equal "what is kept when all are open" "" "$(cat "$XDG_STATE_HOME/mvgl/folded")"
    start 'mvgl: cube-cull' "$cubeCull"
    isThere z-dist || fail "the section is folded again"
    isGone divisions || fail "the teapot's divisions do nothing for a cube, and must be folded"
    clickOn "idle settings"
    await "what does nothing" isThere divisions
    clickOn "idle settings"
    await "that it is folded again" isGone divisions
    clickOn body
    clickOn "body teapot"
    await "divisions, which do something now" isThere divisions
    quit
    # Where nothing can be written it is said once, and kept as long as the program runs.
    XDG_STATE_HOME=/dev/null/none start 'mvgl: cube-cull' "$cubeCull"
    clickOn "section Settings"
    await "a section less" isGone z-dist
    quit
    equal "lines about it" 1 "$(grep -c '^note: /dev/null/none/mvgl/folded: could not be written' "$state/err")"
}
isGone() { says && [ -z "${values["at $1"]-}" ]; }
isThere() { says && [ -n "${values["at $1"]-}" ]; }

drop() { # a picture of one's own, and what is none
    local drops own assets
    own=("$(dirname "$cubeCull")/mvgl" texture-map) drops=$(dirname "$launcher")/drop
    assets=$(cd "$(dirname "${BASH_SOURCE[0]}")/../../assets" && pwd)
    start 'mvgl: texture-map' "${own[@]}" --method correct
    screenshot "$state/before.ppm"
    cp "$assets/postcard.png" "my postcard, 1.png"
    "$drops" "$window" "my postcard, 1.png" || fail "the window takes no drop"
    awaitReport picture "$folder/my postcard, 1.png"
    equal "what is wrong with a picture" "" "$(reported error)"
    screenshot "$state/dropped.ppm"
    [ "$(compare -metric AE "$state/before.ppm" "$state/dropped.ppm" null: 2>&1)" -gt 20000 ] ||
        fail "the dropped picture is not to be seen"
    case $(reported command) in
        "${own[*]} --method correct --picture '$folder/my postcard, 1.png'"*) ;;
        *) fail "the copied command has no picture: $(reported command)" ;;
    esac
    # What is no picture is told, and the last good picture stays. (The left 600 pixels: beside them is the panel.)
    echo "no picture" >notes.txt
    "$drops" "$window" notes.txt || fail "the window takes no drop"
    awaitReport picture "$folder/notes.txt"
    equal "what is said of a file that is none" "--picture: $folder/notes.txt: must be a PNG or JPEG file; other formats have to be converted first, it begins as neither" "$(reported error)"
    screenshot "$state/refused.ppm"
    isDimmed "$state/dropped.ppm" "$state/refused.ppm" 600x440+0+100 # below the window's ring round a handle, which stays as it was
    # Written anew and dropped again, it is read again
    cp "$assets/tiles.png" "my postcard, 1.png"
    "$drops" "$window" "my postcard, 1.png" || fail "the window takes no drop"
    awaitReport picture "$folder/my postcard, 1.png"
    equal "what is wrong with it" "" "$(reported error)"
    screenshot "$state/again.ppm"
    [ "$(compare -metric AE "$state/dropped.ppm" "$state/again.ppm" null: 2>&1)" -gt 20000 ] ||
        fail "a picture that was written anew is not read again"
    quit
    # A demo that takes none says so, until something else is done.
    start 'mvgl: cube-cull' "$cubeCull"
    "$drops" "$window" "my postcard, 1.png" || fail "the window of another demo takes no drop, $?"
    await "a word about the drop" isReported error "dropped file: must go to a demo with a knob that takes a picture, as texture-map has one"
    press Up
    awaitReport z-dist -3.8
    equal "what is said of it later" "" "$(reported error)"
    quit
}
# isDimmed BEFORE AFTER WxH+X+Y: the last good picture stays beside a refusal, 150 of 255 parts of DemoScreen's grey over it, and nothing
# else: each channel to its rounding, a level by whoever draws it and half a one here.
isDimmed() {
    convert "$1" -crop "$3" +repage \( +clone -fill 'rgb(30,33,38)' -colorize 100 \) -compose blend \
        -define compose:args=58.8235 -composite "$state/dimmed.ppm"
    convert "$2" -crop "$3" +repage "$state/shown.ppm"
    atMost "levels by which the dimmed picture is another" \
        "$(convert "$state/dimmed.ppm" "$state/shown.ppm" -compose difference -composite -format '%[fx:maxima*255]' info:)" 1.5
}
isReported() { [ "$(reported "$1")" = "$2" ]; }

keyboard() { # all of the panel without a mouse
    start 'mvgl: cube-cull' "$cubeCull"
    press Tab # there are no handles: to the panel
    await "the focus in the panel" isFocused Lesson
    goTo "section Presets"
    screenshot "$state/focus.ppm"
    atLeast "pixels of the frame round what the keys are at" "$(convert "$state/focus.ppm" -fuzz 8% -fill white \
        -opaque 'rgb(255,204,89)' -fill black +opaque white -format '%[fx:mean*w*h]' info:)" 300
    press Tab Right space
    awaitReport spin-y 0 focused "preset original"
    # Down to a knob, which moves by arrows once Space has taken it, and takes a number after Enter
    goTo z-dist
    press space Right Right space
    [ "$(reported z-dist)" != -4 ] || fail "z-dist has not moved by the keys"
    press Return
    press ctrl+a && write 2.5 && press Return
    awaitReport z-dist 2.5
    goTo "Compare with"
    press space Down space
    await "a comparison" isComparing
    goTo "section Draw by draw"
    press Escape # back to the picture, and only that
    awaitReport focused ""
    press Up
    quit
    # After the last handle Tab goes to the panel, and F6 does at once
    start 'mvgl: view-volume' "$(dirname "$cubeCull")/view-volume"
    press Tab Tab
    awaitReport hovered "far plane"
    press Tab
    await "the focus in the panel" isFocused Lesson
    goTo "Step through the draws"
    press space
    awaitReport until 1 focused ">##draw"
    press space
    awaitReport until 2
    press F6
    awaitReport focused ""
    quit
}

# All that a demo's panel has, by the keyboard alone: the mouse is never moved.
keysOf() { # DEMO
    local before name knob='' presets=() preset i down
    start "mvgl: $1" "$(dirname "$cubeCull")/$1"
    [ "$(reported playing)" = false ] || press space
    awaitReport playing false
    for ((i = 0; i < 20; ++i)); do # past the handles, if there are any
        [ -z "$(reported focused)" ] || break
        press Tab
    done
    [ -n "$(reported focused)" ] || die "Tab does not come to the panel"
    for name in "${!values[@]}"; do
        case $name in
            "at preset "*) presets+=("${name#at }") ;;
            "at sweep height" | "at sweep width") ;; # the picture's are reported by that name
            "at sweep "*) knob=${name#at sweep } ;;
        esac
    done
    # A knob, by arrows; one that takes numbers has a bar
    [ -z "$knob" ] || {
        before=$(reported "$knob")
        goTo "$knob"
        press space Right Right space
        [ "$(reported "$knob")" != "$before" ] || press space Left Left space # it was at its end
        [ "$(reported "$knob")" != "$before" ] || fail "$knob has not moved by the keys"
        for ((i = 0; i < 4; ++i)); do # each arrow is a step of its own
            [ "$(reported "$knob")" = "$before" ] || press ctrl+z
        done
        equal "$knob after all was undone" "$before" "$(reported "$knob")"
    }
    before=$(reported command)
    for preset in "${presets[@]}"; do # one of them is there already
        goTo "$preset"
        press space
        [ "$(reported command)" = "$before" ] || break
    done
    [ "$(reported command)" != "$before" ] || fail "no preset has been set by the keys"
    for ((i = 1; i < 5; ++i)); do # the value that is offered first may be one that makes no picture
        goTo "Compare with"
        press space
        for ((down = 0; down < i; ++down)); do press Down; done
        press space
        [ -n "$(reported error)" ] || break
        goTo "Stop comparing"
        press space
    done
    await "a comparison" isComparing
    goTo "Stop comparing"
    press space
    await "the end of the comparison" isNotComparing
    goTo "Step through the draws"
    press space
    awaitReport until 1
    goTo "Show the whole frame"
    press space
    awaitReport until ""
    if isThere Pause; then
        goTo Step
        before=$(reported frame)
        press space
        awaitReport frame $((before + 1))
        goTo Pause
        press space
        await "time to go on" isPlaying
        press space
        awaitReport playing false
    fi
    if isThere plot; then
        goTo plot
        before=$(reported here)
        press space
        [ "$(reported here)" != "$before" ] || fail "no point of the study has been taken by the keys"
    fi
    press F6
    awaitReport focused ""
    quit
    equal "standard error" "" "$(grep -v '^note: ' "$state/err")"
}
isNotComparing() { says && [ -z "$(reported compare)" ]; }
isPlaying() { [ "$(reported playing)" = true ]; }
isFocused() { says focused "$1"; }
isComparing() { says && [ -n "$(reported compare)" ]; }
# goTo WIDGET: by Tab, with Shift for what is further up, and along a row by arrows
goTo() {
    local i x y toX toY before=none
    for ((i = 0; i < 120; ++i)); do
        [ "$(reported focused)" != "$1" ] || return 0
        read -r x y <<<"$(place "$(reported focused)")"
        read -r toX toY <<<"$(place "$1")"
        if [ "$before" = "$(reported focused)" ] || [ -z "$x" ] || [ -z "$toX" ]; then
            press Tab # along the row there is nothing
        elif [ $((toY - y)) -ge -8 ] && [ $((toY - y)) -le 8 ]; then
            before=$(reported focused)
            if [ "$toX" -gt "$x" ]; then press Right; else press Left; fi
            continue
        elif [ "$toY" -lt "$y" ]; then
            press shift+Tab
        else
            press Tab
        fi
        before=none
    done
    die "Tab and arrows do not come to '$1', but to '$(reported focused)'"
}

undo() {
    start 'mvgl: cube-cull' "$cubeCull"
    clickOn "preset front-culled"
    awaitReport cull front
    at 300 300 # from the panel
    press Up
    awaitReport z-dist -3.8
    press ctrl+z
    awaitReport z-dist -4 cull front
    press ctrl+z
    awaitReport cull back command "$cubeCull"
    press ctrl+z # there is nothing before
    awaitReport command "$cubeCull"
    press ctrl+shift+z ctrl+shift+z
    awaitReport z-dist -3.8 cull front
    # A drag is one step, however many places it went through
    at 300 300 && buttonDown
    at 340 300 && at 340 330 && at 360 340 && buttonUp
    press ctrl+z
    awaitReport spin-y 30 z-dist -3.8
    quit
}

sweep() { # a bar that goes there and back by itself
    start 'mvgl: cube-cull' "$cubeCull"
    local x y rest
    read -r x y <<<"$(place "sweep z-dist")"
    at "$x" "$y"
    xdotool click 1 # it does not come to rest meanwhile
    await "z-dist to come above 4" above z-dist 4
    xdotool click 1
    buttons=2
    awaitReport buttons 2 buttons_held 0
    rest=$(reported z-dist)
    press b
    equal "z-dist after the sweep was stopped" "$rest" "$(reported z-dist)"
    press ctrl+z
    awaitReport z-dist -4 # all of it is one step
    # Its speed stands below while it moves: a click at the right end of that bar makes it slow.
    at "$x" "$y"
    xdotool click 1
    await "a bar for the speed" isShown "sweep seconds"
    local left top right bottom
    IFS=, read -r left top right bottom <<<"${values["at sweep seconds"]}"
    xdotool mousemove --window "$window" $((${right%.*} - 12)) $(((${top%.*} + ${bottom%.*}) / 2)) click 1
    buttons=4
    await "the click" isPressed
    local before after
    before="$(reported seconds) $(reported z-dist)"
    await "two seconds" secondsAfter "${before% *}" 2
    after="$(reported seconds) $(reported z-dist)"
    # 20 units in 60 s, and not in 4
    atMost "units a second" "$(echo "$before $after" | awk '{ print ($4 > $2 ? $4 - $2 : $2 - $4) / ($3 - $1) }')" 0.5
    xdotool mousemove --window "$window" "$x" "$y" click 1
    await "no bar for the speed" isGone "sweep seconds"
    quit
}
isShown() { [ -n "${values["at $1"]-}" ]; }
isPressed() { [ "$(reported buttons)" -ge $buttons ]; }
secondsAfter() { awk -v a="$(reported seconds)" -v b="$1" -v c="$2" 'BEGIN { exit !(a >= b + c) }'; }
above() { awk -v a="$(reported "$1")" -v b="$2" 'BEGIN { exit !(a != "" && a + 0 >= b + 0) }'; }

whole() { # full screen, and larger words
    start 'mvgl: cube-cull' "$cubeCull"
    press F11
    await "a window as large as the screen" says size 1280x1024
    press F11
    await "the window as it was" says size 960x600
    local bar=${values["at section Presets"]}
    press ctrl+plus ctrl+plus
    await "a wider panel" pictureIs 504x600
    press ctrl+minus
    await "a narrower one" pictureIs 555x600
    press ctrl+0
    await "the panel as it was" pictureIs 600x600
    equal "where its first section stands" "$bar" "${values["at section Presets"]}"
    quit
}

one_by_one() { # pixels of a line that has fewer than the knob allows
    start 'mvgl: rasterizer' "$(dirname "$cubeCull")/rasterizer" --size 800x1000
    equal "step at the start" 10 "$(reported step)"
    press Left Left Right
    awaitReport step 9
    press Right Right Right Right Right Right Right Right Right
    awaitReport step 18
    press Right
    awaitReport step 999
    press Left
    awaitReport step 18
    local left top right bottom
    IFS=, read -r left top right bottom <<<"${values["at step"]}"
    at $(((${left%.*} + ${right%.*}) / 2)) $(((${top%.*} + ${bottom%.*}) / 2)) && click
    atLeast "step in the middle of its bar" "$(reported step)" 8
    atMost "step in the middle of its bar" "$(reported step)" 11
    quit
}

held() { # a key held down repeats
    start 'mvgl: cube-cull' "$cubeCull"
    xdotool keydown Down
    await "z-dist to come below -4.6" below z-dist -4.6 # it does not come to rest meanwhile
    xdotool keyup Down
    keysDone 4
    local rest
    rest=$(reported z-dist)
    press b # another key, which does nothing
    equal "z-dist after the key was let go" "$rest" "$(reported z-dist)"
    quit
}
below() { awk -v a="$(reported "$1")" -v b="$2" 'BEGIN { exit !(a != "" && a + 0 <= b + 0) }'; }

slider() {
    start 'mvgl: cube-cull' "$cubeCull"
    local x y
    read -r x y <<<"$(place z-dist)"
    at $((x - 40)) "$y" && buttonDown
    at $((x + 60)) "$y" && buttonUp
    at 300 300
    quit
    # The bar runs from -10 to 10 over some 220 pixels; 60 right of its middle is between 4 and 7.
    atLeast "z-dist" "$(reported z-dist)" 4
    atMost "z-dist" "$(reported z-dist)" 7
    start 'mvgl: cube-cull' "$cubeCull" --z-dist 3 --cull none --size 600x900
    clickOn "Reset all"
    awaitReport command "$cubeCull --size 600x900"
    quit
    # A bar of many decades: its middle is the middle of them, its upper end the last one, and its lower end is 0.
    start 'mvgl: pipeline' "$(dirname "$cubeCull")/pipeline" --size 400x900
    read -r x y <<<"$(place offset)"
    at "$x" "$y" && click
    atLeast "offset in the middle of 1 .. 1e8" "$(reported offset)" 2e3
    atMost "offset in the middle of 1 .. 1e8" "$(reported offset)" 2e4
    at $((x + 40)) "$y" && buttonDown && at $((x + 120)) "$y" && buttonUp
    awaitReport offset 1e+08
    at $((x - 40)) "$y" && buttonDown && at $((x - 150)) "$y" && buttonUp
    awaitReport offset 0
    quit
}

preset() { # its button sets every knob, and the copied line makes the same picture
    start 'mvgl: cube-cull' "$cubeCull" --z-dist -6
    at 300 300
    screenshot "$state/unpointed.ppm"
    # What is said about a widget stands beside the panel, and over no other widget
    local x y
    read -r x y <<<"$(place "preset front-culled")"
    at "$x" "$y"
    await "words about the preset" isTold
    screenshot "$state/pointed.ppm"
    for shown in unpointed pointed; do
        convert "$state/$shown.ppm" -fill black -draw "rectangle 600,$((y - 14)) 960,$((y + 14))" -crop 358x600+602+0 +repage "$state/$shown-panel.ppm"
    done
    cmp "$state/unpointed-panel.ppm" "$state/pointed-panel.ppm" || fail "the tooltip covers what is not its own"
    atLeast "pixels of the tooltip" "$(differing "$state/unpointed.ppm" "$state/pointed.ppm")" 2000
    clickOn "preset front-culled"
    awaitReport cull front z-dist -4
    press s
    quit
    equal "command" "$cubeCull --cull front" "$(reported command)"
    sameAsHeadless cube-cull-1.png
    "$cubeCull" --preset front-culled --shot preset.png
    cmp cube-cull-1.png preset.png || fail "--preset is not what its button is"
    # Other flags move from a preset, and the button goes back to it.
    start 'mvgl: cube-cull' "$cubeCull" --preset original --cull none
    equal "spin-y and cull of the preset and the flag" "0 none" "$(reported spin-y) $(reported cull)"
    clickOn "preset original"
    awaitReport cull back spin-y 0
    quit
}

typed() {
    local x y
    typeValue() {
        read -r x y <<<"$(place z-dist)"
        at "$x" "$y" && holdControl && click && letControl
        press ctrl+a && write "$1" && press Return
    }
    start 'mvgl: cube-cull' "$cubeCull"
    typeValue 2.125
    awaitReport z-dist 2.125
    quit
    start 'mvgl: cube-cull' "$cubeCull"
    typeValue 99
    screenshot "$state/screen.ppm"
    # Refused, its field red, and not moved to the nearest value that is allowed.
    atLeast "red pixels of the field" "$(convert "$state/screen.ppm" -crop 360x600+600+0 -fuzz 1% -fill white \
        -opaque 'rgb(84,23,23)' -fill black +opaque white -format '%[fx:mean*w*h]' info:)" 100
    press Escape # leaves the field, and only that
    quit
    equal "z-dist after 99 was refused" -4 "$(reported z-dist)"
}

choice() {
    start 'mvgl: cube-cull' "$cubeCull"
    clickOn cull
    press Escape # closes the list, and only that
    clickOn cull
    clickOn "cull front"
    awaitReport cull front
    clickOn depth
    awaitReport depth off
    quit
}

wheel() {
    start 'mvgl: cube-cull' "$cubeCull"
    at 300 300
    turn 4 3
    awaitReport z-dist -4.6
    at 780 300
    turn 5 2 # over the panel: it scrolls
    equal "z-dist after two notches over the panel" -4.6 "$(reported z-dist)"
    quit
}

drag() {
    start 'mvgl: cube-cull' "$cubeCull"
    at 300 300
    buttonDown
    at 340 300
    at 340 330
    buttonUp
    at 100 100 # no button: nothing turns
    quit
    equal "spin-y after 40 pixels to the right" -10 "$(reported spin-y)"
    equal "spin-x after 30 pixels down" 50 "$(reported spin-x)"
    # A drag that begins on the panel is the panel's, wherever it goes.
    start 'mvgl: cube-cull' "$cubeCull"
    at 700 20 && buttonDown
    at 300 300 && at 320 300 && buttonUp
    quit
    equal "spin-y after a drag from the panel" 30 "$(reported spin-y)"
}

hand() { # what is dragged in the picture itself
    local folder x y farX farY knob
    folder=$(dirname "$cubeCull")
    start 'mvgl: view-volume' "$folder/view-volume"
    read -r x y <<<"$(place "handle far plane")"
    at $((x + 40)) $((y + 40)) # beside it
    awaitReport hovered ""
    at "$x" "$y"
    awaitReport hovered "far plane"
    buttonDown
    at $((x + 30)) $((y - 10))
    awaitReport hovered "far plane" # which follows
    buttonUp
    atLeast "far after it was dragged away from the camera" "$(reported far)" 33
    equal "turn, which a drag beside a handle moves" 65 "$(reported turn)"
    # It is under the pointer: at most two pixels from it, as near as a line comes to it
    read -r farX farY <<<"$(place "handle far plane")"
    atMost "distance of the handle across" $(((farX - x - 30) * (farX - x - 30))) 100
    at $((x + 100)) $((y + 60)) && buttonDown && at $((x + 110)) $((y + 60)) && buttonUp
    equal "turn after a drag beside the handles" 60 "$(reported turn)"
    # By keyboard: Tab picks near, then far; the arrows move the one that is picked, and not what the demo has them for
    press Tab
    awaitReport hovered "near plane"
    press Right Right shift+Right
    atLeast "near after twelve pixels" "$(reported near)" 8.5
    equal "pan, which the arrows move otherwise" 0 "$(reported pan)"
    press Escape # lets it go, and only that
    press Left
    equal "pan" 5 "$(reported pan)"
    press s
    quit
    sameAsHeadless view-volume-1.png
    # A light in space, while its circle is paused
    start 'mvgl: shadow-floor' "$folder/shadow-floor" --frame 30
    read -r x y <<<"$(place "handle light")"
    at "$x" "$y" && buttonDown
    at $((x - 60)) $((y + 25))
    at $((x - 80)) $((y + 35)) && buttonUp
    read -r farX farY <<<"$(place "handle light")"
    atMost "distance of the light from the pointer" $(((farX - x + 80) * (farX - x + 80) + (farY - y - 35) * (farY - y - 35))) 2
    press s
    quit
    for knob in light-x light-z light-height; do
        reported command | grep -q -- "--$knob " || fail "the light's $knob has not moved: $(reported command)"
    done
    sameAsHeadless shadow-floor-30.png
    # Points: dragged onto their grid, and one more, and one less
    start 'mvgl: shadow-lights' "$folder/shadow-lights" --scene placed --frame 1 --places 0,1/1.5,0.5
    read -r x y <<<"$(place "handle light 2")"
    at "$x" "$y" && buttonDown
    at $((x - 50)) "$y" && buttonUp
    [ "$(reported places)" != 0,1/1.5,0.5 ] || fail "the second light has not moved"
    equal "the first light" 0,1 "$(reported places | cut -d/ -f1)"
    press Insert # under the mouse; the new one is picked
    awaitReport hovered "light 3"
    equal "lights after Insert" 3 "$(reported places | tr / '\n' | wc -l)"
    press shift+Right
    press s
    cp shadow-lights-1.png placed.png
    clickOn "places -"
    equal "lights after the button -" 2 "$(reported places | tr / '\n' | wc -l)"
    clickOn "places +"
    press Tab Delete # the first one
    equal "lights after Delete" 2 "$(reported places | tr / '\n' | wc -l)"
    read -r x y <<<"$(place places)"
    at "$x" "$y" && click # the value as words is edited when it is clicked
    press ctrl+a
    xdotool type --delay 20 "1,1/-1.05,0.5"
    keysDone 13
    press Return
    awaitReport places 1,1/-1.05,0.5
    press s
    quit
    sameAsHeadless shadow-lights-1-2.png
}

replay() { # as fast as xdotool is: nothing is waited for between two moves
    RANDOM=4711
    start 'mvgl: cube-cull' "$cubeCull"
    at 300 300 && buttonDown
    local moves=()
    for _ in $(seq 25); do moves+=(mousemove --window "$window" $((RANDOM % 590 + 5)) $((RANDOM % 590 + 5))); done
    xdotool "${moves[@]}" mousemove --window "$window" 222 111
    awaitReport mouse 222,111
    buttonUp
    turn 4 2
    press s
    quit
    [ "$(reported spin-y)" != 30 ] || fail "the drags moved nothing"
    sameAsHeadless cube-cull-1.png
}

steps() { # by the panel, and what is saved and copied
    start 'mvgl: cube-cull' "$cubeCull" --apart off --size 600x960
    equal "until, of a whole frame" "" "$(reported until)"
    clickOn "Step through the draws"
    awaitReport until 1
    [ -n "$(place "buffer color")" ] || fail "no picture of the colours"
    [ -n "$(place "buffer depth")" ] || fail "no picture of the depths"
    clickOn "<##draw"
    awaitReport until 0
    clickOn ">##draw"
    awaitReport until 1
    # What the draw has changed is outlined: the cube's pixels, as many as differ from the picture before
    for draws in 0 1; do
        "$cubeCull" --apart off --size 600x960 --until $draws --headless --shot "$state/until$draws.png" >"$state/said" || fail "no picture of $draws draws"
    done
    # The mouse over the picture: the pixel's values, and its neighbourhood magnified, with it in the middle
    reach "pixel values"
    turn 5 6
    at 300 480
    await "a magnified pixel" isThere "loupe color"
    screenshot "$state/loupe.ppm"
    local x y
    read -r x y <<<"$(place "loupe color")"
    equal "the middle of the magnified pixels" "srgb(0,0,255)" "$(pixel "$state/loupe.ppm" "$x,$y")"
    read -r x y <<<"$(place "buffer color")"
    at 3 3
    await "another one" isThere "loupe color"
    screenshot "$state/loupe.ppm"
    equal "the same buffer's place" "$x $y" "$(place "buffer color")"
    read -r x y <<<"$(place "loupe color")"
    equal "the middle of the magnified background" "srgb(230,255,255)" "$(pixel "$state/loupe.ppm" "$x,$y")"
    equal "pixels outlined" "$(differing "$state/until0.png" "$state/until1.png")" "$(reported outlined)"
    press s
    awaitReport until 1
    quit
    case $(reported command) in *" --until 1") ;; *) fail "the copied line must end with --until 1: $(reported command)" ;; esac
    sameAsHeadless cube-cull-1.png
    rm cube-cull-1.png
    # More draws than it has: a sentence that says how many, and the slider is there to come back.
    start 'mvgl: cube-cull' "$cubeCull" --apart off --size 600x960 --until 99
    case $(reported error) in "draws: must be 0 .. 2, "*) ;; *) fail "not refused: $(reported error)" ;; esac
    clickOn "<##draw"
    awaitReport until 2
    equal "error" "" "$(reported error)"
    clickOn "Show the whole frame"
    awaitReport until ""
    quit
}
save() {
    start 'mvgl: cube-cull' "$cubeCull"
    press s s
    cp cube-cull-1.png "$state/first.png"
    press Up s
    quit
    equal "files" "cube-cull-1-2.png cube-cull-1-3.png cube-cull-1.png" "$(ls | tr '\n' ' ' | sed 's/ $//')"
    cmp "$state/first.png" cube-cull-1.png || fail "a saved picture was replaced"
    cmp cube-cull-1.png cube-cull-1-2.png || fail "the same picture gave other bytes"
    sameAsHeadless cube-cull-1-3.png
    # A folder that cannot be written to: a sentence, and the window stays.
    mkdir gone && cd gone && start 'mvgl: cube-cull' "$cubeCull" && cd ..
    rmdir gone && press s
    grep -q '^error: cube-cull-1.png: must be in a folder that is there' "$state/err" || fail "no error for a folder that is gone: $(cat "$state/err")"
    quit
}

clipboard() { # a copied line works where the window was opened from, pasted as it is
    pasted() {
        start 'mvgl: cube-cull' "$@" --cull both --size 500x1000
        clickOn "Copy command line"
        local line
        line=$("$(dirname "$launcher")/clipboard")
        quit
        equal "what is pasted is what is reported" "$(reported command)" "$line"
        equal "what --copyable says" "$line" "$("$@" --cull both --size 500x1000 --copyable)"
        sh -c "$line --shot pasted.png" || fail "pasted, '$line' does not run"
        [ -s pasted.png ] || fail "pasted, '$line' makes no picture"
        rm -f pasted.png
        case $line in "$copied"*) ;; *) fail "the line must begin with '$copied': '$line'" ;; esac
    }
    ln -s "$cubeCull" "it's a cube"
    copied="$cubeCull " pasted "$cubeCull"
    copied="'./it'\\''s a cube' " pasted "./it's a cube"
    copied="$launcher cube-cull " pasted "$launcher" cube-cull
    # What a PATH finds is found there again.
    PATH=$(dirname "$cubeCull"):$PATH
    copied="cube-cull " pasted cube-cull
}

matrices() { # go to the clipboard; and smooth edges are in the copied line and in the picture's file
    start 'mvgl: cube-cull' "$cubeCull" --size 500x1000
    clickOn "viewFromModel as LaTeX"
    equal "LaTeX" '\begin{bmatrix}' "$("$(dirname "$launcher")/clipboard" | head -1)"
    clickOn "viewFromModel as C++"
    equal "C++" 'const glm::dmat4 viewFromModel(  // column by column' "$("$(dirname "$launcher")/clipboard" | head -1)"
    clickOn "smooth edges"
    awaitReport command "$cubeCull --size 500x1000 --multisample 4"
    press s
    awaitReport samples 4
    quit
    sameAsHeadless cube-cull-1.png
    equal "the line that the file tells" "$cubeCull --size 500x1000 --multisample 4" "$("$cubeCull" --from cube-cull-1.png --copyable)"
}
desktop() { # the lesson and the shader go to the user's own programs; where none can be asked, that is said
    local source
    source=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
    mkdir programs
    printf '#!/bin/sh\necho "$1" >>"%s/opened"\n' "$PWD" >programs/xdg-open
    chmod +x programs/xdg-open
    local path=$PATH
    PATH=$PWD/programs:$PATH
    start 'mvgl: cube-cull' "$cubeCull"
    clickOn Lesson
    await "the lesson" lastOpened "$source/demos/cube-cull/cube-cull.md"
    clickOn "Edit shader"
    await "the shader" lastOpened "$source/shaders/cube-cull/cube-cull.frag"
    quit
    PATH=$path
    hash -r
    if ! command -v xdg-open >/dev/null; then
        start 'mvgl: cube-cull' "$cubeCull"
        clickOn Lesson
        awaitReport error "xdg-open: must be installed (package xdg-utils) to open this file, $source/demos/cube-cull/cube-cull.md"
        quit
    fi
}
lastOpened() { [ "$(tail -n 1 opened 2>/dev/null)" = "$1" ]; }
error() {
    start 'mvgl: cube-cull' "$cubeCull" --z-dist -0.2
    at 300 300 # what is said about a widget would cover the picture
    screenshot "$state/before.ppm"
    press Up
    awaitReport error "--z-dist: must not be 0: the eye would stand on the point it looks at"
    screenshot "$state/after.ppm"
    isDimmed "$state/before.ppm" "$state/after.ppm" 600x600+0+0
    atLeast "colours of the last good picture" "$(convert "$state/before.ppm" -crop 600x600+0+0 -format %k info:)" 2
    press s
    equal "pictures saved of settings that make none" "" "$(ls)"
    equal "z-dist" 0 "$(reported z-dist)"
    press Up
    awaitReport error "" z-dist 0.2
    quit
    # What is no error of ours is said in our words, too.
    start 'mvgl: probe' "$launcher" probe --frame 1 --mood exhausted
    press 4
    awaitReport error "probe: needs more memory than there is; a smaller --size needs less"
    quit
}

resizing() {
    start 'mvgl: cube-cull' "$cubeCull"
    resize 800 500 440x500
    press s
    quit
    sameAsHeadless cube-cull-1.png
    start 'mvgl: cube-cull' "$cubeCull"
    press h
    await "a picture without the panel" pictureIs 960x600
    isThere hint || fail "nothing tells how to come back"
    screenshot "$state/hinted.ppm"
    press b
    isGone hint || fail "the hint stays when something else is done"
    screenshot "$state/unhinted.ppm"
    atLeast "pixels of the hint" "$(differing "$state/hinted.ppm" "$state/unhinted.ppm")" 500
    quit
    start 'mvgl: cube-cull' "$cubeCull" --size 333x217
    resize 200 100 50x100 # narrower than the panel, of which the picture keeps a quarter
    resize 693 217 333x217
    xdotool windowunmap --sync "$window" windowmap --sync "$window" windowfocus "$window"
    press b
    quit
    equal "picture after being small" 333x217 "$(reported width)x$(reported height)"
}

# storm TITLE PROGRAM ARGUMENTS...: many sizes in quick succession, each change of which asks for a picture: down to a
# single pixel, and minimised.
storm() {
    local storm=() i
    start "$@"
    RANDOM=1234
    for i in $(seq "$sizes"); do
        case $((i % 10)) in
            3) storm+=(windowsize "$window" 1 1) ;;
            6) storm+=(windowsize "$window" $((RANDOM % 1200 + 1)) 1) ;;
            8) storm+=(windowunmap "$window" windowsize "$window" $((RANDOM % 1200 + 1)) 300 windowmap "$window") ;;
            *) storm+=(windowsize "$window" $((RANDOM % 1200 + 1)) $((RANDOM % 1000 + 1))) ;;
        esac
        [ $((i % 7)) -ne 0 ] || storm+=(sleep 0.02) # so that it is no single change for the window
    done
    xdotool "${storm[@]}"
    resize 753 317 393x317
    xdotool windowfocus "$window"
}

stormOfProbe() {
    sizes=100
    storm 'mvgl: probe' "$launcher" probe
    press space ctrl+s
    quit
    equal "error" "" "$(reported error)"
    equal "standard error" "" "$(cat "$state/err")"
    sameAsHeadless probe-*.png
}

stormOf() { # DEMO
    sizes=30
    storm "mvgl: $1" "$(dirname "$cubeCull")/$1"
    press space ctrl+s
    quit
    equal "error" "" "$(reported error)"
    equal "standard error" "" "$(cat "$state/err")"
    sameAsHeadless "$1"-*.png
}

# Sizes that are asked for one after the other belong to different moments; the window must not put them together.
torn() {
    start 'mvgl: cube-cull' "${sham[@]}" SHAM=torn "$cubeCull"
    press Up
    resize 700 600 340x600
    clickOn depth
    awaitReport depth off
    quit
    equal "standard error" "" "$(cat "$state/err")"
}

# ---- Screens of another density

# It looks like a window of twice the size: clicked at where it looks, the box of depth is unchecked, and the cube turns.
# Everything is in pixels of the screen.
looksTwiceAsLarge() {
    screenshot "$state/screen.ppm"
    equal "corner of the picture" "srgb(230,255,255)" "$(pixel "$state/screen.ppm" 3,3)"
    equal "middle of the picture" "srgb(0,0,255)" "$(pixel "$state/screen.ppm" 600,580)"
    equal "lower right corner of the picture" "srgb(230,255,255)" "$(pixel "$state/screen.ppm" 1197,1197)"
    equal "corner of the panel" "srgb(30,33,38)" "$(pixel "$state/screen.ppm" 1203,3)"
    # The only check mark there is, by its colour: width x height + x + y of what has it.
    local w h x y
    IFS='x+' read -r w h x y <<<"$(convert "$state/screen.ppm" -fill black +opaque 'rgb(140,192,255)' -format '%@' info:)"
    atLeast "width of the check mark" "$w" 16 # 9 at ordinary density
    xdotool mousemove --window "$window" $((x + w / 2)) $((y + h / 2))
    click
    awaitReport depth off
    xdotool mousemove --window "$window" 600 600
    awaitReport mouse "$((600 / perUnit)),$((600 / perUnit))"
    buttonDown
    xdotool mousemove --window "$window" 640 600
    awaitReport spin-y "$((30 - 40 / perUnit))"
    buttonUp
    turn 4 1
    awaitReport z-dist -4.2
    press s
    sameAsHeadless cube-cull-1.png
    equal "the picture's size" 1200x1200 "$(reported width)x$(reported height)"
    quit
    equal "standard error" "" "$(cat "$state/err")"
    # The line between two pictures is taken where it is seen, too.
    start 'mvgl: cube-cull' "$@" --compare cull=back,front
    at $((604 / perUnit)) $((400 / perUnit)) && buttonDown
    at $((300 / perUnit)) $((400 / perUnit)) && buttonUp
    quit
    equal "the divider" 0.25 "$(reported divider)"
}

twice() { # the framebuffer is twice the window
    perUnit=2
    start 'mvgl: cube-cull' "${sham[@]}" SHAM=twice "$cubeCull" --apart off
    equal "size, and pixels" "960x600 1920x1200" "$(reported size) $(reported pixels)"
    looksTwiceAsLarge "${sham[@]}" SHAM=twice "$cubeCull"
    perUnit=1
    # A ratio that no screen has is not believed: the window stays as it was, and says so.
    start 'mvgl: cube-cull' "${sham[@]}" SHAM=absurd "$cubeCull"
    equal "size, and pixels" "960x600 960x600" "$(reported size) $(reported pixels)"
    clickOn depth
    awaitReport depth off error ""
    quit
    equal "standard error" "window: pixels for each window coordinate across: must be 0.5 .. 8, 100; 1 is taken
window: pixels for each window coordinate downwards: must be 0.5 .. 8, 100; 1 is taken" "$(cat "$state/err")"
}

density() { # the window has all pixels there are, and everything in it is twice as large
    screenIs() { xprop -root -f RESOURCE_MANAGER 8s -set RESOURCE_MANAGER "Xft.dpi:	$1"; } # DOTS-AN-INCH
    screenIs 192
    start 'mvgl: cube-cull' "$cubeCull" --apart off
    equal "size, and pixels" "1920x1200 1920x1200" "$(reported size) $(reported pixels)"
    looksTwiceAsLarge "$cubeCull"
    start 'mvgl: cube-cull' "$cubeCull"
    resize 800 600 200x600
    quit
    # A density that no screen has is not believed.
    screenIs 9600
    start 'mvgl: cube-cull' "$cubeCull"
    equal "size" 960x600 "$(reported size)"
    quit
    equal "standard error" "window: the screen's scale: must be 0.5 .. 8, 100; 1 is taken" "$(cat "$state/err")"
}

# Frames go by the clock: 60 a second, however many of them were drawn. What is counted is the report's own: the frame
# that is shown, and the seconds up to it, which are taken at the same moment; so a busy machine makes no difference.
time_() {
    start 'mvgl: probe' "$launcher" probe
    frameIsOfItsSecond() {
        local expected
        expected=$(awk -v s="$(reported seconds)" 'BEGIN { print int(60 * s + 1) }')
        atLeast "frame" "$(reported frame)" $((expected - 1)) # a rounding
        atMost "frame" "$(reported frame)" $((expected + 1))
        # ... and no more are drawn than 62.5 a second, though the swap does not wait on this display.
        atMost "frames drawn" "$(reported window_frames)" "$(awk -v s="$(reported seconds)" 'BEGIN { print 62.5 * s + 2 }')"
    }
    local second
    for second in 1 2 3; do
        await "a report of second $second" after $second
        frameIsOfItsSecond
    done
    press space
    awaitReport playing false
    local frame seconds
    frame=$(reported frame) seconds=$(reported seconds)
    await "a second to pass" anotherSecond "$seconds"
    equal "frame after a pause" "$frame" "$(reported frame)"
    quit
}
after() { says && awk -v a="$(reported seconds)" -v b="$1" 'BEGIN { exit !(a >= b) }'; }
anotherSecond() { # nothing is reported of a window at rest, until something is done to it
    press b
    awk -v a="$(reported seconds)" -v b="$1" 'BEGIN { exit !(a >= b + 1) }'
}

paused() {
    start 'mvgl: probe' "$launcher" probe --frame 37
    press ctrl+s
    quit
    equal "frame" 37 "$(reported frame)"
    equal "command" "$launcher probe --frame 37" "$(reported command)"
    sameAsHeadless probe-37.png
    start 'mvgl: probe' "$launcher" probe --frame 37 --size 400x900
    clickOn Step && clickOn Step
    awaitReport frame 39
    clickOn Restart
    awaitReport frame 1
    quit
}

# Somebody plays with a demo that remembers: what was done when is in the copied line, and going back brings it back.
memory() {
    start 'mvgl: frame-rate' "$(dirname "$cubeCull")/frame-rate" --hours 0 --frame 30 --size 500x980
    equal "settings at frame 30" "0 0" "$(reported hours) $(reported jitter)"
    clickOn "preset no-cap"
    awaitReport cap off step-load 20
    for _ in 1 2 3 4 5; do clickOn Step; done
    awaitReport frame 35
    clickOn "preset stutter"
    awaitReport cap on jitter 12
    clickOn Step && clickOn Step
    awaitReport frame 37
    press s
    awaitReport settled true
    case $(reported command) in
        *" --hours 0 "*"--at 30 cap=off"*"--at 35 jitter=12"*"--frame 37"*) ;;
        *) fail "the command has not what was done: $(reported command)" ;;
    esac
    sameAsHeadless frame-rate-37.png
    # Back to frame 32, by dragging the number: the settings are what they were, and so is the picture.
    local x y
    read -r x y <<<"$(place frame)"
    at "$x" "$y" && buttonDown
    at $((x - 5)) "$y" && buttonUp
    awaitReport frame 32 cap off jitter 0
    press s
    awaitReport settled true
    sameAsHeadless frame-rate-32.png
    # A change there is the last; begun anew, there is none.
    clickOn "preset made-for-60"
    awaitReport display 60
    case $(reported command) in *"--at 35"*) fail "what came later is still there: $(reported command)" ;; esac
    clickOn Restart
    awaitReport frame 1 display 60
    equal "command" "$(dirname "$cubeCull")/frame-rate --beside ways --display 60 --hours 0 --size 500x980" "$(reported command)"
    quit
}

# A demo that moves, played by hand: a handle is dragged while it stands and while it plays, time is stopped and gone
# through to and fro, two settings are compared. Whatever is saved, the copied line makes, and a frame is the same again.
# motionOf DEMO HANDLE KNOBS FLAGS KNOB=A,B FLAGS: with the first flags the handle moves these knobs ("hand-x hand-y"), with
# the others A and B are compared.
motionOf() {
    local demo=$1 handle=$2 knobs=$3 compared=$5 x y frame before notches
    local flags comparing
    read -ra flags <<<"$4"
    read -ra comparing <<<"$6"
    start "mvgl: $demo" "$(dirname "$cubeCull")/$demo" --frame 30 --size 720x560 "${flags[@]}"
    moved() { # X Y: where the handle was, it is dragged there from, by 40 to the left and 25 down, in three moves
        before=$(knobValues "$knobs")
        at "$1" "$2" && buttonDown
        at $(($1 - 10)) $(($2 + 5)) && at $(($1 - 30)) $(($2 + 20)) && at $(($1 - 40)) $(($2 + 25)) && buttonUp
        [ "$(knobValues "$knobs")" != "$before" ] || fail "$demo: dragging '$handle' has not moved $knobs"
    }
    read -r x y <<<"$(place "handle $handle")"
    moved "$x" "$y"
    press s
    sameAsHeadless "$demo-30.png"
    # While it plays; what is on its way is seen where it was when the report was written, so only what stands is taken
    press space
    await "frame 45" atFrame 45
    case $handle in car) ;; *)
        read -r x y <<<"$(place "handle $handle")"
        moved "$x" "$y"
        ;;
    esac
    press space
    awaitReport playing false
    frame=$(reported frame)
    press s
    cp "$demo-$frame.png" last.png
    sameAsHeadless last.png
    # Back, by dragging the number, and forward again
    at 900 300
    for ((notches = 0; notches < 60; ++notches)); do # the panel is longer than the window is high
        read -r x y <<<"$(place frame)"
        [ "$y" -gt 530 ] || break
        turn 5 1
    done
    at "$x" "$y" && buttonDown
    at $((x - 15)) "$y"
    awaitReport frame $((frame - 15))
    buttonUp
    press s
    sameAsHeadless "$demo-$((frame - 15)).png"
    [ "$demo" = robot-arm ] || ! cmp -s "$demo-$((frame - 15)).png" last.png || # whose solution no time changes
        fail "$demo: 15 frames before, the picture is the same"
    at "$x" "$y" && buttonDown
    at $((x + 15)) "$y"
    awaitReport frame "$frame"
    buttonUp
    press s
    cmp "$demo-$frame-2.png" last.png || fail "$demo: frame $frame is another after going back"
    quit
    # Two side by side, while it plays, and as they stand. Pictures are named by their frames, and this may stop at one of
    # those above.
    rm "$demo"-*.png
    start "mvgl: $demo" "$(dirname "$cubeCull")/$demo" --frame 30 --size 720x560 "${comparing[@]}" --compare "$compared"
    awaitReport compare "${compared%%=*}"
    press space
    await "frame 40" atFrame 40
    press space
    awaitReport playing false
    frame=$(reported frame)
    press s
    quit
    # Below the labels, left and right of the line in the middle
    local side knob=${compared%%=*} values=${compared#*=}
    for side in "${values%%,*} 0" "${values##*,} 363"; do
        x=${side#* }
        "$(dirname "$cubeCull")/$demo" --size 720x560 "${comparing[@]}" --"$knob" "${side% *}" --frame "$frame" --shot side.png
        equal "pixels of $knob ${side% *} that are another in the comparison" 0 \
            "$(differingIn "$demo-$frame.png" side.png "357x500+$x+60")"
        mv side.png "side-$x.png"
    done
    cmp -s side-0.png side-363.png && fail "$demo: $compared have one picture"
}
knobValues() { # "NAME NAME"
    local knob
    for knob in $1; do echo "$(reported "$knob")"; done
}
atFrame() { says && [ "$(reported frame)" -ge "$1" ]; }
motion() { # DEMO
    case $1 in
        keyframes) motionOf keyframes "key 3" points "--curve catmull-rom" curve=linear,natural "" ;;
        path) motionOf path car start "" up=fixed,banking "" ;;
        robot-arm) motionOf robot-arm target "target-x target-y" "--scene arm --method dls" method=closed,ccd "--scene walker" ;;
        springs) motionOf springs hand "hand-x hand-y" "" method=explicit-euler,energy-momentum "" ;;
        *) die "no hand plays with $1" ;;
    esac
}

reload() {
    mkdir shaders && export PROBE_SHADERS=$PWD/shaders
    cat >shaders/probe.vert <<'END'
void main() { gl_Position = vec4(vec2(gl_VertexID & 1, gl_VertexID >> 1) - 0.5, 0.0, 1.0); }
END
    fragment() { # written in one go: what is followed is never half a file
        printf 'uniform float level;\nout vec4 fragColor;\nvoid main() { fragColor = vec4(%s); }\n' "$1" >"$state/probe.frag"
        mv "$state/probe.frag" shaders/probe.frag
    }
    fragment 'level, 1.0, 0.0, 1.0'
    start 'mvgl: probe' "$launcher" probe --frame 1 --level 0
    await "a green square" squareIs "srgb(0,255,0)"
    fragment '1.0, level, 0.0, 1.0'
    await "a red square after an edit" squareIs "srgb(255,0,0)"
    fragment '1.0, level, 0.0, nonsense'
    await "the mistake in the report" hasMistake
    grep -q '^error: shaders/probe.frag' "$state/err" || fail "the mistake is not told: $(cat "$state/err")"
    grep -q '^shaders/probe.frag:3: .*nonsense' "$state/err" || fail "the mistake is not told by file and line: $(cat "$state/err")"
    squareIs "srgb(255,0,0)" || fail "the square after a mistake is another"
    fragment '0.0, level, 1.0, 1.0'
    await "a blue square after it was mended" squareIs "srgb(0,0,255)"
    awaitReport error ""
    quit
}
squareIs() { import -window root "$state/screen.ppm" && [ "$(pixel "$state/screen.ppm" 200,150)" = "$1" ]; }
hasMistake() { says && reported error | grep -q 'shaders/probe.frag:3'; }

launcher_() {
    start 'mvgl' "$launcher"
    equal "what is chosen at the start" probe "$(reported menu)"
    press Return
    awaitReport demo probe
    window=$(windowCalled 'mvgl: probe')
    equal "window's size" "760x300" "$(xdotool getwindowgeometry "$window" | sed -n 's/.*Geometry: //p')"
    press BackSpace
    awaitReport menu probe
    press Right Return # one that cannot be opened
    awaitReport menu broken error "broken: must never open; that is what it is for"
    press Right
    awaitReport menu cube-cull
    press Return
    awaitReport demo cube-cull
    press BackSpace
    awaitReport menu cube-cull
    # By mouse
    clickOn probe
    awaitReport demo probe
    press BackSpace
    awaitReport menu probe
    clickOn cube-cull
    awaitReport demo cube-cull
    [ -n "$(windowCalled 'mvgl: cube-cull')" ] || fail "the window is not called like its demo"
    press Up
    awaitReport z-dist -3.8
    press Escape # of a demo that it opened: back to it
    awaitReport menu cube-cull
    # Letters search: of names, sentences and chapters
    write prob
    awaitReport search prob menu probe
    [ -z "${values["at cube-cull"]-}" ] || fail "what is not found is shown"
    press Escape # all of them again, and only that
    awaitReport search ""
    [ -n "${values["at cube-cull"]-}" ] || fail "what was not found is not shown again"
    write cull
    press Return
    awaitReport demo cube-cull
    press Escape
    awaitReport menu cube-cull
    quit
    "$launcher" broken 2>"$state/err" && fail "a demo that fails, asked for by name, must end with an error"
    equal "its error" "error: broken: must never open; that is what it is for" "$(cat "$state/err")"
}

sameAgain() {
    start 'mvgl: cube-cull' "$launcher" cube-cull
    press s BackSpace
    awaitReport menu cube-cull
    press Left Left Return
    awaitReport demo probe
    press BackSpace
    awaitReport menu probe
    press Right Right Return
    awaitReport demo cube-cull
    press s Escape
    awaitReport menu cube-cull # which opened it
    quit
    cmp cube-cull-1.png cube-cull-1-2.png || fail "after another demo the first one's picture is another"
}

# A window at rest draws nothing and takes next to no time. What is counted: the window's frames, which the press of a key
# without effect adds at most nine to (three each for key, letter and letting go), however long the rest was before; and
# the processor's ticks of the program alone, beside the seconds that passed meanwhile.
idle() {
    ticks() { awk '{ print $14 + $15 }' /proc/$pid/stat; }
    atRest() { # WHAT
        local frames before start
        frames=$(reported window_frames) before=$(ticks) start=$(date +%s%N)
        sleep 3
        local used=$(($(ticks) - before)) passed=$((($(date +%s%N) - start) / 1000000))
        echo "$1 at rest: $used ticks of $((passed * $(getconf CLK_TCK) / 1000)) in $passed ms"
        atMost "processor time of $1 at rest, ticks" $used $((passed * $(getconf CLK_TCK) / 1000 / 50)) # 2 %
        press F2
        atMost "frames of $1 at rest" $(($(reported window_frames) - frames)) 9
    }
    start 'mvgl: cube-cull' "$cubeCull"
    atRest "cube-cull"
    equal "demo frames of a window at rest" 1 "$(reported demo_frames)"
    quit
    # The same for an animated demo while it is paused, for the menu, and for two settings side by side.
    start 'mvgl: probe' "$launcher" probe --frame 5
    atRest "a paused demo"
    press BackSpace
    awaitReport menu probe
    atRest "the menu"
    quit
    start 'mvgl: cube-cull' "$cubeCull" --compare cull=back,front
    atRest "a comparison"
    equal "demo frames of a comparison at rest" 2 "$(reported demo_frames)"
    quit
}

compare_() {
    local settings="--spin-x 25 --spin-y 35"
    # shellcheck disable=SC2086
    {
        "$cubeCull" $settings --cull back --shot back.png
        "$cubeCull" $settings --cull front --shot front.png
        start 'mvgl: cube-cull' "$cubeCull" $settings --compare cull=back,front
    }
    # Columns of the picture, below its labels, are those of one setting: sides SAVED LEFT-TO-X RIGHT-FROM-X
    sides() {
        equal "pixels of $1 left of the line that are not A's" 0 "$(differingIn "$1" back.png "$2x560+0+40")"
        equal "pixels of $1 right of the line that are not B's" 0 "$(differingIn "$1" front.png "$((600 - $3))x560+$3+40")"
    }
    press s
    mv cube-cull-1.png halves.png && sides halves.png 299 302
    at 303 200 && buttonDown # near the line, not on it
    at 250 200 && at 150 220 && buttonUp
    at 300 500 # the line stays where it was let go
    press s
    mv cube-cull-1.png dragged.png && sides dragged.png 149 152
    press bracketright bracketright bracketright bracketright bracketright bracketleft
    press s
    mv cube-cull-1.png keys.png && sides keys.png 197 200
    quit
    equal "the divider" 0.33 "$(printf %.2f "$(reported divider)")"
    equal "settings after the line was dragged" "25 35" "$(reported spin-x) $(reported spin-y)"
    # Dragging and pushing the line draws neither of the two again.
    equal "demo frames" 2 "$(reported demo_frames)"
    equal "command" "$cubeCull $settings --compare cull=back,front" "$(reported command)"
    differingIn back.png front.png 600x600+0+0 >count
    equal "the difference" "$(awk '{ printf "difference: %.2f %% of pixels, at most 255 of 255", 100 * $1 / 360000 }' count)" \
        "$(reported difference)"
    # The other knobs are for both.
    # shellcheck disable=SC2086
    start 'mvgl: cube-cull' "$cubeCull" $settings --compare cull=back,front
    at 100 300 && buttonDown && at 110 300 && buttonUp
    press s
    quit
    equal "spin-y after a drag far from the line" 25 "$(reported spin-y)"
    "$cubeCull" --spin-x 25 --spin-y 25 --cull back --shot back.png
    "$cubeCull" --spin-x 25 --spin-y 25 --cull front --shot front.png
    sides cube-cull-1.png 299 302
}

differingIn() { # FILE FILE AREA: how many pixels
    convert "$1" -crop "$3" +repage x.png && convert "$2" -crop "$3" +repage y.png
    differing x.png y.png
}

comparePanel() {
    local probe=("$launcher" probe --frame 5 --size 400x1000)
    start 'mvgl: probe' "${probe[@]}"
    clickOn "Compare with"
    press Escape # closes the list, and only that
    clickOn "Compare with"
    press Escape
    equal "what is compared after Escape" "" "$(reported compare)"
    clickOn "Compare with"
    clickOn "compare count"
    awaitReport compare count compare_with 9
    equal "command" "$launcher probe --compare count=3,9 --frame 5 --size 400x1000" "$(reported command)"
    quit
    # Each view, saved as it is shown; mood does not change the picture, level does.
    "${probe[@]}" --level 0.25 --shot a.png
    "${probe[@]}" --level 0.75 --shot b.png
    middle() { echo "$(pixel "$1" 150,500) $(pixel "$1" 250,500)"; }
    start 'mvgl: probe' "${probe[@]}" --compare level=0.25,0.75
    local view
    for view in difference A B divider; do
        clickOn "$view"
        press ctrl+s
        mv probe-5.png "view-$view.png"
    done
    local a b
    read -r a _ <<<"$(middle a.png)" && read -r b _ <<<"$(middle b.png)"
    [ "$a" != "$b" ] || fail "the two settings have the same picture"
    equal "view divider" "$a $b" "$(middle view-divider.png)"
    equal "view A" "$a $a" "$(middle view-A.png)"
    equal "view B" "$b $b" "$(middle view-B.png)"
    # 128 levels apart: 96 + 159 * 128 / 255 green in full red
    equal "view difference" "srgb(255,175,0) srgb(255,175,0)" "$(middle view-difference.png)"
    clickOn "Stop comparing"
    awaitReport command "$launcher probe --frame 5 --size 400x1000"
    press ctrl+s
    cmp probe-5.png a.png || fail "after the end the picture is not A's"
    quit
    # A key and a drag that move the compared knob move A; a setting that B cannot have is told with its name.
    start 'mvgl: probe' "$launcher" probe --frame 5 --mood loud --compare level=0.5,1
    press n
    awaitReport error "with level = 1: --level: must be less than 1 while --mood is loud" level 0.375
    quit
}

study() {
    local integral=("$launcher" integral --size 400x1000)
    start 'mvgl: integral' "${integral[@]}"
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
    # Beside the points a click sets nothing.
    at $((x64 + 3)) $((y64 - 60)) && click
    equal "row after a click beside the points" "trapezia 4" "$(reported here)"
    equal "demo frames" 1 "$(reported demo_frames)"
    clickOn "point simpson 16"
    awaitReport here "simpson 16" command "$launcher integral --rule simpson --n 16 --size 400x1000"
    quit
    # It begins with the scene of its settings; settings that were not measured are at no point.
    start 'mvgl: integral' "${integral[@]}" --function root --n 64
    equal "row in another scene" "trapezia 64" "$(reported here)"
    quit
    start 'mvgl: integral' "${integral[@]}" --n 5
    equal "row of settings that were not measured" "" "$(reported here)"
    quit
    # A point sets what its row leaves as it opens, too: none of the others names --by.
    start 'mvgl: shadow-volume' "$(dirname "$cubeCull")/shadow-volume" --size 320x700 --method z-pass-started --by geometry-shader
    clickOn "point z-fail, every triangle"
    awaitReport by processor here "z-fail, every triangle"
    quit
}

bound() { # a click on an axis of the study's plot chooses what keeps it
    local integral=("$launcher" integral --size 400x1100)
    local x y left right _
    start 'mvgl: integral' "${integral[@]}"
    equal "what was asked for at first" "" "$(reported asked)"
    # Of errors of some 1e-6, which is the middle of the axis, 16 strips of Simpson's are the cheapest.
    clickOn "error axis"
    awaitReport here "simpson 16" command "$launcher integral --rule simpson --n 16 --size 400x1100"
    reported asked | grep -Eq '^error [2-9](\.[0-9])?e-06: simpson 16$' || fail "asked for: $(reported asked)"
    # Within 0.2 ms, the middle of the other axis, 64 of them are the most exact.
    clickOn "time axis"
    awaitReport here "simpson 64"
    reported asked | grep -Eq '^time 0\.[12][0-9]* ms: simpson 64$' || fail "asked for: $(reported asked)"
    clickOn "error axis 0"
    awaitReport here exact asked "error 0: exact"
    # The box beside a point covers none: it is left of the panel.
    read -r x y <<<"$(place "point trapezia 64")"
    at "$x" "$y"
    IFS=, read -r left _ right _ <<<"${values["at study tip"]-}"
    [ -n "$right" ] || fail "no box beside the plot"
    atMost "right side of the box" "$right" 400
    atLeast "left side of the box" "$left" 0
    click # a point is no bound
    awaitReport here "trapezia 64" asked ""
    quit
    # The fastest takes 4 us: nothing keeps less, which is said, and the knobs stay.
    start 'mvgl: integral' "${integral[@]}" --n 16
    IFS=, read -r left y right _ <<<"${values["at time axis"]-}"
    read -r x _ <<<"$(place "time axis")"
    read -r _ y <<<"$(place "error axis")"
    at "$x" $((y - 12)) && click
    reported asked | grep -q '^time .*: nothing$' || fail "asked for what nothing keeps: $(reported asked)"
    equal "row after it" "trapezia 16" "$(reported here)"
    quit
}

# Begins to measure, in the program $child, by a study that lasts until the file PROBE_HOLD is gone.
measuring() {
    mkdir -p tmp && export TMPDIR=$PWD/tmp PROBE_HOLD=$state/hold
    touch "$PROBE_HOLD"
    start 'mvgl: integral' "$launcher" integral --n 16 --size 400x1100
    clickOn "Measure here"
    awaitReport measuring true
    child=$(pgrep -P $pid)
    [ -n "$child" ] || fail "no program measures"
    [ -n "$(ls tmp)" ] || fail "a measurement has no folder"
}

measure() {
    measuring
    rm "$PROBE_HOLD"
    awaitReport measuring false
    equal "folders of a measurement that is done" "" "$(ls tmp)"
    reported study | grep -q "^Measured here: .* threads\.$" || fail "the plot is not the one measured here: $(reported study)"
    equal "row of the present settings, as measured" "trapezia 16" "$(reported here)"
    # The committed run can be had again.
    clickOn machine && clickOn "machine a machine of long ago, 1 thread"
    awaitReport study "Committed, measured on: no driver, a machine of long ago, 1 thread."
    quit
    equal "standard error" "" "$(cat "$state/err")"
    # Closing the window ends one that lasts, and so do Cancel and a window that is killed.
    measuring
    quit
    equal "measuring while the window was closed" true "$(reported measuring)"
    ended "$child" 2>/dev/null || fail "the measurement outlives the window"
    equal "folders after the window was closed" "" "$(ls tmp)"
    measuring
    clickOn Cancel
    awaitReport measuring false
    ended "$child" 2>/dev/null || fail "the measurement outlives Cancel"
    equal "folders after Cancel" "" "$(ls tmp)"
    reported study | grep -q '^Committed' || fail "after Cancel the committed study must be shown: $(reported study)"
    quit
    measuring
    kill -KILL $pid
    awaitEnd "the end of a window that is killed" 2>/dev/null
    await "the end of what it measured" ended "$child"
}

noDisplay() {
    env -u DISPLAY -u WAYLAND_DISPLAY "$cubeCull" >out 2>err
    equal "exit status" 1 $?
    equal "sentence" "error: window: needs a display (DISPLAY or WAYLAND_DISPLAY); use --shot FILE without" "$(cat err)"
    env -u DISPLAY -u WAYLAND_DISPLAY "$cubeCull" --window --report >out 2>err
    equal "exit status of a report that wants a window" 1 $?
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

vanish() { # the display goes, as the connection to another machine's may
    measuring
    kill $server
    server=
    awaitEnd "the end of the program after its display's"
    equal "exit status" 1 $status
    grep -qi 'X connection\|X server' "$state/err" || fail "no word about the display: $(cat "$state/err")"
    await "the end of what it measured" ended "$child"
    equal "folders after the display has gone" "" "$(ls tmp)"
}

# -r: no key repeats but where a test is about it; a key that xdotool holds down for too long on a busy machine would.
repeat=-r screen=1280x1024
sham=(env LD_PRELOAD="$(dirname "$launcher")/sham.so")
case $case in
    held) repeat=r ;;
    twice | density) screen=2560x1600 ;;
esac
openDisplay $screen $repeat
case $case in
    same-again) sameAgain ;;
    no-display) noDisplay ;;
    time) time_ ;;
    compare) compare_ ;;
    compare-panel) comparePanel ;;
    launcher) launcher_ ;;
    resize) resizing ;;
    storm) stormOfProbe ;;
    own-buffers) # demos that own buffers of the window's size
        for demo in shadow-map soft-shadows z-buffer shadow-volume; do stormOf $demo; done
        ;;
    demo.*)
        keysOf "${case#demo.}"
        stormOf "${case#demo.}"
        ;;
    motion.*) motion "${case#motion.}" ;;
    opens | people | tips | widened | folds | keys | keyboard | undo | sweep | whole | one_by_one | held | slider | preset | typed | choice | wheel | drag | hand | replay | save | clipboard | matrices | desktop | error | torn | twice | density | paused | memory | reload | idle | steps | study | bound | measure | drop | vanish)
        "$case"
        ;;
    *) fail "there is no case '$case'" ;;
esac
[ $failures -eq 0 ] && echo "passed: $case"
exit $((failures > 0))
