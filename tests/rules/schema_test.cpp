#include "rules/schema.h"

#include <regex>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/rules/language.h"

namespace gabarit {
namespace {

using Json = nlohmann::json;

Json schema() { return Json::parse(rules_schema(language::catalogue())); }

TEST(Schema, knows_every_selector_and_measure_with_its_parameters) {
  const Json all = schema();
  const Json& forms = all["$defs"]["where"]["anyOf"];
  ASSERT_EQ(forms.size(), 3 + language::catalogue().selectors.size());
  EXPECT_EQ(forms[4]["required"], Json::array({"height"}));
  EXPECT_TRUE(forms[4]["properties"]["height"]["anyOf"][0]["properties"].contains("from"));
  const Json& radius = all["$defs"]["rule"]["properties"]["require"]["anyOf"][0]["properties"]["radius"];
  EXPECT_EQ(radius["properties"]["method"]["enum"], Json::array({"turning", "sphere placement"}));
  EXPECT_EQ(radius["properties"]["window"]["default"], "2 mm");
  EXPECT_EQ(radius["additionalProperties"], false);
}

TEST(Schema, refers_only_to_definitions_that_it_has) {
  const Json all = schema();
  const std::string text = all.dump();
  const std::regex reference("#/\\$defs/([a-z]+)");
  int count = 0;
  for (std::sregex_iterator it(text.begin(), text.end(), reference), end; it != end; ++it, ++count) {
    EXPECT_TRUE(all["$defs"].contains((*it)[1].str())) << (*it)[1];
  }
  EXPECT_GT(count, 5);
}

TEST(Schema, accepts_the_quantities_that_the_reader_accepts) {
  const std::regex length(schema()["$defs"]["length"]["pattern"].get<std::string>());
  for (const char* text : {"4 mm", "0.5mm", "-2 cm", "+.5 in", "1e-3 m", " 4 mm "}) {
    EXPECT_TRUE(std::regex_search(text, length)) << text;
  }
  for (const char* text : {"4", "mm", "4 deg", "0x10 mm", "nan mm", "4 mm mm"}) {
    EXPECT_FALSE(std::regex_search(text, length)) << text;
  }
}

}  // namespace
}  // namespace gabarit
