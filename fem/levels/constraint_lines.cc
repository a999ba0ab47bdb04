#include "fem/levels/constraint_lines.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "core/threads.h"

namespace asperity::fem {
namespace {

// Some microseconds of work.
constexpr int nodes_of_a_part = 1000;

}  // namespace

void ConstraintLines::add_line(int constrained) {
  constrained_.push_back(constrained);
  start_.push_back(start_.back());
}

int ConstraintLines::add_entry(int free, double weight) {
  free_.push_back(free);
  weight_.push_back(weight);
  return start_.back()++;
}

bool ConstraintLines::is_of_node(std::size_t line) const {
  if (line + 2 >= constrained_.size() || constrained_[line] % 3 != 0) return false;
  const int first = start_[line], entries = start_[line + 1] - first;
  if (entries == 0) return false;
  for (int c = 0; c < 3; ++c) {
    if (constrained_[line + c] != constrained_[line] + c ||
        start_[line + c + 1] - start_[line + c] != entries)
      return false;
    for (int e = 0; e < entries; ++e) {
      const double weight = weight_[first + e];
      if (free_[first + e] % 3 != 0 || free_[first + c * entries + e] != free_[first + e] + c ||
          weight_[first + c * entries + e] != weight ||
          static_cast<double>(static_cast<float>(weight)) != weight)
        return false;
    }
  }
  return true;
}

std::vector<int> ConstraintLines::finish() {
  std::vector<int> number_of_entry(free_.size(), -1), start{0}, free;
  std::vector<double> weight;
  Part::NodeSums& hanging = whole_.hanging_;
  for (std::size_t line = 0; line < constrained_.size(); ++line) {
    if (is_of_node(line)) {
      hanging.node.push_back(constrained_[line] / 3);
      for (int e = start_[line]; e < start_[line + 1]; ++e)
        hanging.entry.push_back({free_[e] / 3, static_cast<float>(weight_[e])});
      hanging.start.push_back(static_cast<int>(hanging.entry.size()));
      line += 2;
      continue;
    }
    whole_.single_.push_back(static_cast<int>(unknown_.size()));
    unknown_.push_back(constrained_[line]);
    for (int e = start_[line]; e < start_[line + 1]; ++e) {
      number_of_entry[e] = static_cast<int>(free.size());
      free.push_back(free_[e]);
      weight.push_back(weight_[e]);
    }
    start.push_back(static_cast<int>(free.size()));
  }
  start_ = std::move(start), free_ = std::move(free), weight_ = std::move(weight);
  for (auto* list : {&constrained_, &hanging.node, &hanging.start}) list->shrink_to_fit();
  hanging.entry.shrink_to_fit();
  whole_.receiving_ = hanging.transposed();
  whole_.all_ = this;
  return number_of_entry;
}

ConstraintLines::Part ConstraintLines::of_nodes(const std::vector<char>& wanted) const {
  Part part;
  part.all_ = this;
  const Part::NodeSums& hanging = whole_.hanging_;
  for (std::size_t k = 0; k < hanging.node.size(); ++k) {
    if (!wanted[hanging.node[k]]) continue;
    part.hanging_.node.push_back(hanging.node[k]);
    part.hanging_.entry.insert(part.hanging_.entry.end(), hanging.entry.begin() + hanging.start[k],
                               hanging.entry.begin() + hanging.start[k + 1]);
    part.hanging_.start.push_back(static_cast<int>(part.hanging_.entry.size()));
  }
  for (const int line : whole_.single_)
    if (wanted[unknown_[line] / 3]) part.single_.push_back(line);
  part.receiving_ = part.hanging_.transposed();
  return part;
}

ConstraintLines::Part::NodeSums ConstraintLines::Part::NodeSums::transposed() const {
  struct Whole {
    int free, constrained;
    float weight;
  };
  std::vector<Whole> all;
  for (std::size_t k = 0; k < node.size(); ++k)
    for (int e = start[k]; e < start[k + 1]; ++e) all.push_back({entry[e].node, node[k], entry[e].weight});
  std::stable_sort(all.begin(), all.end(), [](const Whole& a, const Whole& b) { return a.free < b.free; });
  NodeSums sums;
  for (const Whole& one : all) {
    if (sums.node.empty() || sums.node.back() != one.free) {
      sums.node.push_back(one.free);
      sums.start.push_back(sums.start.back());
    }
    sums.entry.push_back({one.constrained, one.weight});
    ++sums.start.back();
  }
  return sums;
}

void ConstraintLines::condense_diagonal(double* y) const {
  for (const int line : whole_.single_) {
    const double value = std::exchange(y[unknown_[line]], 0);
    for (int e = start_[line]; e < start_[line + 1]; ++e) y[free_[e]] += weight_[e] * weight_[e] * value;
  }
  const Part::NodeSums& hanging = whole_.hanging_;
  for (std::size_t k = 0; k < hanging.node.size(); ++k)
    for (int c = 0; c < 3; ++c) {
      const double value = std::exchange(y[3 * static_cast<std::ptrdiff_t>(hanging.node[k]) + c], 0);
      for (int e = hanging.start[k]; e < hanging.start[k + 1]; ++e) {
        const double weight = static_cast<double>(hanging.entry[e].weight);
        y[3 * static_cast<std::ptrdiff_t>(hanging.entry[e].node) + c] += weight * weight * value;
      }
    }
}

template <typename Number>
void ConstraintLines::Part::NodeSums::add(int place, const Number* values, Number (&sum)[3]) const {
  for (int e = start[place]; e < start[place + 1]; ++e) {
    const Number* value = values + 3 * static_cast<std::ptrdiff_t>(entry[e].node);
    const Number weight = entry[e].weight;
    for (int c = 0; c < 3; ++c) sum[c] += weight * value[c];
  }
}

template <typename Number>
void ConstraintLines::Part::distribute(Number* x) const {
  for_parts(static_cast<int>(hanging_.node.size()), nodes_of_a_part, [&](int first, int last) {
    for (int k = first; k < last; ++k) {
      Number sum[3] = {0, 0, 0};
      hanging_.add(k, x, sum);
      for (int c = 0; c < 3; ++c) x[3 * static_cast<std::ptrdiff_t>(hanging_.node[k]) + c] = sum[c];
    }
  });
  for (const int line : single_) {
    Number sum = 0;
    for (int e = all_->start_[line]; e < all_->start_[line + 1]; ++e)
      sum += static_cast<Number>(all_->weight_[e]) * x[all_->free_[e]];
    x[all_->unknown_[line]] = sum;
  }
}

template <typename Number>
void ConstraintLines::Part::condense(Number* y) const {
  for (const int line : single_) {
    Number& value = y[all_->unknown_[line]];
    for (int e = all_->start_[line]; e < all_->start_[line + 1]; ++e)
      y[all_->free_[e]] += static_cast<Number>(all_->weight_[e]) * value;
    value = 0;
  }
  for_parts(static_cast<int>(receiving_.node.size()), nodes_of_a_part, [&](int first, int last) {
    for (int k = first; k < last; ++k) {
      Number* target = y + 3 * static_cast<std::ptrdiff_t>(receiving_.node[k]);
      Number sum[3] = {target[0], target[1], target[2]};
      receiving_.add(k, y, sum);
      for (int c = 0; c < 3; ++c) target[c] = sum[c];
    }
  });
  for_parts(static_cast<int>(hanging_.node.size()), nodes_of_a_part, [&](int first, int last) {
    for (int k = first; k < last; ++k)
      for (int c = 0; c < 3; ++c) y[3 * static_cast<std::ptrdiff_t>(hanging_.node[k]) + c] = 0;
  });
}

template void ConstraintLines::Part::distribute(double*) const;
template void ConstraintLines::Part::distribute(float*) const;
template void ConstraintLines::Part::condense(double*) const;
template void ConstraintLines::Part::condense(float*) const;

}  // namespace asperity::fem
