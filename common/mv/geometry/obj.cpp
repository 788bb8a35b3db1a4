#include "mv/geometry/obj.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <glm/geometric.hpp>
#include <map>
#include <tuple>
#include <vector>

#include "mv/error.h"
#include "mv/math/require.h"
#include "mv/math/robust.h"
#include "mv/portable_number.h"

namespace mv {
namespace {

// The words about the picture that are not read, and those that are no mesh.
constexpr std::array<std::string_view, 16> notRead{"o",          "g",         "s",     "mg",       "usemtl",   "mtllib",
                                                   "usemap",     "maplib",    "bevel", "c_interp", "d_interp", "lod",
                                                   "shadow_obj", "trace_obj", "csh",   "call"};
constexpr std::array<std::string_view, 16> curves{"vp",   "cstype", "deg",  "bmat", "step", "curv", "curv2", "surf",
                                                  "parm", "trim",   "hole", "scrv", "sp",   "end",  "con",   "ctech"};

bool isOneOf(std::string_view word, const std::array<std::string_view, 16>& words) {
    return std::ranges::find(words, word) != words.end();
}

bool isSpace(char letter) { return letter == ' ' || letter == '\t' || letter == '\v' || letter == '\f'; }

// Words of a file, line by line.
class Lines {
  public:
    explicit Lines(std::string_view text) : rest_(text) {
        if (rest_.substr(0, 3) == "\xEF\xBB\xBF") rest_.remove_prefix(3);
    }

    // The next line that has words; false at the end.
    bool next() {
        words_.clear();
        while (words_.empty()) {
            if (rest_.empty()) return false;
            number_ = after_;
            while (addLine()) {
            }
        }
        return true;
    }
    const std::vector<std::string_view>& words() const { return words_; }
    std::size_t number() const { return number_; }  // that of the line's beginning, from 1

  private:
    // The words of one line of the text; true where the next one continues it.
    bool addLine() {
        if (rest_.empty()) return false;
        const std::size_t end = std::min(rest_.find_first_of("\r\n"), rest_.size());
        std::string_view line = rest_.substr(0, end);
        const bool isCrLf = rest_.substr(end, 2) == "\r\n";
        rest_.remove_prefix(std::min(rest_.size(), end + (isCrLf ? 2 : 1)));
        ++after_;
        line = line.substr(0, line.find('#'));
        while (!line.empty() && isSpace(line.back())) line.remove_suffix(1);
        const bool continues = !line.empty() && line.back() == '\\';
        if (continues) line.remove_suffix(1);
        while (!line.empty()) {
            const auto length = static_cast<std::size_t>(std::ranges::find_if(line, isSpace) - line.begin());
            if (length > 0) words_.push_back(line.substr(0, length));
            line.remove_prefix(std::min(line.size(), length + 1));
        }
        return continues;
    }

    std::string_view rest_;
    std::vector<std::string_view> words_;
    std::size_t number_ = 0, after_ = 1;
};

class Reader {
  public:
    Reader(std::string_view text, const std::string& name) : name_(name), lines_(text) {}

    ObjMesh read() {
        while (lines_.next()) readLine();
        if (result_.mesh.indices.empty()) throw Error(name_, "the file must have faces");
        checkIndices();
        build();
        return std::move(result_);
    }

  private:
    // Places in the lists, -1 for what a corner has not, and the face, where it is to have that one's normal.
    struct Corner {
        std::int64_t position = -1, texCoord = -1, normal = -1, face = -1;
        auto operator<=>(const Corner&) const = default;  // NOLINT(modernize-use-nullptr)
    };
    struct Face {
        std::size_t first, count, line;
    };

    [[noreturn]] void refuse(std::size_t line, std::string_view rule, std::string_view value) const {
        throw Error(name_ + ":" + std::to_string(line), rule, shown(value));
    }
    // Names may have any bytes, and a terminal is to see none of them.
    static std::string shown(std::string_view word) {
        std::string text;
        for (const char letter : word.substr(0, 40)) text += letter >= ' ' && letter <= '~' ? letter : '?';
        return word.size() > 40 ? text + "..." : text;
    }

