// The instruments whose text is read, one file each. Each fills tables, and what the file says of the bodies.
#pragma once

#include <string>
#include <vector>

#include "diagnosis/import/import.h"
#include "diagnosis/import/instrument_text.h"

namespace asperity {

/// How an instrument's text is known and read.
struct TextFormat {
  const char* name;
  bool (*recognises)(const InstrumentText&);
  /// Tables, title and what the file knows of the bodies; the rest is filled from the options.
  Recording (*read)(const InstrumentText&, const ImportOptions&);
};

const std::vector<TextFormat>& text_formats();

// Hysitron TriboScan: high-load .hld (header, approach, drift and test tables) and its text export.
/// Whether the text is of this kind; reading throws InputError naming file, line and remedy.
bool is_hysitron(const InstrumentText& text);
Recording read_hysitron(const InstrumentText& text, const ImportOptions& options);
// Optics11 Piuma and Chiaro: cantilever with a sphere.
/// Whether the text is of this kind; reading throws InputError as above.
bool is_optics11(const InstrumentText& text);
Recording read_optics11(const InstrumentText& text, const ImportOptions& options);
// Fischer Fischerscope HM2000: blocks of F, h, t with decimal commas.
/// Whether the text is of this kind; reading throws InputError as above.
bool is_fischer(const InstrumentText& text);
Recording read_fischer(const InstrumentText& text, const ImportOptions& options);
// Any table with a header row, by a map of columns.
/// Whether it is such a table; reading throws InputError as above.
bool is_csv(const InstrumentText& text);
Recording read_mapped_csv(const InstrumentText& text, const ImportOptions& options);

/// Adds `values` (in `unit`) as a channel [SI].
void add_channel(RecordingTable& table, const std::string& channel, const std::vector<double>& values,
                 const std::string& unit);

}  // namespace asperity
