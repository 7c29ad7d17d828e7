"""C++ functions are short enough to read, and the finder that says so finds them."""

from __future__ import annotations

from tests.architecture.cpp_functions import Function, functions_of
from tests.architecture.source_tree import ROOT, project_files
from tests.architecture.test_files import LONGEST_FUNCTION

EXAMPLE = """
#include <vector>
#define ODD {
namespace house {  // a brace in a comment: {
struct Door : Wall {
  Door(int width) : width_{width}, text_("{") {
    open();
  }
  bool operator<(const Door& other) const { return width_ < other.width_; }
  int width_ = 0;
};
const int kSizes[] = {1, 2, 3};
template <typename Value>
auto longest(const std::vector<Value>& values, int (*size)(Value)) -> Value {
  const auto by_size = [](Value a) {
    return a;
  };
  return by_size(values[0]);
}
REGISTER(door)->Args({1, 2});
int House::rooms(Door door = {}) const noexcept { return 1; }
}
"""


def test_the_finder_finds_functions_and_nothing_else() -> None:
    assert list(functions_of(EXAMPLE)) == [
        Function("Door", 6, 3),
        Function("operator<", 9, 1),
        Function("longest", 13, 7),
        Function("House::rooms", 21, 1),
    ]


def test_cpp_functions_are_short_enough_to_read() -> None:
    """The limit is that of Python: functions aim at 40 lines, the rest is room for one long signature or switch."""
    long, found = [], 0
    for path in project_files():
        if path.suffix in {".h", ".cc", ".cpp"}:
            for function in functions_of((ROOT / path).read_text(encoding="utf-8")):
                found += 1
                if function.lines > LONGEST_FUNCTION:
                    long.append(f"{path}:{function.line}: {function.name}: {function.lines} lines")
    assert found > 1000, "the finder no longer finds the functions of the tracer"
    assert not long, "split by thing done:\n" + "\n".join(long)
