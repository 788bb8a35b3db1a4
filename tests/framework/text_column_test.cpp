#include "mv/gl/text_column.h"

#include <gtest/gtest.h>

using namespace mv;

TEST(TextColumn, lines_begin_or_end_where_they_are_told_and_go_down) {
    TextColumn column(100, 20, 15);
    column.left(5, "from");
    column.right(80, "to");
    column.next();
    column.left(0, "below");
    column.next(40);
    column.left(0, "far below");
    ASSERT_EQ(column.lines.size(), 4U);
    EXPECT_EQ(column.lines[0].x, 105);
    EXPECT_EQ(column.lines[1].x + textWidth("to", {.height = 15}), 180);
    EXPECT_EQ(column.lines[1].y, 20);
    EXPECT_EQ(column.lines[2].y, 38);  // the text's height and 3 between
    EXPECT_EQ(column.lines[3].y, 78);
    EXPECT_EQ(column.lines[0].style.height, 15);
}

TEST(TextColumn, numbers_of_a_table) {
    EXPECT_EQ(tableNumber(0), "0");
    EXPECT_EQ(tableNumber(-0.0), "0");
    EXPECT_EQ(tableNumber(-3), "-3");
    EXPECT_EQ(tableNumber(0.12345), "0.123");
    EXPECT_EQ(tableNumber(-999.9996), "-1000.000");
    EXPECT_EQ(tableNumber(1e6 + 0.375), "1000000.38");
    EXPECT_EQ(tableNumber(1e8), "100000000");
}
