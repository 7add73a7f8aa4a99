// The tables of fields: every unit has its dimension, every member of an element has one row.
#include "harness/core/fields.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>

namespace {

using namespace cylon::core;

/// Calls visit.operator()<T>() for every element that has a table.
void for_each_element(auto visit) {
  for_each_force(visit);
  for_each_shape<Shape>(visit);
  visit.template operator()<Part>();
  visit.template operator()<BodyState>();
  visit.template operator()<Body>();
  visit.template operator()<Joint>();
  visit.template operator()<JointDisplacement>();
  visit.template operator()<JointAngle>();
  visit.template operator()<Plane>();
  visit.template operator()<Material>();
  visit.template operator()<Frame>();
}

TEST(Dimension, FollowsFromTheUnit) {
  EXPECT_EQ(dimension(""), Dimension{});
  EXPECT_EQ(dimension("rad/s"), (Dimension{0, 0, -1}));
  EXPECT_EQ(dimension("1/s"), (Dimension{0, 0, -1}));
  EXPECT_EQ(dimension("m/s^2"), (Dimension{0, 1, -2}));
  EXPECT_EQ(dimension("N"), (Dimension{1, 1, -2}));
  EXPECT_EQ(dimension("N/m"), (Dimension{1, 0, -2}));
  EXPECT_EQ(dimension("N m/(rad s^2) kg"), (Dimension{2, 2, -4}));
}

TEST(Dimension, RejectsUnknownUnits) {
  EXPECT_THROW(dimension("lb"), std::invalid_argument);
  EXPECT_THROW(dimension("m^x"), std::invalid_argument);
  EXPECT_THROW(dimension("N or kg/m^3"), std::invalid_argument);
}

TEST(Fields, HaveUnitsWithADimension) {
  int numbers = 0;
  for_each_element([&]<class T>() {
    std::apply(
        [&](const auto&... field) {
          const auto check = [&](const auto& one) {
            if (std::is_same_v<T, Water> && one.key == "buoyancy") return;  // one of two, by `mode`
            EXPECT_NO_THROW(dimension(one.about.unit)) << Element<T>::name << "." << one.key;
            numbers += !one.about.unit.empty();
          };
          (check(field), ...);
        },
        Element<T>::fields);
  });
  EXPECT_GT(numbers, 30);
}

TEST(Fields, HaveOneKeyEach) {
  for_each_element([]<class T>() {
    std::set<std::string_view> keys;
    std::size_t count = 0;
    T element{};
    for_each_field(element, [&](const auto& field, const auto&) {
      ++count, keys.insert(field.key);
      if (!field.about.pin.empty()) ++count, keys.insert(field.about.pin);
      EXPECT_EQ(field.key.data()[field.key.size()], '\0');  // readers use data()
    });
    EXPECT_EQ(keys.size(), count) << Element<T>::name;
  });
}

// Every member has a row: the rows' members do not overlap, and leave no more of the element than padding.
// A flag can hide in the padding; the round trip of scene_json_test.cc finds that one.
TEST(Fields, CoverTheWholeElement) {
  for_each_element([]<class T>() {
    T element{};
    const char* const start = reinterpret_cast<const char*>(&element);
    std::set<std::size_t> covered;
    std::size_t sum = 0;
    for_each_field(element, [&](const auto&, const auto& value) {
      const auto at = static_cast<std::size_t>(reinterpret_cast<const char*>(&value) - start);
      sum += sizeof value;
      for (std::size_t i = 0; i < sizeof value; ++i) covered.insert(at + i);
    });
    EXPECT_EQ(covered.size(), sum) << Element<T>::name << ": two rows for one member";
    std::size_t gap = 0;  // longest run of bytes without a row
    for (std::size_t i = 0, run = 0; i < sizeof(T); ++i) {
      run = covered.contains(i) ? 0 : run + 1;
      gap = std::max(gap, run);
    }
    EXPECT_LT(gap, alignof(T)) << Element<T>::name << ": a member without a row";
  });
}

TEST(Fields, VisitEveryMemberInOrder) {
  const Spring spring{.body = 3, .anchor = {1, 2, 3}, .to = 1, .stiffness = 4.5, .damping = 0.25};
  std::string keys;
  double sum = 0;
  for_each_field(spring, [&](const auto& field, const auto& value) {
    keys += std::string(field.key) + " ";
    if constexpr (std::is_same_v<std::remove_cvref_t<decltype(value)>, double>) sum += value;
  });
  EXPECT_EQ(keys, "body anchor to to_anchor stiffness rest_length damping ");
  EXPECT_EQ(sum, 4.75);
}

}  // namespace
