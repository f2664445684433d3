import { mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { gunzipSync } from "node:zlib";
import { afterEach, beforeEach, expect, test } from "vitest";
import { embed } from "./embed.mjs";

let folder: string;
let dist: string;
let out: string;

beforeEach(() => {
  folder = mkdtempSync(join(tmpdir(), "embed-"));
  [dist, out] = [join(folder, "dist"), join(folder, "out")];
  mkdirSync(join(dist, "assets"), { recursive: true });
  writeFileSync(join(dist, "index.html"), "<p>page</p>");
  writeFileSync(join(dist, "assets/index-1.js"), "let x = 1;");
});
afterEach(() => rmSync(folder, { recursive: true }));

const source = () => readFileSync(join(out, "viewer_assets.cpp"), "utf8");

test("every file is embedded gzipped, sorted by path, with its content type", () => {
  embed(dist, out);
  expect(gunzipSync(readFileSync(join(out, "assets/0.gz"))).toString()).toBe("let x = 1;");
  expect(gunzipSync(readFileSync(join(out, "assets/1.gz"))).toString()).toBe("<p>page</p>");
  expect(source()).toMatch(
    /"\/assets\/index-1\.js", "text\/javascript; charset=utf-8", \{foresight_viewer_asset_0, \d+\}/,
  );
  expect(source()).toContain("kViewerAssetCount = 2;");
});

test("the same input gives the same bytes, another input another source", () => {
  embed(dist, out);
  const [before, gz] = [source(), readFileSync(join(out, "assets/1.gz"))];
  embed(dist, out);
  expect(source()).toBe(before);
  expect(readFileSync(join(out, "assets/1.gz"))).toEqual(gz);
  expect([...gz.subarray(4, 8), gz[9]]).toEqual([0, 0, 0, 0, 255]); // no time, no operating system
  writeFileSync(join(dist, "index.html"), "<p>pagE</p>");
  embed(dist, out);
  expect(source()).not.toBe(before);
});

test("a folder that cannot be embedded gives a sentence with the remedy", () => {
  writeFileSync(join(dist, "strange.xyz"), "");
  expect(() => embed(dist, out)).toThrow("no content type is known for 'strange.xyz'");
  rmSync(join(dist, "index.html"));
  expect(() => embed(dist, out)).toThrow("npm run build");
  expect(() => embed(join(folder, "none"), out)).toThrow("npm run build");
});
