// The decimals of a reference file, so that the certified solution starts from what the file says and not
// from what double makes of it.
#pragma once

#include "reference/certified/model.h"
#include "tests/accuracy/truth/truth_file.h"

#include <cmath>
#include <map>
#include <string>

namespace cylon::certified {

/// Looks a double up among the decimal strings of a file.  One with 18 digits or more stands for a number
/// that was rounded there, and gets half a unit of its last digit as radius.  A double that no decimal
/// explains (a product, a rotated anchor) gets four units in its last place.
class ReferenceNumbers {
 public:
  explicit ReferenceNumbers(const nlohmann::json& file) { collect(file); }

  Ball operator()(double x) const {
    const double reach = 4 * 0x1p-52 * std::abs(x);
    const auto place = decimals_.lower_bound(x - reach);
    if (place != decimals_.end() && place->first <= x + reach) return place->second;
    if (x == 0 || (std::abs(x) < 1e6 && x == std::round(1024 * x) / 1024)) return Ball(x);
    const auto minus = decimals_.lower_bound(-x - reach);
    Ball result(x);
    if (minus != decimals_.end() && minus->first <= -x + reach) {
      result = minus->second;
      arb_neg(result.get(), result.get());
      return result;
    }
    result.widen(reach + 4 * 0x1p-52);
    return result;
  }

 private:
  static Ball decimal(const std::string& text) {
    Ball result(text, 256);
    const auto end = text.find_first_of("eE");
    std::string digits = text.substr(0, end), unit;
    if (digits.size() < 18) return result;
    const auto point = digits.find('.');
    const auto after = point == std::string::npos ? 0 : digits.size() - point - 1;
    const double exponent = end == std::string::npos ? 0 : std::stod(text.substr(end + 1));
    result.widen(0.5000001 * std::pow(10.0, exponent - static_cast<double>(after)));
    return result;
  }
  void collect(const nlohmann::json& j) {
    if (j.is_string()) {
      const auto& text = j.get_ref<const std::string&>();
      char* end = nullptr;
      const double x = std::strtod(text.c_str(), &end);
      if (!text.empty() && *end == 0) decimals_.emplace(x, decimal(text));
    }
    if (j.is_structured())
      for (const auto& [key, value] : j.items())
        if (key != "trajectory" && key != "system" && key != "t" && key != "conditioning") collect(value);
  }

  std::map<double, Ball> decimals_;
};

}  // namespace cylon::certified
