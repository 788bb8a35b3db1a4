// The memory that stays in use, frame after frame.
#include <algorithm>
#include <cstdio>
#include <vector>

#include "mv/gl/gl.h"
#include "support/live_bytes.h"
#include "visits/visit.h"

namespace mv::test {
namespace {

// The pictures of a user who plays with each knob: one after the other, each knob at each of its ends while the others are as the demo
// opens, and then the demo as it opens, with its readouts. Frames are numbered on, as in a window; but of a demo that remembers each
// round begins with frame 1, since a knob that has moved leads it through all frames before the one that is asked for.
class Rounds {
  public:
    explicit Rounds(Demo& demo) : demo_(demo) {}
    void draw() {
        if (demo_.memory()) number_ = 0;
        for (Knob* knob : demo_.knobs()) {
            const std::string before = knob->text();
            for (const std::string& end : knob->sweep()) {
                knob->parse(affordable(knob->name(), end));
                try {
                    drawNext();
                } catch (const Error&) {  // refused by check(), which other tests look at
                }
            }
            knob->parse(before);
        }
        drawNext(true);
        // The past of a demo with a memory is kept, a bounded number of frames of it (Timeline's own test).
        stage().timeline().beginAnew();
        stage().draw(1);
        glFinish();
    }
    int frames() const { return frames_; }

  private:
    void drawNext(bool readouts = false) {
        ++frames_;
        stage().draw(++number_, readouts);
    }
    Demo& demo_;
    int frames_ = 0, number_ = 0;
};

// Two rounds fill whatever is kept. After them none ends with more GL objects (there are fewer where a frame has fewer words). Nor is there
// more memory after one than before it, but for a vector's reserve, which doubles where a frame has the longest line yet: so in the median
// round, at most 8 bytes a frame, where the smallest thing that is forgotten in each is of 24. In ./test --long.
TEST_P(Visits, memory_stays) {
    if (!isLong()) return;
    const int frames = 5000;
    // A picture that the processor computes is small here: how much is kept does not grow from frame to frame with its size.
    const int by = hasPasses(findDemo(GetParam())) ? 4 : 1;
    DemoRun run(GetParam(), 64 / by, 48 / by);
    // The words that drawText keeps of its last sixteen calls: a demo with fewer different words, of which one changes with the frame,
    // would fill it over many rounds. These are longer than a demo's.
    for (int i = 0; i < 16; ++i) {
        drawText(FrameInfo(1, 64, 48), std::vector<TextLine>(20, {0, 0, std::to_string(i) + std::string(100, 'x')}));
    }
    Rounds rounds(run.demo());
    rounds.draw();
    rounds.draw();
    const long objects = liveObjects();
    std::vector<double> grown;  // in each round, bytes a frame
    do {
        const int begun = rounds.frames();
        const std::size_t bytes = liveBytes();
        rounds.draw();
        grown.push_back((double(liveBytes()) - double(bytes)) / (rounds.frames() - begun));
        EXPECT_LE(liveObjects(), objects) << "at frame " << rounds.frames();
        EXPECT_LE(labelledObjects(), static_cast<std::size_t>(liveObjects())) << "labels of what is gone are kept";
    } while (rounds.frames() < frames);
    std::printf("%s: %d frames\n", GetParam().c_str(), rounds.frames());
    std::ranges::sort(grown);
    EXPECT_LE(grown[grown.size() / 2], 8);
}

}  // namespace
}  // namespace mv::test
