// The parts of the panel that only show something.
#pragma once
#include <string>

#include "mv/demo/demo.h"
#include "mv/show/session.h"
#include "mv/window/comparison.h"
#include "mv/window/gui.h"

namespace mv {

// A heading that folds what stands under it; open at first.
bool section(const char* title);

// A button for each preset, and what to look for in the one whose settings are the present ones. True when one was pressed.
bool showPresets(const DemoInfo& info, Demo& demo);

// The demo's readouts of this picture; while two settings are compared, of both.
void showReadouts(const Demo& demo, const Comparison& comparison);

// The knob to compare, and how the two are shown. True when the picture is to be drawn anew.
bool showComparison(Demo& demo, Comparison& comparison, Gui& gui);

// Live tables of the matrices, laid out as on paper; the mouse on an entry shows what it is made of. Returns what is to go to
// the clipboard, "" for nothing.
std::string showMatrices(const FrameNotes& notes);

// Play, pause, step, speed, and which frame. True when another frame is to be shown.
bool showTime(Session& session, float scale);
// How far a picture made in passes is.
void showPasses(int done, int passes);

// Whether a key of that letter is one of the demo's own.
bool isBound(const Demo& demo, char letter);
// The keys, drag and wheel: the demo's own, then the window's.
void showControls(const Demo& demo, bool animated, bool menu, bool fromMenu, bool comparing);

// Messages in a box at the bottom: errors red, notes amber. The height they take, 0 where there are none.
struct Message {
    std::string text;
    bool error = false;
};
float messagesHeight(const std::vector<Message>& messages, float width, float most);
void showMessages(const std::vector<Message>& messages, float height);

}  // namespace mv
