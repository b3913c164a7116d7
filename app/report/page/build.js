// Bundles the page into ../page.html: one file with its script, its style and the licences of what it
// is made of, and a place for the data of a report. `node build.js FILE` writes elsewhere.
import { buildSync } from "esbuild";
import { readFileSync, writeFileSync } from "node:fs";

const here = (name) => new URL(name, import.meta.url);
const text = (name) => readFileSync(here(name), "utf8");

const bundle = buildSync({
  absWorkingDir: here(".").pathname,
  entryPoints: ["src/main.js"],
  bundle: true,
  minify: true,
  format: "iife",
  target: "es2021",
  charset: "ascii",
  legalComments: "none",
  write: false,
});
const script = bundle.outputFiles[0].text.replaceAll("</script", "<\\/script");

const licences = ["three", "fflate"]
  .map((name) => `${name}\n${text(`node_modules/${name}/LICENSE`).trim()}`)
  .join("\n\n");
if (licences.includes("--")) throw new Error("a licence would end the comment that holds it");

const parts = { licences, style: text("src/style.css"), script };
const page = text("src/page.html").replace(/\{\{(\w+)\}\}/g, (_, name) => parts[name].trim());
writeFileSync(process.argv[2] ?? here("../page.html"), page);
