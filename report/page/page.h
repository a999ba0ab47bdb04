// The parts a report page is made of: one HTML file that needs nothing from outside, on light paper,
// printable.
#pragma once

#include <string>
#include <vector>

namespace asperity::report {

/// A cell or caption may hold HTML; whoever puts foreign text in escapes it (report/page/axis.h).
struct Table {
  std::vector<std::string> head;
  std::vector<std::vector<std::string>> rows{};
  bool first_column_is_text = true;
};

/// A table as HTML; cells are HTML already.
std::string table_html(const Table& table);
/// `explanation`: what the figure shows, for someone who has not seen one before.
std::string figure_html(const std::string& title, const std::string& picture, const std::string& explanation);
/// Figures side by side where the page is wide enough.
std::string side_by_side(const std::vector<std::string>& figures);
std::string section_html(const std::string& title, const std::string& body);
/// A number in large letters.
struct Tile {
  std::string value, label, note;
};
std::string tiles_html(const std::vector<Tile>& tiles);
std::string verdict_html(const std::string& headline, const std::vector<std::string>& sentences);
std::string details_html(const std::string& summary, const std::string& body);
std::string paragraph(const std::string& html);
std::string note(const std::string& html);

/// The whole page around its body.
std::string page_html(const std::string& title, const std::string& subtitle, const std::string& body);

}  // namespace asperity::report
