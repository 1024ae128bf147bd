// The post-processor in Node, as a script that programs against the core uses it.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { pathToFileURL } from "node:url";

const folder = process.env.NCTAPE_PKG ?? join(import.meta.dirname, "../../pkg");
/** @type {typeof import("nctape")} */
const nctape = await import(pathToFileURL(join(folder, "nctape.js")).href);
await nctape.default({ module_or_path: readFileSync(join(folder, "nctape_bg.wasm")) });

/** @type {import("nctape").Format} */
const format = { standard: "iso2539", classification: "CAM 333", detail: "N3G2X+42Y+42Z+42I+42J+42F4M2*" };

test("CLDATA becomes a tape, and every block leads back to its record", () => {
  const source = "1,9000,9,1;\n2,20000,0,PARTNO,'\u{1F600}A';\n3,20000,0,RAPID;\n4,5000,5,'',0,10.5,-3.,.;\n5,20000,0,END;\n6,14000;\n:\n";
  const { text, diagnostics, map, incomplete } = nctape.postprocess(source, format);
  assert.equal(text, "%\nN001 G00 X+001050 Y-000300 (A)\nN002 M02\n");
  assert.deepEqual([diagnostics, incomplete], [[], undefined]);
  const blocks = map.filter(([, , from, to]) => to > from);
  assert.deepEqual(blocks.map(([from, to]) => source.slice(from, to)), ["4,5000,5,'',0,10.5,-3.,.;", "5,20000,0,END;"]);
  assert.deepEqual(blocks.map(([, , from, to]) => text.slice(from, to)), ["N001 G00 X+001050 Y-000300 (A)\n", "N002 M02\n"]);
});

test("what the format cannot express is a located error, and the tape says that it is incomplete", () => {
  const source = "GOTO / 1.0, 0.0, 0.0\nFEDRAT / 100, MMPM\nMULTAX / ON\nGOTO / 5.0, 0.0, 0.0, 0.6, 0.0, 0.8\nFINI\n";
  const { text, diagnostics, incomplete } = nctape.postprocess(source, format);
  const tilted = diagnostics.find(({ rule }) => rule === "POST-01");
  assert.ok(tilted);
  assert.equal(source.slice(tilted.from, tilted.to), "GOTO / 5.0, 0.0, 0.0, 0.6, 0.0, 0.8");
  assert.deepEqual([tilted.severity, tilted.line, incomplete], ["error", 4, true]);
  assert.match(text, /^%\nN001 .*\(INCOMPLETE\)/);
});

test("arcs as circles, parabolas and chords", () => {
  const source =
    "1,9000,9,1;\n2,5000,3,'',0,10.,.,.;\n3,20000,0,FEDRAT,60.,PERMIN;\n4,3000,2,0,4,9,'C1',0,.,.,.,.,.,1.,10.;\n5,5000,5,'',0,.,10.,.;\n6,14000;\n:\n";
  const at = { ...format, itemized: { setPoint: [10, 0, 0] } };
  /** @param {import("nctape").PostOptions} options */
  const kinds = (options) => nctape.check(nctape.postprocess(source, at, options).text, at).spans.map(({ kind }) => kind);
  assert.deepEqual(kinds({}), ["arc"]);
  assert.deepEqual(kinds({ arcs: "parabolas", tolerance: 0.01 }), ["parabola", "parabola"]);
  // A chord over an angle a lies R (1 - cos a/2) inside: 90 degrees take three within 0,4.
  assert.deepEqual(kinds({ arcs: "chords", tolerance: 0.4 }), ["line", "line", "line"]);
  for (const [options, field] of /** @type {[any, string][]} */ ([
    [{ arcs: "spirals" }, "arcs"],
    [{ tolerance: 0 }, "tolerance"],
    [{ quadrants: 1 }, "quadrants"],
    [{ columns: 0 }, "columns"],
  ])) {
    assert.throws(() => nctape.postprocess("", format, options), { name: "TypeError", field });
  }
  assert.equal(nctape.postprocess("\u0000{[\ud800;", format).map.length > 0, true);
});
