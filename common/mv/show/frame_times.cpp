#include "mv/show/frame_times.h"

#include <chrono>
#include <cmath>
#include <vector>

#include "mv/show/median.h"
#include "mv/show/stage.h"

namespace mv {

FrameTimes timeFrames(Stage& stage, int index, int runs, double firstMs) {
    std::vector<double> times;
    for (int i = 0; i < runs; ++i) {
        const auto start = std::chrono::steady_clock::now();
        stage.draw(index);
        glFinish();
        times.push_back(std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count());
    }
    FrameTimes result{firstMs, median(times), 0, runs};
    for (double& time : times) time = std::abs(time - result.medianMs);
    result.madMs = median(times);
    return result;
}

}  // namespace mv
