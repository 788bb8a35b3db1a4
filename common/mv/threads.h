// Threads that share out work. A page in a browser has none: threads share memory, which a page has only where its host
// sends headers that many hosts cannot.
#pragma once
#include <algorithm>
#include <thread>
#include <utility>
#include <vector>

namespace mv {

// Whether a thread can be started.
constexpr bool haveThreads() {
#if defined(__EMSCRIPTEN__) && !defined(__EMSCRIPTEN_PTHREADS__)
    return false;
#else
    return true;
#endif
}

// How many share a piece of work: as many as are wanted, and of 0 one for each processor; 1 where there are no threads.
inline int sharing(int wanted) {
    if (!haveThreads()) return 1;
    return wanted > 0 ? wanted : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

// The threads are joined at the end, whatever ends it. (std::jthread, which not every standard library has.)
class Helpers {
  public:
    Helpers() = default;
    Helpers(const Helpers&) = delete;
    Helpers& operator=(const Helpers&) = delete;
    ~Helpers() {
        for (std::thread& thread : threads_) thread.join();
    }
    template <class... Work>
    void start(Work&&... work) {
        threads_.emplace_back(std::forward<Work>(work)...);
    }

  private:
    std::vector<std::thread> threads_;
};

}  // namespace mv
