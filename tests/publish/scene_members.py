"""Members that a `foxglove.SceneUpdate` must have, after schemas/jsonschema/SceneUpdate.json of github.com/foxglove/foxglove-sdk."""
POSE = {"position": dict.fromkeys("xyz", float), "orientation": dict.fromkeys("xyzw", float)}
COLOUR = dict.fromkeys("rgba", float)
VECTOR = dict.fromkeys("xyz", float)
TIME = {"sec": int, "nsec": int}
SCENE = {
    "deletions": [{"timestamp": TIME, "type": int, "id": str}],
    "entities": [{
        "timestamp": TIME, "frame_id": str, "id": str, "lifetime": TIME, "frame_locked": bool,
        "metadata": [{"key": str, "value": str}],
        "arrows": [{"pose": POSE, "shaft_length": float, "shaft_diameter": float, "head_length": float,
                    "head_diameter": float, "color": COLOUR}],
        "cubes": [{"pose": POSE, "size": VECTOR, "color": COLOUR}],
        "spheres": [{"pose": POSE, "size": VECTOR, "color": COLOUR}],
        "cylinders": [{"pose": POSE, "size": VECTOR, "bottom_scale": float, "top_scale": float, "color": COLOUR}],
        "lines": [{"type": int, "pose": POSE, "thickness": float, "scale_invariant": bool, "points": [VECTOR],
                   "color": COLOUR, "colors": [COLOUR], "indices": [int]}],
        "triangles": [{"pose": POSE, "points": [VECTOR], "color": COLOUR, "colors": [COLOUR], "indices": [int]}],
        "texts": [{"pose": POSE, "billboard": bool, "font_size": float, "scale_invariant": bool, "color": COLOUR,
                   "text": str}],
        "models": [{"pose": POSE, "scale": VECTOR, "color": COLOUR, "override_color": bool, "url": str,
                    "media_type": str, "data": str}],
    }],
}


def problem_of(value, wanted, where):
    """Empty, or the first thing that is missing, too much or of another type."""
    if isinstance(wanted, list):
        if not isinstance(value, list):
            return f"{where} is not a list"
        problems = (problem_of(each, wanted[0], f"{where}[{i}]") for i, each in enumerate(value))
        return next(filter(None, problems), "")
    if isinstance(wanted, dict):
        if not isinstance(value, dict) or value.keys() != wanted.keys():
            return f"{where} has other members: {value}"
        problems = (problem_of(value[name], each, f"{where}.{name}") for name, each in wanted.items())
        return next(filter(None, problems), "")
    right = isinstance(value, (int, float) if wanted is float else wanted) and (wanted is bool or not isinstance(value, bool))
    return "" if right else f"{where} is {value!r}"


def problem_of_scene(scene):
    return problem_of(scene, SCENE, "scene")
