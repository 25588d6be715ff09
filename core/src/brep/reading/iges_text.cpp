// IGES 5.3: lines of 80 columns, section letter in the 73rd, its line number behind it. An entity has two lines in the
// directory (D), which say where its parameters (P) are; entities point at each other by the number of the first.
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <deque>
#include <initializer_list>
#include <vector>

#include "base/trimmed.h"
#include "brep/reading/texts.h"

namespace paver {
namespace {

constexpr std::size_t section_column = 72, back_pointer_column = 64, field_width = 8;
constexpr std::string_view sections = "SGDPT";
constexpr double largest_number = 1e101;

struct Fault {
  std::string what;
};

struct Entity {
  int type = 0;
  std::vector<std::string_view> words;  ///< the first is the type
};

long integer(std::string_view text) {
  text = trimmed(text, " ");
  if (text.starts_with('+')) text.remove_prefix(1);
  long value = 0;
  auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (text.empty()) return 0;  // a default
  if (error != std::errc() || end != text.data() + text.size()) throw Fault{"a whole number is missing"};
  return value;
}

double real(std::string_view text) {
  std::string number(trimmed(text, " "));
  if (number.empty()) return 0;
  for (char& c : number)
    if (c == 'D' || c == 'd') c = 'e';
  if (number.find_first_not_of("+-.0123456789eE") != std::string::npos) throw Fault{"a number is missing"};
  char* end = nullptr;
  const double value = std::strtod(number.c_str(), &end);
  if (*end != '\0') throw Fault{"a number is missing"};
  if (!(std::abs(value) <= largest_number)) throw Fault{"a number is too large"};
  return value;
}

class Checker {
 public:
  explicit Checker(std::string_view text) : text_(text) {}

  void run() {
    split();
    read_delimiters();
    for (std::size_t d = 0; d + 1 < directory().size(); d += 2) add_entity(d);
    for (current_ = 0; current_ < entities_.size(); ++current_) check(entities_[current_]);
  }
  /// Of the directory, from 1, as messages name it.
  std::size_t current() const { return 2 * current_ + 1; }
  bool has_entities() const { return !entities_.empty(); }

 private:
  const std::vector<std::string_view>& directory() const { return lines_[2]; }
  const std::vector<std::string_view>& parameters() const { return lines_[3]; }

  /// Lines by section, each in its order and with its number.
  void split() {
    std::size_t section = 0;
    while (!text_.empty()) {
      std::string_view line = text_.substr(0, text_.find('\n'));
      text_.remove_prefix(std::min(text_.size(), line.size() + 1));
      if (line.ends_with('\r')) line.remove_suffix(1);
      if (trimmed(line, " ").empty()) continue;
      if (line.size() <= section_column) throw Fault{"a line is too short"};
      const std::size_t found = sections.find(line[section_column]);
      if (found == std::string_view::npos || found < section) throw Fault{"a line has no section"};
      section = found;
      lines_[section].push_back(line);
      if (integer(line.substr(section_column + 1)) != static_cast<long>(lines_[section].size()))
        throw Fault{"lines are out of order"};
    }
    if (directory().size() % 2 != 0) throw Fault{"half an entry of the directory is missing"};
  }

  /// "1H,,1H;," at the start of the second section.
  void read_delimiters() {
    if (lines_[1].empty()) throw Fault{"the global section is missing"};
    std::string_view first = lines_[1].front();
    if (first.starts_with("1H")) {
      delimiter_ = first[2];
      first.remove_prefix(4);
    } else {
      first.remove_prefix(1);
    }
    if (first.starts_with("1H")) terminator_ = first[2];
  }

  std::string_view field(std::size_t line, std::size_t number) const {
    return directory()[line].substr(number * field_width, field_width);
  }

