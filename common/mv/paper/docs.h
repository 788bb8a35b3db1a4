// Pages made from the declarations, so that nothing about a demo is written twice.
#pragma once
#include <string>
#include <vector>

#include "mv/demo/demo.h"
#include "mv/image/picture.h"
#include "mv/study/data.h"

namespace mv {

// docs/demos.md: by chapters, every demo with its sentence, controls, knobs, readouts and needs.
std::string cataloguePage();

// The lesson page with the tables between its markers <!-- knobs --> and <!-- /knobs --> made anew.
// Error: the markers are missing.
std::string lessonPage(const std::string& page, const DemoInfo& info);

// README.md with the table of all demos, by chapters, made anew between <!-- demos --> and <!-- /demos -->.
// Error: the markers are missing.
std::string readmePage(const std::string& page);

// The committed runs of a demo's study, read from a source tree (docs/errors-and-times/DEMO.*.csv), a processor's first: not from
// what is built in, so that a study that was just measured needs no build between. Empty where there is none. Error: a file
// cannot be read.
std::vector<StudyRun> studiesInTree(const std::string& root, const std::string& demo);

// The pages of a source tree that tell marked numbers (mv/paper/page_numbers.h), as paths below `root`: README.md, the lessons
// and what stands in docs, in this order.
std::vector<std::string> pagesWithNumbers(const std::string& root);

// Writes docs/demos.md, the tables of demos/*.md and README.md, the numbers of all pages that no longer hold, the pages and
// plots of docs/errors-and-times and docs/strip.png into a source tree. Error: demos without a page, all of them, before
// anything is written; and what lessonPage, readmePage and withNumbers refuse, before anything is written, too.
void writeDocs(const std::string& root);

// All demos in their poses at frame 1, for the README: in rows of equal length, nine at most.
Picture pictureStrip();

}  // namespace mv
