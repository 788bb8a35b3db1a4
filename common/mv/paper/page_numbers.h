// The numbers that a page tells, each with what makes it. In a page's text a measured number stands between two comments,
// which no reader of the page sees:
//
//     at 1024 texels <!--= study shadow-map; still life; 1 tap; 1024; wrong % -->0.10<!--/--> % of the pixels are wrong
//     the horizon leans by <!--= run viewpoints view=5 height=20 frame=100; roll -->8.7<!--/--> degrees
//
// Its source is one of
//
//     study DEMO; SCENE; METHOD; P; COLUMN       a row of the committed study of a processor, docs/errors-and-times/DEMO.processor.csv
//     study DEMO gpu; SCENE; METHOD; P; COLUMN   the same of a GPU
//     run DEMO FLAG=VALUE ...; READOUT           a readout, or a count, of the frame that these flags draw
//
// A column is a heading of the study's page ("rms", "max", "wrong %", "away from edges %", "ms", "MAD"), one of "n",
// "unmatched", "wrong pixels", "slope" and "time slope", or the name of a count ("fragments"). Flags stand without their
// dashes, since a comment must not hold two of them. A number that follows from a formula or is held by a test has no
// marker.
#pragma once
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "mv/show/stage.h"
#include "mv/study/data.h"

namespace mv {

// One number of a page.
struct PageNumber {
    int line = 0;          // of the page, from 1
    std::string source;    // what makes it: what stands between <!--= and -->
    std::string text;      // the number as the page tells it
    std::size_t from = 0;  // where `text` begins in the page
};

// The number that a source makes.
struct MadeNumber {
    double value = 0;
    // How much the same source may make with another driver. 0 for counts, and for what a committed file says.
    double tolerance = 0;
    bool isCount = false;  // a whole number, told in full
};

// The marked numbers of the page, in their order. Error, naming `file` and line: a marker that is not closed on its line,
// that Markdown would not take for a comment, or that holds no number.
std::vector<PageNumber> pageNumbers(const std::string& page, const std::string& file);

// Makes numbers from their sources. Pictures and files of one of them are kept for the next.
class NumberSources {
  public:
    // `studies` gives the committed runs of a demo's study, a processor's first, `stage` a stage to draw on.
    NumberSources(std::function<std::vector<StudyRun>(const std::string& demo)> studies, std::function<Stage&()> stage);
    // Error: no such study, row, column, demo, flag or readout; a row that failed; a source that is none of the above.
    MadeNumber make(const std::string& source);

  private:
    using Quantities = std::map<std::string, MadeNumber>;
    const StudyRun& committed(const std::string& demo, Drawer drawer);
    MadeNumber ofRun(const std::vector<std::string>& fields);
    std::function<std::vector<StudyRun>(const std::string& demo)> readStudies_;
    std::function<Stage&()> stage_;
    std::map<std::string, std::vector<StudyRun>> studies_;  // by demo
    std::map<std::string, StudyRun> varied_;                // by command
    std::map<std::string, Quantities> drawn_;               // by command
};

// Whether the page may go on telling `text`: the number made rounds to it, give or take its tolerance. A plain "0" says
// exactly that; "0.00" says that it is less than half of a hundredth.
bool tells(const std::string& text, const MadeNumber& made);

// The number made, told as `text` was: as many digits, but two at least; a count in full.
std::string toldLike(const std::string& text, const MadeNumber& made);

// The page with each marked number that no longer holds told anew. Error, naming `file` and line: what pageNumbers and
// NumberSources refuse.
std::string withNumbers(const std::string& page, const std::string& file, NumberSources& sources);

}  // namespace mv
