// After the JPEG specification (ITU-T T.81): B.1.1 (markers), B.2.2 (frame), B.2.3 (scan), B.2.4 (tables), C (codes).
#include "mv/image/jpeg_check.h"

#include <algorithm>
#include <array>
#include <vector>

#include "mv/error.h"

namespace mv {
namespace {

constexpr unsigned startOfImage = 0xD8;
constexpr unsigned endOfImage = 0xD9;
constexpr unsigned startOfScan = 0xDA;
constexpr unsigned quantisationTables = 0xDB;
constexpr unsigned huffmanTables = 0xC4;
constexpr unsigned progressiveFrame = 0xC2;

class Checker {
  public:
    Checker(std::span<const std::byte> bytes, std::string_view name) : rest_(bytes), name_(name) {}

    void run() {
        if (nextMarker() != startOfImage) refuse("it does not begin as a JPEG file does");
        for (unsigned marker = nextMarker(); marker != endOfImage; marker = nextMarker()) {
            std::span<const std::byte> segment = takeSegment();
            if (marker == quantisationTables) readQuantisation(segment);
            if (marker == huffmanTables) readHuffman(segment);
            if (marker >= 0xC0 && marker <= progressiveFrame) readFrame(segment, marker == progressiveFrame);
            if (marker == startOfScan) {
                readScan(segment);
                skipScanData();
            }
        }
        if (!scanned_) refuse("it holds no picture");
    }

  private:
    struct Component {
        unsigned id;
        unsigned quantisation;
    };
    // Which of the four tables of a kind the file has defined so far.
    using Defined = std::array<bool, 4>;

    [[noreturn]] void refuse(std::string_view reason) const {
        throw Error(name_, "must be an undamaged JPEG file; save or fetch it again", reason);
    }

    unsigned take(std::span<const std::byte>& from) const {
        if (from.empty()) refuse("cut off");
        const auto value = std::to_integer<unsigned>(from.front());
        from = from.subspan(1);
        return value;
    }

    // Bytes between two segments are skipped, as every reader does; a marker may begin with more than one 0xFF.
    unsigned nextMarker() {
        while (take(rest_) != 0xFF) {
        }
        unsigned marker = 0xFF;
        while (marker == 0xFF) marker = take(rest_);
        return marker;
    }

    // What follows a marker: two bytes of length, which count themselves.
    std::span<const std::byte> takeSegment() {
        const unsigned high = take(rest_);
        const std::size_t length = high * 256 + take(rest_);
        if (length < 2) refuse("segment of impossible length");
        if (length - 2 > rest_.size()) refuse("cut off");
        const auto segment = rest_.first(length - 2);
        rest_ = rest_.subspan(length - 2);
        return segment;
    }

    std::span<const std::byte> takeFrom(std::span<const std::byte>& segment, std::size_t length) const {
        if (segment.size() < length) refuse("segment too short for its content");
        const auto part = segment.first(length);
        segment = segment.subspan(length);
        return part;
    }

    unsigned tableNumber(unsigned number) const {
        if (number > 3) refuse("table of a number above 3");
        return number;
    }

    void readQuantisation(std::span<const std::byte> segment) {
        while (!segment.empty()) {
            const unsigned head = take(segment);
            (void)takeFrom(segment, head < 16 ? 64 : 128);
            quantisation_[tableNumber(head % 16)] = true;
        }
    }

    void readHuffman(std::span<const std::byte> segment) {
        while (!segment.empty()) {
            const unsigned head = take(segment);
            // Codes of length n take 1/2^n of all there are; the whole is counted in units of 1/2^16.
            std::size_t codes = 0;
            std::size_t room = std::size_t{1} << 16U;
            for (unsigned length = 1; length <= 16; ++length) {
                const std::size_t count = take(segment);
                const std::size_t taken = count << (16 - length);
                if (taken > room) refuse("Huffman table with more codes than there are");
                room -= taken;
                codes += count;
            }
            if (codes > 256) refuse("Huffman table with more than 256 codes");
            (void)takeFrom(segment, codes);
            if (head > 0x1F) refuse("Huffman table of an unknown kind");
            (head < 16 ? direct_ : alternating_)[tableNumber(head % 16)] = true;
        }
    }

    void readFrame(std::span<const std::byte> segment, bool progressive) {
        if (!components_.empty()) refuse("two pictures in one");
        progressive_ = progressive;
        (void)takeFrom(segment, 5);  // depth, height and width
        for (unsigned left = take(segment); left > 0; --left) {
            const unsigned id = take(segment);
            (void)take(segment);  // how its samples are spread
            components_.push_back({id, tableNumber(take(segment))});
        }
    }

    void readScan(std::span<const std::byte> segment) {
        const unsigned count = take(segment);
        const auto used = takeFrom(segment, std::size_t{2} * count);
        const bool direct = take(segment) == 0;  // the first frequency in the scan; 0 is the mean of a block
        const bool alternating = !progressive_ || !direct;
        for (std::size_t i = 0; i < used.size(); i += 2) {
            const auto id = std::to_integer<unsigned>(used[i]);
            const auto tables = std::to_integer<unsigned>(used[i + 1]);
            const auto component = std::find_if(components_.begin(), components_.end(),
                                                [&](const Component& candidate) { return candidate.id == id; });
            if (component == components_.end()) refuse("scan of a component that it does not have");
            if (!quantisation_[component->quantisation] || (direct && !direct_[tableNumber(tables / 16)]) ||
                (alternating && !alternating_[tableNumber(tables % 16)])) {
                refuse("scan with a table that it does not define");
            }
        }
        scanned_ = true;
    }

    // To the next marker. In the data 0xFF is followed by 0, and restart markers 0xD0..0xD7 belong to them.
    void skipScanData() {
        for (std::size_t i = 0; i + 1 < rest_.size(); ++i) {
            if (rest_[i] != std::byte{0xFF}) continue;
            const auto next = std::to_integer<unsigned>(rest_[i + 1]);
            if (next == 0 || next == 0xFF || (next >= 0xD0 && next <= 0xD7)) continue;
            rest_ = rest_.subspan(i);
            return;
        }
        refuse("cut off");
    }

    std::span<const std::byte> rest_;
    std::string_view name_;
    std::vector<Component> components_;
    Defined quantisation_{};
    Defined direct_{};
    Defined alternating_{};
    bool progressive_ = false;
    bool scanned_ = false;
};

}  // namespace

bool startsAsJpeg(std::span<const std::byte> bytes) {
    return bytes.size() >= 3 && bytes[0] == std::byte{0xFF} && bytes[1] == std::byte{0xD8} &&
           bytes[2] == std::byte{0xFF};
}

void checkJpeg(std::span<const std::byte> bytes, std::string_view name) { Checker(bytes, name).run(); }

}  // namespace mv