    void readLine() {
        const auto& words = lines_.words();
        const std::string_view what = words[0];
        if (what == "v") {
            positions_.push_back(numbers(3, 3));
        } else if (what == "vt") {
            texCoords_.emplace_back(numbers(1, 2));
        } else if (what == "vn") {
            normals_.push_back(numbers(3, 3));
        } else if (what == "f" || what == "fo") {
            readFace();
        } else if (what == "p") {
            result_.leftOut += words.size() - 1;
        } else if (what == "l") {
            ++result_.leftOut;
        } else if (isOneOf(what, curves)) {
            refuse(lines_.number(), "curves and surfaces are not read; export the mesh as polygons", what);
        } else if (!isOneOf(what, notRead)) {
            refuse(lines_.number(), "a line must begin with v, vt, vn, f or another statement of OBJ files", what);
        }
    }

    // The numbers after the statement: `most` at most, of which `least` must be there.
    fvec3 numbers(std::size_t least, std::size_t most) const {
        const auto& words = lines_.words();
        if (words.size() - 1 < least) {
            refuse(lines_.number(), words[0] == "vt" ? "vt must have a number" : "v and vn must have three numbers",
                   std::to_string(words.size() - 1) + " of them");
        }
        vec3 read(0);
        for (std::size_t i = 1; i <= std::min(words.size() - 1, most); ++i) {
            std::string_view word = words[i];
            if (word.size() > 1 && word[0] == '+' && word[1] != '-') word.remove_prefix(1);
            double& number = read[static_cast<int>(i - 1)];
            if (!readNumber(word, number) || !fitsFloat(number))
                refuse(lines_.number(), "a number must be finite, with a point, and fit into floats", words[i]);
        }
        return fvec3(read);
    }
    // A number too small for a double is 0.
    static bool readNumber(std::string_view word, double& number) {
        if (portable::readFinite(word, number)) return true;
        const bool looksSmall = word.find("e-") != std::string_view::npos || word.find("E-") != std::string_view::npos;
        if (!looksSmall || word.find_first_not_of("+-.0123456789eE") != std::string_view::npos) return false;
        number = 0;
        return true;
    }

    void readFace() {
        const auto& words = lines_.words();
        if (words.size() < 4)
            refuse(lines_.number(), "a face must have 3 corners or more", std::to_string(words.size() - 1));
        const std::size_t first = corners_.size();
        for (std::size_t i = 1; i < words.size(); ++i) {
            Corner corner = cornerOf(words[i]);
            if (corner.normal < 0) corner.face = static_cast<std::int64_t>(faces_.size());
            corners_.push_back(corner);
        }
        faces_.push_back({first, corners_.size() - first, lines_.number()});
        for (std::size_t i = 2; i < words.size() - 1; ++i) {
            for (const std::size_t k : {first, first + i - 1, first + i})
                result_.mesh.indices.push_back(static_cast<std::uint32_t>(k));
        }
    }

