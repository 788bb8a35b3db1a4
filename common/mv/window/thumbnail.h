// A picture for Dear ImGui to show.
#pragma once
#include "mv/host/context.h"
#include "mv/image/picture.h"

namespace mv {

// A texture that is no demo's: it stays while demos come and go, so it is made past the table of functions that counts
// what a demo leaves behind.
class Thumbnail {
  public:
    Thumbnail() = default;
    Thumbnail(const Context& context, const Picture& picture);
    ~Thumbnail();
    Thumbnail(Thumbnail&& other) noexcept;
    Thumbnail& operator=(Thumbnail&& other) noexcept;

    int width() const { return width_; }
    int height() const { return height_; }
    void* imguiId() const;

  private:
    using Delete = void (*)(int, const unsigned*);
    unsigned texture_ = 0;
    int width_ = 0, height_ = 0;
    Delete delete_ = nullptr;
};

}  // namespace mv
