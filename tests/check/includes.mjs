// The allowed includes between folders. Reads every #include, every link of a CMake target and every import of the viewer.
// Each forbidden one gives one sentence.
//
//   node tests/check/run.mjs includes
import { readFileSync } from "node:fs";
import { join, posix } from "node:path";
import { filesBelow } from "./files.mjs";

/** The folders of all that read recordings. */
const kSessions = [
  "robot/core",
  "robot/memory",
  "robot/logging",
  "robot/logging/mcap",
  "robot/logging/streams",
  "robot/logging/sessions",
];

/**
 * The table. A folder may include itself, the folders below it, and the folders of its row. `everything` is for leaves,
 * which no other folder may include. A folder gets its row in the commit that adds its first file.
 */
export const rows = {
  proto: [],
  "sim/math": [],
  "sim/field": ["sim/math"],
  "sim/world": ["sim/math", "sim/field"],
  "sim/motion": ["sim/math", "sim/field", "sim/world"],
  "sim/agent": ["sim/math", "sim/field", "sim/motion", "sim/world"],
  "sim/perception": ["sim/math", "sim/field", "sim/world", "sim/motion", "sim/agent"],
  "sim/referee": ["sim/math", "sim/field", "sim/world", "sim/motion", "sim/agent"],
  "sim/match": ["sim/math", "sim/field", "sim/world", "sim/motion", "sim/agent", "sim/perception", "sim/referee"],
  "sim/foresight": [
    "sim/math",
    "sim/field",
    "sim/world",
    "sim/motion",
    "sim/agent",
    "sim/perception",
    "sim/referee",
    "sim/match",
  ],
  "sim/replay": [
    "sim/math",
    "sim/field",
    "sim/world",
    "sim/motion",
    "sim/agent",
    "sim/perception",
    "sim/referee",
    "sim/match",
  ],
  "sim/compare": [],
  "sim/statistics": ["sim/math"],
  "sim/io": [
    "sim/math",
    "sim/field",
    "sim/world",
    "sim/motion",
    "sim/agent",
    "sim/perception",
    "sim/referee",
    "sim/match",
    "sim/foresight",
    "sim/statistics",
    "robot/core",
  ],
  "sim/guest": ["sim/math", "sim/field", "sim/motion", "sim/world", "sim/agent", "robot/core"],
  "sim/contest": [
    "sim/math",
    "sim/field",
    "sim/world",
    "sim/motion",
    "sim/agent",
    "sim/perception",
    "sim/referee",
    "sim/match",
    "sim/foresight",
    "sim/compare",
    "sim/io",
    "sim/guest",
    "robot/core",
  ],
  "sim/check": [
    "sim/math",
    "sim/field",
    "sim/world",
    "sim/motion",
    "sim/agent",
    "sim/perception",
    "sim/referee",
    "sim/match",
    "sim/foresight",
    "sim/compare",
    "sim/io",
    "sim/guest",
    "sim/contest",
    "robot/core",
  ],
  "sim/drills": [
    "sim/math",
    "sim/field",
    "sim/world",
    "sim/motion",
    "sim/agent",
    "sim/perception",
    "sim/referee",
    "sim/match",
    "sim/foresight",
    "sim/compare",
    "sim/io",
    "sim/guest",
    "sim/contest",
    "sim/check",
    "robot/core",
  ],
  "sim/learn": [
    "sim/math",
    "sim/field",
    "sim/world",
    "sim/motion",
    "sim/agent",
    "sim/perception",
    "sim/referee",
    "sim/match",
    "sim/foresight",
    "sim/compare",
    "sim/io",
    "sim/guest",
    "sim/contest",
    "sim/check",
    "sim/drills",
    "robot/core",
  ],
  "sim/environment": [
    "sim/math",
    "sim/field",
    "sim/world",
    "sim/motion",
    "sim/agent",
    "sim/perception",
    "sim/referee",
    "sim/match",
    "sim/foresight",
    "sim/compare",
    "sim/io",
    "sim/guest",
    "sim/contest",
    "sim/check",
    "sim/drills",
    "robot/core",
  ],
  "sim/debug": [
    "sim/math",
    "sim/field",
    "sim/world",
    "sim/motion",
    "sim/agent",
    "sim/perception",
    "sim/referee",
    "sim/match",
    "sim/foresight",
    "sim/compare",
    "sim/io",
    "sim/guest",
    "sim/contest",
    "sim/check",
    "robot/core",
  ],
  "sim/report": [
    "sim/debug",
    "sim/math",
    "sim/field",
    "sim/world",
    "sim/motion",
    "sim/agent",
    "sim/perception",
    "sim/referee",
    "sim/match",
    "sim/foresight",
    "sim/compare",
    "sim/statistics",
    "sim/io",
    "sim/guest",
    "sim/contest",
    "sim/learn",
    "robot/core",
  ],
  "sim/app": "everything",
  "robot/core": [],
  "robot/memory": ["robot/core", "proto"],
  "robot/image": ["robot/core"],
  "robot/logging/mcap": ["robot/core", "robot/memory"],
  "robot/logging/streams": ["robot/core", "robot/memory", "robot/logging/mcap"],
  "robot/logging/sessions": [
    "robot/core",
    "robot/memory",
    "robot/image",
    "robot/logging/mcap",
    "robot/logging/streams",
    "proto",
  ],
  "robot/logging/recent": ["robot/core", "robot/memory", "robot/logging/mcap", "robot/logging/streams"],
  "robot/logging": ["robot/logging/mcap", "robot/logging/streams", "robot/logging/sessions", "robot/logging/recent"],
  "robot/net/http": ["robot/core"],
  "robot/net/websocket": ["robot/core", "robot/net/http"],
  "robot/net/foxglove": [
    "robot/core",
    "robot/memory",
    "robot/image",
    "robot/logging/mcap",
    "robot/logging/streams",
    "robot/net/websocket",
    "proto",
  ],
  "robot/net/scene": ["robot/core", "robot/memory", "robot/net/foxglove", "proto"],
  "robot/net/serve": [
    "robot/core",
    "robot/memory",
    "robot/logging/mcap",
    "robot/logging/streams",
    "robot/logging/sessions",
    "robot/net/http",
    "robot/net/websocket",
    "robot/net/foxglove",
  ],
  "robot/net": ["robot/net/http", "robot/net/websocket", "robot/net/foxglove", "robot/net/scene", "robot/net/serve"],
  "robot/agent": [
    "robot/core",
    "robot/memory",
    "robot/bridge",
    "proto",
    "sim/math",
    "sim/field",
    "sim/motion",
    "sim/world",
    "sim/agent",
    "sim/match",
    "sim/foresight",
    "sim/io",
  ],
  "robot/foresight": [
    "robot/core",
    "robot/memory",
    "robot/bridge",
    "proto",
    "sim/math",
    "sim/field",
    "sim/motion",
    "sim/world",
    "sim/agent",
    "sim/referee",
    "sim/match",
    "sim/foresight",
    "sim/io",
  ],
  "robot/bridge": [
    "robot/core",
    "robot/memory",
    "proto",
    "sim/math",
    "sim/field",
    "sim/motion",
    "sim/world",
    "sim/agent",
    "sim/perception",
    "sim/referee",
    "sim/match",
    "sim/foresight",
  ],
  "robot/game": ["robot/core", "robot/memory", "proto"],
  "robot/nao/lola": ["robot/core"],
  "robot/nao/model": ["robot/nao/lola"],
  "robot/nao/guardian": ["robot/core", "robot/nao/lola"],
  "robot/nao/walk": ["robot/nao/model"],
  "robot/nao/camera": ["robot/core", "robot/memory", "proto", "robot/nao/guardian"],
  "robot/nao/motion": [
    "robot/core",
    "proto",
    "robot/nao/lola",
    "robot/nao/model",
    "robot/nao/walk",
    "robot/nao/guardian",
  ],
  "robot/body/attached": [...kSessions, "proto"],
  "robot/body/nao": [
    "robot/core",
    "robot/memory",
    "proto",
    "robot/nao/lola",
    "robot/nao/model",
    "robot/nao/guardian",
    "robot/nao/camera",
    "robot/nao/motion",
    "robot/nao/walk",
  ],
  "robot/body/replay": [...kSessions, "proto"],
  "robot/body/sim": [
    "robot/core",
    "robot/memory",
    "robot/bridge",
    "proto",
    "sim/math",
    "sim/world",
    "sim/agent",
    "sim/referee",
    "sim/match",
    "sim/io",
  ],
  "robot/client": [],
  "robot/truth/frame": ["robot/core"],
  "robot/truth/sensor": ["robot/core", "robot/nao/camera", "robot/truth/frame"],
  "robot/truth/synthetic": ["robot/core", "robot/truth/frame", "sim/math", "sim/field"],
  "robot/truth/calibration": ["robot/core", "robot/truth/frame", "sim/math", "sim/field"],
  "robot/truth/detection": ["robot/core", "robot/truth/frame", "sim/math", "sim/field"],
  "robot/truth/tracks": ["robot/core", "robot/truth/frame"],
  "robot/truth/tags": ["robot/core", "robot/truth/frame"],
  "robot/truth/feeds": ["robot/core", "robot/truth/frame", "proto"],
  "robot/truth": [
    "robot/truth/sensor",
    "robot/truth/synthetic",
    "robot/truth/detection",
    "robot/truth/calibration",
    "robot/truth/tracks",
    "robot/truth/tags",
    "robot/truth/feeds",
  ],
  "robot/command": [],
  "robot/fit/math": [],
  "robot/fit": [
    ...kSessions,
    "robot/lab/clocks",
    "robot/fit/math",
    "proto",
    "sim/math",
    "sim/field",
    "sim/world",
    "sim/motion",
    "sim/perception",
    "sim/match",
    "sim/statistics",
  ],
  "robot/lab/clocks": [...kSessions, "proto"],
  "robot/lab/import": [...kSessions, "robot/fit/math", "robot/image", "robot/truth/feeds", "proto"],
  "robot/lab/mapping": ["robot/core", "robot/memory", "robot/logging/mcap", "robot/logging/streams", "proto"],
  "robot/lab/relay": [
    ...kSessions,
    "robot/image",
    "robot/net",
    "robot/net/http",
    "robot/net/websocket",
    "robot/net/foxglove",
    "robot/lab/clocks",
    "proto",
  ],
  "robot/lab/whole": [
    "robot/core",
    "robot/memory",
    "robot/logging/mcap",
    "robot/logging/streams",
    "robot/body/replay",
    "proto",
  ],
  "robot/lab/synthetic": ["robot/core", "robot/memory", "robot/lab/import", "proto"],
  "robot/lab": [
    "robot/lab/clocks",
    "robot/lab/import",
    "robot/lab/mapping",
    "robot/lab/relay",
    "robot/lab/synthetic",
    "robot/lab/whole",
  ],
  "robot/app": "everything",
  tests: "everything",
};

