// JSON as text, written in the order of the calls. Readers of JSON use a library; a page in a browser only writes it,
// and would load the library for that.
#pragma once
#include <concepts>
#include <string>
#include <string_view>
#include <vector>

namespace mv {

// A text, in UTF-8, in quotation marks, with what JSON does not allow in them escaped.
std::string jsonQuoted(std::string_view text);

// Two spaces for each level, a line for each member, as nlohmann::json::dump(2) has it.
class JsonText {
  public:
    // Begins an object or an array: the whole, an array's next one, or the member `name` of an object. end() ends what was begun last.
    JsonText& object(std::string_view name = {}) { return begin('{', name); }
    JsonText& array(std::string_view name = {}) { return begin('[', name); }
    JsonText& end();

    // The member `name` of an object, or an array's next one where there is no name. A number that JSON does not know is null.
    JsonText& add(std::string_view name, std::string_view text) { return value(name, jsonQuoted(text)); }
    JsonText& add(std::string_view name, const char* text) { return add(name, std::string_view(text)); }
    JsonText& add(std::string_view name, double number);
    JsonText& add(std::string_view name, std::integral auto one) {
        if constexpr (std::same_as<decltype(one), bool>) return value(name, one ? "true" : "false");
        return value(name, std::to_string(one));
    }
    JsonText& addNull(std::string_view name) { return value(name, "null"); }
    template <class T>
    JsonText& addAll(std::string_view name, const std::vector<T>& items) {
        array(name);
        for (const T& item : items) add({}, item);
        return end();
    }

    // The text, once all is ended.
    const std::string& text() const { return text_; }

  private:
    JsonText& begin(char bracket, std::string_view name);
    JsonText& value(std::string_view name, std::string_view text);

    std::string text_;
    std::string open_;  // what closes each level that was begun
    bool isEmpty_ = true;
};

}  // namespace mv
