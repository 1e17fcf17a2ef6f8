# Writes the YAML files of FOLDER into a C++ file, so that the program finds its worlds wherever it is run.
file(GLOB files ${FOLDER}/*.yaml)
list(SORT files)
set(entries "")
foreach(file IN LISTS files)
  get_filename_component(name ${file} NAME_WE)
  file(READ ${file} text)
  string(APPEND entries "    {\"${name}\", R\"yaml(${text})yaml\"},\n")
endforeach()
file(CONFIGURE OUTPUT ${OUT} @ONLY CONTENT [=[
#include "drivers/simulated/world_file.h"

namespace ariadne::drivers {

std::span<const BuiltinWorld> BuiltinWorlds() {
  static constexpr BuiltinWorld kWorlds[] = {
@entries@  };
  return kWorlds;
}

}  // namespace ariadne::drivers
]=])
