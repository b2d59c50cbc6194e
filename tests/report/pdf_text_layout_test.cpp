#include <gmock/gmock.h>

#include "report/pdf/text_layout.h"

namespace gabarit::pdf {
namespace {

using testing::Each;
using testing::ElementsAre;
using testing::SizeIs;

class TextLayout : public testing::Test {
 protected:
  double width(const std::string& text) {
    return fonts_.width(body_text.face, text) * body_text.size / points_per_mm;
  }

  Document document_{"", "", ""};
  Fonts fonts_{document_, find_usual_fonts({})};
};

TEST_F(TextLayout, lines_break_at_spaces_and_fit) {
  const double room = width("the quick brown");
  EXPECT_THAT(wrap(fonts_, "the quick brown fox jumps", body_text, room),
              ElementsAre("the quick brown", "fox jumps"));
}

TEST_F(TextLayout, a_word_longer_than_a_line_is_broken) {
  const std::vector<std::string> lines =
      wrap(fonts_, std::string(100, 'W'), body_text, width(std::string(30, 'W')));
  EXPECT_THAT(lines, ElementsAre(std::string(30, 'W'), std::string(30, 'W'), std::string(30, 'W'),
                                 std::string(10, 'W')));
}

TEST_F(TextLayout, every_line_fits_whatever_the_text) {
  const std::string text = "Ünï Ωμέγα " + std::string(300, 'i') + " Привет\n\n日本語の文章は空白がない " +
                           std::string(50, ' ') + "x";
  for (const double room : {4.0, 10.0, 33.0, 170.0}) {
    for (const std::string& line : wrap(fonts_, text, body_text, room))
      EXPECT_LE(width(line), room + 1e-9) << line;
  }
}

TEST_F(TextLayout, no_letter_is_lost) {
  const std::string text = "one two three four five six seven eight nine ten";
  std::string joined;
  for (const std::string& line : wrap(fonts_, text, body_text, 20))
    joined += (joined.empty() ? "" : " ") + line;
  EXPECT_EQ(joined, text);
}

TEST_F(TextLayout, what_does_not_fit_is_cut_off_with_a_sign) {
  const std::vector<std::string> lines =
      wrap(fonts_, "one two three four five six", body_text, width("one two th"), 2);
  EXPECT_THAT(lines, ElementsAre("one two", "three fo…"));
  EXPECT_THAT(wrap(fonts_, "one\ntwo\nthree", body_text, 50, 2), ElementsAre("one", "two…"));
  EXPECT_EQ(fitted(fonts_, "one two", body_text, width("one two")), "one two");
  EXPECT_EQ(fitted(fonts_, "one two", body_text, width("one t…")), "one t…");
}

TEST_F(TextLayout, a_number_shrinks_before_it_loses_digits) {
  const std::string number = "0.0002368 mm";
  EXPECT_EQ(shrunk(fonts_, number, body_text, 100).size, body_text.size);
  const TextStyle style = shrunk(fonts_, number, body_text, 5);
  EXPECT_NEAR(fonts_.width(style.face, number) * style.size / points_per_mm, 5, 1e-9);
}

TEST_F(TextLayout, a_room_too_small_for_a_letter_still_ends) {
  EXPECT_THAT(wrap(fonts_, "WWW", body_text, 0.1), SizeIs(3));
  EXPECT_EQ(fitted(fonts_, "WWW", body_text, 0.1), "…");
}

TEST_F(TextLayout, line_breaks_of_the_text_are_kept) {
  EXPECT_THAT(wrap(fonts_, "a\r\n\n  b", body_text, 50), ElementsAre("a", "", "  b"));
  EXPECT_THAT(wrap(fonts_, "", body_text, 50), ElementsAre(""));
}

}  // namespace
}  // namespace gabarit::pdf
