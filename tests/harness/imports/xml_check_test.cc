// What is refused before a library sees it: elements nested without end, which took seconds in the library of a format and
// then ended it by a signal; more bodies than an import takes, which took until the limit of time; and NaN, which MuJoCo
// takes for a number that is not given.
#include "harness/imports/xml_check.h"

#include "harness/core/input_error.h"

#include <gtest/gtest.h>

#include <functional>
#include <string>

namespace cylon::imports {
namespace {

std::string times(std::size_t count, const std::string& text) {
  std::string all;
  for (std::size_t i = 0; i < count; ++i) all += text;
  return all;
}

std::string refusal_of(const std::function<void()>& check) {
  try {
    check();
  } catch (const core::InputError& error) {
    return error.what();
  }
  return "taken";
}

std::string refusal(const std::string& text) {
  return refusal_of([&] { require_small_xml(text, "a.xml", "body"); });
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
       {"<", "<a", "<a b='", "<a b", "<a '", "<!--", "<![CDATA[", "<?", "</", "</a", "<!", "</a></a><a>", ""})
    EXPECT_EQ(refusal(text), "taken") << text;
}

TEST(XmlRoot, IsTheFirstElementAndTheOnlyOne) {
  const XmlFacts facts =
      require_small_xml("<?xml version='1.0'?>\n<!-- <sdf> -->\n  <robot name='a'>\n</robot>\n", "a", "link");
  EXPECT_EQ(facts.root, "robot");
  EXPECT_EQ(facts.line, 3u);
  EXPECT_EQ(facts.column, 3u);
  EXPECT_EQ(refusal("<a/>\n<robot></robot>"),
            "a.xml:2:1: <robot> behind the end of <a>: a file has one root element");
}

TEST(XmlBodies, AreBoundedAndTheFirstBeyondIsTold) {
  const std::string body = "<body><geom/></body>", most = times(most_bodies, body);
  EXPECT_EQ(refusal("<mujoco>" + most + "</mujoco>"), "taken");
  EXPECT_EQ(refusal("<mujoco>" + most + "\n <body name='last'/></mujoco>"),
            "a.xml:2:2: body 'last': more than 20000 elements <body>, which an import takes at most");
  // Of another name, and those of a saved state.
  EXPECT_EQ(refusal("<sdf>" + most + "<link/></sdf>"), "taken");
  EXPECT_EQ(refusal("<sdf>" + most + "<state><body/></state></sdf>"), "taken");
  EXPECT_EQ(require_small_xml("<sdf><plugin><body/></plugin>" + body + "</sdf>", "a", "body").bodies, 1u);
}

TEST(XmlNan, IsRefusedWithItsElement) {
  const auto refused = [](const std::string& text) {
    return refusal_of([&] { require_no_nan(text, "a.xml"); });
  };
  EXPECT_EQ(refused("<mujoco>\n<body name=\"arm\" pos = \"0 NaN 1\"/></mujoco>"),
            "a.xml:2:1: body 'arm': pos=\"0 NaN 1\": NaN is no number");
  EXPECT_EQ(refused("<joint damping='nan'/>"), "a.xml:1:1: <joint>: damping=\"nan\": NaN is no number");
  for (const char* text : {"<body name='nan' childclass='nan'/>", "<geom material='nan' pos='0 inf 1'/>",
                           "<!-- <body pos='nan 0 0'/> -->", "<text data='nan is no number'/>", "<nan/>"})
    EXPECT_EQ(refused(text), "taken") << text;
}

// urdfdom and libsdformat read one of the two, and the mass of the other was lost without a word.
TEST(XmlSecondParts, AreRefusedWithTheirWhole) {
  const auto refused = [](const std::string& text) {
    return refusal_of([&] { require_single(text, "a.urdf"); });
  };
  EXPECT_EQ(
      refused("<robot><link name='arm'><inertial><mass value='1'/></inertial>\n<inertial/></link></robot>"),
      "a.urdf:2:1: link 'arm': a second <inertial>");
  EXPECT_EQ(refused("<joint name='a'><limit lower='0'/><axis xyz='0 0 1'/><limit lower='1'/></joint>"),
            "a.urdf:1:54: joint 'a': a second <limit>");
  EXPECT_EQ(refused("<joint><axis><xyz>1 0 0</xyz><xyz>0 1 0</xyz></axis></joint>"),
            "a.urdf:1:30: <axis>: a second <xyz>");
  EXPECT_EQ(refused("<collision><geometry><box/><sphere/></geometry></collision>"),
            "a.urdf:1:28: <geometry>: a second shape, <sphere>");
  for (const char* text :
       {"<robot><link><inertial/></link><link><inertial/></link></robot>",
        "<visual><geometry><box/><sphere/></geometry></visual>",
        "<link><visual/><visual/><collision/><collision/></link>", "<joint><!-- <limit/> --><limit/></joint>",
        "<gazebo><link><inertial/><inertial/></link></gazebo>",
        "<joint><axis><limit/></axis><axis2><limit/></axis2></joint>"})
    EXPECT_EQ(refused(text), "taken") << text;
}

}  // namespace
}  // namespace cylon::imports
