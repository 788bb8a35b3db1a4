// The numbers that a page tells, each with what makes it. In a page's text a measured number stands between two comments,
// which no reader of the page sees:
//
//     at 1024 texels <!--= study shadow-map; still life; 1 tap; 1024; wrong % -->0.10<!--/--> % of the pixels are wrong
//     the horizon leans by <!--= run viewpoints view=5 height=20 frame=100; roll -->8.7<!--/--> degrees
//
// What makes it is one of
//
//     study DEMO; SCENE; METHOD; P; COLUMN     a row of the committed study, docs/errors-and-times/DEMO.json
//     run DEMO FLAG=VALUE ...; QUANTITY        a readout, or a count, of the frame that these flags draw
//     run DEMO ... frames=A..B; largest QUANTITY          the same over several frames; or smallest
//     run DEMO ... compare=KNOB=a,b; different pixels     of the two pictures
//     run DEMO ... audit; KIND                 how many findings of that kind --audit has
//     run DEMO ... vary=KNOB=a,b,c; P; COLUMN  a row of the study that --study out --vary KNOB=a,b,c makes
//     tested: SUITE.NAME                       nothing here: that test, which holds the number
//     exact: REASON                            nothing: a number that was not measured, and why it is what it is
//
// A column is a heading of the study's page ("rms", "max", "wrong %", "away from edges %", "ms", "MAD"), one of "n",
// "unmatched", "wrong pixels", "slope" and "time slope", or the name of a count ("fragments"). Flags stand without their
// dashes, since a comment must not hold two of them. Two of these with " / " between them are a ratio; what the second
// leaves out in front is as in the first. " as percent", " as percent more", " as percent less" and " as thousands" at the
// end say how the number is told.
#pragma once
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "mv/run/stage.h"
#include "mv/run/study_data.h"

namespace mv {

// One number of a page.
struct PageNumber {
    int line = 0;          // of the page, from 1
    std::string source;    // what makes it: what stands between <!--= and -->
    std::string text;      // the number as the page tells it
    std::size_t from = 0;  // where `text` begins in the page
};

// What a source makes.
struct MadeNumber {
    double value = 0;
    // How much the same source may make with another driver. 0 for counts, and for what a committed file says.
    double tolerance = 0;
    bool isCount = false;  // a whole number, told in full
};

// The marked numbers of the page, in their order. Error, naming `file` and line: a marker that is not closed on its line,
// that Markdown would not take for a comment, or that holds no number.
std::vector<PageNumber> pageNumbers(const std::string& page, const std::string& file);

// Makes numbers from their sources. What was drawn or read for one of them is kept for the next.
class NumberSources {
  public:
    // `study` gives the committed study of a demo (an Error where there is none), `stage` a stage to draw on.
    NumberSources(std::function<StudyRun(const std::string& demo)> study, std::function<Stage&()> stage);
    // Nothing for what is exact, or what a test holds. Error: no such study, row, column, demo, flag or readout; a row that
    // failed; a source that is none of the above.
    std::optional<MadeNumber> make(const std::string& source);

  private:
    using Quantities = std::map<std::string, MadeNumber>;
    MadeNumber quantity(const std::vector<std::string>& fields);
    const StudyRun& committed(const std::string& demo);
    MadeNumber ofRun(const std::vector<std::string>& fields);
    std::function<StudyRun(const std::string& demo)> readStudy_;
    std::function<Stage&()> stage_;
    std::map<std::string, StudyRun> studies_;  // by demo
    std::map<std::string, StudyRun> varied_;   // by command
    std::map<std::string, Quantities> drawn_;  // by command
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
