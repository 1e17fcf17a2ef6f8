#pragma once

#include <string>

namespace ariadne {

/// A floor plan of two rooms of 3.5 m x 4 m; stubs of wall tell their ends apart.
inline const std::string kTwoRoomsPlan =
    R"({"walls": [[0, 0, 7, 0], [7, 0, 7, 4], [7, 4, 0, 4], [0, 4, 0, 0], [3.5, 0, 3.5, 1.3],
        [3.5, 2.7, 3.5, 4], [0.8, 4, 0.8, 3.4], [5.8, 0, 5.8, 0.7]],
        "doors": [], "start": [1.5, 2], "spaces": []})";

}  // namespace ariadne
