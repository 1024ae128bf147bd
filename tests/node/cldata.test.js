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

/** The format of annex E of ISO 2539. */
const format = nctape.presets()[0].format;

test("CLDATA is edited, and asked for what is visible", () => {
  const cldata = new nctape.Cldata(quarter, format);
  const fresh = cldata.summary();
  assert.deepEqual([fresh.edit, fresh.blocks, fresh.spans, fresh.unit, fresh.errors], [0, 7, 1, "mm", 0]);
  assert.deepEqual(fresh.bounds, { min: [0, 0, 5], max: [10, 10, 5] });

  // From the offset of an element to its record and its span, and back.
  const end = quarter.indexOf(".,10.,5.;\n6");
  assert.deepEqual([cldata.recordAt(end), cldata.spanAt(end), cldata.endOfSpan(0)?.from], [4, 0, end]);
  assert.deepEqual([cldata.recordAt(quarter.length - 1), cldata.spanAt(0), cldata.endOfSpan(1)], [-1, -1, null]);
  const [circle, motion] = cldata.records(3, 2);
  assert.deepEqual([circle.called, circle.type, circle.span, circle.kept], ["record 4", 3000, 0, false]);
  assert.match(circle.says, /circle C1, centre X 0 Y 0 Z 5, radius 10/);
  assert.equal(motion.says, "The tool goes to X 0 Y 10 Z 5.");
  assert.equal(quarter.slice(motion.from, motion.to), "5,5000,5,'',0,.,10.,5.;");
  const state = cldata.state(4);
  assert.deepEqual(state?.position, [0, 10, 5]);
  assert.deepEqual(state?.registers.find(({ name }) => name === "Feed"), { name: "Feed", says: "60 mm/min", stated: true });
  assert.equal(cldata.state(7), null);

  // The path has the same form as a tape's.
  const path = cldata.pathChange(0.01);
  assert.deepEqual([path.number, path.first, path.last, path.kinds.length, [...path.blocks]], [1, 0, 0, 1, [3, 4]]);
  assert.equal(nctape.spanKinds()[path.kinds[0] - 1], "arc");
  assert.deepEqual([...path.xyz.slice(0, 3), ...path.xyz.slice(-3)], [10, 0, 5, 0, 10, 5]);

  // An edit: the literal of the circle grows by a surrogate pair, and its radius is spoilt.
  const at = quarter.indexOf("C1");
  assert.equal(cldata.edit(at, at + 2, "\u{1F600}"), 1);
  const radius = quarter.indexOf("10.;\n5");
  cldata.edit(radius, radius + 3, "99.");
  const after = cldata.summary();
  assert.deepEqual([after.edit, after.spans], [2, 1]);
  const found = cldata.diagnostics(0, 1000, 10);
  assert.ok(found.some(({ rule }) => rule === "CLD-34"), JSON.stringify(found));
  assert.deepEqual(cldata.diagnostics(0, 5, 10), [], "only what touches the stretch");
  cldata.free();
});

test("what is kept is marked, and a record leads to its statement", () => {
  const source = "1,1000,12,'70','THREAD/TURN';\n2,15000,1,2.;\n3,14000;\n:";
  const cldata = new nctape.Cldata(source, format);
  const [, kept] = cldata.records(0, 10);
  assert.deepEqual([kept.kept, kept.statement], [true, { record: 0, number: 12, identification: "70", text: "THREAD/TURN" }]);
  const { starts, kinds, ranges, roles } = cldata.syntax(0, source.length, 10);
  assert.deepEqual([[...starts], [...kinds]], [[0, 30, 44], [0, 0, 0]]);
  const marked = [...roles].map((role, i) => [role, source.slice(ranges[2 * i], ranges[2 * i + 1])]);
  assert.deepEqual(marked.slice(0, 4), [[1, "1"], [2, "1000"], [3, "'70'"], [3, "'THREAD/TURN'"]]);
  assert.deepEqual(marked.slice(4, 6), [[4, "2,15000,1,2.;"], [1, "2"]]);
  cldata.free();
});

test("CLDATA is posted, and each record leads to what it became", () => {
  const cldata = new nctape.Cldata(quarter, format);
  const { text, map } = cldata.posted();
  const tape = cldata.postedTape();
  assert.equal(tape.summary().errors, 0);
  assert.equal(tape.summary().totals.rows, nctape.encode(text, format).length);
  const became = (/** @type {number} */ record) => {
    const { from, to } = cldata.records(record, 1)[0];
    for (let i = 0; i < map.length; i += 4) if (map[i] < to && map[i + 1] > from && map[i + 3] > map[i + 2]) return text.slice(map[i + 2], map[i + 3]);
    return null;
  };
  assert.match(became(4) ?? "", /G0?3/);
  assert.equal(tape.block(tape.blockAt(text.indexOf("G03")))?.span, tape.summary().spans - 1);

  // Another format, another tape.
  const other = nctape.presets().find(({ id }) => id === "iso-1058-boring")?.format ?? format;
  cldata.setFormat(other);
  assert.notEqual(cldata.posted().text, text);
  tape.free();
  cldata.free();
});

test("a listing of CLDATA is told from a tape, and the fix opens it", () => {
  const bytes = new TextEncoder().encode(quarter);
  assert.equal(nctape.openFile(bytes, format).language, "cldata");
  assert.equal(nctape.openFile(new TextEncoder().encode("%\nN001 G01 X+001000\n"), format).language, "tape");
  const [found] = nctape.check(quarter, format).diagnostics;
  assert.deepEqual([found.rule, found.fixes?.[0].kind, found.fixes?.[0].edits], ["TAPE-08", "cldata", undefined]);
});
