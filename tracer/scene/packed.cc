#include "scene/packed.h"

#include <array>
#include <cstdint>

namespace vitrail {

namespace {

constexpr std::uint8_t kNoDigit = 64;

constexpr std::array<std::uint8_t, 256> digit_values() {
  std::array<std::uint8_t, 256> values{};
  values.fill(kNoDigit);
  constexpr char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  for (std::uint8_t i = 0; i < 64; ++i) values[static_cast<std::uint8_t>(digits[i])] = i;
  return values;
}

}  // namespace

std::optional<std::string> bytes_of_base64(const std::string& text) {
  static constexpr std::array<std::uint8_t, 256> kValues = digit_values();
  if (text.size() % 4 != 0) return {};
  std::string bytes;
  bytes.reserve(text.size() / 4 * 3);
  for (std::size_t at = 0; at < text.size(); at += 4) {
    // The last four digits may end in one or two signs of padding.
    const bool is_last = at + 4 == text.size();
    const int padding = is_last && text[at + 3] == '=' ? (text[at + 2] == '=' ? 2 : 1) : 0;
    std::uint32_t group = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      const bool is_padding = i + static_cast<std::size_t>(padding) >= 4;
      const std::uint8_t value = is_padding ? 0 : kValues[static_cast<std::uint8_t>(text[at + i])];
      if (value == kNoDigit) return {};
      group = group << 6 | value;
    }
    for (int i = 0; i < 3 - padding; ++i) bytes += static_cast<char>(group >> (16 - 8 * i) & 0xff);
  }
  return bytes;
}

}  // namespace vitrail
