// Text from a file on its way into a generated program: the one place where it is made harmless, language by
// language. A text enters as a comment or as a literal, never as anything else; numbers go through
// text_number.
#pragma once

#include <string>

namespace asperity {

/// Comments of one language: what begins a line of them, and how a text is written so that it neither ends
/// the line nor means anything. Visible ASCII alone is left, whatever the encoding in which the program is
/// read.
struct CommentStyle {
  const char* sign;
  std::string (*escaped)(const std::string& text);

  /// `sign text`, without the line's end.
  std::string line(const std::string& text) const;
};

/// LAMMPS and LIGGGHTS: '&' at the end and three quotation marks draw the next line into the comment; '$'
/// begins a variable.
extern const CommentStyle lammps_comment;
/// Python: "coding:" or "coding=" in one of the first two lines would choose the encoding of all that
/// follows.
extern const CommentStyle python_comment;
/// C++: a backslash at the end, or its trigraph, draws the next line into the comment.
extern const CommentStyle cplusplus_comment;
/// Lists that a person reads (MUSEN).
extern const CommentStyle plain_comment;

/// 'text' as a string of Python 3, in ASCII; it evaluates to the text (bytes that are no UTF-8 to the
/// characters U+0080 to U+00FF).
std::string python_literal(const std::string& text);

}  // namespace asperity
