// Keys, drags and wheel notches that move a knob: the controls of the WebGL originals.
#pragma once
#include <string>

#include "mv/demo/literal.h"

namespace mv {

class Knob;

// A key of the keyboard: a capital letter or digit by its character, the arrows by name.
enum class Key : int { left = 256, right, up, down };
constexpr Key key(char character) { return static_cast<Key>(character); }

enum class Gesture { key, dragAcross, dragDown, wheel };

// One rule: this gesture moves that knob. `amount` is per key press, per pixel (across: to the right, down: downwards)
// or per wheel notch (away from the user). A key with `text` sets the knob to it instead.
struct Binding {
    Gesture gesture;
    Key key;
    Knob* knob;
    double amount;
    std::string text = {};
};

// A key, a drag or the wheel, which moves settings by their names.
struct Control {
    Gesture gesture;
    Literal knob, other = {};  // `other`: of a drag, what moving down moves; of a key, the value that it sets
    Key key = {}, otherKey = {};
    double amount = 0, otherAmount = 0;
};

// "Up", "7", "W"
std::string keyName(Key key);

}  // namespace mv
