#pragma once
/// A JSON value that remembers where it stands, so that every fault can name its path. Private to scene/read*.

#include <cstdint>
#include <initializer_list>
#include <limits>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "base/diagnostic.h"
#include "base/vec3.h"
#include "scene/packed.h"

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

/// Reading never stops at a fault: it is noted, and a harmless value stands in, so that one run finds every fault.
class JsonValue {
 public:
  JsonValue(const nlohmann::json& value, std::string path, Faults& faults)
      : value_(&value), path_(std::move(path)), faults_(&faults) {}

  const std::string& path() const { return path_; }
  void fault(const std::string& what, const std::string& remedy) const { faults_->push_back({path_, what, remedy}); }

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
  /// Numbers packed into one text; none (and noted) where the text is not that.
  template <typename Number>
  std::vector<Number> packed() const {
    std::optional<std::vector<Number>> numbers = unpack<Number>(string());
    if (!numbers) fault("is no text of packed numbers", "write their bytes in base64, lowest first");
    return numbers.value_or(std::vector<Number>{});
  }
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
  Faults* faults_;
};

}  // namespace vitrail
