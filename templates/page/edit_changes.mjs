// Lines of a text that the last change added or modified.

/** Length of the longest common subsequence of each pair of suffixes of `a` and `b`. */
function commonLengths(a, b) {
  const lengths = Array.from({length: a.length + 1}, () => new Uint16Array(b.length + 1));
  for (let i = a.length - 1; i >= 0; --i)
    for (let j = b.length - 1; j >= 0; --j)
      lengths[i][j] = a[i] === b[j] ? lengths[i + 1][j + 1] + 1 : Math.max(lengths[i + 1][j], lengths[i][j + 1]);
  return lengths;
}

const kMostLines = 1000;  // length of a change up to which the minimal difference is computed

/** {changed: indices of new lines in `after`, removed: indices of lines in `after` before which lines were removed}. */
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
  // A modified line is already highlighted, so a removal next to it needs no mark.
  for (const line of removed)
    if (changed.has(line) || changed.has(line - 1)) removed.delete(line);
  return {changed, removed};
}