/** Libraries that only these folders may use: by the first part of an #include, by the first part of a CMake target. */
export const libraries = [
  { name: "Boost", include: "boost/", target: "Boost::", folders: ["robot/net", "tests"] },
  {
    name: "Eigen",
    include: "Eigen/",
    target: "Eigen3::",
    folders: ["robot/nao/model", "robot/nao/motion", "robot/body/nao", "robot/truth", "tests"],
  },
  { name: "libfreenect", include: "libfreenect", target: "freenect", folders: ["robot/truth/sensor", "tests"] },
  { name: "OpenNI", include: "Oni", target: "OpenNI", folders: ["robot/truth/sensor", "tests"] },
  { name: "PCL", include: "pcl/", target: "pcl_", folders: ["tests"] },
  { name: "libpng", include: "png.h", target: "PNG::", folders: ["robot/truth/sensor", "tests"] },
  { name: "libtiff", include: "tiff", target: "TIFF::", folders: ["robot/truth/sensor", "tests"] },
  { name: "libedit", include: "editline/", target: "edit::", folders: ["sim/app"] },
  { name: "Random123", include: "Random123/", target: "Random123::", folders: ["sim/math"] },
];

/** The folders of viewer-web/src, bottom to top: a file imports from its own folder and from those before it. */
const viewerLayers = ["source", "memory", "present", "draw", "state", "widgets", "views", "app"];

