import { defineConfig } from "vitest/config";

export default defineConfig({
  // One document for all files, put in order after each test: making one a file took ten times as long as the tests.
  test: { environment: "jsdom", include: ["src/**/*.test.ts"], isolate: false, restoreMocks: true },
});
