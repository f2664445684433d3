// Pages of the viewer in Chromium without a graphics card, for the benches.
import { join } from "node:path";
import { require } from "../e2e/support.mjs";
import { atEnd, command, scratch } from "./programs.mjs";

const { chromium } = require("playwright-core");

/** Words for a program that serves the viewer at any free port. */
export const state = ["--port", 0, "--state-dir", join(scratch, "state")];

export async function openBrowser() {
  const executablePath = command("which", "chromium").trim();
  const browser = await chromium.launch({
    executablePath,
    args: ["--no-sandbox", "--disable-gpu", "--disable-background-networking"],
  });
  atEnd(() => browser.close());
  return browser;
}

/**
 * A page that keeps the time of each topic's last message since the last didSeek [ms of our clock]. `kept` is what the
 * browser's storage has from before.
 */
export async function openPage(browser, url, kept = {}) {
  const page = await (await browser.newContext({ viewport: { width: 1280, height: 800 } })).newPage();
  await page.addInitScript((entries) => {
    for (const [key, value] of entries) localStorage.setItem(key, value);
  }, Object.entries(kept));
  const seen = { messages: 0, sought: 0, first: new Map(), subscribed: new Map(), topics: new Map(), state: undefined };
  page.on("websocket", (socket) => {
    socket.on("framesent", ({ payload }) => {
      const text = typeof payload === "string" ? payload : "";
      if (!text.includes('"op":"subscribe"') && !text.includes('"op":"unsubscribe"')) return;
      const message = JSON.parse(text);
      for (const { id, channelId } of message.subscriptions ?? []) seen.subscribed.set(id, channelId);
      for (const id of message.subscriptionIds ?? []) seen.subscribed.delete(id);
    });
    socket.on("framereceived", ({ payload }) => {
      if (typeof payload === "string") {
        const message = payload.includes('"op":"advertise"') ? JSON.parse(payload) : {};
        for (const { id, topic } of message.channels ?? []) seen.topics.set(id, topic);
        return;
      }
      if (payload[0] === 5 && payload[14] === 1) {
        seen.sought = performance.now();
        seen.first.clear();
      } else if (payload[0] === 1) {
        ++seen.messages;
        const id = payload.readUInt32LE(1);
        if (!seen.first.has(id)) seen.first.set(id, performance.now());
      }
    });
  });
  await page.goto(url);
  return { page, seen };
}

/** Waits until the page has drawn what it has received. */
export const drawn = (page) =>
  page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => done()))));
