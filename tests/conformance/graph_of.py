"""A graph in our own form from what a recording says of its nodes."""
import re

TYPES = {"OOBJECT": "OObject"}


def graph_of(recording):
    content = recording.content
    nodes = recording.nodes
    objects = {}
    for name, node in nodes.items():
        if "/" in name:
            thing, part = name.split("/")
            objects.setdefault(thing, {})[part] = node
    states = content["nodes"]["env/supervisor_node"]["states"]
    lines = [f"name: {re.sub('[^a-z0-9_]', '_', recording.name)}", f"rate: {content['env_rate']}", f"engine: {{type: OracleEngine, rate: {content['engine']['rate']}}}", "objects:"]
    connections = []
    chained = {t for t, parts in objects.items() if "x" in parts}

    def processor(port):
        if not port["processor"]:
            return ""
        kind, config = port["processor"].split(":", 1)
        return f", processor: {{type: {kind}, config: {config}}}"

    def source(address):
        node, output = address.split("/outputs/")
        if node == "environment":
            return f"actions.{output}"
        return node.replace("/", ".") if "/" in node else f"{node}.{output}"

    def connect(port, target):
        connections.append(f"  - {{from: {source(port['source'])}, to: {target}, window: {port['window']}, delay: {port['delay']:.12g}, skip: {str(port['skip']).lower()}{processor(port)}}}")

    for thing, parts in objects.items():
        nid = min(n["nid"] - (10 if p[0] == "a" else 0) - (9 if p == "x" else int(p[1:])) for p, n in parts.items())
        lines.append(f"  {thing}:\n    type: {'OObjectChain' if thing in chained else 'OObject'}\n    config: {{nid: {nid}}}")
        lines.append("    sensors: {" + ", ".join(f"{p}: {{rate: {n['rate']}{processor(n['outputs'][0])}}}" for p, n in parts.items() if p[0] == "s") + "}")
        lines.append("    actuators: {" + ", ".join(f"{p}: {{rate: {n['rate']}}}" for p, n in parts.items() if p[0] == "a") + "}")
        chosen = [s.split("/")[1] for s in states if s.split("/")[0] == thing]
        lines.append("    states: {" + ", ".join(f"{s}: uniform" for s in chosen) + "}")
        for p, n in parts.items():
            for port in n["inputs"]:
                if p[0] == "a" and port["name"] != "tick":
                    connect(port, f"{thing}.{p}")
    lines.append("nodes:")
    for name, node in nodes.items():
        if "/" in name or name in ("engine", "environment"):
            continue
        config = {k: v for k, v in node.items() if k in ("nid", "n_reset", "delays")}
        chosen = [s.split("/")[1] for s in states if s.split("/")[0] == name]
        lines.append(f"  {name}: {{type: {node['type']}, rate: {node['rate']}, config: {{{', '.join(f'{k}: {v}' for k, v in config.items())}}}, "
                     f"inputs: [{', '.join(i['name'] for i in node['inputs'])}], outputs: {{{', '.join(o['name'] + ': {' + processor(o)[2:] + '}' for o in node['outputs'])}}}, "
                     f"states: {{{', '.join(f'{s}: uniform' for s in chosen)}}}}}")
        for port in node["inputs"]:
            connect(port, f"{name}.{port['name']}")
    lines.append("actions:")
    for port in nodes["environment"]["outputs"]:
        lines.append(f"  {port['name']}: {{space: {{dtype: int64, shape: [2], low: 0, high: 1000000000}}}}")
    lines.append(f"observations: [{', '.join(p['name'] for p in nodes['environment']['inputs'])}]")
    for port in nodes["environment"]["inputs"]:
        connect(port, f"observations.{port['name']}")
    return "\n".join(lines) + "\nconnections:\n" + "\n".join(connections) + "\n"
