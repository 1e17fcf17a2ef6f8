// node bundle.mjs BUILD OUT: bundles src/viewer.js with the packages in BUILD/node_modules, and writes it as C++.
import { readFileSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';

const [build, out] = process.argv.slice(2);
const modules = join(build, 'node_modules');
const { buildSync } = createRequire(join(build, 'package.json'))('esbuild');
const licence = readFileSync(join(modules, 'three', 'LICENSE'), 'utf8').replaceAll('©', '(c)');

const result = buildSync({
  entryPoints: [fileURLToPath(new URL('src/viewer.js', import.meta.url))],
  nodePaths: [modules],
  bundle: true,
  minify: true,
  write: false,
  target: 'es2020',
  loader: { '.css': 'text', '.glsl': 'text' },
  legalComments: 'none', // the whole notice stands in the banner
  banner: { js: `/*! three.js\n${licence}*/` },
});
const program = result.outputFiles[0].text;
if (/<\/script|<!--|[^\x00-\x7f]|\)viewer"/i.test(program)) throw new Error('the bundle cannot stand within HTML or C++');

const pieces = program.match(/[^]{1,60000}/g).map((piece) => `    R"viewer(${piece})viewer"sv,\n`);
writeFileSync(out, `// Made by experiments/report/web/bundle.mjs
#include <array>

#include "experiments/report/viewer_bundle.h"

namespace ariadne::experiments {

using namespace std::literals; // lengths that compilers need not count

std::span<const std::string_view> ViewerBundle() {
  static constexpr std::array<std::string_view, ${pieces.length}> kPieces{
${pieces.join('')}  };
  return kPieces;
}

}  // namespace ariadne::experiments
`);
