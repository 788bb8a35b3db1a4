// Pages made from the declarations, so that nothing about a demo is written twice.
#pragma once
#include <string>

#include "mv/demo/demo.h"
#include "mv/image/picture.h"

namespace mv {

// docs/demos.md: by chapters, every demo with its sentence, controls, knobs, readouts and needs.
std::string cataloguePage();

// The lesson page with the tables between its markers <!-- knobs --> and <!-- /knobs --> made anew.
// Error: the markers are missing.
std::string lessonPage(const std::string& page, const DemoInfo& info);

// README.md with the table of all demos, by chapters, made anew between <!-- demos --> and <!-- /demos -->.
// Error: the markers are missing.
std::string readmePage(const std::string& page);

// Writes docs/demos.md, the tables of demos/*.md and README.md, the pages and plots of docs/errors-and-times and
// docs/strip.png into a source tree. Error: demos without a page, all of them, before anything is written; and what
// lessonPage and readmePage refuse.
void writeDocs(const std::string& root);

// All demos in their poses at frame 1, for the README: in rows of equal length, nine at most.
Picture pictureStrip();

}  // namespace mv
