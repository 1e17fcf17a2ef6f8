#pragma once

#include <string>

namespace ariadne {

/// A floor plan of two rooms of 3.5 m x 4 m; stubs of wall tell their ends apart.
inline const std::string kTwoRoomsPlan =
    R"({"walls": [[0, 0, 7, 0], [7, 0, 7, 4], [7, 4, 0, 4], [0, 4, 0, 0], [3.5, 0, 3.5, 1.3],
        [3.5, 2.7, 3.5, 4], [0.8, 4, 0.8, 3.4], [5.8, 0, 5.8, 0.7]],
        "doors": [], "start": [1.5, 2], "spaces": []})";

/// A small mission in it, from rooms.json: few candidates, and no model. `robot` is more of the config.
inline std::string RoomsConfig(int max_scans, const std::string& robot = "") {
  return "experiment: explore\nworld: rooms.json\nmission:\n  area:\n    polygon:\n      slice:\n"
         "        half_thickness: 0.1\n  planner:\n    candidates:\n      count: 60\n    refined: 40\n"
         "  limits:\n    max_scans: " +
         std::to_string(max_scans) + "\ngeometry:\n  plan:\n    thickness: 0.3\nintegrate: false\n" + robot;
}

}  // namespace ariadne
