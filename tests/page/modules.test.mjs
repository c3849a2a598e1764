// Requirements of generator/tools/page/modules.cpp on the modules that it joins into one script.
import assert from "node:assert/strict";
import {readdirSync, readFileSync} from "node:fs";
import test from "node:test";
import vm from "node:vm";

import {pageOf, root} from "./generator.mjs";

const folder = `${root}templates/page/`, names = readdirSync(folder).filter((name) => name.endsWith(".mjs"));
const texts = new Map(names.map((name) => [name, readFileSync(folder + name, "utf8")]));
const kImport = /^import (?:\{([^}]*)\} from )?"([^"]+)";$/gm;
const importsOf = (text) => [...text.matchAll(kImport)].map(
    ([, list, from]) =>
        ({from: from.replace("./", ""), names: (list ?? "").split(",").map((name) => name.trim()).filter(Boolean)}));

test("imports have one form, rename nothing, and are used", () => {
  for (const [name, text] of texts) {
    const lines = text.split("\n").filter((line) => /^(import|export)\b/.test(line));
    const exported = lines.filter((line) => line.startsWith("export"));
    assert.ok(exported.every((line) => /^export (function|const|let|class|async function) /.test(line)), name);
    const imports = importsOf(text), rest = text.replace(kImport, "");
    assert.equal(lines.length - exported.length, imports.length, `${name}: an import in another form`);
    for (const word of imports.flatMap((one) => one.names)) {
      assert.ok(/^\w+$/.test(word), `${name} renames: ${word}`);
      assert.ok(new RegExp(`\\b${word}\\b`).test(rest), `${name} does not use ${word}`);
    }
  }
});

test("no module imports itself in a circle", () => {
  const done = new Set();
  const follow = (name, way) => {
    assert.ok(!way.includes(name), [...way, name].join(" → "));
    if (done.has(name) || !texts.has(name)) return;
    for (const {from} of importsOf(texts.get(name))) follow(from, [...way, name]);
    done.add(name);
  };
  for (const name of names) follow(name, []);
});

test("no two modules declare the same name", () => {
  const home = new Map();
  const declare = (word, name) => {
    assert.ok(!home.has(word), `${word} is in ${home.get(word)} and ${name}`);
    home.set(word, name);
  };
  for (const [name, text] of texts)
    for (const [, word] of text.matchAll(/^(?:export )?(?:async )?(?:function|class|const|let) (\w+)/gm))
      declare(word, name);
  assert.ok(home.size > 200);
});

test("a page has each module that it needs once, after those that it imports", () => {
  const {script} = pageOf("examples/pendulum_swing_up/graph.yaml");
  assert.ok(script.startsWith("\"use strict\";\n") && !/^(import|export) /m.test(script));
  new vm.Script(script);  // two constants of one name would be a mistake here
  const beginning = (name) => /^(?:export )(?:function|const|let|class) \w+.*$/m.exec(texts.get(name))?.[0].slice(7);
  const places = names.map((name) => [name, beginning(name)])
                     .filter(([, line]) => line)
                     .map(([name, line]) => [name, script.split(line).length - 1, script.indexOf(line)]);
  const ofSomePages = new Set([
    "simulation_view.mjs", "simulation_controls.mjs", "simulation_keys.mjs", "growing_plots.mjs", "history.mjs",
    "stream.mjs", "stream_shown.mjs", "stream_view.mjs", "charts.mjs", "training_view.mjs", "loop_view.mjs"
  ]);
  const isOfSome = (name) => ofSomePages.has(name) || name.startsWith("edit_");
  for (const [name, times] of places) assert.equal(times, isOfSome(name) ? 0 : 1, name);
  const placeOf = new Map(places.map(([name, , place]) => [name, place]));
  for (const [name, text] of texts)
    for (const {from} of importsOf(text))
      if (placeOf.get(name) >= 0 && placeOf.has(from))
        assert.ok(placeOf.get(from) < placeOf.get(name), `${name} comes before ${from}`);
});
