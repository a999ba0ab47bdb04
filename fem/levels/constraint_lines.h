// Constrained unknowns of a mesh level, each a weighted sum of free ones: hanging nodes, the driven plane,
// the fixed one. C of the condensed stiffness C^T K C.
//
// A third of a graded mesh's nodes hang. Their three components have the same weights, so that such nodes are
// lines of nodes; they are kept by constrained and by free node, and threads share either without adding to
// the same. The few other lines are of unknowns.
#pragma once

#include <cstddef>
#include <vector>

namespace asperity::fem {

class ConstraintLines {
 public:
  /// Adds a constrained unknown (local number, component of node number / 3) with no entry yet.
  void add_line(int constrained);
  /// Adds an entry of the last line; returns its number. weight [-].
  int add_entry(int free, double weight);
  void set_weight(int entry, double weight) { weight_[entry] = weight; }

  /// Constrained unknowns, in the order in which they were added.
  const std::vector<int>& constrained() const { return constrained_; }

  /// Some of the lines, by rising number. Refers to those it was made from: the weights of lines that are not
  /// of nodes may change.
  class Part {
   public:
    /// Sets constrained entries from the free ones.
    template <typename Number>
    void distribute(Number* x) const;
    /// Transpose: moves what constrained entries received to the free ones and zeroes them.
    template <typename Number>
    void condense(Number* y) const;

   private:
    friend class ConstraintLines;
    /// Weighted sums of nodes for each of some nodes.
    struct NodeSums {
      struct Entry {
        int node;
        float weight;
      };
      std::vector<int> node, start{0};
      std::vector<Entry> entry;

      NodeSums transposed() const;
      /// Adds the sums of `values` at a place in the list.
      template <typename Number>
      void add(int place, const Number* values, Number (&sum)[3]) const;
    };
    Part(const ConstraintLines& all, const std::vector<int>& lines);

    const ConstraintLines* all_;
    NodeSums hanging_, receiving_;
    std::vector<int> single_;  ///< lines that are not of nodes
  };
  Part part(const std::vector<int>& lines) const { return {*this, lines}; }
  Part all() const;

  /// condense() with squared weights: of a diagonal.
  void condense_diagonal(double* y) const;

 private:
  /// Whether a line and the two after it are the components of one hanging node.
  bool is_of_node(std::size_t line) const;

  std::vector<int> constrained_, start_{0}, free_;
  std::vector<double> weight_;
};

/// Threads are worth waking for some ten microseconds of work.
inline constexpr int nodes_worth_threads = 3000;

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
  const int nodes = static_cast<int>(hanging_.node.size());
#pragma omp parallel for schedule(static) if (nodes > nodes_worth_threads)
  for (int k = 0; k < nodes; ++k) {
    Number sum[3] = {0, 0, 0};
    hanging_.add(k, x, sum);
    for (int c = 0; c < 3; ++c) x[3 * static_cast<std::ptrdiff_t>(hanging_.node[k]) + c] = sum[c];
  }
  for (const int line : single_) {
    Number sum = 0;
    for (int e = all_->start_[line]; e < all_->start_[line + 1]; ++e)
      sum += static_cast<Number>(all_->weight_[e]) * x[all_->free_[e]];
    x[all_->constrained_[line]] = sum;
  }
}

template <typename Number>
void ConstraintLines::Part::condense(Number* y) const {
  for (const int line : single_) {
    Number& value = y[all_->constrained_[line]];
    for (int e = all_->start_[line]; e < all_->start_[line + 1]; ++e)
      y[all_->free_[e]] += static_cast<Number>(all_->weight_[e]) * value;
    value = 0;
  }
  const int nodes = static_cast<int>(hanging_.node.size()),
            masters = static_cast<int>(receiving_.node.size());
#pragma omp parallel if (nodes > nodes_worth_threads)
  {
#pragma omp for schedule(static)
    for (int k = 0; k < masters; ++k) {
      Number* target = y + 3 * static_cast<std::ptrdiff_t>(receiving_.node[k]);
      Number sum[3] = {target[0], target[1], target[2]};
      receiving_.add(k, y, sum);
      for (int c = 0; c < 3; ++c) target[c] = sum[c];
    }
#pragma omp for schedule(static)
    for (int k = 0; k < nodes; ++k)
      for (int c = 0; c < 3; ++c) y[3 * static_cast<std::ptrdiff_t>(hanging_.node[k]) + c] = 0;
  }
}

}  // namespace asperity::fem