    // "v", "v/vt", "v//vn" or "v/vt/vn".
    Corner cornerOf(std::string_view word) const {
        std::array<std::int64_t, 3> places{-1, -1, -1};
        const std::array<std::size_t, 3> counts{positions_.size(), texCoords_.size(), normals_.size()};
        std::string_view rest = word;
        for (std::size_t i = 0; i < 3; ++i) {
            const std::size_t end = std::min(rest.find('/'), rest.size());
            const std::string_view digits = rest.substr(0, end);
            if (!digits.empty()) places.at(i) = placeOf(digits, counts.at(i), word);
            if (end == rest.size()) {
                rest = {};
                break;
            }
            rest.remove_prefix(end + 1);
        }
        if (!rest.empty() || places[0] < 0) refuse(lines_.number(), "a corner must be v, v/vt, v//vn or v/vt/vn", word);
        return {places[0], places[1], places[2]};
    }
    // From 1, or from the last one so far backwards. Whether the file has it is asked at its end.
    std::int64_t placeOf(std::string_view digits, std::size_t count, std::string_view word) const {
        std::int64_t index = 0;
        const char* end = digits.data() + digits.size();
        const auto [stopped, problem] = std::from_chars(digits.data(), end, index);
        if (problem != std::errc() || stopped != end) refuse(lines_.number(), "an index must be a whole number", word);
        const std::int64_t place = index > 0 ? index - 1 : static_cast<std::int64_t>(count) + index;
        if (index == 0 || place < 0)
            refuse(lines_.number(), "an index must be that of something before: from 1, or from -1 backwards", word);
        return place;
    }

    void checkIndices() const {
        const auto check = [&](std::int64_t place, std::size_t count, std::size_t line, std::string_view what) {
            if (place < static_cast<std::int64_t>(count)) return;
            refuse(line, "an index must be one of the file's " + std::to_string(count) + " " + std::string(what),
                   std::to_string(place + 1));
        };
        for (const Face& face : faces_) {
            for (std::size_t i = face.first; i < face.first + face.count; ++i) {
                check(corners_[i].position, positions_.size(), face.line, "positions (v)");
                check(corners_[i].texCoord, texCoords_.size(), face.line, "texture coordinates (vt)");
                check(corners_[i].normal, normals_.size(), face.line, "normals (vn)");
            }
        }
    }

    // Newell's sum of cross products, from the first corner on.
    fvec3 normalOf(const Face& face) const {
        const auto corner = [&](std::size_t i) {
            return vec3(positions_[static_cast<std::size_t>(corners_[face.first + i].position)]);
        };
        vec3 sum(0);
        for (std::size_t i = 2; i < face.count; ++i)
            sum += glm::cross(corner(i - 1) - corner(0), corner(i) - corner(0));
        return unitOrUp(sum);
    }

    void build() {
        MeshData& mesh = result_.mesh;
        const bool hasTexCoords =
            std::ranges::any_of(corners_, [](const Corner& corner) { return corner.texCoord >= 0; });
        std::map<Corner, std::uint32_t> known;
        std::vector<std::uint32_t> vertexOf(corners_.size());
        for (std::size_t i = 0; i < corners_.size(); ++i) {
            const Corner& corner = corners_[i];
            const auto [at, isNew] = known.try_emplace(corner, static_cast<std::uint32_t>(mesh.positions.size()));
            vertexOf[i] = at->second;
            if (!isNew) continue;
            mesh.positions.push_back(positions_[static_cast<std::size_t>(corner.position)]);
            mesh.normals.push_back(corner.normal >= 0
                                       ? unitOrUp(vec3(normals_[static_cast<std::size_t>(corner.normal)]))
                                       : normalOf(faces_[static_cast<std::size_t>(corner.face)]));
            if (hasTexCoords) {
                mesh.texCoords.push_back(corner.texCoord >= 0 ? texCoords_[static_cast<std::size_t>(corner.texCoord)]
                                                              : fvec2(0));
            }
        }
        for (std::uint32_t& index : mesh.indices) index = vertexOf[index];
    }

    static fvec3 unitOrUp(const vec3& normal) { return normal == vec3(0) ? fvec3(0, 1, 0) : fvec3(unit(normal)); }

    std::string name_;
    Lines lines_;
    std::vector<fvec3> positions_, normals_;
    std::vector<fvec2> texCoords_;
    std::vector<Corner> corners_;
    std::vector<Face> faces_;
    ObjMesh result_;
};

}  // namespace

ObjMesh meshFromObj(std::string_view text, const std::string& name) { return Reader(text, name).read(); }

}  // namespace mv
