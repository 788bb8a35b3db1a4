// What the figures of keyframes share: panes, units and words. figure.cpp
#pragma once
#include <string>

#include "keyframes.h"

namespace mv::keyframes {

enum class Part { upper, lower, both };  // of the right side of the picture
const vec4 red(0.75, 0.15, 0.1, 1), blue(0.1, 0.3, 0.7, 1), grey(0.75, 0.75, 0.75, 1), ink(0.1, 0.1, 0.1, 1),
    orange(0.9, 0.5, 0.1, 1);

double unit(const Pane& pane);
// Ten metres each way and a margin, for what goes beyond its keys.
double metre(const Pane& pane);
TextStyle wordStyle(const FrameInfo& frame, const vec4& color);
Pane wholePane(const FrameInfo& frame);
// On the right, or below in a picture that is higher than wide, with room for what is written along the axes.
Box boxOf(const FrameInfo& frame, Part part);
void words(Drawing& drawing, const FrameInfo& frame, int line, const std::string& text, const vec4& color = ink);

}  // namespace mv::keyframes
