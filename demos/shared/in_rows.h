// Pictures that are made row by row, by several threads.
#pragma once
#include <algorithm>
#include <atomic>
#include <functional>

#include "mv/threads.h"

namespace mv {

// Calls `make` once for each row from 0 to rows - 1, each thread taking the next one that nobody has; 0: one thread for each
// processor. `make` throws nothing, and writes nothing that another row reads or writes: then the result does not depend on
// the threads.
inline void inRows(int rows, int threads, const std::function<void(int)>& make) {
    std::atomic<int> next = 0;
    const auto work = [&] {
        for (int row = next++; row < rows; row = next++) make(row);
    };
    Helpers others;
    for (int i = 1; i < std::min(sharing(threads), rows); ++i) others.start(work);
    work();
}

}  // namespace mv
