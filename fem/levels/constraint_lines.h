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
  ConstraintLines() = default;
  ConstraintLines(const ConstraintLines&) = delete;
  ConstraintLines& operator=(const ConstraintLines&) = delete;

  /// Adds a constrained unknown (local number, component of node number / 3) with no entry yet.
  void add_line(int constrained);
  /// Adds an entry of the last line; returns its number. weight [-].
  int add_entry(int free, double weight);
  /// Ends the adding: entries of node lines are kept as all() has them alone. Returns the number that each
  /// entry has from now on; -1: of a node line.
  std::vector<int> finish();

  /// For an entry that is not of a node line. weight [-].
  void set_weight(int entry, double weight) { weight_[entry] = weight; }

  /// Constrained unknowns, in the order in which they were added.
  const std::vector<int>& constrained() const { return constrained_; }

  /// Some of the lines. Refers to those it was made from: the weights of lines that are not of nodes may
  /// change.
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
    const ConstraintLines* all_ = nullptr;
    NodeSums hanging_, receiving_;
    std::vector<int> single_;  ///< lines that are not of nodes
  };
  /// All of them, after finish().
  const Part& all() const { return whole_; }
  /// Those of some nodes, by local node.
  Part of_nodes(const std::vector<char>& wanted) const;

  /// condense() with squared weights: of a diagonal.
  void condense_diagonal(double* y) const;

 private:
  /// Whether a line and the two after it are the components of one hanging node.
  bool is_of_node(std::size_t line) const;

  std::vector<int> constrained_;
  std::vector<int> unknown_;          ///< after finish(): of the lines that are not of nodes
  std::vector<int> start_{0}, free_;  ///< of all lines; after finish() of those that are not of nodes
  std::vector<double> weight_;
  Part whole_;
};

}  // namespace asperity::fem
