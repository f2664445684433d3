// Turns dist/ into C++: one source file that carries every file of the viewer, gzipped, inside the robot's program.
//
//   node embed.mjs DIST OUT      writes OUT/viewer_assets.cpp and OUT/assets/0.gz, 1.gz, …
//
// The same input gives the same bytes. The assembler reads the .gz files when viewer_assets.cpp is compiled; each has
// its content's hash in the C++ text, so a build system that watches the source file notices every change.

import { createHash } from "node:crypto";
import { mkdirSync, readdirSync, readFileSync, rmSync, statSync, writeFileSync } from "node:fs";
import { extname, join, resolve, sep } from "node:path";
import { pathToFileURL } from "node:url";
import { gzipSync } from "node:zlib";

const kContentTypes = {
  ".css": "text/css; charset=utf-8",
  ".html": "text/html; charset=utf-8",
  ".ico": "image/x-icon",
  ".js": "text/javascript; charset=utf-8",
  ".json": "application/json",
  ".png": "image/png",
  ".svg": "image/svg+xml",
  ".txt": "text/plain; charset=utf-8",
  ".wasm": "application/wasm",
  ".woff2": "font/woff2",
};

/** All files below `folder`, as paths with `/`, in an order that depends on nothing but the names. */
function filesBelow(folder) {
  return readdirSync(folder, { recursive: true })
    .filter((path) => statSync(join(folder, path)).isFile())
    .map((path) => path.split(sep).join("/"))
    .sort((a, b) => (a < b ? -1 : 1));
}

/** Gzip without anything that depends on when or where it was made. */
function gzip(content) {
  const bytes = gzipSync(content, { level: 9 });
  bytes.writeUInt32LE(0, 4); // modification time: none
  bytes[9] = 255; // operating system: unknown
  return bytes;
}

const quoted = (text) => `"${text.replace(/[\\"]/g, "\\$&")}"`;

/** Writes everything; returns how many bytes were embedded. Throws a sentence. */
export function embed(dist, out) {
  let paths;
  try {
    paths = filesBelow(dist);
  } catch {
    throw new Error(`embed: cannot read the folder '${dist}'; build the viewer first: npm run build`);
  }
  if (!paths.includes("index.html"))
    throw new Error(`embed: '${dist}' has no index.html; build the viewer first: npm run build`);

  const folder = join(resolve(out), "assets");
  rmSync(folder, { recursive: true, force: true });
  mkdirSync(folder, { recursive: true });
  const assets = paths.map((path, index) => {
    const type = kContentTypes[extname(path)];
    if (!type)
      throw new Error(`embed: no content type is known for '${path}'; add its extension to kContentTypes in embed.mjs`);
    const content = readFileSync(join(dist, path));
    const bytes = gzip(content);
    const file = join(folder, `${index}.gz`);
    writeFileSync(file, bytes);
    const etag = createHash("sha256").update(content).digest("hex").slice(0, 16); // the server adds the quotes
    return { path: `/${path}`, type, file, etag, size: bytes.length, symbol: `foresight_viewer_asset_${index}` };
  });

  writeFileSync(join(resolve(out), "viewer_assets.cpp"), sourceOf(assets));
  return assets.reduce((sum, { size }) => sum + size, 0);
}

function sourceOf(assets) {
  const blob = ({ symbol, file }) =>
    [`.globl ${symbol}`, `.hidden ${symbol}`, `${symbol}:`, `.incbin ${quoted(file)}`]
      .map((line) => `    ${quoted(`${line}\n`).replaceAll("\n", "\\n")}`)
      .join("\n");
  const declaration = ({ symbol }) => `extern "C" __attribute__((visibility("hidden"))) const char ${symbol}[];`;
  const entry = ({ path, type, symbol, size, etag }) =>
    `    {${quoted(path)}, ${quoted(type)}, {${symbol}, ${size}}, ${quoted(etag)}},`;

  return `// Made by viewer-web/embed.mjs; not to be edited. The viewer's files, gzipped, sorted by path.
#include "robot/net/http/assets.h"

__asm__(
    ".pushsection .rodata\\n"
${assets.map(blob).join("\n")}
    ".popsection\\n");

${assets.map(declaration).join("\n")}

namespace robot::net {

const Asset kViewerAssets[] = {
${assets.map(entry).join("\n")}
};
const std::size_t kViewerAssetCount = ${assets.length};

}  // namespace robot::net
`;
}

if (import.meta.url === pathToFileURL(process.argv[1] ?? "").href) {
  const [dist, out, ...more] = process.argv.slice(2);
  if (!dist || !out || more.length > 0) {
    console.error("usage: node embed.mjs DIST OUT");
    process.exit(2);
  }
  try {
    console.log(`embedded ${(embed(dist, out) / 1000).toFixed(1)} kB, gzipped`);
  } catch (error) {
    console.error(error.message);
    process.exit(2);
  }
}
