// What a lecture asks of a demo: a movie, one sentence on two settings, a plot of one scene.
#pragma once
#include <string>

#include "mv/run/command_line.h"

namespace mv {

// --movie FILE: the frames of --frames, or a picture for each value of --vary, 60 a second, by ffmpeg. Error: there is no
// ffmpeg, or it cannot make such a file.
void writeMovie(const Command& command);

// --versus KNOB=A,B: prints what A costs and how wrong it is, and B beside it.
void printVersus(const Command& command);

// --plot [SCENE=]FILE.svg: a scene of the demo's committed study, as --study draws it. Error: there is no such study or scene.
void writePlot(const Command& command);

}  // namespace mv
