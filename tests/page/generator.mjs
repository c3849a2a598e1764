// Pages that the generator of BUILD (the environment variable EAGERX_BUILD) makes.
import {spawnSync} from "node:child_process";
import {mkdtempSync, readFileSync, rmSync} from "node:fs";
import {tmpdir} from "node:os";
import {join} from "node:path";

export const root = new URL("../../", import.meta.url).pathname;

/** {data, script} of the page of a graph below the root. */
export function pageOf(graph, ...options) {
  const folder = mkdtempSync(join(tmpdir(), "eagerx-page-"));
  try {
    const output = join(folder, "page.html");
    const done = spawnSync(
        join(process.env.EAGERX_BUILD, "eagerx-gen"), ["report", join(root, graph), "-o", output, ...options],
        {env: {...process.env, EAGERX_HOME: root}, encoding: "utf8"});
    if (done.status !== 0) throw new Error(`${graph}: ${done.stderr}`);
    const text = readFileSync(output, "utf8");
    const [, data] = /<script type="application\/json" id="data">(.*?)<\/script>/s.exec(text);
    const [, script] = /<script>(.*?)<\/script>/s.exec(text);
    return {data: JSON.parse(data), script};
  } finally {
    rmSync(folder, {recursive: true});
  }
}
