// Texts that a program declares between quotes: a demo's name, a knob's sentence. Literals stand in the program
// already, so that declaring them makes no copy: on a page of the browser, which loads all demos, copies are a tenth of
// the module.
#pragma once
#include <concepts>
#include <iosfwd>
#include <string>
#include <string_view>

namespace mv {

// One such text. The compiler makes it and refuses any other, so whoever keeps it need not ask how long it lives.
class Literal {
  public:
    constexpr Literal() = default;  // no text
    consteval Literal(const char* text) : text_(text) {}

    constexpr operator std::string_view() const { return text_; }
    operator std::string() const { return text_; }
    constexpr const char* c_str() const { return text_; }
    constexpr bool empty() const { return *text_ == '\0'; }

    friend constexpr bool operator==(Literal a, const std::convertible_to<std::string_view> auto& b) {
        return std::string_view(a) == std::string_view(b);
    }
    friend std::string operator+(std::string before, Literal text) { return before += text.text_; }
    friend std::string operator+(const char* before, Literal text) { return std::string(before) += text.text_; }
    friend std::string operator+(Literal text, std::string_view after) { return std::string(text) += after; }
    template <class Traits>
    friend std::basic_ostream<char, Traits>& operator<<(std::basic_ostream<char, Traits>& out, Literal text) {
        return out << text.text_;
    }

  private:
    const char* text_ = "";
};

}  // namespace mv
