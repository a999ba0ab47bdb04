// LAMMPS and LIGGGHTS read the same table of particles, and scripts that differ by the walls.
#include "engines/many_particles/particle_box.h"
#include "engines/text_number.h"

namespace asperity {
namespace {

constexpr const char* table_file = "particles.data";

std::string row(std::initializer_list<double> values) {
  std::string text;
  for (const double value : values) text += " " + text_number(value);
  return text;
}

std::string table(const MaterialMatrix& matrix, const ParticleBox& box) {
  std::string text = "asperity: particles of a box\n\n" + std::to_string(box.particles.size()) + " atoms\n" +
                     std::to_string(matrix.materials.size()) + " atom types\n\n";
  for (const char* axis : {"x", "y", "z"})
    text += "0 " + text_number(box.edge) + " " + axis + "lo " + axis + "hi\n";
  text += "\nAtoms\n\n";
  for (std::size_t k = 0; k < box.particles.size(); ++k) {
    const BoxParticle& p = box.particles[k];
    text += std::to_string(k + 1) + " " + std::to_string(p.material + 1) +
            row({2 * p.radius, matrix.materials[p.material].density, p.position[0], p.position[1],
                 p.position[2]}) +
            "\n";
  }
  text += "\nVelocities\n\n";
  for (std::size_t k = 0; k < box.particles.size(); ++k) {
    const BoxParticle& p = box.particles[k];
    text += std::to_string(k + 1) + row({p.velocity[0], p.velocity[1], p.velocity[2], 0, 0, 0}) + "\n";
  }
  return text;
}

std::string script(const ParticleBox& box, const std::string& begin, const std::string& contacts,
                   const std::string& walls) {
  return "# asperity: a closed box of particles that cools by its impacts; energy.csv has its energy\n" +
         begin + "read_data " + table_file + "\nneighbor " + text_number(box.edge / 100) +
         " bin\nneigh_modify delay 0 every 1 check yes\ninclude " + contacts + "\n" + walls +
         "fix move all nve/sphere\ntimestep " + text_number(box.time_step) +
         "\ncompute translation all ke\ncompute rotation all erotate/sphere\nvariable time equal step*dt\n"
         "variable translation equal c_translation\nvariable rotation equal c_rotation\n"
         "thermo_style custom step c_translation c_rotation\nthermo " +
         std::to_string(box.every * 10) + "\nthermo_modify lost error\nfix out all print " +
         std::to_string(box.every) +
         " \"${time},${translation},${rotation}\" file energy.csv screen no title "
         "\"time,translation,rotation\"\nrun " +
         std::to_string(box.steps) + "\n";
}

}  // namespace

std::vector<WrittenFile> lammps_box(const MaterialMatrix& matrix, const ParticleBox& box,
                                    const std::string& contacts) {
  std::string walls;
  const std::string wall = std::to_string(matrix.wall() + 1);
  for (std::size_t i = 0; i < matrix.materials.size(); ++i) {
    const std::string type = std::to_string(i + 1);
    walls += "group type_" + type + " type " + type + "\n";
    for (const char* axis : {"x", "y", "z"})
      walls += "fix wall_" + type + "_" + axis + " type_" + type + " wall/gran granular ${on_plane_" + type +
               "_" + wall + "} " + axis + "plane 0 " + text_number(box.edge) + "\n";
  }
  return {
      {"in.box", script(box, "units si\natom_style sphere\nboundary f f f\nnewton off\ncomm_modify vel yes\n",
                        contacts, walls)},
      {table_file, table(matrix, box)}};
}

std::vector<WrittenFile> liggghts_box(const MaterialMatrix& matrix, const ParticleBox& box,
                                      const std::string& contacts) {
  std::string walls;
  for (const char* axis : {"x", "y", "z"})
    for (const bool upper : {false, true})
      walls += std::string("fix wall_") + axis + (upper ? "_upper" : "_lower") +
               " all wall/gran ${on_plane} primitive type " + std::to_string(matrix.wall() + 1) + " " + axis +
               "plane " + (upper ? text_number(box.edge) : "0.0") + "\n";
  return {
      {"in.box",
       script(
           box,
           "hard_particles yes\natom_style granular\nboundary f f f\nnewton off\ncommunicate single vel yes\n"
           "units si\n",
           contacts, walls)},
      {table_file, table(matrix, box)}};
}

}  // namespace asperity
