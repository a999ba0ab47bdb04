// Text files as a person's programs save them: with or without a byte order mark, in UTF-8, UTF-16 or
// Latin-1, lines ended as Unix, Windows or old Macintosh computers do.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace asperity {

/// The text of bytes that begin with the mark of UTF-16 (Unicode 15, section 2.6), in UTF-8 without the mark.
/// None where there is no mark, half a character, or a control character that is no blank: then it is no
/// text.
std::optional<std::string> text_of_utf16(const std::string& bytes);

/// The same text in UTF-8, without a byte order mark, its lines ended by \n.
std::string plain_text(std::string bytes);

/// The text of a file. Throws InputError naming the file as `read_file` does, and where it is binary.
std::string read_text_file(const std::filesystem::path& path);

}  // namespace asperity
