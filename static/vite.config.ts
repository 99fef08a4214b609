import { defineConfig } from "vite";

const pages = ["site", "library", "clip", "trial", "welcome", "thanks", "results", "viewer", "keys", "sets", "studio", "graph", "builder", "studies", "live", "impressions", "space", "spaces"];

export default defineConfig({
  base: "/static/",
  publicDir: false,
  build: {
    outDir: "dist",
    manifest: true,
    target: "es2022",
    modulePreload: { polyfill: false },
    chunkSizeWarningLimit: 1200,
    rolldownOptions: {
      input: {
        ...Object.fromEntries(pages.map((page) => [page, `src/entries/${page}.ts`])),
        japanese: "src/styles/japanese.css",
      },
    },
  },
});
