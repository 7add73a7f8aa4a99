// The decimals of a reference file, so that the certified solution starts from what the file says and not
// from what double makes of it.
#pragma once

#include "reference/certified/model.h"
#include "tests/conformance/accuracy/truth/truth_file.h"

#include <cmath>
#include <map>
#include <string>
#include <vector>

namespace cylon::certified {

/// Looks a double up among the decimal strings of a file.  One with 18 digits or more was rounded there: it
/// is a short decimal times a third, a root, or the sine or cosine of an angle among the parameters or its
/// half, told by agreeing to all its digits; else it gets half a unit of its last digit as radius.  A double
/// that no decimal explains (a product, a rotated anchor) gets four units in its last place.
class ReferenceNumbers {
 public:
  explicit ReferenceNumbers(const nlohmann::json& file) {
    for (const int n : {3, 7, 11}) {
      factors_.push_back(quotient(1, n)), factors_.push_back(root(n));
      factors_.push_back(root(n));
      arb_div_si(factors_.back().get(), factors_.back().get(), n, bits);
    }
    factors_.push_back(root(2));
    collect_angles(file["params"]);
    collect(file);
  }

  Ball operator()(double x) const {
    const double reach = 4 * 0x1p-52 * std::abs(x);
    if (const auto place = decimals_.lower_bound(x - reach);
        place != decimals_.end() && place->first <= x + reach)
      return place->second;
    if (x == std::round(1024 * x) / 1024) return Ball(x);
    if (const auto place = decimals_.lower_bound(-x - reach);
        place != decimals_.end() && place->first <= -x + reach) {
      Ball result = place->second;
      arb_neg(result.get(), result.get());
      return result;
    }
    Ball result(x);
    result.widen(reach + 4 * 0x1p-52);
    return result;
  }

 private:
  static constexpr slong bits = 320;

  static Ball quotient(int a, int b) {
    Ball x(a);
    arb_div_si(x.get(), x.get(), b, bits);
    return x;
  }
  static Ball root(int n) {
    Ball x;
    arb_sqrt_ui(x.get(), static_cast<ulong>(n), bits);
    return x;
  }

  void collect_angles(const nlohmann::json& j) {
    if (j.is_structured())
      for (const auto& [key, value] : j.items()) collect_angles(value);
    if (!j.is_string() || !is_number(j.get<std::string>())) return;
    for (const int part : {180, 360}) {
      Ball angle(j.get<std::string>(), bits), s, c;
      arb_div_si(angle.get(), angle.get(), part, bits);
      arb_sin_cos_pi(s.get(), c.get(), angle.get(), bits);
      factors_.push_back(s), factors_.push_back(c);
    }
  }

  static bool is_number(const std::string& text) {
    char* end = nullptr;
    std::strtod(text.c_str(), &end);
    return !text.empty() && *end == 0;
  }

  Ball decimal(const std::string& text) const {
    Ball result(text, bits);
    const auto end = text.find_first_of("eE");
    const std::string digits = text.substr(0, end);
    if (digits.size() < 18) return result;
    const auto point = digits.find('.');
    const auto after = point == std::string::npos ? 0 : digits.size() - point - 1;
    const double exponent = end == std::string::npos ? 0 : std::stod(text.substr(end + 1));
    result.widen(0.5000001 * std::pow(10.0, exponent - static_cast<double>(after)));
    for (const Ball& factor : factors_) {
      constexpr double unit = 1e-6;  // of a short decimal
      const double times = std::round(result.middle() / factor.middle() / unit);
      if (!(std::abs(times) < 1e9) || times == 0) continue;
      Ball exact(times);
      arb_mul(exact.get(), exact.get(), factor.get(), bits);
      arb_div_si(exact.get(), exact.get(), 1'000'000, bits);
      if (arb_contains(result.get(), exact.get())) return exact;
    }
    return result;
  }

  void collect(const nlohmann::json& j) {
    if (j.is_string() && is_number(j.get<std::string>()))
      decimals_.emplace(std::stod(j.get<std::string>()), decimal(j.get<std::string>()));
    if (j.is_structured())
      for (const auto& [key, value] : j.items())
        if (key != "trajectory" && key != "system" && key != "t" && key != "conditioning") collect(value);
  }

  std::vector<Ball> factors_;
  std::map<double, Ball> decimals_;
};

}  // namespace cylon::certified
