#include "surfaces/readers/foreign_kinds.h"

#include "core/error.h"

namespace asperity {
namespace {

struct ForeignKind {
  std::string begins_with;
  std::string name;    ///< as people call the file
  std::string remedy;  ///< what to export from which program
};

const std::vector<ForeignKind>& foreign_kinds() {
  const std::string by_gwyddion = "open it in Gwyddion and export .gsf";
  static const std::vector<ForeignKind> kinds{
      {std::string("\x01\xb0\x93\xff", 4), "an NT-MDT file (.mdt)", by_gwyddion},
      {"VCA DATA", "a file of Bruker's Vision64 or Dektak (.OPDx)",
       "export it from Vision64 as .opd, or " + by_gwyddion},
      {"OLYMPUSRAWFORMAT", "an Olympus file (.oir)",
       "export the heights from the microscope's software as text, or " + by_gwyddion},
      {"KPK0", "a Keyence file (.zon)", "export the heights from the microscope's software as text (.csv)"},
      {":NANONIS_VERSION:", "a Nanonis file (.sxm)", by_gwyddion},
      {"#R3.", "an RHK file (.sm3)", by_gwyddion},
      {"STiMage", "an RHK file (.sm2)", by_gwyddion},
      {"[Paramco32]", "a Createc file (.dat)", by_gwyddion},
      {"[Paramet32]", "a Createc file (.dat)", by_gwyddion},
      {"Wyko ASCII Data File Format", "a Wyko text export (.asc)",
       "pass the .opd, or export x, y, z as text from Vision"},
      {"\x89PNG", "a picture (.png)",
       "it holds colours and no lengths; export the heights, for example as .gsf"},
      {"\xff\xd8\xff", "a picture (.jpg)",
       "it holds colours and no lengths; export the heights, for example as .gsf"},
      {"BM", "a picture (.bmp)", "it holds colours and no lengths; export the heights, for example as .gsf"},
      {"BZh", "packed by bzip2", "unpack it and pass what is inside, or pack it with gzip"},
      {std::string("\xfd"
                   "7zXZ\0",
                   6),
       "packed by xz", "unpack it and pass what is inside, or pack it with gzip"},
      {"7z\xbc\xaf", "a 7-zip archive", "unpack it and pass one of its height maps"}};
  return kinds;
}

}  // namespace

void refuse_foreign_kind(const SourceFile& file) {
  for (const auto& kind : foreign_kinds())
    if (file.bytes.compare(0, kind.begins_with.size(), kind.begins_with) == 0)
      throw InputError(file.name() + " is " + kind.name + ", which is not read; " + kind.remedy);
}

}  // namespace asperity
