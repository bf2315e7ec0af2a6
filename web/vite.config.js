// One script and one style sheet, which the report writer embeds in each page as they are.
export default {
  build: {
    target: "es2022",
    modulePreload: false,
    cssCodeSplit: false,
    assetsInlineLimit: 0,
    chunkSizeWarningLimit: 1500,
    lib: { entry: "src/main.ts", formats: ["iife"], name: "LoosefitPage",
           fileName: () => "page.js", cssFileName: "page" },
  },
};
