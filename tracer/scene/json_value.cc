#include "scene/json_value.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace vitrail {

namespace {

const nlohmann::json kNothing;

template <typename Words>
std::string listed(const Words& words) {
  std::string text;
  for (const char* word : words) text += (text.empty() ? "" : ", ") + std::string(word);
  return text;
}

std::string shown(const nlohmann::json& value) {
  std::string text = value.dump(-1, ' ', true, nlohmann::json::error_handler_t::replace);
  return text.size() <= 60 ? text : text.substr(0, 57) + "...";
}

std::string shown(double value) { return nlohmann::json(value).dump(); }

}  // namespace

bool JsonValue::object(std::initializer_list<const char*> required, std::initializer_list<const char*> optional) const {
  if (!value_->is_object()) {
    fault("is " + shown(*value_) + ", not an object", "write an object with the keys " + listed(required));
    return false;
  }

  // Refuse what is not read, so that a misspelt key cannot be lost.
  for (const auto& item : value_->items()) {
    const auto same = [&](const char* key) { return item.key() == key; };
    if (std::none_of(required.begin(), required.end(), same) && std::none_of(optional.begin(), optional.end(), same))
      faults_->push_back({path_ + "." + item.key(), "is unknown",
                          "the keys here are " + listed(required) + (optional.size() ? ", " : "") + listed(optional)});
  }
  for (const char* key : required)
    if (!value_->contains(key)) faults_->push_back({path_ + "." + key, "is missing", "add it"});
  return true;
}

bool JsonValue::has(const char* key) const { return value_->is_object() && value_->contains(key); }
bool JsonValue::is_object() const { return value_->is_object(); }
bool JsonValue::is_string() const { return value_->is_string(); }
bool JsonValue::is_null() const { return value_->is_null(); }

JsonValue JsonValue::at(const char* key) const {
  const std::string path = path_.empty() ? key : path_ + "." + key;
  if (value_->is_object() && value_->contains(key)) return {(*value_)[key], path, *faults_};

  // A missing key has been noted by object(); what is read from it stays silent.
  static thread_local Faults ignored;
  ignored.clear();
  return {kNothing, path, ignored};
}

std::vector<JsonValue> JsonValue::array(int size) const {
  std::vector<JsonValue> values;
  if (!value_->is_array() || (size >= 0 && value_->size() != static_cast<std::size_t>(size))) {
    fault("is " + shown(*value_), size < 0 ? "write a list" : "write a list of " + std::to_string(size) + " values");
    return values;
  }
  for (std::size_t i = 0; i < value_->size(); ++i)
    values.emplace_back((*value_)[i], path_ + "[" + std::to_string(i) + "]", *faults_);
  return values;
}

double JsonValue::number(Range range) const {
  const double value = value_->is_number() ? value_->get<double>() : std::nan("");
  const bool low_enough = value <= range.high;
  const bool high_enough = range.above_low ? value > range.low : value >= range.low;
  if (std::isfinite(value) && low_enough && high_enough) return value;

  std::string remedy = "write a finite number";
  if (std::isfinite(range.low)) remedy += (range.above_low ? " above " : " not below ") + shown(range.low);
  if (std::isfinite(range.high)) remedy += " and not above " + shown(range.high);
  fault("is " + shown(*value_), remedy);
  return std::isfinite(range.high) ? range.high : 1;
}

std::int64_t JsonValue::integer(std::int64_t low, std::int64_t high) const {
  if (value_->is_number_integer() && !(value_->is_number_unsigned() && value_->get<std::uint64_t>() >> 63)) {
    const auto value = value_->get<std::int64_t>();
    if (low <= value && value <= high) return value;
  }
  fault("is " + shown(*value_), "write a whole number from " + std::to_string(low) + " to " + std::to_string(high));
  return low;
}

std::uint64_t JsonValue::count() const {
  if (value_->is_number_unsigned()) return value_->get<std::uint64_t>();
  fault("is " + shown(*value_), "write a whole number from 0 to 18446744073709551615");
  return 0;
}

bool JsonValue::boolean() const {
  if (value_->is_boolean()) return value_->get<bool>();
  fault("is " + shown(*value_), "write true or false");
  return false;
}

std::string JsonValue::string() const {
  if (value_->is_string()) return value_->get<std::string>();
  fault("is " + shown(*value_), "write a text in quotes");
  return "";
}

std::size_t JsonValue::position_in(const std::vector<const char*>& words) const {
  if (value_->is_string()) {
    const auto found = std::find(words.begin(), words.end(), value_->get_ref<const std::string&>());
    if (found != words.end()) return static_cast<std::size_t>(found - words.begin());
  }
  fault("is " + shown(*value_), "write one of " + listed(words));
  return 0;
}

Vec3 JsonValue::vector() const {
  const std::vector<JsonValue> values = array(3);
  return values.empty() ? Vec3{0, 0, 1} : Vec3{values[0].number(), values[1].number(), values[2].number()};
}

Vec3 JsonValue::unit_vector() const {
  const Vec3 given = vector();
  const double size = length(given);
  if (std::abs(size - 1) <= 1e-9) return given / size;  // decimal digits written and read again keep far more than 9
  fault("has length " + shown(size), "divide it by its length");
  return {0, 0, 1};
}

Rgb JsonValue::colour(Range range) const {
  const std::vector<JsonValue> values = array(3);
  return values.empty() ? Rgb{} : Rgb{values[0].number(range), values[1].number(range), values[2].number(range)};
}

}  // namespace vitrail
