#pragma once
/// A JSON value that remembers where it stands, so that every fault can name its path. Private to scene/read*.

#include <cstdint>
#include <initializer_list>
#include <limits>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "base/diagnostic.h"
#include "base/vec3.h"

namespace vitrail {

using Faults = std::vector<Diagnostic>;

/// The allowed range of a number, for the check and for its message.
struct Range {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool above_low = false;  // low itself is refused

  static Range any() { return {}; }
  static Range positive() { return {0, std::numeric_limits<double>::infinity(), true}; }
  static Range not_negative() { return {0}; }
  static Range share() { return {0, 1}; }
};

/// A word of the scene file and what it stands for: a value, or the reader of a kind of part.
template <typename Value>
struct Choice {
  const char* word;
  Value value;
};

/// What all values of one file share: where its relative file names begin, and the faults found so far.
struct Reading {
  const std::string& folder;
  Faults& faults;
};

/// Reading never stops at a fault: it is noted, and a harmless value stands in, so that one run finds every fault.
class JsonValue {
 public:
  JsonValue(const nlohmann::json& value, std::string path, Reading reading)
      : value_(&value), path_(std::move(path)), reading_(reading) {}

  const std::string& path() const { return path_; }
  void fault(const std::string& what, const std::string& remedy) const {
    reading_.faults.push_back({path_, what, remedy});
  }

  /// An object that has exactly these keys, the optional ones or not. False (and noted) if it is no object.
  bool object(std::initializer_list<const char*> required, std::initializer_list<const char*> optional = {}) const;
  bool has(const char* key) const;
  JsonValue at(const char* key) const;

  /// An array of `size` values, or of any number with size < 0. Empty if it is no array.
  std::vector<JsonValue> array(int size = -1) const;

  bool is_object() const;
  bool is_string() const;
  bool is_null() const;

  double number(Range range = Range::any()) const;
  std::int64_t integer(std::int64_t low, std::int64_t high) const;
  std::uint64_t count() const;  // any whole number of 64 bits, not negative
  bool boolean() const;
  std::string string() const;
  /// A file name as given if absolute, else beside the file that is read.
  std::string file() const;
  /// What a word stands for in a table of choices; the first where the word is in none.
  template <typename Value, std::size_t count>
  Value choice(const Choice<Value> (&choices)[count]) const {
    std::vector<const char*> words;
    for (const Choice<Value>& one : choices) words.push_back(one.word);
    return choices[position_in(words)].value;
  }

  Vec3 vector() const;
  Vec3 unit_vector() const;  // of length 1 within 1e-9, returned with length 1 to rounding
  Rgb colour(Range range = Range::not_negative()) const;

 private:
  /// The position of this word in a list; 0 (and noted) if it is none of them.
  std::size_t position_in(const std::vector<const char*>& words) const;

  const nlohmann::json* value_;
  std::string path_;
  Reading reading_;
};

}  // namespace vitrail
