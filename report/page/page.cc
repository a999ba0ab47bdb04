#include "report/page/page.h"

#include "report/page/axis.h"

namespace asperity::report {
namespace {

const char* const style = R"css(
:root { --ink: #1c2430; --soft: #5b6675; --line: #d9dee5; --accent: #0b5c8a; --paper: #ffffff;
  --tint: #f4f7fa; }
* { box-sizing: border-box; }
body { margin: 0; background: var(--tint); color: var(--ink);
  font: 16px/1.55 "Source Sans 3", "Segoe UI", "Helvetica Neue", Arial, "Liberation Sans",
    "DejaVu Sans", sans-serif; }
main { max-width: 1160px; margin: 0 auto; background: var(--paper); padding: 40px 52px 64px;
  box-shadow: 0 0 18px rgba(20,40,60,.08); }
h1 { font-size: 2rem; line-height: 1.2; margin: 0 0 4px; letter-spacing: -.01em; }
.subtitle { color: var(--soft); margin: 0 0 26px; }
h2 { font-size: 1.32rem; margin: 44px 0 12px; padding-top: 14px; border-top: 2px solid var(--ink); }
h3 { font-size: 1.04rem; margin: 0 0 8px; }
section > h3 { margin-top: 28px; }
.wrapped { display: inline-block; white-space: normal; min-width: 13em; text-align: left; }
p { margin: 0 0 12px; max-width: 52em; }
.note { color: var(--soft); font-size: .93rem; }
.verdict { border-left: 6px solid var(--accent); background: #eaf3f9; padding: 18px 24px;
  border-radius: 0 6px 6px 0; margin: 22px 0; }
.verdict .headline { font-size: 1.22rem; font-weight: 600; line-height: 1.4; margin: 0 0 8px;
  max-width: none; }
.verdict ul { margin: 0; padding-left: 20px; }
.verdict li { margin: 4px 0; }
.tiles { display: grid; grid-template-columns: repeat(auto-fill, minmax(225px, 1fr)); gap: 12px;
  margin: 20px 0; }
.tile { border: 1px solid var(--line); border-radius: 6px; padding: 12px 16px; }
.tile .value { font-size: 1.42rem; font-weight: 600; font-variant-numeric: tabular-nums; line-height: 1.25; }
.tile .label { font-size: .92rem; }
.tile .small { font-size: .85rem; color: var(--soft); }
.pair { display: grid; grid-template-columns: repeat(auto-fill, minmax(410px, 1fr)); gap: 20px 28px;
  align-items: start; }
figure { margin: 10px 0 22px; break-inside: avoid; }
figure svg { width: 100%; height: auto; display: block; }
figure svg.chart { max-width: 760px; }
figure svg.map { max-width: 560px; }
figcaption { font-size: .93rem; color: #3b4654; margin-top: 6px; max-width: 48em; }
svg text { font-family: inherit; fill: var(--ink); }
svg .tick { font-size: 12.5px; }
svg .label { font-size: 13.5px; font-weight: 600; }
svg .grid { stroke: #e6eaef; stroke-width: 1; }
svg .frame { fill: none; stroke: #59636f; stroke-width: 1; }
svg .legend { fill: rgba(255,255,255,.92); stroke: var(--line); }
svg .band { fill: #dcebd9; fill-opacity: .75; }
.scroll { overflow-x: auto; margin: 12px 0 20px; }
table { border-collapse: collapse; font-size: .92rem; font-variant-numeric: tabular-nums; min-width: 50%; }
td { white-space: nowrap; }
td.text { white-space: normal; min-width: 9em; }
details td { white-space: normal; overflow-wrap: anywhere; }
th { text-align: right; font-weight: 600; border-bottom: 2px solid var(--ink); padding: 6px 10px;
  vertical-align: bottom; }
td { text-align: right; border-bottom: 1px solid var(--line); padding: 5px 10px; vertical-align: top; }
th.text, td.text { text-align: left; }
tr:hover td { background: var(--tint); }
details { border: 1px solid var(--line); border-radius: 6px; padding: 10px 16px; margin: 10px 0; }
summary { cursor: pointer; font-weight: 600; }
.warning { border-left: 6px solid #d55e00; background: #fdf1e8; padding: 12px 20px;
  border-radius: 0 6px 6px 0; margin: 16px 0; }
.warning ul { margin: 4px 0 0; padding-left: 20px; }
footer { margin-top: 44px; padding-top: 12px; border-top: 1px solid var(--line); color: var(--soft);
  font-size: .88rem; }
@media (max-width: 720px) { main { padding: 22px 18px 40px; } .pair { grid-template-columns: 1fr; } }
@media print {
  body { background: white; font-size: 10.5pt; }
  main { box-shadow: none; max-width: none; padding: 0; }
  h2 { break-after: avoid; }
  .pair { grid-template-columns: 1fr 1fr; gap: 12px; }
  .verdict, .tile, .warning, svg .band { -webkit-print-color-adjust: exact; print-color-adjust: exact; }
  tr { break-inside: avoid; }
}
)css";

}  // namespace

std::string table_html(const Table& table) {
  const auto cell = [&](const std::string& tag, const std::string& content, std::size_t column) {
    const bool is_text = column == 0 && table.first_column_is_text;
    return "<" + tag + (is_text ? " class='text'" : "") + ">" + content + "</" + tag + ">";
  };
  std::string html = "<div class='scroll'><table>";
  if (!table.head.empty()) {
    html += "<thead><tr>";
    for (std::size_t i = 0; i < table.head.size(); ++i) html += cell("th", table.head[i], i);
    html += "</tr></thead>";
  }
  html += "<tbody>";
  for (const auto& row : table.rows) {
    html += "<tr>";
    for (std::size_t i = 0; i < row.size(); ++i) html += cell("td", row[i], i);
    html += "</tr>\n";
  }
  return html + "</tbody></table></div>\n";
}

std::string figure_html(const std::string& title, const std::string& picture,
                        const std::string& explanation) {
  return "<figure>" + (title.empty() ? "" : "<h3>" + escaped(title) + "</h3>") + picture + "<figcaption>" +
         explanation + "</figcaption></figure>\n";
}

std::string side_by_side(const std::vector<std::string>& figures) {
  std::string html = "<div class='pair'>";
  for (const auto& figure : figures) html += figure;
  return html + "</div>\n";
}

std::string section_html(const std::string& title, const std::string& body) {
  return "<section><h2>" + escaped(title) + "</h2>\n" + body + "</section>\n";
}

std::string tiles_html(const std::vector<Tile>& tiles) {
  std::string html = "<div class='tiles'>";
  for (const auto& tile : tiles)
    html += "<div class='tile'><div class='value'>" + tile.value + "</div><div class='label'>" + tile.label +
            "</div><div class='small'>" + tile.note + "</div></div>";
  return html + "</div>\n";
}

std::string verdict_html(const std::string& headline, const std::vector<std::string>& sentences) {
  std::string html = "<div class='verdict'><p class='headline'>" + headline + "</p><ul>";
  for (const auto& sentence : sentences) html += "<li>" + sentence + "</li>";
  return html + "</ul></div>\n";
}

std::string details_html(const std::string& summary, const std::string& body) {
  return "<details><summary>" + summary + "</summary>" + body + "</details>\n";
}

std::string paragraph(const std::string& html) { return "<p>" + html + "</p>\n"; }
std::string note(const std::string& html) { return "<p class='note'>" + html + "</p>\n"; }

std::string page_html(const std::string& title, const std::string& subtitle, const std::string& body) {
  return "<!DOCTYPE html>\n<html lang='en'>\n<head>\n<meta charset='utf-8'>\n"
         "<meta name='viewport' content='width=device-width, initial-scale=1'>\n<title>" +
         escaped(title) + "</title>\n<style>" + style + "</style>\n</head>\n<body>\n<main>\n<h1>" +
         escaped(title) + "</h1>\n<p class='subtitle'>" + subtitle + "</p>\n" + body +
         "</main>\n</body>\n</html>\n";
}

}  // namespace asperity::report
