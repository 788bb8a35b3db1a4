// Put before common/mv/motion/iteration_matrix.cpp. Eigen's sparse LU writes one number, a column's, by a string stream, which
// alone would bring streams and locales into the module, 3 % of it.
#pragma once
#include <sstream>
#include <string>

namespace std {

class NumberAsText {
  public:
    NumberAsText& operator<<(long long number) {
        text_ = to_string(number);
        return *this;
    }
    const string& str() const { return text_; }

  private:
    string text_;
};

}  // namespace std

#define ostringstream NumberAsText
