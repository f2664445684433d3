import assert from "node:assert/strict";
import { test } from "node:test";
import { violations } from "./includes.mjs";
import { repositoryOf } from "./repository.mjs";

const table = {
  proto: [],
  "robot/core": [],
  "robot/memory": ["robot/core", "proto"],
  "robot/net": ["robot/core"],
  "robot/app": "everything",
  tests: "everything",
};

// one include for each permission of each row
const lawful = {
  "proto/CMakeLists.txt": "add_library(proto STATIC ball.proto)\n",
  "robot/core/clock.h": "#include <cstdint>\n",
  "robot/core/CMakeLists.txt":
    "add_library(robot_core STATIC clock.cpp)\ntarget_link_libraries(robot_core PUBLIC project_options)\n",
  "robot/memory/deep/memory.h":
    '#include "proto/ball.pb.h"\n#include "robot/core/clock.h"\n#include "robot/memory/other.h"\n',
  "robot/memory/CMakeLists.txt":
    "# robot_app is not linked\nadd_library(robot_memory STATIC m.cpp)\ntarget_link_libraries(robot_memory\n  PUBLIC robot_core proto)\n",
  "robot/net/serve/server.cpp": "#include <boost/beast.hpp>\n",
  "robot/net/CMakeLists.txt":
    "add_library(robot_net server.cpp)\ntarget_link_libraries(robot_net PRIVATE Boost::headers robot_core)\n",
  "robot/app/main.cpp": '#include "robot/memory/deep/memory.h"\n#include "robot/net/serve/server.h"\n',
  "robot/app/CMakeLists.txt": "add_library(robot_app a.cpp)\ntarget_link_libraries(robot_app robot_net robot_memory)\n",
  "tests/robot/app/main_test.cpp":
    '#include "robot/app/main.h"\n#include "tests/support/file.h"\n#include <boost/beast.hpp>\n',
  "viewer-web/src/a/b.ts": 'import { x } from "../c";\nimport "svelte";\n',
  "viewer-web/src/views/Field.svelte": 'import { x } from "../draw/field";\nconst later = import("./Game.svelte");\n',
  "viewer-web/src/main.ts": 'import App from "./app/App.svelte";\n',
};

const cases = [
  {
    name: "a folder that includes what its row does not list",
    files: { "robot/core/clock.cpp": '\n  # include "robot/memory/deep/memory.h"\n' },
    says: 'robot/core/clock.cpp:2: includes "robot/memory/deep/memory.h", but robot/core may only use nothing of ours',
  },
  {
    name: "the same in angle brackets",
    files: { "robot/net/serve/server.h": "#include <proto/ball.pb.h>\n" },
    says: "robot/net/serve/server.h:1: includes <proto/ball.pb.h>, but robot/net may only use robot/core",
  },
  {
    name: "a leaf that is included",
    files: { "robot/memory/m.cpp": '#include "robot/app/main.h"\n' },
    says: 'robot/memory/m.cpp:1: includes "robot/app/main.h", but robot/app is a leaf that nobody includes',
  },
  {
    name: "a leaf that includes the tests",
    files: { "robot/app/other.cpp": '#include "tests/support/file.h"\n' },
    says: 'robot/app/other.cpp:1: includes "tests/support/file.h", but tests is a leaf that nobody includes',
  },
  {
    name: "a path that does not begin at the top",
    files: { "robot/core/clock.cpp": '#include "../core/clock.h"\n' },
    says:
      'robot/core/clock.cpp:1: includes "../core/clock.h", ' +
      "but our files are included by their path from the top of the repository, others' with <…>",
  },
  {
    name: "a library that others keep to themselves",
    files: { "robot/memory/m.cpp": "#include <boost/asio.hpp>\n" },
    says: "robot/memory/m.cpp:1: includes <boost/asio.hpp>, but only robot/net, tests may know Boost",
  },
  {
    name: "a link that the table forbids",
    files: {
      "robot/net/CMakeLists.txt":
        "add_library(robot_net s.cpp)\n\ntarget_link_libraries(robot_net PUBLIC robot_memory)\n",
    },
    says: "robot/net/CMakeLists.txt:3: links robot_net with robot_memory, but robot/net may only use robot/core",
  },
  {
    name: "a link with a library that others keep to themselves",
    files: { "robot/core/CMakeLists.txt": "target_link_libraries(robot_core PRIVATE Boost::headers)\n" },
    says: "robot/core/CMakeLists.txt:1: links robot_core with Boost::headers, but only robot/net, tests may know Boost",
  },
  {
    name: "an import that leaves the viewer",
    files: { "viewer-web/src/a/b.ts": '\nimport { Ball } from "../../../proto/ball";\n' },
    says: 'viewer-web/src/a/b.ts:2: imports "../../../proto/ball", but viewer-web uses nothing outside its folder',
  },
  {
    name: "an import from a higher folder of the viewer",
    files: { "viewer-web/src/draw/field.ts": 'import { Viewer } from "../state/viewer.svelte";\n' },
    says: 'viewer-web/src/draw/field.ts:1: imports "../state/viewer.svelte", but draw is below state',
  },
  {
    name: "code in a folder without a row",
    files: { "robot/game/game.cpp": "" },
    says:
      "robot/game/game.cpp: no row of the table in tests/check/includes.mjs is about this folder; " +
      "add one with what it may include",
  },
];

test("an allowed include is no violation", (t) => {
  assert.deepEqual(violations(repositoryOf(t, lawful), table), []);
});

for (const { name, files, says } of cases)
  test(`${name} is one sentence`, (t) => {
    assert.deepEqual(violations(repositoryOf(t, { ...lawful, ...files }), table), [says]);
  });

test("a row about a folder that does not exist is a violation", (t) => {
  const withSim = { ...table, "robot/net": ["robot/core", "sim"] };
  assert.deepEqual(violations(repositoryOf(t, lawful), withSim), [
    "tests/check/includes.mjs: the table names sim, which does not exist; it comes with its first file",
  ]);
});
