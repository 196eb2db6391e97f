// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstdint>

namespace dioptre {

/// How long it took to ask what rays meet, from timing a few of the queries.
struct QueryTimes {
  std::uint64_t queries = 0;  ///< all that were made
  std::uint64_t timed = 0;    ///< those that were timed
  double timed_seconds = 0;

  /// The estimate for all queries; 0 if none was timed.
  double seconds() const {
    if (timed == 0) return 0;
    return timed_seconds * (static_cast<double>(queries) / static_cast<double>(timed));
  }
  QueryTimes& operator+=(const QueryTimes& b) {
    queries += b.queries, timed += b.timed, timed_seconds += b.timed_seconds;
    return *this;
  }
};

/// Times one query in 61, which costs about a nanosecond per query. A prime number, so that queries
/// that come in a fixed order, as pixels of two lights make them, are all timed alike.
class QueryClock {
 public:
  /// Makes a query and gives its answer.
  template <class Query>
  auto time(Query&& query) {
    if (--until_next_ != 0) return query();
    until_next_ = kEvery;
    ++timed_;
    // What reading the clock takes is measured beside and taken off.
    const Clock::time_point before = Clock::now(), begin = Clock::now();
    const auto answer = query();
    time_ += (Clock::now() - begin) - (begin - before);
    return answer;
  }

  QueryTimes times() const {
    return {timed_ * kEvery + (kEvery - until_next_), timed_,
            std::chrono::duration<double>(time_).count()};
  }

 private:
  using Clock = std::chrono::steady_clock;
  static constexpr std::uint32_t kEvery = 61;

  std::uint32_t until_next_ = kEvery;
  std::uint64_t timed_ = 0;
  Clock::duration time_{};
};

}  // namespace dioptre
