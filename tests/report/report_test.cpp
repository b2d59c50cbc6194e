#include "report/report.h"

#include <cstdlib>

#include <gtest/gtest.h>

#include "tests/report/sample_report.h"

namespace gabarit {
namespace {

TEST(make_report, the_id_follows_what_decides_the_content) {
  SampleReport sample;
  const std::string id = sample.report().id;
  EXPECT_EQ(id.size(), 12U);
  EXPECT_EQ(sample.report().id, id);
  sample.outcome.setups[0].sag = 0.2;
  EXPECT_NE(sample.report().id, id);
  sample.outcome.setups[0].sag = 0.1;
  sample.model.sha256[5] = 'c';
  EXPECT_NE(sample.report().id, id);
}

TEST(make_report, the_date_is_that_of_the_sources_or_none) {
  const SampleReport sample;
  unsetenv("SOURCE_DATE_EPOCH");
  EXPECT_EQ(sample.report().date, "");
  setenv("SOURCE_DATE_EPOCH", "1700000000", 1);
  EXPECT_EQ(sample.report().date, "2023-11-14T22:13:20Z");
  for (const char* const wrong : {"", "yesterday", "12x", "-5", "99999999999999999999", "253402300800"}) {
    setenv("SOURCE_DATE_EPOCH", wrong, 1);
    EXPECT_EQ(sample.report().date, "") << wrong;
  }
  unsetenv("SOURCE_DATE_EPOCH");
}

}  // namespace
}  // namespace gabarit
