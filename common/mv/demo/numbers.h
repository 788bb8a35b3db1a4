// The numbers that a lesson tells beside its picture.
#pragma once

namespace mv {

class Demo;

// Takes the values of a lesson's readouts, by name. Whoever leaves one out tells none: these settings do not measure it.
class Numbers {
  public:
    explicit Numbers(Demo& demo) : demo_(demo) {}
    // Error: no readout of that name, or a value that is not finite.
    void set(const char* name, double value);

  private:
    Demo& demo_;
};

}  // namespace mv
