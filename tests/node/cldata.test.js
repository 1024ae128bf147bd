// CLDATA in Node, as a script that programs against the core uses it.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { pathToFileURL } from "node:url";

const folder = process.env.NCTAPE_PKG ?? join(import.meta.dirname, "../../pkg");
/** @type {typeof import("nctape")} */
const nctape = await import(pathToFileURL(join(folder, "nctape.js")).href);
await nctape.default({ module_or_path: readFileSync(join(folder, "nctape_bg.wasm")) });

const quarter = [
  "1,9000,9,1;",
  "2,5000,3,'',0,10.,.,5.;",
  "3,20000,0,FEDRAT,60.,PERMIN;",
  "4,3000,2,0,4,9,'C1',0,.,.,5.,.,.,1.,10.;",
  "5,5000,5,'',0,.,10.,5.;",
  "6,20000,0,END;",
  "7,14000;",
  ":\n",
].join("\n");

test("records are blocks and elements are words", () => {
  const report = nctape.checkCldata(quarter);
  assert.deepEqual([report.api, report.unit, report.axes], [1, "mm", ["X", "Y", "Z"]]);
  assert.deepEqual(report.diagnostics, []);
  assert.deepEqual(report.blocks.map((block) => block.sequence), ["1", "2", "3", "4", "5", "6", "7"]);
  const feed = report.blocks[2];
  assert.equal(quarter.slice(feed.from, feed.to), "3,20000,0,FEDRAT,60.,PERMIN;");
  assert.deepEqual(feed.words.map((word) => word.address), ["", "", "", "FEDRAT", "", "PERMIN"]);
  assert.deepEqual(feed.words.map((word) => word.value), [3, 20000, 0, null, 60, null]);
  const [arc] = report.spans;
  assert.deepEqual([arc.kind, arc.blocks, arc.plane, arc.centre, arc.end], ["arc", [3, 4], "xy", [0, 0, 5], [0, 10, 5]]);
  // A quarter of a circle of radius 10 at 60 mm a minute, which is 1 mm a second.
  assert.ok(Math.abs(arc.length - 5 * Math.PI) < 1e-12 && Math.abs((arc.seconds ?? 0) - 5 * Math.PI) < 1e-12);
  assert.deepEqual([report.totals.rows, report.totals.tapeMillimetres, report.totals.rapid], [0, 0, 0]);
});

test("offsets are UTF-16 code units, and fixes mend", () => {
  const source = "1,20000,0,PPRINT,\u2019\u{1F600}A\u2019;\n2,5000,3,'',0,10,.,5.;\n3,14000;\n:";
  const report = nctape.checkCldata(source);
  const integer = report.diagnostics.find((found) => found.name === "integer-for-real");
  assert.ok(integer);
  assert.deepEqual([integer.line, integer.column, source.slice(integer.from, integer.to)], [2, 15, "10"]);
  assert.deepEqual(integer.clauses, ["ISO 3592 5.10.1"]);
  assert.deepEqual(integer.fixes?.[0].edits, [{ from: integer.to, to: integer.to, insert: "." }]);
});

test("columns and dialects", () => {
  const cards = `1,20000,0,PPRINT,'${"A".repeat(54)}JOB00135\nB';\n2,14000;\n:`;
  const [literal] = nctape.checkCldata(cards, { columns: 72 }).blocks[0].words.slice(-1);
  assert.equal(literal.value, null);
  assert.deepEqual(nctape.checkCldata(cards, { columns: 72 }).diagnostics, []);
  assert.equal(nctape.checkCldata(cards).diagnostics[0].name, "line-end-in-literal");
  const coded = "1,2000,17;\n2,14000;\n:";
  assert.equal(nctape.checkCldata(coded).diagnostics[0].name, "code-with-two-words");
  assert.deepEqual(nctape.checkCldata(coded, { dialect: "apt360" }).diagnostics, []);
});

test("a malformed option throws a TypeError with its field", () => {
  for (const [options, field] of [
    [7, "options"], [{ columns: 0 }, "columns"], [{ columns: "72" }, "columns"], [{ dialect: "basic" }, "dialect"],
    [{ limit: -1 }, "limit"],
  ]) {
    // @ts-expect-error what is passed is wrong on purpose
    assert.throws(() => nctape.checkCldata("", options), { name: "TypeError", field });
  }
  // @ts-expect-error what is passed is wrong on purpose
  assert.throws(() => nctape.checkCldata(12), { name: "TypeError", field: "source" });
  assert.deepEqual(nctape.checkCldata("\u0000{[\ud800;").spans, []);
});

test("the rules on CLDATA say their verdict", () => {
  const rule = nctape.rules().find((rule) => rule.rule === "CLD-12");
  assert.deepEqual(rule?.severity, { iso2539: null, iso1058: null, rs274: null, iso3592: "error" });
});

test("the CL text of a CAM system becomes CLDATA, and what is no statement is said", () => {
  const { text, faults, map } = nctape.clTextToCldata("PARTNO / \u00e9\nFEDRAT / 100, MMPM\nGOTO / 1, 2\nFROM / 0, 0, 0\nGOTO / 3, 4, 0\nFINI\n");
  assert.deepEqual(faults.map(({ from, to }) => [from, to]), [[30, 41]]);
  assert.match(faults[0].message, /^GOTO has 2 numbers/);
  const [, , records, end] = map[4];
  assert.equal(text.slice(records, end).split("\n")[1].replace(/^\d+,/, ""), "5000,5,'',0,3.,4.,.;");
  assert.equal(nctape.checkCldata(text).spans.length, 1);
});
