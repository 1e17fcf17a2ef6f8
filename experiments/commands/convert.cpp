#include <fmt/format.h>

#include <filesystem>
#include <memory>

#include "experiments/commands/commands.h"
#include "slam/base/error.h"
#include "slam/io/cloud_io.h"

namespace ariadne::experiments {
namespace {

struct ConvertArguments {
  std::string in;
  std::string out;
  std::string format;
  std::string encoding;
};

void Convert(const ConvertArguments& arguments) {
  const std::filesystem::path out(arguments.out);
  slam::FormatFromPath(out);  // a wrong extension is told before the reading
  const std::optional<slam::CloudEncoding> encoding =
      arguments.encoding.empty() ? std::nullopt : std::optional(slam::EncodingFromName(arguments.encoding));
  const slam::CloudFile file = arguments.format.empty()
                                   ? slam::ReadCloud(arguments.in)
                                   : slam::ReadCloud(arguments.in, slam::FormatFromName(arguments.format));
  slam::WriteCloud(out, file.cloud, encoding);
  fmt::print("{}: {} points{}{}{}\n", arguments.out, file.cloud.size(),
             file.cloud.reflectance.empty() ? "" : ", with reflectance",
             file.cloud.organized() ? fmt::format(", {} slices", file.cloud.slice_begin.size()) : "",
             file.dropped > 0 ? fmt::format("; {} without a measurement were dropped", file.dropped) : "");
}

}  // namespace

void AddConvertCommand(CLI::App& app) {
  CLI::App* command = app.add_subcommand("convert", "Convert a scan from one format to another");
  auto arguments = std::make_shared<ConvertArguments>();
  command->add_option("in", arguments->in, "File to read")->required();
  command->add_option("out", arguments->out, "File to write: .3d, .xyz, .ply, .pcd or .bin")->required();
  command->add_option("--format", arguments->format,
                      "Of IN: uos, xyz, ply, pcd or kitti; without it: by extension");
  command->add_option("--encoding", arguments->encoding,
                      "Of OUT: ascii, binary or binary_compressed (PCD only)");
  command->footer("Example:\n  ariadne convert scan000.3d scan000.ply --encoding ascii");
  command->callback([arguments] { Convert(*arguments); });
}

}  // namespace ariadne::experiments
