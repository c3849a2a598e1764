"""Places for a layered drawing: every box in a row below all that it links, few crossings, short ways.

Follows Sugiyama, Tagawa, Toda, "Methods for visual understanding of hierarchical system structures" (1981). An edge
over several rows has a bend in each of them; edges to the same box share theirs. All choices are by name where two are
equally good, so that the drawing is the same everywhere.
"""
import bisect
import collections
import hashlib

COLUMNS = range(-11, 12)
STARTS = 2  # orders to begin with; the best result counts
CROSSING, BESIDE = 6.0, 0.05  # costs, of a crossing, and of a column away from the middle; one column sideways costs 1


def rows_of(links, users, spine):
    """Rows from the longest chains; a box with room to move goes where its edges are shorter, else to emptier rows."""
    row = {}

    def lowest(name):
        if name not in row:
            row[name] = max((lowest(library) + 1 for library in links[name]), default=0)
        return row[name]

    for name in sorted(links):
        lowest(name)
    fixed = set(spine)
    for name in sorted(links, key=lambda n: (-row[n], n)):
        last = min((row[user] for user in users[name]), default=row[name] + 1) - 1
        if name in fixed or last == row[name]:
            continue
        counts = collections.Counter(r for n, r in row.items() if n != name)
        pull = len(links[name]) - len(users[name])  # positive: towards what it links
        row[name] = min(range(row[name], last + 1), key=lambda r: (pull * r, counts[r], r))
    return row


def ways_of(links, row):
    """{(source, target): [source, bends…, target]}; bends are (target, row) and shared."""
    row = dict(row)
    ways = {}
    for target in sorted(links):
        for source in sorted(links[target]):
            bends = [(target, r) for r in range(row[source] + 1, row[target])]
            ways[source, target] = [source, *bends, target]
    return ways


def shuffled(start, item):
    """A sort key: another order for every start, the same one on every machine."""
    return hashlib.sha256(f"{start} {item}".encode()).digest()


def cost_of_gap(lines):
    """Of lines from a column to one in the row below."""
    total, crossings = 0.0, 0
    before = []  # where the lines end that begin further left, in order
    beginning = []  # and those that begin in this column, which cross none of each other
    column = None
    for a, b in sorted(lines):
        if a != column:
            for end in beginning:
                bisect.insort(before, end)
            beginning.clear()
            column = a
        beginning.append(b)
        crossings += len(before) - bisect.bisect_right(before, b)
        distance = abs(a - b)
        total += distance + 0.3 * distance * distance
    return total + CROSSING * crossings


class Search:
    """Moves boxes and bends between columns as long as that helps."""

    def __init__(self, row, ways, spine, start):
        self.row = dict(row)
        for path in ways.values():
            self.row.update({item: item[1] for item in path[1:-1]})
        self.gaps = collections.defaultdict(list)  # below each row: ends of the segments there
        for a, b in sorted({(a, b) for path in ways.values() for a, b in zip(path, path[1:])}, key=str):
            self.gaps[self.row[a]].append((a, b))
        self.by_row = collections.defaultdict(list)
        for item in sorted(self.row, key=str):
            self.by_row[self.row[item]].append(item)
        self.fixed = {item: 0 for item in spine}
        self.known = {}  # costs of gaps, by row and columns: most moves leave most gaps as another move had them
        self.column = {}
        for items in self.by_row.values():
            free = sorted(COLUMNS, key=lambda c: (abs(c), c))
            for item in sorted(items, key=lambda i: (i not in self.fixed, shuffled(start, i))):
                self.column[item] = free.pop(0)

    def cost(self, rows):
        """Of these rows and the gaps beside them."""
        at, total = self.column, 0.0
        for row in sorted(rows | {row - 1 for row in rows}):
            lines = tuple([(at[a], at[b]) for a, b in self.gaps[row]])
            if (row, lines) not in self.known:
                self.known[row, lines] = cost_of_gap(lines)
            total += self.known[row, lines]
        return total + BESIDE * sum(abs(at[item]) for row in rows for item in self.by_row[row])

    def moves(self):
        """Each: {item: column}. One item, one with its neighbour's place, or all bends of a target."""
        for items in self.by_row.values():
            taken = {self.column[item]: item for item in items}
            for item in items:
                for column in COLUMNS:
                    other = taken.get(column)
                    if item in self.fixed or other == item or other in self.fixed:
                        continue
                    yield {item: column} if other is None else {item: column, other: self.column[item]}
        bends = collections.defaultdict(list)
        for item in sorted(self.row, key=str):
            if isinstance(item, tuple):
                bends[item[0]].append(item)
        for items in bends.values():
            for column in COLUMNS:
                move, free = {}, True
                for item in items:
                    other = next((o for o in self.by_row[self.row[item]] if self.column[o] == column), item)
                    free = free and other not in self.fixed
                    move.update({item: column} if other == item else {item: column, other: self.column[item]})
                if free:
                    yield move

    def run(self):
        """Makes the best move until none helps; the cost that is left."""
        changes = collections.Counter()  # of each row
        gains = {}  # of a move, with how often its rows and those beside them had changed
        while True:
            best, best_move, costs, states = 0.0, None, {}, {}
            for move in self.moves():
                rows = frozenset(self.row[item] for item in move)
                if rows not in costs:
                    costs[rows] = self.cost(rows)
                    states[rows] = tuple(changes[r] for r in range(min(rows) - 1, max(rows) + 2))
                key = frozenset(move.items())
                state, gain = gains.get(key, (None, 0.0))
                if state != states[rows]:
                    gain = self.gain(move, rows, costs[rows])
                    gains[key] = states[rows], gain
                if gain > best + 1e-9:
                    best, best_move = gain, move
            if best_move is None:
                return self.cost(set(self.by_row))
            self.column.update(best_move)
            changes.update({self.row[item] for item in best_move})

    def gain(self, move, rows, cost):
        before = {item: self.column[item] for item in move}
        self.column.update(move)
        gain = cost - self.cost(rows)
        self.column.update(before)
        return gain


def place(links, spine):
    """Rows from the top, columns, and the ways of the edges. `links`: {name: names}; `spine` stays in the middle."""
    users = {name: {user for user in links if name in links[user]} for name in links}
    row = rows_of(links, users, spine)
    ways = ways_of(links, row)
    searches = [Search(row, ways, spine, start) for start in range(STARTS)]
    best = min(searches, key=Search.run)  # the first one of equally good ones
    return best.row, best.column, ways
