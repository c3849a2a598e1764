"""Runs a program, and reads the trace of a run."""
import subprocess


class Trace:
    """`rows`: (episode, channel, seq, values), in order."""

    def __init__(self, path):
        lines = path.read_text().splitlines()
        rates = [line.split()[2:] for line in lines if line.startswith("# channel ")]
        self.period = {name: int(rate.split("/")[1]) / int(rate.split("/")[0]) for name, _, _, rate in rates}
        self.bools = {name for name, dtype, _, _ in rates if dtype == "bool"}
        self.rows = []
        for line in lines:
            if line[:1].isdigit():
                episode, channel, seq, *values = line.split(",")
                self.rows.append((int(episode), channel, int(seq), [float(v) for v in values]))

    def times(self):
        """Of each row, seconds since the run began: an episode begins a slowest period after the one before."""
        gap, begin, last, before, times = max(self.period.values()), 0.0, 0.0, 0, []
        for episode, channel, seq, _ in self.rows:
            if episode != before:
                begin, before = last + gap, episode
            times.append(begin + seq * self.period[channel])
            last = max(last, times[-1])
        return times

    def steps(self):
        """{(episode, step): {channel: (time, values)}}: the last message of each channel in a step."""
        steps, key = {}, (0, 0)
        for (episode, channel, seq, values), when in zip(self.rows, self.times()):
            if episode != key[0]:
                key = (episode, 0)
            elif channel == "environment/voltage":
                key = (episode, seq + 1)
            steps.setdefault(key, {})[channel] = (when, values)
        return steps


def run(program, *options, code=0):
    done = subprocess.run([program, *map(str, options)], capture_output=True, text=True)
    assert done.returncode == code, f"{options}: {done.returncode}\n{done.stdout}{done.stderr}"
    return done.stdout + done.stderr
