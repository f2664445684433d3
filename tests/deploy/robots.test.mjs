// The commands against virtual robots without bodies: each has its own network, ssh server, home and runtime.
import { describe } from "node:test";
import { deployStory } from "./deploy_story.mjs";
import { whyNoField } from "./field.mjs";
import { guardianStory } from "./guardian_story.mjs";
import { linksStory } from "./links_story.mjs";
import { logsStory } from "./logs_story.mjs";
import { systemdStory } from "./systemd_story.mjs";

// the tests of each story run in order; all of them mostly wait
describe("robots", { skip: whyNoField(), concurrency: true }, () => {
  describe("deploy", { concurrency: false }, deployStory);
  describe("deploy over links that break", { concurrency: false }, linksStory);
  describe("deploy where there is systemd", { concurrency: false }, systemdStory);
  describe("deploy to a body of ours", { concurrency: false }, guardianStory);
  describe("logs", { concurrency: false }, logsStory);
});
