// Pictures that are made row by row, by several threads.
#pragma once
#include <algorithm>
#include <atomic>
#include <functional>
#include <thread>
#include <vector>

namespace mv {

// Calls `make` once for each row from 0 to rows - 1, each thread taking the next one that nobody has; 0: one thread for each
// processor. `make` throws nothing, and writes nothing that another row reads or writes: then the result does not depend on
// the threads.
inline void inRows(int rows, int threads, const std::function<void(int)>& make) {
    if (threads == 0) threads = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
    std::atomic<int> next = 0;
    const auto work = [&] {
        for (int row = next++; row < rows; row = next++) make(row);
    };
    std::vector<std::jthread> others;  // joined at the end
    for (int i = 1; i < std::min(threads, rows); ++i) others.emplace_back(work);
    work();
}

}  // namespace mv
