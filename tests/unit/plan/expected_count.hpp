// The message count of SEMANTICS §3 as EAGERx's expected_inputs() has it, transcribed word for
// word, in exact fractions.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "generator/frontend/read/rational.hpp"
#include "generator/graph/plan/counts.hpp"

namespace eagerx::gen {

struct Connection {
  Rational source_rate, rate, delay_s;
  bool skip = false;
};

/// count(N) as EAGERx's expected_inputs() has it.
inline std::int64_t expected_count(const Connection& c, std::int64_t tick) {
  if (tick == 0) return c.skip ? 0 : 1;
  const Rational r_in = c.source_rate, r = c.rate, d = c.delay_s;
  Rational off = 0;
  // int((r - 1e-9) / r_in): the largest whole number below r / r_in.
  if (c.skip) off = r > r_in ? Rational((r / r_in).ceil() - 1) : Rational(-1);
  const auto cum = [&](const Rational& k) { return ((r_in * k - r * r_in * d) / r).floor(); };
  const Rational n = tick;
  const std::int64_t delta = cum(n + off) - cum(n + off - Rational(1));
  const Rational j = delta - (c.skip ? 1 : 0);
  const Rational t = (r_in * n - r * r_in * d - r * j) / (r * r_in);
  return delta - std::min(delta, std::max<std::int64_t>(0, -(t * r_in).floor()));
}

/// As plan_reception makes them.
inline Counts counts_of(const Connection& c) {
  const Rational ratio = c.source_rate / c.rate;
  return {ratio.num(), ratio.den(), (Rational(ratio.den()) * c.source_rate * c.delay_s).ceil(),
          c.skip};
}

inline Rational parsed(const char* text) {
  return Rational::parse(text).value();
}

/// Rates that divide each other, that do not, and that have decimals.
inline std::vector<Rational> some_rates() {
  std::vector<Rational> rates;
  for (const char* text : {"1", "2", "3", "5", "7", "15", "20", "30", "60", "250", "1000", "0.5",
                           "12.5", "29.97", "30000/1001"}) {
    rates.push_back(parsed(text));
  }
  return rates;
}

/// None, tiny, multiples of periods and others.
inline std::vector<Rational> some_delays(const Rational& source_rate, const Rational& rate) {
  std::vector<Rational> delays = {0,
                                  parsed("1e-9"),
                                  parsed("0.01"),
                                  parsed("0.07"),
                                  parsed("1/3"),
                                  parsed("0.5"),
                                  parsed("2.5")};
  for (const int periods : {1, 2, 4}) {
    delays.push_back(Rational(periods) / source_rate);
    delays.push_back(Rational(periods) / rate);
  }
  return delays;
}

}  // namespace eagerx::gen
