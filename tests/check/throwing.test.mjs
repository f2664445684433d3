import assert from "node:assert/strict";
import { test } from "node:test";
import { throwingCalls } from "./throwing.mjs";

const sentencesOf = (code) => throwingCalls(code).map(([line, sentence]) => `${line}: ${sentence}`);

test("a call with an error code passes, and the same call without one does not", () => {
  const code = "std::error_code failed, ignored;\nstd::filesystem::remove(path / (a + b), failed);\n";
  assert.deepEqual(sentencesOf(code), []);
  assert.deepEqual(sentencesOf(code.replace(", failed)", ")")), [
    "2: remove() throws: expected a std::error_code as its last argument",
  ]);
  assert.deepEqual(sentencesOf("bool is(const fs::path& p) { return fs::exists(p); }"), [
    "1: exists() throws: expected a std::error_code as its last argument",
  ]);
  assert.deepEqual(
    sentencesOf("std::error_code e;\nif (fs::is_symlink(fs::symlink_status(folder, e)) || fs::exists(status)) return;"),
    [],
  );
  assert.deepEqual(
    sentencesOf("void f(std::error_code& error) { std::filesystem::create_directories(folder, error); }"),
    [],
  );
});

test("an entry, an iteration, a thread and an async are found", () => {
  assert.deepEqual(sentencesOf("if (entry.is_directory()) return;\nif (entry.is_directory(error)) return;"), [
    "1: is_directory() throws: expected a std::error_code as its argument",
  ]);
  assert.equal(
    sentencesOf("for (const auto& entry : std::filesystem::directory_iterator(folder, failed)) f(entry);").length,
    2,
    "without a declaration also its code is not known",
  );
  assert.deepEqual(
    sentencesOf(
      "std::error_code e;\nfor (std::filesystem::directory_iterator at(folder, e), end; at != end; at.increment(e)) f(*at);",
    ),
    [],
  );
  assert.equal(sentencesOf("thread_ = std::thread([this] { run(); });").length, 1);
  assert.equal(sentencesOf("std::thread worker(run);").length, 1);
  assert.deepEqual(sentencesOf("std::thread thread_;\nstd::vector<std::thread> threads;"), []);
  assert.equal(sentencesOf("std::async(std::launch::async, f);").length, 1);
});

test("comments and texts do not count", () => {
  assert.deepEqual(sentencesOf('// std::filesystem::exists(path)\nconst char* text = "std::thread(run)";'), []);
});
