import { defineConfig } from "vite";

/** One ES module, one style sheet and the page, with names that do not change, into the package. */
export default defineConfig({
  base: "./",
  build: {
    outDir: "../src/skydome/explorer/page",
    emptyOutDir: true,
    target: "es2022",
    modulePreload: false,
    cssCodeSplit: false,
    assetsInlineLimit: 0,
    rollupOptions: {
      preserveEntrySignatures: "strict",
      output: {
        entryFileNames: "explorer.js",
        assetFileNames: "explorer[extname]",
        codeSplitting: false,
      },
    },
  },
  json: { stringify: true },
});