  void add_entity(std::size_t line) {
    Entity entity;
    entity.type = static_cast<int>(integer(field(line, 0)));
    current_ = entities_.size();
    const long first = integer(field(line, 1)), count = std::max(1L, integer(field(line + 1, 3)));
    if (entity.type != 0) {
      if (first < 1 || count > static_cast<long>(parameters().size()) - first + 1)
        throw Fault{"parameters are missing"};
      records_.emplace_back();
      for (long p = first - 1; p < first - 1 + count; ++p) {
        std::string_view one = parameters()[p];
        if (integer(one.substr(back_pointer_column, field_width)) != static_cast<long>(line) + 1)
          throw Fault{"parameters belong to another entity"};
        records_.back() += one.substr(0, back_pointer_column);
      }
      split_words(records_.back(), entity.words);
      if (integer(entity.words.front()) != entity.type) throw Fault{"parameters are of another type"};
    }
    entities_.push_back(std::move(entity));
  }

  void split_words(std::string_view record, std::vector<std::string_view>& words) const {
    for (std::size_t start = 0;;) {
      const std::size_t end = end_of_word(record, start);
      if (end >= record.size()) throw Fault{"parameters end early"};
      words.push_back(record.substr(start, end - start));
      if (record[end] == terminator_) return;
      start = end + 1;
    }
  }

  /// Texts are as "3Habc" and may hold delimiters.
  std::size_t end_of_word(std::string_view record, std::size_t start) const {
    std::size_t at = std::min(record.find_first_not_of(' ', start), record.size());
    const std::size_t digits = std::min(record.find_first_not_of("0123456789", at), record.size());
    if (digits > at && digits < record.size() && record[digits] == 'H')
      at = digits + 1 + static_cast<std::size_t>(integer(record.substr(at, digits - at)));
    while (at < record.size() && record[at] != delimiter_ && record[at] != terminator_) ++at;
    return at;
  }

  // What the reader follows without a look: the lists of splines and what bodies consist of.

  void check(const Entity& entity) const {
    switch (entity.type) {
      case 126:
        return check_curve(entity);
      case 128:
        return check_surface(entity);
      case 102:
        return check_list(entity, 1, 1, 0, {});
      case 142:
        at(entity, 2, {});
        return need(number(entity, 3) != 0 || number(entity, 4) != 0, "a boundary has no curve");
      case 144:
        return check_trimmed(entity);
      case 186:
        at(entity, 1, {514});
        return check_list(entity, 3, 2, 0, {514});
      case 504:
        return check_edges(entity);
      case 508:
        return check_loop(entity);
      case 510:
        at(entity, 1, {});
        return check_list(entity, 2, 1, 1, {508});
      case 514:
        return check_list(entity, 1, 2, 0, {510});
      default:
        for (std::size_t i = 1; i < entity.words.size(); ++i)
          if (entity.type >= 100 && entity.type < 200 && entity.words[i].find('H') == std::string_view::npos)
            real(entity.words[i]);
    }
  }

  static void need(bool is_so, const char* what) {
    if (!is_so) throw Fault{what};
  }
  static std::string_view word(const Entity& entity, std::size_t place) {
    need(place < entity.words.size(), "parameters are missing");
    return entity.words[place];
  }
  static long number(const Entity& entity, std::size_t place) { return integer(word(entity, place)); }

  /// The entity that is pointed at, which is of one of these types where some are named.
  const Entity& at(const Entity& entity, std::size_t place, std::initializer_list<int> types) const {
    const long pointer = number(entity, place);
    need(pointer > 0 && pointer % 2 == 1 && pointer < static_cast<long>(directory().size()), "a pointer leads nowhere");
    const Entity& found = entities_[pointer / 2];
    need(found.type != 0 && (types.size() == 0 || std::count(types.begin(), types.end(), found.type) != 0),
         "a pointer leads to another type");
    return found;
  }

  /// A count at `place` and, `gap` words behind it, so many groups of `width` words, each with a pointer first.
  void check_list(const Entity& entity, std::size_t place, std::size_t width, std::size_t gap,
                  std::initializer_list<int> types) const {
    const long count = number(entity, place);
    need(count >= 0 && count < static_cast<long>(entity.words.size()), "a count is wrong");
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) at(entity, place + 1 + gap + i * width, types);
  }

