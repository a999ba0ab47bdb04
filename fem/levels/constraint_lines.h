// Constrained unknowns of a mesh level, each a weighted sum of free ones: hanging nodes, the driven plane,
// the fixed one. C of the condensed stiffness C^T K C.
//
// A third of a graded mesh's nodes hang. Their three components have the same weights, so that such nodes are
// lines of nodes; they are kept by constrained and by free node, and threads share either without adding to
// the same. The few other lines are of unknowns.
#pragma once

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

}  // namespace asperity::fem
