import { svelte } from "@sveltejs/vite-plugin-svelte";
import { fileURLToPath } from "node:url";
import { defineConfig } from "vitest/config";
import { schemaComments } from "./schema_comments.mjs";

// `npm run dev` serves the page itself and takes everything else from a robot: FORESIGHT_ROBOT=http://10.0.14.2:8765
const robot = process.env["FORESIGHT_ROBOT"] ?? "http://127.0.0.1:8765";

export default defineConfig({
  plugins: [svelte(), schemaComments(fileURLToPath(new URL("../proto/foresight", import.meta.url)))],
  build: {
    // The robot's Content-Security-Policy allows no data: scripts or styles, so nothing is inlined.
    assetsInlineLimit: 0,
    target: "es2022",
    modulePreload: { polyfill: false },
  },
  server: {
    proxy: {
      "/api": robot,
      "/logs": robot,
      "/live": { target: robot.replace(/^http/, "ws"), ws: true },
    },
  },
  // a busy machine may take long
  test: { testTimeout: 60_000, include: ["src/**/*.test.ts", "embed.test.ts", "schema.test.ts"] },
});
