#pragma once
/// Many numbers as one text of a JSON file: their bytes, lowest first, in base64. No digit is lost, and a million of
/// them are read in a blink.

#include <bit>
#include <cstring>
#include <optional>
#include <string>
#include <vector>

namespace vitrail {

/// The bytes of a text in base64 with its padding; nothing for any other text.
std::optional<std::string> bytes_of_base64(const std::string& text);

/// The numbers of such a text; nothing where it is no base64, or does not hold a whole number of them.
template <typename Number>
std::optional<std::vector<Number>> unpack(const std::string& text) {
  static_assert(std::endian::native == std::endian::little, "bytes are stored lowest first");
  const std::optional<std::string> bytes = bytes_of_base64(text);
  if (!bytes || bytes->size() % sizeof(Number) != 0) return {};
  std::vector<Number> numbers(bytes->size() / sizeof(Number));
  if (!numbers.empty()) std::memcpy(numbers.data(), bytes->data(), bytes->size());
  return numbers;
}

}  // namespace vitrail
