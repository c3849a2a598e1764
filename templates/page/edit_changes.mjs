// Which lines of a text the last change made or changed.

/** The length of the longest common subsequence of every beginning of `a` and `b`. */
function commonLengths(a, b) {
  const lengths = Array.from({length: a.length + 1}, () => new Uint16Array(b.length + 1));
  for (let i = a.length - 1; i >= 0; --i)
    for (let j = b.length - 1; j >= 0; --j)
      lengths[i][j] = a[i] === b[j] ? lengths[i + 1][j + 1] + 1 : Math.max(lengths[i + 1][j], lengths[i][j + 1]);
  return lengths;
}

const kMostLines = 1000;  // of a change, for which the least difference is looked for

/** {changed: numbers of lines of `after` (from 0) that are new, removed: lines before which some are gone}. */
export function changedLines(before, after) {
  const [a, b] = [before.split(/\r?\n/), after.split(/\r?\n/)];
  let start = 0, end = 0;
  while (start < a.length && start < b.length && a[start] === b[start]) ++start;
  while (end < Math.min(a.length, b.length) - start && a.at(-1 - end) === b.at(-1 - end)) ++end;
  const [old, now] = [a.slice(start, a.length - end), b.slice(start, b.length - end)];
  const changed = new Set(), removed = new Set();
  if (old.length > kMostLines || now.length > kMostLines) {
    now.forEach((_, j) => changed.add(start + j));
    return {changed, removed};
  }
  const lengths = commonLengths(old, now);
  let i = 0, j = 0;
  while (i < old.length || j < now.length) {
    if (i < old.length && j < now.length && old[i] === now[j]) {
      ++i;
      ++j;
    } else if (j < now.length && (i === old.length || lengths[i][j + 1] >= lengths[i + 1][j]))
      changed.add(start + j++);
    else {
      removed.add(start + j);
      ++i;
    }
  }
  // What became of a line that was changed is to be seen already.
  for (const line of removed)
    if (changed.has(line) || changed.has(line - 1)) removed.delete(line);
  return {changed, removed};
}
