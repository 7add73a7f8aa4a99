// Elements nested without end, which took seconds in the library of a format and then ended it by a signal.
#include "harness/imports/xml_depth.h"

#include "harness/core/input_error.h"

#include <gtest/gtest.h>

#include <string>

namespace cylon::imports {
namespace {

std::string times(int count, const std::string& text) {
  std::string all;
  for (int i = 0; i < count; ++i) all += text;
  return all;
}

std::string refusal(const std::string& text) {
  try {
    require_shallow_xml(text, "a.xml");
  } catch (const core::InputError& error) {
    return error.what();
  }
  return "taken";
}

TEST(XmlDepth, IsBoundedAndItsPlaceIsTold) {
  EXPECT_EQ(refusal(times(deepest_xml, "<a>")), "taken");
  const std::string too_deep = "a.xml:2:5: an element nested more than 500 deep";
  EXPECT_EQ(refusal(times(deepest_xml, "<a>") + "\n    <b/>"), too_deep);
  EXPECT_EQ(refusal(times(deepest_xml, "<a b='/>'>") + "\n    <b>"), too_deep);
  EXPECT_EQ(refusal(times(1'000'000, "<a>")), "a.xml:1:1501: an element nested more than 500 deep");
}

TEST(XmlDepth, ElementsBesideEachOtherAndOtherTextDoNotCount) {
  const std::string inner[] = {"<a><b/></a>",  "<a b='>' c=\"/>\"></a>",
                               "<!-- <a> -->", "<![CDATA[<a>]]>",
                               "<?a <a> ?>",   "<!DOCTYPE a>"};
  for (const std::string& text : inner)
    EXPECT_EQ(refusal(times(deepest_xml - 2, "<a>") + times(2000, text)), "taken") << text;
}

TEST(XmlDepth, EndsWithTextThatIsCutOff) {
  for (const char* text :
       {"<", "<a", "<a b='", "<!--", "<![CDATA[", "<?", "</", "</a", "<!", "</a></a><a>", ""})
    EXPECT_EQ(refusal(text), "taken") << text;
}

}  // namespace
}  // namespace cylon::imports
