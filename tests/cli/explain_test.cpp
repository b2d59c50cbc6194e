#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "rules/catalogue.h"
#include "tests/cli/run_gabarit.h"

namespace gabarit {
namespace {

using testing::HasSubstr;

TEST(explain_command, explains_everything_that_its_list_names) {
  const Ending list = run_gabarit({"explain"});
  EXPECT_EQ(list.exit, 0);
  EXPECT_EQ(list.err, "");
  const Catalogue catalogue;
  std::vector<std::string> names = catalogue.measure_names();
  for (const std::string& name : catalogue.selector_names()) names.push_back(name);
  EXPECT_GE(names.size(), 5U);
  for (const std::string& name : names) {
    EXPECT_THAT(list.out, HasSubstr("\n  " + name + "\n"));
    const Ending one = run_gabarit({"explain", name});
    EXPECT_EQ(one.exit, 0);
    EXPECT_THAT(one.out, HasSubstr("Parameters"));
    EXPECT_THAT(one.out, HasSubstr("Example"));
  }
}

TEST(explain_command, an_unknown_name_gets_the_nearest_one) {
  const Ending run = run_gabarit({"explain", "contct"});
  EXPECT_EQ(run.exit, 2);
  EXPECT_EQ(run.out, "");
  EXPECT_THAT(run.err, HasSubstr("nothing is called `contct`\ndid you mean `contact`?"));
}

TEST(explain_command, the_schema_is_json) {
  const Ending run = run_gabarit({"explain", "--schema"});
  EXPECT_EQ(run.exit, 0);
  EXPECT_TRUE(nlohmann::json::parse(run.out).contains("properties"));
}

TEST(devices_command, names_the_processor) {
  const Ending run = run_gabarit({"devices"});
  EXPECT_EQ(run.exit, 0);
  EXPECT_THAT(run.out, HasSubstr("cpu     "));
}

}  // namespace
}  // namespace gabarit
