#pragma once

#include <string>
#include <vector>

#include "experiments/report/table.h"

namespace ariadne::experiments {

/// A part of a page: pictures, HTML and a table under a heading. Each may be empty.
struct PageSection {
  std::string heading;
  std::vector<std::string> pictures;  // paths relative to the page
  Table table;
  bool folded = false;    // the table only opens when it is asked for
  std::string html = {};  // goes into the page as it is
};

/// What a person opens to see how a run went.
struct Page {
  std::string title;
  std::vector<PageSection> sections;
  std::vector<std::string> files;  // linked at the end, relative to the page
};

/// The page as HTML that needs nothing but the files beside it.
std::string ToHtml(const Page& page);

}  // namespace ariadne::experiments