/** Reports whether the folder of a row, or one above it, may know the library. */
const knows = (row, library) => library.folders.some((folder) => row === folder || row.startsWith(`${folder}/`));

/** The row of `path`, or undefined. */
function rowOf(path, table) {
  let folder = path;
  while (folder !== "." && !(folder in table)) folder = posix.dirname(folder);
  return folder === "." ? undefined : folder;
}

/** Returns undefined if files of row `from` may use those of row `to`, otherwise the reason. */
function reasonAgainst(from, to, table) {
  if (from === to || from === "tests") return undefined;
  if (table[to] === "everything") return `${to} is a leaf that nobody includes`;
  if (table[from] === "everything" || table[from].includes(to)) return undefined;
  return `${from} may only use ${table[from].length ? table[from].join(", ") : "nothing of ours"}`;
}

const isCode = (path) => /\.(h|hpp|c|cc|cpp)$/.test(path);
const isScript = (path) => /\.(ts|js|mjs|svelte)$/.test(path);
const lineOf = (text, index) => text.slice(0, index).split("\n").length;

function* includesIn(text) {
  for (const match of text.matchAll(/^[ \t]*#[ \t]*include[ \t]*(["<])([^">]+)[">]/gm))
    yield { quoted: match[1] === '"', path: match[2], line: lineOf(text, match.index) };
}

function* checkCode(path, text, { table, folders }) {
  const from = rowOf(posix.dirname(path), table);
  if (!from) {
    yield `${path}: no row of the table in tests/check/includes.mjs is about this folder; add one with what it may include`;
    return;
  }
  const topLevels = new Set([...folders].map((folder) => folder.split("/")[0]));
  for (const include of includesIn(text)) {
    const where = `${path}:${include.line}: includes ${include.quoted ? `"${include.path}"` : `<${include.path}>`}`;

    const library = libraries.find((library) => include.path.startsWith(library.include));
    if (library && !knows(from, library))
      yield `${where}, but only ${library.folders.join(", ")} may know ${library.name}`;

    const ours = topLevels.has(include.path.split("/")[0]);
    if (include.quoted && !ours && !library)
      yield `${where}, but our files are included by their path from the top of the repository, others' with <…>`;
    if (!ours) continue;
    const to = rowOf(posix.dirname(include.path), table);
    const reason = to ? reasonAgainst(from, to, table) : "no row of the table is about that folder";
    if (reason) yield `${where}, but ${reason}`;
  }
}

/** The commands of a CMakeLists.txt: name, words, line. */
function* commandsIn(text) {
  const code = text.replace(/#.*$/gm, "");
  for (const match of code.matchAll(/\b([a-z_]+)\s*\(([^()]*)\)/gi))
    yield {
      name: match[1].toLowerCase(),
      words: match[2].split(/\s+/).filter(Boolean),
      line: lineOf(code, match.index),
    };
}

function* checkLinks(path, text, { table, folderOfTarget }) {
  const from = rowOf(posix.dirname(path), table);
  if (!from) return; // the top levels only gather
  for (const { name, words, line } of commandsIn(text)) {
    if (name !== "target_link_libraries") continue;
    for (const word of words.slice(1)) {
      const where = `${path}:${line}: links ${words[0]} with ${word}`;

      const library = libraries.find((library) => word.startsWith(library.target));
      if (library && !knows(from, library))
        yield `${where}, but only ${library.folders.join(", ")} may know ${library.name}`;

      const to = folderOfTarget.has(word) && rowOf(folderOfTarget.get(word), table);
      const reason = to && reasonAgainst(from, to, table);
      if (reason) yield `${where}, but ${reason}`;
    }
  }
}

/** The viewer imports nothing from outside its folder, because it learns all schemas from its server, and nothing from above. */
function* checkImports(path, text) {
  const layerOf = (file) => viewerLayers.indexOf(file.split("/")[2]); // -1: outside the layers, such as main.ts
  for (const match of text.matchAll(/\b(?:from|import)\s*\(?\s*["']([^"']+)["']/g)) {
    const target = match[1];
    const where = `${path}:${lineOf(text, match.index)}: imports "${target}"`;
    const file = posix.join(posix.dirname(path), target);
    if (target.startsWith("/") || (target.startsWith(".") && !file.startsWith("viewer-web/")))
      yield `${where}, but viewer-web uses nothing outside its folder`;
    else if (target.startsWith(".") && layerOf(path) >= 0 && layerOf(file) > layerOf(path))
      yield `${where}, but ${viewerLayers[layerOf(path)]} is below ${viewerLayers[layerOf(file)]}`;
  }
}

/** Returns one sentence per violation of `table` in the repository at `root`. */
export function violations(root, table = rows) {
  const files = filesBelow(root);
  const folders = new Set(files.map((path) => posix.dirname(path)));
  const read = (path) => readFileSync(join(root, path), "utf8");

  const folderOfTarget = new Map();
  const cmake = files.filter((path) => posix.basename(path) === "CMakeLists.txt");
  for (const path of cmake)
    for (const { name, words } of commandsIn(read(path)))
      if (name === "add_library" || name === "add_executable") folderOfTarget.set(words[0], posix.dirname(path));

  const sentences = [];
  const repository = { table, folders, folderOfTarget };
  for (const path of files) {
    if (isCode(path)) sentences.push(...checkCode(path, read(path), repository));
    if (path.startsWith("viewer-web/src/") && isScript(path)) sentences.push(...checkImports(path, read(path)));
  }
  for (const path of cmake) sentences.push(...checkLinks(path, read(path), repository));

  // a rule about a folder that does not exist has no effect and misleads readers of the table
  const named = new Set([
    ...Object.keys(table),
    ...Object.values(table).flatMap((row) => (row === "everything" ? [] : row)),
  ]);
  for (const folder of named)
    if (!files.some((path) => path.startsWith(`${folder}/`)))
      sentences.push(
        `tests/check/includes.mjs: the table names ${folder}, which does not exist; it comes with its first file`,
      );
  return sentences;
}
