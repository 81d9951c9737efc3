#include "renderer/spelling.h"

#include <algorithm>
#include <numeric>
#include <vector>

#include "renderer/screen.h"
#include "renderer/settings.h"

namespace unghost {
namespace {

std::string hyphened(std::string name) {
  std::ranges::replace(name, '_', '-');
  return name;
}

// Levenshtein, one row at a time.
size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), size_t{0});
  for (size_t i = 1; i <= a.size(); ++i) {
    size_t diagonal = row[0];
    row[0] = i;
    for (size_t j = 1; j <= b.size(); ++j) {
      const size_t substituted = diagonal + (a[i - 1] != b[j - 1]);
      diagonal = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, substituted});
    }
  }
  return row.back();
}

} // namespace

#define UNGHOST_ANSWER(column, answer, value) {hyphened(#answer), value},
#define UNGHOST_ANSWERS(Column, LIST)                                                                        \
  template <> std::span<const Answer> answers<Column>() {                                                    \
    static const Answer all[] = {LIST(UNGHOST_ANSWER)};                                                      \
    return all;                                                                                              \
  }
UNGHOST_ANSWERS(Jitter, TAA_JITTER)
UNGHOST_ANSWERS(Dilation, TAA_DILATION)
UNGHOST_ANSWERS(HistoryFilter, TAA_HISTORY)
UNGHOST_ANSWERS(Ringing, TAA_RINGING)
UNGHOST_ANSWERS(Space, TAA_SPACE)
UNGHOST_ANSWERS(Weighting, TAA_WEIGHTING)
UNGHOST_ANSWERS(Rectify, TAA_RECTIFY)
UNGHOST_ANSWERS(Where, TAA_WHERE)
UNGHOST_ANSWERS(Axes, TAA_AXES)
UNGHOST_ANSWERS(Reject, TAA_REJECT)
UNGHOST_ANSWERS(Fill, TAA_FILL)
UNGHOST_ANSWERS(Blend, TAA_BLEND)
UNGHOST_ANSWERS(Input, TAA_INPUT)
UNGHOST_ANSWERS(Keeps, TAA_KEEPS)
UNGHOST_ANSWERS(TextureJitter, TAA_TEXTURE_JITTER)
UNGHOST_ANSWERS(Resolver, TAA_RESOLVER)
UNGHOST_ANSWERS(Store, TAA_STORE)
UNGHOST_ANSWERS(View, UNGHOST_VIEWS)
UNGHOST_ANSWERS(Stage, UNGHOST_STAGES)
UNGHOST_ANSWERS(Arrangement, UNGHOST_ARRANGEMENTS)

std::string joined(std::span<const std::string> words, std::string_view between) {
  std::string text;
  for (const std::string& word : words) {
    if (&word != words.data()) text += between;
    text += word;
  }
  return text;
}

std::string nearest_word(std::string_view word, std::span<const std::string> known) {
  const size_t near = std::max<size_t>(2, word.size() / 3); // further away is another word, not a slip
  std::string best;
  size_t best_distance = near + 1;
  for (const std::string& candidate : known)
    if (const size_t distance = edit_distance(word, candidate); distance < best_distance)
      best = candidate, best_distance = distance;
  return best_distance < word.size() || best_distance == 0 ? best : std::string{};
}

std::string did_you_mean(std::string_view word, std::span<const std::string> known) {
  const std::string nearest = nearest_word(word, known);
  if (!nearest.empty()) return "; did you mean '" + nearest + "'?";
  constexpr size_t most_listed = 12;
  if (known.empty() || known.size() > most_listed) return {};
  return (known.size() == 1 ? "; there is " : "; there are ") + joined(known, ", ");
}

} // namespace unghost
