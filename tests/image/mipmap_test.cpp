#include "mv/image/mipmap.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/random.h"

using namespace mv;
using namespace mv::test;

namespace {

FloatPicture noise(int width, int height, int channels) {
    FloatPicture picture(width, height, channels);
    Random random(51);
    for (float& value : picture.values) value = static_cast<float>(random.number(0, 1));
    return picture;
}

double mean(const FloatPicture& picture, int channel) {
    double sum = 0;
    for (std::size_t i = static_cast<std::size_t>(channel); i < picture.values.size();
         i += static_cast<std::size_t>(picture.channels))
        sum += double(picture.values[i]);
    return sum / picture.width / picture.height;
}

}  // namespace

TEST(Mipmap, mean_is_kept) {
    for (const auto& [width, height] :
         {std::pair{1, 1}, {2, 2}, {3, 3}, {5, 7}, {1, 9}, {13, 1}, {64, 64}, {100, 33}}) {
        const FloatPicture picture = noise(width, height, 3);
        for (const FloatPicture& level : mipmaps(picture)) {
            // Each level rounds each texel once to float: 6e-8 of at most 1, nine levels at most
            for (const int channel : {0, 1, 2}) EXPECT_NEAR(mean(level, channel), mean(picture, channel), 6e-7);
        }
    }
}

TEST(Mipmap, sizes_are_gls) {
    const auto levels = mipmaps(FloatPicture(13, 4, 1));
    ASSERT_EQ(levels.size(), 4U);  // 13x4, 6x2, 3x1, 1x1
    EXPECT_EQ(levels[1].width, 6);
    EXPECT_EQ(levels[1].height, 2);
    EXPECT_EQ(levels[2].width, 3);
    EXPECT_EQ(levels[2].height, 1);
    EXPECT_EQ(levels[3].width * levels[3].height, 1);
    EXPECT_EQ(mipmaps(FloatPicture(1, 1, 4)).size(), 1U);
}

TEST(Mipmap, parts_of_texels_count_as_parts) {
    FloatPicture row(3, 1, 1);
    row.values = {1, 4, 10};
    EXPECT_EQ(halved(row).values, (std::vector<float>{5}));
    FloatPicture five(5, 1, 1);
    five.values = {1, 0, 0, 0, 1};  // each half covers two texels and a half
    EXPECT_EQ(halved(five).values, (std::vector<float>{0.4F, 0.4F}));
    FloatPicture even(4, 2, 1);
    even.values = {1, 3, 0, 0, 5, 7, 0, 8};
    EXPECT_EQ(halved(even).values, (std::vector<float>{4, 2}));
}

TEST(Mipmap, refused) {
    FloatPicture wrong(2, 2, 1);
    wrong.values.pop_back();
    EXPECT_ANY_THROW((void)halved(wrong));
    EXPECT_ANY_THROW((void)mipmaps(wrong));
}