  void check_trimmed(const Entity& entity) const {
    at(entity, 1, {});
    if (number(entity, 2) != 0) at(entity, 4, {142});
    check_list(entity, 3, 1, 1, {142});
  }

  void check_edges(const Entity& entity) const {
    const long count = number(entity, 1);
    need(count > 0 && count < static_cast<long>(entity.words.size()), "a count is wrong");
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
      at(entity, 2 + 5 * i, {});
      for (std::size_t end : {3 + 5 * i, 5 + 5 * i}) within(number(entity, end + 1), number(at(entity, end, {502}), 1));
    }
  }

  static void within(long index, long count) { need(index >= 1 && index <= count, "a number in a list is wrong"); }

  void check_loop(const Entity& entity) const {
    const long count = number(entity, 1);
    need(count > 0, "a loop has no edges");
    std::size_t place = 2;
    for (long i = 0; i < count; ++i) {
      within(number(entity, place + 2), number(at(entity, place + 1, {502, 504}), 1));
      const long curves = number(entity, place + 4);
      need(curves >= 0, "a count is wrong");
      for (long k = 0; k < curves; ++k) at(entity, place + 6 + 2 * static_cast<std::size_t>(k), {});
      place += 5 + 2 * static_cast<std::size_t>(curves);
    }
  }

  void reals(const Entity& entity, std::size_t first, std::size_t count) const {
    need(count < entity.words.size() && first + count <= entity.words.size(), "parameters are missing");
    for (std::size_t i = first; i < first + count; ++i) real(entity.words[i]);
  }
  void knots(const Entity& entity, std::size_t first, std::size_t count) const {
    reals(entity, first, count);
    for (std::size_t i = first + 1; i < first + count; ++i)
      need(real(entity.words[i - 1]) <= real(entity.words[i]), "knots do not rise");
    need(real(entity.words[first]) < real(entity.words[first + count - 1]), "knots do not rise");
  }
  void weights(const Entity& entity, std::size_t first, std::size_t count) const {
    reals(entity, first, count);
    for (std::size_t i = first; i < first + count; ++i) need(real(entity.words[i]) > 0, "a weight is not positive");
  }
  /// Highest index of the poles, and the degree.
  static std::array<std::size_t, 2> sizes(const Entity& entity, std::size_t index, std::size_t degree) {
    const long k = number(entity, index), m = number(entity, degree);
    need(m >= 1 && m <= 25 && k >= m && k < static_cast<long>(entity.words.size()), "a count is wrong");
    return {static_cast<std::size_t>(k), static_cast<std::size_t>(m)};
  }

  void check_curve(const Entity& entity) const {
    const auto [k, m] = sizes(entity, 1, 2);
    std::size_t place = 7;
    knots(entity, place, k + m + 2);
    weights(entity, place += k + m + 2, k + 1);
    reals(entity, place + k + 1, 3 * (k + 1) + 2);
  }

  void check_surface(const Entity& entity) const {
    const auto [k, m] = sizes(entity, 1, 3);
    const auto [l, n] = sizes(entity, 2, 4);
    std::size_t place = 10, poles = (k + 1) * (l + 1);
    knots(entity, place, k + m + 2);
    knots(entity, place += k + m + 2, l + n + 2);
    weights(entity, place += l + n + 2, poles);
    reals(entity, place + poles, 3 * poles + 4);
  }

  std::string_view text_;
  std::array<std::vector<std::string_view>, sections.size()> lines_;
  char delimiter_ = ',', terminator_ = ';';
  std::deque<std::string> records_;  ///< words look into them
  std::vector<Entity> entities_;
  std::size_t current_ = 0;
};

}  // namespace

std::string fault_of_iges(std::string_view text) {
  Checker checker(text);
  try {
    checker.run();
  } catch (const Fault& fault) {
    return checker.has_entities() ? "D" + std::to_string(checker.current()) + ": " + fault.what : fault.what;
  }
  return {};
}

}  // namespace paver
